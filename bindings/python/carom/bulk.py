"""Thousands of bodies in one call: arrays of positions, orientations, velocities."""
from __future__ import annotations

import array
import ctypes
from typing import Any, Callable, Iterable

from . import raw
from ._values import enum, handles_out, need_numpy, numpy

_WIDTH = {raw.CAROM_FIELD_POSITION: 3, raw.CAROM_FIELD_ORIENTATION: 4, raw.CAROM_FIELD_POSE: 7,
          raw.CAROM_FIELD_LINEAR_VELOCITY: 3, raw.CAROM_FIELD_ANGULAR_VELOCITY: 3, raw.CAROM_FIELD_VELOCITY: 6,
          raw.CAROM_FIELD_FORCE: 6, raw.CAROM_FIELD_CENTER: 3, raw.CAROM_FIELD_MASS: 1}


def width_of(field: int) -> int:
    if field not in _WIDTH:
        raise ValueError(f"no field {field}")
    return _WIDTH[field]


def handles_of(bodies):
    """Bodies, their handles, or a numpy array of them. @return (C array or pointer, how many, keep alive)"""
    if numpy is not None and isinstance(bodies, numpy.ndarray):
        packed = numpy.ascontiguousarray(bodies, dtype=numpy.uint64)
        return packed.ctypes.data_as(ctypes.POINTER(ctypes.c_uint64)), packed.size, packed
    handles = [getattr(body, "handle", body) for body in bodies]
    packed = (ctypes.c_uint64 * len(handles))(*handles)
    return packed, len(packed), packed


def floats(values):
    """An array of float64 or float32 as it is; of integers, or lists of rows, one of float64."""
    np = need_numpy("this")
    return np.asarray(values, dtype=None if isinstance(values, np.ndarray) and values.dtype.kind == "f" else np.float64)


def place(data, width: int, rows: int | None, writable: bool):
    """Where rows of `width` scalars lie in a numpy array or buffer of float or double, whatever its stride from row to row.
    @return (address, rows, CAROM_SCALAR_*, stride, keep alive)"""
    if numpy is not None and isinstance(data, numpy.ndarray):
        shaped = data.reshape(-1, 1) if data.ndim == 1 and width == 1 else data
        if shaped.ndim != 2 or shaped.shape[1] != width or shaped.dtype not in (numpy.float64, numpy.float32):
            raise ValueError(f"takes an array of float64 or float32 of shape (n, {width}), got {data.dtype} {data.shape}")
        if shaped.shape[0] > 1 and (shaped.strides[1] != shaped.itemsize or shaped.strides[0] < width * shaped.itemsize):
            raise ValueError("each row must lie in one piece, one after the other")
        if shaped.shape[0] == 1 and not shaped.flags.c_contiguous:
            raise ValueError("the row must lie in one piece")
        if writable and not shaped.flags.writeable:
            raise ValueError("out is read only")
        scalar = raw.CAROM_SCALAR_F64 if shaped.itemsize == 8 else raw.CAROM_SCALAR_F32
        found: Any = shaped.ctypes.data, shaped.shape[0], scalar, shaped.strides[0] if shaped.shape[0] > 1 else 0, shaped
    else:
        view = memoryview(data)
        if view.format not in ("d", "f") or not view.c_contiguous or view.nbytes % (width * view.itemsize):
            raise ValueError(f"takes a packed buffer of doubles or floats, {width} for each body")
        if writable and view.readonly:
            raise ValueError("out is read only")
        if view.readonly:
            held = (ctypes.c_char * view.nbytes).from_buffer_copy(view)
        elif view.nbytes == 0:
            held = (ctypes.c_char * 1)()  # an empty buffer has no address
        else:
            held = (ctypes.c_char * view.nbytes).from_buffer(view)
        scalar = raw.CAROM_SCALAR_F64 if view.format == "d" else raw.CAROM_SCALAR_F32
        found = ctypes.addressof(held), view.nbytes // (width * view.itemsize), scalar, 0, held
    if rows is not None and found[1] != rows:
        raise ValueError(f"takes {rows} rows, one for each body, got {found[1]}")
    return found


class Bulk:
    """Reads and writes of a world. Fields: "position", "orientation", "pose", "linear_velocity", "angular_velocity",
    "velocity", "force", "center", "mass". One call, one copy, no Python object a body."""

    _call: Callable[..., None]

    def body_count(self) -> int:
        count = ctypes.c_uint64()
        self._call(raw.carom_world_get_bodies, None, 0, ctypes.byref(count))
        return count.value

    def body_handles(self):
        """Handles of all bodies, in the order in which read() has their rows: numpy array, or array.array without numpy."""
        handles = handles_out(self._call, raw.carom_world_get_bodies)
        return numpy.ctypeslib.as_array(handles) if numpy is not None else array.array("Q", bytes(handles))

    def read(self, field: str | int, bodies: Iterable | None = None, out=None, dtype="float64"):
        """One field of many bodies, a row each.
        @param bodies  which: Body objects, handles, or a numpy array of handles; None: all, as body_handles() has them
        @param out     where to: numpy array (n, width) of float64 or float32, rows at any stride; or a packed buffer
        @return        out; without it a new numpy array (array.array of doubles where there is no numpy)"""
        field = enum("FIELD", field)
        width = width_of(field)
        handles, n, alive = (None, self.body_count(), None) if bodies is None else handles_of(bodies)
        if out is None:
            out = numpy.empty((n, width), dtype) if numpy is not None else array.array("d", bytes(8 * n * width))
        address, _, scalar, stride, held = place(out, width, n, True)
        self._call(raw.carom_world_read, field, scalar, handles, n, address, stride)
        return out

    def write(self, field: str | int, values, bodies: Iterable | None = None) -> None:
        """The reverse; all values are checked before the first is written. @param values  rows: array, buffer, or lists"""
        field = enum("FIELD", field)
        width = width_of(field)
        handles, n, alive = (None, self.body_count(), None) if bodies is None else handles_of(bodies)
        if isinstance(values, (list, tuple)):
            flat = [x for row in values for x in (row if width > 1 else (row,))]
            values = array.array("d", flat)
        elif numpy is not None and isinstance(values, numpy.ndarray):
            values = floats(values)
        address, _, scalar, stride, held = place(values, width, n, False)
        self._call(raw.carom_world_write, field, scalar, handles, n, address, stride)

    def positions(self, out=None):
        """m, (n, 3)"""
        return self.read("position", out=out)

    def orientations(self, out=None):
        """x, y, z, w, (n, 4)"""
        return self.read("orientation", out=out)

    def velocities(self, out=None):
        """m/s and rad/s, (n, 6)"""
        return self.read("velocity", out=out)

    def create_bodies(self, positions, shape=None, **about):
        """Many bodies alike but for where they are. @param positions  rows of 3, m   @return numpy array of their handles"""
        np = need_numpy("create_bodies()")
        rows = np.asarray(positions, dtype=np.float64).reshape(-1, 3)
        return np.array([self.body(shape, position=row, **about).handle for row in rows], dtype=np.uint64)
