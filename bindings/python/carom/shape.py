"""A shape: a plugin with parameters, immutable, used by any number of colliders."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING

from . import raw
from .errors import CaromError, Closed
from ._values import record
from .records import ShapeInfoRecord

if TYPE_CHECKING:
    from .engine import Engine


class Shape:
    """A handle and its engine. The engine owns the shape; forgetting this object destroys nothing."""

    __slots__ = ("engine", "handle")

    def __init__(self, engine: Engine, handle: int):
        self.engine, self.handle = engine, handle

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Shape) and (self.engine, self.handle) == (other.engine, other.handle)

    def __hash__(self) -> int:
        return hash(self.handle)

    def __repr__(self) -> str:
        what = f"carom.Shape {self.handle:#x}"
        try:
            info = self.info
        except Closed:
            return f"<{what}, of a closed engine>"
        except CaromError:
            return f"<{what}, destroyed>"
        return f"<{what}: {'a half-space' if info.is_half_space else 'scenery' if info.is_scenery else f'{info.volume:.6g} m^3'}>"

    @property
    def info(self) -> ShapeInfoRecord:
        """What the engine knows of it: bounds, volume, centroid, inertia (for 1 kg/m^3), each with its error."""
        info = raw.carom_shape_info(struct_size=ctypes.sizeof(raw.carom_shape_info))
        self.engine._call(raw.carom_shape_get_info, self.handle, ctypes.byref(info))
        return record(ShapeInfoRecord, info)

    @property
    def params(self) -> tuple[float, ...]:
        count = ctypes.c_uint64(self.info.param_count)
        values = (ctypes.c_double * count.value)()
        self.engine._call(raw.carom_shape_get_params, self.handle, values, ctypes.byref(count))
        return tuple(values)

    @property
    def parts(self) -> list[tuple[Shape, tuple[float, ...], tuple[float, ...], tuple[float, ...]]]:
        """Of a hull of shapes: shape, position, orientation and scale of each, as engine.hull_of() takes them. Else none."""
        count = ctypes.c_uint64()
        ask = raw.carom_shape_get_parts
        self.engine._call(ask, self.handle, None, None, None, None, ctypes.byref(count), None)
        n = count.value
        handles = (ctypes.c_uint64 * n)()
        p, q, s = (ctypes.c_double * (3 * n))(), (ctypes.c_double * (4 * n))(), (ctypes.c_double * (3 * n))()
        self.engine._call(ask, self.handle, handles, p, q, s, ctypes.byref(count), None)
        return [(Shape(self.engine, handles[i]), tuple(p[3 * i:3 * i + 3]), tuple(q[4 * i:4 * i + 4]), tuple(s[3 * i:3 * i + 3]))
                for i in range(n)]

    @property
    def rounding(self) -> float:
        """Of a hull of shapes: m, by which it grew on all sides. Else 0."""
        count, radius = ctypes.c_uint64(), ctypes.c_double()
        self.engine._call(raw.carom_shape_get_parts, self.handle, None, None, None, None, ctypes.byref(count), ctypes.byref(radius))
        return radius.value

    def destroy(self) -> None:
        """@raise InUse while a collider uses it"""
        self.engine._call(raw.carom_shape_destroy, self.handle)
