"""What is gone raises; nothing crashes, in whatever order things go."""
import gc
import subprocess
import sys
import threading
import unittest
import weakref

import carom
from carom import errors


class Gone(unittest.TestCase):
    def test_world_closed(self):
        with carom.Engine() as engine:
            with engine.world() as world:
                ball = world.body(engine.sphere(0.5), position=(0, 1, 0))
            self.assertTrue(world.closed)
            for use in (lambda: world.step(), lambda: ball.position, lambda: ball.add_force((1, 0, 0)), lambda: world.contacts(),
                        lambda: world.dials["substeps"], lambda: world.body(), lambda: world.positions(), ball.destroy):
                with self.assertRaisesRegex(carom.Closed, "this world was closed. Remedy"):
                    use()
            world.close()  # twice is once

    def test_engine_closes_its_worlds(self):
        engine = carom.Engine()
        worlds = [engine.world(), engine.world()]
        ball = engine.sphere(1)
        engine.close()
        self.assertTrue(all(world.closed for world in worlds))
        for use in (engine.world, lambda: engine.box(1, 1, 1), lambda: ball.info, worlds[0].step):
            with self.assertRaises(carom.Closed):
                use()

    def test_body_destroyed(self):
        with carom.Engine() as engine, engine.world() as world:
            body = world.body(engine.sphere(0.5))
            same = carom.Body(world, body.handle)
            self.assertEqual({body}, {same})
            body.destroy()
            with self.assertRaises(errors.StaleHandle):
                same.position
            self.assertRaises(ReferenceError, body.destroy)
            self.assertNotEqual(world.body(), body)  # a new one in its slot is another

    def test_handles_of_others(self):
        with carom.Engine() as engine, engine.world() as one, engine.world() as other:
            body = one.body()
            with self.assertRaises(errors.WrongWorld):
                carom.Body(other, body.handle).position
            with self.assertRaises(errors.WrongKind):
                carom.Body(one, engine.sphere(1).handle).position
            with self.assertRaises(errors.InvalidHandle):
                carom.Body(one, 0).position

    def test_shape_in_use(self):
        with carom.Engine() as engine, engine.world() as world:
            shape = engine.sphere(0.5)
            body = world.body(shape)
            self.assertRaises(errors.InUse, shape.destroy)
            body.destroy()
            shape.destroy()

    def test_failed_body_leaves_nothing(self):
        with carom.Engine() as engine, engine.world() as world:
            with self.assertRaises(ValueError):
                world.body(engine.half_space(), type="dynamic")  # a half-space is for static bodies
            self.assertEqual(world.body_count(), 0)
            self.assertRaises(KeyError, engine.world, substep=3)
        self.assertRaises(carom.Closed, engine.world)


class Collected(unittest.TestCase):
    """Without close(): Python's collector finds all of it, in orders of its own."""

    def make(self, cycle):
        engine = carom.Engine()
        calls = []
        shape = engine.support_plugin(lambda p, d: (calls.append(0), (0.0, 0.0, 0.0))[1], "test.point")
        world = engine.world()
        body = world.body(mass=1)
        world.step()
        if cycle:
            engine.me, world.me, body.world.body_of_mine, engine.world_of_mine = engine, world, body, world
        return engine, world, shape

    def test_orders(self):
        for cycle in (False, True):
            for order in ((0, 1, 2), (1, 0, 2), (2, 1, 0), (0, 2, 1)):
                things = list(self.make(cycle))
                owners = [weakref.ref(things[0]._owner), weakref.ref(things[1]._owner)]
                for i in order:
                    things[i] = None
                    gc.collect()
                self.assertEqual([owner() for owner in owners], [None, None], (cycle, order))

    def test_world_keeps_its_engine(self):
        world = carom.Engine().world()
        gc.collect()
        world.body(mass=1)
        world.step()
        body = world.body()
        del world
        gc.collect()
        self.assertEqual(body.position, (0, 0, 0))

    def test_destroyed_for_good(self):
        """The library refuses to destroy an engine that has worlds (InUse): forgotten ones are none."""
        engine, kept = carom.Engine(), []
        for _ in range(100):
            kept.append(engine.world())
        self.assertEqual(carom.raw.carom_engine_destroy(engine._pointer, None), carom.raw.CAROM_E_IN_USE)
        kept.clear()
        gc.collect()
        self.assertEqual(len(engine._worlds), 0)
        engine.close()

    def test_at_exit(self):
        code = "import carom; e = carom.Engine(); w = e.world(); s = e.sphere(1); b = w.body(s); w.step(); w.me = w"
        done = subprocess.run([sys.executable, "-X", "dev", "-c", code], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


class Misused(unittest.TestCase):
    def test_close_while_stepping(self):
        """Another thread is in a step, for certain: it waits there, in a support function, until we have tried."""
        entered, tried = threading.Event(), threading.Event()

        def support(params, direction):
            if threading.current_thread() is stepper:
                entered.set()
                tried.wait(10)
            return tuple(0.5 if x >= 0 else -0.5 for x in direction)

        stepper = None
        with carom.Engine() as engine, engine.world() as world:
            shape = engine.support_plugin(support, "test.slow")()
            world.ground()
            world.body(shape, position=(0, 0.5, 0))
            stepper = threading.Thread(target=world.step)
            stepper.start()
            self.assertTrue(entered.wait(10))
            self.assertRaises(errors.Busy, world.close)
            self.assertRaises(errors.Busy, engine.close)
            self.assertRaises(errors.Busy, world.step)
            self.assertRaises(errors.Busy, lambda: world.gravity)
            tried.set()
            stepper.join()
            self.assertFalse(world.closed)
            world.step()

    def test_call_from_a_support_function(self):
        seen = []

        def support(params, direction):
            try:
                world.step()
            except carom.CaromError as refused:
                seen.append(type(refused))
            return tuple(0.5 if x >= 0 else -0.5 for x in direction)

        with carom.Engine() as engine, engine.world() as world:
            engine.support_plugin(support, "test.reentrant")()
        self.assertEqual(set(seen), {errors.Reentrant})


if __name__ == "__main__":
    unittest.main()
