"""Between Python's values and C's: descriptors from keywords, records from structs, words for enumerations."""
from __future__ import annotations

import ctypes
import functools
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


def enum(prefix: str, value: str | int) -> int:
    """"hinge" with prefix "JOINT" is raw.CAROM_JOINT_HINGE; numbers pass."""
    if not isinstance(value, str):
        return int(value)
    if value.lower() not in words(prefix):
        raise ValueError(f"{value!r} is not one of {', '.join(words(prefix))}")
    found: int = getattr(raw, f"CAROM_{prefix}_{value.upper()}")
    return found


# Of constants that begin with a prefix, those of other enumerations.
_OTHERS = {
    "BODY": ("field_", "stays_awake", "disabled"),
    "JOINT": ("field_", "read_", "world_frame", "collide"),
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


def bits(prefix: str, names: str | int | Iterable[str | int]) -> int:
    """Bits of one word, or of several; numbers pass."""
    if isinstance(names, (str, int)):
        names = (names,)
    value = 0
    for name in names:
        value |= enum(prefix, name)
    return value


def vector(values: Iterable[float], n: int, name: str) -> ctypes.Array[ctypes.c_double]:
    """@return a C array of n doubles"""
    values = tuple(values)
    if len(values) != n:
        raise ValueError(f"{name} takes {n} numbers, got {len(values)}")
    return (ctypes.c_double * n)(*values)


def vec3(values: Iterable[float], name: str = "vector") -> ctypes.Array[ctypes.c_double]:
    return vector(values, 3, name)


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
    if key in raw.HANDLES.get(type(desc).__name__, ()):
        desc.__setattr__(key, handle_of(value))
    elif issubclass(kind, ctypes.Array):
        setattr(desc, key, vector(value, kind._length_, key))
    elif kind is ctypes.c_double:
        setattr(desc, key, float(value))
    else:
        setattr(desc, key, int(value))


def handle_of(thing: Any) -> int:
    """A handle, or that of a body, shape, ...; None is CAROM_NULL_HANDLE."""
    return 0 if thing is None else int(getattr(thing, "handle", thing))


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


def doubles(values: Any, width: int, name: str) -> tuple[int, int, Any]:
    """Rows of `width` numbers, from numpy or from sequences. @return (C array of doubles or pointer, rows, keep alive)"""
    if numpy is not None:
        array = numpy.ascontiguousarray(values, dtype=numpy.float64)
        if array.ndim == 1 and array.size == width:
            array = array.reshape(1, width)
        if array.ndim != 2 or array.shape[1] != width:
            raise ValueError(f"{name} takes rows of {width} numbers, got shape {array.shape}")
        return array.ctypes.data, array.shape[0], array
    rows = [tuple(row) for row in values]
    if any(len(row) != width for row in rows):
        raise ValueError(f"{name} takes rows of {width} numbers")
    flat = (ctypes.c_double * (width * len(rows)))(*(x for row in rows for x in row))
    return ctypes.addressof(flat), len(rows), flat
