"""The wheel, built as `python_wheel` builds it and unpacked as pip unpacks it, works with nothing else around."""
import os
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings" / "python"))
from build_wheel import build, soname  # noqa: E402

PROGRAM = """
import carom
assert carom.raw.LIBRARY.startswith(SITE), carom.raw.LIBRARY
with carom.Engine() as engine, engine.world() as world:
    world.ground()
    shapes = [engine.sphere(0.5), engine.box(0.5, 0.5, 0.5), engine.capsule(0.3, 0.2), engine.cylinder(0.3, 0.5), engine.cone(0.3, 0.5),
              engine.ellipsoid(0.3, 0.4, 0.5), engine.hull([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])]
    bodies = [world.body(shape, position=(3 * i, 1, 0)) for i, shape in enumerate(shapes)]
    carom.run(world, 1)
    assert all(0 < body.position[1] < 0.6 for body in bodies[:6]), [body.position for body in bodies]
print(carom.__version__)
"""


class Wheel(unittest.TestCase):
    def test_wheel(self):
        with tempfile.TemporaryDirectory() as folder:
            wheel = build(os.environ["CAROM_LIBRARY"], os.environ["CAROM_PLUGIN_DIR"], folder)
            self.assertRegex(wheel.name, r"^carom-\d+\.\d+\.\d+-py3-none-linux_\w+\.whl$")
            names = zipfile.ZipFile(wheel).namelist()
            for needed in (f"carom/lib/{soname()}", "carom/lib/plugins/box.so", "carom/py.typed", "carom/raw.pyi", "carom/errors.pyi", "carom/robots/__init__.py"):
                self.assertIn(needed, names)
            self.assertFalse([name for name in names if "template" in name or "__pycache__" in name])
            site = Path(folder, "site")
            zipfile.ZipFile(wheel).extractall(site)
            done = subprocess.run([sys.executable, "-B", "-c", f"SITE = {str(site)!r}\n" + PROGRAM], capture_output=True, text=True,
                                  cwd=folder, env={"PYTHONPATH": str(site), "PATH": os.environ["PATH"]})
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn(done.stdout.strip(), wheel.name)

    def test_of_other_systems(self):
        """A wheel has the library under the name that the package asks for on that system, and plugins with its ending."""
        of_package = ("import importlib, sys, carom; sys.platform = sys.argv[1]\n"
                      "print(importlib.reload(carom.raw).FILE, importlib.reload(carom.engine).PLUGIN_SUFFIX)")
        for system, tag, built in (("win32", "win_amd64", "carom.dll"), ("darwin", "macosx_11_0_arm64", "libcarom.0.9.0.dylib"),
                                   ("linux", "linux_aarch64", "libcarom.so.0.9.0")):
            with self.subTest(system), tempfile.TemporaryDirectory() as folder:
                done = subprocess.run([sys.executable, "-B", "-c", of_package, system], capture_output=True, text=True)
                self.assertEqual(done.stderr, "")
                file, suffix = done.stdout.split()
                Path(folder, "plugins").mkdir()
                for name in (built, f"plugins/box{suffix}", f"plugins/template{suffix}"):
                    Path(folder, name).write_bytes(b"not run here")
                wheel = build(Path(folder, built), Path(folder, "plugins"), Path(folder, "made"), tag)
                self.assertTrue(wheel.name.endswith(f"-py3-none-{tag}.whl"), wheel.name)
                there = [name for name in zipfile.ZipFile(wheel).namelist() if name.startswith("carom/lib/")]
                self.assertEqual(sorted(there), sorted([f"carom/lib/{file}", f"carom/lib/plugins/box{suffix}"]))


if __name__ == "__main__":
    unittest.main()
