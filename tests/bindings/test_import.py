"""Importing: without numpy all but arrays works; a library that does not fit is refused, and the text says where and what to do."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

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


class SystemLibrary(unittest.TestCase):
    def test_found_by_its_name(self):
        """As a distribution installs it: the loader finds the library, and shapes lie beside it."""
        library, plugins = os.environ["CAROM_LIBRARY"], os.environ["CAROM_PLUGIN_DIR"]
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "carom").mkdir()
            import carom
            shutil.copy(Path(library).resolve(), Path(folder, carom.raw.SONAME))
            Path(folder, "carom", "plugins").symlink_to(plugins)
            environment = {**os.environ, "LD_LIBRARY_PATH": folder}
            for name in ("CAROM_LIBRARY", "CAROM_PLUGIN_DIR"):
                environment.pop(name)
            code = "import carom; print(carom.Engine().sphere(1).params)"
            done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment)
            self.assertEqual((done.stdout, done.stderr), ("(1.0,)\n", ""))


class BadLibrary(unittest.TestCase):
    def refused(self, library, why):
        done = subprocess.run([sys.executable, "-c", "import carom"], capture_output=True, text=True,
                              env={**os.environ, "CAROM_LIBRARY": str(library)})
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr.splitlines()[-1], "^ImportError: .*" + why)

    def test_none(self):
        self.refused("/no/such/libcarom.so", "set CAROM_LIBRARY")

    def test_another(self):
        self.refused("libc.so.6", "older than this package: it lacks carom_.* Install libcarom")

    def test_another_machine(self):
        """Of a processor or a C library that are not here: file and cure."""
        import carom
        image = Path(carom.raw.LIBRARY).read_bytes()
        newest = max(re.findall(rb"GLIBC_2\.(\d\d)\0", image), default=None)
        if not newest:
            self.skipTest("the library is not of this C library")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, carom.raw.SONAME)
            for changed in (image[:18] + b"\xf3\x00" + image[20:], image.replace(b"GLIBC_2." + newest, b"GLIBC_9." + newest)):
                file.write_bytes(changed)
                self.refused(file, f"{file}.*Install the wheel, or set CAROM_LIBRARY")

    def test_another_layout(self):
        """The library itself, but for one word of the layout that it tells: a double that is said to be a float."""
        image = Path(os.environ["CAROM_LIBRARY"]).read_bytes()
        row = next(line for line in image[image.index(b"carom_contact.separation "):].splitlines())
        self.assertTrue(row.endswith(b" 8 f64"), row)
        self.assertEqual(image.count(row), 1)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "libcarom.so")
            path.write_bytes(image.replace(row, row.replace(b" 8 f64", b" 4 f32")))
            self.refused(path, "disagree: field separation of carom_contact is f32 of 4 bytes .* f64 of 8 bytes .* Install")


if __name__ == "__main__":
    unittest.main()
