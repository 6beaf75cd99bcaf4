"""Many jobs from one snapshot: function(world, seed) for each seed, on threads, processes or a Ray cluster, with equal results.

    import carom

    def height(world, seed):
        world.bodies[-1].linear_velocity = (0, seed, 0)
        for _ in range(60):
            world.step(1 / 60)
        return world.bodies[-1].position[1]

    if __name__ == "__main__":
        heights = carom.jobs.map(snapshot, height, range(100), on="processes", file="heights.jsonl")

A job gets a world of its own, as it was saved; what it gives follows from the snapshot and its seed. So a job may be done again, by whomever:
its result counts once.
"""
from __future__ import annotations

import hashlib
import importlib
import json
import os
import threading
from concurrent.futures import FIRST_COMPLETED, CancelledError, Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context
from typing import TYPE_CHECKING, Any, Callable, Iterable, Literal, Optional

from ._values import whole
from .engine import PLUGIN_SUFFIX, Engine, plugin_folders
from .errors import CaromError

if TYPE_CHECKING:
    from .world import World

    Function = Callable[[World, int], Any]
    Setup = Optional[Callable[[Engine], None]]

__all__ = ["JobFailed", "map"]


class JobFailed(RuntimeError):
    """A job raised, or its worker ended, more often than `retries` allows. seed: which; the cause stands beside (__cause__)."""

    def __init__(self, seed: int, text: str) -> None:
        super().__init__(f"the job of seed {seed} failed: {text}")
        self.seed = seed


def map(snapshot: bytes, function: Function, seeds: Iterable[int], *, on: Literal["here", "threads", "processes", "ray"] = "threads",
        workers: int | None = None, window: int | None = None, file: str | os.PathLike[str] | None = None, retries: int = 2,
        setup: Setup = None, progress: Callable[[int, int], None] | None = None) -> list[Any]:
    """Results in the order of the seeds.
    @param snapshot  of World.save(whole=True)
    @param function  (world, seed) -> what JSON has: numbers, text, lists, dicts with names. On processes and Ray it must be importable
    @param on        "here": one after the other; "threads"; "processes", which a job may take down; "ray": the cluster that ray.init() finds
    @param workers   how many at once, default the processors; on Ray the cluster's
    @param window    jobs that are handed out at a time, default four for each worker
    @param file      lines of JSON of finished jobs, appended: what stands there of the same snapshot and function is not done again
    @param retries   how often a job is done anew after its worker ended; a job that raises is not
    @param setup     called with each engine first: load_plugin() for shapes of your own
    @param progress  called with (jobs done, jobs in all) after each
    @raise JobFailed"""
    data, wanted = bytes(snapshot), [whole(seed, f"seeds[{k}]", 0, 2**63 - 1) for k, seed in enumerate(seeds)]
    if on not in ("here", "threads", "processes", "ray"):
        raise ValueError(f"on {on!r} is not one of here, threads, processes, ray")
    if not callable(function):
        raise TypeError(f"function takes a function of (world, seed), got {function!r}")
    many = whole(workers, "workers", 1, 4096) if workers is not None else os.cpu_count() or 1
    retries = whole(retries, "retries", 0, 1000)
    ledger = _Ledger(file, _key(data, function))
    todo = [seed for seed in dict.fromkeys(wanted) if seed not in ledger.results]
    total = len(todo) + len(ledger.results)

    def finished(seed: int, result: Any) -> None:
        ledger.add(seed, result)
        if progress is not None:
            progress(total - len(todo) + len(done), total)

    done: set[int] = set()

    def once(seed: int, result: Any) -> None:  # a job that was done twice counts once
        if seed not in done:
            done.add(seed)
            finished(seed, result)

    try:
        if on == "here":
            for seed in todo:
                once(seed, _guarded(data, function, setup, seed))
        else:
            pool: _Pool = _RayPool(data, function, setup) if on == "ray" else _LocalPool(on, many, data, function, setup)
            try:
                _hand_out(pool, todo, whole(window, "window", 1, 2**20) if window is not None else 4 * many, retries, once)
            finally:
                pool.close()
    finally:
        ledger.close()
    return [ledger.results[seed] for seed in wanted]


def _key(data: bytes, function: Any) -> str:
    name = f"{getattr(function, '__module__', '')}.{getattr(function, '__qualname__', repr(function))}"
    return hashlib.sha256(data + name.encode()).hexdigest()[:16]


class _Ledger:
    """Results by seed, and the file that has them. A line that a crash cut off is none."""

    def __init__(self, file: str | os.PathLike[str] | None, key: str) -> None:
        self.results: dict[int, Any] = {}
        self._key, self._file = key, None if file is None else open(file, "a+b")
        if self._file is None:
            return
        self._file.seek(0)
        text = self._file.read()
        for line in text.split(b"\n"):
            try:
                entry = json.loads(line)
            except ValueError:
                continue
            if isinstance(entry, dict) and entry.get("key") == key and isinstance(entry.get("seed"), int) and "result" in entry:
                self.results.setdefault(entry["seed"], entry["result"])
        if text and not text.endswith(b"\n"):
            self._file.write(b"\n")

    def add(self, seed: int, result: Any) -> None:
        try:
            line = json.dumps({"key": self._key, "seed": seed, "result": result}, allow_nan=True)
        except (TypeError, ValueError) as why:
            raise JobFailed(seed, f"its result is not what JSON has: {why}") from why
        self.results[seed] = json.loads(line)["result"]  # alike, whether from a file or from a job
        if self._file is not None:
            self._file.write(line.encode() + b"\n")
            self._file.flush()

    def close(self) -> None:
        if self._file is not None:
            self._file.close()


# ---- a job ----

_own = threading.local()  # an engine a thread


def _do(data: bytes, function: Function, setup: Setup, seed: int) -> Any:
    engine = getattr(_own, "engine", None)
    if engine is None or getattr(_own, "setup", None) is not setup:
        engine = _own.engine = Engine()
        _own.setup = setup
        for folder in plugin_folders():
            for name in sorted(folder.glob("*" + PLUGIN_SUFFIX)) if folder.is_dir() else ():
                try:
                    engine.plugin(f"carom.{name.stem}")
                except CaromError:
                    pass
        if setup is not None:
            setup(engine)
    with engine.world() as world:
        world.restore(data)
        return function(world, seed)


def _guarded(data: bytes, function: Function, setup: Setup, seed: int) -> Any:
    try:
        return _do(data, function, setup, seed)
    except Exception as why:
        raise JobFailed(seed, f"{type(why).__name__}: {why}") from why


_given: list[Any] = []  # in a process of a pool


def _begin(data: bytes, function: Function, setup: Setup) -> None:
    _given[:] = data, function, setup


def _do_given(seed: int) -> Any:
    data, function, setup = _given
    return _do(data, function, setup, seed)


# ---- who does them ----

class _Lost(Exception):
    """A worker ended."""


class _Pool:
    def submit(self, seed: int) -> Any:
        raise NotImplementedError

    def some(self, pending: Iterable[Any]) -> list[Any]:
        """@return those of the pending that are done; one at least"""
        raise NotImplementedError

    def result(self, job: Any) -> Any:
        """@raise _Lost"""
        raise NotImplementedError

    def close(self) -> None:
        pass


def _hand_out(pool: _Pool, todo: list[int], window: int, retries: int, once: Callable[[int, Any], None]) -> None:
    waiting, lost = list(reversed(todo)), dict.fromkeys(todo, 0)
    pending: dict[Any, int] = {}
    while waiting or pending:
        while waiting and len(pending) < window:
            seed = waiting.pop()
            pending[pool.submit(seed)] = seed
        for job in pool.some(pending):
            seed = pending.pop(job)
            try:
                result = pool.result(job)
            except _Lost as why:
                lost[seed] += 1
                if lost[seed] > retries:
                    raise JobFailed(seed, f"its worker ended {lost[seed]} times") from why
                waiting.append(seed)
            except Exception as why:
                raise JobFailed(seed, f"{type(why).__name__}: {why}") from why
            else:
                once(seed, result)


class _LocalPool(_Pool):
    def __init__(self, on: str, workers: int, data: bytes, function: Function, setup: Setup) -> None:
        self._on, self._workers, self._given = on, workers, (data, function, setup)
        self._pool = self._make()

    def _make(self) -> Executor:
        if self._on == "threads":
            return ThreadPoolExecutor(self._workers)
        return ProcessPoolExecutor(self._workers, get_context("spawn"), _begin, self._given)

    def submit(self, seed: int) -> Future[Any]:
        if self._on == "threads":
            return self._pool.submit(_do, *self._given, seed)
        try:
            return self._pool.submit(_do_given, seed)
        except BrokenProcessPool:  # all that it had is lost, and said so
            self._pool.shutdown(wait=False)
            self._pool = self._make()
            return self._pool.submit(_do_given, seed)

    def some(self, pending: Iterable[Future[Any]]) -> list[Future[Any]]:
        return list(wait(list(pending), return_when=FIRST_COMPLETED)[0])

    def result(self, job: Future[Any]) -> Any:
        try:
            return job.result()
        except (BrokenProcessPool, CancelledError) as why:
            raise _Lost from why

    def close(self) -> None:
        self._pool.shutdown(wait=True, cancel_futures=True)


class _RayPool(_Pool):
    def __init__(self, data: bytes, function: Function, setup: Setup) -> None:
        try:
            self._ray: Any = importlib.import_module("ray")
        except ImportError as why:
            raise ImportError("on='ray' needs Ray: pip install ray") from why
        if not self._ray.is_initialized():
            self._ray.init()
        self._do = self._ray.remote(max_retries=0)(_do)
        self._given = [self._ray.put(data), self._ray.put(function), self._ray.put(setup)]

    def submit(self, seed: int) -> Any:
        return self._do.remote(*self._given, seed)

    def some(self, pending: Iterable[Any]) -> list[Any]:
        return list(self._ray.wait(list(pending), num_returns=1)[0])

    def result(self, job: Any) -> Any:
        lost = (self._ray.exceptions.WorkerCrashedError, self._ray.exceptions.NodeDiedError, self._ray.exceptions.OutOfMemoryError)
        try:
            return self._ray.get(job)
        except lost as why:
            raise _Lost from why
        except self._ray.exceptions.RayTaskError as why:
            raise (why.cause if isinstance(why.cause, Exception) else why) from None
