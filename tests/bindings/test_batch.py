"""carom.Batch: arrays that the library reads and writes in place, whatever their type and stride; what is refused; the page's program.

Needs numpy, and is skipped without it. Bits beside worlds alone: tests/abi/test_batch.cpp.
"""
import re
import subprocess
import sys
import unittest
from pathlib import Path

SKIPPED = 77  # what CTest takes for skipped
try:
    import numpy as np
except ImportError as why:
    print(f"skipped: {why} (Debian: python3-numpy)")
    sys.exit(SKIPPED)

import carom
from carom.errors import CaromError, Closed, NotFinite, OutOfRange, Unsupported

ROOT = Path(__file__).resolve().parents[2]
DT = 1 / 64


class Exporter:
    """An array of somebody else's, known by DLPack alone."""

    def __init__(self, array):
        self.array = array

    def __dlpack__(self, **about):
        return self.array.__dlpack__(**about)

    def __dlpack_device__(self):
        return self.array.__dlpack_device__()


class Case(unittest.TestCase):
    def setUp(self):
        self.engine = carom.Engine(threads=2)
        self.addCleanup(self.engine.close)
        self.world = self.engine.world()
        self.world.ground()
        self.ball = self.world.body(self.engine.sphere(0.1), position=(0, 1, 0))
        self.box = self.world.body(self.engine.box(0.1, 0.1, 0.1), position=(1, 0.1, 0))
        self.hinge = self.world.joint("hinge", None, self.box, position=(1, 0.5, 0), axis=(0, 0, 1))


class Arrays(Case):
    def test_they_are_the_memory_that_is_read_and_written(self):
        batch = carom.Batch(self.world, 5)
        speed = batch.column("bodies", "linear_velocity", [self.ball, self.box])
        place = batch.column("bodies", "position", [self.ball], when="after_step")
        self.assertEqual((speed.array.shape, place.array.shape, len(batch)), ((5, 2, 3), (5, 1, 3), 5))
        speed.array[:, 0, 0] = np.arange(5)
        batch.write(speed)
        batch.step(DT, 8)
        self.assertLess(np.abs(place.array[:, 0, 0] - np.arange(5) / 8).max(), 1e-12)
        twin = self.world.fork()
        twin.bodies[1].linear_velocity = (3, 0, 0)
        for _ in range(8):
            twin.step(DT)
        self.assertTrue(np.array_equal(twin.read("position")[1], place.array[3, 0]))
        self.assertEqual(int(batch.hashes()[3]), twin.hash)

    def test_of_the_hosts_own_at_any_stride_and_in_floats(self):
        batch = carom.Batch(self.world, 4)
        doubles, wide = np.full((4, 1, 3), 7.0), np.full((4, 5, 3), 7.0, np.float32)
        for out in (doubles, wide[:, 2:3], Exporter(np.zeros((4, 1, 3)))):
            batch.column("bodies", "position", [self.ball], when="after_step", out=out)
        lone = batch.column("bodies", "position", [self.ball], when="after_step", dtype="float32")
        batch.step(DT)
        self.assertTrue((doubles[:, 0, 1] < 1).all() and np.array_equal(doubles.astype(np.float32), lone.array))
        self.assertTrue(np.array_equal(wide[:, 2], lone.array[:, 0]) and (wide[:, [0, 1, 3, 4]] == 7).all())
        self.assertTrue(np.shares_memory(np.from_dlpack(lone), lone.array))

    def test_joints_by_position_and_effort(self):
        batch = carom.Batch(self.world, 3)
        place = batch.column("joints", "position", [self.hinge], when="after_step")
        effort = batch.column("joints", "target_effort", [self.hinge], when="before_step")
        place.array[:, 0, 0] = (0, 0.4, -0.4)
        batch.write(place)
        self.assertLess(np.abs(place.array[:, 0, 0] - (0, 0.4, -0.4)).max(), 1e-12)
        effort.array[0, 0, 0] = 5
        batch.step(DT, 4)
        self.assertTrue(place.array[0, 0, 0] > 0 and place.array[1, 0, 0] < 0.4 and place.array[2, 0, 0] > -0.4)
        self.assertAlmostEqual(place.array[1, 0, 0], -place.array[2, 0, 0], 6)

    def test_a_world_of_another_structure(self):
        batch = carom.Batch(self.world, 2)
        other = self.engine.world(gravity=(0, 0, -1))
        stone = other.body(self.engine.sphere(0.2), position=(0, 0, 5))
        self.assertEqual(batch.add_worlds(other, 3), range(2, 5))
        place = batch.column("bodies", "position", [stone], when="after_step", world=3)
        gravity = batch.column("gravity", world=4)
        batch.read(gravity)
        self.assertEqual((place.array.shape, gravity.array.tolist()), ((3, 1, 3), [[[0.0, 0.0, -1.0]]] * 3))
        batch.step(DT, 64, mask=np.array([True, True, True, False, True]))
        self.assertLess(abs(place.array[0, 0, 2] - 4.5), 1e-9)
        self.assertEqual(place.array[1].tolist(), [[0, 0, 0]])

    def test_starts(self):
        batch = carom.Batch(self.world, 3)
        begin = batch.hashes()
        batch.step(DT, 10)
        start = batch.add_start(batch.save(1))
        later = batch.hashes()
        batch.step(DT, 10)
        batch.reset(np.array([True, False, True]), starts=[0, 0, start])
        self.assertEqual([int(h) for h in batch.hashes()[[0, 2]]], [int(begin[0]), int(later[2])])
        self.world.restore(batch.save(2))
        self.assertEqual(self.world.hash, int(later[2]))


class Random(Case):
    def test_numbers_follow_from_seed_world_and_draw_alone(self):
        many, part = carom.Batch(self.world, 6, seed=9), carom.Batch(self.world, 2, seed=9, first=3)
        first, second = many.random(4), many.random(3, "normal")
        self.assertTrue(np.array_equal(part.random(4), first[3:5]) and np.array_equal(part.random(2, "normal"), second[3:5, :2]))
        self.assertTrue(((first >= 0) & (first < 1)).all() and len(np.unique(first)) == 24)
        mask = np.array([True, False, True, True, True, True])
        third, twin = many.random(4, mask=mask), carom.Batch(self.world, 6, seed=9)
        for _ in range(3):
            rows = twin.random(4)
        self.assertEqual(third[1].tolist(), [0] * 4)
        self.assertTrue(np.array_equal(third[mask], rows[mask]))
        self.assertTrue(np.array_equal(many.random(4, mask=~mask)[1], rows[1]))  # it has drawn one row less than the others
        seeds = np.array([5, 5, 6, 7, 8, 9])
        many.draws[:] = 0
        rows = many.random(4, seeds=seeds)
        self.assertTrue(np.array_equal(rows[0], rows[1]) and not np.array_equal(rows[1], rows[2]))


class Drives(unittest.TestCase):
    """The drive of a hinge's or slider's own axis: a servo. Columns drive_target, drive_velocity, drive_effort, drive_max_force, drive_gains."""

    def setUp(self):
        self.engine = carom.Engine(threads=2)
        self.addCleanup(self.engine.close)

    def arm(self, drive="position", length=0.4):
        """A hinge that a drive holds up, and on it a slider that another moves."""
        world = self.engine.world(gravity=(0, -9.81, 0))
        upper = world.body(self.engine.box(length / 2, 0.03, 0.03), position=(length / 2, 0, 0))
        lower = world.body(self.engine.box(length / 4, 0.02, 0.02), position=(1.25 * length, 0, 0))
        hinge = world.joint("hinge", None, upper, position=(0, 0, 0), axis=(0, 0, 1))
        slider = world.joint("slider", upper, lower, position=(length, 0, 0), axis=(1, 0, 0))
        for joint in (hinge, slider):
            self.tell(joint, drive)
        return world, [hinge, slider]

    def tell(self, joint, drive="position", **other):
        about = dict(drive=drive, drive_gains="force", drive_stiffness=80, drive_damping=6, max_force=50)
        if drive != "position":
            about.update(speed=0.5, effort=7)
        joint.axis("turn_x" if joint.desc.kind == "hinge" else "x", **{**about, **other})

    # of each field, numbers for each joint of three worlds
    VALUES = {"drive_target": ([[0.3], [0.05]], [[-0.4], [0]], [[0], [-0.02]]),
              "drive_velocity": ([[1], [0.2]], [[-2], [0]], [[0], [-0.1]]),
              "drive_effort": ([[9], [3]], [[-4], [0]], [[0], [-2]]),
              "drive_max_force": ([[3], [1]], [[20], [0]], [[0], [9]]),
              "drive_gains": ([[30, 2], [200, 5]], [[0, 9], [90, 0]], [[500, 1], [0, 0]])}
    KINDS = {"drive_target": ["position"], "drive_velocity": ["position", "velocity"], "drive_effort": ["effort"],
             "drive_max_force": ["position", "velocity", "effort"], "drive_gains": ["position"]}
    WORDS = {"drive_target": ["target"], "drive_velocity": ["speed"], "drive_effort": ["effort"], "drive_max_force": ["max_force"],
             "drive_gains": ["drive_stiffness", "drive_damping"]}

    def test_each_does_what_its_axis_is_told(self):
        """To the bit, beside worlds alone in which carom_joint_set_axis() said it; every value matters, and is read back."""
        for field, values in self.VALUES.items():
            for drive in self.KINDS[field]:
                with self.subTest(field=field, drive=drive):
                    world, joints = self.arm(drive)
                    batch = carom.Batch(world, 4)
                    column, seen = batch.column("joints", field, joints), batch.column("joints", field, joints, when="after_step")
                    batch.read(column, seen)
                    begin = column.array.copy()
                    column.array[:3] = values
                    batch.write(column, mask=np.array([True, True, True, False]))
                    np.testing.assert_array_equal(seen.array[:3], values)
                    np.testing.assert_array_equal(seen.array[3], begin[3])
                    batch.step(DT, 20)
                    hashes = batch.hashes()
                    for k in range(4):
                        twin = world.fork()
                        for joint, row in zip(twin.joints, column.array[k]):
                            self.tell(joint, drive, **dict(zip(self.WORDS[field], map(float, row))))
                        for _ in range(20):
                            twin.step(DT)
                        self.assertEqual(twin.hash, int(hashes[k]), k)
                    self.assertEqual(len(set(hashes.tolist())), 4)

    def test_before_each_step_and_in_floats(self):
        world, joints = self.arm()
        batch = carom.Batch(world, 3)
        target = batch.column("joints", "drive_target", joints, when="before_step", dtype="float32")
        gains = batch.column("joints", "drive_gains", joints[:1], when="before_step")
        self.assertEqual((target.array.shape, gains.array.shape), ((3, 2, 1), (3, 1, 2)))
        place = batch.column("joints", "position", joints, when="after_step")
        gains.array[:] = (400, 20)
        twin = world.fork()
        for k in range(20):
            target.array[:, 0, 0] = 0.2 * np.sin(0.1 * k) * np.array([1, -1, 0])
            self.tell(twin.joints[0], drive_stiffness=400, drive_damping=20, target=float(target.array[1, 0, 0]))
            batch.step(DT)
            twin.step(DT)
        np.testing.assert_array_equal(place.array[1, :, 0], twin.read_joints("position")[:, 0])
        self.assertGreater(place.array[0, 0, 0], place.array[2, 0, 0])
        self.assertGreater(place.array[2, 0, 0], place.array[1, 0, 0])

    def test_where_they_lead(self):
        """In closed form: a stiff position drive sags by load / stiffness; a velocity drive goes at its speed; an effort bears its weight."""
        world, joints = self.arm()
        weight = 9.81 * (joints[0].desc.body_b.mass * 0.2 + joints[1].desc.body_b.mass * 0.5)  # N m about the hinge
        batch = carom.Batch(world, 3)
        gains, most = batch.column("joints", "drive_gains", joints), batch.column("joints", "drive_max_force", joints)
        place = batch.column("joints", "position", joints, when="after_step")
        gains.array[:, 0] = [(2000, 60), (500, 60), (500, 60)]
        gains.array[:, 1] = (4000, 200)
        most.array[:, 0, 0], most.array[:, 1, 0] = (1e3, 1e3, weight / 4), 1e3
        batch.write(gains, most)
        batch.step(1 / 240, 960)
        for k, stiffness in ((0, 2000), (1, 500)):
            self.assertAlmostEqual(place.array[k, 0, 0], -weight / stiffness, delta=0.02 * weight / stiffness)  # it turns, and its slider gives way
        self.assertLess(place.array[2, 0, 0], -10 * weight / 500)  # too weak: it falls
        world, joints = self.arm("velocity")
        batch = carom.Batch(world, 2)
        speed, seen = batch.column("joints", "drive_velocity", joints, when="before_step"), batch.column("joints", "velocity", joints, when="after_step")
        speed.array[:, 0, 0] = (0.7, -0.2)
        batch.step(1 / 240, 48)
        np.testing.assert_allclose(seen.array[:, 0, 0], (0.7, -0.2), atol=2e-2)

    def test_two_structures_and_a_reset(self):
        one, of_one = self.arm()
        other, of_other = self.arm("effort", 0.7)
        extra = other.body(self.engine.sphere(0.1), position=(0, 5, 0))
        batch = carom.Batch(one, 2)
        batch.add_worlds(other, 3)
        target = batch.column("joints", "drive_target", of_one)
        effort = batch.column("joints", "drive_effort", of_other[:1], world=2)
        self.assertEqual((target.array.shape, effort.array.shape), ((2, 2, 1), (3, 1, 1)))
        begin = batch.hashes()
        target.array[:, 0, 0], effort.array[:, 0, 0] = (0.1, 0.2), (5, 10, 10)
        batch.write(target, effort)
        batch.step(DT, 30)
        hashes = batch.hashes()
        twin = other.fork()
        self.tell(twin.joints[0], "effort", effort=10)
        for _ in range(30):
            twin.step(DT)
        self.assertEqual((int(hashes[3]), int(hashes[4])), (twin.hash, twin.hash))
        self.assertEqual(len(set(hashes.tolist())), 4)
        batch.reset()
        np.testing.assert_array_equal(batch.hashes(), begin)  # drives, too
        with self.assertRaises(CaromError):  # joints of the other structure
            batch.column("joints", "drive_target", of_other)
        self.assertIsNotNone(extra)

    def test_refused(self):
        world, joints = self.arm()
        ball = world.joint("ball", None, joints[0].desc.body_b, position=(0, 0, 0))
        bare = world.joint("distance", joints[0].desc.body_b, joints[1].desc.body_b, length=0.3)
        batch = carom.Batch(world, 3)
        for field, width in (("drive_target", 1), ("drive_gains", 2)):
            for shape in ((3, 2, 3 - width), (2, 2, width), (3, 1, width), (3, 2)):
                with self.assertRaisesRegex(ValueError, r"shape \(3, 2, "):
                    batch.column("joints", field, joints, out=np.zeros(shape))
        for field in self.VALUES:
            for wrong in (ball, bare):
                with self.assertRaises(Unsupported):
                    batch.read(batch.column("joints", field, [joints[0], wrong]))
        before = batch.hashes()
        for field, wrong in (("drive_target", 2e9), ("drive_velocity", 2e6), ("drive_effort", 2e30), ("drive_max_force", -1.0), ("drive_gains", -1.0),
                             *((field, np.nan) for field in self.VALUES)):
            column = batch.column("joints", field, joints)
            batch.read(column)
            column.array[2, 1, -1] = wrong
            column.array[0, 0, 0] += 0.01
            with self.subTest(field=field, wrong=wrong), self.assertRaisesRegex((OutOfRange, NotFinite), "world 2, column"):
                batch.write(column)
            np.testing.assert_array_equal(batch.hashes(), before)


class Refused(Case):
    def test_wrong_shapes_types_and_words(self):
        batch = carom.Batch(self.world, 3)
        good = np.zeros((3, 1, 3))
        read_only = good.copy()
        read_only.flags.writeable = False
        for wrong, out in ((ValueError, np.zeros((3, 3))), (ValueError, np.zeros((3, 1, 3), np.int64)), (ValueError, np.zeros((2, 1, 3))),
                           (ValueError, read_only), (ValueError, np.zeros((1, 1, 3))[[0, 0, 0]][:, :, ::-1]), (TypeError, [[0, 0, 0]])):
            with self.assertRaises(wrong):
                batch.column("bodies", "position", [self.ball], out=out)
        for arguments in (("bones", "position", [self.ball]), ("bodies", "place", [self.ball]), ("bodies", None, [self.ball]), ("gravity", "position"),
                          ("bodies", "position")):
            with self.assertRaises(ValueError):
                batch.column(*arguments)
        with self.assertRaises(ValueError):
            batch.column("bodies", "position", [self.ball], dtype="int32")
        with self.assertRaises(CaromError):
            batch.column("joints", "position", [self.ball])
        with self.assertRaises(Unsupported):
            batch.column("joints", "position", [self.hinge], when="before_step")
        with self.assertRaises(OutOfRange):
            batch.column("bodies", "position", [self.ball], world=3)
        with self.assertRaises(ValueError):
            batch.step(DT, mask=np.ones(2, bool))
        with self.assertRaises(ValueError):
            batch.reset(starts=[0, -1, 0])
        with self.assertRaises(ValueError):
            carom.Batch(self.world, 0)
        other = carom.Batch(self.world, 1)
        with self.assertRaises(TypeError):
            batch.read(other.column("time"))

    def test_a_number_that_is_none_stops_all_and_says_where(self):
        batch = carom.Batch(self.world, 3)
        force = batch.column("bodies", "force", [self.ball], when="before_step")
        before = batch.hashes()
        force.array[1, 0, 4] = np.nan
        with self.assertRaisesRegex(NotFinite, "world 1, column 0: force of body 0"):
            batch.step(DT)
        self.assertTrue(np.array_equal(batch.hashes(), before))

    def test_a_fault_is_said(self):
        batch = carom.Batch(self.world, 3)
        speed = batch.column("bodies", "linear_velocity", [self.ball])
        speed.array[2] = 1e12
        batch.write(speed, mask=np.array([False, False, True]))
        self.assertEqual((batch.step(DT), batch.stopped().tolist()), (1, [0, 0, 1]))
        [fault] = batch.faults(2)
        self.assertEqual((fault.kind, fault.body), ("body_state", self.ball.handle))
        self.assertEqual((batch.info.stopped, batch.info.worlds, batch.faults(0)), (1, 3, []))

    def test_closed(self):
        batch = carom.Batch(self.world, 3)
        place = batch.column("bodies", "position", [self.ball])
        self.world.close()
        batch.read(place)  # the batch has what it needs
        batch.close()
        for call in (batch.hashes, lambda: batch.step(DT), lambda: batch.read(place)):
            with self.assertRaises(Closed):
                call()
        again = carom.Batch(self.engine.world(), 1)
        self.engine.close()
        self.assertTrue(again.closed)


class Page(unittest.TestCase):
    def test_the_program(self):
        text = (ROOT / "src/site/docs/topics/batches.md").read_text(encoding="utf-8")
        program = re.findall(r"```python\n(.*?)```", text, re.S)[0]
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, "throws of 5.1 to 6.7 m/s, at 42 to 70 degrees, end within 0.04 m of the mark\n")


if __name__ == "__main__":
    unittest.main()
