"""What mypy must find right, and of which type: read by tests/bindings/test_typed.py, never run."""
import carom
import numpy as np
from carom.query import Hits, RayHits
from carom.records import ContactRecord, IslandFlags, JointAxisRecord, JointLimitRecord, JointStateRecord, WorldHitRecord
from numpy.typing import NDArray
from typing_extensions import assert_type

with carom.Engine(threads=2) as engine, engine.world(substeps=8, solver="direct") as world:
    assert_type(engine, carom.Engine)
    assert_type(world, carom.World)
    ground = world.ground()
    ball = world.body(engine.sphere(0.5), position=(0, 3, 0), type="dynamic")
    assert_type(ball, carom.Body)
    assert_type(ball.position, tuple[float, ...])
    ball.position = [0, 4, 0]
    ball.position = np.zeros(3)
    ball.locks = {"linear_z", "angular_x"}
    ball.attributes["drag"] = (0.1, 0.02)
    assert_type(ball.mass, float)
    ball.mass, ball.damping, ball.type, ball.user = 2, (0.1, 0), "kinematic", 7
    ball.pose = (0, 4, 0), (0, 0, 0, 1)
    ball.set_mass(2, center=np.zeros(3))
    for piece in ball.colliders:
        assert_type(piece.material, "carom.Material | None")
        piece.density, piece.material, piece.pose = 500, None, piece.pose
    assert_type(ball.desc.type, str)
    assert_type(ball.collider(engine.box(1, 1, 1)), carom.Collider)

    hinge = world.joint("hinge", ball, position=(0, 4, 0), axis=(0, 0, 1), break_force=1e3)
    assert_type(hinge, carom.Joint)
    assert_type(hinge.limit("twist", lower=-1, upper=1), JointLimitRecord)
    assert_type(hinge.state, JointStateRecord)
    assert_type(hinge.state.force, tuple[float, float, float])
    assert_type(world.joint("six_axis", ball).axis("x", mode="limited", lower=0, upper=1), JointAxisRecord)
    assert_type(hinge.desc.body_a, "carom.Body | None")

    carom.run(world, seconds=1)
    assert_type(world.read("position"), NDArray[np.float64])
    assert_type(world.read("pose", dtype="float32"), NDArray[np.float32])
    rows: NDArray[np.float32] = np.empty((2, 3), np.float32)
    assert_type(world.positions(out=rows), NDArray[np.float32])
    assert_type(world.body_handles(), NDArray[np.uint64])
    assert_type(world.create_bodies(np.zeros((4, 3)), engine.sphere(1), density=500), NDArray[np.uint64])
    assert_type(world.read_joints("limit", [hinge]), NDArray[np.float64])
    assert_type(world.read_joints("position", out=rows), NDArray[np.float32])
    world.write_joints("target_effort", [1.5], [hinge])
    tree = world.tree(ball)
    assert_type(tree, carom.JointTree)
    assert_type(tree.forces(accelerations=np.zeros(6), speeds=(0,) * 6), NDArray[np.float64])
    assert_type(tree.mass, NDArray[np.float64])
    assert_type(tree.coordinates[0].joint, "carom.Joint | None")
    assert_type(world.contacts(), list[ContactRecord])
    assert_type(world.report.max_penetration, float)
    assert_type(world.islands()[0].flags, IslandFlags)
    assert_type(IslandFlags.BOUND in world.islands()[0].flags, bool)
    assert_type(world.ray((0, 9, 0), (0, -1, 0), mask=1), "WorldHitRecord | None")
    assert_type(world.rays(np.zeros((4, 3)), (0, -1, 0)), RayHits)
    assert_type(world.casts(engine.sphere(1), np.zeros((4, 3)), (0, -1, 0)), Hits)
    assert_type(world.rays(np.zeros((4, 3)), (0, -1, 0)).times, NDArray[np.float64])
    assert_type(engine.distance(engine.sphere(1), engine.sphere(2), position_b=(4, 0, 0)).separation, float)

    walker = carom.Character(world, engine.capsule(0.3, 0.6), position=(0, 1, 0), step_up=0.4, flies=False)
    walker.move(np.zeros(3), jump=2)
    assert_type(walker.set_shape(engine.sphere(0.3)), bool)
    assert_type(walker.ground_body, "carom.Body | None")
    assert_type(walker.contacts[0].body, carom.Body)
    assert_type(walker.settings["step_up"], "float | None")
    car = carom.Vehicle(ball, [{"position": (1, 0, 0), "radius": 0.3}, dict(drive=1)], torque_curve=[(0, 100), (500, 80)])
    car.drive(throttle=1, gear=-1)
    assert_type(car.wheels[0].state.body, "carom.Body | None")
    assert_type(car.save(), bytes)

    with world.fork() as copy:
        assert_type(copy, carom.World)
        assert_type(copy.counterpart(ball), carom.Body)
    world.force_field("vortex", strength=2).update(kind="radial", strength=3)
    box = engine.support_plugin(lambda p, d: d, "my.box", params=[("x", "m", 1e-6, 1e3)], form="box", args=(0, 0, 0))
    assert_type(box(0.5), carom.Shape)


def falls(trial: carom.Trial, speed: float) -> float:
    space = trial.world(gravity=(0, -1, 0))
    stone = space.body(trial.engine.sphere(0.1), linear_velocity=(0, speed, 0))
    assert_type(trial.run(space, 0.5), float)
    assert_type(trial.until(space, lambda w: trial.touches(w, stone), most=3), float)
    return stone.position[1]


answer = carom.measure(falls, {"speed": 1}, slopes=["speed"], widths={"speed": 0.1})
assert_type(answer, carom.Measured)
assert_type(answer.slopes["speed"], carom.Slope)
assert_type(answer.half_cost, float)
assert_type(answer.lyapunov_time, "float | None")
