"""The raw layer of bindings/python: ctypes declarations of all that the headers declare, and stubs for it."""
import keyword
import re

SCALARS = {"uint8_t": "c_uint8", "int32_t": "c_int32", "uint32_t": "c_uint32", "uint64_t": "c_uint64", "int64_t": "c_int64",
           "double": "c_double", "char": "c_char"}
IMPORTED = "CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_int32, c_uint8, c_uint32, c_uint64, c_void_p"


class Types:
    """C's spelling of a type to ctypes' expression for it."""

    def __init__(self, api):
        self.handles = {h["name"] for h in api["handles"]}
        self.opaque = {o["name"] for o in api["opaque"]}
        self.callbacks = {c["name"] for c in api["callbacks"]}
        self.structs = {s["name"] for s in api["structs"]}

    def of(self, spelled):
        match = re.fullmatch(r"(.*?) \(\*\)\((.*)\)", spelled)
        if match:
            return self.function(match.group(1), [a for a in match.group(2).split(", ") if a != "void"])
        stars = spelled.count("*")
        base = re.sub(r"\bconst\b|\*", "", spelled).strip()
        if base == "void":
            base, stars = ("None", 0) if stars == 0 else ("c_void_p", stars - 1)
        elif base in self.opaque:
            base, stars = "c_void_p", stars - 1
        elif base == "char" and stars:
            base, stars = "c_char_p", stars - 1
        elif base in SCALARS:
            base = SCALARS[base]
        return "POINTER(" * stars + base + ")" * stars

    def function(self, returns, arguments):
        return f"CFUNCTYPE({', '.join([self.of(returns)] + [self.of(a) for a in arguments])})"


def declarations(api):
    types = Types(api)
    out = ['"""ctypes declarations of include/carom. Written by bindings/gen/generate from include/carom; do not edit."""',
           f"from ctypes import {IMPORTED}", "", f"VERSION = {api['version']!r}", f"SONAME = {api['soname']!r}", "", "# constants"]
    out += [f"{c['name']} = {c['value']!r}" for c in api["constants"]]
    out += ["", "# handles"] + [f"{h['name']} = c_uint64" for h in api["handles"]]
    out += ["", "# callbacks"]
    out += [f"{c['name']} = {types.function(c['returns'], [a['type'] for a in c['arguments']])}" for c in api["callbacks"]]
    out += ["", "# structs"]
    for s in api["structs"]:
        fields = ", ".join(f'("{f["name"]}", {types.of(f["type"])}{" * %d" % f["count"] if "count" in f else ""})' for f in s["fields"])
        out += [f"class {s['name']}(Structure):", f"    _fields_ = [{fields}]"]
    out += ["", "STRUCTS = {", *(f'    "{s["name"]}": {s["name"]},' for s in api["structs"]), "}"]
    out += ["", "# which fields are handles, and of what", "HANDLES = {"]
    for s in api["structs"]:
        named = {f["name"]: f["type"] for f in s["fields"] if f["type"] in types.handles}
        if named:
            out.append(f'    "{s["name"]}": {named},')
    out += ["}", "", "# name: (since, restype, argtypes)", "FUNCTIONS = {"]
    for f in api["functions"]:
        arguments = "".join(types.of(a["type"]) + ", " for a in f["arguments"]).strip()
        out.append(f'    "{f["name"]}": ("{f["since"]}", {types.of(f["returns"])}, ({arguments})),')
    return "\n".join(out + ["}", ""])


PYTHON = {"c_int32": "int", "c_uint32": "int", "c_uint64": "int", "c_double": "float", "c_char_p": "bytes",
          "c_void_p": "int | None", "None": "None"}


def stubs(api):
    """Names, types and the headers' documentation for editors and type checkers."""
    types = Types(api)

    def doc(text, indent):
        return indent + '"""' + text.replace("\\", "\\\\").replace('"""', "'''").replace("\n", "\n" + indent) + '"""'

    out = ['"""Written by bindings/gen/generate from include/carom; do not edit."""', "import builtins", "import ctypes",
           "from typing import Any", "", "VERSION: str", "FILE: str", "LIBRARY: str", "lib: ctypes.CDLL",
           "STRUCTS: dict[str, type[ctypes.Structure]]", "HANDLES: dict[str, dict[str, str]]", "FUNCTIONS: dict[str, tuple[str, Any, tuple[Any, ...]]]",
           "def layout() -> dict[str, tuple[int, int, str]]: ...",
           "def check_layout(manifest: str, ours: dict[str, tuple[int, int, str]] | None = ...) -> None: ..."]
    out += [f"{c['name']}: {'str' if c['type'] == 'string' else 'int'}" for c in api["constants"]]
    out += [f"{h['name']} = ctypes.c_uint64" for h in api["handles"]] + [f"{c['name']}: Any" for c in api["callbacks"]]
    for s in api["structs"]:
        out += [f"class {s['name']}(ctypes.Structure):"] + ([doc(s["doc"], "    ")] if s["doc"] else [])
        for f in s["fields"]:
            ctype = types.of(f["type"])
            if f["type"] == "char":
                type = "builtins.bytes"  # a field may have that name, too
            elif f["type"] in types.handles:
                type = "int"
            else:
                type = PYTHON[ctype] if ctype in ("c_int32", "c_uint32", "c_uint64", "c_double") and "count" not in f else "Any"
            if not keyword.iskeyword(f["name"]):
                out.append(f"    {f['name']}: {type}")
    for f in api["functions"]:
        arguments = ", ".join(f"{a['name']}: Any" for a in f["arguments"])
        out += [f"def {f['name']}({arguments}) -> {PYTHON.get(types.of(f['returns']), 'Any')}:", doc(f["doc"] or f["name"], "    "), "    ..."]
    return "\n".join(out) + "\n"
