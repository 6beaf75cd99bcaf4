"""The face: what each room of the package does, on scenes whose answer is known."""
import io
import math
import unittest

import carom

G = 9.81


class Face(unittest.TestCase):
    def setUp(self):
        self.engine = carom.Engine()
        self.world = self.engine.world()
        self.addCleanup(self.engine.close)

    def test_chaos_is_told_from_what_is_regular(self):
        def rods(angles):
            world = self.engine.world()
            before, at = None, (0.0, 0.0)
            for angle in angles:
                down = (math.sin(angle), -math.cos(angle))
                rod = world.body(position=(at[0] + down[0] / 4, at[1] + down[1] / 4, 0), mass=1, inertia=(0.02, 0, 0, 0, 0.02, 0, 0, 0, 0.02))
                world.joint("hinge", before, rod, position=(*at, 0), orientation=(0, -math.sqrt(0.5), 0, math.sqrt(0.5)))
                before, at = rod, (at[0] + down[0] / 2, at[1] + down[1] / 2)
            world.set_accuracy(place=1e-5, turn=1e-5)
            hash_before = world.hash
            growth = world.measure_growth(steps=1200)
            self.assertEqual(world.hash, hash_before)
            world.step()
            flags = world.islands()[0].flags
            self.assertIs(type(flags), carom.records.IslandFlags)
            self.assertIn(carom.records.IslandFlags.JOINTS_ALONE, flags)
            return growth

        wild, calm = rods((2.0, 2.5)), rods((1.0,))
        self.assertTrue(wild.sensitive and wild.rate > 1 and wild.body is not None)
        self.assertFalse(calm.sensitive)
        with self.assertRaises(carom.errors.OutOfRange):
            self.world.measure_growth(steps=0)

    def test_defaults_are_the_descriptors(self):
        desc = self.world.body().desc
        self.assertEqual((desc.type, desc.position, desc.orientation, desc.mass), ("dynamic", (0, 0, 0), (0, 0, 0, 1), 1))
        about = dict(position=(1, 2, 3), orientation=(0, 0.6, 0, 0.8), linear_velocity=(4, 5, 6), angular_velocity=(7, 8, 9), mass=3,
                     center=(0.1, 0, 0), inertia=(1, 0, 0, 0, 2, 0, 0, 0, 2.5), linear_damping=0.5, angular_damping=0.25, user=77)
        desc = self.world.body(stays_awake=True, **about).desc
        for name, value in about.items():
            if name == "linear_velocity":
                continue
            found = getattr(desc, name)
            if isinstance(value, tuple):
                for a, b in zip(found, value):
                    self.assertAlmostEqual(a, b, 14, name)
            else:
                self.assertEqual(found, value, name)
        self.assertTrue(desc.fields & carom.raw.CAROM_BODY_STAYS_AWAKE)

    def test_shapes(self):
        """Volumes in closed form, within the bracket that the engine gives."""
        for shape, volume in [(self.engine.sphere(2), 4 / 3 * math.pi * 8), (self.engine.box(1, 2, 3), 48),
                              (self.engine.capsule(1, 2), math.pi * 4 + 4 / 3 * math.pi), (self.engine.cylinder(1, 2), math.pi * 4),
                              (self.engine.cone(1, 2), math.pi / 3 * 4), (self.engine.ellipsoid(1, 2, 3), 4 / 3 * math.pi * 6),
                              (self.engine.hull([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]), 1 / 6)]:
            info = shape.info
            self.assertLessEqual(info.volume_min * (1 - 1e-12), volume)
            self.assertGreaterEqual(info.volume_max * (1 + 1e-12), volume)
        self.assertEqual(self.engine.box(1, 2, 3).params, (1, 2, 3))
        self.assertTrue(self.engine.half_space().info.is_half_space)
        self.assertTrue(self.engine.mesh([(0, 0, 0), (0, 0, 1), (1, 0, 0)], [(0, 1, 2)]).info.is_scenery)
        self.assertTrue(self.engine.height_field([[0, 0, 0], [0, 1, math.nan]], (1, 2)).info.is_scenery)

    def test_hulls_of_shapes(self):
        with carom.Engine() as engine:
            ball, box = engine.sphere(0.25), engine.box(0.5, 0.1, 0.2)
            sweep = engine.hull_of([(ball, (0, -1, 0)), (ball, (0, 1, 0))])
            capsule = engine.capsule(0.25, 1).info
            self.assertTrue(sweep.info.volume_min <= capsule.volume <= sweep.info.volume_max)
            parts = [(box, (1.0, 0.0, 0.0), (0.0, 0.6, 0.0, 0.8), (1.0, -2.0, 1.0)), (ball, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), (1.0, 1.0, 1.0))]
            mixed = engine.hull_of([parts[0], ball], radius=0.125)
            self.assertEqual((mixed.parts, mixed.rounding), (parts, 0.125))
            self.assertEqual((box.parts, box.rounding), ([], 0))
            self.assertTrue(engine.hull_of([box, (box, (1, 0, 0))]).info.mass_exact)
            with self.assertRaises(carom.errors.InUse):
                ball.destroy()
            with self.assertRaises(carom.errors.Unsupported):
                engine.hull_of([engine.half_space()])
            with self.assertRaises(carom.errors.OutOfRange):
                engine.hull_of([])
            with self.assertRaises(ValueError):
                engine.hull_of([(ball, (0, 0, 0), (0, 0, 0, 1), (1, 1, 1), 5)])
            with self.assertRaisesRegex(ValueError, r"parts\[0\] takes a Shape"):
                engine.hull_of([3.5])
            tapered = engine.tapered_capsule(0.5, 0.25, 1).info
            self.assertAlmostEqual(tapered.aabb_max[1], 1.25, 12)

    def test_distance(self):
        answer = self.engine.distance(self.engine.sphere(1), self.engine.sphere(2), (0, 0, 0), (5, 0, 0), tolerance=1e-9)
        self.assertAlmostEqual(answer.separation, 2, 8)
        self.assertTrue(answer.lower <= 2 <= answer.upper)
        self.assertEqual([round(x, 9) for x in answer.normal], [1, 0, 0])

    def test_flight(self):
        ball = self.world.body(position=(0, 10, 0), linear_velocity=(1, 0, 0))
        self.assertEqual(carom.run(self.world, 1, dt=1 / 64), 64)
        x, y, _ = ball.position  # velocity Verlet: exact under gravity
        self.assertAlmostEqual(x, 1, 12)
        self.assertAlmostEqual(y, 10 - G / 2, 12)
        ball.add_impulse((0, 2, 0))
        self.assertAlmostEqual(ball.linear_velocity[1], 2 - G, 12)
        self.world.gravity = 0, 0, 0
        ball.set_velocity()
        ball.add_force((3, 0, 0))
        self.world.step(0.5)
        self.assertAlmostEqual(ball.linear_velocity[0], 1.5, 12)

    def test_run_shows_progress_and_stops(self):
        file = io.StringIO()
        self.assertEqual(carom.run(self.world, 0.26, dt=0.1, progress=True, file=file), 3)  # 0.1, 0.1 and what is left
        self.assertAlmostEqual(self.world.report.time, 0.26, 12)
        self.assertRegex(file.getvalue(), r"\[#{24}\] .*x real time.* left \n$")
        silent = io.StringIO()
        self.assertEqual(carom.run(self.world, 1, dt=0.1, each=lambda w: w.report.time > 0.5, file=silent), 3)
        self.assertEqual(silent.getvalue(), "")
        self.assertEqual(carom.run(self.world, 0), 0)
        self.assertRaises(ValueError, carom.run, self.world, -1)

    def test_dials(self):
        self.world.dials["solver"] = "direct"
        self.world.dials["substeps"] = 7
        self.assertEqual((self.world.dials["solver"], self.world.dials["substeps"]), ("direct", 7))
        del self.world.dials["substeps"]
        self.assertEqual(self.world.dials["substeps"], carom.dial_infos()["substeps"].initial)
        self.assertEqual(len(self.world.dials), carom.raw.CAROM_DIAL_COUNT)
        with self.engine.world(solver="soft_step", sleep="on") as other:
            self.assertEqual((other.dials["solver"], other.dials["sleep"]), ("soft_step", "on"))

    def test_questions(self):
        ball = self.world.body(self.engine.sphere(1), position=(0, 5, 0))
        self.world.ground()
        hit = self.world.ray((0, 10, 0), (0, -1, 0))
        self.assertEqual((hit.outcome, hit.body), ("hit", ball))
        self.assertTrue(hit.lower <= 4 <= hit.upper)
        self.assertIsNone(self.world.ray((0, 10, 0), (0, 1, 0)))
        self.assertIsNone(self.world.ray((0, 10, 0), (0, -1, 0), max=3))
        self.assertAlmostEqual(self.world.ray((0, 10, 0), (0, -1, 0), ignore=ball).point[1], 0, 6)
        self.assertEqual(self.world.nearest((3, 5, 0)).body, ball)
        self.assertAlmostEqual(self.world.nearest((3, 5, 0)).separation, 2, 5)
        self.assertIsNone(self.world.nearest((30, 50, 0), reach=1))
        self.assertEqual([hit.body for hit in self.world.overlaps(self.engine.sphere(0.5), (0, 6.2, 0))], [ball])
        moved = self.world.cast(self.engine.sphere(0.5), (0, 10, 0), (0, -10, 0))
        self.assertAlmostEqual(moved.time, 0.35, 5)
        many = self.world.rays([(0, 10, 0), (50, 10, 0), (0, 10, 0)], [(0, -1, 0), (0, -1, 0), (0, 1, 0)])
        self.assertEqual(many.outcomes.tolist(), [1, 1, 0])
        self.assertAlmostEqual(many.times[0], 4, 5)

    def test_events(self):
        self.world.collect_events("contact", "sensor", "sleep", hit_speed=1)
        self.world.dials["sleep"] = "on"
        self.world.ground()
        gate = self.world.body(type="static", position=(0, 2, 0)).collider(self.engine.box(1, 0.2, 1))
        gate.sensor = True
        ball = self.world.body(self.engine.sphere(0.5), position=(0, 4, 0))
        seen = []

        def look(world):
            seen.extend(("contact", e.kind, ball in (e.body_a, e.body_b)) for e in world.contact_events())
            seen.extend(("sensor", e.kind, e.sensor == gate and e.other_body == ball) for e in world.sensor_events())
            seen.extend(("sleep", e.kind, e.body == ball) for e in world.sleep_events())

        carom.run(self.world, 3, each=look)
        self.assertEqual(seen, [("sensor", "enter", True), ("sensor", "leave", True), ("contact", "begin", True), ("contact", "hit", True),
                                ("sleep", "asleep", True)])
        self.assertTrue(ball.asleep)
        ball.wake()
        self.assertFalse(ball.asleep)

    def test_attributes(self):
        """Each by its name, as the typed properties have them; and what they are."""
        ball = self.world.body(self.engine.sphere(0.5), position=(0, 4, 0))
        infos = carom.attribute_infos()
        self.assertEqual(set(ball.attributes), set(infos))
        self.assertEqual((infos["drag"].numbers, infos["drag"].unit, infos["locks"].whole), (2, "kg/s, kg/m", True))
        for name, info in infos.items():
            value = tuple(min(x + 1, info.max) for x in info.usual)
            ball.attributes[name] = value if info.numbers > 1 else value[0]
            self.assertEqual(ball.attributes[name], value if info.numbers > 1 else value[0])
        self.assertEqual((ball.gravity_factor, ball.drag, ball.locks), (2, (1, 1), 1))
        del ball.attributes["drag"]
        self.assertEqual(ball.drag, (0, 0))
        with self.assertRaisesRegex(KeyError, "no attribute 'weight'; there are .*drag"):
            ball.attributes["weight"] = 1
        with self.assertRaisesRegex(ValueError, "2 numbers"):
            ball.attributes["drag"] = 1
        with self.assertRaises(carom.CaromError):
            ball.attributes["locks"] = 0.5

    def test_magnets(self):
        """A compass turns towards the field: moment times field over inertia, in its first step."""
        self.world.gravity = (0, 0, 0)
        needle = self.world.body(self.engine.box(0.1, 0.1, 0.1), position=(0, 4, 0))
        needle.attributes["magnetic_moment"] = (2, 0, 0)
        field = self.world.force_field("magnetic", vector=(0, 0, 0.5))
        self.assertEqual(field.desc.kind, "magnetic")
        self.world.step(1 / 480)
        self.assertAlmostEqual(needle.angular_velocity[1], -2 * 0.5 / (8 * 0.02 / 3) / 480, 4)

    def test_joints(self):
        """A pendulum of a hinge: after a quarter of its swing; and a joint that breaks."""
        bob = self.world.body(position=(1, 0, 0), mass=1, inertia=(0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1))
        hinge = self.world.joint("hinge", None, bob, position=(0, 0, 0), axis=(0, 0, 1))
        self.assertEqual((hinge.desc.kind, hinge.desc.body_a, hinge.desc.body_b), ("hinge", None, bob))
        limit = hinge.limit("twist", lower=-0.5, upper=0.5)
        self.assertEqual((limit.enabled, limit.lower, limit.upper), (True, -0.5, 0.5))
        carom.run(self.world, 2)
        self.assertAlmostEqual(abs(hinge.state.coordinate["twist"]), 0.5, 2)  # it hangs in its limit
        self.assertLess(hinge.state.gap, 1e-3)
        self.assertFalse(hinge.limit("twist", enabled=False).enabled)
        weight, self.world.gravity = self.world.gravity, (0, 0, 0)
        motor = hinge.motor("twist", speed=2, max_force=1e6)
        self.assertTrue(motor.enabled)
        self.world.step()
        self.assertAlmostEqual(abs(bob.angular_velocity[2]), 2, 3)
        hinge.destroy()
        self.world.gravity = weight
        self.assertEqual(self.world.joints, [])
        self.world.collect_events("joint")
        weak = self.world.joint("weld", None, bob, position=bob.position, break_force=G / 2)
        self.world.step()
        self.assertEqual([e.joint for e in self.world.joint_events()], [weak])
        self.assertTrue(weak.state.broken)
        rope = self.world.joint("distance", None, bob, position_a=(0, 5, 0), length=2, user=5)
        self.assertEqual((rope.desc.length, rope.desc.user), (2, 5))

    def test_pulleys_and_gears(self):
        """Atwood's machine, g (m1 - m2) / (m1 + m2); and two wheels that turn against each other."""
        inertia = (0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1)
        heavy = self.world.body(position=(0, -3, 0), mass=3, inertia=inertia)
        light = self.world.body(position=(2, -3, 0), mass=1, inertia=inertia)
        pulley = self.world.joint("pulley", heavy, light)
        over = pulley.transmission(anchor_a=(0, 0, 0), anchor_b=(2, 0, 0))
        self.assertEqual((pulley.desc.kind, over.ratio, over.length), ("pulley", 1, 6))
        carom.run(self.world, 0.5)
        self.assertAlmostEqual(heavy.linear_velocity[1], -G / 2 * 0.5, 9)
        self.world.gravity = 0, 0, 0
        one, two = (self.world.body(position=(x, 9, 0), mass=1, inertia=inertia) for x in (5, 6))
        gear = self.world.joint("gear", one, two, position=(5, 9, 0), axis=(0, 0, 1))
        self.assertEqual(gear.transmission(ratio=-2).ratio, -2)
        one.angular_velocity = 0, 0, 5
        carom.run(self.world, 0.5)
        self.assertAlmostEqual(one.angular_velocity[2], 4, 9)  # of 5 (1 / (1 + 1 / 4))
        self.assertAlmostEqual(two.angular_velocity[2], 2, 9)

    def test_couplings(self):
        """A weight on a rack that a wheel turns: a = m g / (m + I / r^2)."""
        inertia = (0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1)
        wheel = self.world.body(position=(0, 0, 0), mass=1, inertia=inertia)
        weight = self.world.body(position=(1, 0, 0), mass=2, inertia=inertia)
        pin = self.world.joint("hinge", None, wheel, position=(0, 0, 0), axis=(0, 0, 1))
        rack = self.world.joint("slider", None, weight, position=(1, 0, 0), axis=(0, 1, 0))
        coupling = self.world.couple(rack, pin, (0, 0.25), user=3)
        now = coupling.coupling()
        self.assertEqual((coupling.desc.kind, now.follower, now.leader, list(now.polynomial), now.user), ("coupling", rack, pin, [0, 0.25, 0, 0, 0], 3))
        carom.run(self.world, 0.5)
        self.assertAlmostEqual(weight.linear_velocity[1], -2 * G / (2 + 0.1 / 0.25**2) * 0.5, 8)
        self.assertEqual(list(coupling.coupling((0, 0, 1)).polynomial), [0, 0, 1, 0, 0])
        with self.assertRaisesRegex(ValueError, "degree 4"):
            self.world.couple(rack, pin, range(6))
        with self.assertRaisesRegex(TypeError, "leader"):
            self.world.couple(rack, "pin")
        pin.destroy()
        self.assertEqual(len(self.world.joints), 1)

    def test_axes(self):
        """A weight on a spring in N/m sags by m g / k; a ball turns to where it is told to."""
        inertia = (0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1)
        weight = self.world.body(position=(0, 0, 0), mass=2, inertia=inertia)
        rail = self.world.joint("six_axis", None, weight, position=(0, 0, 0))
        self.assertEqual((rail.desc.kind, rail.axis("x").mode), ("six_axis", "free"))
        for name in ("x", "z", "turn_x", "turn_y", "turn_z"):
            self.assertEqual(rail.axis(name, mode="locked").mode, "locked")
        now = rail.axis("y", spring_gains="force", spring_stiffness=500, spring_damping=60)
        self.assertEqual((now.spring_gains, now.spring_stiffness, now.drive), ("force", 500, "none"))
        carom.run(self.world, 3)
        self.assertAlmostEqual(rail.state.axis["y"], -2 * G / 500, 9)
        head = self.world.body(position=(5, 0, 0), mass=2, inertia=inertia)
        neck = self.world.joint("ball", None, head, position=(5, 0, 0))
        half = math.sqrt(0.5)
        drive = neck.orientation_drive(drive="position", target=(0, half, 0, half), stiffness=2, damping=1)
        self.assertEqual((drive.drive, drive.gains, drive.stiffness), ("position", "frequency", 2))
        carom.run(self.world, 3)
        self.assertAlmostEqual(neck.state.axis["turn_y"], math.pi / 2, 9)
        with self.assertRaises(NotImplementedError):
            neck.axis("x")

    def test_tree(self):
        """A weight of 2 kg on a rail, and one on a hinge of it, 1 m aside: M, weights, and what the coordinates are."""
        inertia = (0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1)
        block = self.world.body(position=(0, 0, 0), mass=2, inertia=inertia)
        arm = self.world.body(position=(1, 0, 0), mass=2, inertia=inertia)
        rail = self.world.joint("slider", None, block, position=(0, 0, 0), axis=(0, 1, 0))
        pin = self.world.joint("hinge", block, arm, position=(0, 0, 0), axis=(0, 0, 1))
        tree = self.world.tree(arm)
        self.assertEqual((len(tree), [(c.joint, c.body, c.axis) for c in tree.coordinates]),
                         (2, [(rail, block, "x"), (pin, arm, "turn_x")]))
        self.assertEqual([round(float(x), 12) for x in tree.mass.reshape(-1)], [4, 2, 2, 2.1])
        self.assertEqual([round(float(x), 12) for x in tree.forces(speeds=[0, 0])], [4 * G, 2 * G])
        self.assertEqual([round(float(x), 12) for x in tree.forces([1, 2], [0, 0])], [round(4 * G + 8, 12), round(2 * G + 6.2, 12)])
        self.assertEqual(list(tree.speeds), [0, 0])
        with self.assertRaisesRegex(ValueError, "accelerations"):
            tree.forces([1])
        self.world.joint("gear", block, arm)
        with self.assertRaisesRegex(NotImplementedError, "gear"):
            self.world.tree(arm)

    def test_forces(self):
        self.world.gravity = 0, 0, 0
        one, two = self.world.body(mass=2), self.world.body(mass=2, position=(2, 0, 0))
        spring = self.world.spring(one, two, rest=1, stiffness=10)
        self.assertEqual(spring.state, (2, 10))
        self.assertEqual((spring.desc.body_a, spring.desc.body_b), (one, two))
        spring.update(2, 10, 0)
        self.assertEqual(spring.state, (2, 0))
        field = self.world.force_field("uniform", vector=(0, 3, 0))
        self.world.step(0.5)
        self.assertAlmostEqual(one.linear_velocity[1], 1.5, 12)
        field.update(vector=(0, -3, 0), user=4)
        self.assertEqual((field.desc.kind, field.desc.vector, field.desc.user), ("uniform", (0, -3, 0), 4))
        field.destroy()
        self.assertIsNone(self.world.water)
        self.world.water = carom.Water(level=1.5, density=900)
        self.assertEqual((self.world.water.level, self.world.water.density, self.world.water.normal), (1.5, 900, (0, 1, 0)))
        self.world.water = None
        self.assertIsNone(self.world.water)
        self.world.wind, one.drag = (1, 2, 3), (0.5, 0.25)
        self.assertEqual((self.world.wind, one.drag), ((1, 2, 3), (0.5, 0.25)))
        one.gravity_factor, one.locks, one.continuous = 0.5, ("linear_z", "angular_x"), "always"
        self.assertEqual((one.gravity_factor, one.locks, one.continuous), (0.5, 0x4 | 0x8, "always"))

    def test_plan_and_effects(self):
        self.world.body()
        self.world.step()
        plan = {line.name: line for line in self.world.plan()}
        self.assertTrue(plan["gravity"].runs and plan["gravity"].participants == 1 and plan["gravity"].mode == "as_needed")
        self.assertFalse(plan["friction"].runs)
        self.assertTrue(plan["friction"].reason)
        self.world.set_effect("gravity", "forbid")
        self.world.step()
        plan = {line.name: line for line in self.world.plan()}
        self.assertEqual((plan["gravity"].runs, plan["gravity"].mode), (False, "forbid"))
        self.assertIn("buoyancy", carom.effects())
        with self.assertRaisesRegex(ValueError, "not one of .*gravity"):
            self.world.set_effect("gravitation")

    def test_residuals_and_budget(self):
        self.assertIsNone(self.world.residuals.energy_drift)
        self.world.keep_ledger()
        self.world.step(1 / 64)
        left = self.world.residuals
        self.assertEqual(left.max_penetration, self.world.report.max_penetration)
        self.assertIsInstance(left.energy_drift, float)
        self.assertIsNone(self.world.budget)
        self.world.set_budget(2e-3, 2, 6)
        self.assertEqual(self.world.budget, (2e-3, 2, 6))
        with self.assertRaises(ValueError):
            self.world.set_budget(2e-3, 6, 2)
        self.world.set_budget(None)
        self.assertIsNone(self.world.budget)

    def test_ledger(self):
        ball = self.world.body(mass=2)
        self.assertEqual(self.world.ledger(), {})
        self.world.keep_ledger()
        carom.run(self.world, 0.5, dt=0.125)
        self.assertAlmostEqual(self.world.ledger()["gravity"].total_linear[1], -2 * G * 0.5, 12)
        state = self.world.ledger_state
        self.assertTrue(state.is_kept and state.steps == 4)
        self.assertAlmostEqual(state.now_kinetic, ball.linear_velocity[1] ** 2, 12)

    def test_particles(self):
        sparks = self.world.particles(mass=0.1, capacity=10)
        sparks.add([(0, i, 0) for i in range(5)], [(1, 0, 0)] * 5)
        self.assertEqual(len(sparks), 5)
        self.world.step(0.5)
        self.assertEqual(sparks.read("position")[:, 0].tolist(), [0.5] * 5)
        sparks.write("linear_velocity", [(0, 0, 2)] * 5)
        sparks.remove([1, 3])
        self.assertEqual(sparks.read("linear_velocity").tolist(), [[0, 0, 2]] * 3)
        self.assertEqual(sparks.read("mass", dtype="float32").dtype, "float32")

    def test_materials_and_colliders(self):
        belt = self.world.material(friction=0.9, restitution=0.1, friction_mix="maximum", rolling=0.01)
        self.assertEqual(belt.resistance, (0.01, 0))
        body = self.world.body(self.engine.box(1, 1, 1), material=belt, density=10, type="kinematic")
        part = body.collider(self.engine.sphere(1), position=(0, 1, 0))
        desc = part.desc
        self.assertEqual((desc.body, desc.position, desc.shape, desc.material), (body, (0, 1, 0), desc.shape, None))
        self.assertIsInstance(desc.shape, carom.Shape)
        self.assertRaises(carom.errors.InUse, belt.destroy)
        part.set_filter(category=2, mask=4, group=-1)
        part.set_surface_velocity((1, 0, 0))
        part.destroy()

    def test_draw_and_faults(self):
        self.world.body(self.engine.box(1, 1, 1))
        lines = self.world.draw("shapes")
        self.assertEqual(len(lines), 12)
        self.assertEqual((len(lines[0].from_), len(lines[0].to)), (3, 3))
        answer = [0.5]
        fickle = self.engine.support_plugin(lambda p, d: tuple(answer[0] if x >= 0 else -answer[0] for x in d), "test.fickle")()
        self.world.ground()
        self.world.body(fickle, position=(5, 0.4, 0))
        self.world.collect_events("fault")
        self.world.step()
        self.assertEqual(self.world.faults(), [])
        answer[0] = math.nan
        self.world.step()
        self.assertEqual([(f.kind, f.shape) for f in self.world.faults()], [("not_finite", fickle)])
        self.assertEqual([f.kind for f in self.world.fault_events()], ["not_finite"])

    def test_log(self):
        said = []
        with carom.Engine(log=lambda level, text: said.append((level, text))) as engine, engine.world() as world:
            world.step()
        self.assertTrue(all(level in (1, 2, 3) and text for level, text in said))


if __name__ == "__main__":
    unittest.main()
