"""The raw layer of bindings/rust: all that the headers declare, with types of its own for handles, and the layout of each struct."""
import spelled

BASES = {"int32_t": "i32", "uint32_t": "u32", "uint64_t": "u64", "int64_t": "i64", "double": "f64", "uint8_t": "u8", "char": "c_char", "void": "c_void"}
KEYWORDS = {"type", "match", "move", "ref", "where", "in", "box", "final", "loop"}


def name_of(c_name):
    return f"r#{c_name}" if c_name in KEYWORDS else c_name


def type_of(c_type, callbacks):
    called = spelled.function(c_type)
    if called:
        return function_type(called[0], called[1], callbacks)
    base, consts = spelled.pointers(c_type)
    rust = BASES.get(base, base)
    for const in consts:
        rust = f"*{'const' if const else 'mut'} {rust}"
    return rust


def function_type(returns, arguments, callbacks):
    back = "" if returns == "void" else f" -> {type_of(returns, callbacks)}"
    return f"Option<unsafe extern \"C\" fn({', '.join(type_of(a, callbacks) for a in arguments)}){back}>"


def docs(text, indent=""):
    return [f"{indent}/// {line}".rstrip() for line in text.split("\n")] if text else []


def value_of(constant):
    if constant["type"] == "string":
        return "&str", '"' + constant["value"] + '"'
    return constant["type"], str(constant["value"])


def sys(api):
    callbacks = {c["name"] for c in api["callbacks"]}
    out = ["//! All of include/carom under its own names. Written by bindings/gen/generate from include/carom; do not edit.",
           "#![no_std]", "#![allow(non_camel_case_types, rustdoc::broken_intra_doc_links, rustdoc::invalid_html_tags)]",
           "use core::ffi::{c_char, c_void};", "use core::mem::{offset_of, size_of, zeroed};", "",
           f'pub const VERSION: &str = "{api["version"]}";', f'pub const SONAME: &str = "{api["soname"]}";']
    for c in api["constants"]:
        out += docs(c["doc"]) + ["pub const {}: {} = {};".format(c["name"], *value_of(c))]
    for o in api["opaque"]:
        out += docs(o["doc"]) + ["#[repr(C)]", f"pub struct {o['name']} {{", "    _opaque: [u8; 0],", "}"]
    for h in api["handles"]:  # repr(transparent): passed as the number that it is
        out += docs(h["doc"]) + ["#[repr(transparent)]", "#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]",
                                 f"pub struct {h['name']}(pub u64);"]
    for c in api["callbacks"]:
        out += docs(c["doc"]) + [f"pub type {c['name']} = {function_type(c['returns'], [a['type'] for a in c['arguments']], callbacks)};"]
    for s in api["structs"]:
        out += docs(s["doc"]) + ["#[repr(C)]", "#[derive(Clone, Copy, Debug)]", f"pub struct {s['name']} {{"]
        for f in s["fields"]:
            rust = type_of(f["type"], callbacks)
            out += docs(f["doc"], "    ")
            out.append(f"    pub {name_of(f['name'])}: " + (f"[{rust}; {f['count']}]," if "count" in f else f"{rust},"))
        out.append("}")
        out += default_of(s)
    out += ['extern "C" {']
    for f in api["functions"]:
        arguments = ", ".join(f"{name_of(a['name'])}: {type_of(a['type'], callbacks)}" for a in f["arguments"])
        back = "" if f["returns"] == "void" else f" -> {type_of(f['returns'], callbacks)}"
        out += docs(f["doc"], "    ") + [f"    pub fn {f['name']}({arguments}){back};"]
    out += ["}", "/// Name, offset, size and kind of each struct and field, as the lines of carom_abi_manifest().",
            "pub static LAYOUT: &[(&str, usize, usize, &str)] = &["]
    for s in api["structs"]:
        out.append(f'    ("{s["name"]}", 0, size_of::<{s["name"]}>(), "struct"),')
        for f in s["fields"]:
            rust = type_of(f["type"], callbacks)
            many = f" * {f['count']}" if "count" in f else ""
            place = f"offset_of!({s['name']}, {name_of(f['name'])}), size_of::<{rust}>(){many}"
            out.append(f'    ("{s["name"]}.{f["name"]}", {place}, "{f["kind"]}"),')
    return "\n".join(out + ["];", ""])


def default_of(s):
    """As the library fills it; else, of a struct that it writes to, with its size set."""
    if s["init"]:
        fill = f"{s['init']}(&mut it, size_of::<{s['name']}>() as u32);"
    elif s["fields"][0]["name"] == "struct_size":
        fill = f"it.struct_size = size_of::<{s['name']}>() as u32;"
    else:
        fill = ""
    return [f"impl Default for {s['name']} {{", "    fn default() -> Self {", "        unsafe {",
            f"            let {'mut ' if fill else ''}it: Self = zeroed();"] + ([f"            {fill}"] if fill else []) + [
            "            it", "        }", "    }", "}"]
