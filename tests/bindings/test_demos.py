"""The demonstrations of bindings/python/demos, each for a short while, and what their page says of them.

Needs numpy, and is skipped without it.
"""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SKIPPED = 77  # what CTest takes for skipped
try:
    import numpy  # noqa: F401
except ImportError as why:
    print(f"skipped: {why} (Debian: python3-numpy)")
    sys.exit(SKIPPED)

ROOT = Path(__file__).resolve().parents[2]
DEMOS = ROOT / "bindings/python/demos"
PAGE = (ROOT / "src/site/docs/topics/demonstrations.md").read_text(encoding="utf-8")
NIGHTLY = os.environ.get("CAROM_NIGHTLY") == "1"
STILL = "import carom; carom.raw.carom_world_step = carom.raw.carom_batch_step = lambda *_: 0; "

SMOOTH = "import carom; rough = carom.World.material; carom.World.material = lambda world, **about: rough(world, friction=0.0); "


class Demos(unittest.TestCase):
    def run_one(self, name, *arguments, still=""):
        with tempfile.TemporaryDirectory() as folder:
            picture = Path(folder) / "seen.svg"
            program = f"{still}import runpy, sys; sys.argv = {[name, *map(str, arguments), '--picture', str(picture)]!r}; runpy.run_path({str(DEMOS / name)!r}, run_name='__main__')"
            done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
            if not still and not done.returncode:
                self.assertRegex(picture.read_text(encoding="utf-8"), "<polygon|<circle")
            return done

    def good(self, name, *arguments):
        done = self.run_one(name, *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        return done.stdout

    def test_a_hand_holds_a_ball(self):
        said = self.good("hand.py", "--seconds", 3600 if NIGHTLY else 3)
        self.assertIn("at y = 0.090 m", said)
        self.assertIn("it slips", self.run_one("hand.py", "--seconds", 1, still=SMOOTH).stderr)

    def test_a_linkage_draws_a_line(self):
        self.assertIn("0.764 m", self.good("linkage.py", "--seconds", 600 if NIGHTLY else 3))
        self.assertIn("it is no line", self.run_one("linkage.py", "--seconds", 1, still=STILL).stderr)

    def test_contacts_without_a_limit(self):
        self.good("contacts.py", "--balls", 2000 if NIGHTLY else 400)

    def test_worlds_alike(self):
        said = self.good("worlds.py", "--worlds", 16)
        found = re.findall("hash ([0-9a-f]{16})", said)
        self.assertEqual((len(found), len(set(found))), (4, 1), said)

    def test_two_platforms(self):
        done = self.run_one("rollout.py", "--steps", 2400)
        if done.returncode == SKIPPED:
            self.skipTest(done.stdout.strip())
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)

    def test_the_page_shows_each(self):
        for file in sorted(DEMOS.glob("*.py")):
            self.assertIn(f"bindings/python/demos/{file.name}", PAGE)
            self.assertIn(f"demos/{file.stem}.svg", PAGE)


if __name__ == "__main__":
    unittest.main()
