"""Questions to a world between steps: rays, moving shapes, overlaps, what is nearest."""
from __future__ import annotations

import ctypes
import math
from typing import TYPE_CHECKING, Any, Callable, Sequence

from . import raw
from ._values import Record, ask, copy_out, enum, floats, handle_of, listed, need_numpy, number, numpy, record, shape_of, vec3, vector, word
from ._values import direction as way_of
from .records import WorldHitRecord

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from typing_extensions import Unpack

    from ._values import Rows, Vector
    from .records import QueryKeywords as QueryFields
    from .records import WantWord
    from .shape import Shape

    class QueryKeywords(QueryFields, total=False):
        ignore_touched: bool

OUTCOMES = ("miss", "hit", "overlap", "undecided", "bad_ray")


class RayHits(Record):
    """Of many rays, a row each: outcomes (0 a miss), colliders (handles), times, normals, points."""
    outcomes: NDArray[np.uint32]
    colliders: NDArray[np.uint64]
    times: NDArray[np.float64]
    normals: NDArray[np.float64]
    points: NDArray[np.float64]


class Hits(Record):
    """Of many queries, a row each: fields of carom_world_hit; colliders and bodies are handles."""
    outcomes: NDArray[np.uint32]
    queries: NDArray[np.uint32]
    colliders: NDArray[np.uint64]
    bodies: NDArray[np.uint64]
    times: NDArray[np.float64]
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    separations: NDArray[np.float64]
    normals: NDArray[np.float64]
    points: NDArray[np.float64]
    points_own: NDArray[np.float64]
    statuses: NDArray[np.uint32]


def rows_of(values: Any, width: int, name: str) -> Any:
    """Numbers as a packed numpy array (n, width)."""
    array = floats(values, name)
    if array.shape != (width,) and (array.ndim != 2 or array.shape[1] != width) and array.size:
        raise ValueError(f"{name} takes rows of {width} numbers, got shape {array.shape}")
    return numpy.ascontiguousarray(array, dtype=numpy.float64).reshape(-1, width)


def spread(array: NDArray[Any], shape: tuple[int, ...], name: str) -> Any:
    """As many rows as there are questions, packed, where one stands for all."""
    if array.shape not in (shape, shape[1:], (1, *shape[1:])):
        what = f"{shape[0]} rows of {shape[1]} numbers" if len(shape) > 1 else f"{shape[0]} numbers"
        raise ValueError(f"{name} takes {what}, or one for all, got shape {array.shape}")
    return numpy.ascontiguousarray(numpy.broadcast_to(array, shape), dtype=numpy.float64)


class Questions:
    """`how`: fields of carom_query_desc, as category=, mask=, ignore=body, tolerance=, target=, flags=.
    ignore_touched=True: what a ray or shape touches or overlaps at its start is passed over."""

    _call: Callable[..., None]
    _wrap: Callable[[str, int], Any]

    def _hit(self, found: Any) -> WorldHitRecord | None:
        """A record of carom_world_hit, or None for a miss."""
        if found.outcome == raw.CAROM_CAST_MISS:
            return None
        return record(WorldHitRecord, found, self._wrap, outcome=word("CAST", found.outcome, OUTCOMES))

    def ray(self, origin: Vector, direction: Vector, max: float = math.inf, **how: Unpack[QueryKeywords]) -> WorldHitRecord | None:
        """What origin + t direction, 0 <= t <= max, meets first.
        @return None, or: body, collider, point, normal, time (t), bracket [lower, upper], outcome"""
        found, desc = raw.carom_world_hit(), ask(raw.carom_query_desc, how)
        self._call(raw.carom_world_cast_ray, vec3(origin, "origin"), way_of(direction, "direction"), number(max, "max"), ctypes.byref(desc),
                   ctypes.byref(found), ctypes.sizeof(found))
        return self._hit(found)

    @staticmethod
    def _rays(origins: Any, directions: Any, max: Any) -> tuple[raw.carom_rays, Any, int]:
        """carom_rays of numpy arrays. Keep what is returned until after the call."""
        np = need_numpy("rays()")
        origins = rows_of(origins, 3, "origins")
        n = len(origins)
        directions = spread(floats(directions, "directions"), (n, 3), "directions")
        still = ~directions.any(axis=1)
        if still.any():
            directions = np.where(still[:, None], np.nan, directions)  # a ray without a direction: outcome 4, bad_ray
        ends = spread(floats(math.inf if max is None else max, "max"), (n,), "max")
        rays = raw.carom_rays(struct_size=ctypes.sizeof(raw.carom_rays), scalar=raw.CAROM_SCALAR_F64, count=n,
                              origins=origins.ctypes.data, directions=directions.ctypes.data, max=ends.ctypes.data)
        return rays, (origins, directions, ends), n

    def rays(self, origins: Rows, directions: Rows | Vector, max: float | Sequence[float] | NDArray[Any] | None = None,
             want: WantWord = "first", **how: Unpack[QueryKeywords]) -> RayHits:
        """Many at once, numpy arrays (n, 3). @param max  one number or (n,), default infinite
        @return arrays: outcomes (0 a miss, 4 a bad ray: no number, or no direction), colliders (handles), times, normals, points"""
        np = need_numpy("rays()")
        rays, alive, n = self._rays(origins, directions, max)
        outcomes, colliders = np.zeros(n, np.uint32), np.zeros(n, np.uint64)
        times, normals, points = np.zeros(n), np.zeros((n, 3)), np.zeros((n, 3))
        hits = raw.carom_world_hits(
            struct_size=ctypes.sizeof(raw.carom_world_hits), scalar=raw.CAROM_SCALAR_F64,
            outcomes=outcomes.ctypes.data_as(ctypes.POINTER(ctypes.c_uint32)),
            colliders=colliders.ctypes.data_as(ctypes.POINTER(ctypes.c_uint64)),
            times=times.ctypes.data, normals=normals.ctypes.data, points=points.ctypes.data)
        desc = ask(raw.carom_query_desc, how)
        self._call(raw.carom_world_cast_rays, ctypes.byref(rays), enum("WANT", want, "want"), ctypes.byref(desc), ctypes.byref(hits))
        return RayHits(outcomes=outcomes, colliders=colliders, times=times, normals=normals, points=points)

    def rays_all(self, origins: Rows, directions: Rows | Vector, max: float | Sequence[float] | NDArray[Any] | None = None,
                 **how: Unpack[QueryKeywords]) -> Hits:
        """All that each of many rays meets: by query, then by time. @return arrays as of casts()"""
        rays, alive, _ = self._rays(origins, directions, max)
        desc = ask(raw.carom_query_desc, how)
        return self._arrays(copy_out(self._call, raw.carom_world_cast_rays_all, raw.carom_world_hit, ctypes.byref(rays),
                                     ctypes.byref(desc)))

    @staticmethod
    def _one_shape(shape: Shape | None, position: Vector, orientation: Vector,
                   motion: Vector | None) -> tuple[raw.carom_query_shapes, Any]:
        """carom_query_shapes of one; `shape` None is a point. Keep what is returned until after the call."""
        handle = ctypes.c_uint64(handle_of(shape, "shape", "carom_shape"))
        at, turned = vec3(position, "position"), vector(orientation, 4, "orientation")
        way = None if motion is None else vec3(motion, "motion")
        asking = raw.carom_query_shapes(
            struct_size=ctypes.sizeof(raw.carom_query_shapes), scalar=raw.CAROM_SCALAR_F64, count=1,
            shapes=ctypes.pointer(handle), positions=ctypes.addressof(at), orientations=ctypes.addressof(turned),
            motions=None if way is None else ctypes.addressof(way))
        return asking, (handle, at, turned, way)

    @staticmethod
    def _shapes(shapes: Any, positions: Any, orientations: Any, motions: Any) -> tuple[raw.carom_query_shapes, Any, int]:
        """carom_query_shapes of many. @param shapes  one for all, one each, or None: points. Keep what is returned."""
        np = need_numpy("many shapes")
        if shapes is not None and not hasattr(shapes, "handle"):
            shapes = listed(shapes, "shapes", "a Shape, or one for each")
        rows = [np.atleast_2d(floats(a, name)) for a, name in ((positions, "positions"), (motions, "motions")) if a is not None]
        n = max([len(a) for a in rows] + [1 if shapes is None or hasattr(shapes, "handle") else len(shapes)])

        def each_of(values: Any, width: int, name: str) -> Any:
            return None if values is None else spread(floats(values, name), (n, width), name)

        at, turned, way = each_of(positions, 3, "positions"), each_of(orientations, 4, "orientations"), each_of(motions, 3, "motions")
        if shapes is not None and not hasattr(shapes, "handle") and len(shapes) not in (1, n):
            raise ValueError(f"shapes takes {n}, or one for all, got {len(shapes)}")
        each = None if shapes is None else np.ascontiguousarray(np.broadcast_to(
            np.asarray([shape_of(s, "shapes") for s in ([shapes] if hasattr(shapes, "handle") else shapes)], dtype=np.uint64), (n,)))

        def address(array: Any) -> int | None:
            return None if array is None else int(array.ctypes.data)

        asking = raw.carom_query_shapes(
            struct_size=ctypes.sizeof(raw.carom_query_shapes), scalar=raw.CAROM_SCALAR_F64, count=n,
            shapes=None if each is None else each.ctypes.data_as(ctypes.POINTER(ctypes.c_uint64)),
            positions=address(at), orientations=address(turned), motions=address(way))
        return asking, (each, at, turned, way), n

    @staticmethod
    def _arrays(found: Any) -> Hits:
        """Records of carom_world_hit as arrays, a row each."""
        rows = numpy.ctypeslib.as_array(found) if len(found) else numpy.zeros(0, numpy.dtype(raw.carom_world_hit))
        names = {"outcome": "outcomes", "query": "queries", "collider": "colliders", "body": "bodies", "time": "times",
                 "lower": "lower", "upper": "upper", "separation": "separations", "normal": "normals", "point": "points",
                 "point_own": "points_own", "status": "statuses"}
        return Hits(**{name: rows[field].copy() for field, name in names.items()})

    def _each(self, function: Callable[..., int], asking: raw.carom_query_shapes, n: int, *between: object) -> Hits:
        found = (raw.carom_world_hit * n)()
        self._call(function, ctypes.byref(asking), *between, found, ctypes.sizeof(raw.carom_world_hit))
        return self._arrays(found)

    def casts(self, shapes: Shape | Sequence[Shape], positions: Rows | Vector, motions: Rows | Vector,
              orientations: Rows | Vector | None = None, want: WantWord = "first", **how: Unpack[QueryKeywords]) -> Hits:
        """What each of many shapes meets first as it moves by its motion without turning: numpy arrays.
        @param shapes  one for all, or one each   @param positions, motions  (n, 3) m   @param orientations  (n, 4) or None
        @return arrays by query: outcomes (0 a miss), colliders and bodies (handles), times (fractions of the motion),
                lower, upper, separations, normals, points, points_own"""
        asking, alive, n = self._shapes(shapes, positions, orientations, motions)
        desc = ask(raw.carom_query_desc, how)
        return self._each(raw.carom_world_cast_shapes, asking, n, enum("WANT", want, "want"), ctypes.byref(desc))

    def nearests(self, positions: Rows | Vector, shapes: Shape | Sequence[Shape] | None = None, reach: float = math.inf,
                 orientations: Rows | Vector | None = None, **how: Unpack[QueryKeywords]) -> Hits:
        """The collider nearest to each of many points or shapes. @return arrays as of casts()"""
        asking, alive, n = self._shapes(shapes, positions, orientations, None)
        desc = ask(raw.carom_query_desc, how)
        return self._each(raw.carom_world_find_nearest, asking, n, number(reach, "reach"), ctypes.byref(desc))

    def casts_all(self, shapes: Shape | Sequence[Shape], positions: Rows | Vector, motions: Rows | Vector,
                  orientations: Rows | Vector | None = None, **how: Unpack[QueryKeywords]) -> Hits:
        """All that each of many moving shapes meets: by query, then by time. @return arrays as of casts()"""
        asking, alive, _ = self._shapes(shapes, positions, orientations, motions)
        desc = ask(raw.carom_query_desc, how)
        return self._arrays(copy_out(self._call, raw.carom_world_cast_shapes_all, raw.carom_world_hit, ctypes.byref(asking),
                                     ctypes.byref(desc)))

    def overlaps_all(self, shapes: Shape | Sequence[Shape], positions: Rows | Vector,
                     orientations: Rows | Vector | None = None, **how: Unpack[QueryKeywords]) -> Hits:
        """All that each of many shapes overlaps, by query. @return arrays as of casts()"""
        asking, alive, _ = self._shapes(shapes, positions, orientations, None)
        desc = ask(raw.carom_query_desc, how)
        return self._arrays(copy_out(self._call, raw.carom_world_overlap_shapes, raw.carom_world_hit, ctypes.byref(asking),
                                     ctypes.byref(desc)))

    def cast(self, shape: Shape, position: Vector, motion: Vector, orientation: Vector = (0, 0, 0, 1),
             **how: Unpack[QueryKeywords]) -> WorldHitRecord | None:
        """What a shape meets first as it moves by `motion`, m, without turning; time is a fraction of it. @return as ray()"""
        asking, alive = self._one_shape(shape, position, orientation, motion)
        found, desc = raw.carom_world_hit(), ask(raw.carom_query_desc, how)
        self._call(raw.carom_world_cast_shapes, ctypes.byref(asking), raw.CAROM_WANT_FIRST, ctypes.byref(desc),
                   ctypes.byref(found), ctypes.sizeof(found))
        return self._hit(found)

    def nearest(self, position: Vector, shape: Shape | None = None, reach: float = math.inf, orientation: Vector = (0, 0, 0, 1),
                **how: Unpack[QueryKeywords]) -> WorldHitRecord | None:
        """The collider nearest to a point or a shape. @return None, or as ray() with separation, m"""
        asking, alive = self._one_shape(shape, position, orientation, None)
        found, desc = raw.carom_world_hit(), ask(raw.carom_query_desc, how)
        self._call(raw.carom_world_find_nearest, ctypes.byref(asking), number(reach, "reach"), ctypes.byref(desc), ctypes.byref(found),
                   ctypes.sizeof(found))
        return self._hit(found)

    def overlaps(self, shape: Shape, position: Vector, orientation: Vector = (0, 0, 0, 1),
                 **how: Unpack[QueryKeywords]) -> list[WorldHitRecord]:
        """All that a shape at a place overlaps. @return list of records as of ray()"""
        asking, alive = self._one_shape(shape, position, orientation, None)
        desc = ask(raw.carom_query_desc, how)
        found = copy_out(self._call, raw.carom_world_overlap_shapes, raw.carom_world_hit, ctypes.byref(asking), ctypes.byref(desc))
        return [one for one in map(self._hit, found) if one is not None]
