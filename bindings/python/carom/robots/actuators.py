"""Actuators: what controls do to joints.

A servo that alone drives its joint is a drive of the world's, with its damping and as much of its stiffness as a substep carries;
snapshots have it. What is stiffer, and all other actuators, Robot.step() finds before each step, from where joints are and go.
"""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import raw
from . import turns
from .bodies import OF_CAP, Bodies
from .links import Move, name_of
from .problems import Problems
from .tendons import Path, Tendons

if TYPE_CHECKING:
    from .turns import Array

INFINITE = 1e30  # N or N m: the library's word for no bound


@dataclass
class Actuator:
    index: int
    name: str
    control: int                       # in ctrl
    state: int                         # in act; -1: none
    pulls: dict[int, float]            # by joint of MuJoCo's: N or N m on it for 1 N; also its share of the length
    gain: tuple[float, float, float]   # force = (gain . (1, l, l')) control + bias . (1, l, l')
    bias: tuple[float, float, float]
    bounds: tuple[float, float]        # of its control
    force: tuple[float, float]         # N: of its force
    dynamics: str = "none"             # "none", "integrator", "filter", "filterexact"
    lag: float = 0.0                   # s
    states: tuple[float, float] = (-math.inf, math.inf)
    site: int = -1                     # that it pushes at, by `wrench`, site axes, for 1 N
    wrench: Any = None
    body: int = -1                     # of MuJoCo's, whose contacts it pulls together
    path: Path | None = None           # of the spatial tendon that it pulls, `gear` times
    gear: float = 1.0
    servo: tuple[float, float] | None = None  # stiffness and damping along the joint, of a drive of the world's

    @property
    def in_world(self) -> bool:
        return self.servo is not None


class Actuators:
    def __init__(self, bodies: Bodies, tendons: Tendons, problems: Problems) -> None:
        self.bodies, self.tendons, self.problems = bodies, tendons, problems
        self.model, self.links = bodies.model, bodies.links
        from .read import need_mujoco
        self.mujoco = need_mujoco()
        self.moves: list[Move] = [move for move in self.links.moves if move.kind in ("hinge", "slide")]
        self.at = {move.index: k for k, move in enumerate(self.moves)}
        self.all = [made for k in range(self.model.nu) if (made := self._read(k)) is not None]
        self._place()
        m, n = self.model, len(self.all)
        self.pushed = np.zeros(len(self.moves))  # N or N m: the effort that each axis has now
        self.of_host = np.array([bodies.by_host.get(move.index, 0.0) for move in self.moves])
        self.rest = np.array([float(m.qpos_spring[move.q]) for move in self.moves])
        self.zero = np.array([move.zero for move in self.moves])
        self.joint_range = np.array([m.jnt_actfrcrange[move.index] if m.jnt_actfrclimited[move.index] else (-np.inf, np.inf)
                                     for move in self.moves], float).reshape(-1, 2)
        # a row for each of `all`
        self.index = np.array([a.index for a in self.all], int)
        self.shares = np.array([[a.pulls.get(move.index, 0.0) for move in self.moves] for a in self.all]).reshape(n, len(self.moves))
        self.gain, self.bias = (np.array(rows, float).reshape(n, 3).T for rows in ([a.gain for a in self.all], [a.bias for a in self.all]))
        self.bounds, self.force = (np.array(rows, float).reshape(n, 2).T for rows in ([a.bounds for a in self.all], [a.force for a in self.all]))
        self.controls, self.states = np.array([a.control for a in self.all], int), np.array([a.state for a in self.all], int)
        self.by_step = np.array([not a.in_world and a.site < 0 and a.path is None for a in self.all], bool)
        self.beside = [k for k, a in enumerate(self.all) if a.path is not None]
        self.springs = springs = [spring for spring in tendons.springs if spring.tendon in tendons.shares]
        self.bungees = [spring for spring in tendons.springs if spring.tendon in tendons.paths]
        self.of_tendons = np.array([[tendons.shares[spring.tendon].get(move.index, 0.0) for move in self.moves]
                                    for spring in springs]).reshape(len(springs), len(self.moves))
        self.laws = np.array([(spring.stiffness, spring.low, spring.high) for spring in springs], float).reshape(len(springs), 3).T
        self.servos = Servos(self)

    # ---- from the model ----

    def _read(self, k: int) -> Actuator | None:
        m, mujoco, name = self.model, self.mujoco, name_of(self.model, "actuator", k)

        def out(reason: str) -> None:
            self.problems.add("actuator", name, reason)

        def word(enum: str, prefix: str, value: Any) -> str:
            return next((w[len(prefix):].lower() for w, v in getattr(mujoco, enum).__members__.items() if int(v) == int(value)), str(value))

        if self.bodies.disabled.actuation:
            return None
        if m.actuator_ctrlnum[k] != 1 or m.actuator_outnum[k] != 1:
            return out("it has several controls or forces")  # type: ignore[func-returns-value]
        through = word("mjtTrn", "mjTRN_", m.actuator_trntype[k])
        dynamics, gain, bias = (word(f"mjt{what}", f"mj{what.upper()}_", value[k]) for what, value in
                                (("Dyn", m.actuator_dyntype), ("Gain", m.actuator_gaintype), ("Bias", m.actuator_biastype)))
        if dynamics not in ("none", "integrator", "filter", "filterexact") or gain not in ("fixed", "affine") or bias not in ("none", "affine"):
            return out(f"a {next(w for w in (dynamics, gain, bias) if w not in ('none', 'fixed', 'affine', 'integrator', 'filter', 'filterexact'))} "
                       "has a law of its own: forces here are affine in control, length and speed")  # type: ignore[func-returns-value]
        for what in ("actuator_armature", "actuator_damping", "actuator_dampingpoly", "actuator_delay"):
            if np.any(getattr(m, what)[k]):
                out(f"its {what[len('actuator_'):]}: it acts without")
        pulls, site, wrench = self._through(k, through, out)
        body = int(m.actuator_trnid[k][0]) if through == "body" else -1
        if pulls is None:
            return None
        tendon = int(m.actuator_trnid[k][0]) if through == "tendon" else -1

        def bounds(limited: Any, given: Any) -> tuple[float, float]:
            return (float(given[0]), float(given[1])) if limited else (-math.inf, math.inf)

        g, b = [float(x) for x in m.actuator_gainprm[k][:3]], [float(x) for x in m.actuator_biasprm[k][:3]]
        state = int(m.actuator_actadr[k]) if dynamics != "none" else -1
        return Actuator(
            k, name, int(m.actuator_ctrladr[k]), state, pulls, (g[0], *(g[1:] if gain == "affine" else (0.0, 0.0))),
            tuple(b) if bias == "affine" else (0.0, 0.0, 0.0),  # type: ignore[arg-type]
            bounds(m.actuator_ctrllimited[k] and not self.bodies.disabled.clamp, m.actuator_ctrlrange[k]),
            bounds(m.actuator_forcelimited[k], m.actuator_forcerange[k]), dynamics, float(m.actuator_dynprm[k][0]),
            bounds(m.actuator_actlimited[k], m.actuator_actrange[k]), site, wrench, body, self.tendons.paths.get(tendon), float(m.actuator_gear[k][0]))

    def _through(self, k: int, through: str, out: Any) -> tuple[dict[int, float] | None, int, Any]:
        """@return shares of joints; site and wrench of one that pushes at a site. (None, -1, None): it is left out"""
        m, target, gear = self.model, int(self.model.actuator_trnid[k][0]), [float(x) for x in self.model.actuator_gear[k]]
        if through in ("joint", "jointinparent"):
            if target in self.at:
                return {target: gear[0]}, -1, None
            out("it drives a ball or a free joint")
        elif through == "tendon":
            if target in self.tendons.shares:
                return {joint: gear[0] * share for joint, share in self.tendons.shares[target].items()}, -1, None
            if target in self.tendons.paths:
                return {}, -1, None
            out("its tendon winds about a geom")
        elif through == "body":
            return {}, -1, None
        elif through == "site" and m.actuator_trnid[k][1] < 0:
            if self.bodies.of_link(self.links.of_body[int(m.site_bodyid[target])]) is not None:
                return {}, target, np.array(gear)
            out("it pushes at a site that does not move")
        elif through == "site":
            out("it pulls a site towards a place in another's frame")
        else:
            out(f"it acts by a {through}: the library has none")
        return None, -1, None

    def _place(self) -> None:
        """Which are drives of the world's."""
        m, users = self.model, [joint for actuator in self.all for joint in actuator.pulls]
        for actuator in self.all:
            if len(actuator.pulls) != 1 or any(actuator.gain[1:]):
                continue
            [(joint, gear)] = actuator.pulls.items()
            stiffness, damping = -gear * gear * actuator.bias[1], -gear * gear * actuator.bias[2]
            joint_range = m.jnt_actfrcrange[joint] if m.jnt_actfrclimited[joint] else (0.0, 0.0)
            one_way = actuator.force[0] != -actuator.force[1] or joint_range[0] != -joint_range[1]
            if users.count(joint) > 1 or one_way or stiffness < 0 or damping < 0 or not (stiffness or damping):
                continue
            axis = self.bodies.axes[joint]
            carried = OF_CAP / (2 if axis.spring_stiffness else 1) * self.bodies.stiffest[joint]
            axis.drive_stiffness = stiffness if stiffness <= carried else carried if damping else 0.0
            if not (axis.drive_stiffness or damping):
                continue
            axis.drive, axis.drive_damping = raw.CAROM_DRIVE_POSITION, damping
            axis.max_force = min(INFINITE, abs(gear) * actuator.force[1])
            actuator.servo = stiffness, damping
            self.bodies.set_axis(self.moves[self.at[joint]])

    # ---- a step ----

    def inputs(self, control: Any, act: Any) -> Array:
        """What the law of each takes: its control within its range, or its activation."""
        given = np.clip(control[self.controls], self.bounds[0], self.bounds[1]) if self.all else np.zeros(0)
        with_state = self.states >= 0
        given[with_state] = act[self.states[with_state]]
        return given

    def measure(self, q: Any, v: Any) -> tuple[Array, Array]:
        """Lengths of MuJoCo's actuators and their rates, at these places and speeds of hinges and slides."""
        out = np.zeros((2, self.model.nu))
        out[:, self.index] = self._measure(q, v, 0.0)
        return out[0], out[1]

    def _measure(self, q: Any, v: Any, ahead: float) -> tuple[Array, Array]:
        length, speed = self.shares @ q, self.shares @ v
        for k in self.beside:
            a = self.all[k]
            assert a.path is not None
            length[k], speed[k] = (a.gear * value for value in a.path.measure(ahead))
        return length, speed

    def forces(self, given: Array, q: Any, v: Any, ahead: float) -> Array:
        """N or N m, of each, at these places and speeds of hinges and slides. @param ahead  s: that q is later than the world"""
        length, speed = self._measure(q, v, ahead)
        force = (self.gain[0] + self.gain[1] * length + self.gain[2] * speed) * given + self.bias[0] + self.bias[1] * length + self.bias[2] * speed
        return np.clip(force, self.force[0], self.force[1])  # type: ignore[no-any-return]

    def push(self, control: Any, act: Any, q: Any, v: Any, dt: float, applied: Any) -> Array:
        """Give the world the efforts of a step, of what is not in it: found where joints will be in its middle, which keeps springs
        from gaining energy. @param applied  N or N m, of the host, beside. @return forces of MuJoCo's actuators"""
        middle, given = q + dt / 2 * v, self.inputs(control, act)
        self.servos.aim(given, middle)
        forces = self.forces(given, middle, v, dt / 2) if self.all else np.zeros(0)
        efforts = (forces * self.by_step) @ self.shares
        efforts = np.clip(efforts, self.joint_range[:, 0], self.joint_range[:, 1]) - self.of_host * (middle - self.rest) + applied
        if len(self.of_tendons):
            stiffness, low, high = self.laws
            length = self.of_tendons @ middle
            dampers = np.array([spring.damp(dt) for spring in self.springs])
            efforts -= (stiffness * (length - np.clip(length, low, high)) + dampers * (self.of_tendons @ v)) @ self.of_tendons
        beside = []
        for k in np.flatnonzero(efforts != self.pushed):
            move = self.moves[k]
            axis = self.bodies.axes[move.index]
            if axis.drive == raw.CAROM_DRIVE_POSITION:
                beside.append(k)
                continue
            axis.drive, axis.effort = raw.CAROM_DRIVE_EFFORT, float(efforts[k])
            self.bodies.set_axis(move)
        if beside:
            self.bodies.world.write_joints("target_effort", efforts[beside].reshape(-1, 1), [self.bodies.joints[self.moves[k].index] for k in beside])
        self.pushed = efforts
        for a, force in zip(self.all, forces):
            if a.site >= 0:
                self._push_at(a, float(force))
            elif a.body >= 0 and force:
                self._stick(a.body, float(force))
            elif a.path is not None:
                a.path.push(a.gear * float(force), dt / 2)
        for spring in self.bungees:
            path = self.tendons.paths[spring.tendon]
            path.push(spring.force(*path.measure(dt / 2), dt), dt / 2)
        whole = np.zeros(self.model.nu)
        whole[self.index] = forces
        return whole

    def rest_all(self) -> None:
        """No efforts, and every axis as it is known here."""
        for move in self.moves:
            axis = self.bodies.axes[move.index]
            if axis.drive == raw.CAROM_DRIVE_EFFORT:
                axis.drive, axis.effort = raw.CAROM_DRIVE_NONE, 0.0
            self.bodies.set_axis(move)
        driven = [k for k in np.flatnonzero(self.pushed) if self.bodies.axes[self.moves[k].index].drive == raw.CAROM_DRIVE_POSITION]
        if driven:
            self.bodies.world.write_joints("target_effort", np.zeros((len(driven), 1)), [self.bodies.joints[self.moves[k].index] for k in driven])
        self.pushed = np.zeros(len(self.moves))

    def _push_at(self, a: Actuator, force: float) -> None:
        m, body_of = self.model, int(self.model.site_bodyid[a.site])
        body = self.bodies.of_link(self.links.of_body[body_of])
        assert body is not None
        on_link = turns.on(self.links.within[body_of], (np.array(m.site_pos[a.site]), turns.from_mujoco(m.site_quat[a.site])))
        at, turn = turns.on(body.pose, on_link)  # type: ignore[arg-type]
        body.add_force(turns.rotate(turn, force * a.wrench[:3]), turns.rotate(turn, force * a.wrench[3:]), point=at)

    def _stick(self, body: int, force: float) -> None:
        """Pull what touches a body towards it: each contact point of the last step by an equal part."""
        world, known = self.bodies.world, self.bodies.of_link(self.links.of_body[body])
        if known is None:
            return
        rows = world.contact_array()
        rows = rows[((rows["body_a"] == known.handle) | (rows["body_b"] == known.handle)) & ((rows["separation"] <= 0) | (rows["normal_impulse"] > 0))]
        for row in rows:
            pull = force / len(rows) * row["normal"]  # A to B
            for handle, along in ((int(row["body_a"]), pull), (int(row["body_b"]), -pull)):
                on = self.bodies.by_handle.get(handle)
                if on is not None:
                    on.add_force(along, point=row["point"])

    def advance(self, control: Any, act: Any, dt: float) -> None:
        """Activations a step later."""
        for a in self.all:
            if a.state < 0:
                continue
            u, now = min(max(float(control[a.control]), a.bounds[0]), a.bounds[1]), float(act[a.state])
            if a.dynamics == "integrator":
                now += dt * u
            elif a.dynamics == "filter":
                now += dt * (u - now) / max(a.lag, 1e-15)
            else:
                now += (u - now) * -math.expm1(-dt / max(a.lag, 1e-15))
            act[a.state] = min(max(now, a.states[0]), a.states[1])


class Servos:
    """Drives of the world's to a position or a speed."""

    def __init__(self, actuators: Actuators) -> None:
        self.bodies, rows = actuators.bodies, [k for k, a in enumerate(actuators.all) if a.servo is not None]
        self.rows = np.array(rows, int)
        joints = [next(iter(actuators.all[k].pulls)) for k in rows]
        self.at = np.array([actuators.at[joint] for joint in joints], int)
        self.moves = [actuators.moves[at] for at in self.at]
        self.zero = actuators.zero[self.at]
        gear = np.array([actuators.all[k].pulls[joint] for k, joint in zip(rows, joints)])
        self.gain, self.bias = gear * actuators.gain[0][self.rows], gear * actuators.bias[0][self.rows]
        self.stiffness = np.array([self.bodies.axes[joint].drive_stiffness for joint in joints])
        self.damping = np.array([self.bodies.axes[joint].drive_damping for joint in joints])
        wanted = [servo[0] for k in rows if (servo := actuators.all[k].servo) is not None]
        self.lacking = np.array(wanted) - self.stiffness  # N/m or N m/rad: what step() adds
        self.aims = np.zeros((len(rows), 2))

    def aim(self, given: Array, middle: Any) -> None:
        """@param given  inputs() of all   @param middle  m or rad: where hinges and slides will be"""
        if not len(self.rows):
            return
        push = self.gain * given[self.rows] + self.bias - self.lacking * middle[self.at]
        soft = self.stiffness == 0
        aims = np.stack([np.where(soft, 0.0, push / np.where(soft, 1.0, self.stiffness) - self.zero),
                         np.where(soft, push / np.where(soft, self.damping, 1.0), 0.0)], axis=1)
        for k in np.flatnonzero((aims != self.aims).any(axis=1)):
            axis = self.bodies.axes[self.moves[k].index]
            axis.target, axis.speed = float(aims[k, 0]), float(aims[k, 1])
            self.bodies.set_axis(self.moves[k])
        self.aims = aims
