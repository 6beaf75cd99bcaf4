"""The raw layer of bindings/lua: LuaJIT's ffi.cdef reads C, so this is the C of the headers without its preprocessor."""


def named(type, name, count=None):
    """A C declaration of a variable from a type spelled without a name."""
    if "(*)" in type:
        return type.replace("(*)", f"(*{name})", 1)
    array = "" if count is None else f"[{count}]"
    return f"{type}{'' if type.endswith('*') else ' '}{name}{array}"


def listed(arguments):
    return ", ".join(named(a["type"], a["name"]) for a in arguments) or "void"


def number(constant):
    if constant["type"] == "string":
        return '"' + constant["value"] + '"'
    return f"0x{constant['value']:x}ULL" if constant["type"] == "u64" else str(constant["value"])


def cdef(api):
    out = ["-- Written by bindings/gen/generate from include/carom; do not edit.", 'require("ffi").cdef [[']
    out += [f"typedef struct {s['name']} {s['name']};" for s in api["opaque"] + api["structs"]]
    out += [f"typedef uint64_t {h['name']};" for h in api["handles"]]
    out += [f"typedef {c['returns']} (*{c['name']})({listed(c['arguments'])});" for c in api["callbacks"]]
    for s in api["structs"]:
        fields = "".join(f" {named(f['type'], f['name'], f.get('count'))};" for f in s["fields"])
        out.append(f"struct {s['name']} {{{fields} }};")
    out += [f"{named(f['returns'], f['name'])}({listed(f['arguments'])});" for f in api["functions"]]
    out += ["]]", "return {"]
    out += [f"  {c['name']} = {number(c)}," for c in api["constants"]]
    rows = len(api["structs"]) + sum(len(s["fields"]) for s in api["structs"])
    return "\n".join(out + [f'  VERSION = "{api["version"]}",', f"  ROWS = {rows}, -- of the layout manifest", "}", ""])

