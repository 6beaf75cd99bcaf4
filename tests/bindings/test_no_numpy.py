"""Everything but arrays works where there is no numpy; what needs it says so."""
import subprocess
import sys
import unittest

CODE = """
import sys
sys.modules["numpy"] = None  # importing it fails
import array, carom
with carom.Engine() as engine, engine.world() as world:
    world.ground()
    balls = [world.body(engine.sphere(0.5), position=(2 * i, 1, 0)) for i in range(3)]
    carom.run(world, 1)
    rows = world.positions()
    assert isinstance(rows, array.array) and len(rows) == 12 and tuple(rows[3:6]) == balls[0].position
    assert list(world.body_handles())[1:] == [b.handle for b in balls]
    out = array.array("f", bytes(4 * 9))
    world.read("position", balls, out=out)
    assert abs(out[4] - 0.5) < 0.01
    world.write("position", [(0, 9, 0)], balls[:1])
    assert balls[0].position == (0, 9, 0)
    assert world.ray((0, 20, 0), (0, -1, 0)).body == balls[0]
    assert len(world.contacts()) == 3
    engine.mesh([(0, 0, 0), (0, 0, 1), (1, 0, 0)], [(0, 1, 2)])
    engine.height_field([[0, 0], [0, 1]])
    for use in (world.contact_array, lambda: world.rays([(0, 0, 0)], (0, 1, 0)), lambda: world.create_bodies([(0, 0, 0)]),
                lambda: engine.support(engine.sphere(1), [(1, 0, 0)])):
        try:
            use()
        except ImportError as missing:
            assert "needs numpy" in str(missing), missing
        else:
            raise AssertionError(use)
print("done")
"""


class NoNumpy(unittest.TestCase):
    def test_all_but_arrays(self):
        done = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True)
        self.assertEqual((done.stdout, done.stderr), ("done\n", ""))

    def test_bad_library(self):
        """What is no library of Carom's, or none at all, is an ImportError that says what to do."""
        for path, why in [("/no/such/libcarom.so.1", "set CAROM_LIBRARY"), ("libc.so.6", "older than this package: it lacks carom_")]:
            done = subprocess.run([sys.executable, "-c", "import os; os.environ['CAROM_LIBRARY'] = %r; import carom" % path],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr.splitlines()[-1], "^ImportError: .*" + why)


if __name__ == "__main__":
    unittest.main()
