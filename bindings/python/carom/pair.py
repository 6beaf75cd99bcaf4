"""Questions without a world: what two shapes at given places, or on their way, are to each other."""
from __future__ import annotations

import ctypes
import math
from typing import Any, Callable

from . import raw
from ._values import describe, need_numpy, record, vec3, vector, word
from .query import OUTCOMES
from .shape import Shape

IDENTITY = (0, 0, 0, 1)
OVERLAPS = ("apart", "overlapping", "touching", "fault")


def _pose(position, orientation, of: str):
    return vec3(position, f"position{of}"), vector(orientation, 4, f"orientation{of}")


class PairQuestions:
    """`how`: fields of carom_cast_desc, as tolerance=, target=, iterations=. Times are in brackets [lower, upper]."""

    _call: Callable[..., None]

    def _cast(self, function, how, *arguments):
        desc = describe(raw.carom_cast_desc, how)
        result = raw.carom_cast(struct_size=ctypes.sizeof(raw.carom_cast))
        self._call(function, *arguments, ctypes.byref(desc), ctypes.byref(result))
        return record(result, outcome=word("CAST", result.outcome, OUTCOMES))

    def distance(self, a: Shape, b: Shape, position_a=(0, 0, 0), position_b=(0, 0, 0), orientation_a=IDENTITY,
                 orientation_b=IDENTITY, **how):
        """Signed distance of two shapes, with bracket [lower, upper], normal and closest points.
        @param how  fields of carom_distance_desc: tolerance=1e-9, pair_routines=1"""
        desc = describe(raw.carom_distance_desc, how)
        result = raw.carom_distance(struct_size=ctypes.sizeof(raw.carom_distance))
        self._call(raw.carom_shape_distance, a.handle, *_pose(position_a, orientation_a, "_a"), b.handle,
                   *_pose(position_b, orientation_b, "_b"), ctypes.byref(desc), ctypes.byref(result))
        return record(result)

    def ray_cast(self, shape: Shape, origin, direction, max: float = math.inf, position=(0, 0, 0), orientation=IDENTITY, **how):
        """Where origin + t direction, 0 <= t <= max, meets a shape. @return outcome ("hit", "miss", ...), time, point_b, normal"""
        return self._cast(raw.carom_ray_cast, how, shape.handle, *_pose(position, orientation, ""), vec3(origin, "origin"),
                          vec3(direction, "direction"), max)

    def shape_cast(self, a: Shape, b: Shape, motion, position_a=(0, 0, 0), position_b=(0, 0, 0), orientation_a=IDENTITY,
                   orientation_b=IDENTITY, **how):
        """When A, moved by `motion` (m) without turning, touches B: a fraction of the motion. @return as ray_cast()"""
        return self._cast(raw.carom_shape_cast, how, a.handle, *_pose(position_a, orientation_a, "_a"), vec3(motion, "motion"),
                          b.handle, *_pose(position_b, orientation_b, "_b"))

    def time_of_impact(self, a: Shape, b: Shape, duration: float, motion_a: dict[str, Any] | None = None,
                       motion_b: dict[str, Any] | None = None, **how):
        """When two shapes that both travel and turn first touch, s.
        @param motion_a, motion_b  fields of carom_motion, None: it rests at the origin: position, orientation, center,
                                   linear_velocity (m/s), angular_velocity (rad/s)
        @return as ray_cast()"""
        return self._cast(raw.carom_shape_time_of_impact, how, a.handle, ctypes.byref(describe(raw.carom_motion, motion_a or {})),
                          b.handle, ctypes.byref(describe(raw.carom_motion, motion_b or {})), duration)

    def overlap(self, a: Shape, b: Shape, position_a=(0, 0, 0), position_b=(0, 0, 0), orientation_a=IDENTITY,
                orientation_b=IDENTITY, **how):
        """Whether two shapes overlap, with a proof. @return outcome ("apart", "overlapping", "touching"), normal or point"""
        desc = describe(raw.carom_cast_desc, how)
        result = raw.carom_overlap(struct_size=ctypes.sizeof(raw.carom_overlap))
        self._call(raw.carom_shape_overlap, a.handle, *_pose(position_a, orientation_a, "_a"), b.handle,
                   *_pose(position_b, orientation_b, "_b"), ctypes.byref(desc), ctypes.byref(result))
        return record(result, outcome=word("OVERLAP", result.outcome, OVERLAPS))

    def support(self, shape: Shape, directions):
        """Farthest points of a shape along directions, numpy arrays of rows of 3."""
        np = need_numpy("support()")
        along = np.ascontiguousarray(directions, dtype=np.float64).reshape(-1, 3)
        points = np.empty_like(along)
        real = ctypes.POINTER(ctypes.c_double)
        self._call(raw.carom_shape_support, shape.handle, along.ctypes.data_as(real), len(along), points.ctypes.data_as(real))
        return points
