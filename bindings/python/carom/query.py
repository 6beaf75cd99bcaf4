"""Questions to a world between steps: rays, moving shapes, overlaps, what is nearest."""
from __future__ import annotations

import ctypes
import math
from typing import Any, Callable, Sequence

from . import raw
from ._values import Record, describe, enum, need_numpy, record, vec3, word

OUTCOMES = ("miss", "hit", "overlap", "undecided", "bad_ray")


class Questions:
    """`how`: fields of carom_query_desc, as category=, mask=, ignore=body, tolerance=, target=, flags=."""

    _call: Callable[..., None]
    _wrap: Callable[[str, int], Any]

    def _hit(self, found):
        """A record of carom_world_hit, or None for a miss."""
        if found.outcome == raw.CAROM_CAST_MISS:
            return None
        return record(found, self._wrap, outcome=word("CAST", found.outcome, OUTCOMES))

    def ray(self, origin: Sequence[float], direction: Sequence[float], max: float = math.inf, **how):
        """What origin + t direction, 0 <= t <= max, meets first.
        @return None, or: body, collider, point, normal, time (t), bracket [lower, upper], outcome"""
        found, desc = raw.carom_world_hit(), describe(raw.carom_query_desc, how)
        self._call(raw.carom_world_cast_ray, vec3(origin, "origin"), vec3(direction, "direction"), max, ctypes.byref(desc),
                   ctypes.byref(found), ctypes.sizeof(found))
        return self._hit(found)

    def rays(self, origins, directions, max=None, want: str = "first", **how):
        """Many at once, numpy arrays (n, 3). @param max  one number or (n,), default infinite
        @return arrays: outcomes (0 a miss), colliders (handles), times, normals, points"""
        np = need_numpy("rays()")
        origins = np.ascontiguousarray(origins, dtype=np.float64).reshape(-1, 3)
        directions = np.ascontiguousarray(np.broadcast_to(np.asarray(directions, dtype=np.float64), origins.shape))
        n = len(origins)
        ends = np.ascontiguousarray(np.broadcast_to(np.asarray(math.inf if max is None else max, dtype=np.float64), (n,)))
        rays = raw.carom_rays(struct_size=ctypes.sizeof(raw.carom_rays), scalar=raw.CAROM_SCALAR_F64, count=n,
                              origins=origins.ctypes.data, directions=directions.ctypes.data, max=ends.ctypes.data)
        outcomes, colliders = np.zeros(n, np.uint32), np.zeros(n, np.uint64)
        times, normals, points = np.zeros(n), np.zeros((n, 3)), np.zeros((n, 3))
        hits = raw.carom_world_hits(
            struct_size=ctypes.sizeof(raw.carom_world_hits), scalar=raw.CAROM_SCALAR_F64,
            outcomes=outcomes.ctypes.data_as(ctypes.POINTER(ctypes.c_uint32)),
            colliders=colliders.ctypes.data_as(ctypes.POINTER(ctypes.c_uint64)),
            times=times.ctypes.data, normals=normals.ctypes.data, points=points.ctypes.data)
        desc = describe(raw.carom_query_desc, how)
        self._call(raw.carom_world_cast_rays, ctypes.byref(rays), enum("WANT", want), ctypes.byref(desc), ctypes.byref(hits))
        return Record(outcomes=outcomes, colliders=colliders, times=times, normals=normals, points=points)

    @staticmethod
    def _one_shape(shape, position, orientation, motion):
        """carom_query_shapes of one; `shape` None is a point. Keep what is returned until after the call."""
        handle = ctypes.c_uint64(0 if shape is None else shape.handle)
        at, turned = vec3(position, "position"), (ctypes.c_double * 4)(*orientation)
        way = None if motion is None else vec3(motion, "motion")
        asking = raw.carom_query_shapes(
            struct_size=ctypes.sizeof(raw.carom_query_shapes), scalar=raw.CAROM_SCALAR_F64, count=1,
            shapes=ctypes.pointer(handle), positions=ctypes.addressof(at), orientations=ctypes.addressof(turned),
            motions=None if way is None else ctypes.addressof(way))
        return asking, (handle, at, turned, way)

    def cast(self, shape, position: Sequence[float], motion: Sequence[float], orientation: Sequence[float] = (0, 0, 0, 1), **how):
        """What a shape meets first as it moves by `motion`, m, without turning; time is a fraction of it. @return as ray()"""
        asking, alive = self._one_shape(shape, position, orientation, motion)
        found, desc = raw.carom_world_hit(), describe(raw.carom_query_desc, how)
        self._call(raw.carom_world_cast_shapes, ctypes.byref(asking), raw.CAROM_WANT_FIRST, ctypes.byref(desc),
                   ctypes.byref(found), ctypes.sizeof(found))
        return self._hit(found)

    def nearest(self, position: Sequence[float], shape=None, reach: float = math.inf, orientation: Sequence[float] = (0, 0, 0, 1), **how):
        """The collider nearest to a point or a shape. @return None, or as ray() with separation, m"""
        asking, alive = self._one_shape(shape, position, orientation, None)
        found, desc = raw.carom_world_hit(), describe(raw.carom_query_desc, how)
        self._call(raw.carom_world_find_nearest, ctypes.byref(asking), reach, ctypes.byref(desc), ctypes.byref(found),
                   ctypes.sizeof(found))
        return self._hit(found)

    def overlaps(self, shape, position: Sequence[float], orientation: Sequence[float] = (0, 0, 0, 1), **how):
        """All that a shape at a place overlaps. @return list of records as of ray()"""
        asking, alive = self._one_shape(shape, position, orientation, None)
        desc, count, capacity = describe(raw.carom_query_desc, how), ctypes.c_uint64(), 0
        stride = ctypes.sizeof(raw.carom_world_hit)
        while True:
            found = (raw.carom_world_hit * capacity)()
            self._call(raw.carom_world_overlap_shapes, ctypes.byref(asking), ctypes.byref(desc), found if capacity else None,
                       stride, capacity, ctypes.byref(count))
            if count.value <= capacity:
                return [self._hit(hit) for hit in found[:count.value]]
            capacity = count.value
