"""carom.tune(): asks the command about a world of this program. Skipped where the tools were not built."""
import math
import os
import shutil
import unittest
from pathlib import Path

import carom
from carom.tune import Setting

TOOL = os.environ.get("CAROM_TOOL") or str(Path(os.environ.get("CAROM_LIBRARY", "/")).parent.parent / "bin" / "carom")


@unittest.skipUnless(shutil.which(TOOL), "the command carom is not built")
class Tune(unittest.TestCase):
    def setUp(self):
        self.engine = carom.Engine()
        self.addCleanup(self.engine.close)
        self.world = self.engine.world()
        self.world.ground()
        for i in range(4):
            self.world.body(self.engine.box(0.5, 0.5, 0.5), position=(0.01 * i, 0.5 + i, 0))

    def test_the_pick_is_on_the_front_and_can_be_applied(self):
        before = self.world.hash
        found = carom.tune(self.world, budget_ms=5, seconds=1, within=3, tool=TOOL)
        self.assertEqual(before, self.world.hash)
        self.assertIn(found.pick, found.front)
        self.assertEqual("m", found.unit)
        self.assertEqual(1, found.seconds)
        for cheap, dear in zip(found.front, found.front[1:]):
            self.assertLess(cheap.ms, dear.ms)
            self.assertLess(dear.error, cheap.error)
        self.assertTrue(math.isfinite(found.pick.error) and found.pick.ms <= 5)
        for setting in found.front:
            setting.apply(self.world)
            for name, value in setting.dials.items():
                self.assertEqual(value if isinstance(self.world.dials[name], str) else float(value), self.world.dials[name])
        self.world.step(1 / 60)

    def test_what_goes_wrong_is_said(self):
        with self.assertRaisesRegex(FileNotFoundError, "CAROM_TOOL"):
            carom.tune(self.world, tool="/no/such/carom")
        with self.assertRaisesRegex(RuntimeError, "--budget"):
            carom.tune(self.world, budget_ms=-1, tool=TOOL)
        with self.assertRaisesRegex(RuntimeError, "pose"):
            carom.tune(self.world, error="prose", tool=TOOL)

    def test_presets_are_applied(self):
        for name, substeps in (("fast", 1), ("accurate", 8)):
            Setting(1, {}, name, 0, 0, 0).apply(self.world)
            self.assertEqual(substeps, self.world.dials["substeps"])


if __name__ == "__main__":
    unittest.main()
