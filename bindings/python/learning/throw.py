#!/usr/bin/env python3
"""Learn to throw the bunny over the wall into the basket, by SAC of stable-baselines3 (pip install 'carom[gym]' stable-baselines3).

usage: throw.py [--throws N] [--seeds N] [--curve FILE.svg]

Wall and basket stand elsewhere in each episode. The policy sees where, and chooses velocity and spin. Every 256 throws it is judged by
128 others, without noise. --curve draws how good it was.
"""
import argparse
import time

import carom.gym
import numpy as np
from stable_baselines3 import SAC
from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.vec_env import VecEnv

WORLDS = 64   # thrown in at once
ROUND = 256  # throws between two judgements
JUDGES = 128  # throws that judge; of other seeds than those that teach


class Worlds(VecEnv):
    """What stable-baselines3 asks of many environments, over carom.gym.VectorEnv."""

    def __init__(self, task, count, seed, threads=1):
        self.envs = carom.gym.VectorEnv(task, count, threads=threads, autoreset_mode=carom.gym.AutoresetMode.SAME_STEP)
        super().__init__(count, self.envs.single_observation_space, self.envs.single_action_space)
        self.first, self.actions = seed, None

    def reset(self):
        observations, _ = self.envs.reset(seed=self.first)
        self.first = None  # once; from then on each world goes on with its own numbers
        return observations.astype(np.float32)

    def step_async(self, actions):
        self.actions = actions

    def step_wait(self):
        observations, rewards, terminated, truncated, infos = self.envs.step(self.actions)
        told = [{} for _ in range(self.num_envs)]
        for k in np.flatnonzero(infos.get("_final_obs", np.zeros(self.num_envs, bool))):
            told[k] = {"terminal_observation": infos["final_obs"][k].astype(np.float32), "TimeLimit.truncated": bool(truncated[k] and not terminated[k])}
        return observations.astype(np.float32), rewards.astype(np.float32), terminated | truncated, told

    def close(self):
        self.envs.close()

    def get_attr(self, name, indices=None):
        return [getattr(self.envs, name)] * len(self._get_indices(indices))

    def set_attr(self, name, value, indices=None):
        raise NotImplementedError(f"{name} is one for all worlds: set it on envs")

    def env_method(self, name, *arguments, indices=None, **about):
        return [getattr(self.envs, name)(*arguments, **about)] * len(self._get_indices(indices))

    def env_is_wrapped(self, wrapper_class, indices=None):
        return [False] * len(self._get_indices(indices))


def learner(worlds, seed):
    """An episode is one throw, so nothing follows from it: gamma 0."""
    return SAC("MlpPolicy", worlds, learning_starts=ROUND, train_freq=1, gradient_steps=16, batch_size=256, learning_rate=2e-3, gamma=0.0,
               ent_coef=0.01, policy_kwargs={"net_arch": [64, 64]}, seed=seed, device="cpu")


def judge(model, envs):
    """@return (share of throws over the wall, mean way from the basket where they end, m, mean reward)"""
    observations, _ = envs.reset(seed=10**6)
    actions, _ = model.predict(observations, deterministic=True)
    goal = observations.copy()
    _, rewards, _, _, _ = envs.step(actions)
    place = envs.task.place.array[:, 0]
    over = place[:, 0] > goal[:, 0]
    return float(over.mean()), float(np.hypot(place[:, 0] - goal[:, 2], place[:, 2]).mean()), float(rewards.mean())


class Judge(BaseCallback):
    def __init__(self, envs, begin):
        super().__init__()
        self.envs, self.begin, self.rows = envs, begin, []

    def _on_step(self):
        return True

    def _on_rollout_start(self):
        if self.num_timesteps >= ROUND * len(self.rows):
            self.rows.append((self.num_timesteps, *judge(self.model, self.envs), time.process_time() - self.begin))
            print("{:6d} throws: {:3.0%} over the wall, {:.2f} m from the basket, reward {:.2f} ({:.0f} s)".format(
                self.rows[-1][0], *self.rows[-1][1:]), flush=True)

    def _on_training_end(self):
        self._on_rollout_start()


def learn(throws, seed):
    """@return rows of (throws, share over the wall, m from the basket, reward, s of the processor)"""
    worlds, envs = Worlds("Throw", WORLDS, seed), carom.gym.VectorEnv("Throw", JUDGES, autoreset_mode=carom.gym.AutoresetMode.DISABLED)
    try:
        told = Judge(envs, time.process_time())
        learner(worlds, seed).learn(throws, callback=told)
        return told.rows
    finally:
        worlds.close()
        envs.close()


def curve(runs):
    """An SVG: a line for each run, of the way from the basket, and of the share over the wall."""
    left, right, top, height = 60, 620, 30, 130
    last = max(row[0] for rows in runs for row in rows)
    far = max(row[2] for rows in runs for row in rows)
    out = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 400" font-family="sans-serif" font-size="13" fill="#444">', '<rect width="640" height="400" fill="#fff"/>']
    for which, (title, most, unit) in enumerate((("from the basket", np.ceil(far), " m"), ("over the wall", 1.0, ""))):
        base = top + height + which * 180
        out.append(f'<text x="{left}" y="{base - height - 8}">{title}</text>')
        for step in range(5):
            y, value = base - height * step / 4, most * step / 4
            out.append(f'<path d="M{left} {y:.1f}H{right}" stroke="#e6e6e6"/>')
            out.append(f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">{f"{value:.0%}" if most == 1 and not unit else f"{value:g}{unit}"}</text>')
        for rows in runs:
            points = " ".join(f"{left + (right - left) * row[0] / last:.1f},{base - height * row[2 - which] / most:.1f}" for row in rows)
            out.append(f'<polyline points="{points}" fill="none" stroke="#2a6fdb" stroke-width="1.6" stroke-opacity="0.75"/>')
    for step in range(5):
        out.append(f'<text x="{left + (right - left) * step / 4:.1f}" y="360" text-anchor="middle">{last * step // 4:,}</text>')
    out += [f'<text x="{(left + right) / 2}" y="384" text-anchor="middle">throws</text>', "</svg>"]
    return "\n".join(out) + "\n"


def main():
    parser = argparse.ArgumentParser(description="Learn to throw the bunny over the wall.")
    parser.add_argument("--throws", type=int, default=16 * ROUND, help="how many teach it")
    parser.add_argument("--seeds", type=int, default=1, help="how many times, each from another seed")
    parser.add_argument("--curve", metavar="FILE.svg", help="draw how good it was")
    given = parser.parse_args()
    runs = [learn(given.throws, seed) for seed in range(1, given.seeds + 1)]
    if given.curve:
        with open(given.curve, "w", encoding="utf-8") as file:
            file.write(curve(runs))


if __name__ == "__main__":
    main()
