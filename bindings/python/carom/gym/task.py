"""What an environment is of: a world, what an action does to it, what is seen of it, what is good, when it ends."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..batch import Batch, Column
    from ..engine import Engine
    from ..joint import Joint
    from ..world import World

    Array = NDArray[np.float64]


class Task:
    """Derive from it, and give an instance to VectorEnv. Arrays have a row for each environment.

    dt, steps       s, and how many steps an action lasts
    longest         actions until an episode is truncated
    actions         numbers of an action, each from -1 to 1
    observations    numbers of an observation
    noise           of the first joint positions (m, rad) and half of it a second of their speeds; see begin()
    """

    dt = 1 / 200
    steps = 4
    longest = 1000
    actions = 1
    observations = 1
    noise = 0.05

    def build(self, engine: Engine) -> World:
        """The world in which every episode begins."""
        raise NotImplementedError

    def attach(self, batch: Batch) -> None:
        """Add the columns that the task needs. Here: those of joints(), as self.effort, self.place, self.speed, and what puts them."""
        joints: Any = self.joints()
        self.effort = batch.column("joints", "target_effort", joints, when="before_step")
        self.place = batch.column("joints", "position", joints, when="after_step")
        self.speed = batch.column("joints", "velocity", joints, when="after_step")

    def joints(self) -> list[Joint]:
        """Hinges and sliders that attach() and begin() are about."""
        raise NotImplementedError

    def begin(self, batch: Batch, mask: NDArray[np.bool_], seeds: NDArray[np.uint64]) -> None:
        """After a reset of these environments: make their first states differ, by batch.random(..., mask=mask, seeds=seeds)."""
        if not self.noise:
            return
        n = self.place.array.shape[1]
        offsets = (2 * batch.random(2 * n, mask=mask, seeds=seeds) - 1) * self.noise
        self.place.array[mask] += offsets[mask, :n, None]
        self.speed.array[mask] += offsets[mask, n:, None] / 2
        batch.write(self.place, self.speed, mask=mask)

    def act(self, actions: Array) -> None:
        """Put actions, within -1 and 1, into the columns that are written before each step."""
        raise NotImplementedError

    def observe(self) -> Array:
        raise NotImplementedError

    def judge(self, actions: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Rewards, and which episodes are at their end, after an action."""
        raise NotImplementedError


def rows(*columns: Column | Array) -> Array:
    """Side by side, a row for each environment."""
    arrays = [np.asarray(column) for column in columns]
    side: Array = np.concatenate([array.reshape(len(array), -1) for array in arrays], axis=1)
    return side
