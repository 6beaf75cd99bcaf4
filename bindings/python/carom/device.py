"""Distances of many pairs of shapes in one call: on the engine's threads, or on a device of OpenCL. The bits are the same."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Callable, Sequence

from . import raw
from ._root import Root, count_of
from ._values import describe, floats, listed, need_numpy, shape_of, whole
from .query import spread

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._values import Rows, Vector
    from .engine import Engine
    from .records import DistanceKeywords
    from .shape import Shape

IDENTITY = (0, 0, 0, 1)


def measure(call: Callable[..., None], function: Callable[..., int], a: Shape | Sequence[Shape], b: Shape | Sequence[Shape], position_a: Any,
            position_b: Any, orientation_a: Any, orientation_b: Any, how: Any) -> Any:
    """The results of carom_pairs_distance() or its like."""
    np = need_numpy("distances()")
    desc = describe(raw.carom_distance_desc, how)
    shapes = [[shape_of(s, name)] if hasattr(s, "handle") else [shape_of(x, name) for x in listed(s, name, "a Shape, or one for each")]
              for s, name in ((a, "a"), (b, "b"))]
    poses = [floats(values, name) for values, name in ((position_a, "position_a"), (orientation_a, "orientation_a"), (position_b, "position_b"),
                                                       (orientation_b, "orientation_b"))]
    rows = [len(p) for p in poses if p.ndim > 1] + [len(s) for s in shapes if len(s) != 1]
    n = rows[0] if rows else 1
    if any(len(s) not in (1, n) for s in shapes):
        raise ValueError(f"a and b take {n} shapes each, or one for all, got {len(shapes[0])} and {len(shapes[1])}")
    handles = [np.ascontiguousarray(np.broadcast_to(np.asarray(s, dtype=np.uint64), (n,))) for s in shapes]
    packed = [spread(p, (n, width), name) for p, width, name in zip(poses, (3, 4, 3, 4), ("position_a", "orientation_a", "position_b", "orientation_b"))]
    pairs = raw.carom_pairs(struct_size=ctypes.sizeof(raw.carom_pairs), count=n)
    words, numbers = ctypes.POINTER(ctypes.c_uint64), ctypes.POINTER(ctypes.c_double)
    pairs.shapes_a, pairs.shapes_b = (h.ctypes.data_as(words) for h in handles)
    pairs.positions_a, pairs.orientations_a, pairs.positions_b, pairs.orientations_b = (p.ctypes.data_as(numbers) for p in packed)
    found = np.zeros(n, np.dtype(raw.carom_distance))
    call(function, ctypes.byref(pairs), ctypes.byref(desc), found.ctypes.data_as(ctypes.POINTER(raw.carom_distance)), found.itemsize)
    return found


class Device(Root):
    """A device of OpenCL, by its place among those of this machine. CaromError with what to install where there is none."""

    _kind = "device"

    def __init__(self, engine: Engine, index: int = 0) -> None:
        pointer = ctypes.c_void_p()
        engine._call(raw.carom_device_create, whole(index, "index", 0, 2**32 - 1), ctypes.byref(pointer))
        super().__init__(pointer.value, raw.carom_device_destroy, engine._owner)
        engine._batches.add(self)

    def _info(self) -> raw.carom_device_info:
        info = raw.carom_device_info(struct_size=ctypes.sizeof(raw.carom_device_info))
        self._call(raw.carom_device_get_info, ctypes.byref(info))
        return info

    def __repr__(self) -> str:
        return "<carom.Device, closed>" if self._closed else f"<carom.Device: {self.name}, {count_of(self.pairs, 'pair')}>"

    @property
    def name(self) -> str:
        """As its driver says."""
        return self._info().name.decode(errors="replace")

    @property
    def pairs(self) -> int:
        """How many it was asked for."""
        return self._info().pairs

    @property
    def host_pairs(self) -> int:
        """How many of them it left to the host: cores that overlap."""
        return self._info().host_pairs

    def distances(self, a: Shape | Sequence[Shape], b: Shape | Sequence[Shape], position_a: Rows | Vector = (0, 0, 0),
                  position_b: Rows | Vector = (0, 0, 0), orientation_a: Rows | Vector = IDENTITY, orientation_b: Rows | Vector = IDENTITY,
                  **how: Unpack[DistanceKeywords]) -> Any:
        """As Engine.distances(), on this device: the same bits."""
        return measure(self._call, raw.carom_device_pairs_distance, a, b, position_a, position_b, orientation_a, orientation_b, how)
