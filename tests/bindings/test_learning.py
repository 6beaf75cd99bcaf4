"""bindings/python/learning/throw.py: one update of a policy changes it, alike for a seed; what stable-baselines3 asks of environments; the curve.

Needs stable-baselines3 and gymnasium, and is skipped without them (pip install gymnasium stable-baselines3).
"""
import sys
import unittest
from pathlib import Path

SKIPPED = 77  # what CTest takes for skipped
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bindings/python/learning"))
try:
    import carom.gym
    import numpy as np
    import throw
    import torch
except ImportError as why:
    print(f"skipped: {why} (pip install gymnasium stable-baselines3)")
    sys.exit(SKIPPED)

torch.set_num_threads(1)


class Short(carom.gym.Throw):
    steps = 60


class Learning(unittest.TestCase):
    def updated(self, seed):
        worlds = throw.Worlds(Short, 8, seed)
        self.addCleanup(worlds.close)
        model = throw.learner(worlds, seed)
        model.learning_starts = 16
        before = [p.detach().clone() for p in model.policy.parameters()]
        model.learn(24)
        return before, [p.detach().clone() for p in model.policy.parameters()]

    def test_one_update(self):
        before, after = self.updated(1)
        self.assertTrue(any((a != b).any() for a, b in zip(before, after)))
        self.assertTrue(all(torch.isfinite(p).all() for p in after))
        self.assertTrue(all(map(torch.equal, after, self.updated(1)[1])))  # the same seed, the same policy

    def test_what_a_learner_is_told(self):
        """Where an episode ends the next begins at once, and its end stands beside."""
        worlds, twin = throw.Worlds(Short, 3, 5), carom.gym.VectorEnv(Short, 3)
        self.addCleanup(worlds.close)
        self.addCleanup(twin.close)
        first = worlds.reset()
        np.testing.assert_array_equal(first, twin.reset(seed=5)[0].astype(np.float32))
        actions = np.array([[0.1, 0, 0, 0], [0.3, 0.2, 0, 0], [-0.5, 0, 0.1, 0]])
        worlds.step_async(actions)
        seen, rewards, ends, told = worlds.step_wait()
        last, theirs, _, _, _ = twin.step(actions)
        np.testing.assert_array_equal(rewards, theirs.astype(np.float32))
        self.assertTrue(ends.all())
        for k in range(3):
            np.testing.assert_array_equal(told[k]["terminal_observation"], last[k].astype(np.float32))
            self.assertFalse(told[k]["TimeLimit.truncated"])
        self.assertFalse(np.array_equal(seen, first))

    def test_the_curve(self):
        rows = [(0, 0.5, 2.0, -1.5, 1.0), (256, 0.75, 1.0, 0.0, 2.0), (512, 1.0, 0.25, 0.75, 3.0)]
        drawn = throw.curve([rows])
        self.assertEqual(drawn.count("<polyline"), 2)
        self.assertIn('points="60.0,30.0 340.0,95.0 620.0,143.8"', drawn)  # m from the basket
        self.assertIn('points="60.0,275.0 340.0,242.5 620.0,210.0"', drawn)  # share over the wall


if __name__ == "__main__":
    unittest.main()
