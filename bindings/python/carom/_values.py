"""Between Python's values and C's: descriptors from keywords, records from structs, words for enumerations."""
from __future__ import annotations

import ctypes
import functools
import math
import operator
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Sequence, TypeVar, Union

from . import raw

if TYPE_CHECKING:
    from numpy.typing import NDArray
    Vector = Union[Sequence[float], NDArray[Any]]  # a few numbers: a list, a tuple, a row of an array
    Rows = Union[Sequence[Sequence[float]], NDArray[Any]]

numpy: Any
try:
    import numpy
except ImportError:  # optional: only arrays need it
    numpy = None


S = TypeVar("S", bound=ctypes.Structure)
Wrap = Callable[[str, int], Any]


def need_numpy(what: str) -> Any:
    if numpy is None:
        raise ImportError(f"{what} needs numpy (Debian: python3-numpy); single objects do not")
    return numpy


_TEXT = (str, bytes, bytearray)


def number(value: Any, name: str) -> float:
    """A double, of whatever Python counts as a number. Not finite ones pass: the library says where they may not stand."""
    try:
        if isinstance(value, _TEXT):  # float("2") would take it
            raise TypeError
        return float(value)
    except OverflowError:
        raise ValueError(f"{name} is beyond 1.8e308: a double ends there") from None
    except (TypeError, ValueError):
        raise TypeError(_not_a_number(value, name, "a number")) from None


def whole(value: Any, name: str, least: int = 0, most: int = 2**32 - 1, usual: int | None = None) -> int:
    """A whole number, as an int or as a float without a fraction. @param usual  what to type where the value gives no hint"""
    bounds = f"a whole number from {least} to {most if most < 2**63 else '2^64 - 1'}"
    try:
        if isinstance(value, _TEXT):
            raise TypeError
        try:
            found = operator.index(value)
        except TypeError:
            found = math.trunc(float(value))
            if found != float(value):
                raise ValueError from None
    except TypeError:
        raise TypeError(_not_a_number(value, name, bounds)) from None
    except (ValueError, OverflowError):  # a fraction, nan, inf
        raise ValueError(f"{name} takes {bounds}, got {value!r}{_hint(value, name, least, most, usual)}") from None
    if not least <= found <= most:
        raise ValueError(f"{name} takes {bounds}, got {value!r}{_hint(value, name, least, most, usual)}")
    return found


def flag(value: Any, name: str) -> int:
    """True or False, as C has it."""
    try:
        return whole(value, name, 0, 1)
    except (TypeError, ValueError):
        raise type_of_wrong(value)(f"{name} takes True or False, got {value!r}") from None


def mask(value: Any, name: str, width: int) -> int:
    """Bits of an unsigned number; what Python writes as ~x is below 0 and means the same bits."""
    return whole(value, name, -(1 << (width - 1)), (1 << width) - 1) & ((1 << width) - 1)


def _hint(value: Any, name: str, least: int, most: int, usual: int | None) -> str:
    try:
        near = min(max(math.trunc(float(value)), least), most)
    except (TypeError, ValueError, OverflowError):
        near = least if usual is None else usual
    if usual is not None and not least < near < most:
        near = usual
    return f"; type {name}={near}" if name.isidentifier() else f"; type {near}"


def _not_a_number(value: Any, name: str, what: str) -> str:
    text = f"{name} takes {what}, got {value!r}, which is of type {type(value).__name__}"
    try:
        meant = value.strip() if isinstance(value, str) else ""
        float(meant)
        return f"{text}; type {name}={meant} without quotes" if name.isidentifier() else f"{text}; type {meant} without quotes"
    except ValueError:
        return text


def enum(prefix: str, value: str | int, name: str) -> int:
    """"hinge" with prefix "JOINT" is raw.CAROM_JOINT_HINGE; numbers pass. @param name  of the argument"""
    if not isinstance(value, str):
        try:
            return whole(value, name)
        except (TypeError, ValueError):
            raise type_of_wrong(value)(f"{name} is {value!r}: it takes one of {', '.join(map(repr, words(prefix)))}") from None
    if value.lower() not in words(prefix):
        raise ValueError(f"{name} {value!r} is not one of {', '.join(words(prefix))}")
    found: int = getattr(raw, f"CAROM_{prefix}_{value.upper()}")
    return found


# Of constants that begin with a prefix, those of other enumerations.
_OTHERS = {
    "BODY": ("field_", "stays_awake", "disabled"),
    "JOINT": ("field_", "bulk_", "world_frame", "collide", "accelerations"),
    "AXIS": ("mode_",),
    "DIAL": ("kind_",),
    "DRAW": ("by_",),
    "FIELD": (),
}


@functools.lru_cache(maxsize=None)
def words(prefix: str) -> list[str]:
    start = f"CAROM_{prefix}_"
    names = (name[len(start):].lower() for name in dir(raw) if name.startswith(start))
    return [name for name in names if name != "count" and not name.startswith(_OTHERS.get(prefix, ()))]


def word(prefix: str, value: int, among: tuple[str, ...]) -> str:
    """The reverse of enum(), for the words named; the number as text where a newer library has another."""
    for name in among:
        if getattr(raw, f"CAROM_{prefix}_{name.upper()}") == value:
            return name
    return str(value)


def bits(prefix: str, names: str | int | Iterable[str | int], name: str) -> int:
    """Bits of one word, or of several; numbers pass. @param name  of the argument"""
    one = isinstance(names, _TEXT) or not isinstance(names, Iterable)
    value = 0
    for each in (names,) if one else names:  # type: ignore[union-attr]
        value |= enum(prefix, each, name)  # type: ignore[arg-type]
    return value


def vector(values: Iterable[float], n: int, name: str) -> ctypes.Array[ctypes.c_double]:
    """@return a C array of n doubles"""
    try:
        values = tuple(values)
    except TypeError:
        raise TypeError(f"{name} takes {n} numbers, got {values!r}; type {name}=({', '.join('0' * n)})") from None
    if len(values) != n:
        raise ValueError(f"{name} takes {n} numbers, got {len(values)}")
    try:
        return (ctypes.c_double * n)(*values)
    except (TypeError, ValueError, OverflowError):
        return (ctypes.c_double * n)(*(number(value, f"{name}[{i}]") for i, value in enumerate(values)))


def vec3(values: Iterable[float], name: str) -> ctypes.Array[ctypes.c_double]:
    return vector(values, 3, name)


def direction(values: Iterable[float], name: str) -> ctypes.Array[ctypes.c_double]:
    """Three numbers of which one is not 0."""
    way = vec3(values, name)
    if not any(way):
        raise ValueError(f"{name} is (0, 0, 0): a ray needs a way to go; type {name}=(0, -1, 0) for one that goes down")
    return way


def describe(struct: type[S], keywords: Mapping[str, Any]) -> S:
    """A descriptor with its defaults and those keywords that are not None."""
    name = struct.__name__
    desc = struct()
    initialise = getattr(raw, name + "_init", None)
    if initialise:
        initialise(ctypes.byref(desc), ctypes.sizeof(struct))
    else:
        setattr(desc, "struct_size", ctypes.sizeof(struct))
    for key, value in keywords.items():
        if value is not None:
            set_field(desc, key, value)
    return desc


def ask(struct: type[S], keywords: Mapping[str, Any]) -> S:
    """A descriptor of a question: as describe(), with ignore_touched= as a bit of flags."""
    rest = {key: value for key, value in keywords.items() if key != "ignore_touched"}
    if keywords.get("ignore_touched"):
        rest["flags"] = int(rest.get("flags") or 0) | raw.CAROM_ASK_IGNORE_TOUCHED
    return describe(struct, rest)


def set_field(desc: ctypes.Structure, key: str, value: Any) -> None:
    kind: Any = dict(desc._fields_).get(key)  # type: ignore[arg-type]
    if kind is None or key in ("struct_size", "reserved"):
        raise TypeError(f"{type(desc).__name__} has no {key}; it has {', '.join(f[0] for f in desc._fields_[1:] if f[0] != 'reserved')}")
    handles = raw.HANDLES.get(type(desc).__name__, {})
    if key in handles:
        setattr(desc, key, handle_of(value, key, handles[key]))
    elif issubclass(kind, ctypes.Array):
        setattr(desc, key, vector(value, kind._length_, key))
    elif kind is ctypes.c_double:
        setattr(desc, key, number(value, key))
    elif key.endswith("mask") or key == "category":
        setattr(desc, key, mask(value, key, 8 * ctypes.sizeof(kind)))
    else:
        setattr(desc, key, whole(value, key, *bounds_of(kind)))


def bounds_of(kind: Any) -> tuple[int, int]:
    """The least and the most that a C integer holds."""
    width = 8 * ctypes.sizeof(kind)
    signed = kind(-1).value < 0
    return (-(2 ** (width - 1)), 2 ** (width - 1) - 1) if signed else (0, 2**width - 1)


def listed(values: Any, name: str, what: str) -> tuple[Any, ...]:
    """@return what an iterable gives. @param what  it should be, in words"""
    try:
        if isinstance(values, _TEXT):
            raise TypeError
        return tuple(values)
    except TypeError:
        raise TypeError(f"{name} takes {what}, got {values!r}") from None


def handle_of(thing: Any, name: str, kind: str, or_none: bool = True) -> int:
    """A handle, or that of a body, shape, ...; None is CAROM_NULL_HANDLE. @param kind  "carom_body" """
    if thing is None and or_none:
        return 0
    try:
        return whole(getattr(thing, "handle", thing), name, 0, 2**64 - 1)
    except (TypeError, ValueError):
        what = kind.replace("carom_", "").replace("_", " ").title().replace(" ", "")
        raise type_of_wrong(thing)(f"{name} takes a {what}{' or None' if or_none else ''}, got {thing!r}") from None


def type_of_wrong(value: Any) -> type[Exception]:
    """What to raise for a number of the wrong value, or for what is no number."""
    return ValueError if isinstance(value, (int, float)) else TypeError


def shape_of(thing: Any, name: str) -> int:
    return handle_of(thing, name, "carom_shape", or_none=False)


class Record:
    """What a struct said, as attributes; vectors are tuples, handles are objects, None where there is none."""

    def __init__(self, **values: Any):
        self.__dict__.update(values)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in vars(self).items())})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Record) and vars(self) == vars(other)


R = TypeVar("R", bound=Record)


def record(kind: type[R], struct: ctypes.Structure, wrap: Wrap | None = None, /, **changes: Any) -> R:
    """@param kind  its class in records.py
    @param wrap  (type name of the handle, handle) -> object; else handles stay numbers"""
    name, out = type(struct).__name__, {}
    handles = raw.HANDLES.get(name, {})
    for field, *_ in struct._fields_:
        if field in ("struct_size", "reserved"):
            continue
        value = getattr(struct, field)
        if field in handles and wrap:
            value = wrap(handles[field], value) if value else None
        elif isinstance(value, bytes):
            value = value.decode("utf-8", "replace")
        elif isinstance(value, ctypes.Array):
            value = tuple(value)
        out[field + "_" if field in ("from",) else field] = value
    out.update(changes)
    return kind(**out)


def copy_out(call: Callable[..., None], function: Callable[..., int], struct: type[S], *before: object) -> ctypes.Array[S]:
    """All elements of one of the calls that end in dst, stride, capacity, count. @return a C array"""
    count = ctypes.c_uint64()
    stride = ctypes.sizeof(struct)
    call(function, *before, None, stride, 0, ctypes.byref(count))
    while True:
        capacity = count.value
        found = (struct * capacity)()
        call(function, *before, found if capacity else None, stride, capacity, ctypes.byref(count))
        if count.value <= capacity:
            return found if count.value == capacity else (struct * count.value).from_buffer(found)


def handles_out(call: Callable[..., None], function: Callable[..., int], *before: object) -> ctypes.Array[ctypes.c_uint64]:
    """All handles of one of the calls that end in handles, capacity, count. @return a C array"""
    count = ctypes.c_uint64()
    call(function, *before, None, 0, ctypes.byref(count))
    handles = (ctypes.c_uint64 * count.value)()
    call(function, *before, handles, count.value, ctypes.byref(count))
    return handles


def floats(values: Any, name: str) -> NDArray[Any]:
    """An array of float64 or float32 as it is; of integers, or lists of rows, one of float64."""
    np = need_numpy(name)
    try:
        array: NDArray[Any] = np.asarray(values)
    except ValueError:
        raise ValueError(f"{name} takes rows of as many numbers each; these differ in length") from None
    if array.dtype.kind not in "fiub" and array.size:
        array = np.array([number(x, f"{name}[{i}]") for i, x in enumerate(array.flat)]).reshape(array.shape)
    return array if isinstance(values, np.ndarray) and array.dtype.kind == "f" else np.asarray(array, dtype=np.float64)


def doubles(values: Any, width: int, name: str) -> tuple[int, int, Any]:
    """Rows of `width` numbers, from numpy or from sequences. @return (C array of doubles or pointer, rows, keep alive)"""
    if numpy is not None:
        array = numpy.ascontiguousarray(floats(values, name), dtype=numpy.float64)
        if array.ndim == 1 and array.size == width:
            array = array.reshape(1, width)
        if array.ndim != 2 or array.shape[1] != width:
            raise ValueError(f"{name} takes rows of {width} numbers, got shape {array.shape}")
        return array.ctypes.data, array.shape[0], array
    rows = [vector(row, width, f"{name}[{i}]") for i, row in enumerate(listed(values, name, f"rows of {width} numbers"))]
    flat = (ctypes.c_double * (width * len(rows)))(*(x for row in rows for x in row))
    return ctypes.addressof(flat), len(rows), flat
