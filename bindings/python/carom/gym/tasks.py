"""The tasks that come with the package. Their robots are their own: sizes and masses stand here."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from .task import Task, rows

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..batch import Batch
    from ..body import Body
    from ..engine import Engine
    from ..joint import Joint
    from ..world import World
    from .task import Array

Point = tuple[float, float, float]


def hinge(world: World, a: Body | None, b: Body, at: Point, axis: Point, low: float, high: float, armature: float = 0.01,
          damping: float = 0.2, stiffness: float = 0.0) -> Joint:
    """Degrees, kg m^2, N m s/rad, N m/rad towards the stance."""
    joint = world.joint("hinge", a, b, position=at, axis=axis)
    joint.axis("turn_x", mode="limited", lower=math.radians(low), upper=math.radians(high), armature=armature, spring_damping=damping,
               spring_stiffness=stiffness, spring_gains="force")
    return joint


def rod(engine: Engine, world: World, start: Point, end: Point, radius: float, density: float = 1000) -> Body:
    """A capsule between two points."""
    a, b = np.array(start), np.array(end)
    way = b - a
    length = float(np.linalg.norm(way))
    axis = np.cross((0, 1, 0), way / length)
    cosine = way[1] / length
    turn = (1.0, 0.0, 0.0, 0.0) if cosine < -1 + 1e-9 else (*axis, 1 + cosine)
    return world.body(engine.capsule(radius, length / 2), position=tuple((a + b) / 2), orientation=tuple(np.array(turn) / np.linalg.norm(turn)),
                      density=density)


class CartPole(Task):
    """A cart of 1 kg holds up a pole of 0.2 kg and 1 m. Observation: place, angle, their rates. Reward: 1 for each action until the
    pole leans by 0.25 rad or the cart has gone 2 m."""

    dt, steps, longest = 1 / 200, 4, 500
    actions, observations = 1, 4

    def build(self, engine: Engine) -> World:
        world = engine.world(substeps=2)
        cart = world.body(engine.box(0.2, 0.1, 0.1), mass=1.0)
        pole = rod(engine, world, (0, 0, 0), (0, 1, 0), 0.03, 60)
        pole.mass = 0.2
        world.joint("slider", None, cart, position=(0, 0, 0), axis=(1, 0, 0))
        world.joint("hinge", cart, pole, position=(0, 0, 0), axis=(0, 0, 1))
        self._joints = world.joints
        return world

    def joints(self) -> list[Joint]:
        return self._joints

    def act(self, actions: Array) -> None:
        self.effort.array[:, 0, 0] = 10 * actions[:, 0]  # N

    def observe(self) -> Array:
        return rows(self.place, self.speed)

    def judge(self, actions: Array) -> tuple[Array, NDArray[np.bool_]]:
        place = self.place.array[:, :, 0]
        over = (np.abs(place[:, 0]) > 2) | (np.abs(place[:, 1]) > 0.25)
        return np.ones(len(place)), over


class Walker(Task):
    """What stands on legs and is to go along x. Observation: height, orientation, joint angles, velocity and turn of the trunk, joint
    speeds. Reward: speed along x, 1 for standing, less for effort."""

    lowest, highest = 0.0, math.inf  # m, of the trunk while it stands
    strengths: Any = 1.0             # N m, of each joint for an action of 1
    cost = 0.1                       # of an action of 1 in all joints
    trunk: Body
    hinges: list[Joint]

    def joints(self) -> list[Joint]:
        return self.hinges

    def attach(self, batch: Batch) -> None:
        super().attach(batch)
        self.pose = batch.column("bodies", "pose", [self.trunk], when="after_step")
        self.motion = batch.column("bodies", "velocity", [self.trunk], when="after_step")

    def act(self, actions: Array) -> None:
        self.effort.array[:, :, 0] = self.strengths * actions

    def observe(self) -> Array:
        pose = self.pose.array[:, 0]
        return rows(pose[:, 1:2], pose[:, 3:], self.place, self.motion, self.speed)

    def judge(self, actions: Array) -> tuple[Array, NDArray[np.bool_]]:
        height = self.pose.array[:, 0, 1]
        over = (height < self.lowest) | (height > self.highest)
        return self.motion.array[:, 0, 0] + 1.0 - self.cost * np.square(actions).mean(axis=1), over


class Ant(Walker):
    """Four legs of two joints about a ball."""

    dt, steps = 1 / 200, 10
    actions, observations = 8, 5 + 8 + 6 + 8
    lowest, highest, strengths, cost = 0.2, 1.2, 40.0, 0.5

    def build(self, engine: Engine) -> World:
        world = engine.world(substeps=2)
        world.ground(material=world.material(friction=1.0))
        self.trunk = world.body(engine.sphere(0.25), position=(0, 0.6, 0), density=300)
        self.hinges = []
        for k in range(4):
            angle = math.pi / 4 + k * math.pi / 2
            out = np.array([math.cos(angle), 0, -math.sin(angle)])
            side = (math.sin(angle), 0.0, math.cos(angle))
            hip, knee = np.array([0, 0.6, 0]) + 0.28 * out, np.array([0, 0.6, 0]) + 0.56 * out
            foot = knee + 0.4 * out + np.array([0, -0.52, 0])
            thigh = rod(engine, world, tuple(hip), tuple(knee), 0.07, 300)
            shin = rod(engine, world, tuple(knee), tuple(foot), 0.07, 300)
            self.hinges += [hinge(world, self.trunk, thigh, tuple(hip), (0, 1, 0), -35, 35, 0.05),
                            hinge(world, thigh, shin, tuple(knee), side, -40, 40, 0.05)]
        return world


class Humanoid(Walker):
    """17 hinges: three of the waist, three of each hip, knees, two of each shoulder, elbows. Joints of several axes have small parts
    between them."""

    dt, steps = 1 / 300, 5
    actions, observations = 17, 5 + 17 + 6 + 17
    lowest, highest, cost, noise = 0.8, 2.0, 0.1, 0.01
    strengths = np.array([60.0] * 3 + [80, 60, 120, 100] * 2 + [25, 25, 25] * 2)

    def build(self, engine: Engine) -> World:
        world = engine.world(substeps=2)
        world.ground(material=world.material(friction=1.0))
        x, y, z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
        self.trunk = world.body(engine.box(0.1, 0.2, 0.16), position=(0, 1.3, 0), density=900)
        self.trunk.collider(engine.sphere(0.1), position=(0, 0.33, 0), density=900)
        self.hinges = []

        def chain(parent: Body, at: Point, axes: list[tuple[Point, float, float]], last: Body) -> None:
            parent.ignore_collision(last)  # small parts are between them
            for k, (axis, low, high) in enumerate(axes):
                child = last if k == len(axes) - 1 else world.body(position=at, mass=0.5, center=(0, 0, 0), inertia=(2e-3, 0, 0, 0, 2e-3, 0, 0, 0, 2e-3))
                self.hinges.append(hinge(world, parent, child, at, axis, low, high, 0.02, 1.0))
                parent = child

        pelvis = world.body(engine.box(0.09, 0.08, 0.14), position=(0, 0.98, 0), density=900)
        chain(self.trunk, (0, 1.08, 0), [(y, -45, 45), (z, -70, 30), (x, -30, 30)], pelvis)
        for side in (-1, 1):
            hip, knee, foot = (0.0, 0.9, 0.1 * side), (0.0, 0.5, 0.1 * side), (0.0, 0.1, 0.1 * side)
            thigh, shin = rod(engine, world, hip, knee, 0.06, 900), rod(engine, world, knee, foot, 0.05, 900)
            shin.collider(engine.box(0.12, 0.03, 0.05), position=tuple(np.array(shin_point(shin, (0.05, 0.05, 0.1 * side)))), density=400)
            chain(pelvis, hip, [(x, -25, 25), (y, -40, 40), (z, -20, 110)], thigh)
            self.hinges.append(hinge(world, thigh, shin, knee, z, -140, 2, 0.02, 1.0))
        for side in (-1, 1):
            shoulder, elbow, hand = (0.0, 1.45, 0.22 * side), (0.0, 1.17, 0.22 * side), (0.0, 0.92, 0.22 * side)
            upper, lower = rod(engine, world, shoulder, elbow, 0.04, 900), rod(engine, world, elbow, hand, 0.035, 900)
            chain(self.trunk, shoulder, [(x, -85, 85), (z, -60, 120)], upper)
            self.hinges.append(hinge(world, upper, lower, elbow, z, 0, 130, 0.02, 1.0))
        return world


def shin_point(body: Body, at: Point) -> Any:
    """A place of the world in a body's frame."""
    x, y, z, w = body.orientation
    q = np.array([-x, -y, -z])
    way = np.array(at) - np.array(body.position)
    return way + 2 * np.cross(q, np.cross(q, way) + w * way)


class Quadruped(Walker):
    """Four legs of three joints on a field of hills; each episode begins elsewhere on it. Springs hold its stance, actions push beside them. A
    row of nine rays down, up to 0.8 m ahead, is seen beside."""

    dt, steps = 1 / 200, 4
    actions, observations = 12, 5 + 12 + 6 + 12 + 9
    lowest, strengths, cost, noise = -math.inf, 30.0, 0.05, 0.02

    def build(self, engine: Engine) -> World:
        world = engine.world(substeps=2)
        grid = np.arange(81)
        hills = 0.06 * (np.sin(0.9 * grid)[:, None] * np.cos(0.7 * grid)[None, :] + 0.6 * np.sin(0.37 * grid[:, None] + 0.53 * grid[None, :]))
        self.field = world.body(engine.height_field(hills, (0.25, 0.25)), position=(-10, 0, -10), type="static", material=world.material(friction=1.0))
        self.trunk = world.body(engine.box(0.25, 0.06, 0.12), position=(0, 0.55, 0), mass=8.0)
        self.hinges = []
        for front in (1, -1):
            for side in (1, -1):
                hip = np.array([0.2 * front, 0.55, 0.14 * side])
                knee, foot = hip + (-0.1, -0.19, 0.02 * side), hip + (0.0, -0.38, 0.02 * side)
                carrier = world.body(position=tuple(hip), mass=0.4, center=(0, 0, 0), inertia=(1e-3, 0, 0, 0, 1e-3, 0, 0, 0, 1e-3))
                thigh, shin = rod(engine, world, tuple(hip), tuple(knee), 0.03, 900), rod(engine, world, tuple(knee), tuple(foot), 0.025, 900)
                self.trunk.ignore_collision(thigh)  # the carrier is between them
                self.hinges += [hinge(world, self.trunk, carrier, tuple(hip), (1, 0, 0), -40, 40, 0.02, 2.0, 100.0), hinge(world, carrier, thigh, tuple(hip), (0, 0, 1), -80, 80, 0.02, 2.0, 100.0),
                                hinge(world, thigh, shin, tuple(knee), (0, 0, 1), -80, 80, 0.02, 2.0, 100.0)]
        return world

    def attach(self, batch: Batch) -> None:
        super().attach(batch)
        self.ground = batch.column("bodies", "pose", [self.field])
        self.over = batch.column("bodies", "pose", [self.trunk])
        ahead = [(0.1 * k, 0, 0, 0, -1, 0, 3.0) for k in range(9)]
        self.scan = batch.column("rays", None, [self.trunk] * 9, when="after_step", rays=ahead)
        batch.read(self.ground, self.over)
        self.center = self.ground.array.copy()

    def begin(self, batch: Batch, mask: NDArray[np.bool_], seeds: NDArray[np.uint64]) -> None:
        shift = (2 * batch.random(2, mask=mask, seeds=seeds) - 1) * 6  # m: the field is 20 m wide
        self.ground.array[mask, 0, 0], self.ground.array[mask, 0, 2] = (self.center[mask, 0, 0] + shift[mask, 0], self.center[mask, 0, 2] + shift[mask, 1])
        batch.write(self.ground, mask=mask)
        super().begin(batch, mask, seeds)

    def observe(self) -> Array:
        return rows(super().observe(), self.scan)

    def judge(self, actions: Array) -> tuple[Array, NDArray[np.bool_]]:
        rewards, _ = super().judge(actions)
        x, z = self.pose.array[:, 0, 3], self.pose.array[:, 0, 5]
        return rewards, (1 - 2 * (x * x + z * z) < 0.3) | (self.scan.array[:, 0, 0] < 0.12)  # it lies on its side, or on its belly


class Stack(Task):
    """A cube that a force of up to twice its weight moves is to rest on another. The fourth number of an action below 0 lets go.
    Observation: places and velocities of both, where the first is of where it should be. Reward: nearness, and 5 while it rests there by
    itself."""

    dt, steps, longest = 1 / 120, 4, 200
    actions, observations = 4, 3 + 6 + 3 + 6 + 3
    half = 0.05  # m

    def build(self, engine: Engine) -> World:
        world = engine.world()
        world.ground()
        box = engine.box(self.half, self.half, self.half)
        self.cubes = [world.body(box, position=(x, self.half, 0), density=500) for x in (-0.2, 0.2)]
        return world

    def attach(self, batch: Batch) -> None:
        self.force = batch.column("bodies", "force", [self.cubes[0]], when="before_step")
        self.place = batch.column("bodies", "position", self.cubes, when="after_step")
        self.motion = batch.column("bodies", "velocity", self.cubes, when="after_step")
        self.weight = 9.81 * self.cubes[0].mass

    def begin(self, batch: Batch, mask: NDArray[np.bool_], seeds: NDArray[np.uint64]) -> None:
        shift = 0.2 * batch.random(4, mask=mask, seeds=seeds)
        self.place.array[mask, 0, 0::2] -= shift[mask, :2] * (1, -1)
        self.place.array[mask, 1, 0::2] += shift[mask, 2:] * (1, -1)
        batch.write(self.place, mask=mask)

    def act(self, actions: Array) -> None:
        held = actions[:, 3:] >= 0
        self.held = held[:, 0]
        force = 2 * self.weight * actions[:, :3] + (0, self.weight, 0) - 4 * self.weight * 0.1 * self.motion.array[:, 0, :3]
        self.force.array[:, 0, :3] = np.where(held, force, 0.0)

    def away(self) -> Array:
        return np.asarray(self.place.array[:, 0] - self.place.array[:, 1] - (0, 2 * self.half, 0))

    def observe(self) -> Array:
        return rows(self.place.array[:, 0], self.motion.array[:, 0], self.place.array[:, 1], self.motion.array[:, 1], self.away())

    def judge(self, actions: Array) -> tuple[Array, NDArray[np.bool_]]:
        away = np.linalg.norm(self.away(), axis=1)
        still = np.linalg.norm(self.motion.array[:, 0, :3], axis=1) < 0.02
        done = (away < self.half) & still & ~self.held
        fell = np.abs(self.place.array[:, 0, 0::2]).max(axis=1) > 2
        return np.exp(-5 * away) + 5.0 * done, fell


class Throw(Task):
    """Throw the bunny over the wall: one action, three numbers of its velocity and one of its spin, then it flies for 3 s. Observation: the
    wall's place and height, and where the basket is behind it. Reward: 1 less the way to the basket in metres, less 1 if it stays before
    the wall."""

    dt, steps, longest = 1 / 120, 360, 1
    actions, observations = 4, 3

    def build(self, engine: Engine) -> World:
        world = engine.world()
        world.ground()
        self.wall = world.body(engine.box(0.05, 0.5, 2), position=(2, 0.5, 0), type="static")
        self.bunny = world.body(engine.ellipsoid(0.12, 0.1, 0.08), position=(0, 0.6, 0), density=300)
        self.bunny.collider(engine.sphere(0.06), position=(0.12, 0.08, 0), density=300)
        for side in (-1, 1):
            self.bunny.collider(engine.capsule(0.015, 0.05), position=(0.11, 0.18, 0.03 * side), density=300)
        return world

    def attach(self, batch: Batch) -> None:
        self.speed = batch.column("bodies", "velocity", [self.bunny])
        self.place = batch.column("bodies", "position", [self.bunny], when="after_step")
        self.stands = batch.column("bodies", "position", [self.wall])
        self.batch = batch
        self.goal = np.zeros((len(batch), 3))

    def begin(self, batch: Batch, mask: NDArray[np.bool_], seeds: NDArray[np.uint64]) -> None:
        drawn = batch.random(3, mask=mask, seeds=seeds)
        self.goal[mask] = np.stack([1.5 + drawn[:, 0], 0.4 + 0.6 * drawn[:, 1], 3.5 + 1.5 * drawn[:, 2]], axis=1)[mask]  # m: wall, its top, basket
        self.stands.array[mask, 0] = np.stack([self.goal[:, 0], self.goal[:, 1] - 0.5, np.zeros(len(self.goal))], axis=1)[mask]
        batch.write(self.stands, mask=mask)

    def act(self, actions: Array) -> None:
        self.speed.array[:, 0] = 0
        self.speed.array[:, 0, :3] = actions[:, :3] * (4, 3, 1) + (4, 4, 0)  # m/s
        self.speed.array[:, 0, 5] = 5 * actions[:, 3]
        self.batch.write(self.speed)

    def observe(self) -> Array:
        return self.goal.copy()

    def judge(self, actions: Array) -> tuple[Array, NDArray[np.bool_]]:
        place = self.place.array[:, 0]
        away = np.hypot(place[:, 0] - self.goal[:, 2], place[:, 2])
        return 1 - away - (place[:, 0] < self.goal[:, 0]), np.ones(len(place), bool)


TASKS: dict[str, type[Task]] = {task.__name__: task for task in (CartPole, Ant, Humanoid, Quadruped, Stack, Throw)}
