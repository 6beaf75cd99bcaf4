"""Tendons: lengths that bodies have between them, and what acts along those.

The length of a fixed tendon is a weighted sum of the coordinates of hinges and slides. Where it has a limit, friction or a rotor, or
where an equality holds more than two joints, the world gets a chain of sliders along x: each hangs on the one before, and a coupling
makes it go as far as one joint does, times its share. So where the last one's body is tells how much longer the tendon is than in the
model as it was written. What the tendon has is an axis's between the world and that body; a rotor is its mass. Snapshots have it.

A spatial tendon leads straight from site to site. Of one straight piece the world gets a distance joint for a limit and a spring for
stiffness and damping. Springs and dampers of fixed tendons, of pieces that bend and of what a substep does not carry are step()'s: a
spring of the world's is no stiffer than a substep resolves for what it is tied to, and a chain weighs next to nothing. A damper of an
axis there kept couplings from being led back: limits gave way by 1e-3.
"""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Container, NamedTuple

import numpy as np

from . import turns
from .bodies import within
from .links import Frame, name_of, site_frame

if TYPE_CHECKING:
    from ..body import Body
    from ..joint import Joint
    from .bodies import Bodies
    from .links import Links, Move
    from .turns import Array

# What a slider of a chain weighs, of what its tendon moves. At a tenth of it the solver no longer leads couplings back to where they
# belong at steps of 2 ms, and limits give way by 1e-4; more is inertia that the model has not.
OF_MOVED = 1e-5
CARRIED = 0.5  # a spatial spring of so much of what a substep resolves is left to step(): what its ends weigh changes as they turn


class Piece(NamedTuple):
    """A straight part of a spatial tendon."""
    a: Frame
    b: Frame
    share: float  # of its length in the tendon's: less than 1 behind a pulley


@dataclass
class Path:
    """Of a spatial tendon."""
    bodies: Bodies
    pieces: list[Piece]
    fixed: float  # m: pieces between sites of one link

    def _end(self, frame: Frame, ahead: float) -> tuple[Array, Array, Body | None]:
        """Where it will be in `ahead` s, if it goes on as now, m; how fast, m/s; on what."""
        body = self.bodies.of_link(frame.link)
        if body is None:
            return frame.within[0], np.zeros(3), None
        position, turn = body.pose
        point = np.array(position) + turns.rotate(np.array(turn), frame.within[0])
        velocity = body.linear_velocity + turns.cross(np.array(body.angular_velocity), point - body.center)
        return point + ahead * velocity, velocity, body

    def measure(self, ahead: float = 0.0) -> tuple[float, float]:
        """Length, m, and its rate, m/s."""
        length, rate = self.fixed, 0.0
        for piece in self.pieces:
            (a, a_rate, _), (b, b_rate, _) = self._end(piece.a, ahead), self._end(piece.b, ahead)
            long = math.sqrt(float((b - a) @ (b - a)))
            length += piece.share * long
            rate += piece.share * float((b_rate - a_rate) @ (b - a)) / max(long, 1e-300)
        return length, rate

    def push(self, force: float, ahead: float) -> None:
        """@param force  N, for the next step: above 0 it makes the tendon longer"""
        if not force:
            return
        for piece in self.pieces:
            (a, _, on_a), (b, _, on_b) = self._end(piece.a, ahead), self._end(piece.b, ahead)
            long = math.sqrt(float((b - a) @ (b - a)))
            if not long:  # it pulls nowhere
                continue
            along = piece.share * force / long * (b - a)
            if on_a is not None:
                on_a.add_force(-along, point=self._end(piece.a, 0.0)[0])
            if on_b is not None:
                on_b.add_force(along, point=self._end(piece.b, 0.0)[0])


@dataclass
class Chain:
    """Of a fixed tendon: what stands for its length in the world."""
    moves: list[Move]
    shares: Array
    nodes: list[Body]
    sliders: list[Joint]
    end: Joint  # between the world and the last body: its axis x has what the tendon has

    def offsets(self, values: Any) -> Array:
        """m or rad, of each body along x. @param values  of its joints, in that order"""
        return np.cumsum(self.shares * values)


@dataclass
class Spring:
    """That step() is to pull: towards a length from `low` to `high`, in MuJoCo's measure."""
    tendon: int
    stiffness: float  # N/m or N m/rad
    damping: float    # N s/m or N m s/rad
    low: float
    high: float
    light: float      # 1/kg or 1/(kg m^2): how fast it gets longer for an impulse of 1

    def damp(self, dt: float) -> float:
        """N for a rate of 1 at a step's beginning: a damper that the step does not resolve takes the rate to 0, and not beyond."""
        return self.damping / (1 + self.damping * dt * self.light)

    def force(self, length: float, rate: float, dt: float) -> float:
        return -self.stiffness * (length - min(max(length, self.low), self.high)) - self.damp(dt) * rate


class Tendon(NamedTuple):
    """Of a robot."""
    name: str
    kind: str  # "fixed", "spatial"
    measure: Callable[[], tuple[float, float]]
    chain: Chain | None

    @property
    def length(self) -> float:
        """m, or of a fixed one the sum of its joints' coordinates times their shares"""
        return self.measure()[0]

    @property
    def rate(self) -> float:
        """of its length, a second"""
        return self.measure()[1]


class Tendons:
    def __init__(self, bodies: Bodies, substep: float) -> None:
        self.bodies, self.model, self.substep = bodies, bodies.model, substep
        self.shares: dict[int, dict[int, float]] = {}  # of fixed tendons, by MuJoCo's joint
        self.paths: dict[int, Path] = {}
        self.chains: dict[str, Chain] = {}   # by tendon, or by equality
        self.ropes: dict[str, Joint] = {}    # distance joints, by tendon
        self.springs: list[Spring] = []
        for tendon in range(self.model.ntendon):
            shares = shares_of(self.model, tendon, bodies.axes)
            if shares is not None:
                self.shares[tendon] = {joint: share for joint, share in shares.items() if share}
                self._fixed(tendon)
                continue
            path = self._path(tendon)
            if path is None:
                self._out(tendon, self._has(tendon), "it winds about a geom: tendons here lead straight from site to site")
                continue
            self.paths[tendon] = path
            self._spatial(tendon, path)

    # ---- from the model ----

    def _has(self, tendon: int) -> dict[str, float]:
        """What acts along it, of what the model's options leave on."""
        m, off = self.model, self.bodies.disabled
        limited = bool(m.tendon_limited[tendon]) and not off.limit
        found = {"a limit": float(limited), "friction": 0.0 if off.friction else float(m.tendon_frictionloss[tendon]),
                 "stiffness": 0.0 if off.spring else float(m.tendon_stiffness[tendon]),
                 "damping": 0.0 if off.damper else float(m.tendon_damping[tendon]), "armature": float(m.tendon_armature[tendon])}
        return {what: value for what, value in found.items() if value}

    def _out(self, tendon: int, what: Any, reason: str) -> None:
        if what:
            self.bodies.problems.add("tendon", name_of(self.model, "tendon", tendon), f"{' and '.join(what)}: {reason}")

    def _fixed(self, tendon: int) -> None:
        m, has, shares = self.model, self._has(tendon), self.shares[tendon]
        if not shares:
            return  # its length never changes
        if {"stiffness", "damping"} & has.keys():
            self.springs.append(self._spring(tendon, has))
        if not has.keys() - {"stiffness", "damping"}:
            return
        axis: dict[str, Any] = {}
        if "a limit" in has:
            low, high = within(m.tendon_range[tendon], m.tendon_margin[tendon])
            zero = float(m.tendon_length0[tendon])
            axis.update(mode="limited", lower=low - zero, upper=high - zero)
        self.chain(name_of(m, "tendon", tendon), shares, has.get("armature", 0.0), friction=has.get("friction", 0.0), **axis)

    def _spring(self, tendon: int, has: dict[str, float]) -> Spring:
        m = self.model
        low, high = (float(x) for x in m.tendon_lengthspring[tendon])
        return Spring(tendon, has.get("stiffness", 0.0), has.get("damping", 0.0), low, high, float(m.tendon_invweight0[tendon]))

    def chain(self, name: str, shares: dict[int, float], rotor: float = 0.0, **axis: Any) -> Joint:
        """@param axis  of the whole length, less that of the model as it was written   @return the joint that has it"""
        m, world = self.model, self.bodies.world
        moves = [move for move in self.bodies.links.moves if move.index in shares]
        mass = OF_MOVED / sum(shares[move.index] ** 2 * float(m.dof_invweight0[move.v]) for move in moves)
        nodes: list[Body] = []
        sliders: list[Joint] = []
        for k, move in enumerate(moves):
            weight = max(mass, rotor) if k == len(moves) - 1 else mass
            node = world.body(mass=weight, center=(0, 0, 0), inertia=(weight, 0, 0, 0, weight, 0, 0, 0, weight))
            node.gravity_factor = 0.0
            sliders.append(world.joint("slider", nodes[-1] if nodes else None, node, position=(0, 0, 0), axis=(1, 0, 0)))
            world.couple(sliders[-1], self.bodies.joints[move.index], (0, shares[move.index]))
            nodes.append(node)
        end = sliders[0] if len(sliders) == 1 else world.joint("six_axis", None, nodes[-1], position=(0, 0, 0), axis=(1, 0, 0))
        end.axis("x", **axis)
        self.chains[name] = Chain(moves, np.array([shares[move.index] for move in moves]), nodes, sliders, end)
        return end

    def _path(self, tendon: int) -> Path | None:
        """None: it winds about something."""
        m, links = self.model, self.bodies.links
        from .read import need_mujoco
        kinds = need_mujoco().mjtWrap
        fixed, share, before = 0.0, 1.0, None
        pieces: list[Piece] = []
        for row in range(int(m.tendon_adr[tendon]), int(m.tendon_adr[tendon] + m.tendon_num[tendon])):
            kind, of = int(m.wrap_type[row]), int(m.wrap_objid[row])
            if kind == int(kinds.mjWRAP_PULLEY):
                share, before = 1 / float(m.wrap_prm[row]), None
                continue
            if kind != int(kinds.mjWRAP_SITE):
                return None
            frame = site_frame(m, links, of)
            if before is not None and before.link == frame.link:
                fixed += share * float(np.linalg.norm(frame.within[0] - before.within[0]))
            elif before is not None:
                pieces.append(Piece(before, frame, share))
            before = frame
        return Path(self.bodies, pieces, fixed)

    def _spatial(self, tendon: int, path: Path) -> None:
        m, has, name = self.model, self._has(tendon), name_of(self.model, "tendon", tendon)
        self._out(tendon, [what for what in ("friction", "armature") if what in has], "a spatial tendon here has none")
        if not path.pieces:
            return
        if "a limit" in has:
            low, high = ((bound - path.fixed) / path.pieces[0].share for bound in within(m.tendon_range[tendon], m.tendon_margin[tendon]))
            if len(path.pieces) > 1:
                self._out(tendon, ["a limit"], "it bends at a site that moves: a distance joint is straight")
            elif high < 0:
                self._out(tendon, ["a limit"], "it is shorter than what of the tendon has a fixed length")
            else:
                self.rope(name, path).limit("distance", lower=max(0.0, low), upper=high)
        if not {"stiffness", "damping"} & has.keys():
            return
        spring = self._spring(tendon, has)
        if not self._in_world(path, spring):
            self.springs.append(spring)

    def rope(self, name: str, path: Path, length: float | None = None) -> Joint:
        """A distance joint for its one piece. @param length  m, of the whole tendon"""
        [piece] = path.pieces
        about: dict[str, Any] = {} if length is None else {"length": (length - path.fixed) / piece.share}
        of_a, of_b = self.bodies.of_link(piece.a.link), self.bodies.of_link(piece.b.link)
        made = self.bodies.world.joint("distance", of_a, of_b, position_a=piece.a.within[0], position_b=piece.b.within[0], collide=True, **about)
        self.ropes[name] = made
        return made

    def _in_world(self, path: Path, spring: Spring) -> bool:
        """Whether a spring of the world's does all that it does."""
        low, high = spring.low, spring.high
        pulls = low <= 0 and high > 0  # a bungee: it acts from `high` on. Dampers of bungees hold nothing that is slack
        if len(path.pieces) != 1 or not (low == high or pulls and not spring.damping):
            return False
        [piece] = path.pieces
        scale, rest = piece.share ** 2, (high - path.fixed) / piece.share
        mass = self._weigh(path)
        if rest < 0 or not (spring.stiffness * scale < CARRIED * mass / self.substep ** 2 and spring.damping * scale < CARRIED * mass / self.substep):
            return False
        self.bodies.world.spring(self.bodies.of_link(piece.a.link), self.bodies.of_link(piece.b.link), rest, spring.stiffness * scale,
                                 spring.damping * scale, piece.a.within[0], piece.b.within[0], only_pulls=pulls)
        return True

    def _weigh(self, path: Path) -> float:
        """kg: what the two ends of its one piece weigh along it, were their bodies alone."""
        [piece] = path.pieces
        (a, _, on_a), (b, _, on_b) = path._end(piece.a, 0.0), path._end(piece.b, 0.0)
        along = (b - a) / max(math.sqrt(float((b - a) @ (b - a))), 1e-300)
        inverse = 0.0
        for point, body in ((a, on_a), (b, on_b)):
            if body is None or body.type != "dynamic":
                continue
            mass, _, inertia = body._masses()
            axes = turns.matrix(np.array(body.orientation))
            arm = turns.cross(point - body.center, along)
            inverse += 1 / mass + float(arm @ np.linalg.solve(axes @ np.reshape(inertia, (3, 3)) @ axes.T, arm))
        return 1 / inverse if inverse else math.inf


def have_chains(model: Any) -> bool:
    """Whether bodies that weigh next to nothing stand for some of its tendons."""
    from .read import need_mujoco
    mujoco = need_mujoco()

    def joints(tendon: int) -> int:
        """Of a fixed tendon; 0: it is spatial."""
        rows = slice(int(model.tendon_adr[tendon]), int(model.tendon_adr[tendon] + model.tendon_num[tendon]))
        return int(np.sum(model.wrap_type[rows] == int(mujoco.mjtWrap.mjWRAP_JOINT)))

    acted = np.flatnonzero(model.tendon_limited.astype(bool) | (model.tendon_frictionloss != 0) | (model.tendon_armature != 0))
    held = np.flatnonzero(model.eq_type == int(mujoco.mjtEq.mjEQ_TENDON))
    return any(joints(int(tendon)) for tendon in acted) or any(sum(joints(of) for of in (int(model.eq_obj1id[k]), int(model.eq_obj2id[k])) if of >= 0) > 2 for k in held)


def shares_of(model: Any, tendon: int, known: Container[int]) -> dict[int, float] | None:
    """Shares of joints in a fixed tendon's length; None: it is spatial, or of a joint that is not known."""
    from .read import need_mujoco
    of_joint = int(need_mujoco().mjtWrap.mjWRAP_JOINT)
    shares: dict[int, float] = {}
    for row in range(int(model.tendon_adr[tendon]), int(model.tendon_adr[tendon] + model.tendon_num[tendon])):
        joint = int(model.wrap_objid[row])
        if int(model.wrap_type[row]) != of_joint or joint not in known:
            return None
        shares[joint] = shares.get(joint, 0.0) + float(model.wrap_prm[row])
    return shares
