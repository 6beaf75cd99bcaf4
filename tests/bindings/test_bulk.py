"""Ten thousand bodies in a call: right, in place, and much faster than one by one."""
import array
import time
import unittest

import carom
import numpy as np

N = 10000


class Bulk(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.engine = carom.Engine()
        cls.world = cls.engine.world(body_capacity=N)
        rng = np.random.default_rng(1)
        cls.at = rng.uniform(-100, 100, (N, 3))
        cls.handles = cls.world.create_bodies(cls.at, mass=2.0)
        cls.world.write("velocity", rng.uniform(-1, 1, (N, 6)))

    @classmethod
    def tearDownClass(cls):
        cls.engine.close()

    def test_same_as_one_by_one(self):
        positions, orientations, velocities = self.world.positions(), self.world.orientations(), self.world.velocities()
        self.assertEqual((positions.shape, orientations.shape, velocities.shape), ((N, 3), (N, 4), (N, 6)))
        np.testing.assert_array_equal(self.world.body_handles(), self.handles)
        for i in range(0, N, 997):
            body = carom.Body(self.world, int(self.handles[i]))
            self.assertEqual(tuple(positions[i]), body.position)
            self.assertEqual(tuple(orientations[i]), body.orientation)
            self.assertEqual(tuple(velocities[i, :3]), body.linear_velocity)
            self.assertEqual(tuple(velocities[i, 3:]), body.angular_velocity)

    def test_out(self):
        out = np.full((N, 3), np.nan)
        self.assertIs(self.world.positions(out=out), out)
        np.testing.assert_array_equal(out, self.at)
        whole = np.zeros((N, 8), np.float32)  # a column of a larger array, in float
        self.assertTrue(np.shares_memory(self.world.read("position", out=whole[:, 2:5]), whole))
        np.testing.assert_array_equal(whole[:, 2:5], self.at.astype(np.float32))
        self.assertFalse(whole[:, :2].any() or whole[:, 5:].any())
        packed = array.array("f", bytes(4 * 3 * N))
        self.world.read("position", out=packed)
        np.testing.assert_array_equal(np.frombuffer(packed, np.float32).reshape(N, 3), whole[:, 2:5])

    def test_some_bodies_in_some_order(self):
        chosen = self.handles[[5, 3, 9999]]
        np.testing.assert_array_equal(self.world.read("position", chosen), self.at[[5, 3, 9999]])
        bodies = [carom.Body(self.world, int(h)) for h in chosen]
        np.testing.assert_array_equal(self.world.read("position", bodies), self.at[[5, 3, 9999]])
        np.testing.assert_array_equal(self.world.read("mass", bodies), [[2.0]] * 3)

    def test_write(self):
        chosen = self.handles[10:13]
        before = self.world.read("position", chosen)
        self.world.write("position", before + 1, chosen)
        np.testing.assert_array_equal(self.world.read("position", chosen), before + 1)
        self.world.write("position", before.tolist(), chosen)
        np.testing.assert_array_equal(self.world.read("position", chosen), before)
        with self.assertRaises(ValueError):
            self.world.write("position", np.full((3, 3), np.nan), chosen)
        np.testing.assert_array_equal(self.world.read("position", chosen), before)

    def test_refused(self):
        for out, why in [(np.zeros((N, 4)), "shape"), (np.zeros((N - 1, 3)), "rows"), (np.zeros((N, 3), np.int64), "float64"), (np.zeros((N, 3), ">f8"), "float64"),
                         (np.zeros((3, N)).T, "one piece"), (np.zeros((N, 3))[::-1], "one after the other"), (bytes(24 * N), "packed|read only")]:
            with self.assertRaisesRegex(ValueError, why):
                self.world.read("position", out=out)
        locked = np.zeros((N, 3))
        locked.flags.writeable = False
        with self.assertRaisesRegex(ValueError, "read only"):
            self.world.read("position", out=locked)
        with self.assertRaisesRegex(ValueError, "not one of .*position"):
            self.world.read("colour")

    def test_none_and_one(self):
        with self.engine.world() as world:
            self.assertEqual(world.positions().shape, (0, 3))
            self.assertEqual(len(world.read("position", out=array.array("d"))), 0)
            world.write("position", [])
            body = world.body(mass=1)
            world.write("position", np.array([[1, 2, 3]]), (b for b in [body]))  # integers, a generator
            self.assertEqual(world.read("position", [body], out=np.zeros((4, 3))[2:3]).tolist(), [[1, 2, 3]])
            with self.assertRaisesRegex(ValueError, "one piece"):
                world.read("position", [body], out=np.zeros((1, 6))[:, ::2])

    def test_fast(self):
        """One call against N getters. A getter is at least a Python call and a C call, some 500 ns; a row of the bulk call is
        24 bytes copied, some 10 ns: 20 is what a busy machine leaves of that, and 1 would be a loop in disguise."""
        bodies = [carom.Body(self.world, int(h)) for h in self.handles]
        out = np.empty((N, 3))
        began = time.perf_counter()
        one_by_one = [body.position for body in bodies]
        slow = time.perf_counter() - began
        fast = float("inf")
        for _ in range(5):
            began = time.perf_counter()
            self.world.positions(out=out)
            fast = min(fast, time.perf_counter() - began)
        self.assertEqual(one_by_one[77], tuple(out[77]))
        print(f"\n{N} positions: getters {1e3 * slow:.2f} ms, one call {1e3 * fast:.3f} ms, {slow / fast:.0f} times")
        self.assertGreater(slow / fast, 20)

    def test_contacts_as_an_array(self):
        with self.engine.world() as world:
            world.ground()
            world.create_bodies([(2 * i, 0.5, 0) for i in range(10)], self.engine.sphere(0.5))
            world.step()
            points = world.contact_array()
            self.assertEqual(len(points), 10)
            np.testing.assert_allclose(sorted(points["point"][:, 0]), np.arange(0, 20, 2), atol=1e-9)
            self.assertEqual(points["separation"][0], world.contacts()[0].separation)


class Joints(unittest.TestCase):
    """Wheels on axles along x, and a ball, in a world of their own."""

    def setUp(self):
        self.engine = carom.Engine()
        self.world = self.engine.world(gravity=(0, 0, 0))
        self.wheels = [self.world.body(position=(3 * i, 0, 0), mass=2, inertia=(0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5)) for i in range(4)]
        self.hinges = [self.world.joint("hinge", None, w, position=w.position, axis=(1, 0, 0)) for w in self.wheels]

    def tearDown(self):
        self.engine.close()

    def test_targets_are_written_and_efforts_read(self):
        world, torques = self.world, np.array([1.0, -2.0, 0.5, 0.0])
        np.testing.assert_array_equal(world.joint_handles(), [hinge.handle for hinge in self.hinges])
        world.write_joints("target_effort", torques)
        carom.run(world, seconds=0.5)
        efforts, speeds = world.read_joints("effort"), world.read_joints("velocity", dtype="float32")
        self.assertEqual((efforts.shape, speeds.shape, speeds.dtype), ((4, 1), (4, 1), np.float32))
        np.testing.assert_allclose(efforts[:, 0], torques, atol=1e-12)
        np.testing.assert_allclose(speeds[:, 0], torques / 0.5 * 30 / 60, atol=1e-6)
        np.testing.assert_array_equal(world.read_joints("speeds")[:, 0], world.read_joints("velocity")[:, 0])
        self.assertEqual(world.read_joints("position", [self.hinges[1]])[0, 0], self.hinges[1].state.coordinate["twist"])

    def test_rows_of_many_numbers(self):
        world, chosen = self.world, self.hinges[1:3]
        world.write_joints("spring", [(1, 0.25, 2, 0.5, 100), (1, -0.25, 3, 1, 200)], chosen)
        self.assertEqual((chosen[1].spring("twist").target, chosen[1].spring("twist").frequency), (-0.25, 3))
        self.assertFalse(self.hinges[0].spring("twist").enabled)
        wide = np.zeros((2, 8))
        wide[:, 2:5] = (1, -0.5, 0.5)  # columns of a larger array
        world.write_joints("limit", wide[:, 2:5], [hinge.handle for hinge in chosen])
        self.assertEqual((chosen[0].limit("twist").lower, chosen[0].limit("twist").upper), (-0.5, 0.5))
        out = np.empty((4, 3), np.float32)
        self.assertIs(world.read_joints("limit", out=out), out)
        np.testing.assert_array_equal(out[1:3], [(1, -0.5, 0.5)] * 2)

    def test_positions_and_velocities_move_bodies(self):
        world, turns = self.world, np.array([7.0, -0.5, 0.25, 0.0])
        hand = world.body(position=(2, 1, 0), mass=1)
        wrist = world.joint("hinge", self.wheels[0], hand, position=(1, 1, 0), axis=(0, 0, 1), accelerations=True)
        world.write_joints("position", turns, self.hinges)
        world.write_joints("velocity", [1, 2, 3, 4], self.hinges)
        np.testing.assert_allclose(world.read_joints("position", self.hinges)[:, 0], turns, atol=1e-14)
        np.testing.assert_allclose(world.read_joints("velocity", self.hinges)[:, 0], [1, 2, 3, 4], atol=1e-14)
        np.testing.assert_allclose(hand.position, (2, np.cos(7), np.sin(7)), atol=1e-14)
        world.step(1 / 60)
        self.assertEqual(world.read_joints("acceleration", [wrist]).shape, (1, 1))
        with self.assertRaisesRegex(carom.CaromError, "does not measure"):
            world.read_joints("acceleration", self.hinges)

    def test_what_is_wrong_is_said(self):
        ball = self.world.joint("ball", None, self.world.body(position=(0, 9, 0)), position=(0, 9, 0))
        with self.assertRaisesRegex(carom.CaromError, "joint 4 is a ball and has no target"):
            self.world.write_joints("target", [1] * 5)
        with self.assertRaisesRegex(carom.CaromError, "joint 0 is a hinge"):
            self.world.read_joints("orientation_target", self.hinges)
        self.world.write_joints("orientation_target", [(0, 0.6, 0, 0.8)], [ball])
        with self.assertRaisesRegex(ValueError, "'velocity_' is not one of"):
            self.world.read_joints("velocity_")
        with self.assertRaisesRegex(ValueError, "takes 4 rows"):
            self.world.write_joints("target", [1, 2], self.hinges)
        with self.assertRaisesRegex(carom.CaromError, "a joint of joints .* is a handle of a body"):
            self.world.read_joints("force", self.wheels)


if __name__ == "__main__":
    unittest.main()
