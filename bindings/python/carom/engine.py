"""The first root: plugins, shapes, threads of work; and queries of shapes without a world."""
from __future__ import annotations

import ctypes
import os
import sys
import weakref
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Iterable, Sequence

from . import raw
from ._root import Root, check, count_of
from ._values import bits, describe, doubles, handle_of, listed, number, shape_of, vec3, vector, whole
from .errors import AlreadyExists, NotFound
from .host import Allocator, Jobs, put_allocator, put_jobs
from .pair import PairQuestions
from .shape import Shape
from .support import Support, SupportPlugin
from .world import World

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._values import Rows, Vector
    from .batch import Batch
    from .device import Device
    from .records import DialKeywords, FormWord


PLUGIN_SUFFIX = ".dll" if sys.platform == "win32" else ".so"


def _file_of_library() -> Path:
    """Where the library is, also where the system's loader found it by its name."""
    class Info(ctypes.Structure):
        _fields_ = [("file", ctypes.c_char_p), ("base", ctypes.c_void_p), ("name", ctypes.c_char_p), ("address", ctypes.c_void_p)]

    info = Info()
    if not os.path.dirname(raw.LIBRARY) and os.name == "posix":
        if ctypes.CDLL(None).dladdr(ctypes.cast(raw.lib.carom_version, ctypes.c_void_p), ctypes.byref(info)) and info.file:
            return Path(os.fsdecode(info.file))
    return Path(raw.LIBRARY)


def plugin_folders() -> list[Path]:
    """Where shape plugins are looked for: $CAROM_PLUGIN_DIR, this package, beside the library."""
    library = _file_of_library()
    given = os.environ.get("CAROM_PLUGIN_DIR")
    return ([Path(given)] if given else []) + [Path(__file__).parent / "lib" / "plugins", library.parent / "carom" / "plugins",
                                               library.parent.parent / "plugins"]


class Engine(Root, PairQuestions):
    """Owns plugins and shapes; makes worlds. Closing it closes its worlds and batches.

        with carom.Engine(threads=2) as engine, engine.world() as world: ...

    threads  how many share the work of each step; the outcome is the same to the bit
    log      called with (level, text), level 1 to 3
    allocator  gives the memory of all that grows with a scene, @see host.Allocator
    jobs     who shares the work of a step in place of `threads`: called with (job, count), it sees to it that job(begin, end) is
             called for ranges that cover 0 up to count, on any threads at once, and returns when all these calls have. What it
             leaves out is done when it returns. share(executor, parts) makes one.
    """

    _kind = "engine"

    def __init__(self, threads: int = 1, log: Callable[[int, str], None] | None = None, *, allocator: Allocator | None = None,
                 jobs: Jobs | None = None):
        threads = whole(threads, "threads", 0, 256, usual=1)
        if jobs is not None and threads > 1:
            raise ValueError("either threads of the engine's own or jobs of the host's, not both")
        desc = describe(raw.carom_engine_desc, {})
        alive: list[Any] = []
        if allocator is not None:
            alive += put_allocator(desc, allocator)
        if log is not None:
            callback = type(desc.log)(lambda _, level, text: log(level, text.decode("utf-8", "replace")))
            desc.log = callback
            alive.append(callback)
        pointer = ctypes.c_void_p()
        check(raw.carom_engine_create, ctypes.byref(desc), ctypes.byref(pointer))
        super().__init__(pointer.value, raw.carom_engine_destroy, *alive)
        self._worlds: weakref.WeakSet[World] = weakref.WeakSet()
        self._batches: weakref.WeakSet[Batch | Device] = weakref.WeakSet()
        self._plugins: dict[str, int] = {}
        self._threads = None if jobs is not None else max(threads, 1)
        if threads > 1 or jobs is not None:
            who = describe(raw.carom_jobs_desc, {"threads": threads if jobs is None else 0})
            if jobs is not None:
                self._owner.alive += put_jobs(who, jobs)
            self._call(raw.carom_engine_set_jobs, ctypes.byref(who))

    def __repr__(self) -> str:
        if self._closed:
            return "<carom.Engine, closed>"
        who = "jobs of the host's" if self._threads is None else count_of(self._threads, "thread")
        return f"<carom.Engine: {count_of(sum(not world.closed for world in self._worlds), 'world')}, {who}>"

    def close(self) -> None:
        if not self._closed:
            for batch in list(self._batches):
                batch.close()
            for world in list(self._worlds):
                world.close()
        super().close()

    def world(self, gravity: Vector | None = None, body_capacity: int | None = None, **dials: Unpack[DialKeywords]) -> World:
        """An empty world.
        @param gravity  m/s^2, default (0, -9.81, 0)   @param dials  as of World.dials: substeps=8, solver="direct" """
        return World(self, describe(raw.carom_world_desc, {"gravity": gravity, "body_capacity": body_capacity}), dials)

    # ---- shapes ----

    def load_plugin(self, path: str | os.PathLike[str]) -> int:
        """Load a shape plugin from a file. @return its handle, for shape()"""
        plugin = ctypes.c_uint64()
        self._call(raw.carom_plugin_load, os.fsencode(os.path.abspath(path)), ctypes.byref(plugin))
        return plugin.value

    def plugin(self, id: str) -> int:
        """The handle of a plugin that is loaded, or found as NAME.so (Windows: NAME.dll) of "carom.NAME" in plugin_folders()."""
        if id not in self._plugins:
            try:
                self._plugins[id] = self._find_plugin(id)
            except NotFound:
                file = id.rpartition(".")[2] + PLUGIN_SUFFIX
                found = next((folder / file for folder in plugin_folders() if (folder / file).exists()), None)
                if found is None:
                    raise
                try:
                    self._plugins[id] = self.load_plugin(found)
                except AlreadyExists:  # another thread was faster
                    self._plugins[id] = self._find_plugin(id)
        return self._plugins[id]

    def _find_plugin(self, id: str) -> int:
        handle = ctypes.c_uint64()
        self._call(raw.carom_plugin_find, id.encode(), ctypes.byref(handle))
        return handle.value

    def shape(self, plugin: str | int, params: Iterable[float]) -> Shape:
        """A shape of a plugin, by its id ("carom.sphere") or handle, with the parameters that the plugin documents."""
        values = listed(params, "params", "numbers")
        handle = ctypes.c_uint64()
        of = self.plugin(plugin) if isinstance(plugin, str) else handle_of(plugin, "plugin", "carom_plugin", or_none=False)
        self._call(raw.carom_shape_create, of, vector(values, len(values), "params"), len(values), ctypes.byref(handle))
        return Shape(self, handle.value)

    def sphere(self, radius: float) -> Shape:
        return self.shape("carom.sphere", (number(radius, "radius"),))

    def box(self, x: float, y: float, z: float) -> Shape:
        """@param x, y, z  m, half extents"""
        return self.shape("carom.box", (number(x, "x"), number(y, "y"), number(z, "z")))

    def capsule(self, radius: float, half_height: float) -> Shape:
        """Axis y. @param half_height  m, of the segment between the two balls' centres"""
        return self.shape("carom.capsule", (number(radius, "radius"), number(half_height, "half_height")))

    def tapered_capsule(self, radius_bottom: float, radius_top: float, half_height: float) -> Shape:
        """The hull of two balls on the axis y. @param half_height  m, from the middle to the centre of a ball"""
        return self.shape("carom.tapered_capsule", (number(radius_bottom, "radius_bottom"), number(radius_top, "radius_top"),
                                                    number(half_height, "half_height")))

    def cylinder(self, radius: float, half_height: float) -> Shape:
        """Axis y."""
        return self.shape("carom.cylinder", (number(radius, "radius"), number(half_height, "half_height")))

    def cone(self, radius: float, half_height: float) -> Shape:
        """Axis y, apex up."""
        return self.shape("carom.cone", (number(radius, "radius"), number(half_height, "half_height")))

    def ellipsoid(self, x: float, y: float, z: float) -> Shape:
        """@param x, y, z  m, radii"""
        return self.shape("carom.ellipsoid", (number(x, "x"), number(y, "y"), number(z, "z")))

    def hull(self, points: Iterable[Vector]) -> Shape:
        """The convex hull of points, m."""
        rows = [vec3(point, f"points[{i}]") for i, point in enumerate(listed(points, "points", "rows of 3 numbers"))]
        return self.shape("carom.hull", (x for row in rows for x in row))

    def hull_of(self, parts: Iterable[Shape | Sequence[Any]], radius: float = 0) -> Shape:
        """The convex hull of shapes. A part is a shape, or (shape, position), (shape, position, orientation) or (shape,
        position, orientation, scale). A shape at two places gives its sweep, one part with a scale a scaled shape, one
        with a radius a rounded shape.
        @param radius  m, by which all of it grows"""
        grown = number(radius, "radius")
        rows = [part if isinstance(part, (tuple, list)) else (part,) for part in listed(parts, "parts", "shapes")]
        for i, row in enumerate(rows):
            if not 1 <= len(row) <= 4:
                raise ValueError(f"parts[{i}] takes a shape, position, orientation, scale; got {len(row)} values")
        handles = (ctypes.c_uint64 * len(rows))(*(shape_of(row[0], f"parts[{i}]") for i, row in enumerate(rows)))

        def column(at: int, usual: tuple[float, ...], name: str) -> ctypes.Array[ctypes.c_double]:
            each = [vector(row[at], len(usual), f"{name} of parts[{i}]") if len(row) > at else usual for i, row in enumerate(rows)]
            return (ctypes.c_double * (len(usual) * len(rows)))(*(x for row in each for x in row))

        handle = ctypes.c_uint64()
        self._call(raw.carom_shape_create_hull_of, handles, len(rows), column(1, (0, 0, 0), "position"),
                   column(2, (0, 0, 0, 1), "orientation"), column(3, (1, 1, 1), "scale"), grown,
                   ctypes.byref(handle))
        return Shape(self, handle.value)

    def half_space(self, normal: Vector = (0, 1, 0), offset: float = 0) -> Shape:
        """All x with normal . x <= offset: ground without end, for static bodies."""
        handle = ctypes.c_uint64()
        self._call(raw.carom_shape_create_half_space, vec3(normal, "normal"), number(offset, "offset"), ctypes.byref(handle))
        return Shape(self, handle.value)

    def mesh(self, vertices: Rows, triangles: Iterable[Sequence[int]] | Rows, two_sided: bool = False) -> Shape:
        """A surface of triangles, for static and kinematic bodies. @param vertices  rows of 3, m
        @param triangles  rows of 3 indices, counter-clockwise seen from outside"""
        faces = [listed(row, f"triangles[{i}]", "3 indices") for i, row in enumerate(listed(triangles, "triangles", "rows of 3 indices"))]
        if any(len(row) != 3 for row in faces):
            raise ValueError(f"triangles takes rows of 3 indices, got one of {next(len(row) for row in faces if len(row) != 3)}")
        corners = [whole(corner, f"triangles[{i}]") for i, row in enumerate(faces) for corner in row]
        address, count, alive = doubles(vertices, 3, "vertices")
        desc = describe(raw.carom_mesh_desc, {"flags": bits("SCENERY", "two_sided", "two_sided") if two_sided else 0})
        desc.vertices, desc.vertex_count = ctypes.cast(address, ctypes.POINTER(ctypes.c_double)), count
        desc.triangles, desc.triangle_count = (ctypes.c_uint32 * len(corners))(*corners), len(corners) // 3
        handle = ctypes.c_uint64()
        self._call(raw.carom_shape_create_mesh, ctypes.byref(desc), ctypes.byref(handle))
        del alive
        return Shape(self, handle.value)

    def height_field(self, heights: Rows, spacing: Vector = (1, 1)) -> Shape:
        """Ground from a grid. @param heights  [rows along z][columns along x] m, NaN for a hole   @param spacing  m, along x, z"""
        rows = [tuple(number(h, f"heights[{i}]") for h in listed(row, f"heights[{i}]", "numbers"))
                for i, row in enumerate(listed(heights, "heights", "rows of numbers"))]
        columns = len(rows[0]) if rows else 0
        address, count, alive = doubles(rows, columns, "heights")
        desc = describe(raw.carom_height_field_desc, {"columns": columns, "rows": count, "spacing": spacing})
        desc.heights = ctypes.cast(address, ctypes.POINTER(ctypes.c_double))
        handle = ctypes.c_uint64()
        self._call(raw.carom_shape_create_height_field, ctypes.byref(desc), ctypes.byref(handle))
        del alive
        return Shape(self, handle.value)

    def support_plugin(self, support: Support, id: str, params: Sequence[tuple[str, str, float, float]] = (),
                       form: FormWord | None = None, args: Sequence[int] = (), core_radius: int | None = None, version: int = 1,
                       tail_group: int = 0, tail_min: int = 0) -> SupportPlugin:
        """A kind of shape whose support function is written in Python; see support.py.

            box = engine.support_plugin(lambda p, d: tuple(math.copysign(h, x) for h, x in zip(p, d)), "my.box",
                                        params=[("x", "m", 1e-6, 1e3), ("y", "m", 1e-6, 1e3), ("z", "m", 1e-6, 1e3)])
            die = box(0.5, 0.5, 0.5)
        """
        return SupportPlugin(self, support, id, params, form, args, core_radius, version, tail_group, tail_min)
