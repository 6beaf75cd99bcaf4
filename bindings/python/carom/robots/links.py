"""What bodies a model has once those that nothing moves against each other are one, what moves them, and where they are.

A link is such a group of MuJoCo's bodies; its frame is that of its first. Where a sensor measures what one body of a group bears, that
body begins a link of its own, which a weld holds. A link with several joints is a chain of nodes, one
a joint: the last node is the link itself, those before it carry what MuJoCo has no body for, and weigh next to nothing.
"""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Iterator, NamedTuple, Sequence

import numpy as np

from . import turns
from .inertias import LEAST_INERTIA, is_a_body

if TYPE_CHECKING:
    from .turns import Array, Pose

# What a node before a link's last has, of the link's mass, and of its least moment of inertia. Less takes the direct solver more
# rounds: three times as long at 1e-9 of either. More is inertia that the model has not.
NODE_MASS = 1e-10
NODE_TURN = 1e-6


def name_of(model: Any, kind: str, index: int) -> str:
    """The name of an element, or "body 3" where it has none."""
    return str(getattr(model, kind)(index).name) or f"{ {'jnt': 'joint', 'eq': 'equality', 'key': 'keyframe'}.get(kind, kind)} {index}"


@dataclass
class Move:
    """A joint of MuJoCo's, of which numbers it is, and what it turns or shifts."""
    index: int
    name: str
    kind: str  # "free", "ball", "slide", "hinge", "weld": of the library's alone
    q: int     # its first number in qpos
    v: int     # and in qvel
    anchor: Array  # m, frame of the link
    axis: Array    # unit, likewise
    zero: float    # m or rad: MuJoCo's coordinate where the model stands as it was written; Carom's is 0 there

    @property
    def positions(self) -> int:
        return {"free": 7, "ball": 4, "weld": 0}.get(self.kind, 1)

    @property
    def speeds(self) -> int:
        return {"free": 6, "ball": 3, "weld": 0}.get(self.kind, 1)

    def step(self, pose: Pose, q: Any) -> Pose:
        """Where the joint leads from `pose`, that of what it moves while it does nothing."""
        if self.kind == "weld":
            return pose
        if self.kind == "slide":
            return pose[0] + (float(q[self.q]) - self.zero) * turns.rotate(pose[1], self.axis), pose[1]
        turn = turns.from_mujoco(q[self.q:self.q + 4]) if self.kind == "ball" else turns.about(self.axis, float(q[self.q]) - self.zero)
        turned = turns.multiply(pose[1], turn)
        return pose[0] + turns.rotate(pose[1], self.anchor) - turns.rotate(turned, self.anchor), turned


@dataclass
class Link:
    body: int                     # MuJoCo's, the first of the group
    parent: int                   # link; 0: the world
    rest: Pose                    # in the parent's frame, as the model was written
    mass: float = 0.0             # kg
    center: Array = field(default_factory=lambda: np.zeros(3))           # m
    inertia: Array = field(default_factory=lambda: np.zeros((3, 3)))     # kg m^2, about the centre, axes of the frame
    lift: float = 0.0             # kg: of its mass, what gravcomp bears
    least: float = 0.0            # kg m^2: of one that weighs nothing, and is a node, the least moment of inertia of what it carries
    moves: list[Move] = field(default_factory=list)
    group: int = -1               # the link that its weld, or those of its parents, hold it to; itself where a joint moves it
    mocap: int = -1
    first_node: int = -1          # its nodes are numbered on from here; -1: it does not move

    @property
    def is_a_body(self) -> bool:
        """Whether its mass and inertia are some that a body can have."""
        return self.mass > LEAST_INERTIA and is_a_body(np.linalg.eigvalsh(self.inertia))

    @property
    def is_static(self) -> bool:
        return not self.moves and self.mocap < 0

    @property
    def nodes(self) -> int:
        return max(1, len(self.moves))


class Frame(NamedTuple):
    """Of a body, site, geom or camera of MuJoCo's: a place on a link."""
    link: int
    within: Pose


class Links:
    """Of a model: `links` in the order of MuJoCo's bodies, `of_body` and `within`: the link of each body, and its pose there."""

    def __init__(self, model: Any) -> None:
        self.model = model
        self.links: list[Link] = []
        self.of_body: list[int] = []
        self.within: list[Pose] = []
        self._measured = measured(model)
        for body in range(model.nbody):
            self._add(body)
        lend(self.links)
        self.nodes = 0
        for link in self.links:
            if not link.is_static:
                link.first_node = self.nodes
                self.nodes += link.nodes

    def _add(self, body: int) -> None:
        m = self.model
        own: Pose = np.array(m.body_pos[body], float), turns.from_mujoco(m.body_quat[body])
        parent = int(m.body_parentid[body])
        moved = bool(m.body_jntnum[body]) or m.body_mocapid[body] >= 0
        welded = not moved and body in self._measured and bool(self.links) and not self.links[self.of_body[parent]].is_static
        if body and not moved and not welded:  # part of its parent's link, or of the scenery
            own = turns.on(self.within[parent], own)
            self.of_body.append(self.of_body[parent])
            self.within.append(own)
            self._weigh(self.links[self.of_body[body]], body, own)
            return
        link = Link(body, self.of_body[parent] if body else 0, turns.on(self.within[parent], own) if body else own,
                    mocap=int(m.body_mocapid[body]))
        link.group = self.links[link.parent].group if welded else len(self.links)
        self.of_body.append(len(self.links))
        self.within.append((np.zeros(3), turns.NONE))
        self.links.append(link)
        if welded:
            link.moves.append(Move(-1 - body, f"weld of {name_of(m, 'body', body)}", "weld", 0, 0, np.zeros(3), np.array([1.0, 0.0, 0.0]), 0.0))
        for joint in range(m.body_jntadr[body], m.body_jntadr[body] + m.body_jntnum[body]):
            kind = ("free", "ball", "slide", "hinge")[int(m.jnt_type[joint])]
            q = int(m.jnt_qposadr[joint])
            link.moves.append(Move(joint, name_of(m, "jnt", joint), kind, q, int(m.jnt_dofadr[joint]), np.array(m.jnt_pos[joint], float),
                                   np.array(m.jnt_axis[joint], float), float(m.qpos0[q]) if kind in ("slide", "hinge") else 0.0))
        self._weigh(link, body, self.within[body])

    def _weigh(self, link: Link, body: int, pose: Pose) -> None:
        """Add a body's mass to its link's."""
        m = self.model
        mass, (center, turn) = float(m.body_mass[body]), turns.on(pose, (np.array(m.body_ipos[body]), turns.from_mujoco(m.body_iquat[body])))
        axes = turns.matrix(turn)
        link.inertia = link.inertia + axes @ np.diag(m.body_inertia[body]) @ axes.T  # that of what has no mass counts, too
        if not mass:
            return
        whole = link.mass + mass
        between = center - link.center
        link.inertia = link.inertia + link.mass * mass / whole * (between @ between * np.eye(3) - np.outer(between, between))
        link.center = link.center + mass / whole * between
        link.mass = whole
        link.lift += mass * float(m.body_gravcomp[body])

    @property
    def moving(self) -> Iterator[Link]:
        return (link for link in self.links if not link.is_static)

    @property
    def moves(self) -> Iterator[Move]:
        return (move for link in self.links for move in link.moves)

    def poses(self, q: Sequence[float] | Array, mocap: Any = None) -> tuple[list[Pose], list[Pose]]:
        """@param q  qpos   @param mocap  poses of mocap bodies, None: as the model was written
        @return (of links, of nodes)"""
        of_links: list[Pose] = []
        of_nodes: list[Pose] = []
        for link in self.links:
            pose = turns.on(of_links[link.parent], link.rest) if of_links else link.rest
            if link.mocap >= 0:
                pose = mocap[link.mocap] if mocap is not None else pose
                of_nodes.append(pose)
            for move in link.moves:
                if move.kind == "free":
                    pose = np.array(q[move.q:move.q + 3], float), turns.from_mujoco(q[move.q + 3:move.q + 7])
                else:
                    pose = move.step(pose, q)
                of_nodes.append(pose)
            of_links.append(pose)
        return of_links, of_nodes

    def velocities(self, q: Any, v: Any, of_links: list[Pose]) -> Array:
        """@return (nodes, 6): of each node's origin, m/s, and its turn, rad/s, world"""
        out, found = np.zeros((self.nodes, 6)), np.zeros((len(self.links), 6))
        for at, link in enumerate(self.links):
            if link.is_static or link.mocap >= 0:
                continue
            base, parent = of_links[link.parent], found[link.parent]
            pose = turns.on(base, link.rest)
            linear = parent[:3] + turns.cross(parent[3:], pose[0] - base[0])
            angular = parent[3:].copy()
            for k, move in enumerate(link.moves):
                mine = v[move.v:move.v + move.speeds]
                if move.kind == "free":
                    pose = of_links[at]
                    linear, angular = np.array(mine[:3], float), turns.rotate(pose[1], mine[3:])
                elif move.kind != "weld":
                    after = move.step(pose, q)
                    linear = linear + turns.cross(angular, after[0] - pose[0])
                    if move.kind == "slide":
                        linear = linear + mine[0] * turns.rotate(pose[1], move.axis)
                    else:
                        spin = turns.rotate(after[1], mine) if move.kind == "ball" else mine[0] * turns.rotate(pose[1], move.axis)
                        anchor = pose[0] + turns.rotate(pose[1], move.anchor)
                        linear, angular = linear + turns.cross(spin, after[0] - anchor), angular + spin
                    pose = after
                out[link.first_node + k] = np.concatenate([linear, angular])
            found[at] = out[link.first_node + link.nodes - 1]
        return out


LENT = 0.1  # of what a link has to lend: of its mass, and of its least moment of inertia


def lend(links: list[Link]) -> None:
    """Let links that weigh nothing, or turn like points, borrow from those that hinges hold to them. A point on a hinge's axis, and a
    moment of inertia that is alike all about it, do the same to both links: what one has and the other has not moves nothing."""
    for k in range(len(links) - 1, 0, -1):
        link = links[k]
        if link.is_static or link.mocap >= 0 or link.is_a_body or len(link.moves) != 1:
            continue
        before = link.mass, link.center, link.inertia
        given: list[tuple[Link, Any]] = []
        for other in links:
            is_child = other.parent == k and len(other.moves) == 1 and other.moves[0].kind == "hinge" and other.is_a_body
            if is_child or (other is links[link.parent] and link.moves[0].kind == "hinge"):
                given.append((other, (other.mass, other.center, other.inertia)))
                borrow(link, other, other.moves[0] if is_child else link.moves[0], other.rest if is_child else None, link.rest)
        if not link.is_a_body:
            link.mass, link.center, link.inertia = before
            for other, had in given:
                other.mass, other.center, other.inertia = had
            carried = [other for other in links if other.parent == k and len(other.moves) == 1 and other.is_a_body and not other.lift]
            if not link.mass and carried:
                be_a_node(link, carried[0])


def be_a_node(link: Link, child: Link) -> None:
    """Let a link that weighs nothing be as what stands between the joints of one body: @see node_masses()."""
    link.least = child.least or float(np.linalg.eigvalsh(child.inertia)[0])
    share = child.mass / 2 if child.least else NODE_MASS * child.mass
    anchor = child.moves[0].anchor
    if child.moves[0].kind in ("hinge", "ball"):
        put(child, -share, (anchor, turns.NONE), 0.0)
    link.mass, link.center, link.inertia = share, turns.on(child.rest, (anchor, turns.NONE))[0], NODE_TURN * link.least * np.eye(3)


def borrow(link: Link, other: Link, hinge: Move, child_at: Pose | None, own_at: Pose) -> None:
    """@param child_at  where `other` is in the frame of `link`, whose child it is; None: it is its parent, and the other way about"""
    at_hinge = hinge.anchor, turns.x_to(hinge.axis)
    here = turns.on(child_at, at_hinge) if child_at is not None else at_hinge
    there = at_hinge if child_at is not None else turns.on(own_at, at_hinge)
    still = other.is_static
    if not still and (not other.is_a_body or other.lift or link.lift or len(other.moves) != 1):
        return
    if still:
        return put(link, 0.0, here, float(np.linalg.eigvalsh(link.inertia)[2]))
    had, least = (other.mass, other.center, other.inertia), float(np.linalg.eigvalsh(other.inertia)[0])
    moment, mass = LENT * least, LENT * (min(link.mass, other.mass) if link.mass else other.mass)
    put(other, -mass, there, -moment)
    while float(np.linalg.eigvalsh(other.inertia)[0]) < least / 2:  # of mass that lies far off
        mass /= 2
        other.mass, other.center, other.inertia = had
        put(other, -mass, there, -moment)
    put(link, mass, here, moment)


def put(link: Link, mass: float, at: Pose, moment: float) -> None:
    """Add a point, kg, and a moment of inertia, kg m^2, across the x axis of `at`."""
    whole = link.mass + mass
    if mass:
        between = at[0] - link.center
        reduced = link.mass * mass / whole
        link.inertia = link.inertia + reduced * (between @ between * np.eye(3) - np.outer(between, between))
        link.center = link.center + mass / whole * between
        link.mass = whole
    axis = turns.rotate(at[1], (1, 0, 0))
    link.inertia = link.inertia + moment * (np.eye(3) - np.outer(axis, axis))


def site_frame(model: Any, links: Links, site: int) -> Frame:
    body = int(model.site_bodyid[site])
    own = np.array(model.site_pos[site], float), turns.from_mujoco(model.site_quat[site])
    return Frame(links.of_body[body], turns.on(links.within[body], own))


def measured(model: Any) -> set[int]:
    """Bodies of which a sensor measures the force or torque that its parent exerts, and that weigh something."""
    from .read import need_mujoco
    kinds = need_mujoco().mjtSensor
    wanted = (int(kinds.mjSENS_FORCE), int(kinds.mjSENS_TORQUE))
    found = {int(model.site_bodyid[model.sensor_objid[k]]) for k in range(model.nsensor) if int(model.sensor_type[k]) in wanted}
    mass = [float(x) for x in model.body_mass]  # of a body and of those that are one with it
    for body in range(model.nbody - 1, 0, -1):
        if not model.body_jntnum[body] and body not in found:
            mass[int(model.body_parentid[body])] += mass[body]
    return {body for body in found if mass[body] > 0}


def node_masses(link: Link) -> list[tuple[float, Array, Array]]:
    """Mass, centre and inertia of each node. What nodes before the last weigh, at the anchors of their joints, the last does not:
    where the joints of a link share an anchor its mass, its centre and its weight are as the model has them."""
    own = (link.mass, link.center, link.inertia)
    if len(link.moves) < 2:
        return [own]
    before: list[tuple[float, Array, Array]] = []
    least = float(np.linalg.eigvalsh(link.inertia)[0])
    mass, center, inertia = own
    share = NODE_MASS * link.mass
    for move in link.moves[:-1]:
        before.append((share, move.anchor, NODE_TURN * least * np.eye(3)))
        rest = mass - share
        left = (mass * center - share * move.anchor) / rest
        off = move.anchor - left
        inertia = inertia - share * rest / mass * (off @ off * np.eye(3) - np.outer(off, off))
        mass, center = rest, left
    return [*before, (mass, center, inertia)]
