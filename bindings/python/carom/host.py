"""What a host may put in place of the engine's own: memory, and threads of a step."""
from __future__ import annotations

import traceback
from concurrent.futures import Executor, wait
from typing import Any, Callable, Protocol

from ._values import whole

Job = Callable[[int, int], None]  # the parts begin up to end of a loop
Jobs = Callable[[Job, int], None]


class Allocator(Protocol):
    """Memory for all that grows with a scene. Called on whichever threads use the engine, at once; calls of carom from it raise
    Reentrant there. An exception in `alloc` is printed, and stands for no memory."""

    def alloc(self, size: int, alignment: int) -> int | None:
        """@return the address of `size` bytes at a multiple of `alignment`, a power of two; None if there is none"""
        ...

    def free(self, address: int, size: int, alignment: int) -> None: ...


def share(executor: Executor, parts: int) -> Jobs:
    """Loops of a step in so many parts, one of them on the thread that steps and the others in the executor's threads: an engine's
    jobs. A hand-over takes a thread pool of Python some ten microseconds, tens of times a step: worth it where steps take ten
    milliseconds. Engine(threads=) has threads of its own, which take one."""

    parts = whole(parts, "parts", 1)

    def run(job: Job, count: int) -> None:
        size = -(-count // parts)
        others = [executor.submit(job, begin, min(begin + size, count)) for begin in range(size, count, size)]
        try:
            job(0, min(size, count))
        finally:
            wait(others)

    return run


def put_allocator(desc: Any, allocator: Allocator) -> list[Any]:
    """@return what must live as long as the engine"""

    def alloc_or_none(_: int | None, size: int, alignment: int) -> int | None:
        try:  # what a callback of ctypes returns after an exception is whatever the stack held
            return allocator.alloc(size, alignment)
        except Exception:
            traceback.print_exc()
            return None

    alloc = type(desc.alloc)(alloc_or_none)
    free = type(desc.free)(lambda _, address, size, alignment: allocator.free(address, size, alignment))
    desc.alloc, desc.free = alloc, free
    return [alloc, free]


def put_jobs(desc: Any, jobs: Jobs) -> list[Any]:
    """@return what must live as long as the engine"""
    run = type(desc.run)(lambda _, job, context, count: jobs(lambda begin, end: job(context, begin, end), count))
    desc.run = run
    return [run]
