"""Questions without a world: what two shapes at given places, or on their way, are to each other."""
from __future__ import annotations

import ctypes
import math
from typing import TYPE_CHECKING, Any, Callable, Mapping, Sequence

from . import raw
from ._values import ask, describe, direction as way_of, need_numpy, number, record, shape_of, vec3, vector, word
from .device import measure
from .query import OUTCOMES, rows_of
from .records import CastRecord, DistanceRecord, OverlapRecord
from .shape import Shape

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from typing_extensions import Unpack

    from ._values import Rows, Vector
    from .records import CastKeywords as CastFields
    from .records import DistanceKeywords, MotionKeywords

    class CastKeywords(CastFields, total=False):
        ignore_touched: bool

IDENTITY = (0, 0, 0, 1)
OVERLAPS = ("apart", "overlapping", "touching", "fault")


def _pose(position: Vector, orientation: Vector, of: str) -> tuple[Any, Any]:
    return vec3(position, f"position{of}"), vector(orientation, 4, f"orientation{of}")


class PairQuestions:
    """`how`: fields of carom_cast_desc, as tolerance=, target=, iterations=, flags=. Times are in brackets [lower, upper].
    ignore_touched=True: what a ray or shape touches or overlaps at its start is passed over."""

    _call: Callable[..., None]

    def _cast(self, function: Callable[..., int], how: Mapping[str, Any], *arguments: object) -> CastRecord:
        desc = ask(raw.carom_cast_desc, how)
        result = raw.carom_cast(struct_size=ctypes.sizeof(raw.carom_cast))
        self._call(function, *arguments, ctypes.byref(desc), ctypes.byref(result))
        return record(CastRecord, result, outcome=word("CAST", result.outcome, OUTCOMES))

    def distance(self, a: Shape, b: Shape, position_a: Vector = (0, 0, 0), position_b: Vector = (0, 0, 0), orientation_a: Vector = IDENTITY,
                 orientation_b: Vector = IDENTITY, **how: Unpack[DistanceKeywords]) -> DistanceRecord:
        """Signed distance of two shapes, with bracket [lower, upper], normal and closest points.
        @param how  fields of carom_distance_desc: tolerance=1e-9, pair_routines=1"""
        desc = describe(raw.carom_distance_desc, how)
        result = raw.carom_distance(struct_size=ctypes.sizeof(raw.carom_distance))
        self._call(raw.carom_shape_distance, shape_of(a, "a"), *_pose(position_a, orientation_a, "_a"), shape_of(b, "b"),
                   *_pose(position_b, orientation_b, "_b"), ctypes.byref(desc), ctypes.byref(result))
        return record(DistanceRecord, result)

    def distances(self, a: Shape | Sequence[Shape], b: Shape | Sequence[Shape], position_a: Rows | Vector = (0, 0, 0),
                  position_b: Rows | Vector = (0, 0, 0), orientation_a: Rows | Vector = IDENTITY, orientation_b: Rows | Vector = IDENTITY,
                  **how: Unpack[DistanceKeywords]) -> Any:
        """Signed distances of many pairs at once, with the bits of distance(), on the engine's threads.
        @param a, b  one shape for all, or one for each pair   @param position_*  (n, 3) m, or one for all
        @param orientation_*  (n, 4), or one for all   @param how  as of distance()
        @return an array of n records: "separation", "lower", "upper", "normal", "point_a", "point_b", "status", ..."""
        return measure(self._call, raw.carom_pairs_distance, a, b, position_a, position_b, orientation_a, orientation_b, how)

    def ray_cast(self, shape: Shape, origin: Vector, direction: Vector, max: float = math.inf, position: Vector = (0, 0, 0),
                 orientation: Vector = IDENTITY, **how: Unpack[CastKeywords]) -> CastRecord:
        """Where origin + t direction, 0 <= t <= max, meets a shape. @return outcome ("hit", "miss", ...), time, point_b, normal"""
        return self._cast(raw.carom_ray_cast, how, shape_of(shape, "shape"), *_pose(position, orientation, ""),
                          vec3(origin, "origin"), way_of(direction, "direction"), number(max, "max"))

    def shape_cast(self, a: Shape, b: Shape, motion: Vector, position_a: Vector = (0, 0, 0), position_b: Vector = (0, 0, 0), orientation_a: Vector = IDENTITY,
                   orientation_b: Vector = IDENTITY, **how: Unpack[CastKeywords]) -> CastRecord:
        """When A, moved by `motion` (m) without turning, touches B: a fraction of the motion. @return as ray_cast()"""
        return self._cast(raw.carom_shape_cast, how, shape_of(a, "a"), *_pose(position_a, orientation_a, "_a"), vec3(motion, "motion"),
                          shape_of(b, "b"), *_pose(position_b, orientation_b, "_b"))

    def time_of_impact(self, a: Shape, b: Shape, duration: float, motion_a: MotionKeywords | None = None,
                       motion_b: MotionKeywords | None = None, **how: Unpack[CastKeywords]) -> CastRecord:
        """When two shapes that both travel and turn first touch, s.
        @param motion_a, motion_b  fields of carom_motion, None: it rests at the origin: position, orientation, center,
                                   linear_velocity (m/s), angular_velocity (rad/s)
        @return as ray_cast()"""
        return self._cast(raw.carom_shape_time_of_impact, how, shape_of(a, "a"),
                          ctypes.byref(describe(raw.carom_motion, motion_a or {})), shape_of(b, "b"),
                          ctypes.byref(describe(raw.carom_motion, motion_b or {})), number(duration, "duration"))

    def overlap(self, a: Shape, b: Shape, position_a: Vector = (0, 0, 0), position_b: Vector = (0, 0, 0), orientation_a: Vector = IDENTITY,
                orientation_b: Vector = IDENTITY, **how: Unpack[CastKeywords]) -> OverlapRecord:
        """Whether two shapes overlap, with a proof. @return outcome ("apart", "overlapping", "touching"), normal or point"""
        desc = ask(raw.carom_cast_desc, how)
        result = raw.carom_overlap(struct_size=ctypes.sizeof(raw.carom_overlap))
        self._call(raw.carom_shape_overlap, shape_of(a, "a"), *_pose(position_a, orientation_a, "_a"), shape_of(b, "b"),
                   *_pose(position_b, orientation_b, "_b"), ctypes.byref(desc), ctypes.byref(result))
        return record(OverlapRecord, result, outcome=word("OVERLAP", result.outcome, OVERLAPS))

    def support(self, shape: Shape, directions: Rows) -> NDArray[np.float64]:
        """Farthest points of a shape along directions, numpy arrays of rows of 3."""
        np = need_numpy("support()")
        along = rows_of(directions, 3, "directions")
        points: NDArray[Any] = np.empty_like(along)
        real = ctypes.POINTER(ctypes.c_double)
        self._call(raw.carom_shape_support, shape_of(shape, "shape"), along.ctypes.data_as(real), len(along), points.ctypes.data_as(real))
        return points
