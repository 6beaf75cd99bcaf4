"""The kit from Python: what a character and a vehicle do in closed form, the bits of the raw calls, and what is refused."""
import ctypes
import unittest

import carom
from carom import errors, raw

G, DT, GAP = 9.81, 1 / 60, 0.01 * 1.02  # m/s^2; s; m that a character stands off the ground


class Kit(unittest.TestCase):
    def setUp(self):
        self.engine = carom.Engine()
        self.world = self.engine.world()
        self.addCleanup(self.engine.close)
        self.ground = self.world.ground()

    def box(self, low, high, **about):
        half = [(b - a) / 2 for a, b in zip(low, high)]
        return self.world.body(self.engine.box(*half), position=[(a + b) / 2 for a, b in zip(low, high)], **{"type": "static", **about})


class Characters(Kit):
    def walker(self, x=0.0, **about):
        """A capsule 1.8 m tall that stands on the ground."""
        one = carom.Character(self.world, self.engine.capsule(0.3, 0.6), position=(x, 0.9 + GAP, 0), **about)
        one.move((0, 0, 0))
        self.assertEqual((one.ground, one.ground_body), ("firm", self.ground))
        return one

    def frames(self, one, n, walk=(0, 0, 0)):
        for _ in range(n):
            self.world.step(DT)
            one.move(walk, DT)
            one.push(DT)

    def test_it_climbs_what_is_low_and_stops_at_what_is_high(self):
        for limit, height in ((0.3, 0), (0.5, 0.4)):
            step = self.box((1, -1, -5), (9, 0.4, 5))
            one = self.walker(step_up=limit)
            self.frames(one, 120, (1.5, 0, 0))
            self.assertAlmostEqual(one.position[1] - one.foot, height + GAP, 4)
            if height:
                self.assertAlmostEqual(one.position[0], 3, 3)  # 2 s at 1.5 m/s
                self.assertEqual((one.ground_body, one.ground_normal[1]), (step, 1))
            else:
                [contact] = one.contacts
                self.assertEqual(contact.body, step)
                self.assertAlmostEqual(contact.normal[0], -1, 6)
                self.assertAlmostEqual(contact.point[0], 1, 6)
                self.assertAlmostEqual(contact.speed, 1.5, 6)
            step.destroy()

    def test_a_jump_rises_to_v_squared_over_2_g(self):
        one, highest = self.walker(), 0
        one.move((0, 0, 0), DT, jump=4)
        self.assertEqual((one.ground, one.ground_body, one.ground_collider), ("air", None, None))
        for _ in range(60):
            highest = max(highest, one.position[1] - one.foot - GAP)
            one.move((0, 0, 0), DT)
        self.assertAlmostEqual(highest, 16 / (2 * G), delta=G * DT * DT / 8 + 1e-4)  # the top is at most half a frame away
        self.assertEqual(one.ground, "firm")

    def test_it_stands_up_only_where_there_is_a_place(self):
        low, tall = self.engine.capsule(0.3, 0.2), self.engine.capsule(0.3, 0.6)
        ceiling = self.box((-1, 1.5, -1), (1, 2, 1))
        one = carom.Character(self.world, low, position=(0, 0.5 + GAP, 0))
        one.move((0, 0, 0))
        before = one.save()
        self.assertIs(one.set_shape(tall), False)
        self.assertEqual((one.save(), one.shape), (before, low))
        ceiling.destroy()
        self.assertIs(one.set_shape(tall), True)
        self.assertEqual(one.shape, tall)
        self.assertAlmostEqual(one.position[1] - one.foot, GAP, 5)
        self.box((-1, 1.5, -1), (1, 2, 1))
        self.assertIs(one.set_shape(tall, always=True), True)

    def test_it_pushes_with_a_bounded_force(self):
        """push_force less Coulomb's force on a crate of 100 kg, from rest, as long as it pushes: v = (F / m - mu g) t."""
        crate = self.box((0.32, 0, -0.5), (1.32, 1, 0.5), type="dynamic", mass=100)
        one = self.walker(push_force=600)
        self.frames(one, 31, (3, 0, 0))
        self.assertAlmostEqual(crate.linear_velocity[0], (6 - 0.5 * G) * 0.5, delta=0.05)

    def test_a_body_follows_it(self):
        body = self.world.body(self.engine.capsule(0.3, 0.6), position=(0, 0.9 + GAP, 0), type="kinematic")
        one = self.walker(body=body)
        for _ in range(30):
            self.world.step(DT)
            one.move((1, 0, 0), DT)
            one.move_body(DT)
        self.world.step(DT)
        for there, here in zip(body.position, one.position):
            self.assertAlmostEqual(there, here, 9)
        self.assertEqual(one.settings["body"], body)

    def test_bits_are_those_of_the_raw_calls(self):
        self.box((1, -1, -5), (9, 0.2, 5))
        one = self.walker(step_up=0.25, turns=False)
        desc, state = raw.carom_character_desc(), raw.carom_character()
        raw.carom_character_desc_init(ctypes.byref(desc), ctypes.sizeof(desc))
        raw.carom_character_init(ctypes.byref(state), ctypes.sizeof(state))
        desc.step_up, desc.flags, state.position[1] = 0.25, 0, 0.9 + GAP
        self.world._call(lambda w, *rest: raw.carom_character_set_shape(self.engine._pointer, w, *rest), ctypes.byref(desc),
                         ctypes.byref(state), one.shape.handle, None)
        still, walk = (ctypes.c_double * 3)(), (ctypes.c_double * 3)(1.5, 0, 0.25)
        self.world._call(raw.carom_character_move, ctypes.byref(desc), ctypes.byref(state), still, 0, DT)
        for i in range(90):
            self.world._call(raw.carom_character_move, ctypes.byref(desc), ctypes.byref(state), walk, 3.0 if i == 40 else 0.0, DT)
            one.move((1.5, 0, 0.25), DT, jump=3 if i == 40 else 0)
        self.assertEqual(one.save(), bytes(state))
        self.assertGreater(one.position[0], 2)

    def test_back_in_time(self):
        crate = self.box((1, 0, -0.5), (2, 1, 0.5), type="dynamic", density=50)
        one = self.walker()
        self.frames(one, 40, (1.5, 0, 0))
        saved, world = one.save(), self.world.save()
        self.frames(one, 40, (1.5, 0, 0))
        after, there, hash_ = one.save(), crate.position, self.world.hash
        one.restore(saved)
        self.world.restore(world)
        self.frames(one, 40, (1.5, 0, 0))
        self.assertEqual((one.save(), crate.position, self.world.hash), (after, there, hash_))
        self.assertNotEqual(saved, after)

    def test_settings_are_the_descriptors(self):
        one = self.walker()
        settings = one.settings
        self.assertEqual((settings["step_up"], settings["mass"], settings["up"], settings["turns"], settings["flies"], settings["body"]),
                         (0.3, 80, (0, 1, 0), True, False, None))
        one.update(step_up=0.4, flies=True)
        self.assertEqual(one.settings, {**settings, "step_up": 0.4, "flies": True})
        self.assertEqual(carom.Character(self.world, one.shape, **one.settings).settings, one.settings)

    def test_teleport_and_turn(self):
        one = self.walker()
        one.position, one.velocity = (5, 3, 0), (0, 0, 0)
        self.assertEqual((one.ground, one.position), ("air", (5, 3, 0)))
        one.orientation = (0, 0, 0.5**0.5, 0.5**0.5)  # it lies: the origin sinks from 0.9 to 0.3 m over the lowest point
        self.assertAlmostEqual(one.position[1], 2.4, 6)
        self.assertAlmostEqual(one.foot, 0.3, 6)

    def test_what_is_refused_changes_nothing(self):
        one = self.walker()
        before, settings = one.save(), one.settings
        for error, call in (
                (TypeError, lambda: one.update(step_upp=1)), (errors.OutOfRange, lambda: one.update(max_slope=2)),
                (TypeError, lambda: one.update(mass="80")), (errors.NotUnit, lambda: one.update(up=(0, 2, 0))),
                (errors.Unsupported, lambda: one.set_shape(self.engine.half_space((0, 1, 0), 0))), (TypeError, lambda: one.set_shape(None)),
                (errors.OutOfRange, lambda: one.move((0, 0, 0), 2)), (errors.NotFinite, lambda: one.move((float("nan"), 0, 0))),
                (ValueError, lambda: one.move((1, 0))), (ValueError, lambda: one.restore(before[:-1])),
                (ValueError, lambda: one.restore(bytes(len(before)))), (errors.InvalidHandle, lambda: one.update(body=12345))):
            with self.subTest(error=error), self.assertRaises(error):
                call()
        self.assertEqual((one.save(), one.settings), (before, settings))
        self.world.close()
        for call in (lambda: one.move((0, 0, 0)), lambda: one.set_shape(one.shape)):
            with self.assertRaises(carom.Closed):
                call()


class Vehicles(Kit):
    def car(self, z=0.0, **about):
        """1200 kg, axles at z = +-1.3 m, wheels at x = +-0.75 m; at rest on its springs."""
        body = self.world.body(position=(0, 0.6, z), mass=1200, center=(0, 0, 0), inertia=(1600, 0, 0, 0, 1800, 0, 0, 0, 500))
        body.collider(self.engine.box(0.85, 0.3, 2), position=(0, 0.15, 0))
        front, rear = dict(max_steer=0.6), dict(drive=1, handbrake=3000)
        car = carom.Vehicle(body, [{"position": (x, -0.32, z), "brake": 1e5, "slide": 1, **(front if z > 0 else rear)}
                                   for z in (1.3, -1.3) for x in (0.75, -0.75)], **about)
        self.frames(car, 240)
        return car

    def frames(self, car, n, **how):
        for _ in range(n):
            car.drive(DT, **how)
            self.world.step(DT)

    def test_springs_bear_the_weight(self):
        car = self.car()
        states = [wheel.state for wheel in car.wheels]
        self.assertAlmostEqual(sum(s.load for s in states), 1200 * G, delta=1)
        for s in states:
            self.assertTrue(s.touches is True and s.body == self.ground and s.normal[1] == 1)
            self.assertAlmostEqual(s.compression, 300 * G / 30000, 4)

    def test_it_brakes_in_v_squared_over_2_mu_g(self):
        for grip in (1, 0.5):
            car = self.car()
            for wheel in car.wheels:
                wheel.update(grip=grip, side_grip=grip)
                wheel.spin = 20 / 0.33
                self.assertEqual((wheel.spin, wheel.settings["grip"]), (20 / 0.33, grip))
            car.chassis.linear_velocity = (0, 0, 20)
            begin = car.chassis.position[2]
            self.frames(car, int(60 * (20 / (grip * G) + 1.5)), brake=1, gear=0)
            way = 400 / (2 * grip * G)
            self.assertAlmostEqual(car.chassis.position[2] - begin, way, delta=0.3 + 0.01 * way)
            self.assertAlmostEqual(car.speed, 0, 3)
            car.chassis.destroy()

    def test_engine_and_gears(self):
        """In the one gear it has, the engine's largest speed is that of the car."""
        car = self.car(gears=[3.5], torque_curve=[(100, 250), (400, 300), (680, 300)], automatic=False)
        self.assertEqual((car.settings["gears"], car.settings["torque_curve"]), ((3.5,), [(100, 250), (400, 300), (680, 300)]))
        self.frames(car, 900, throttle=1)
        self.assertAlmostEqual(car.speed, 680 / (3.5 * 3.7) * 0.33, delta=0.3)
        self.assertEqual((car.gear, car.state.gear), (1, 1))
        self.frames(car, 300, brake=0.5, gear=0)
        self.frames(car, 120, throttle=0.5, gear=-1)
        self.assertLess(car.speed, -1)

    def test_it_steers_to_the_left(self):
        car = self.car()
        self.frames(car, 120, throttle=0.4, steer=0.3)
        self.assertGreater(car.wheels[0].state.steer, 0.1)
        self.assertGreater(car.chassis.position[0], 0.1)  # left of +z is +x

    def test_back_in_time(self):
        car = self.car()
        self.frames(car, 30, throttle=1)
        saved, world = car.save(), self.world.save()
        self.frames(car, 60, throttle=1, steer=0.2)
        after, hash_ = car.save(), self.world.hash
        car.restore(saved)
        self.world.restore(world)
        self.frames(car, 60, throttle=1, steer=0.2)
        self.assertEqual((car.save(), self.world.hash), (after, hash_))

    def test_settings_are_the_descriptors(self):
        car = self.car()
        settings = car.settings
        self.assertEqual((settings["gears"], settings["final_drive"], len(settings["torque_curve"]), settings["automatic"]),
                         ((3.5, 2.1, 1.4, 1.05, 0.85), 3.7, 4, True))
        again = carom.Vehicle(car.chassis, [wheel.settings for wheel in car.wheels], **{**settings, "final_drive": 4})
        self.assertEqual(again.settings, {**settings, "final_drive": 4})
        self.assertEqual([w.settings for w in again.wheels], [w.settings for w in car.wheels])
        self.assertEqual(car.wheels[0].settings["anti_roll_partner"], raw.CAROM_NO_WHEEL)

    def test_what_is_refused_changes_nothing(self):
        car = self.car()
        before, settings = car.save(), car.settings
        for error, call in (
                (TypeError, lambda: car.update(gear_ratios=[1])), (ValueError, lambda: car.update(gears=[])),
                (ValueError, lambda: car.update(gears=range(1, 10))), (ValueError, lambda: car.update(torque_curve=[(1, 2, 3)])),
                (TypeError, lambda: car.wheels[0].update(radius="0.3")), (errors.OutOfRange, lambda: car.drive(DT, throttle=2)),
                (errors.OutOfRange, lambda: car.drive(DT, gear=7)), (TypeError, lambda: car.drive(DT, steer="left")),
                (ValueError, lambda: carom.Vehicle(car.chassis, [])), (ValueError, lambda: carom.Vehicle(car.chassis, [{}] * 17)),
                (TypeError, lambda: carom.Vehicle(None, [{}])), (ValueError, lambda: car.restore(before + b"0")),
                (errors.OutOfRange, lambda: carom.Vehicle(self.ground, [{}]).drive())):
            with self.subTest(error=error), self.assertRaises(error):
                call()
        self.assertEqual((car.save(), car.settings), (before, settings))
        car.chassis.destroy()
        with self.assertRaises(errors.StaleHandle):
            car.drive()


if __name__ == "__main__":
    unittest.main()
