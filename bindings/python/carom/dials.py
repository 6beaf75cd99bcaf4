"""Dials of a world by name: world.dials["substeps"] = 8, world.dials["solver"] = "direct"."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Iterator, MutableMapping

from . import raw
from ._root import check
from ._values import Record, number

if TYPE_CHECKING:
    from .world import World

class DialInfo(Record):
    """What a dial is."""
    dial: int
    name: str
    unit: str
    summary: str
    choices: tuple[str, ...]
    integer: bool
    min: float
    max: float
    initial: float


_infos: dict[str, DialInfo] = {}


def dial_infos() -> dict[str, DialInfo]:
    """What each dial is: name, unit, summary, choices, min, max, initial."""
    if not _infos:
        count = ctypes.c_uint32()
        raw.carom_dial_get_count(ctypes.byref(count))
        for dial in range(count.value):
            info = raw.carom_dial_info(struct_size=ctypes.sizeof(raw.carom_dial_info))
            check(raw.carom_dial_get_info, dial, ctypes.byref(info))
            choices = tuple(info.choices[i].decode() for i in range(info.choice_count)) if info.choices else ()
            _infos[info.name.decode()] = DialInfo(
                dial=dial, name=info.name.decode(), unit=info.unit.decode(), summary=info.summary.decode(), choices=choices,
                integer=info.kind == raw.CAROM_DIAL_KIND_INTEGER, min=info.min, max=info.max, initial=info.initial)
    return _infos


class Dials(MutableMapping[str, "float | str"]):
    """All dials of a world; choices are words, others numbers."""

    def __init__(self, world: World):
        self._world = world

    def _info(self, name: str) -> DialInfo:
        infos = dial_infos()
        if name not in infos:
            raise KeyError(f"no dial {name!r}; there are {', '.join(infos)}")
        return infos[name]

    def __getitem__(self, name: str) -> float | str:
        info, value = self._info(name), ctypes.c_double()
        self._world._call(raw.carom_world_get_dial, info.dial, ctypes.byref(value))
        if info.choices:
            return info.choices[int(value.value)]
        return int(value.value) if info.integer else value.value

    def __setitem__(self, name: str, value: float | str) -> None:
        info = self._info(name)
        if isinstance(value, str) and info.choices:
            if value not in info.choices:
                raise ValueError(f"{name} is one of {', '.join(info.choices)}, not {value!r}")
            value = info.choices.index(value)
        self._world._call(raw.carom_world_set_dial, info.dial, number(value, name))

    def __delitem__(self, name: str) -> None:
        """Back to what a new world has."""
        self[name] = self._info(name).initial

    def __iter__(self) -> Iterator[str]:
        return iter(dial_infos())

    def __len__(self) -> int:
        return len(dial_infos())

    def __repr__(self) -> str:
        return f"Dials({dict(self)})"
