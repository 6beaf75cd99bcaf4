"""Force fields, springs, water."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

from . import raw
from ._values import describe, enum, number, record, set_field
from .body import Thing
from .records import ForceFieldRecord, SpringRecord

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._values import Vector
    from .records import ForceFieldKeywords, ForceFieldWord


class ForceField(Thing):
    __slots__ = ()
    _destroy = staticmethod(raw.carom_force_field_destroy)

    def _about(self) -> str:
        return self.desc.kind

    def _get_desc(self) -> raw.carom_force_field_desc:
        desc = raw.carom_force_field_desc(struct_size=ctypes.sizeof(raw.carom_force_field_desc))
        self._call(raw.carom_force_field_get, ctypes.byref(desc))
        return desc

    @property
    def desc(self) -> ForceFieldRecord:
        desc = self._get_desc()
        return record(ForceFieldRecord, desc, kind=raw.carom_force_field_name(desc.kind).decode())

    def update(self, kind: ForceFieldWord | int | None = None, **about: Unpack[ForceFieldKeywords]) -> None:
        """Change some of its fields; the others stay."""
        desc = self._get_desc()
        for key, value in about.items():
            set_field(desc, key, value)
        if kind is not None:
            desc.kind = enum("FORCE_FIELD", kind, "kind")
        self._call(raw.carom_force_field_update, ctypes.byref(desc))


class Spring(Thing):
    __slots__ = ()
    _destroy = staticmethod(raw.carom_spring_destroy)

    def _about(self) -> str:
        length, force = self.state
        return f"{length:.6g} m long, {force:.6g} N"

    @property
    def desc(self) -> SpringRecord:
        desc = raw.carom_spring_desc(struct_size=ctypes.sizeof(raw.carom_spring_desc))
        self._call(raw.carom_spring_get, ctypes.byref(desc))
        return record(SpringRecord, desc, self.world._wrap)

    def update(self, rest: float, stiffness: float, damping: float) -> None:
        self._call(raw.carom_spring_update, number(rest, "rest"), number(stiffness, "stiffness"), number(damping, "damping"))

    @property
    def state(self) -> tuple[float, float]:
        """Length, m, and force, N: above 0 it pulls its ends together"""
        length, force = ctypes.c_double(), ctypes.c_double()
        self._call(raw.carom_spring_get_state, ctypes.byref(length), ctypes.byref(force))
        return length.value, force.value


class Water:
    """All of space where normal . x <= level. @param density  kg/m^3   @param current  m/s   @param drag  1/s"""

    def __init__(self, level: float = 0, density: float = 1000, normal: Vector = (0, 1, 0),
                 current: Vector = (0, 0, 0), drag: float = 1):
        self.level, self.density, self.normal, self.current, self.drag = level, density, tuple(normal), tuple(current), drag

    def __repr__(self) -> str:
        return f"Water({', '.join(f'{name}={value}' for name, value in vars(self).items())})"

    def _desc(self) -> raw.carom_water:
        return describe(raw.carom_water, vars(self))

    @staticmethod
    def _of(desc: raw.carom_water) -> Water:
        return Water(desc.level, desc.density, tuple(desc.normal), tuple(desc.current), desc.drag)
