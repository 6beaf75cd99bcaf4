"""A robot in a world: its bodies, joints, actuators and sensors by name, its coordinates as arrays."""
from __future__ import annotations

import os
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, Callable, Iterator, Literal, Mapping, NamedTuple

import numpy as np

from ..errors import CaromError
from . import turns
from .actuators import Actuators
from .bodies import Bodies, Disabled, close_loops
from .fluid import Fluid
from .geoms import Geoms
from .links import Frame, Links, name_of
from .problems import LeftOut, Problems
from .save import save
from .sensors import Sensor, Sensors
from .tendons import Tendon, Tendons
from .unread import note_unread

if TYPE_CHECKING:
    from ..body import Body
    from ..engine import Engine
    from ..joint import Joint
    from ..world import World
    from .turns import Array, Pose


class Vector:
    """Numbers of a robot, as one array or by name: robot.qpos[:], robot.qpos["knee"] = 0.5, robot.ctrl[:] = 0."""

    def __init__(self, what: str, places: Mapping[str, slice], read: Callable[[], Array], write: Callable[[Array], None]) -> None:
        self._what, self.places, self._read, self._write = what, dict(places), read, write

    def _at(self, key: Any) -> Any:
        if not isinstance(key, str):
            return key
        if key not in self.places:
            raise KeyError(f"{self._what} has no {key!r}; it has {', '.join(self.places) or 'nothing'}")
        place = self.places[key]
        return place if place.stop - place.start > 1 else place.start

    def __getitem__(self, key: Any) -> Any:
        return self._read()[self._at(key)]

    def __setitem__(self, key: Any, value: Any) -> None:
        array = self._read()
        array[self._at(key)] = value
        if not np.isfinite(array).all():
            raise ValueError(f"{self._what} takes numbers that are finite, got {value!r}")
        self._write(array)

    def __len__(self) -> int:
        return len(self._read())

    def __iter__(self) -> Iterator[float]:
        return iter(self._read())

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return np.asarray(self._read(), dtype)

    def __repr__(self) -> str:
        return f"<{self._what} of {len(self)}: {', '.join(self.places)}>"


class Keyframe(NamedTuple):
    name: str
    qpos: Array
    qvel: Array
    act: Array
    ctrl: Array
    mocap: list[Pose]


class Robot:
    """Made by load(). Numbers stand in the order and the meaning that MuJoCo gives them: quaternions in qpos are w, x, y, z; of a
    free joint qvel has the velocity of the frame's origin in world axes and the turn in the body's.

    world, engine   what it stands in
    left_out        what the model has and the world does not: kind, names, reason
    qpos, qvel      coordinates and their rates; writing moves the bodies
    ctrl, act       controls and activations, for step()
    applied         N and N m on hinges and slides beside, in the order of qvel, until they are set anew
    bodies, joints  the library's objects by name. Bodies that no joint moves against each other are one.
    tendons         by name; each tells its length and rate
    """

    def __init__(self, model: Any, world: World, owned: Engine | None, dt: float, substeps: int, problems: Problems, made: list[Any]) -> None:
        self._model, self.world, self.engine, self._owned, self.dt = model, world, world.engine, owned, dt
        self._links = Links(model)
        disabled = Disabled(model)
        self._bodies = Bodies(world, model, self._links, disabled, dt / substeps, problems)
        m = model
        self._tendons = Tendons(self._bodies, dt / substeps)
        self._loops = close_loops(world, self._bodies, self._tendons, problems)
        body_of = {("link", k): self._bodies.last(link) for k, link in enumerate(self._links.links) if not link.is_static}
        if not disabled.contact:
            Geoms(m, self._links, problems).make(world, body_of, made)
        self._scenery = {body: known for (kind, body), known in body_of.items() if kind == "scenery"}
        self._actuators = Actuators(self._bodies, self._tendons, problems)
        self._fluid = Fluid(self._bodies)
        note_unread(m, problems)
        self._scalar_joints = np.array([self._bodies.joints[move.index].handle for move in self._actuators.moves], np.uint64)
        self._nodes = np.array([body.handle for body in self._bodies.nodes], np.uint64)
        self._zeros = np.array([move.zero for move in self._actuators.moves])
        self._q = np.array([move.q for move in self._actuators.moves], int)
        self._v = np.array([move.v for move in self._actuators.moves], int)
        self._ctrl, self._act, self._applied = np.zeros(m.nu), np.zeros(m.na), np.zeros(m.nv)
        self._forces = np.zeros(m.nu)
        self._before: Any = None
        self.bodies: dict[str, Body] = {name_of(m, "body", body): known for body in range(1, m.nbody)
                                        if (known := self._bodies.of_link(self._links.of_body[body])) is not None}
        named = [move for move in self._links.moves if move.kind != "weld"]
        self.joints: dict[str, Joint] = {**{move.name: self._bodies.joints[move.index] for move in named if move.kind != "free"}, **self._loops}
        self.qpos = Vector("qpos", {move.name: slice(move.q, move.q + move.positions) for move in named}, self._read_qpos,
                           lambda q: self._place(q, self._read_qvel()))
        self.qvel = Vector("qvel", {move.name: slice(move.v, move.v + move.speeds) for move in named}, self._read_qvel,
                           lambda v: self._place(self._read_qpos(), v))
        of_control = {a.name: slice(a.control, a.control + 1) for a in self._actuators.all}
        self.ctrl = Vector("ctrl", of_control, self._ctrl.copy, self._set(self._ctrl))
        of_state = {a.name: slice(a.state, a.state + 1) for a in self._actuators.all if a.state >= 0}
        self.act = Vector("act", of_state, self._act.copy, self._set(self._act))
        self.applied = Vector("applied", {move.name: slice(move.v, move.v + 1) for move in self._actuators.moves}, self._applied.copy,
                              self._set(self._applied))
        self.tendons: dict[str, Tendon] = {name_of(m, "tendon", k): self._tendon(k) for k in (*self._tendons.shares, *self._tendons.paths)}
        self._sensors = Sensors(self, problems)
        self.sensors: dict[str, Sensor] = self._sensors.all
        self.sites: list[str] = [name_of(m, "site", k) for k in range(m.nsite)]
        self.keyframes = {name_of(m, "key", k): self._keyframe(k) for k in range(m.nkey)}
        self.left_out: list[LeftOut] = problems.listed()
        self._aim()
        self._first = None if owned is None else world.save()

    @staticmethod
    def _set(own: Array) -> Callable[[Array], None]:
        def write(array: Array) -> None:
            own[:] = array
        return write

    def __repr__(self) -> str:
        m = self._model
        left = f", {len(self.left_out)} kinds of things left out" if self.left_out else ""
        return f"<carom.Robot: {len(self.bodies)} bodies, {m.nv} degrees of freedom, {len(self._actuators.all)} actuators{left}>"

    def close(self) -> None:
        """Close the engine that load() made. A world that was given stays."""
        if self._owned is not None:
            self._owned.close()

    def __enter__(self) -> Robot:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    # ---- coordinates ----

    def _scalars(self) -> tuple[Array, Array]:
        """Places and speeds of hinges and slides."""
        if not len(self._scalar_joints):
            return np.zeros(0), np.zeros(0)
        places = self.world.read_joints("position", self._scalar_joints)[:, 0] + self._zeros
        return places, self.world.read_joints("velocity", self._scalar_joints)[:, 0]

    def _tendon(self, k: int) -> Tendon:
        name, path = name_of(self._model, "tendon", k), self._tendons.paths.get(k)
        if path is not None:
            return Tendon(name, "spatial", path.measure, None)
        shares = np.array([self._tendons.shares[k].get(move.index, 0.0) for move in self._actuators.moves])

        def measure() -> tuple[float, float]:
            places, speeds = self._scalars()
            return float(shares @ places), float(shares @ speeds)
        return Tendon(name, "fixed", measure, self._tendons.chains.get(name))

    def _read_qpos(self) -> Array:
        q = np.array(self._model.qpos0, float)
        q[self._q] = self._scalars()[0]
        for link in self._links.moving:
            for k, move in enumerate(link.moves):
                if move.kind == "free":
                    position, turn = self._bodies.last(link).pose
                    q[move.q:move.q + 3], q[move.q + 3:move.q + 7] = position, turns.to_mujoco(turn)
                elif move.kind == "ball":
                    before, after = self._around(link, k)
                    q[move.q:move.q + 4] = turns.to_mujoco(turns.multiply(turns.inverse(before), after))
        return q

    def _around(self, link: Any, k: int) -> tuple[Array, Array]:
        """Turns of what a joint moves: before it acts, and after."""
        after = np.array(self._bodies.nodes[link.first_node + k].orientation)
        if k:
            return np.array(self._bodies.nodes[link.first_node + k - 1].orientation), after
        parent = self._bodies.of_link(link.parent)
        return (link.rest[1] if parent is None else turns.multiply(parent.orientation, link.rest[1])), after

    def _read_qvel(self) -> Array:
        v = np.zeros(self._model.nv)
        v[self._v] = self._scalars()[1]
        for link in self._links.moving:
            for k, move in enumerate(link.moves):
                body = self._bodies.nodes[link.first_node + k]
                if move.kind == "free":
                    turn, spin = np.array(body.orientation), np.array(body.angular_velocity)
                    v[move.v:move.v + 3] = body.linear_velocity - turns.cross(spin, turns.rotate(turn, link.center))
                    v[move.v + 3:move.v + 6] = turns.rotate(turns.inverse(turn), spin)
                elif move.kind == "ball":
                    base = self._bodies.nodes[link.first_node + k - 1] if k else self._bodies.of_link(link.parent)
                    spin = np.array(body.angular_velocity) - (0 if base is None else np.array(base.angular_velocity))
                    v[move.v:move.v + 3] = turns.rotate(turns.inverse(body.orientation), spin)
        return v

    def _place(self, q: Array, v: Array, mocap: Any = None) -> None:
        """Put every body where coordinates say."""
        if mocap is None:
            mocap = [self._bodies.last(link).pose for link in sorted((x for x in self._links.moving if x.mocap >= 0), key=lambda x: x.mocap)]
        of_links, of_nodes = self._links.poses(q, mocap)
        rates = self._links.velocities(q, v, of_links)
        nodes = self._nodes
        if not len(nodes):
            return
        self.world.write("pose", np.array([np.concatenate(pose) for pose in of_nodes]), nodes)
        arms = self.world.read("center", nodes) - np.array([pose[0] for pose in of_nodes])
        rates[:, :3] += np.cross(rates[:, 3:], arms)
        self.world.write("velocity", rates, nodes)
        for chain in self._tendons.chains.values():
            at, along = np.zeros((len(chain.nodes), 7)), np.zeros((len(chain.nodes), 6))
            at[:, 6] = 1
            at[:, 0] = chain.offsets([q[move.q] - move.zero for move in chain.moves])
            along[:, 0] = chain.offsets([v[move.v] for move in chain.moves])
            self.world.write("pose", at, chain.nodes)
            self.world.write("velocity", along, chain.nodes)
        places = q[self._q] - self._zeros
        if len(self._scalar_joints) and np.abs(self._scalars()[0] - q[self._q]).max() > 1:  # whole turns, which no pose tells
            try:
                self.world.write_joints("position", places.reshape(-1, 1), self._scalar_joints)
            except CaromError:  # of loops, which keep none
                pass

    # ---- time ----

    def reset(self, keyframe: str | int | None = None) -> None:
        """Put it where a keyframe has it, or, without one, where the model was written; at rest, and controls at 0, but for what the
        keyframe says. In a world of its own all is as it was after load(), so that equal steps lead to equal bits; its time is 0."""
        if self._first is not None:
            try:
                self.world.restore(self._first)
            except CaromError:  # the host has put something beside it: that stays as it is
                self._first = None
        self._before, self._forces[:] = None, 0
        self._applied[:] = 0
        self._actuators.rest_all()
        if keyframe is None:
            self._act[:], self._ctrl[:] = 0, 0
            self._place(np.array(self._model.qpos0, float), np.zeros(self._model.nv), self._mocap_poses(self._model.body_pos, self._model.body_quat))
        else:
            names = list(self.keyframes)
            name = names[keyframe] if isinstance(keyframe, int) and -len(names) <= keyframe < len(names) else keyframe
            if name not in self.keyframes:
                raise KeyError(f"there is no keyframe {keyframe!r}; there are {', '.join(names) or 'none'}")
            key = self.keyframes[name]
            self._act[:], self._ctrl[:] = key.act, key.ctrl
            self._place(key.qpos.copy(), key.qvel.copy(), key.mocap)
        self._aim()

    def _aim(self) -> None:
        """Drives as controls and places are now."""
        self._actuators.servos.aim(self._actuators.inputs(self._ctrl, self._act), self._scalars()[0])

    def _mocap_poses(self, positions: Any, quaternions: Any) -> list[Pose]:
        bodies = sorted((int(self._model.body_mocapid[body]), body) for body in range(self._model.nbody) if self._model.body_mocapid[body] >= 0)
        return [(np.array(positions[body], float), turns.from_mujoco(quaternions[body])) for _, body in bodies]

    def _keyframe(self, k: int) -> Keyframe:
        m = self._model
        rows = zip(np.reshape(m.key_mpos[k], (-1, 3)), np.reshape(m.key_mquat[k], (-1, 4)))
        mocap = [(np.array(at, float), turns.from_mujoco(turn)) for at, turn in rows]
        return Keyframe(name_of(m, "key", k), np.array(m.key_qpos[k], float), np.array(m.key_qvel[k], float), np.array(m.key_act[k], float),
                        np.array(m.key_ctrl[k], float), mocap)

    def step(self, steps: int = 1) -> None:
        """Apply the controls and advance by dt, so often."""
        for _ in range(steps):
            control = self._ctrl
            q, v = self._scalars()
            self._forces = self._actuators.push(control, self._act, q, v, self.dt, self._applied[self._v] if len(self._v) else np.zeros(0))
            self._fluid.push()
            self._bodies.rub(self.dt)
            self._actuators.advance(control, self._act, self.dt)
            if self._sensors.needs_rates:
                self._before = self._rates()
            self.world.step(self.dt)

    def save(self, path: str | os.PathLike[str]) -> tuple[Path, Path]:
        """Write PATH, a whole snapshot of the world as it is now, and PATH.json, names: for programs without MuJoCo. What step() does
        beside the world (actuators with "in_world": false, springs_of_the_host, springs_of_tendons, friction_of_turns, a fluid) is theirs to do. Who moves joints of a
        chain ("tendons") moves its sliders, too.   @return both paths"""
        return save(self, path)

    # ---- places ----

    def pose(self, name: str, kind: Literal["body", "site"] | None = None) -> tuple[Array, Array]:
        """Position, m, and orientation (x, y, z, w) of a body of the model, or else of a site, in the world.
        @param kind  which, where both have that name"""
        m, kinds = self._model, self._sensors.mujoco.mjtObj
        for word, count, of in (("body", m.nbody, kinds.mjOBJ_XBODY), ("site", m.nsite, kinds.mjOBJ_SITE)):
            for k in range(count) if kind in (None, word) else ():
                if name_of(m, word, k) == name:
                    frame = self._sensors.frame(int(of), k)
                    assert frame is not None
                    return self._pose(frame)
        raise KeyError(f"there is neither site nor body {name!r}; sites are {', '.join(self.sites) or 'none'}, bodies {', '.join(self.bodies)}")

    def _pose(self, frame: Frame) -> Pose:
        body = self._bodies.of_link(frame.link)
        if body is None:
            return frame.within
        position, turn = body.pose
        return turns.on((np.array(position), np.array(turn)), frame.within)

    def _velocity(self, frame: Frame) -> tuple[Array, Array]:
        body = self._bodies.of_link(frame.link)
        if body is None:
            return np.zeros(3), np.zeros(3)
        spin = np.array(body.angular_velocity)
        return body.linear_velocity + turns.cross(spin, self._pose(frame)[0] - body.center), spin

    def _rates(self) -> tuple[Array, Array, Array]:
        read = self.world.read
        return read("pose", self._nodes), read("velocity", self._nodes), read("center", self._nodes)

    def _acceleration(self, frame: Frame) -> tuple[Array, Array]:
        """m/s^2 and rad/s^2: means over the last step; 0 before one."""
        body, link = self._bodies.of_link(frame.link), self._links.links[frame.link]
        if body is None or self._before is None:
            return np.zeros(3), np.zeros(3)
        row = link.first_node + link.nodes - 1
        pose, velocity, center = (rows[row] for rows in self._before)
        at = pose[:3] + turns.rotate(pose[3:], frame.within[0])
        before = velocity[:3] + turns.cross(velocity[3:], at - center)
        now, spin = self._velocity(frame)
        return (now - before) / self.dt, (spin - velocity[3:]) / self.dt

    def _normal_force(self, contact: Any) -> float:
        return float(contact.normal_impulse / self.dt)

    # ---- dynamics ----

    def _trees(self) -> Iterator[tuple[Any, Any, Array]]:
        """Each tree, the rows of qvel that it has, and what turns MuJoCo's speeds into its own."""
        rooted: dict[int, list[Any]] = {}
        for k, link in enumerate(self._links.links):
            if link.moves:
                root = k
                while not self._links.links[self._links.links[root].parent].is_static and self._links.links[self._links.links[root].parent].mocap < 0:
                    root = self._links.links[root].parent
                rooted.setdefault(root, []).append(link)
        for links in rooted.values():
            tree = self.world.tree(self._bodies.nodes[links[0].first_node])
            rows = np.array([row for link in links for move in link.moves for row in range(move.v, move.v + move.speeds)])
            turn = np.eye(len(rows))
            at = 0
            for link in links:
                for k, move in enumerate(link.moves):
                    if move.kind == "free" and move.index in self._bodies.joints:  # of the joint that holds it to the world
                        turn[at + 3:at + 6, at + 3:at + 6] = turns.matrix(self._bodies.last(link).orientation)
                    elif move.kind == "free":
                        axes = turns.matrix(self._bodies.last(link).orientation)
                        arm = axes @ link.center
                        hat = np.array([[0, -arm[2], arm[1]], [arm[2], 0, -arm[0]], [-arm[1], arm[0], 0]])
                        turn[at:at + 3, at + 3:at + 6], turn[at + 3:at + 6, at + 3:at + 6] = -hat @ axes, axes
                    elif move.kind == "ball":
                        before, after = self._around(link, k)
                        turn[at:at + 3, at:at + 3] = turns.matrix(turns.multiply(turns.inverse(before), after))
                    at += move.speeds
            yield tree, rows, turn

    @property
    def mass(self) -> float:
        """kg, of all that moves"""
        return float(self.world.read("mass", self._nodes).sum()) if len(self._nodes) else 0.0

    def mass_matrix(self) -> Array:
        """(nv, nv), kg, kg m, kg m^2: the energy of motion is qvel @ mass_matrix() @ qvel / 2.
        @raise Unsupported  where joints close a loop"""
        whole = np.zeros((self._model.nv, self._model.nv))
        for tree, rows, turn in self._trees():
            whole[np.ix_(rows, rows)] = turn.T @ tree.mass @ turn
        return whole

    def gravity_forces(self) -> Array:
        """(nv,), N and N m: what holds the robot still against gravity, at its present place, all by joints.
        @raise Unsupported  where joints close a loop"""
        whole = np.zeros(self._model.nv)
        for tree, rows, turn in self._trees():
            whole[rows] = turn.T @ tree.forces(speeds=[0.0] * len(rows))
        return whole
