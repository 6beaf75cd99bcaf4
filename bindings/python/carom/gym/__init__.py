"""Environments for reinforcement learning, thousands in one batch (pip install 'carom[gym]').

    import carom.gym

    envs = carom.gym.VectorEnv("Ant", 1024, threads=2)
    observations, infos = envs.reset(seed=1)
    observations, rewards, terminated, truncated, infos = envs.step(envs.action_space.sample())

Gymnasium knows them as well: gymnasium.make("carom/Ant-v0"), gymnasium.make_vec("carom/Ant-v0", 1024). SI units, y up. An episode
follows from its seed and its actions to the bit, whatever the number of environments and threads.
"""
from __future__ import annotations

from .env import AutoresetMode, Env, VectorEnv, gymnasium
from .task import Task
from .tasks import TASKS, Ant, CartPole, Humanoid, Quadruped, Stack, Throw

__all__ = ["Ant", "AutoresetMode", "CartPole", "Env", "Humanoid", "Quadruped", "Stack", "TASKS", "Task", "Throw", "VectorEnv"]

for _name in TASKS:
    if f"carom/{_name}-v0" not in gymnasium.registry:
        gymnasium.register(id=f"carom/{_name}-v0", entry_point="carom.gym.env:Env", vector_entry_point="carom.gym.env:VectorEnv",
                           kwargs={"task": _name})
