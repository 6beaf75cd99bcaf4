"""What is written from the headers' data: one function a file, each gives the file's whole text."""
import json
from pathlib import Path

import emit_cpp
import emit_csharp
import emit_go
import emit_java
import emit_js
import emit_lua
import emit_pages
import emit_python
import emit_record
import emit_records
import emit_rust

BY = "Written by bindings/gen/generate from include/carom; do not edit."


def api_json(api):
    """One line for each constant, field, argument: a change of a header is as small here."""
    def text(value, indent, leaf):
        if isinstance(value, dict) and not leaf:
            inside = [f"{indent} {json.dumps(key)}: {text(item, indent + ' ', False)}" for key, item in value.items()]
            return "{\n" + ",\n".join(inside) + f"\n{indent}}}"
        if isinstance(value, list) and value and isinstance(value[0], dict):
            flat = not any(isinstance(item, list) for item in value[0].values())
            return "[\n" + ",\n".join(f"{indent} {text(item, indent + ' ', flat)}" for item in value) + f"\n{indent}]"
        return json.dumps(value, ensure_ascii=False)
    return text(api, "", False) + "\n"


def manifest_rows(api):
    lines = [f"// Rows of the layout manifest, see manifest.cpp. {BY}"]
    for struct in api["structs"]:
        lines.append(f"CAROM_STRUCT({struct['name']})")
        lines += [f"CAROM_FIELD({struct['name']}, {field['name']})" for field in struct["fields"]]
    return "\n".join(lines) + "\n"


FILES = {
    "bindings/api.json": api_json,
    "include/carom/fill.hpp": emit_cpp.fill,
    "src/abi/manifest_rows.inc": manifest_rows,
    "src/abi/record_calls.inc": emit_record.record_calls,
    "src/tools/replay/calls.inc": emit_record.replay_calls,
    "bindings/js/src/constants.js": emit_js.constants,
    "bindings/js/src/constants.d.ts": emit_js.constant_types,
    "bindings/js/src/raw.d.ts": emit_js.raw_types,
    "bindings/js/src/recorded_calls.js": emit_js.recorded_calls,
    "bindings/lua/carom_cdef.lua": emit_lua.cdef,
    "bindings/python/carom/_c.py": emit_python.declarations,
    "bindings/python/carom/records.py": emit_records.records,
    "bindings/python/carom/raw.pyi": emit_python.stubs,
    "bindings/go/raw/raw.go": emit_go.raw,
    "bindings/go/calls.go": emit_go.calls,
    "bindings/csharp/Carom/Raw.cs": emit_csharp.raw,
    "bindings/java/carom/Raw.java": emit_java.raw,
    "bindings/java/carom/Vec3.java": emit_java.VEC3,
    "bindings/java/carom/Quat.java": emit_java.QUAT,
    "bindings/java/carom/Pose.java": emit_java.POSE,
    "bindings/java/carom/EngineCalls.java": emit_java.calls("carom_engine"),
    "bindings/java/carom/WorldCalls.java": emit_java.calls("carom_world"),
    "bindings/rust/carom-sys/src/lib.rs": emit_rust.sys,
    "bindings/rust/carom/src/calls.rs": emit_rust.calls,
    **emit_pages.pages(sorted(path.name for path in (Path(__file__).resolve().parents[2] / "include" / "carom").glob("*.h"))),
}
