"""What a model's sensors read, as far as a world has it."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Callable, NamedTuple

import numpy as np

from . import turns
from .links import Frame, name_of
from .problems import Problems

if TYPE_CHECKING:
    from .robot import Robot
    from .turns import Array

Read = Callable[[], Any]
AT_SITES = ("accelerometer", "velocimeter", "gyro", "magnetometer", "rangefinder", "touch", "force", "torque")


class Sensor(NamedTuple):
    name: str
    kind: str
    read: Read
    cutoff: float

    def __call__(self) -> Array:
        value = np.atleast_1d(np.asarray(self.read(), float))
        return np.clip(value, -self.cutoff, self.cutoff) if self.cutoff > 0 else value


class Sensors:
    """Of a robot: `all` by name."""

    def __init__(self, robot: Robot, problems: Problems) -> None:
        from .read import need_mujoco
        self.robot, self.model, self.links = robot, robot._model, robot._links
        self.mujoco = need_mujoco()
        self.needs_rates = False  # whether steps are to keep the velocities that they began with
        self.all: dict[str, Sensor] = {}
        self.subtrees: dict[int, Subtree] = {}
        words = {int(value): word[len("mjSENS_"):].lower() for word, value in self.mujoco.mjtSensor.__members__.items()}
        for k in range(self.model.nsensor):
            kind, name = words[int(self.model.sensor_type[k])], name_of(self.model, "sensor", k)
            read = self._reader(kind, k)
            if isinstance(read, str):
                problems.add("sensor", name, read)
            else:
                self.all[name] = Sensor(name, kind, read, float(self.model.sensor_cutoff[k]))

    def frame(self, kind: int, index: int) -> Frame | None:
        m, kinds = self.model, self.mujoco.mjtObj
        if kind in (int(kinds.mjOBJ_BODY), int(kinds.mjOBJ_XBODY)):
            own = np.zeros(3), turns.NONE
            if kind == int(kinds.mjOBJ_BODY):
                own = np.array(m.body_ipos[index]), turns.from_mujoco(m.body_iquat[index])
            body = index
        else:
            word = {int(kinds.mjOBJ_SITE): "site", int(kinds.mjOBJ_GEOM): "geom", int(kinds.mjOBJ_CAMERA): "cam"}.get(kind)
            if word is None:
                return None
            body = int(getattr(m, f"{word}_bodyid")[index])
            own = np.array(getattr(m, f"{word}_pos")[index]), turns.from_mujoco(getattr(m, f"{word}_quat")[index])
        return Frame(self.links.of_body[body], turns.on(self.links.within[body], own))

    # ---- by kind ----

    def _reader(self, kind: str, k: int) -> Read | str:
        m, robot = self.model, self.robot
        target = int(m.sensor_objid[k])
        simple = getattr(self, f"_{kind}", None)
        if kind.startswith(("frame", "subtree")) or kind in AT_SITES:
            if kind == "rangefinder" and int(m.sensor_objtype[k]) != int(self.mujoco.mjtObj.mjOBJ_SITE):
                return "a rangefinder that is not at a site"
            if simple is None:
                return f"of kind {kind}: the library does not tell that"
            if kind.startswith("subtree"):
                return simple(target)  # type: ignore[no-any-return]
            at = self.frame(int(m.sensor_objtype[k]), target)
            if at is None:
                return "of an object that has no frame"
            if kind.startswith("frame") and int(m.sensor_refid[k]) >= 0:
                seen_from = self.frame(int(m.sensor_reftype[k]), int(m.sensor_refid[k]))
                return "of an object that has no frame" if seen_from is None else simple(at, seen_from)
            return simple(at, None) if kind.startswith("frame") else simple(at, target)  # type: ignore[no-any-return]
        if kind in ("jointpos", "jointvel"):
            move = next(move for move in self.links.moves if move.index == target)
            return (lambda: robot.qpos[move.name]) if kind == "jointpos" else (lambda: robot.qvel[move.name])
        if kind in ("tendonpos", "tendonvel"):
            tendon = robot.tendons.get(name_of(m, "tendon", target))
            return "its tendon winds about a geom" if tendon is None else lambda: tendon.measure()[kind == "tendonvel"]
        if kind in ("actuatorpos", "actuatorvel", "actuatorfrc"):
            if not any(a.index == target for a in robot._actuators.all):
                return "of an actuator that is left out"
            if kind == "actuatorfrc":
                return lambda: robot._forces[target]
            return lambda: robot._actuators.measure(*robot._scalars())[kind == "actuatorvel"][target]
        if kind == "jointactfrc":
            return lambda: sum(a.pulls.get(target, 0.0) * robot._forces[a.index] for a in robot._actuators.all)
        if kind in ("ballquat", "ballangvel"):
            move = next(move for move in self.links.moves if move.index == target)
            return (lambda: robot.qpos[move.name]) if kind == "ballquat" else (lambda: robot.qvel[move.name])
        if kind == "clock":
            return lambda: robot.world.report.time
        return f"of kind {kind}: the library does not tell that"

    def _framepos(self, at: Frame, seen_from: Frame | None) -> Read:
        def read() -> Any:
            pose = self.robot._pose(at)
            if seen_from is None:
                return pose[0]
            base = self.robot._pose(seen_from)
            return turns.rotate(turns.inverse(base[1]), pose[0] - base[0])
        return read

    def _turn(self, at: Frame, seen_from: Frame | None) -> Array:
        turn = self.robot._pose(at)[1]
        return turn if seen_from is None else turns.multiply(turns.inverse(self.robot._pose(seen_from)[1]), turn)

    def _framequat(self, at: Frame, seen_from: Frame | None) -> Read:
        return lambda: turns.to_mujoco(self._turn(at, seen_from))

    def _framexaxis(self, at: Frame, seen_from: Frame | None) -> Read:
        return lambda: turns.rotate(self._turn(at, seen_from), (1, 0, 0))

    def _frameyaxis(self, at: Frame, seen_from: Frame | None) -> Read:
        return lambda: turns.rotate(self._turn(at, seen_from), (0, 1, 0))

    def _framezaxis(self, at: Frame, seen_from: Frame | None) -> Read:
        return lambda: turns.rotate(self._turn(at, seen_from), (0, 0, 1))

    def _framelinvel(self, at: Frame, seen_from: Frame | None) -> Read:
        def read() -> Any:
            linear = self.robot._velocity(at)[0]
            if seen_from is None:
                return linear
            base, pose = self.robot._pose(seen_from), self.robot._pose(at)
            moving = self.robot._velocity(seen_from)
            return turns.rotate(turns.inverse(base[1]), linear - moving[0] - turns.cross(moving[1], pose[0] - base[0]))
        return read

    def _frameangvel(self, at: Frame, seen_from: Frame | None) -> Read:
        def read() -> Any:
            spin = self.robot._velocity(at)[1]
            if seen_from is None:
                return spin
            return turns.rotate(turns.inverse(self.robot._pose(seen_from)[1]), spin - self.robot._velocity(seen_from)[1])
        return read

    def _framelinacc(self, at: Frame, seen_from: Frame | None) -> Read:
        self.needs_rates = True
        return lambda: self.robot._acceleration(at)[0] - np.array(self.robot.world.gravity)

    def _frameangacc(self, at: Frame, seen_from: Frame | None) -> Read:
        self.needs_rates = True
        return lambda: self.robot._acceleration(at)[1]

    def _accelerometer(self, at: Frame, site: int) -> Read:
        self.needs_rates = True
        return lambda: turns.rotate(turns.inverse(self.robot._pose(at)[1]), self.robot._acceleration(at)[0] - np.array(self.robot.world.gravity))

    def _velocimeter(self, at: Frame, site: int) -> Read:
        return lambda: turns.rotate(turns.inverse(self.robot._pose(at)[1]), self.robot._velocity(at)[0])

    def _gyro(self, at: Frame, site: int) -> Read:
        return lambda: turns.rotate(turns.inverse(self.robot._pose(at)[1]), self.robot._velocity(at)[1])

    def _magnetometer(self, at: Frame, site: int) -> Read:
        field = np.array(self.model.opt.magnetic, float)
        return lambda: turns.rotate(turns.inverse(self.robot._pose(at)[1]), field)

    def _rangefinder(self, at: Frame, site: int) -> Read:
        def read() -> float:
            pose = self.robot._pose(at)
            hit = self.robot.world.ray(pose[0], turns.rotate(pose[1], (0, 0, 1)), ignore=self.robot._bodies.of_link(at.link))
            return -1.0 if hit is None else float(hit.time)
        return read

    def _subtreecom(self, body: int) -> Read:
        return lambda: self._subtree(body).center()

    def _subtreelinvel(self, body: int) -> Read:
        return lambda: self._subtree(body).velocity()

    def _subtreeangmom(self, body: int) -> Read:
        return lambda: self._subtree(body).spin()

    def _subtree(self, body: int) -> Subtree:
        if body not in self.subtrees:
            self.subtrees[body] = Subtree(self.robot, body)
        return self.subtrees[body]

    def _touch(self, at: Frame, site: int) -> Read | str:
        body = self.robot._bodies.of_link(at.link) or self.robot._scenery.get(int(self.model.site_bodyid[site]))
        kind, size = int(self.model.site_type[site]), [float(x) for x in self.model.site_size[site]]
        inside = volume(self.mujoco.mjtGeom, kind, size)
        if inside is None:
            return "its site is neither ball, box, ellipsoid, capsule nor cylinder"

        def read() -> float:
            pose, force = self.robot._pose(at), 0.0
            if body is None:  # nothing of it can be touched
                return force
            for contact in self.robot.world.contacts():
                if body in (contact.body_a, contact.body_b):
                    at_site = turns.rotate(turns.inverse(pose[1]), np.array(contact.point) - pose[0])
                    force += self.robot._normal_force(contact) if inside(at_site) else 0.0
            return force
        return read

    def _force(self, at: Frame, site: int) -> Read | str:
        return self._borne(at, site, lambda force, torque, arm: force)

    def _torque(self, at: Frame, site: int) -> Read | str:
        return self._borne(at, site, lambda force, torque, arm: torque + turns.cross(arm, force))

    def _borne(self, at: Frame, site: int, which: Callable[[Array, Array, Array], Array]) -> Read | str:
        """What the parent does to a link, through its last joint."""
        link = self.links.links[at.link]
        if link.body != int(self.model.site_bodyid[site]):
            return "between two bodies that no joint moves: they are one body here, which bears what it bears within"
        if not link.moves or link.moves[-1].kind == "free":
            return lambda: np.zeros(3)
        move = link.moves[-1]

        def read() -> Any:
            pose, state = self.robot._pose(at), self.robot._bodies.joints[move.index].state
            body = self.robot._bodies.last(link).pose
            joint = np.array(body[0]) + turns.rotate(body[1], move.anchor)
            borne = which(np.array(state.force), np.array(state.torque), joint - pose[0])
            return turns.rotate(turns.inverse(pose[1]), borne)
        return read


class Subtree:
    """A body of MuJoCo's and all that hangs on it, of which each weighs what the model says."""

    def __init__(self, robot: Robot, body: int) -> None:
        m, links = robot._model, robot._links
        self.robot = robot
        among = [k for k in range(m.nbody) if m.body_mass[k] and hangs(m, k, body)]
        moving = [k for k in among if not links.links[links.of_body[k]].is_static]
        held = [k for k in among if links.links[links.of_body[k]].is_static]
        self.mass = float(sum(m.body_mass[k] for k in among))
        within = {k: turns.on(links.within[k], (np.array(m.body_ipos[k], float), turns.from_mujoco(m.body_iquat[k]))) for k in among}
        self.held = sum((float(m.body_mass[k]) * within[k][0] for k in held), np.zeros(3))  # kg m
        self.held_at = [(float(m.body_mass[k]), within[k][0]) for k in held]
        ends = [robot._bodies.last(links.links[links.of_body[k]]).handle for k in moving]
        self.bodies = list(dict.fromkeys(ends))
        self.of = np.array([self.bodies.index(end) for end in ends], int)
        self.masses = np.array([float(m.body_mass[k]) for k in moving])[:, None]
        self.offsets = np.array([within[k][0] for k in moving]).reshape(-1, 3)
        axes = [turns.matrix(within[k][1]) for k in moving]
        self.inertias = np.array([a @ np.diag(m.body_inertia[k]) @ a.T for a, k in zip(axes, moving)]).reshape(-1, 3, 3)

    def _read(self) -> tuple[Array, Array, Array, Array]:
        """@return centres, their velocities, turns as matrices, spins, in the world"""
        if not self.bodies:
            return (np.zeros((0, 3)),) * 2 + (np.zeros((0, 3, 3)), np.zeros((0, 3)))
        read = self.robot.world.read
        pose, rates, middle = (read(what, self.bodies)[self.of] for what in ("pose", "velocity", "center"))
        axes = turns.matrices(pose[:, 3:])
        at = pose[:, :3] + np.einsum("nij,nj->ni", axes, self.offsets)
        return at, rates[:, :3] + np.cross(rates[:, 3:], at - middle), axes, rates[:, 3:]

    def center(self) -> Array:
        at = self._read()[0]
        return ((self.masses * at).sum(axis=0) + self.held) / max(self.mass, 1e-300)  # type: ignore[no-any-return]

    def velocity(self) -> Array:
        return (self.masses * self._read()[1]).sum(axis=0) / max(self.mass, 1e-300)  # type: ignore[no-any-return]

    def spin(self) -> Array:
        """kg m^2/s, about its centre of mass"""
        at, rates, axes, spins = self._read()
        middle = ((self.masses * at).sum(axis=0) + self.held) / max(self.mass, 1e-300)
        mean = (self.masses * rates).sum(axis=0) / max(self.mass, 1e-300)
        own = np.einsum("nij,njk,nlk,nl->ni", axes, self.inertias, axes, spins)
        whole = (np.cross(at - middle, self.masses * (rates - mean)) + own).sum(axis=0)
        return whole + sum((np.cross(place - middle, -mass * mean) for mass, place in self.held_at), np.zeros(3))  # type: ignore[no-any-return]


def hangs(model: Any, body: int, on: int) -> bool:
    while body and body != on:
        body = int(model.body_parentid[body])
    return body == on


def volume(kinds: Any, kind: int, size: list[float]) -> Callable[[Array], bool] | None:
    """Whether a point is within a site, from its frame."""
    if kind == int(kinds.mjGEOM_SPHERE):
        return lambda p: float(p @ p) <= size[0] ** 2
    if kind == int(kinds.mjGEOM_BOX):
        return lambda p: bool(np.all(np.abs(p) <= size))
    if kind == int(kinds.mjGEOM_ELLIPSOID):
        return lambda p: float(np.sum((p / size) ** 2)) <= 1
    if kind == int(kinds.mjGEOM_CAPSULE):
        return lambda p: math.hypot(p[0], p[1], max(0.0, abs(p[2]) - size[1])) <= size[0]
    if kind == int(kinds.mjGEOM_CYLINDER):
        return lambda p: math.hypot(p[0], p[1]) <= size[0] and abs(p[2]) <= size[1]
    return None
