"""The C interface as it is: every function, struct and constant of include/carom under its own name.

Loading this module finds the library, compares the layout of every struct with the one that the library's compiler made
(carom_abi_manifest), and gives every function its argument types. `carom` is built on it; use it for what that leaves out.
The library is $CAROM_LIBRARY, else the one in this package, else the one of the name `FILE`, where the system's loader finds it.
"""
import ctypes
import os
import sys
from pathlib import Path

from . import _c
from ._c import *  # noqa: F401,F403
from ._c import FUNCTIONS, HANDLES, SONAME, STRUCTS, VERSION  # noqa: F401

FILE = {"win32": "carom.dll", "darwin": SONAME.replace(".so", "") + ".dylib"}.get(sys.platform, SONAME)
_KINDS = {ctypes.c_uint32: "u32", ctypes.c_int32: "i32", ctypes.c_uint64: "u64", ctypes.c_double: "f64", ctypes.c_char: "char"}


def _find():
    given = os.environ.get("CAROM_LIBRARY")
    if given:
        return given
    packaged = Path(__file__).with_name("lib") / FILE
    return str(packaged) if packaged.exists() else FILE


def _kind(type):
    """The manifest's word for a ctypes type."""
    if issubclass(type, ctypes.Array):
        return f"{_kind(type._type_)}[{type._length_}]"
    if type in _KINDS:
        return _KINDS[type]
    return "fn" if issubclass(type, ctypes._CFuncPtr) else "ptr"


def layout():
    """{name: (offset, size, kind)} of every struct and field, as this module has it."""
    rows = {}
    for name, struct in STRUCTS.items():
        rows[name] = (0, ctypes.sizeof(struct), "struct")
        for field, type in struct._fields_:
            at = getattr(struct, field)
            rows[f"{name}.{field}"] = (at.offset, at.size, _kind(type))
    return rows


def check_layout(manifest, ours=None):
    """Compare `layout()` with what a library says of itself. @raise ImportError naming the struct and the field."""
    version, *lines = manifest.splitlines()
    theirs = {}
    for line in lines:
        name, offset, size, kind = line.split(" ")
        theirs[name] = (int(offset), int(size), kind)
    for name, here in (ours or layout()).items():
        there = theirs.get(name)
        if there == here or (here[2] == "struct" and there and there[2] == "struct" and there[1] > here[1]):
            continue  # a struct may be longer in a newer library: the tail is not ours
        struct, _, field = name.partition(".")
        what = f"field {field} of {struct}" if field else struct
        said = f"{there[2]} of {there[1]} bytes at offset {there[0]}" if there else "not there"
        raise ImportError(f"the library ({version}) and this package ({VERSION}) disagree: {what} is {said} in the library, "
                          f"{here[2]} of {here[1]} bytes at offset {here[0]} here. Install a package and a library of one version.")


def _load(path):
    try:
        library = ctypes.CDLL(path)  # CDLL, not PyDLL: every call lets other Python threads run
    except OSError as problem:
        raise ImportError(f"cannot load Carom's library ({problem}). Install the wheel, or set CAROM_LIBRARY to the path of {FILE}") from None
    for name, (since, result, arguments) in FUNCTIONS.items():
        try:
            function = getattr(library, name)
        except AttributeError:
            raise ImportError(f"{path} is older than this package: it lacks {name}, which came with {since}. "
                              f"Install libcarom {VERSION} or newer.") from None
        function.restype, function.argtypes = result, arguments
    check_layout(library.carom_abi_manifest().decode())
    return library


LIBRARY = _find()
lib = _load(LIBRARY)
globals().update({name: getattr(lib, name) for name in FUNCTIONS})
