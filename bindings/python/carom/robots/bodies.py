"""Bodies and joints of a world from the links of a model."""
from __future__ import annotations

import ctypes
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import raw
from .._values import describe
from . import turns
from .links import Link, Links, Move, name_of, node_masses
from .problems import Problems

if TYPE_CHECKING:
    from ..body import Body
    from ..joint import Joint
    from ..world import World
    from .tendons import Tendons

AXIS = {"hinge": raw.CAROM_AXIS_TURN_X, "slide": raw.CAROM_AXIS_X}
FARTHEST = {"hinge": 1e3, "slide": 1e9}  # rad, m: bounds of the library's limits
OF_CAP = 0.5  # a spring as stiff as this share of what a substep carries is left to the host: what a joint weighs changes as it turns


class Disabled:
    """What a model's options switch off."""

    def __init__(self, model: Any) -> None:
        from .read import need_mujoco
        bits = need_mujoco().mjtDisableBit
        flags = int(model.opt.disableflags)

        def off(name: str) -> bool:
            return bool(flags & int(getattr(bits, name)))

        all_constraints = off("mjDSBL_CONSTRAINT")
        self.contact = off("mjDSBL_CONTACT") or all_constraints
        self.limit = off("mjDSBL_LIMIT") or all_constraints
        self.friction = off("mjDSBL_FRICTIONLOSS") or all_constraints
        self.equality = off("mjDSBL_EQUALITY") or all_constraints
        self.spring = off("mjDSBL_SPRING")
        self.damper = off("mjDSBL_DAMPER")
        self.gravity = off("mjDSBL_GRAVITY")
        self.actuation = off("mjDSBL_ACTUATION")
        self.clamp = off("mjDSBL_CLAMPCTRL")
        self.parents_touch = off("mjDSBL_FILTERPARENT")


class Bodies:
    """Of a world. nodes: its bodies in the order of Links.nodes; joints: by MuJoCo's number, of hinges, slides and balls."""

    def __init__(self, world: World, model: Any, links: Links, disabled: Disabled, substep: float, problems: Problems) -> None:
        self.world, self.model, self.links, self.disabled, self.problems = world, model, links, disabled, problems
        self.nodes: list[Body] = []
        self.joints: dict[int, Joint] = {}
        self.axes: dict[int, Any] = {}           # carom_joint_axis of hinges and slides, as set
        self.by_host: dict[int, float] = {}      # N/m or N m/rad: of springs that a substep can't carry
        self.stiffest: dict[int, float] = {}     # likewise: the stiffest that one carries
        self.turning: dict[int, float] = {}      # N m, by free joint: friction about each axis of the body, which is the host's
        self.fastest = math.pi / (2 * substep)   # rad/s
        of_links, of_nodes = links.poses(model.qpos0)
        for link in links.moving:
            self._bodies(link, of_nodes)
        for link in links.moving:
            for k, move in enumerate(link.moves):
                if move.kind == "free":
                    self._free(link, move)
                else:
                    self._joint(link, k, move)
        self.by_handle = {body.handle: body for body in self.nodes if body.type == "dynamic"}
        if not disabled.parents_touch:
            self._apart()

    def _apart(self) -> None:
        """What a joint holds does not touch, nor do those that are one with either of the two. Joints see to their own two bodies."""
        links = self.links.links
        groups: dict[int, list[int]] = {}
        for k, link in enumerate(links):
            if not link.is_static:
                groups.setdefault(link.group, []).append(k)
        for group, among in groups.items():
            parent = links[group].parent
            others = among if links[parent].is_static else among + groups[links[parent].group]
            for a in among:
                for b in others:
                    joined = links[a].parent == b and len(links[a].moves) == 1 or links[b].parent == a and len(links[b].moves) == 1
                    if a != b and not joined and (b not in among or a < b):
                        self.last(links[a]).ignore_collision(self.last(links[b]))

    def last(self, link: Link) -> Body:
        return self.nodes[link.first_node + link.nodes - 1]

    def of_link(self, index: int) -> Body | None:
        """None: it is part of the world."""
        link = self.links.links[index]
        return None if link.is_static else self.last(link)

    def _bodies(self, link: Link, of_nodes: list[turns.Pose]) -> None:
        factor = 1 - link.lift / link.mass if link.mass else 1.0
        rotor = float(self.model.dof_armature[link.moves[0].v]) if link.moves and link.moves[0].kind == "free" else 0.0
        for k, (mass, center, inertia) in enumerate(node_masses(link)):
            inertia = inertia + rotor * np.eye(3)
            position, turn = of_nodes[link.first_node + k]
            if link.mocap >= 0:
                self.nodes.append(self.world.body(type="kinematic", position=position, orientation=turn))
                continue
            body = self.world.body(position=position, orientation=turn, mass=mass, center=center, inertia=inertia.ravel())
            if factor != 1:
                body.gravity_factor = factor
            self.nodes.append(body)
        m = self.model
        group = [body for body in range(m.nbody) if self.links.of_body[body] == self.links.of_body[link.body] and m.body_mass[body]]
        if len({float(m.body_gravcomp[body]) for body in group}) > 1:
            self.problems.add("body", name_of(m, "body", link.body),
                              "bodies that make up one have unlike gravcomp: its mean acts at their common centre of mass")

    def _free(self, link: Link, move: Move) -> None:
        """What resists a free joint holds its body to the world, at the body's origin, by a joint that leaves all six ways free. What a
        rotor about all axes weighs is the body's: it turns like it, and has no weight."""
        m, off, v = self.model, self.disabled, move.v
        armature = float(m.dof_armature[v])
        damping, friction = 0.0 if off.damper else float(m.dof_damping[v]), 0.0 if off.friction else float(m.dof_frictionloss[v])
        if not (armature or damping or friction):
            return
        joint = self.world.joint("six_axis", None, self.last(link), position_a=(0, 0, 0), position_b=(0, 0, 0), collide=True)
        for axis in ("x", "y", "z"):
            joint.axis(axis, armature=armature, friction=friction, spring_damping=damping, spring_gains="force")
        if damping:
            joint.orientation_drive(drive="position", gains="force", stiffness=0, damping=damping, target=(0, 0, 0, 1))
        if friction:
            self.turning[move.index] = friction
        self.joints[move.index] = joint

    def rub(self, dt: float) -> None:
        """Friction of free joints that turn, for the next step: as much as stops the turn, and no more than there is."""
        for link in self.links.moving:
            for move in link.moves:
                if move.index in self.turning:
                    body, most = self.last(link), self.turning[move.index]
                    turn = np.array(body.orientation)
                    spin = turns.rotate(turns.inverse(turn), np.array(body.angular_velocity))
                    body.add_force((0, 0, 0), turns.rotate(turn, np.clip(-np.diag(link.inertia) * spin / dt, -most, most)))

    def _joint(self, link: Link, k: int, move: Move) -> None:
        m, off = self.model, self.disabled
        parent = self.links.links[link.parent]
        a, base = self.of_link(link.parent), link.rest
        if k:
            a, base = self.nodes[link.first_node + k - 1], (np.zeros(3), turns.NONE)
        frame = turns.NONE if move.kind in ("ball", "weld") else turns.x_to(move.axis)
        ball = move.kind == "ball"
        armature = 0.0 if move.kind == "weld" else float(m.dof_armature[move.v])
        kind = "six_axis" if ball and armature else {"hinge": "hinge", "slide": "slider", "ball": "ball", "weld": "weld"}[move.kind]
        on_a = turns.on(base, (move.anchor, frame))
        joint = self.world.joint(kind, a, self.nodes[link.first_node + k], position_a=on_a[0], orientation_a=on_a[1],  # type: ignore[arg-type]
                                 position_b=move.anchor, orientation_b=frame, collide=off.parents_touch and not parent.is_static and move.kind != "weld")
        self.joints[move.index] = joint
        if ball:
            self._ball(joint, move, armature)
        elif move.kind != "weld":
            self._axis(joint, move, armature)

    def _axis(self, joint: Joint, move: Move, armature: float) -> None:
        m, off, j, v = self.model, self.disabled, move.index, move.v
        axis = describe(raw.carom_joint_axis, {"armature": armature, "spring_gains": raw.CAROM_GAINS_FORCE, "drive_gains": raw.CAROM_GAINS_FORCE})
        if m.jnt_limited[j] and not off.limit:
            lower, upper = (x - move.zero for x in within(m.jnt_range[j], m.jnt_margin[j]))
            if -FARTHEST[move.kind] <= lower and upper <= FARTHEST[move.kind]:
                axis.mode, axis.lower, axis.upper = raw.CAROM_AXIS_MODE_LIMITED, lower, upper
            elif lower > -FARTHEST[move.kind] or upper < FARTHEST[move.kind]:
                self.problems.add("joint", move.name, f"a limit beyond {FARTHEST[move.kind]:g} on one side: it has none on either")
        if not off.friction:
            axis.friction = float(m.dof_frictionloss[v])
        if not off.damper:
            axis.spring_damping = float(m.dof_damping[v])
        if m.jnt_actfrclimited[j]:
            axis.effort_limit = max(abs(float(x)) for x in m.jnt_actfrcrange[j])
        self.stiffest[j] = self.fastest ** 2 * alone(joint, AXIS[move.kind])
        stiffness = 0.0 if off.spring else float(m.jnt_stiffness[j])
        if stiffness > OF_CAP * self.stiffest[j]:
            self.by_host[j] = stiffness
        elif stiffness:
            axis.spring_stiffness, axis.rest = stiffness, float(m.qpos_spring[move.q]) - move.zero
        self.axes[j] = axis
        self.set_axis(move)

    def set_axis(self, move: Move) -> None:
        """Give the world what `axes` has."""
        self.world._call(raw.carom_joint_set_axis, self.joints[move.index].handle, AXIS[move.kind], ctypes.byref(self.axes[move.index]))

    def lock(self, joint: int, at: float) -> None:
        """@param at  m or rad, of a hinge or slide of MuJoCo's, from where the model was written"""
        axis = self.axes[joint]
        axis.mode, axis.lower, axis.upper = raw.CAROM_AXIS_MODE_LIMITED, at, at
        self.set_axis(next(move for move in self.links.moves if move.index == joint))

    def _ball(self, joint: Joint, move: Move, armature: float) -> None:
        m, off, j, v = self.model, self.disabled, move.index, move.v
        if armature:
            for axis in ("x", "y", "z"):
                joint.axis(axis, mode="locked", lower=0, upper=0)
            for axis in ("turn_x", "turn_y", "turn_z"):
                joint.axis(axis, armature=armature)  # type: ignore[arg-type]
        if m.jnt_limited[j] and not off.limit:
            self.problems.add("joint", move.name, "the limit of a ball joint: MuJoCo's is of the whole angle, the library's of swing and twist")
        if m.dof_frictionloss[v] and not off.friction:
            self.problems.add("joint", move.name, "frictionloss of a ball joint")
        damping, stiffness = 0.0 if off.damper else float(m.dof_damping[v]), 0.0 if off.spring else float(m.jnt_stiffness[j])
        if damping or stiffness:
            x, y, z, w = turns.from_mujoco(m.qpos_spring[move.q:move.q + 4])
            joint.orientation_drive(drive="position", gains="force", stiffness=stiffness, damping=damping, target=(x, y, z, w))


def within(ends: Any, margin: Any) -> tuple[float, float]:
    """Ends of a limit: its margin is kept off both, as MuJoCo does."""
    low, high, off = float(ends[0]), float(ends[1]), float(margin)
    return (low + off, high - off) if low + off <= high - off else ((low + high) / 2,) * 2


def alone(joint: Joint, axis: int) -> float:
    """kg or kg m^2: what the joint's two bodies weigh along an axis of its frame, were they alone, the other five held."""
    desc = joint.desc
    inverse = np.zeros((6, 6))
    axes = None
    for body, position, turn in ((desc.body_a, desc.position_a, desc.orientation_a), (desc.body_b, desc.position_b, desc.orientation_b)):
        if body is None or body.type != "dynamic":
            continue
        mass, center, inertia = body._masses()
        axes = turns.matrix(turn)
        arm = axes.T @ (np.array(center) - position)  # in the joint's frame
        turned = axes.T @ np.reshape(inertia, (3, 3)) @ axes
        hat = np.array([[0, -arm[2], arm[1]], [arm[2], 0, -arm[0]], [-arm[1], arm[0], 0]])
        spatial = np.block([[mass * np.eye(3), -mass * hat], [mass * hat, turned - mass * hat @ hat]])
        inverse += np.linalg.inv(spatial)
    return float(np.linalg.inv(inverse)[axis, axis])


def close_loops(world: World, bodies: Bodies, tendons: Tendons, problems: Problems) -> dict[str, Joint]:
    """Equalities: what holds two bodies together, or coordinates."""
    m, links = bodies.model, bodies.links
    from .read import need_mujoco
    mujoco = need_mujoco()
    kinds, sites = mujoco.mjtEq, int(mujoco.mjtObj.mjOBJ_SITE)
    made: dict[str, Joint] = {}

    def site(index: int) -> tuple[int, turns.Pose]:
        return int(m.site_bodyid[index]), (np.array(m.site_pos[index]), turns.from_mujoco(m.site_quat[index]))

    for k in range(m.neq):
        name, kind, data = name_of(m, "eq", k), int(m.eq_type[k]), [float(x) for x in m.eq_data[k]]
        one, other = int(m.eq_obj1id[k]), int(m.eq_obj2id[k])
        if bodies.disabled.equality:
            continue
        if not m.eq_active0[k]:
            problems.add("equality", name, "it begins inactive")
        elif kind in (int(kinds.mjEQ_CONNECT), int(kinds.mjEQ_WELD)):
            weld = kind == int(kinds.mjEQ_WELD)
            at_a: turns.Pose
            at_b: turns.Pose
            if int(m.eq_objtype[k]) == sites:
                (one, at_a), (other, at_b) = site(one), site(other)
            elif weld:
                at_a, at_b = (np.array(data[3:6]), turns.from_mujoco(data[6:10])), (np.zeros(3), turns.NONE)
            else:
                at_a, at_b = (np.array(data[0:3]), turns.NONE), (np.array(data[3:6]), turns.NONE)
            a, b = links.of_body[one], links.of_body[other]
            if a == b:
                continue  # one link already
            on_a, on_b = turns.on(links.within[one], at_a), turns.on(links.within[other], at_b)
            made[name] = world.joint("weld" if weld else "ball", bodies.of_link(a), bodies.of_link(b), position_a=on_a[0], orientation_a=on_a[1],
                                     position_b=on_b[0], orientation_b=on_b[1], collide=True)
        elif kind == int(kinds.mjEQ_JOINT) and other < 0 and one in bodies.axes:
            bodies.lock(one, data[0])
        elif kind == int(kinds.mjEQ_JOINT):
            if one not in bodies.axes or other not in bodies.axes:
                problems.add("equality", name, "a joint that follows another, of which one is neither hinge nor slide")
                continue
            made[name] = world.couple(bodies.joints[one], bodies.joints[other], data[:5])  # both tell where they are from where the model was written
        elif kind == int(kinds.mjEQ_TENDON):
            held = _hold_tendon(tendons, name, one, other, data)
            if isinstance(held, str):
                problems.add("equality", name, held)
            elif held is not None:
                made[name] = held
        else:
            word = next((w[len("mjEQ_"):].lower() for w, value in kinds.__members__.items() if int(value) == kind), str(kind))
            problems.add("equality", name, f"of kind {word}: the library has no such constraint")
    return made


def _hold_tendon(tendons: Tendons, name: str, one: int, other: int, data: list[float]) -> Joint | str | None:
    """A tendon whose length stays, or follows another's.   @return what holds it; None: nothing has to; or why it is left out"""
    bodies = tendons.bodies
    if one in tendons.paths and other < 0:
        path = tendons.paths[one]
        if len(path.pieces) != 1:
            return "of a tendon that bends at a site that moves: a distance joint is straight"
        length = float(bodies.model.tendon_length0[one]) + data[0]
        return tendons.rope(name, path, length) if length >= path.fixed else "of a tendon that would be shorter than nothing"
    if one not in tendons.shares or other >= 0 and other not in tendons.shares:
        return "its tendon winds about a geom" if other < 0 else "a tendon that follows another, of which one is spatial"
    shares = dict(tendons.shares[one])
    if other >= 0:
        if any(data[2:5]):
            return "a tendon that follows another by more than a line"
        for joint, share in tendons.shares[other].items():
            shares[joint] = shares.get(joint, 0.0) - data[1] * share
    some = [(joint, share) for joint, share in shares.items() if share]
    if not some:
        return None
    if len(some) == 1:
        bodies.lock(some[0][0], data[0] / some[0][1])
        return None
    if len(some) == 2:  # a length that stays is a line between two coordinates
        (follower, own), (leader, share) = some
        return bodies.world.couple(bodies.joints[follower], bodies.joints[leader], (data[0] / own, -share / own))
    return tendons.chain(name, dict(some), mode="limited", lower=data[0], upper=data[0])
