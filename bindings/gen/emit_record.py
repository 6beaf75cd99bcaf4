"""How calls that change a world are written down, and made again: src/abi/record_calls.inc, src/tools/replay/calls.inc.

What a function does with an argument follows from its type; what does not is said here. A function that is neither known to
read nor of arguments that this knows is refused, so that nobody forgets to say how it is recorded.
"""
import re

from c_reader import HeaderError

BY = "Written by bindings/gen/generate from include/carom; do not edit."

# Functions of a world that change nothing of it; and those of recording itself and of the world's end.
READS = re.compile(r"carom_\w+?_(get|read|is|hash|measure|save|fork|draw|compare|translate|cast|overlap|closest|nearest|contains|find)(_\w+)?$")
# A budget chooses substeps by the time it measures: a record has its choices, as dials that were set. What is made of other
# calls is recorded as those.
NOT_RECORDED = {"carom_world_record_begin", "carom_world_record_end", "carom_world_destroy", "carom_world_set_budget",
                "carom_body_create_named", "carom_character_move", "carom_character_push", "carom_character_move_body",
                "carom_vehicle_drive"}

# Pointers to more than one element: how many, or of what shape.
#   ("array", n)                            n elements of the type
#   ("bytes", n)
#   ("records", n, field or 3, scalar, stride)   of so many numbers; the stride is not kept
SIZED = {
    ("carom_world_write", "handles"): ("array", "n"),
    ("carom_world_write", "src"): ("records", "n", "field_width(field)", "scalar", "stride"),
    ("carom_world_write_joints", "joints"): ("array", "n"),
    ("carom_world_write_joints", "src"): ("records", "n", "joint_bulk_width(field)", "scalar", "stride"),
    ("carom_particles_add", "positions"): ("records", "n", "3", "scalar", "position_stride"),
    ("carom_particles_add", "velocities"): ("records", "n", "3", "scalar", "velocity_stride"),
    ("carom_particles_remove", "indices"): ("array", "n"),
    ("carom_particles_write", "indices"): ("array", "n"),
    ("carom_particles_write", "src"): ("records", "n", "field_width(field)", "scalar", "stride"),
    ("carom_world_restore", "bytes"): ("bytes", "size"),
}
NUMBERS = ("uint32_t", "int32_t", "uint64_t", "double")


def changing(api):
    """Functions that change a world, without the world and the error among their arguments."""
    for function in api["functions"]:
        arguments = function["arguments"]
        if not arguments or arguments[0]["type"] != "carom_world *" or function["name"] in NOT_RECORDED:
            continue
        if not READS.match(function["name"]):
            yield function["name"], arguments[1:-1]


class Kinds:
    def __init__(self, api):
        self.handles = {h["name"] for h in api["handles"]}
        self.structs = {s["name"]: s for s in api["structs"]}

    def of(self, function, argument):
        """(what, detail): number, handle, shape, vector, struct, out, stride, array, bytes, records"""
        name, type = argument["name"], argument["type"]
        if (function, name) in SIZED:
            how = SIZED[function, name]
            return how[0], how[1:]
        if any(key[0] == function and how[0] == "records" and how[4] == name for key, how in SIZED.items()):
            return "stride", None
        if type == "carom_shape":
            return "shape", None
        if type in self.handles:
            return "handle", type
        if type in NUMBERS:
            return "number", type
        pointed = re.fullmatch(r"(const )?(\w+) \*", type)
        if pointed and pointed[1] and pointed[2] == "double" and "count" in argument:
            return "vector", argument["count"]
        if pointed and pointed[1] and pointed[2] in self.structs:
            return "struct", pointed[2]
        if pointed and not pointed[1] and pointed[2] in self.handles:
            return "out", pointed[2]
        raise HeaderError(f"{function}: how to record argument {name} ({type}) is not known: bindings/gen/emit_record.py says how")

    def handle_fields(self, struct):
        return [(f["name"], "shape" if f["type"] == "carom_shape" else "handle")
                for f in self.structs[struct]["fields"] if f["type"] in self.handles]


def length_of(what, detail):
    """How many elements a recorded list must have, in C++; records are recorded as bytes."""
    if what == "records":
        return f"Script::bytes_of({detail[0]}, {detail[1]}, {detail[2]})"
    return detail[0]


def spelled(argument):
    return argument["type"].replace(" *", "* ") + ("" if argument["type"].endswith("*") else " ") + argument["name"]


def record_calls(api):
    kinds = Kinds(api)
    lines = [f"// How each call that changes a world is written down; record_calls.h includes this. {BY}", "",
             "namespace carom::abi::record {", ""]
    for name, arguments in changing(api):
        used, says = [], []
        for argument in arguments:
            what, detail = kinds.of(name, argument)
            a = argument["name"]
            if what == "out":
                continue
            used.append(argument)
            if what in ("number", "handle"):
                says.append(f"to.number({a});")
            elif what == "shape":
                says.append(f"to.shape({a}), to.number({a});")
            elif what == "vector":
                says.append(f"to.list({a}, {detail});")
            elif what == "struct":
                says += [f"to.shape({a}->{field});" for field, kind in kinds.handle_fields(detail) if kind == "shape"]
                says.append(f"to.structure({a});")
            elif what == "array":
                says.append(f"to.list({a}, {detail[0]});")
            elif what == "bytes":
                says.append(f"to.bytes({a}, {detail[0]});")
            elif what == "records":
                says.append(f"to.records({a}, {', '.join(detail)});")
        lines.append(f"inline auto {name.removeprefix('carom_')}({', '.join(spelled(a) for a in used)}) {{")
        lines.append("  return [=](Serializer& to) {")
        lines += [f'    {say}' for say in [f'to.call("{name}");'] + says]
        lines += ["  };", "}"]
    return "\n".join(lines + ["", "}  // namespace carom::abi::record"]) + "\n"


def replay_calls(api):
    kinds = Kinds(api)
    lines = [f"// How each recorded call is made again, see script.h. {BY}"]
    for name, arguments in changing(api):
        lines.append(f'{{"{name}", [](Script& s) {{')
        given = []
        for argument in arguments:
            what, detail = kinds.of(name, argument)
            a = argument["name"]
            given.append(a)
            if what == "number":
                lines.append(f'   const auto {a} = s.number<{detail}>("{a}");')
            elif what in ("handle", "shape"):
                lines.append(f'   const auto {a} = s.{what}("{a}");')
            elif what == "vector":
                lines.append(f'   const auto* {a} = s.list<double>("{a}", {detail});')
            elif what == "struct":
                lines.append(f'   auto* {a} = s.structure<{detail}>("{a}");')
                lines += [f'   if ({a}) {a}->{field} = s.own_{kind}("{field}", {a}->{field});'
                          for field, kind in kinds.handle_fields(detail)]
            elif what == "array":
                element = re.fullmatch(r"const (\w+) \*", argument["type"])[1]
                call = "handles" if element in kinds.handles else f"list<{element}>"
                lines.append(f'   const auto* {a} = s.{call}("{a}");')
            elif what in ("bytes", "records"):
                lines.append(f'   const auto* {a} = s.list<std::byte>("{a}");')
            elif what == "out":
                lines.append("   uint64_t made = 0;")
                given[-1] = "&made"
            elif what == "stride":
                given[-1] = "0"
        # What counts an array may stand behind it: lengths are compared when all has been read.
        for argument in arguments:
            what, detail = kinds.of(name, argument)
            if what in ("array", "bytes", "records"):
                lines.append(f'   s.demand("{argument["name"]}", {length_of(what, detail)});')
        lines.append(f"   return {name}(s.world(), {', '.join(given + ['s.error()'])});")
        lines.append(" }},")
    return "\n".join(lines) + "\n"
