"""Which settings err least on a world within a budget: the command `carom tune`, asked about a world of this program."""
from __future__ import annotations

import json
import os
import shutil
import subprocess
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from . import raw
from ._values import enum, number
from .world import World


@dataclass(frozen=True)
class Setting:
    """What a host sets, and what came of it."""
    steps_per_frame: int
    dials: dict[str, str]
    preset: str | None
    ms: float            # of computing, a frame
    worst_ms: float      # the dearest frame
    error: float         # in the unit of Tuned; inf: it came to nothing
    offences: dict[str, float] = field(default_factory=dict)  # sink m, joints m, cone m/s, energy J/kg

    def apply(self, world: World) -> None:
        """Set preset and dials on a world; stepping `steps_per_frame` times a frame is the caller's."""
        if self.preset is not None:
            world._call(raw.carom_world_set_preset, enum("PRESET", self.preset, "preset"))
        for name, value in self.dials.items():
            world.dials[name] = value if isinstance(world.dials[name], str) else float(value)


@dataclass(frozen=True)
class Tuned:
    """Answer of tune(). `front`: settings that none beats in both time and error, the cheapest first."""
    pick: Setting | None  # the least error within the budget; None: nothing is as cheap
    front: list[Setting]
    error: str            # what an error is: pose, laws, ...
    unit: str
    chaotic: bool         # poses say nothing: judged by what no motion may do
    seconds: float        # simulated, by which settings were judged
    floor: float          # errors below it are not told apart


def tune(world: World, budget_ms: float = 2, *, seconds: float | None = None, frame_rate: float = 60, error: str | None = None,
         within: float = 20, tool: str | None = None) -> Tuned:
    """Run copies of the world at some tens of settings, compare them with a fine run of their own, and tell which are worth it.

    The world is saved whole and handed to the command `carom`; it stays as it is. Shapes written in Python can't go along.

    @param budget_ms   ms of computing a frame
    @param seconds     simulated, from now on; None: 5, or as many as `within` allows for
    @param frame_rate  frames a second, Hz
    @param error       pose (m), drift (m), energy (J), gap (m) or laws (m); None: pose, or laws where the world is chaotic
    @param within      s that the search takes; 0: as long as it does
    @param tool        the command; None: $CAROM_TOOL, else `carom` beside the library's folder or on the path
    @raise FileNotFoundError  no such command   @raise RuntimeError  what the command said
    """
    budget_ms, frame_rate, within = number(budget_ms, "budget_ms"), number(frame_rate, "frame_rate"), number(within, "within")
    seconds = None if seconds is None else number(seconds, "seconds")
    command = _find_tool(tool)
    with tempfile.TemporaryDirectory() as folder:
        state, answer = Path(folder, "world.carom"), Path(folder, "answer.json")
        state.write_bytes(world.save(whole=True))
        line = [command, "tune", str(state), "--budget", repr(budget_ms), "--frame", repr(frame_rate), "--within",
                repr(within), "--json", str(answer), "--quiet"]
        if seconds is not None:
            line += ["--seconds", repr(seconds)]
        if error is not None:
            line += ["--error", error]
        done = subprocess.run(line, capture_output=True, text=True)
        if not answer.exists():
            raise RuntimeError(f"carom tune: {done.stderr.strip() or done.stdout.strip() or f'exit code {done.returncode}'}")
        found = json.loads(answer.read_text())
    return Tuned(pick=_setting(found["pick"]) if found["pick"] else None, front=[_setting(s) for s in found["front"]], error=found["error"],
                 unit=found["unit"], chaotic=found["chaotic"], seconds=found["judged_seconds"], floor=found["floor"])


def _setting(found: dict[str, Any]) -> Setting:
    dials = dict(found["dials"])
    return Setting(steps_per_frame=found["steps_per_frame"], preset=dials.pop("preset", None), dials=dials, ms=found["ms"],
                   worst_ms=found["worst_ms"], error=float("inf") if found["error"] is None else found["error"], offences=found["offences"])


def _find_tool(given: str | None) -> str:
    library = os.environ.get("CAROM_LIBRARY")
    beside = [str(Path(library).parent.parent / "bin" / "carom")] if library else []
    for candidate in [given] if given else [os.environ.get("CAROM_TOOL"), *beside, "carom"]:
        found = shutil.which(candidate) if candidate else None
        if found:
            return found
    raise FileNotFoundError(f"{given or 'the command carom'} is not there: install Carom's tools, or name it by tool= or $CAROM_TOOL")
