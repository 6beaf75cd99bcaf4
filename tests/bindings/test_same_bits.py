"""The same scene from C and from Python gives the same bits; so does a shape whose support function is Python."""
import os
import subprocess
import unittest

import carom
import scene


class SameBits(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = os.environ["CAROM_PLUGIN_DIR"]
        done = subprocess.run([os.environ["CAROM_SCENE"], folder], capture_output=True, text=True, check=True)
        cls.of_c = done.stdout.split()

    def test_scene(self):
        self.assertEqual(len(set(self.of_c)), 3)  # it moves
        with carom.Engine() as engine:
            self.assertEqual(scene.hashes(engine, engine.shape("carom.template", (0.35, 0.4))), self.of_c)

    def test_scene_on_two_threads(self):
        with carom.Engine(threads=2) as engine:
            self.assertEqual(scene.hashes(engine, engine.shape("carom.template", (0.35, 0.4))), self.of_c)

    def test_shape_written_in_python(self):
        calls = []

        def counted(params, direction):
            calls.append(None)
            return scene.top_support(params, direction)

        with carom.Engine() as engine:
            top = engine.support_plugin(counted, "test.top", params=scene.TOP_PARAMS)
            made = len(calls)
            self.assertEqual(scene.hashes(engine, top(0.35, 0.4)), self.of_c)
            self.assertGreater(len(calls), made + 1000)  # the scene really asked it

    def test_another_shape_gives_other_bits(self):
        with carom.Engine() as engine:
            self.assertNotEqual(scene.hashes(engine, engine.shape("carom.template", (0.35, 0.41)))[2], self.of_c[2])


if __name__ == "__main__":
    unittest.main()
