"""Calls on an engine or a world as the faces of languages offer them: values and spans in place of pointers and lengths, what C writes
as what comes back. What does not fit (a struct with pointers, a callback) is left to the raw layer."""
import re
from dataclasses import dataclass, field

import spelled
from c_reader import HeaderError

# By hand: what begins, ends or keeps something.
BY_HAND = {"carom_engine_destroy", "carom_world_destroy", "carom_body_create"}
WORDS = {"carom_shape_create_named": "shape", "carom_shape_create": "shape_of", "carom_body_create_named": "body_named",
         "carom_plugins_register_standard": "register_standard", "carom_world_get_particles": "particle_sets"}


@dataclass
class Value:
    """What a caller gives or gets. kind: number, handle, text, struct, state (a struct that C changes), vector (of `count` numbers),
    span (of `count` numbers an element), bytes, records (a span of what has as many numbers as a field); of `to` spans C writes the elements."""
    name: str
    kind: str
    base: str = ""
    count: int = 1
    optional: bool = False
    to: bool = False
    sized: bool = False  # a struct that carries its size


@dataclass
class Call:
    function: dict
    owner: str
    name: str
    given: list = field(default_factory=list)
    back: list = field(default_factory=list)
    passed: dict = field(default_factory=dict)  # by argument of C's: a Value, or ("length", span), ("size", struct), ("list", element) ...
    lengths: dict = field(default_factory=dict)  # by argument of C's, a number: the spans that tell it, those first that are always there
    list: str = ""  # type of the elements of a list that says how many there are

    @property
    def writes(self):
        return self.function["thread"] == "writer"


class Reader:
    def __init__(self, api):
        self.handles = {h["name"] for h in api["handles"]}
        self.structs = {s["name"]: s for s in api["structs"]}
        self.callbacks = {c["name"] for c in api["callbacks"]}
        self.opaque = {o["name"] for o in api["opaque"]}

    def plain(self, name):
        return not any("*" in f["type"] or f["type"] in self.callbacks for f in self.structs[name]["fields"])

    def sized(self, name):
        return self.structs[name]["fields"][0]["name"] == "struct_size"

    def read(self, function, owner):
        arguments = function["arguments"]
        if function["name"] in BY_HAND or not arguments or arguments[-1]["type"] != "carom_error *" or arguments[0]["type"] != f"{owner} *":
            return None
        call = Call(function, owner, "")
        lengths = {length: a["name"] for a in arguments for length in re.findall(r"^(?:\d \* )?(\w+)(?: \* width of field)?$", a.get("length", ""))}
        for a in arguments[1:-1]:
            base, consts = spelled.pointers(a["type"])
            length, value = a.get("length"), None
            if a["name"] == "scalar":
                call.passed["scalar"] = ("scalar", None)
            elif a["name"] == "capacity" and call.list:
                call.passed["capacity"] = ("capacity", call.list)
            elif not consts and a["name"] in lengths:
                call.passed[a["name"]] = ("length", lengths[a["name"]])
            elif not consts and a["name"] == "stride" and call.list:
                call.passed["stride"] = ("stride", call.list)
            elif a["name"] == "stride" and call.given[-1].kind == "records":
                call.passed["stride"] = ("record", None)
            elif not consts and a["name"] == "size" and call.back and call.back[-1].kind == "struct":
                call.passed["size"] = ("size", call.back[-1])
            elif a["name"] in ("count", "needed") and call.list:
                call.passed[a["name"]] = ("count", None)
            elif not consts:
                if base in self.callbacks or spelled.function(a["type"]):
                    return None
                value = Value(a["name"], "handle" if base in self.handles else "number", base)
            elif a["type"] == "const char *":
                value = Value(a["name"], "text")
            elif base in self.opaque or len(consts) > 1:
                return None
            elif length == "capacity" and a["nullable"]:
                call.list = "uint8_t" if base == "void" else base
                call.passed[a["name"]] = ("list", call.list)
                continue
            elif base in self.structs and not length:
                returned = a["direction"] != "in" and ("_get" in function["name"] or not self.structs[base]["init"])
                if a["direction"] == "in" and not self.plain(base):
                    return None
                value = Value(a["name"], "struct" if returned or a["direction"] == "in" else "state", base, optional=a["nullable"] and not returned,
                              sized=self.sized(base))
                if returned:
                    call.back.append(value)
                    call.passed[a["name"]] = value
                    continue
            else:
                value = self.array(a, base, length or "1")
                if value is None:
                    return None
                if value.kind in ("number", "handle", "vector") and a["direction"] != "in":
                    call.back.append(value)
                    call.passed[a["name"]] = value
                    continue
            if value:
                call.given.append(value)
                call.passed[a["name"]] = value
        for name, how in call.passed.items():
            if isinstance(how, tuple) and how[0] == "length":
                told = {a["name"] for a in arguments if re.fullmatch(rf"(\d \* )?{name}( \* width of field)?", a.get("length", ""))}
                call.lengths[name] = sorted((v for v in call.given if v.name in told and v.kind in ("span", "bytes", "records")), key=lambda v: v.optional)
        return call if set(call.passed) == {a["name"] for a in arguments[1:-1]} and not (call.list and call.back) else None

    def array(self, a, base, length):
        if length == "n * width of field" and a["stride"] == "stride":
            return Value(a["name"], "records", to=a["direction"] == "out")
        shape = re.fullmatch(r"(?:(\d) \* )?(\w+)", length)
        if not shape or base in self.structs or a["direction"] == "inout":
            return None
        many, of = int(shape[1] or 1), shape[2]
        if base == "void":
            return Value(a["name"], "bytes") if a["direction"] == "in" and many == 1 and "stride" not in a and not of.isdigit() else None
        if "stride" in a:
            return None
        if of.isdigit():
            number = int(of) * many
            if number > 1:
                return Value(a["name"], "vector", base, number, a["nullable"] and a["direction"] == "in")
            return None if a["direction"] == "in" else Value(a["name"], "handle" if base in self.handles else "number", base)
        return Value(a["name"], "span", base, many, a["nullable"], a["direction"] == "out")


def calls(api):
    """By owner; a name is C's without `carom_`, the owner, `body_` and `get_`. What makes a thing has that thing's name."""
    reader = Reader(api)
    for owner in ("carom_engine", "carom_world"):
        found = [call for f in api["functions"] if (call := reader.read(f, owner))]
        taken = set()
        for call in sorted(found, key=lambda c: c.function["name"].startswith("carom_body_")):  # a world's own go first
            plain = call.function["name"].removeprefix("carom_")
            plain = re.sub(r"_get$", "_desc", plain).removeprefix(owner.removeprefix("carom_") + "_")
            plain = re.sub(r"(^|_)get_", r"\1", plain)
            short = re.sub(r"_create$", "", plain if plain == "body_desc" else plain.removeprefix("body_"))
            call.name = WORDS.get(call.function["name"], plain if short in taken else short)
            if call.name in taken:
                raise HeaderError(f"two calls of the name {call.name}")
            taken.add(call.name)
        yield owner, found
