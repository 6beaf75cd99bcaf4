"""Thousands of bodies or joints in one call: arrays of positions, orientations, velocities, targets, efforts."""
from __future__ import annotations

import array
import ctypes
from typing import TYPE_CHECKING, Any, Callable, Iterable, Literal, TypedDict, TypeVar, overload

from . import raw
from ._values import enum, floats, handle_of, handles_out, listed, need_numpy, numpy, vector

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from typing_extensions import Unpack

    from ._values import Rows, Vector
    from .body import Body, Material
    from .joint import Joint
    from .records import BodyTypeWord, FieldWord, JointBulkWord
    from .shape import Shape

T = TypeVar("T")


class BodyArguments(TypedDict, total=False):
    """What World.body() takes beside shape and position."""
    orientation: Vector | None
    type: BodyTypeWord | int
    linear_velocity: Vector | None
    angular_velocity: Vector | None
    mass: float | None
    center: Vector | None
    inertia: Vector | None
    linear_damping: float | None
    angular_damping: float | None
    stays_awake: bool
    user: int | None
    material: Material | None
    density: float | None


_WIDTH = {raw.CAROM_FIELD_POSITION: 3, raw.CAROM_FIELD_ORIENTATION: 4, raw.CAROM_FIELD_POSE: 7,
          raw.CAROM_FIELD_LINEAR_VELOCITY: 3, raw.CAROM_FIELD_ANGULAR_VELOCITY: 3, raw.CAROM_FIELD_VELOCITY: 6,
          raw.CAROM_FIELD_FORCE: 6, raw.CAROM_FIELD_CENTER: 3, raw.CAROM_FIELD_MASS: 1}


def width_of(field: int) -> int:
    if field not in _WIDTH:
        raise ValueError(f"field is {field}, which is none; it is one of 'position', 'velocity', ...: see Bulk")
    return _WIDTH[field]


def handles_of(things: Iterable[Body | Joint | int] | NDArray[np.uint64], name: str = "bodies",
               kind: str = "carom_body") -> tuple[Any, int, Any]:
    """Bodies or joints, their handles, or a numpy array of them. @return (C array or pointer, how many, keep alive)"""
    if numpy is not None and isinstance(things, numpy.ndarray):
        packed = numpy.ascontiguousarray(things, dtype=numpy.uint64)
        return packed.ctypes.data_as(ctypes.POINTER(ctypes.c_uint64)), packed.size, packed
    one = kind.removeprefix("carom_")
    handles = [handle_of(thing, f"{name}[{i}]", kind, False)
               for i, thing in enumerate(listed(things, name, f"{name} or their handles, as [{one}]"))]
    packed = (ctypes.c_uint64 * len(handles))(*handles)
    return packed, len(packed), packed


def place(data: Any, width: int, rows: int | None, name: str, writable: bool = False) -> tuple[int, int, int, int, Any]:
    """Where rows of `width` scalars lie in a numpy array or buffer of float or double, whatever its stride from row to row.
    @return (address, rows, CAROM_SCALAR_*, stride, keep alive)"""
    if numpy is not None and isinstance(data, numpy.ndarray):
        shaped = data.reshape(-1, 1) if data.ndim == 1 and width == 1 else data
        if shaped.ndim != 2 or shaped.shape[1] != width or shaped.dtype not in (numpy.float64, numpy.float32):
            raise ValueError(f"{name} takes an array of float64 or float32 of shape (n, {width}), got {data.dtype} {data.shape}")
        if shaped.shape[0] > 1 and (shaped.strides[1] != shaped.itemsize or shaped.strides[0] < width * shaped.itemsize):
            raise ValueError(f"each row of {name} must lie in one piece, one after the other")
        if shaped.shape[0] == 1 and not shaped.flags.c_contiguous:
            raise ValueError(f"the row of {name} must lie in one piece")
        if writable and not shaped.flags.writeable:
            raise ValueError(f"{name} is read only")
        scalar = raw.CAROM_SCALAR_F64 if shaped.itemsize == 8 else raw.CAROM_SCALAR_F32
        found: tuple[int, int, int, int, Any] = shaped.ctypes.data, shaped.shape[0], scalar, shaped.strides[0] if shaped.shape[0] > 1 else 0, shaped
    else:
        try:
            view = memoryview(data)
        except TypeError:
            raise TypeError(f"{name} takes an array or a buffer of doubles or floats, got a {type(data).__name__}") from None
        if view.format not in ("d", "f") or not view.c_contiguous or view.nbytes % (width * view.itemsize):
            raise ValueError(f"{name} takes a packed buffer of doubles or floats, {width} for each body")
        if writable and view.readonly:
            raise ValueError(f"{name} is read only")
        if view.readonly:
            held = (ctypes.c_char * view.nbytes).from_buffer_copy(view)
        elif view.nbytes == 0:
            held = (ctypes.c_char * 1)()  # an empty buffer has no address
        else:
            held = (ctypes.c_char * view.nbytes).from_buffer(view)
        scalar = raw.CAROM_SCALAR_F64 if view.format == "d" else raw.CAROM_SCALAR_F32
        found = ctypes.addressof(held), view.nbytes // (width * view.itemsize), scalar, 0, held
    if rows is not None and found[1] != rows:
        raise ValueError(f"{name} takes {rows} rows, one for each, got {found[1]}")
    return found


def packed(values: Any, width: int) -> Any:
    """Lists of rows, or of numbers where a row has one, as a buffer; arrays in doubles or floats; buffers as they are."""
    if isinstance(values, (list, tuple)):
        rows = [vector(row if width > 1 else (row,), width, f"values[{i}]") for i, row in enumerate(values)]
        return array.array("d", [x for row in rows for x in row])
    return floats(values, "values") if numpy is not None and isinstance(values, numpy.ndarray) else values


def room_for(n: int, width: int, dtype: Any) -> Any:
    return numpy.empty((n, width), dtype) if numpy is not None else array.array("d", bytes(8 * n * width))


class Bulk:
    """Reads and writes of a world. Fields: "position", "orientation", "pose", "linear_velocity", "angular_velocity",
    "velocity", "force", "center", "mass". One call, one copy, no Python object a body."""

    _call: Callable[..., None]
    body: Callable[..., Body]

    def body_count(self) -> int:
        count = ctypes.c_uint64()
        self._call(raw.carom_world_get_bodies, None, 0, ctypes.byref(count))
        return count.value

    def body_handles(self) -> NDArray[np.uint64]:
        """Handles of all bodies, in the order in which read() has their rows: numpy array, or array.array without numpy."""
        return self._handles(raw.carom_world_get_bodies)

    def _handles(self, get: Callable[..., int]) -> NDArray[np.uint64]:
        handles = handles_out(self._call, get)
        found: Any = numpy.ctypeslib.as_array(handles) if numpy is not None else array.array("Q", bytes(handles))
        return found  # type: ignore[no-any-return]

    @overload
    def read(self, field: FieldWord | int, bodies: Iterable[Body | int] | NDArray[np.uint64] | None = None, out: None = None,
             dtype: Literal["float64"] = "float64") -> NDArray[np.float64]: ...

    @overload
    def read(self, field: FieldWord | int, bodies: Iterable[Body | int] | NDArray[np.uint64] | None = None, out: None = None, *,
             dtype: Literal["float32"]) -> NDArray[np.float32]: ...

    @overload
    def read(self, field: FieldWord | int, bodies: Iterable[Body | int] | NDArray[np.uint64] | None = None, *, out: T) -> T: ...

    def read(self, field: FieldWord | int, bodies: Iterable[Body | int] | NDArray[np.uint64] | None = None, out: Any = None,
             dtype: Any = "float64") -> Any:
        """One field of many bodies, a row each.
        @param bodies  which: Body objects, handles, or a numpy array of handles; None: all, as body_handles() has them
        @param out     where to: numpy array (n, width) of float64 or float32, rows at any stride; or a packed buffer
        @return        out; without it a new numpy array (array.array of doubles where there is no numpy)"""
        number = enum("FIELD", field, "field")
        width = width_of(number)
        handles, n, alive = (None, self.body_count(), None) if bodies is None else handles_of(bodies)
        if out is None:
            out = room_for(n, width, dtype)
        address, _, scalar, stride, held = place(out, width, n, "out", writable=True)
        self._call(raw.carom_world_read, number, scalar, handles, n, address, stride)
        return out

    def write(self, field: FieldWord | int, values: Any, bodies: Iterable[Body | int] | NDArray[np.uint64] | None = None) -> None:
        """The reverse; all values are checked before the first is written. @param values  rows: array, buffer, or lists"""
        number = enum("FIELD", field, "field")
        width = width_of(number)
        handles, n, alive = (None, self.body_count(), None) if bodies is None else handles_of(bodies)
        address, _, scalar, stride, held = place(packed(values, width), width, n, "values")
        self._call(raw.carom_world_write, number, scalar, handles, n, address, stride)

    def joint_handles(self) -> NDArray[np.uint64]:
        """Handles of all joints, in the order in which read_joints() has their rows, as body_handles()."""
        return self._handles(raw.carom_world_get_joints)

    def _joints(self, field: JointBulkWord | int, joints: Iterable[Joint | int] | NDArray[np.uint64] | None) -> tuple[int, int, Any, int, Any]:
        """@return (field, scalars of a row, handles, how many, keep alive)"""
        number = enum("JOINT_BULK", field, "field")
        out = ctypes.c_uint32()
        if raw.carom_joint_bulk_width(number, ctypes.byref(out)) != raw.CAROM_OK:
            raise ValueError(f"field is {field}, which is none; it is one of 'position', 'target', ...: see carom.raw.CAROM_JOINT_BULK_*")
        if joints is not None:
            return number, out.value, *handles_of(joints, "joints", "carom_joint")
        count = ctypes.c_uint64()
        self._call(raw.carom_world_get_joints, None, 0, ctypes.byref(count))
        return number, out.value, None, count.value, None

    @overload
    def read_joints(self, field: JointBulkWord | int, joints: Iterable[Joint | int] | NDArray[np.uint64] | None = None, out: None = None,
                    dtype: Literal["float64"] = "float64") -> NDArray[np.float64]: ...

    @overload
    def read_joints(self, field: JointBulkWord | int, joints: Iterable[Joint | int] | NDArray[np.uint64] | None = None, out: None = None, *,
                    dtype: Literal["float32"]) -> NDArray[np.float32]: ...

    @overload
    def read_joints(self, field: JointBulkWord | int, joints: Iterable[Joint | int] | NDArray[np.uint64] | None = None, *, out: T) -> T: ...

    def read_joints(self, field: JointBulkWord | int, joints: Iterable[Joint | int] | NDArray[np.uint64] | None = None, out: Any = None,
                    dtype: Any = "float64") -> Any:
        """One field of many joints, a row each, as read() has those of bodies. Of hinges, sliders, distance joints and pulleys: "position"
        (m or rad, whole turns counted), "velocity", "effort" (N or N m, mean over the last step), "target", "target_velocity",
        "target_effort", "acceleration" (m/s^2 or rad/s^2, of joints made with accelerations=True), "motor" (enabled, speed, max_force), "spring" (enabled, target, frequency, damping, max_force), "limit"
        (enabled, lower, upper). Of six-axis joints "axis_targets" and others, of balls "orientation_target" and others, of any
        "coordinates", "speeds", "axes", "axis_speeds", "force", "torque", "error", "broken", "axis_efforts", "axis_accelerations". carom/joint.h says how
        many numbers a row has."""
        number, width, handles, n, alive = self._joints(field, joints)
        if out is None:
            out = room_for(n, width, dtype)
        address, _, scalar, stride, held = place(out, width, n, "out", writable=True)
        self._call(raw.carom_world_read_joints, number, scalar, handles, n, address, stride)
        return out

    def write_joints(self, field: JointBulkWord | int, values: Any, joints: Iterable[Joint | int] | NDArray[np.uint64] | None = None) -> None:
        """The reverse, of targets, motors, springs, limits and gains; "position", "velocity", "axes" and "axis_speeds" move bodies and what
        hangs on them. All values are checked before the first is written.
        @param values  rows: array, buffer, or lists; a number each where a row has one"""
        number, width, handles, n, alive = self._joints(field, joints)
        address, _, scalar, stride, held = place(packed(values, width), width, n, "values")
        self._call(raw.carom_world_write_joints, number, scalar, handles, n, address, stride)

    @overload
    def positions(self, out: None = None) -> NDArray[np.float64]: ...

    @overload
    def positions(self, out: T) -> T: ...

    def positions(self, out: Any = None) -> Any:
        """m, (n, 3): one row for each body of `world.bodies`, static ones included. `world.read("position", bodies)` reads some."""
        return self.read("position", out=out)

    @overload
    def orientations(self, out: None = None) -> NDArray[np.float64]: ...

    @overload
    def orientations(self, out: T) -> T: ...

    def orientations(self, out: Any = None) -> Any:
        """x, y, z, w, (n, 4)"""
        return self.read("orientation", out=out)

    @overload
    def velocities(self, out: None = None) -> NDArray[np.float64]: ...

    @overload
    def velocities(self, out: T) -> T: ...

    def velocities(self, out: Any = None) -> Any:
        """m/s and rad/s, (n, 6)"""
        return self.read("velocity", out=out)

    def create_bodies(self, positions: Rows, shape: Shape | None = None, **about: Unpack[BodyArguments]) -> NDArray[np.uint64]:
        """Many bodies alike but for where they are. @param positions  rows of 3, m   @return numpy array of their handles"""
        np = need_numpy("create_bodies()")
        rows = floats(positions, "positions").reshape(-1, 3)
        handles: NDArray[Any] = np.array([self.body(shape, position=row, **about).handle for row in rows], dtype=np.uint64)
        return handles
