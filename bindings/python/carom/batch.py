"""Many worlds at once: copies of one world, or of several, that step on the engine's threads; numbers go in and out as arrays.

    with carom.Engine(threads=2) as engine, engine.world() as world:
        world.ground()
        ball = world.body(engine.sphere(0.1), position=(0, 1, 0))
        batch = carom.Batch(world, 1000)
        speed = batch.column("bodies", "linear_velocity", [ball])
        place = batch.column("bodies", "position", [ball], when="after_step")
        speed.array[:] = batch.random(3, "normal")
        batch.write(speed)
        batch.step(1 / 60, 60)
        print(place.array.mean(axis=0))

A world goes on to the bit as it would alone, whatever the number of worlds and threads.
"""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Iterable, Literal, Sequence, Union

from . import raw
from ._root import Root, check, count_of
from ._values import copy_out, describe, enum, floats, handle_of, need_numpy, number, record, whole, word
from .bulk import handles_of, width_of
from .records import BatchInfoRecord, FaultRecord
from .report import FAULTS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._values import Rows
    from .body import Body
    from .joint import Joint
    from .world import World

    Mask = Union[NDArray[Any], Sequence[bool], None]

_KIND = {raw.CAROM_COLUMN_JOINTS: "carom_joint", raw.CAROM_COLUMN_MATERIALS: "carom_material"}
_WIDTH = {raw.CAROM_COLUMN_MASSES: 1, raw.CAROM_COLUMN_MATERIALS: 2, raw.CAROM_COLUMN_GRAVITY: 3, raw.CAROM_COLUMN_TIME: 1,
          raw.CAROM_COLUMN_CONTACT_FORCES: 3, raw.CAROM_COLUMN_RAYS: 1}
_OF_WORLD = (raw.CAROM_COLUMN_GRAVITY, raw.CAROM_COLUMN_TIME)


class Column:
    """Numbers of the worlds of one structure, made by Batch.column().

    array   (worlds, things, numbers): the memory that the batch reads and writes. It has DLPack: torch.from_dlpack(column.array)
    number  by which the library knows it
    """

    def __init__(self, batch: Batch, number: int, array: NDArray[Any], what: str) -> None:
        self.batch, self.number, self.array, self._what = batch, number, array, what

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return self.array if dtype is None or dtype == self.array.dtype else self.array.astype(dtype)

    def __dlpack__(self, **about: Any) -> Any:
        return self.array.__dlpack__(**about)

    def __dlpack_device__(self) -> Any:
        return self.array.__dlpack_device__()

    def __repr__(self) -> str:
        return f"<carom.Column {self.number}: {self._what}, {self.array.shape} of {self.array.dtype}>"


class _Writable:
    """Memory of an array that numpy took for read only."""

    def __init__(self, array: Any) -> None:
        self.array = array
        interface = dict(array.__array_interface__)
        interface["data"] = (interface["data"][0], False)
        self.__array_interface__ = interface


def _from_dlpack(np: Any, out: Any) -> Any:
    """numpy before 2.1 takes whatever comes by DLPack for read only, since that did not say."""
    array = np.from_dlpack(out)
    says = tuple(int(part) for part in np.__version__.split(".")[:2]) >= (2, 1)
    return array if says or array.flags.writeable else np.asarray(_Writable(array))


class Batch(Root):
    """n worlds that are as `world` is now; add_worlds() adds others. `seed` is that of random(), `first` the number that the first
    world has there: a part of a larger batch gives the numbers that the whole one would."""

    _kind = "batch"

    def __init__(self, world: World, n: int, *, seed: int = 0, first: int = 0) -> None:
        self._np: Any = need_numpy("carom.Batch")
        n = whole(n, "n", 1, 2**24)
        self.seed, self.first = whole(seed, "seed", 0, 2**64 - 1), whole(first, "first", 0, 2**63)
        self.engine = world.engine
        pointer = ctypes.c_void_p()
        self.engine._call(raw.carom_batch_create, ctypes.byref(pointer))
        super().__init__(pointer.value, raw.carom_batch_destroy, self.engine._owner)
        self.engine._batches.add(self)
        self._columns: list[Column] = []
        self._ranges: list[range] = []
        self.draws: NDArray[np.uint64] = self._np.zeros(0, self._np.uint64)
        try:
            self.add_worlds(world, n)
        except BaseException:
            self.close()
            raise

    def __repr__(self) -> str:
        return "<carom.Batch, closed>" if self._closed else f"<carom.Batch: {count_of(len(self), 'world')}, {count_of(len(self._columns), 'column')}>"

    def __len__(self) -> int:
        return len(self.draws)

    def add_worlds(self, world: World, n: int) -> range:
        """n more that are as this world is now, of any structure. @return their numbers"""
        n = whole(n, "n", 1, 2**24)
        first = ctypes.c_uint64()
        if getattr(world, "engine", None) is not self.engine:
            raise ValueError(f"world takes a World of the batch's engine, got {world!r}")
        self._call(raw.carom_batch_add_worlds, world._pointer, n, ctypes.byref(first))
        made = range(first.value, first.value + n)
        self._ranges.append(made)
        self.draws = self._np.concatenate([self.draws, self._np.zeros(n, self._np.uint64)])
        return made

    # ---- columns ----

    def column(self, source: str | int, field: str | int | None = None, things: Iterable[Any] | None = None, *, when: str | int = "on_call",
               dtype: Any = "float64", out: Any = None, world: int = 0, rays: Rows | None = None) -> Column:
        """Numbers of each world, in an array that the batch reads and writes in place.
        @param source  "bodies", "joints", "masses", "materials" (friction, restitution), "gravity", "time", "contact_forces", "rays"
        @param field   of bodies as World.read() has them, of joints as World.read_joints()
        @param things  the world's own bodies, joints or materials, or their handles; of rays the body each goes with, or None
        @param when    "before_step": written before each step; "after_step": read after it, and after calls that change worlds
        @param out     an array of yours: (worlds, things, numbers) of float64 or float32, numpy's or one with DLPack in host memory
        @param world   the number of a world of the structure
        @param rays    rows of 7: origin, direction, how many directions far"""
        np = self._np
        kind = enum("COLUMN", source, "source")
        desc = describe(raw.carom_batch_column, {"world": whole(world, "world", 0, 2**63)})
        desc.source, desc.when = kind, enum("WHEN", when, "when")
        if kind in (raw.CAROM_COLUMN_BODIES, raw.CAROM_COLUMN_JOINTS):
            if field is None:
                raise ValueError(f"field is missing: {source} have many, as 'position'")
            desc.field = enum("FIELD" if kind == raw.CAROM_COLUMN_BODIES else "JOINT_BULK", field, "field")
        elif field is not None:
            raise ValueError(f"field belongs to bodies and joints; {source} have none")
        width = self._width(kind, desc.field, field)
        alive: Any = None
        if kind in _OF_WORLD:
            n = desc.n = 1
        else:
            if things is None:
                raise ValueError("things are missing: list what the column is of")
            if kind == raw.CAROM_COLUMN_RAYS and not isinstance(things, np.ndarray):
                things = np.array([handle_of(thing, f"things[{i}]", "carom_body") for i, thing in enumerate(things)], np.uint64)
            handles, n, alive = handles_of(things, "things", _KIND.get(kind, "carom_body"))
            desc.handles, desc.n = ctypes.cast(handles, ctypes.POINTER(ctypes.c_uint64)), n
        if rays is not None:
            packed = np.ascontiguousarray(floats(rays, "rays"), np.float64)
            if packed.shape != (n, 7):
                raise ValueError(f"rays takes {n} rows of 7 numbers, one for each of things, got {packed.shape}")
            desc.rays = ctypes.cast(packed.ctypes.data, ctypes.POINTER(ctypes.c_double))
        worlds = next((len(known) for known in self._ranges if world in known), 0)
        array = self._room(out, (worlds, n, width), dtype)
        desc.data, desc.stride = array.ctypes.data, array.strides[0] if worlds > 1 else 0
        desc.scalar = raw.CAROM_SCALAR_F64 if array.dtype == np.float64 else raw.CAROM_SCALAR_F32
        made = ctypes.c_uint32()
        self._call(raw.carom_batch_add_column, ctypes.byref(desc), ctypes.byref(made))
        del alive
        about = f"{word('COLUMN', kind, ('bodies', 'joints', 'masses', 'materials', 'gravity', 'time', 'contact_forces', 'rays'))}"
        column = Column(self, made.value, array, about if field is None else f"{about} {field}")
        self._columns.append(column)
        self._owner.alive.append(array)
        return column

    def _width(self, kind: int, number: int, field: Any) -> int:
        if kind == raw.CAROM_COLUMN_BODIES:
            return width_of(number)
        if kind == raw.CAROM_COLUMN_JOINTS:
            width = ctypes.c_uint32()
            if raw.carom_joint_bulk_width(number, ctypes.byref(width)) != raw.CAROM_OK:
                raise ValueError(f"field is {field}, which joints do not have")
            return width.value
        return _WIDTH.get(kind, 1)

    def _room(self, out: Any, shape: tuple[int, ...], dtype: Any) -> Any:
        np = self._np
        if out is None:
            made = np.dtype(dtype)
            if made not in (np.float64, np.float32):
                raise ValueError(f"dtype takes float64 or float32, got {dtype!r}")
            return np.zeros(shape, made)
        array = out if isinstance(out, np.ndarray) else _from_dlpack(np, out) if hasattr(out, "__dlpack__") else None
        if array is None:
            raise TypeError(f"out takes an array of numpy's, or one with DLPack, got a {type(out).__name__}")
        if array.dtype not in (np.float64, np.float32) or array.shape != shape:
            raise ValueError(f"out takes an array of float64 or float32 of shape {shape}, got {array.dtype} {array.shape}")
        packed = shape[2] * array.itemsize
        if (shape[2] > 1 and array.strides[2] != array.itemsize) or (shape[1] > 1 and array.strides[1] != packed) or \
                (shape[0] > 1 and array.strides[0] < packed * shape[1]):
            raise ValueError("each world's row of out must lie in one piece, one after the other")
        if not array.flags.writeable:
            raise ValueError("out is read only")
        return array

    def _mask(self, mask: Any) -> Any:
        """@return (pointer or None, keep alive)"""
        if mask is None:
            return None, None
        array = self._np.ascontiguousarray(mask)
        if array.dtype != bool and array.dtype != self._np.uint8 or array.shape != (len(self),):
            raise ValueError(f"mask takes {len(self)} of True and False, got {array.dtype} {array.shape}")
        return array.ctypes.data_as(ctypes.POINTER(ctypes.c_uint8)), array

    def _numbers(self, columns: tuple[Column, ...]) -> tuple[Any, int]:
        for column in columns:
            if not isinstance(column, Column) or column.batch is not self:
                raise TypeError(f"columns takes columns of this batch, got {column!r}")
        return (ctypes.c_uint32 * max(1, len(columns)))(*(column.number for column in columns)), len(columns)

    # ---- time ----

    def step(self, dt: float, steps: int = 1, mask: Mask = None) -> int:
        """Advance worlds by so many steps of dt. @return how many are stopped now: see stopped()"""
        pointer, alive = self._mask(mask)
        stopped = ctypes.c_uint64()
        self._call(raw.carom_batch_step, pointer, number(dt, "dt"), whole(steps, "steps", 1, 1000000), ctypes.byref(stopped))
        del alive
        return stopped.value

    def read(self, *columns: Column, mask: Mask = None) -> None:
        """Fill the arrays of columns, of worlds as they are now."""
        (numbers, count), (pointer, alive) = self._numbers(columns), self._mask(mask)
        self._call(raw.carom_batch_read, numbers, count, pointer)
        del alive

    def write(self, *columns: Column, mask: Mask = None) -> None:
        """Put what the arrays of columns have into worlds: all of it or, where something is refused, nothing."""
        (numbers, count), (pointer, alive) = self._numbers(columns), self._mask(mask)
        self._call(raw.carom_batch_write, numbers, count, pointer)
        del alive

    def reset(self, mask: Mask = None, starts: int | Sequence[int] | NDArray[Any] | None = None) -> None:
        """Put worlds back to where they began. @param starts  numbers of add_start(), one, or one for each world"""
        np = self._np
        pointer, alive = self._mask(mask)
        chosen = None
        if starts is not None:
            numbers = np.asarray(starts)
            if numbers.dtype.kind not in "iu" or numbers.shape not in ((), (len(self),)) or (numbers.size and numbers.min() < 0):
                raise ValueError(f"starts takes a whole number, or {len(self)} of them, got {starts!r}")
            chosen = np.ascontiguousarray(np.broadcast_to(numbers, (len(self),)), np.uint32)
        self._call(raw.carom_batch_reset, pointer, None if chosen is None else chosen.ctypes.data_as(ctypes.POINTER(ctypes.c_uint32)))
        del alive

    def add_start(self, snapshot: bytes, world: int = 0) -> int:
        """A state that worlds of the structure may be reset to. @param snapshot  of World.save() or save() @return its number"""
        start = ctypes.c_uint32()
        data = bytes(snapshot)
        self._call(raw.carom_batch_add_start, whole(world, "world", 0, 2**63), data, len(data), ctypes.byref(start))
        return start.value

    def save(self, world: int) -> bytes:
        """A snapshot of one world, for World.restore() and add_start()."""
        world, size = whole(world, "world", 0, 2**63), ctypes.c_uint64()
        self._call(raw.carom_batch_save, world, None, 0, ctypes.byref(size))
        buffer = ctypes.create_string_buffer(size.value)
        self._call(raw.carom_batch_save, world, buffer, size.value, ctypes.byref(size))
        return buffer.raw

    # ---- what happened ----

    def hashes(self) -> NDArray[np.uint64]:
        """(worlds,): of each what World.hash would be."""
        found = self._np.zeros(len(self), self._np.uint64)
        self._call(raw.carom_batch_get_hashes, found.ctypes.data_as(ctypes.POINTER(ctypes.c_uint64)), len(self))
        return found  # type: ignore[no-any-return]

    def stopped(self) -> NDArray[np.uint32]:
        """(worlds,): 0 where a world steps, 1 where a fault stopped it, 2 where there was no memory."""
        found = self._np.zeros(len(self), self._np.uint32)
        self._call(raw.carom_batch_get_stopped, found.ctypes.data_as(ctypes.POINTER(ctypes.c_uint32)), len(self))
        return found  # type: ignore[no-any-return]

    def faults(self, world: int) -> list[FaultRecord]:
        """What stopped a world. Handles are numbers, of the world that was copied."""
        found = copy_out(self._call, raw.carom_batch_get_faults, raw.carom_fault, whole(world, "world", 0, 2**63))
        return [record(FaultRecord, one, kind=word("FAULT", one.kind, FAULTS)) for one in found]

    @property
    def info(self) -> BatchInfoRecord:
        """structures, worlds, stopped, columns, real_worlds, state_bytes"""
        out = describe(raw.carom_batch_info, {})
        self._call(raw.carom_batch_get_info, ctypes.byref(out))
        return record(BatchInfoRecord, out)

    def random(self, width: int, kind: Literal["uniform", "normal"] = "uniform", mask: Mask = None, *, seeds: Any = None) -> NDArray[np.float64]:
        """(worlds, width) random numbers, the next of each world: they follow from (seed, number of the world, how often it has drawn)
        alone. Rows that the mask leaves out are 0, and draw nothing. `draws` has how often each did, and may be set.
        @param seeds  of each world, in place of the batch's and of the world's number: equal seeds give equal numbers"""
        np = self._np
        width, which = whole(width, "width", 0, 2**24), enum("RANDOM", kind, "kind")
        chosen = np.arange(len(self))
        if mask is not None:
            chosen = np.flatnonzero(self._mask(mask)[1])
        keys = np.empty((len(chosen), 3), np.uint64)
        keys[:, 0] = self.seed if seeds is None else np.broadcast_to(np.asarray(seeds, np.uint64), (len(self),))[chosen]
        keys[:, 1] = chosen.astype(np.uint64) + np.uint64(self.first) if seeds is None else np.uint64(0)
        keys[:, 2] = self.draws[chosen]
        rows = np.zeros((len(chosen), width))
        doubles, words = ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_uint64)
        check(raw.carom_random_fill, which, keys.ctypes.data_as(words), len(chosen), width, rows.ctypes.data_as(doubles))
        self.draws[chosen] += np.uint64(1)
        out = np.zeros((len(self), width))
        out[chosen] = rows
        return out  # type: ignore[no-any-return]
