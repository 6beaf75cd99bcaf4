"""The raw layer of bindings/csharp: functions and constants under C's names in class Raw, by P/Invoke; structs of the same layout. Engines and
worlds are SafeHandles, which the runtime keeps alive for the length of a call. Beside a function that may fail stands one of its name without
`error`: it throws, takes values and spans in place of pointers and lengths, and returns what C writes."""
import re

import spelled
from c_reader import HeaderError

VALUES = {"int32_t": "int", "uint32_t": "uint", "uint64_t": "ulong", "int64_t": "long", "double": "double", "uint8_t": "byte", "char": "byte", "void": "void"}
DISPOSED = {"carom_engine_destroy", "carom_world_destroy"}  # of a pointer whose SafeHandle ends
OWNERS = {"carom_engine": "Engine", "carom_world": "World"}
KEYWORDS = {"params", "in", "out", "ref", "object", "fixed", "lock", "event", "base", "operator", "string", "is", "as", "checked", "default", "this",
            "new", "static", "switch", "class", "int", "long", "float", "double", "char", "namespace", "internal", "readonly", "override"}


def class_of(c_name):
    return "".join(part.capitalize() for part in c_name.removeprefix("carom_").split("_"))


def local(name):
    return "@" + name if name in KEYWORDS else name


def docs(text, indent):
    if not text:
        return []
    for plain, written in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;")):
        text = text.replace(plain, written)
    first, *rest = text.split("\n")
    lines = [f"{indent}/// <summary>{first}"] + [f"{indent}/// {line}".rstrip() for line in rest]
    return lines[:-1] + [lines[-1] + "</summary>"]


def value_of(constant):
    kind = {"i32": "int", "u32": "uint", "u64": "ulong", "string": "string"}[constant["type"]]
    return kind, f'"{constant["value"]}"' if kind == "string" else str(constant["value"])


class Types:
    def __init__(self, api):
        self.functions = {c["name"] for c in api["callbacks"]}
        self.opaque = {o["name"] for o in api["opaque"]}
        self.structs = {s["name"] for s in api["structs"]}
        self.bases = {**VALUES, **{h["name"]: "ulong" for h in api["handles"]}, **{s["name"]: class_of(s["name"]) for s in api["structs"]}}

    def of(self, c_type):
        base, consts = spelled.pointers(c_type)
        if spelled.function(c_type) or base in self.functions:
            return "IntPtr"
        stars = len(consts)
        if base in self.opaque:  # only ever pointed to
            return "IntPtr" + "*" * (stars - 1)
        return self.bases[base] + "*" * stars

    def passed(self, argument):
        if argument["type"] == "const char *":
            return "[MarshalAs(UnmanagedType.LPUTF8Str)] string"
        base, consts = spelled.pointers(argument["type"])
        return OWNERS[base] if base in OWNERS and len(consts) == 1 else self.of(argument["type"])

    def field(self, owner, f):
        name = class_of(f["name"])
        name += "_" if name == owner else ""
        if "count" not in f:
            return f"public {self.of(f['type'])} {name};"
        if f["kind"] == "f64[3]":
            return f"public Vec3 {name};"
        if f["kind"] == "f64[4]" and ("orientation" in f["name"] or f["name"] == "target"):
            return f"public Quat {name};"
        return f"public fixed {self.of(f['type'])} {name}[{f['count']}];"


class Safe:
    """A function as C# calls it: what it takes, what happens before, what C is given, what comes back."""

    def __init__(self, types, function):
        self.types, self.function = types, function
        self.arguments = {a["name"]: a for a in function["arguments"][:-1]}
        self.given, self.fixed, self.before, self.passed, self.back, self.list = [], [], [], {}, [], None
        self.record = None  # of a bulk array: any struct of numbers
        self.lengths = {}  # the spans that tell an argument of C's
        self.known = self.find_list() and all(self.add(a) for a in self.arguments.values() if a["name"] not in self.passed)

    def find_list(self):
        """A buffer with a capacity and a count: what there is, as an array."""
        for a in self.arguments.values():
            if a.get("length") == "capacity" and a["nullable"]:
                base, _ = spelled.pointers(a["type"])
                self.list = "byte" if base == "void" else self.types.of(base)
                count = next(name for name in ("count", "needed") if name in self.arguments)
                self.passed.update({a["name"]: "to", "capacity": "(ulong)all.Length", count: "&count"})
                if "stride" in self.arguments:
                    self.passed["stride"] = f"(ulong)sizeof({self.list})"
        return True

    def add(self, a):
        name, kind, length = local(a["name"]), a["type"], a.get("length")
        base, consts = spelled.pointers(kind)
        opaque = base in self.types.opaque and len(consts) == 1
        if kind == "const char *" or opaque or not consts:
            if not consts and (a["name"] in self.passed or any(re.fullmatch(rf"(\d \* )?{a['name']}", o.get("length", "")) for o in self.arguments.values())):
                return True  # the spans tell it
            if a["name"] == "size":  # of the struct before it
                self.passed["size"] = f"(ulong)sizeof({self.back[-1][0]})"
                return True
            self.given.append((("string" if kind == "const char *" else self.types.passed(a)) + f" {name}", None))
            self.passed[a["name"]] = name
            return True
        if base == "void" and "stride" in a and a["stride"] == "stride" and length == "n * width of field":  # C refuses a stride below the field's width
            self.given.append((f"{'ReadOnlySpan' if a['direction'] == 'in' else 'Span'}<T> {name}", None))
            self.fixed.append(f"fixed (byte* {a['name']}_ = MemoryMarshal.Cast<T, byte>({name}))")
            self.lengths.setdefault("n", []).append((name, False))
            self.passed.update({a["name"]: f"Call.Some({a['name']}_)", "stride": "(ulong)Unsafe.SizeOf<T>()"})
            self.record = "T"
            return True
        made = base in self.types.opaque and len(consts) == 2
        one = a["direction"] != "in" and base not in ("void", "char") or base in self.types.structs  # C says of arrays how long they are
        if not (one or length) or len(consts) == 2 and not made:
            return False
        type, cast = "byte" if base == "void" else "IntPtr" if made else self.types.of(base), ""
        shape = re.fullmatch(r"(?:(\d) \* )?(\w+)", length or "1")
        if not shape:
            return False
        many, of = shape.groups()
        width = of if of in ("3", "4") else many
        if base == "double" and (width == "3" or width == "4" and "orientation" in name):
            type, cast = {"3": "Vec3", "4": "Quat"}[width], "(double*)"
        elif width or of.isdigit() and of != "1":
            return False
        wanted = "?" if a["nullable"] else ""
        if of in self.arguments:
            self.given.append((f"{'ReadOnlySpan' if a['direction'] == 'in' else 'Span'}<{type}> {name}", "default" if a["nullable"] else None))
            self.fixed.append(f"fixed ({type}* {a['name']}_ = {name})")
            self.lengths.setdefault(of, []).append((name, a["nullable"]))
            some = cast or f"({type}*)"  # an empty span is NULL
            self.passed[a["name"]] = f"{cast}{a['name']}_" if a["nullable"] else f"{some}Call.Some({a['name']}_)"
            self.passed.setdefault(of, f"(ulong){name}.Length")
        elif a["direction"] == "in" and wanted:
            self.given.append((f"{type}? {name}", "null"))
            self.before.append(f"{type} {a['name']}_ = {name}.GetValueOrDefault();")
            self.passed[a["name"]] = f"{name}.HasValue ? {cast}&{a['name']}_ : null"
        elif a["direction"] == "in":
            self.given.append((f"{type} {name}", None))
            self.passed[a["name"]] = f"{cast}&{name}"
        elif a["direction"] == "inout":
            self.given.append((f"ref {type} {name}", None))
            self.fixed.append(f"fixed ({type}* {a['name']}_ = &{name})")
            self.passed[a["name"]] = f"{cast}{a['name']}_"
        else:
            self.back.append((type, name))
            self.before.append(f"{type} {name};")
            self.passed[a["name"]] = f"{cast}&{name}"
        return True

    def lines(self):
        if not self.known or self.list and self.back:
            return []
        name, back = self.function["name"], [f"{type} {what}" for type, what in self.back]
        returns = f"{self.list}[]" if self.list else "void" if not back else self.back[0][0] if len(back) == 1 else f"({', '.join(back)})"
        given, required = [], False
        for text, usual in reversed(self.given):  # what follows a required argument is required
            required = required or usual is None
            given.append(text if required else f"{text} = {usual}")
        for spans in self.lengths.values():
            (first, may_be_empty), *others = sorted(spans, key=lambda span: span[1])
            self.passed[next(of for of, all in self.lengths.items() if all is spans)] = f"(ulong){first}.Length"
            self.before += [f"Call.Fits(nameof({other}), {other}.Length, {first}.Length, {str(empty).lower()});" for other, empty in others]
        call = "Call.Check(%s(%s, Call.Error));" % (name, ", ".join(self.passed[a] for a in self.arguments))
        generic, where = ("<T>", " where T : struct") if self.record else ("", "")
        head = f"        public static {returns} {name}{generic}({', '.join(reversed(given))}){where}"
        if not self.before and not self.fixed and not self.list:
            return [f"{head} => {call[:-1]};", ""]
        body = [*self.before, *pinned(self.fixed, call)]
        if self.list:
            none = call.replace("(to,", "(null,").replace(", to,", ", null,").replace("(ulong)all.Length", "0")
            body = [*self.before, "ulong count = 0;", *pinned(self.fixed, none), f"var all = new {self.list}[count];",
                    *pinned([*self.fixed, f"fixed ({self.list}* to = all)"], call), "return all;"]
        elif back:
            body.append("return " + (self.back[0][1] if len(back) == 1 else f"({', '.join(what for _, what in self.back)})") + ";")
        return [head, "        {", *("            " + line for line in body), "        }", ""]


def pinned(fixed, call):
    return [*fixed, "    " + call] if fixed else [call]


def number_struct(name, letters, more):
    """A struct of doubles that compares."""
    low = [letter.lower() for letter in letters]
    lines = [f"public double {', '.join(letters)};", *more,
             f"public {name}({', '.join('double ' + x for x in low)}) {{ {' '.join(f'{big} = {x};' for big, x in zip(letters, low))} }}",
             f"public bool Equals({name} o) => {' && '.join(f'{x} == o.{x}' for x in letters)};",
             f"public override bool Equals(object o) => o is {name} && Equals(({name})o);",
             f"public override int GetHashCode() => ({', '.join(letters)}).GetHashCode();",
             f"public override string ToString() => $\"({', '.join('{' + x + '}' for x in letters)})\";"]
    return [f"    public struct {name} : IEquatable<{name}>", "    {", *("        " + line for line in lines), "    }", ""]


def raw(api):
    types = Types(api)
    out = ["// <auto-generated>Written by bindings/gen/generate from include/carom; do not edit.</auto-generated>", "using System;", "using System.Runtime.CompilerServices;",
           "using System.Runtime.InteropServices;", "", "namespace Carom", "{"]
    out += number_struct("Vec3", "XYZ", []) + number_struct("Quat", "XYZW", ["public static readonly Quat Identity = new Quat(0, 0, 0, 1);"])
    names = [class_of(s["name"]) for s in api["structs"]]
    if len(names) != len(set(names)):
        raise HeaderError("two structs of one name in C#")
    for s in api["structs"]:
        owner = class_of(s["name"])
        out += docs(s["doc"], "    ") + ["    [StructLayout(LayoutKind.Sequential)]", f"    public unsafe struct {owner}", "    {"]
        for f in s["fields"]:
            out += docs(f["doc"], "        ") + ["        " + types.field(owner, f)]
        if s["init"]:
            out += ["", "        /// <summary>With the library's defaults.</summary>", f"        public static {owner} New()", "        {",
                    f"            {owner} it;", f"            Raw.{s['init']}(&it, (uint)sizeof({owner}));", "            return it;", "        }"]
        elif s["fields"][0]["name"] == "struct_size":
            out += ["", "        /// <summary>With its size set.</summary>",
                    f"        public static {owner} New() {{ return new {owner} {{ StructSize = (uint)sizeof({owner}) }}; }}"]
        out += ["    }", ""]
    for c in api["callbacks"]:
        given = ", ".join(f"{types.of(a['type'])} {local(a['name'])}" for a in c["arguments"])
        out += docs(c["doc"], "    ") + ["    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]",
                                         f"    public unsafe delegate {types.of(c['returns'])} {c['name']}({given});", ""]
    out += ["    /// <summary>All of include/carom: functions and constants under their own names. A handle is a ulong. A function without an error",
            "    /// throws a CaromException, and takes values and spans.</summary>",
            "    public static unsafe class Raw", "    {", f'        public const string Version = "{api["version"]}";',
            f'        public const string Soname = "{api["soname"]}";', '        internal const string File = "carom";', "",
            "        static Raw() { Library.Name(); }", ""]
    for c in api["constants"]:
        kind, value = value_of(c)
        out += docs(c["doc"], "        ") + [f"        public const {kind} {c['name']} = {value};"]
    out.append("")
    for f in api["functions"]:
        given = ", ".join(f"{types.passed(a)} {local(a['name'])}" for a in f["arguments"])
        names = ", ".join(local(a["name"]) for a in f["arguments"])
        out += docs(f["doc"], "        ")
        if f["returns"] == "const char *":
            out += [f"        public static string {f['name']}({given}) {{ return Marshal.PtrToStringUTF8({f['name']}_({names})); }}",
                    f'        [DllImport(File, EntryPoint = "{f["name"]}", CallingConvention = CallingConvention.Cdecl)]',
                    f"        private static extern IntPtr {f['name']}_({given});", ""]
        else:
            access = "internal" if f["name"] in DISPOSED else "public"
            if f["name"] in DISPOSED:
                given = ", ".join(f"{types.of(a['type'])} {local(a['name'])}" for a in f["arguments"])
            out += ["        [DllImport(File, CallingConvention = CallingConvention.Cdecl)]",
                    f"        {access} static extern {types.of(f['returns'])} {f['name']}({given});", ""]
            if access == "public" and f["arguments"] and f["arguments"][-1]["type"] == "carom_error *":
                out += Safe(types, f).lines()
    out.append(f'        internal const string Layout = @"carom {api["version"]}')  # as carom_abi_check() reads it
    for s in api["structs"]:
        out.append(f"{s['name']} 0 {s['size']} struct")
        out += [f"{s['name']}.{f['name']} {f['offset']} {f['size']} {f['kind']}" for f in s["fields"]]
    return "\n".join(out + ['";', "    }", "}", ""])
