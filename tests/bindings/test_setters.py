"""What C can set, Python can: of each carom_*_set_* there is a property, a method or a mapping, and what it sets is what is read."""
import ctypes
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import carom
from carom import raw


class Setters(unittest.TestCase):
    def setUp(self):
        self.engine = carom.Engine()
        self.world = self.engine.world()
        self.addCleanup(self.engine.close)

    def test_each_call_of_C_has_one(self):
        kinds = {"body": carom.Body, "collider": carom.Collider, "material": carom.Material, "joint": carom.Joint, "world": carom.World,
                 "particles": carom.Particles, "force_field": carom.ForceField, "spring": carom.Spring}
        elsewhere = {"body.attribute": carom.Attributes.__setitem__, "world.dial": carom.dials.Dials.__setitem__,
                     "material.pair": carom.Material.set_against}
        seen = 0
        for name in raw.FUNCTIONS:
            kind, set_, what = name.replace("carom_", "").partition("_set_")
            if not set_ or kind not in kinds:
                continue
            seen += 1
            member = getattr(kinds[kind], what, None)
            self.assertTrue(
                f"{kind}.{what}" in elsewhere or isinstance(member, property) and member.fset or hasattr(kinds[kind], f"set_{what}")
                or kind == "joint" and callable(member), f"{name} has no way from Python")
        self.assertGreater(seen, 30)

    def assertNear(self, found, expected, places=12):
        self.assertEqual(len(found), len(expected))
        for a, b in zip(found, expected):
            self.assertAlmostEqual(a, b, delta=10.0**-places * max(1, abs(b)))

    # ---- bodies ----

    def test_mass_follows_colliders(self):
        """What followed from the colliders still does: centre of theirs, inertia scaled."""
        body = self.world.body(self.engine.box(1, 1, 1))
        self.assertEqual(body.mass, 8000)
        body.mass = 2
        self.assertEqual(body.mass, 2)
        self.assertNear(body.inertia, [2 * 2 / 3, 0, 0, 0, 2 * 2 / 3, 0, 0, 0, 2 * 2 / 3])  # m (2^2 + 2^2) / 12
        body.collider(self.engine.box(1, 1, 1), position=(2, 0, 0))
        self.assertEqual(body.mass, 2)
        self.assertNear(body.center, (1, 0, 0))
        body.mass = 0  # of the densities again
        self.assertAlmostEqual(body.mass, 16000)

    def test_mass_keeps_what_was_given(self):
        """A centre below the middle, an inertia of one's own: the centre stays, the inertia is in proportion."""
        given = dict(mass=1000, center=(0, -0.4, 0), inertia=(300, 10, 0, 10, 400, 0, 0, 0, 500))
        for shape in (self.engine.box(1, 1, 1), None):
            body = self.world.body(shape, linear_velocity=(1, 2, 3), **given)
            body.mass = 1500
            self.assertEqual(body.mass, 1500)
            self.assertNear(body.center, (0, -0.4, 0))
            self.assertNear(body.inertia, [1.5 * x for x in given["inertia"]])
            self.assertNear(body.linear_velocity, (1, 2, 3))
        low = self.world.body(self.engine.sphere(1), mass=10, center=(0, -0.5, 0))
        inertia = low.inertia
        low.mass = 20
        self.assertNear(low.center, (0, -0.5, 0))
        self.assertNear(low.inertia, [2 * x for x in inertia])

    def test_mass_of_a_particle(self):
        """It has no inertia, so that a collider that comes later gives it one."""
        body = self.world.body()
        body.mass = 5
        self.assertEqual((body.mass, body.inertia), (5, (0,) * 9))
        body.collider(self.engine.sphere(1))
        self.assertEqual(body.mass, 5)
        self.assertNear(body.inertia, [2, 0, 0, 0, 2, 0, 0, 0, 2])  # 2/5 m r^2

    def test_set_mass_and_inertia(self):
        body = self.world.body(self.engine.sphere(1))
        body.set_mass(3, center=(0, 1, 0), inertia=(1, 0, 0, 0, 2, 0, 0, 0, 2.5))
        self.assertEqual((body.mass, body.center, body.inertia), (3, (0, 1, 0), (1, 0, 0, 0, 2, 0, 0, 0, 2.5)))
        body.inertia = (2, 0, 0, 0, 2, 0, 0, 0, 2)
        self.assertEqual((body.mass, body.center, body.inertia), (3, (0, 1, 0), (2, 0, 0, 0, 2, 0, 0, 0, 2)))

    def test_wrong_masses_change_nothing(self):
        bodies = [self.world.body(self.engine.sphere(1), mass=3, center=(0, 0.1, 0)), self.world.body(type="static"), self.world.body(mass=2)]
        before = self.world.save()
        for body, mass in [(bodies[0], -1), (bodies[0], math.nan), (bodies[0], math.inf), (bodies[1], 2), (bodies[2], 1e-310), (bodies[0], 1e-310)]:
            with self.assertRaises(ValueError):
                body.mass = mass
            self.assertEqual(self.world.save(), before)
        with self.assertRaises(ValueError):
            bodies[0].inertia = (-1, 0, 0, 0, 1, 0, 0, 0, 1)
        self.assertEqual(self.world.save(), before)

    def test_a_heavier_body_falls_alike_and_pushes_more(self):
        """Momentum: of two balls that meet head on without restitution and friction, (m1 v1 + m2 v2) / (m1 + m2) afterwards."""
        for masses in [(1, 3), (2, 2), (5, 0.25)]:
            world = self.engine.world(gravity=(0, 0, 0))
            balls = [world.body(self.engine.sphere(0.5), position=(side, 0, 0), linear_velocity=(-side, 0, 0)) for side in (-1, 1)]
            for ball, mass in zip(balls, masses):
                ball.mass = mass
            carom.run(world, seconds=2)
            together = (masses[0] - masses[1]) / sum(masses)
            for ball in balls:
                self.assertAlmostEqual(ball.linear_velocity[0], together, 6)

    def test_type(self):
        body = self.world.body(self.engine.box(1, 1, 1), position=(0, 5, 0))
        for kind in ("static", "kinematic", "dynamic"):
            body.type = kind
            self.assertEqual((body.type, body.desc.type), (kind, kind))
            body.linear_velocity = (0, 0, 0)
            self.world.step(0.1)
            self.assertEqual(body.linear_velocity[1] < 0, kind == "dynamic")
        self.assertEqual(body.mass, 8000)
        with self.assertRaisesRegex(ValueError, "type 'dynamik' is not one of dynamic, kinematic, static"):
            body.type = "dynamik"
        with self.assertRaises(carom.errors.OutOfRange):
            self.world.ground().type = "dynamic"

    def test_damping(self):
        """exp(-c t) of the velocity, of the other one none."""
        for c in (0.5, 2):
            body = self.world.body(mass=1, inertia=(1, 0, 0, 0, 1, 0, 0, 0, 1), linear_velocity=(1, 0, 0), angular_velocity=(0, 1, 0))
            body.gravity_factor = 0
            body.linear_damping = c
            self.assertEqual(body.damping, (c, 0))
            for _ in range(60):
                self.world.step(1 / 60)
            self.assertAlmostEqual(body.linear_velocity[0], math.exp(-c), 3)
            self.assertAlmostEqual(body.angular_velocity[1], 1, 9)
            body.angular_damping = 7
            self.assertEqual((body.damping, body.linear_damping, body.angular_damping), ((c, 7), c, 7))
            body.damping = 0, 1
            self.assertEqual((body.desc.linear_damping, body.desc.angular_damping), (0, 1))
            with self.assertRaises(ValueError):
                body.angular_damping = -1
            self.assertEqual(body.damping, (0, 1))

    def test_user_mask_effect(self):
        body = self.world.body()
        for user in (0, 1, 2**64 - 1):
            body.user = user
            self.assertEqual((body.user, body.desc.user), (user, user))
        body.force_field_mask = 6
        self.assertEqual((body.force_field_mask, body.attributes["force_field_mask"]), (6, 6))
        body.set_effect("gravity", "forbid")
        other = self.world.body()
        self.world.step()
        self.assertEqual(body.linear_velocity, (0, 0, 0))
        self.assertLess(other.linear_velocity[1], 0)
        self.assertRaisesRegex(ValueError, "effect 'gravitation' is not one of .*gravity", body.set_effect, "gravitation")

    def test_pose(self):
        a, b = self.world.body(), self.world.body()
        a.pose = (1, 2, 3), (0, 0.6, 0, 0.8)
        self.assertEqual((a.position, a.orientation), ((1, 2, 3), (0, 0.6, 0, 0.8)))
        b.pose = a.pose
        self.assertEqual(b.pose, ((1, 2, 3), (0, 0.6, 0, 0.8)))
        for wrong in ((1, 2, 3), 5, ((1, 2, 3),), None):
            with self.assertRaisesRegex(ValueError, "pose takes two vectors"):
                b.pose = wrong
        with self.assertRaisesRegex(TypeError, r"position\[1\] takes a number, got 'x'"):
            b.pose = (1, "x", 3), (0, 0, 0, 1)
        self.assertEqual(b.position, (1, 2, 3))

    # ---- colliders ----

    def test_density(self):
        body = self.world.body(self.engine.box(1, 1, 1))
        second = body.collider(self.engine.box(1, 1, 1), position=(2, 0, 0), density=0)
        self.assertEqual([piece.density for piece in body.colliders], [1000, 0])
        self.assertEqual(body.colliders[1], second)
        second.density = 3000
        self.assertAlmostEqual(body.mass, 32000)
        self.assertNear(body.center, (1.5, 0, 0))
        body.mass = 7  # given: a density no longer counts
        second.density = 10
        self.assertEqual((body.mass, second.density, second.body), (7, 10, body))

    def test_material(self):
        """A box on a slope of 30 degrees: it slides where friction is below tan 30 = 0.577, and stays where it is above."""
        slope = math.radians(30)
        for friction, slides in [(0.3, True), (0.8, False), (0.5, True)]:
            world = self.engine.world(gravity=(9.81 * math.sin(slope), -9.81 * math.cos(slope), 0))
            ground = world.ground()
            box = world.body(self.engine.box(0.5, 0.5, 0.5), position=(0, 0.5, 0))
            piece = box.colliders[0]
            self.assertIsNone(piece.material)
            stuff = world.material(friction=friction)
            piece.material = ground.colliders[0].material = stuff
            self.assertEqual(piece.material, stuff)
            carom.run(world, seconds=1)
            way = 0.5 * 9.81 * (math.sin(slope) - friction * math.cos(slope)) if slides else 0
            self.assertAlmostEqual(box.position[0], way, delta=0.05 * way + 1e-3)
            piece.material = None
            self.assertIsNone(piece.material)

    def test_pose_on_the_body(self):
        body = self.world.body(self.engine.box(1, 1, 1))
        piece = body.colliders[0]
        piece.position = (3, 0, 0)
        self.assertNear(body.center, (3, 0, 0))
        piece.orientation = (0, 0.6, 0, 0.8)
        self.assertEqual((piece.pose, piece.position), (((3, 0, 0), (0, 0.6, 0, 0.8)), (3, 0, 0)))
        piece.pose = (0, 1, 0), (0, 0, 0, 1)
        self.assertEqual((piece.position, piece.orientation), ((0, 1, 0), (0, 0, 0, 1)))
        hit = self.world.ray((0, 9, 0), (0, -1, 0))
        self.assertEqual((hit.collider, round(hit.time, 9)), (piece, 7))
        with self.assertRaises(carom.errors.NotUnit):
            piece.orientation = (0, 0, 0, 2)
        with self.assertRaisesRegex(ValueError, "position takes 3 numbers, got 2"):
            piece.position = (1, 2)
        self.assertEqual(piece.pose, ((0, 1, 0), (0, 0, 0, 1)))

    def test_belt_and_filter(self):
        piece = self.world.body(self.engine.box(1, 1, 1), type="static").colliders[0]
        piece.surface_velocity = (1, 0, 0), (0, 2, 0)
        self.assertEqual(piece.surface_velocity, ((1, 0, 0), (0, 2, 0)))
        piece.set_filter(category=2, mask=4, group=-1)
        self.assertEqual(piece.filter, (2, 4, -1))

    # ---- others ----

    def test_presets(self):
        for word in ("fast", "balanced", "accurate", "reference"):
            self.world.set_preset(word)
            self.world.set_preset(getattr(raw, f"CAROM_PRESET_{word.upper()}"))
        self.assertNotEqual(dict(self.world.dials), dict(self.engine.world().dials))
        self.assertRaisesRegex(ValueError, "preset 'best' is not one of .*reference", self.world.set_preset, "best")

    def test_particles(self):
        sparks = self.world.particles(mass=2, gravity_factor=0.5)
        sparks.update(linear_damping=1)
        desc = raw.carom_particles_desc(struct_size=ctypes.sizeof(raw.carom_particles_desc))
        self.world._call(raw.carom_particles_get, sparks.handle, ctypes.byref(desc))
        self.assertEqual((desc.mass, desc.gravity_factor, desc.linear_damping), (2, 0.5, 1))

    def test_they_are_recorded(self):
        """A session that sets everything replays to the same bits."""
        try:
            tool = sys.modules["carom.tune"]._find_tool(None)
        except FileNotFoundError:
            self.skipTest("the command carom was not built")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "session.rec")
            with open(path, "wb") as file, self.world.record(file):
                body = self.world.body(self.engine.box(1, 1, 1))
                body.mass, body.type, body.damping, body.user = 2, "kinematic", (1, 2), 3
                body.type, body.pose, body.inertia = "dynamic", ((0, 9, 0), (0, 0.6, 0, 0.8)), (1, 0, 0, 0, 2, 0, 0, 0, 2.5)
                piece = body.colliders[0]
                piece.density, piece.material, piece.position = 3, self.world.material(0.1), (0, 1, 0)
                self.world.set_preset("accurate")
                for _ in range(10):
                    self.world.step()
            done = subprocess.run([tool, "replay", str(path)], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
