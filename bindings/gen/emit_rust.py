"""The raw layer of bindings/rust: all that the headers declare, with types of its own for handles, and the layout of each struct. Above it
the calls of the crate `carom` that need no pointer of the caller's."""
import re

import calls as faces
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


def element(value):
    """Of a span, of what comes back, of a number."""
    base = BASES.get(value.base, f"raw::{value.base}")
    return f"[{base}; {value.count}]" if value.count > 1 else base


def taken(value):
    """As an argument of a method."""
    rust = {"text": "&str", "bytes": "&[u8]", "struct": f"&raw::{value.base}", "state": f"&mut raw::{value.base}",
            "records": "[T; N]"}.get(value.kind) or element(value)
    if value.kind in ("span", "records"):
        rust = f"&mut [{rust}]" if value.to else f"&[{rust}]"
    return f"{name_of(value.name)}: " + (f"Option<{rust}>" if value.optional else rust)


def handed(value):
    """What is done before the call, and what C is given."""
    name = name_of(value.name)
    if value.kind == "text":
        return [f"let {name} = text({name})?;"], f"{name}.as_ptr()"
    if value.kind == "struct" and value.sized:  # its size is the crate's, whatever the caller wrote there
        whole = f"raw::{value.base} {{ struct_size: size_of::<raw::{value.base}>() as u32, ..*%s }}"
        if value.optional:
            return [f"let {name} = {name}.map(|it| {whole % 'it'});"], f"{name}.as_ref().map_or(null(), |it| it)"
        return [f"let {name} = {whole % name};"], f"&{name}"
    if value.kind == "state" and value.sized:
        return [f"{name}.struct_size = size_of::<raw::{value.base}>() as u32;"], name
    if value.kind in ("span", "vector", "bytes", "records"):
        cast = "" if value.kind == "span" and value.count == 1 or value.kind == "vector" else ".cast()"
        if value.optional:
            borrow = ".as_ref()" if value.kind == "vector" else ""
            return [], f"{name}{borrow}.map_or(null(), |it| it.as_ptr(){cast})"
        return [], f"{name}.{'as_mut_ptr' if value.to else 'as_ptr'}(){cast}"
    return [], name


def method(call):
    f, before, passed = call.function, [], {}
    for value in call.given:
        lines, passed[value.name] = handed(value)
        before += lines
    for value in call.back:
        before.append(f"let mut {name_of(value.name)} = <{element(value)}>::default();")
        passed[value.name] = f"{name_of(value.name)}.as_mut_ptr()" if value.count > 1 else f"&mut {name_of(value.name)}"
    for name, how in call.passed.items():
        if isinstance(how, tuple):
            passed[name] = {"length": name_of(name), "list": "dst.cast()" if call.list == "uint8_t" else "dst", "count": "count", "capacity": "capacity",
                            "scalar": "T::SCALAR", "record": "size_of::<[T; N]>() as u64",
                            "stride": f"size_of::<raw::{call.list}>() as u64", "size": f"size_of::<raw::{getattr(how[1], 'base', '')}>() as u64"}[how[0]]
    for name, (first, *others) in call.lengths.items():
        length = f"{name_of(first.name)}.map_or(0, |it| it.len())" if first.optional else f"{name_of(first.name)}.len()"
        before.append(f"let {name_of(name)} = {length} as u64;")
        before += [f"{name_of(o.name)}.map_or(Ok(()), |it| fits(it.len(), {name_of(name)}))?;" if o.optional else
                   f"fits({name_of(o.name)}.len(), {name_of(name)})?;" for o in others]
    generic = "<T: Scalar, const N: usize>" if any(v.kind == "records" for v in call.given) else ""
    given = ", ".join(["&mut self" if call.writes else "&self", *map(taken, call.given)])
    words = ", ".join(passed[a["name"]] for a in f["arguments"][1:-1])
    words = f"p, {words}, e" if words else "p, e"
    back = [element(v) for v in call.back]
    returns = f"Vec<{BASES.get(call.list, 'raw::' + call.list)}>" if call.list else back[0] if len(back) == 1 else f"({', '.join(back)})"
    names = [name_of(v.name) for v in call.back]
    if call.list:
        dst = "dst: *mut u8" if call.list == "uint8_t" else "dst"
        last = [f"self.list(|p, {dst}, capacity, count, e| unsafe {{ raw::{f['name']}({words}) }})"]
    elif back:
        last = [f"self.call(|p, e| unsafe {{ raw::{f['name']}({words}) }})?;", f"Ok({names[0] if len(names) == 1 else '(' + ', '.join(names) + ')'})"]
    else:
        last = [f"self.call(|p, e| unsafe {{ raw::{f['name']}({words}) }})"]
    return docs(f["doc"], "    ") + [f"    pub fn {name_of(call.name)}{generic}({given}) -> Result<{returns}> {{", *("        " + line for line in before + last), "    }", ""]


# What the methods below call.
HELP = '''\
/// Numbers of arrays: f32 or f64.
/// # Safety
/// `SCALAR` says what the type is.
pub unsafe trait Scalar: Copy {
    const SCALAR: u32;
}
unsafe impl Scalar for f32 {
    const SCALAR: u32 = raw::CAROM_SCALAR_F32;
}
unsafe impl Scalar for f64 {
    const SCALAR: u32 = raw::CAROM_SCALAR_F64;
}

fn refused(message: String, remedy: &str) -> Error {
    Error { code: raw::CAROM_E_OUT_OF_RANGE, argument: 0, message, remedy: remedy.into(), witness: None }
}

/// What C takes as a text.
pub(crate) fn text(text: &str) -> Result<CString> {
    CString::new(text).map_err(|_| refused(format!("{text:?} has a zero byte"), "leave it out"))
}

/// Whether slices that go together are of one length.
fn fits(n: usize, wanted: u64) -> Result<()> {
    let unlike = || refused(format!("{n} where {wanted} are wanted"), "pass slices of one length");
    (n as u64 == wanted).then_some(()).ok_or_else(unlike)
}

impl World {
    /// All of a list that says how many there are: asked for none first, then for all.
    fn list<T>(
        &self,
        ask: impl Fn(*mut raw::carom_world, *mut T, u64, *mut u64, *mut raw::carom_error) -> i32,
    ) -> Result<Vec<T>> {
        let (mut all, mut count) = (Vec::new(), 0);
        loop {
            let room = all.capacity() as u64;
            match self.call(|p, e| ask(p, all.as_mut_ptr(), room, &mut count, e)) {
                Err(error) if error.code != raw::CAROM_E_BUFFER_TOO_SMALL || count <= room => return Err(error),
                _ if count > room => all.reserve(count as usize), // some say so by that error
                _ => break,
            }
        }
        unsafe { all.set_len(count as usize) }; // as many were written: it was at most the capacity
        Ok(all)
    }
}
'''


def calls(api):
    """What needs no pointer of the caller's, as methods."""
    out = ["//! Calls of the interface as methods. Written by bindings/gen/generate from include/carom; do not edit.",
           "#![allow(rustdoc::broken_intra_doc_links, rustdoc::invalid_html_tags, clippy::doc_lazy_continuation, clippy::doc_overindented_list_items, clippy::too_many_arguments, clippy::type_complexity)]",
           "use crate::{raw, Engine, Error, Result, World};", "use std::ffi::CString;", "use std::mem::size_of;", "use std::ptr::null;", "", HELP]
    for owner, methods in faces.calls(api):
        out += [f"impl {owner.removeprefix('carom_').capitalize()} {{", *(line for call in methods for line in method(call))]
        out[-1:] = ["}", ""]
    return "\n".join(out)
