"""Questions: two shapes without a world against closed forms; thousands in a call, the same as one by one."""
import math
import unittest

import carom
import numpy as np

INFINITE = math.inf


class Pairs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.engine = carom.Engine()
        cls.ball, cls.box = cls.engine.sphere(0.5), cls.engine.box(1, 0.1, 0.1)

    @classmethod
    def tearDownClass(cls):
        cls.engine.close()

    def assertBrackets(self, answer, time, slack):
        self.assertLessEqual(answer.lower, time + slack)
        self.assertGreaterEqual(answer.upper, time - slack)
        self.assertAlmostEqual(answer.time, time, delta=slack)

    def test_two_balls_meet(self):
        hit = self.engine.time_of_impact(self.ball, self.ball, 10, {"position": (-4, 0, 0), "linear_velocity": (2, 0, 0)},
                                         {"position": (4, 0, 0), "linear_velocity": (-1, 0, 0)})
        self.assertEqual(hit.outcome, "hit")
        self.assertBrackets(hit, 7 / 3, 1e-5)
        self.assertAlmostEqual(hit.normal[0], 1, 9)
        self.assertAlmostEqual(hit.point_b[0], 4 - 7 / 3 - 0.5, 4)

    def test_many_distances_are_those_one_by_one(self):
        draw = np.random.default_rng(1)
        n = 500
        shapes = [self.ball, self.box, self.engine.cylinder(0.3, 0.5)]
        a = [shapes[i] for i in draw.integers(0, 3, n)]
        at, turned = draw.uniform(-1.5, 1.5, (n, 3)), draw.normal(size=(n, 4))
        turned /= np.linalg.norm(turned, axis=1)[:, None]
        found = self.engine.distances(a, self.box, position_b=at, orientation_b=turned, tolerance=1e-9)
        self.assertEqual(found.shape, (n,))
        for i in range(n):
            one = self.engine.distance(a[i], self.box, position_b=at[i], orientation_b=turned[i], tolerance=1e-9)
            self.assertEqual((one.separation, one.lower, one.upper), (found["separation"][i], found["lower"][i], found["upper"][i]))
            self.assertEqual(list(one.point_b), list(found["point_b"][i]))
        self.assertEqual(len(self.engine.distances(self.ball, self.box)), 1)
        with self.assertRaisesRegex(carom.CaromError, r"position_b of pair 7\[1\] is nan"):
            at[7, 1] = math.nan
            self.engine.distances(a, self.box, position_b=at)
        with self.assertRaisesRegex(ValueError, "500 shapes each"):
            self.engine.distances(a[:3], self.box, position_b=at)

    def test_a_device_gives_the_same_bits(self):
        try:
            device = carom.Device(self.engine)
        except carom.CaromError as e:
            self.skipTest(str(e))
        with device:
            at = np.random.default_rng(2).uniform(-2, 2, (1000, 3))
            on_host, on_device = (of.distances(self.ball, self.box, position_b=at) for of in (self.engine, device))
            self.assertEqual(on_host.tobytes(), on_device.tobytes())
            self.assertEqual(device.pairs, 1000)
            self.assertLess(device.host_pairs, 500)

    def test_a_turning_box_reaches_a_ball(self):
        """The box's face end, 1 m from the axis, comes round to where the ball's surface is, by pi / 2 less what it is thick."""
        at = (0, 1.3, 0)
        hit = self.engine.time_of_impact(self.box, self.ball, 10, {"angular_velocity": (0, 0, 1)}, {"position": at})
        self.assertEqual(hit.outcome, "hit")
        turned = lambda t: (0, 0, math.sin(t / 2), math.cos(t / 2))  # noqa: E731
        for t, sign in ((hit.lower - 1e-9, 1), (hit.upper + 1e-3, -1)):
            apart = self.engine.distance(self.box, self.ball, position_b=at, orientation_a=turned(t), tolerance=1e-9)
            self.assertGreater(sign * apart.separation, -1e-9)

    def test_rays_casts_and_overlap(self):
        self.assertBrackets(self.engine.ray_cast(self.ball, (-3, 0, 0), (2, 0, 0)), 1.25, 1e-6)
        self.assertEqual(self.engine.ray_cast(self.ball, (-3, 0, 0), (2, 0, 0), max=1).outcome, "miss")
        cast = self.engine.shape_cast(self.ball, self.box, (0, -2, 0), position_a=(0.5, 1.6, 0))
        self.assertBrackets(cast, 0.5, 1e-5)
        self.assertEqual(self.engine.overlap(self.ball, self.box, (0, 0.5, 0)).outcome, "overlapping")
        self.assertEqual(self.engine.overlap(self.ball, self.box, (0, 0.7, 0)).outcome, "apart")
        self.assertEqual(self.engine.overlap(self.ball, self.box, (0, 0.7, 0), target=0.2).outcome, "overlapping")

    def test_wrong_ones(self):
        with self.assertRaises(TypeError):
            self.engine.time_of_impact(self.ball, self.ball, 1, {"speed": 3})
        with self.assertRaises(ValueError):
            self.engine.shape_cast(self.ball, self.ball, (1, 0))
        with self.assertRaises(carom.errors.OutOfRange):
            self.engine.time_of_impact(self.ball, self.ball, -1)


class Crowds(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.engine = carom.Engine()
        cls.world = cls.engine.world()
        cls.world.ground()
        rng = np.random.default_rng(4)
        cls.ball, cls.box = cls.engine.sphere(0.3), cls.engine.box(0.4, 0.2, 0.3)
        for at in rng.uniform((-5, 0.5, -5), (5, 5, 5), (200, 3)):
            cls.world.body(cls.box if at[0] > 0 else cls.ball, position=tuple(at))
        cls.at, cls.way = rng.uniform((-5, 1, -5), (5, 8, 5), (64, 3)), rng.uniform(-8, 8, (64, 3))
        q = rng.normal(size=(64, 4))
        cls.turned = q / np.linalg.norm(q, axis=1)[:, None]

    @classmethod
    def tearDownClass(cls):
        cls.engine.close()

    def check(self, many, i, one):
        if one is None:
            self.assertEqual(many.outcomes[i], carom.raw.CAROM_CAST_MISS)
            self.assertEqual(many.colliders[i], 0)
            return
        self.assertEqual(many.bodies[i], one.body.handle)
        self.assertEqual(many.colliders[i], one.collider.handle)
        self.assertEqual((many.times[i], many.lower[i], many.upper[i]), (one.time, one.lower, one.upper))
        self.assertEqual(many.separations[i], one.separation)
        self.assertEqual((tuple(many.points[i]), tuple(many.normals[i])), (one.point, one.normal))

    def test_casts(self):
        shapes = [self.box if i % 2 else self.ball for i in range(64)]
        many = self.world.casts(shapes, self.at, self.way, self.turned)
        self.assertEqual(many.queries.tolist(), list(range(64)))
        hits = 0
        for i in range(64):
            one = self.world.cast(shapes[i], self.at[i], self.way[i], self.turned[i])
            hits += one is not None
            self.check(many, i, one)
        self.assertGreater(hits, 20)
        any_hit = self.world.casts(shapes, self.at, self.way, self.turned, want="any")
        self.assertEqual((any_hit.outcomes > 0).tolist(), (many.outcomes > 0).tolist())

    def test_one_for_all(self):
        many = self.world.casts(self.ball, self.at, (0, -9, 0))
        for i in (0, 17, 63):
            self.check(many, i, self.world.cast(self.ball, self.at[i], (0, -9, 0)))
        self.assertTrue((many.outcomes > 0).all())  # there is the ground

    def test_nearests(self):
        points, shapes = self.world.nearests(self.at, reach=2), self.world.nearests(self.at, self.box, orientations=self.turned)
        for i in range(64):
            self.check(points, i, self.world.nearest(self.at[i], reach=2))
            self.check(shapes, i, self.world.nearest(self.at[i], self.box, orientation=self.turned[i]))

    def test_all_of_them(self):
        every = self.world.casts_all(self.ball, self.at, self.way)
        first = self.world.casts(self.ball, self.at, self.way)
        for i in range(64):
            own = np.flatnonzero(every.queries == i)
            self.assertEqual(len(own) > 0, bool(first.outcomes[i]))
            if len(own):
                self.assertEqual(every.times[own].tolist(), sorted(every.times[own]))
                self.assertEqual(every.times[own[0]], first.times[i])
        through = self.world.rays_all([(0, 20, 0), (0, 20, 0)], [(0, -1, 0), (0, 1, 0)])
        self.assertTrue((through.queries == 0).all() and len(through.times) >= 1)
        over = self.world.overlaps_all(self.box, self.at)
        for i in (0, 5, 40):
            self.assertEqual(over.bodies[over.queries == i].tolist(),
                             [hit.body.handle for hit in self.world.overlaps(self.box, self.at[i])])
        none = self.world.overlaps_all(self.ball, [(0, 100, 0)])
        self.assertEqual((len(none.times), none.points.shape), (0, (0, 3)))

    def test_wrong_numbers(self):
        with self.assertRaises(ValueError):
            self.world.casts(self.ball, self.at, self.way[:3])
        with self.assertRaises(ValueError):
            self.world.casts([self.ball] * 5, self.at, self.way)


class Seams(unittest.TestCase):
    """Ground of many parts, at the origin and far out: nothing stops at a seam, and nothing falls through one."""

    OUT = (0, 12345, 1e6, 1e8)

    @classmethod
    def setUpClass(cls):
        cls.engine = e = carom.Engine()
        n = 13
        cls.grid = e.mesh([(x, 0, z) for x in range(n) for z in range(n)],
                          [t for i in range(n - 1) for k in range(n - 1)
                           for t in ((i * n + k, i * n + k + 1, i * n + k + n), (i * n + k + n, i * n + k + 1, i * n + k + n + 1))])
        cls.field, cls.chunk = e.height_field([[0.0] * n] * n, spacing=(1, 1)), e.height_field([[0.0] * 5] * 5, spacing=(1, 1))
        cls.tile, cls.wall = e.box(0.5, 0.25, 0.5), e.box(0.5, 5, 20)
        prism = [(0.4 * math.cos(a), y, 0.4 * math.sin(a)) for a in range(6) for y in (-0.5, 0.5)]
        cls.shapes = (e.sphere(0.5), e.box(0.5, 0.5, 0.5), e.capsule(0.3, 0.2), e.cylinder(0.4, 0.5), e.cone(0.4, 0.5),
                      e.ellipsoid(0.3, 0.5, 0.4), e.hull(prism))

    @classmethod
    def tearDownClass(cls):
        cls.engine.close()

    def grounds(self, out):
        def world(*parts):
            w = self.engine.world()
            for shape, x, y, z in parts:
                w.body(shape, position=(out + x, y, out + z), type="static")
            self.wall_body = w.body(self.wall, position=(out + 11.5, 5, out + 6), type="static")
            return w
        yield "mesh", world((self.grid, 0, 0, 0))
        yield "field", world((self.field, 0, 0, 0))
        yield "chunks", world(*((self.chunk, 4 * i, 0, 4 * k) for i in range(3) for k in range(3)))
        yield "tiles", world(*((self.tile, i + 0.5, -0.25, k + 0.5) for i in range(12) for k in range(12)))

    def test_shapes_along_away_and_in(self):
        for out in self.OUT:
            off = 1e-5 + 1e-14 * out  # m, of a time: its places are rounded
            for name, w in self.grounds(out):
                for number, shape in enumerate(self.shapes):
                    for x, z, side in ((2, 6, 0), (2.5, 6.25, 0.5), (3, 5.5, -1), (2.25, 6, 1)):
                        at = (out + x, 0.5, out + z)
                        with self.subTest(out=out, ground=name, shape=number, at=(x, z)):
                            self.assertEqual(w.cast(shape, at, (9, 0, side)).body, self.wall_body)
                            self.assertIsNone(w.cast(shape, at, (0.5, 3, 0)))
                            self.assertLess(w.cast(shape, at, (0.3, -1, 0)).time, off)
                            down = w.cast(shape, (out + x, 3, out + z), (0, -4, 0))
                            self.assertAlmostEqual(4 * down.time, 2.5, delta=off)
                            if name in ("mesh", "field"):  # one collider; of several only the one that is touched is passed over
                                sunk = w.cast(shape, (out + x, 0.499, out + z), (9, 0, 0), ignore_touched=True)
                                self.assertEqual(sunk.body, self.wall_body)

    def test_rays_down_and_from_the_ground(self):
        for out in self.OUT:
            for name, w in self.grounds(out):
                for x, z in ((2, 3), (4, 4), (5, 2.3), (3.7, 8), (1.5, 1.5)):
                    with self.subTest(out=out, ground=name, at=(x, z)):
                        hit = w.ray((out + x, 5, out + z), (0, -1, 0))
                        self.assertAlmostEqual(hit.time, 5, delta=1e-9)
                        self.assertEqual((hit.outcome, hit.normal), ("hit", (0, -1, 0)))
                        self.assertIsNone(w.ray((out + x, 0, out + z), (0.3, 1, 0), 4))
                        self.assertLess(w.ray((out + x, 0, out + z), (0.3, -1, 0)).time, 1e-9 + 1e-14 * out)

    def test_parts_of_a_turned_body(self):
        for out in self.OUT:
            w = self.engine.world()
            body = w.body(position=(out, 0, out), orientation=(0, math.sin(0.2), 0, math.cos(0.2)), type="static")
            for i in range(-3, 3):
                for k in range(-3, 3):
                    body.collider(self.tile, position=(i + 0.5, -0.25, k + 0.5))
            c, s = math.cos(0.4), math.sin(0.4)
            for x, z in ((0, 0), (1, 0.3), (-1.2, 2), (2, -2), (0.5, 1)):
                with self.subTest(out=out, at=(x, z)):
                    hit = w.ray((out + c * x + s * z, 5, out - s * x + c * z), (0, -1, 0))
                    self.assertEqual(hit.outcome, "hit")
                    self.assertAlmostEqual(hit.time, 5, delta=1e-9 + 1e-14 * out)


class OnPieces(unittest.TestCase):
    """A shape that comes down flat on corners of triangles is met by what they are, not by one of their edges."""

    def test_normals_of_what_lands_on_a_grid(self):
        with carom.Engine() as engine:
            fields = (engine.height_field([[0.0] * 7] * 7, spacing=(0.5, 0.5)),
                      engine.mesh([(i / 2, 0, k / 2) for i in range(7) for k in range(7)],
                                  [t for i in range(6) for k in range(6) for a in [7 * i + k]
                                   for t in ((a, a + 1, a + 7), (a + 7, a + 1, a + 8))]))
            for ground in fields:
                world = engine.world()
                world.body(ground, position=(-1.5, 0, -1.5), type="static")
                for shape, low in ((engine.box(0.5, 0.2, 0.5), 0.2), (engine.box(1, 0.3, 0.5), 0.3),
                                   (engine.hull([(x, y, z) for x in (-0.5, 0.5) for y in (-0.1, 0.1) for z in (-1, 1)]), 0.1)):
                    hit = world.cast(shape, (0, 2, 0), (0, -4, 0))
                    self.assertEqual(hit.outcome, "hit")
                    self.assertAlmostEqual(hit.time, (2 - low) / 4, 6)
                    self.assertGreater(abs(hit.normal[1]), 1 - 1e-9)
                    for speed in (2, 9, 13):
                        met = engine.time_of_impact(shape, ground, 1 / 240, {"position": (0, low + 0.004, 0), "linear_velocity": (0, -speed, 0)},
                                                    {"position": (-1.5, 0, -1.5)})
                        self.assertAlmostEqual(met.time, 0.004 / speed, 9)
                        self.assertGreater(abs(met.normal[1]), 1 - 1e-9)


if __name__ == "__main__":
    unittest.main()
