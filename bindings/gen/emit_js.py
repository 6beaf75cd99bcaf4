"""The raw layer of bindings/js: constants, and types of what the module exports. Layouts of structs are not here: 32-bit
pointers move fields, so the package asks carom_abi_manifest() of the module that it has loaded."""
import json
import re

import emit_record
from c_reader import HeaderError

BY = "// Written by bindings/gen/generate from include/carom; do not edit."


def _value(constant):
    value = constant["value"]
    if constant["type"] == "string":
        return '"' + value + '"'
    return f"{value}n" if constant["type"] == "u64" else str(value)


def _kinds_of_joints(api):
    """{ ball: 0, ... }: what the package takes for CAROM_JOINT_*."""
    values = {c["name"]: c["value"] for c in api["constants"]}
    names = next(e["values"] for e in api["enumerations"] if e["name"] == "joint")
    return "{ " + ", ".join(f"{name.removeprefix('CAROM_JOINT_').lower()}: {values[name]}" for name in names) + " }"


def constants(api):
    lines = [f"export const {c['name']} = {_value(c)};" for c in api["constants"]]
    return "\n".join([BY] + lines + [f"export const JOINTS = {_kinds_of_joints(api)};"]) + "\n"


def _comment(text, indent):
    if not text:
        return []
    return [f"{indent}/** " + text.replace("*/", "* /").replace("\n", f"\n{indent} *  ") + " */"]


def constant_types(api):
    out = [BY]
    for c in api["constants"]:
        out += _comment(c["doc"], "")
        out.append(f"export const {c['name']}: {_value(c)};")
    out += ["/** Kinds of joints by name. */", f"export const JOINTS: {_kinds_of_joints(api)};"]
    return "\n".join(out) + "\n"


def raw_types(api):
    """Functions as WebAssembly has them: pointers and 32 bits are numbers, 64 bits are BigInts."""
    handles = {h["name"] for h in api["handles"]}

    def of(spelled):
        if "*" in spelled or spelled in ("int32_t", "uint32_t", "double") or spelled.endswith("_fn"):
            return "number"
        if spelled in handles or spelled in ("uint64_t", "int64_t"):
            return "bigint"
        return "void" if spelled == "void" else "number"

    out = [BY, "/** The C interface as the module exports it. A pointer is an offset into `memory`. */", "export interface Raw {",
           "  memory: WebAssembly.Memory;", "  malloc(bytes: number): number;", "  free(pointer: number): void;"]
    for f in api["functions"]:
        arguments = ", ".join(re.sub(r"\W", "_", a["name"]) + ": " + of(a["type"]) for a in f["arguments"])
        out += _comment(f["doc"], "  ")
        out.append(f"  {f['name']}({arguments}): {of(f['returns'])};")
    return "\n".join(out + ["}", ""])


def recorded_calls(api):
    """Arguments of each call that a recording holds, in order: recording.js reads them so."""
    kinds = emit_record.Kinds(api)

    def spelled(function, argument):
        name = argument["name"]
        what, detail = kinds.of(function, argument)
        if what == "number":
            return [what, name, detail]
        if what == "vector":
            return [what, name, detail]
        if what == "struct":
            if any(f["kind"] in ("ptr", "fn") for f in kinds.structs[detail]["fields"]):
                raise HeaderError(f"{function}: {detail} has a pointer, which no recording can hold")
            return [what, name, detail, kinds.handle_fields(detail)]
        if what == "array":
            element = re.fullmatch(r"const (\w+) \*", argument["type"])[1]
            if element in kinds.handles:
                return ["handles", name, detail[0]]
            return ["array", name, detail[0], {"uint32_t": 4, "uint64_t": 8, "double": 8}[element]]
        if what == "bytes":
            return ["array", name, detail[0], 1]
        if what == "records":
            asked = re.fullmatch(r"(\w+)\((\w+)\)", detail[1])
            width = asked[2] if asked else int(detail[1])
            return [what, name, detail[0], width, detail[2]] + (["carom_" + asked[1]] if asked and asked[1] != "field_width" else [])
        return [what, name]

    rows = [f"  {name}: {json.dumps([spelled(name, a) for a in arguments])}," for name, arguments in emit_record.changing(api)]
    return "\n".join([BY, "export const CALLS = {"] + rows + ["};", ""])
