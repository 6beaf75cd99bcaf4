"""Let time pass, and show how far it has come."""
from __future__ import annotations

import sys
import time
from typing import Callable, TextIO

from ._values import number
from .world import World


def run(world: World, seconds: float, dt: float = 1 / 60, progress: bool | None = None, each: Callable[[World], object] | None = None,
        file: TextIO | None = None) -> int:
    """Step until `seconds` have passed, in steps of dt (the last one as long as what is left, if that is not next to nothing).
    @param progress  draw a line with time, speed and what is left; None: if `file` is a terminal
    @param each      called with the world after each step; what it returns true stops the run
    @param file      where the line goes, default sys.stderr
    @return steps done
    """
    seconds, dt = number(seconds, "seconds"), number(dt, "dt")
    if not seconds >= 0 or not dt > 0:
        raise ValueError(f"run() takes seconds of at least 0 and dt above 0, got seconds={seconds:g}, dt={dt:g}")
    file = sys.stderr if file is None else file
    shown = file.isatty() if progress is None else progress
    whole = int(seconds / dt + 1e-9)
    rest = seconds - whole * dt
    steps = [dt] * whole + ([rest] if rest > 1e-9 * dt else [])
    began = last = time.monotonic()
    done = 0
    try:
        for length in steps:
            world.step(length)
            done += 1
            if each is not None and each(world):
                break
            now = time.monotonic()
            if shown and (now - last > 0.1 or done == len(steps)):
                last = now
                file.write(_line(done, len(steps), dt, now - began))
                file.flush()
    finally:
        if shown:
            file.write("\n")
            file.flush()
    return done


def _line(done: int, total: int, dt: float, took: float) -> str:
    filled = 24 * done // total
    speed = done * dt / took if took > 0 else 0.0
    left = took * (total - done) / done
    return (f"\r[{'#' * filled}{'.' * (24 - filled)}] {done * dt:.2f} of {total * dt:.2f} s, {speed:.1f} x real time, "
            f"{1e3 * took / done:.2f} ms a step, {left:.0f} s left ")
