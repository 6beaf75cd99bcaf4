"""carom.gym: what Gymnasium asks of environments; episodes that follow from their seeds; the three ways to begin anew.

Needs gymnasium and numpy, and is skipped without them.
"""
import re
import subprocess
import sys
import unittest
import warnings
from pathlib import Path

SKIPPED = 77  # what CTest takes for skipped
try:
    import gymnasium
    import numpy as np
    from gymnasium.utils.env_checker import check_env
except ImportError as why:
    print(f"skipped: {why} (pip install gymnasium)")
    sys.exit(SKIPPED)

import carom.gym
from carom.gym import AutoresetMode, VectorEnv


class Short(carom.gym.CartPole):
    """Ends soon, in both ways."""
    longest = 6


def run(envs, steps, seed=3, strength=1.0):
    """Observations, rewards and ends of random actions, which belong to the number of the environment."""
    found = [envs.reset(seed=seed)[0].copy()]
    for step in range(steps):
        actions = np.stack([np.random.default_rng((k, step)).uniform(-strength, strength, envs.single_action_space.shape) for k in range(envs.num_envs)])
        observations, rewards, terminated, truncated, _ = envs.step(actions)
        found += [observations.copy(), rewards.copy(), terminated | truncated]
    return found


class Tasks(unittest.TestCase):
    def test_check_env_has_nothing_to_say(self):
        for name in carom.gym.TASKS:
            with self.subTest(name), warnings.catch_warnings():
                warnings.simplefilter("error")
                env = gymnasium.make(f"carom/{name}-v0", disable_env_checker=True)
                check_env(env.unwrapped, skip_render_check=True)
                env.close()

    def test_each_goes_on_finite_and_ends_by_its_time(self):
        for name, task in carom.gym.TASKS.items():
            with self.subTest(name):
                short = type(name, (task,), {"longest": 8})
                envs = VectorEnv(short, 3)
                self.addCleanup(envs.close)
                ends = np.zeros(3, int)
                envs.reset(seed=1)
                for step in range(10):
                    observations, rewards, terminated, truncated, _ = envs.step(envs.action_space.sample() * 0.2)
                    self.assertTrue(np.isfinite(observations).all() and np.isfinite(rewards).all())
                    self.assertIn(observations, envs.observation_space)
                    ends += terminated | truncated
                self.assertTrue((ends >= 1).all())

    def test_a_quadruped_stands_wherever_it_begins(self):
        envs = VectorEnv("Quadruped", 6, autoreset_mode="Disabled")
        self.addCleanup(envs.close)
        envs.reset(seed=4)
        for _ in range(100):
            observations, _, terminated, _, _ = envs.step(np.zeros(envs.action_space.shape))
        self.assertFalse(terminated.any())
        self.assertLess(np.abs(envs.task.motion.array).max(), 0.3)
        below = observations[:, -9]  # m: what the first ray down from the trunk meets
        self.assertTrue(((below > 0.2) & (below < 0.45)).all(), below)
        self.assertGreater(np.ptp(envs.task.pose.array[:, 0, 1]), 0.02)  # on other hills

    def test_what_is_good_is_better(self):
        """A cart that is pushed under its pole holds it longer than one that is left alone; a throw at the right speed gets farther."""
        envs = VectorEnv("CartPole", 8, autoreset_mode="Disabled")
        self.addCleanup(envs.close)
        lasted = []
        for gain in (0.0, 1.0):
            observations, _ = envs.reset(seed=5)
            n = 0
            for n in range(150):
                pushes = gain * (8 * observations[:, 1] + 2 * observations[:, 3] + 0.4 * observations[:, 0] + 0.8 * observations[:, 2])
                observations, _, terminated, truncated, _ = envs.step(-np.clip(pushes, -1, 1)[:, None])
                if (terminated | truncated).any():
                    break
            lasted.append(n)
        self.assertGreater(max(lasted), 140)
        self.assertLess(min(lasted), 100)
        throws = VectorEnv("Throw", 2, autoreset_mode="Disabled")
        self.addCleanup(throws.close)
        throws.reset(seed=1)
        rewards = throws.step(np.array([[-1, -1, 0, 0], [0.2, 0.7, 0, 0]]))[1]
        self.assertGreater(rewards[1], rewards[0] + 1)


class Seeds(unittest.TestCase):
    def test_an_episode_follows_from_its_seed_alone(self):
        for name in ("CartPole", "Ant", "Quadruped"):
            with self.subTest(name):
                whole, threaded, one = VectorEnv(name, 4), VectorEnv(name, 4, threads=3), VectorEnv(name, 1)
                for envs in (whole, threaded, one):
                    self.addCleanup(envs.close)
                want = run(whole, 12)
                self.assertTrue(all(map(np.array_equal, want, run(threaded, 12))))
                self.assertTrue(all(np.array_equal(a[:1], b) for a, b in zip(want, run(one, 12))))
                self.assertTrue(all(map(np.array_equal, want, run(whole, 12))))  # once more, after others
                self.assertFalse(np.array_equal(want[0][0], want[0][1]))
                self.assertFalse(np.array_equal(whole.reset()[0], want[0]))  # without a seed it goes on


class Anew(unittest.TestCase):
    def envs(self, mode):
        made = VectorEnv(Short, 3, autoreset_mode=mode)
        self.addCleanup(made.close)
        made.reset(seed=[1, 2, 3])
        return made

    def test_with_the_next_action(self):
        envs = self.envs(AutoresetMode.NEXT_STEP)
        rest = np.zeros((3, 1))
        for _ in range(6):
            last, _, _, truncated, _ = envs.step(rest)
        self.assertTrue(truncated.all())
        first, rewards, terminated, truncated, _ = envs.step(rest + 1)
        self.assertTrue((rewards == 0).all() and not (terminated | truncated).any())
        self.assertTrue((np.abs(first) <= 0.05).all() and not np.array_equal(first, last))
        self.assertTrue((envs.step(rest)[1] == 1).all())

    def test_at_once_with_the_end_beside(self):
        envs, twin = self.envs(AutoresetMode.SAME_STEP), self.envs(AutoresetMode.NEXT_STEP)
        rest = np.zeros((3, 1))
        for _ in range(6):
            first, rewards, _, truncated, infos = envs.step(rest)
            last = twin.step(rest)[0]
        self.assertTrue(truncated.all() and (rewards == 1).all() and infos["_final_obs"].all())
        self.assertTrue(all(map(np.array_equal, infos["final_obs"], last)))
        self.assertTrue(np.array_equal(first, twin.step(rest)[0]))
        self.assertNotIn("final_obs", envs.step(rest)[4])

    def test_by_the_host(self):
        envs = self.envs(AutoresetMode.DISABLED)
        rest = np.zeros((3, 1))
        for _ in range(6):
            last = envs.step(rest)[0].copy()
        with self.assertRaisesRegex(RuntimeError, r"\[0, 1, 2\]"):
            envs.step(rest)
        some = envs.reset(options={"reset_mask": np.array([True, False, False])})[0]
        self.assertFalse(np.array_equal(some[0], last[0]))
        self.assertTrue(np.array_equal(some[1:], last[1:]))
        for mask in ([True, True, True], np.array([1, 1, 1]), np.zeros(3, bool), np.ones(2, bool)):
            with self.assertRaises(ValueError):
                envs.reset(options={"reset_mask": mask})

    def test_a_fault_ends_its_episode(self):
        envs = self.envs(AutoresetMode.NEXT_STEP)
        speed = envs.batch.column("bodies", "linear_velocity", [envs.task.joints()[0].desc.body_b])
        speed.array[1] = 1e12
        envs.batch.write(speed, mask=np.array([False, True, False]))
        observations, _, terminated, _, infos = envs.step(np.zeros((3, 1)))
        self.assertEqual((terminated.tolist(), infos["fault"].tolist()), ([False, True, False],) * 2)
        _, _, terminated, _, infos = envs.step(np.zeros((3, 1)))
        self.assertFalse(terminated.any() or infos.get("fault", np.zeros(3)).any())


class Refused(unittest.TestCase):
    def test_what_is_no_action_seed_or_task(self):
        envs = VectorEnv("CartPole", 2)
        self.addCleanup(envs.close)
        envs.reset(seed=1)
        with self.assertRaisesRegex(ValueError, "row 1"):
            envs.step(np.array([[0.0], [np.nan]]))
        for wrong in (np.zeros((1, 1)), np.zeros(2)):
            with self.assertRaises(ValueError):
                envs.step(wrong)
        for seed in (-1, [1], [1, -2]):
            with self.assertRaises(ValueError):
                envs.reset(seed=seed)
        with self.assertRaisesRegex(ValueError, "CartPole"):
            VectorEnv("Cartpole", 2)
        with self.assertRaises(TypeError):
            VectorEnv(3, 2)
        with self.assertRaises(ValueError):
            VectorEnv("CartPole", 2, render_mode="human")


class Page(unittest.TestCase):
    def test_the_program(self):
        text = (Path(__file__).resolve().parents[2] / "src/site/docs/topics/batches.md").read_text(encoding="utf-8")
        program = re.findall(r"```python\n(.*?)```", text, re.S)[1]
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr, done.stdout), (0, "", "(64, 27) (64,)\n"))


if __name__ == "__main__":
    unittest.main()
