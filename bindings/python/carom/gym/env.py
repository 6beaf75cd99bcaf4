"""Gymnasium's environments over a batch of worlds."""
from __future__ import annotations

import importlib
from typing import Any, Sequence

import numpy as np

from ..batch import Batch
from ..engine import Engine
from .task import Task
from .tasks import TASKS

gymnasium: Any
try:
    gymnasium = importlib.import_module("gymnasium")
    AutoresetMode: Any = importlib.import_module("gymnasium.vector").AutoresetMode
except ImportError:
    raise ImportError("carom.gym needs gymnasium: pip install 'carom[gym]'") from None

FARTHEST = 1e15  # m: where a body may be; m/s and rad/s are less


def task_of(task: str | Task | type[Task]) -> Task:
    if isinstance(task, str):
        if task not in TASKS:
            raise ValueError(f"task {task!r} is none of {', '.join(TASKS)}")
        return TASKS[task]()
    made = task() if isinstance(task, type) else task
    if not isinstance(made, Task):
        raise TypeError(f"task takes a name or a carom.gym.Task, got {task!r}")
    return made


class VectorEnv(gymnasium.vector.VectorEnv):  # type: ignore[misc]
    """Many environments of one task.
    @param task            a name of carom.gym.TASKS, or a Task of your own
    @param autoreset_mode  NextStep: an episode that ended begins anew with the next action, which is not looked at; SameStep: at once,
                           and infos["final_obs"], infos["final_info"] have its end; Disabled: by reset(options={"reset_mask": ...})
    @param threads         that step worlds; the outcome is the same to the bit
    """

    def __init__(self, task: str | Task | type[Task], num_envs: int = 1, *, autoreset_mode: Any = AutoresetMode.NEXT_STEP,
                 threads: int = 1, render_mode: None = None) -> None:
        if render_mode is not None:
            raise ValueError(f"render_mode takes None, got {render_mode!r}: save a world by batch.save() and draw it")
        self.task = task_of(task)
        self.num_envs = num_envs
        self.mode = AutoresetMode(autoreset_mode)
        self.metadata = {"render_modes": [], "autoreset_mode": self.mode, "render_fps": round(1 / (self.task.dt * self.task.steps))}
        self.render_mode = None
        self.single_action_space = gymnasium.spaces.Box(-1.0, 1.0, (self.task.actions,), np.float32)
        self.single_observation_space = gymnasium.spaces.Box(-FARTHEST, FARTHEST, (self.task.observations,), np.float64)
        self.action_space = gymnasium.vector.utils.batch_space(self.single_action_space, num_envs)
        self.observation_space = gymnasium.vector.utils.batch_space(self.single_observation_space, num_envs)
        self.engine = Engine(threads=threads)
        try:
            self.batch = Batch(self.task.build(self.engine), num_envs)
            self.task.attach(self.batch)
        except BaseException:
            self.engine.close()
            raise
        self._seeds = np.random.default_rng().integers(0, 2**63, num_envs, dtype=np.uint64)
        self._ages = np.zeros(num_envs, np.int64)
        self._over = np.ones(num_envs, bool)  # not reset yet, or at the end

    def reset(self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """@param seed  of the first environment, the others count on; or one for each   @param options  {"reset_mask": booleans}"""
        mask = np.ones(self.num_envs, bool)
        if options and "reset_mask" in options:
            mask = options["reset_mask"]
            if not isinstance(mask, np.ndarray) or mask.dtype != bool or mask.shape != (self.num_envs,) or not mask.any():
                raise ValueError(f"reset_mask takes {self.num_envs} booleans of numpy, of which one is True, got {mask!r}")
        if seed is not None:
            given = [seed + k for k in range(self.num_envs)] if isinstance(seed, (int, np.integer)) else list(seed)
            if len(given) != self.num_envs or any(one is not None and one < 0 for one in given):
                raise ValueError(f"seed takes one number that is not negative, or {self.num_envs}, got {seed!r}")
            for k in np.flatnonzero(mask):
                one = given[k]
                if one is not None:
                    self._seeds[k], self.batch.draws[k] = one, 0
            super().reset(seed=next((int(one) for one in given if one is not None), None))
        self._begin(mask)
        return self.task.observe(), {}

    def _begin(self, mask: Any) -> None:
        self.batch.reset(mask)
        self.task.begin(self.batch, mask, self._seeds)
        self._ages[mask], self._over[mask] = 0, False

    def step(self, actions: Any) -> tuple[Any, Any, Any, Any, dict[str, Any]]:
        given = np.asarray(actions, np.float64)
        if given.shape != self.action_space.shape or not np.isfinite(given).all():
            raise ValueError(f"actions takes finite numbers of shape {self.action_space.shape}, got {given.shape}"
                             + ("" if given.shape != self.action_space.shape else f", of which row {np.argwhere(~np.isfinite(given))[0][0]} is not"))
        acting = ~self._over
        if self.mode == AutoresetMode.DISABLED and not acting.all():
            raise RuntimeError(f"environments {np.flatnonzero(self._over)[:8].tolist()} are at their end, or were never reset: call reset() for them")
        clipped = np.clip(given, -1, 1)
        self.task.act(clipped)
        stopped = self.batch.step(self.task.dt, self.task.steps, mask=acting)
        rewards, terminated = self.task.judge(clipped)
        rewards = np.where(acting, rewards, 0.0)
        infos: dict[str, Any] = {}
        if stopped:
            faults = (self.batch.stopped() != 0) & acting
            terminated = terminated | faults
            infos["fault"], infos["_fault"] = faults, faults.copy()
        terminated = terminated & acting
        self._ages[acting] += 1
        truncated = acting & ~terminated & (self._ages >= self.task.longest)
        over = terminated | truncated
        if self.mode == AutoresetMode.NEXT_STEP:
            if not acting.all():
                self._begin(~acting)
            self._over = over
        elif self.mode == AutoresetMode.SAME_STEP and over.any():
            final, obs = np.full(self.num_envs, None, object), self.task.observe()
            for k in np.flatnonzero(over):
                final[k] = obs[k].copy()
            infos = {"final_obs": final, "_final_obs": over.copy(), "final_info": {**infos}, "_final_info": over.copy()}
            self._begin(over)
        else:
            self._over = self._over | over
        return self.task.observe(), rewards, terminated, truncated, infos

    def close_extras(self, **kwargs: Any) -> None:
        self.engine.close()


class Env(gymnasium.Env):  # type: ignore[misc]
    """One environment of a task, in a batch of its own."""

    metadata: dict[str, Any] = {"render_modes": []}

    def __init__(self, task: str | Task | type[Task], render_mode: None = None) -> None:
        self.envs = VectorEnv(task, 1, autoreset_mode=AutoresetMode.DISABLED, render_mode=render_mode)
        self.metadata = {"render_modes": [], "render_fps": self.envs.metadata["render_fps"]}
        self.render_mode = None
        self.action_space, self.observation_space = self.envs.single_action_space, self.envs.single_observation_space

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        super().reset(seed=seed)
        observations, _ = self.envs.reset(seed=seed)
        return observations[0].copy(), {}

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        observations, rewards, terminated, truncated, _ = self.envs.step(np.asarray(action)[None])
        return observations[0].copy(), float(rewards[0]), bool(terminated[0]), bool(truncated[0]), {}

    def close(self) -> None:
        self.envs.close()
