"""Worlds saved, restored, forked, compared and recorded from Python."""
import io
import unittest

import carom


def heap(engine):
    world = engine.world()
    world.ground()
    bodies = [world.body(engine.box(0.4, 0.25, 0.3), position=(0.2 * i, 1 + 0.6 * i, 0), user=i) for i in range(5)]
    world.joint("ball", bodies[0], bodies[4], position=(0.4, 2.2, 0))
    return world, bodies


def onward(world, steps=40):
    hashes = []
    for _ in range(steps):
        world.step(1 / 60)
        hashes.append(world.hash)
    return hashes


class Snapshots(unittest.TestCase):
    def setUp(self):
        self.engine = carom.Engine()
        self.addCleanup(self.engine.close)
        self.world, self.bodies = heap(self.engine)
        onward(self.world, 20)

    def test_a_state_goes_back(self):
        state = self.world.save()
        self.assertIsInstance(state, bytes)
        first = onward(self.world)
        self.world.restore(state)
        self.assertEqual(first, onward(self.world))
        with self.assertRaises(carom.errors.Corrupt):
            self.world.restore(state[:-1])
        with self.assertRaises(carom.errors.Mismatch):
            self.engine.world().restore(state)

    def test_a_whole_world_is_made_elsewhere(self):
        whole = self.world.save(whole=True)
        with carom.Engine() as other:
            with other.world() as world:
                with self.assertRaises(carom.errors.NotFound) as caught:
                    world.restore(whole)
                self.assertIn("carom.box version 1", caught.exception.message)
                other.box(1, 1, 1)  # loads the plugin
                world.restore(bytearray(whole))
                self.assertEqual(world.save(whole=True), whole)
                there = world.counterpart(self.bodies[3])
                self.assertEqual((there.desc.user, there.position), (3, self.bodies[3].position))
                self.assertEqual(onward(world), onward(self.world))

    def test_a_fork_goes_its_own_way(self):
        before = self.world.save()
        copy = self.world.fork()
        ahead = onward(copy)
        self.assertIsNone(self.world.compare(before))
        self.assertEqual(onward(self.world), ahead)
        body = copy.counterpart(self.bodies[2])
        body.linear_velocity = 0, 5, 0
        self.assertEqual(len(copy.bodies), len(self.world.bodies))
        difference = copy.compare(self.world.save())
        self.assertEqual((difference.sections[0], difference.first), ("bodies", body))
        self.bodies[2].destroy()
        with self.assertRaises(carom.errors.StaleHandle):
            self.world.counterpart(body)
        copy.close()

    def test_a_session_is_recorded(self):
        file = io.BytesIO()
        with self.world.record(file, states=True) as recording:
            self.world.gravity = 0, -5, 0
            onward(self.world, 3)
            with self.assertRaises(carom.errors.InUse):
                self.world.record(io.BytesIO())
        recording.end()  # again does nothing
        data = file.getvalue()
        self.assertTrue(data.startswith(b"CAROMREC"))
        self.assertIn(b"carom_world_set_gravity", data)
        self.assertIn(b"carom_world_step", data)
        with self.world.record(io.BytesIO()):
            pass

    def test_a_file_that_fails(self):
        class Full(io.BytesIO):
            def write(self, data):
                if self.tell() > 3000:
                    raise OSError("no room")
                return super().write(data)
        recording = self.world.record(Full(), states=True)
        onward(self.world, 10)
        with self.assertRaises(carom.errors.WriteFailed) as caught:
            recording.end()
        self.assertIsInstance(caught.exception.__cause__, OSError)
        left = self.world.record(io.BytesIO())  # ended by the world
        self.world.close()
        del left


if __name__ == "__main__":
    unittest.main()
