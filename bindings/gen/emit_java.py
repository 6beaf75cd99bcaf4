"""The raw layer of bindings/java: one class, by java.lang.foreign. Functions and constants have C's names, structs are classes over
memory that the caller's Arena owns. Above it the calls on engines and worlds that need no pointer of the caller's."""
import re

import calls as faces
from c_reader import HeaderError

VALUES = {"int32_t": ("int", "JAVA_INT"), "uint32_t": ("int", "JAVA_INT"), "uint64_t": ("long", "JAVA_LONG"), "int64_t": ("long", "JAVA_LONG"),
          "double": ("double", "JAVA_DOUBLE")}
POINTER = ("MemorySegment", "ADDRESS")
TAKEN = {"default", "native", "switch", "class", "int", "long", "float", "double", "short", "char", "boolean", "static", "final", "abstract",
         "interface", "package", "return", "new", "wait", "notify", "hashCode", "toString", "getClass", "equals", "segment"}


def class_of(c_name):
    return "".join(part.capitalize() for part in c_name.removeprefix("carom_").split("_"))


def name_of(c_name):
    first, *rest = c_name.split("_")
    name = first + "".join(part.capitalize() for part in rest)
    return name + "_" if name in TAKEN else name


def docs(text, indent):
    if not text:
        return []
    text = re.sub(r"@(\w+)", r"\1:", text)  # tags that Java does not know, or whose names it would look up
    for plain, written in (("*/", "* /"), ("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ("\\", "&#92;")):
        text = text.replace(plain, written)
    return [f"{indent}/** " + text.replace("\n", f"\n{indent} *  ") + " */"]


def value_of(constant):
    value = constant["value"]
    if constant["type"] == "string":
        return "String", f'"{value}"'
    if constant["type"] == "u64":
        return "long", f"0x{value:x}L"
    return "int", f"0x{value:x}" if value >= 2**31 else str(value)


class Types:
    def __init__(self, api):
        self.values = {**VALUES, **{h["name"]: VALUES["uint64_t"] for h in api["handles"]}}

    def of(self, c_type):
        return POINTER if "*" in c_type else self.values.get(c_type, POINTER)  # the rest is a callback

    def descriptor(self, returns, arguments):
        layouts = [self.of(a["type"])[1] for a in arguments]
        return f"FunctionDescriptor.ofVoid({', '.join(layouts)})" if returns == "void" else \
            f"FunctionDescriptor.of({', '.join([self.of(returns)[1]] + layouts)})"

    def field(self, owner, f):
        """A getter and a setter that gives back the struct."""
        name, at = name_of(f["name"]), f["offset"]
        if f["type"] == "char":
            return [f"public String {name}() {{ return segment.getString({at}); }}"]
        java, layout = self.of(f["type"])
        if "count" not in f:
            return [f"public {java} {name}() {{ return segment.get({layout}, {at}); }}",
                    f"public {owner} {name}({java} it) {{ segment.set({layout}, {at}, it); return this; }}"]
        n = f["count"]
        return [f"public {java}[] {name}() {{ return segment.asSlice({at}, {f['size']}).toArray({layout}); }}",
                f"public {owner} {name}({java}... it) {{ MemorySegment.copy(it, 0, segment, {layout}, {at}, count(it.length, {n})); return this; }}"]


# What the calls on engines and worlds share.
HELP = '''\
    // What C is given of Java's: NULL for null, and never an empty block, since a shape may have no parameters.
    static MemorySegment in(Arena arena, double... it) { return it == null ? MemorySegment.NULL : it.length == 0 ? arena.allocate(8, 8) : arena.allocateFrom(JAVA_DOUBLE, it); }
    static MemorySegment in(Arena arena, long[] it) { return it == null ? MemorySegment.NULL : it.length == 0 ? arena.allocate(8, 8) : arena.allocateFrom(JAVA_LONG, it); }
    static MemorySegment in(Arena arena, int[] it) { return it == null ? MemorySegment.NULL : it.length == 0 ? arena.allocate(8, 8) : arena.allocateFrom(JAVA_INT, it); }
    static MemorySegment in(Arena arena, byte[] it) { return it.length == 0 ? arena.allocate(8, 8) : arena.allocateFrom(JAVA_BYTE, it); }
    static MemorySegment in(Arena arena, Vec3 v) { return v == null ? MemorySegment.NULL : in(arena, v.x(), v.y(), v.z()); }
    static MemorySegment in(Arena arena, Quat q) { return q == null ? MemorySegment.NULL : in(arena, q.x(), q.y(), q.z(), q.w()); }
    static MemorySegment in(Arena arena, String text) { return arena.allocateFrom(text); }

    static void fits(int n, int wanted) {
        if (n != wanted) throw new CaromException(CAROM_E_OUT_OF_RANGE, n + " where " + wanted + " are wanted", "pass arrays of one length");
    }

    interface Ask {
        int of(MemorySegment pointer, MemorySegment dst, long capacity, MemorySegment count, MemorySegment error);
    }

    /** All of a list that says how many there are: asked for none first, then for all. */
    static MemorySegment list(Consumer<EngineCalls.Call> call, Arena arena, long size, Ask ask) {
        MemorySegment count = Arena.ofAuto().allocate(8, 8);
        for (long room = 0;; room = count.get(JAVA_LONG, 0)) {
            MemorySegment dst = room == 0 ? MemorySegment.NULL : arena.allocate(size * room, 8);
            long fits = room;
            call.accept((p, e) -> {
                int result = ask.of(p, dst, fits, count, e);
                return result == CAROM_E_BUFFER_TOO_SMALL && count.get(JAVA_LONG, 0) > fits ? CAROM_OK : result; // so do some say how many
            });
            if (count.get(JAVA_LONG, 0) <= room) return dst.asSlice(0, size * count.get(JAVA_LONG, 0));
        }
    }
'''

# Arrays of records, whose width goes by the field.
RECORDS = '''\
    static int width(int field, long[] bodies, int numbers) {
        if (field < 0 || field >= WIDTH.length) throw unfit("there is no field " + field);
        int width = WIDTH[field];
        if (numbers % width != 0 || bodies != null && numbers / width != bodies.length)
            throw unfit(numbers + " numbers, " + width + " a body" + (bodies == null ? "" : ", for " + bodies.length + " bodies"));
        return width;
    }

    static CaromException unfit(String what) {
        return new CaromException(Raw.CAROM_E_OUT_OF_RANGE, what, "pass as many numbers as the field has for as many bodies");
    }
'''

# What begins each class of calls.
OWNER = '''\
    private MemorySegment pointer;

    {name}Calls(MemorySegment pointer) {{ this.pointer = pointer; }}

    /** What calls of Raw take; NULL once it is closed, which they refuse. */
    public MemorySegment pointer() {{ return pointer; }}

    /** Any call of Raw on this {lower}: {lower}.call((p, e) -> Raw.{example}). */
    public void call(EngineCalls.Call call) {{
        var scratch = Library.Scratch.get();
        scratch.check(call.of(pointer, scratch.error.segment));
    }}

    /** Give back all memory; closing twice does nothing.{more} */
    @Override
    public void close() {{
        if (pointer.equals(MemorySegment.NULL)) return;
        call(Raw::carom_{lower}_destroy);
        pointer = MemorySegment.NULL;
    }}
'''
CALL = '''\
    /** A call of Raw that takes an engine or a world, then what it takes besides, then the error. */
    @FunctionalInterface
    public interface Call {
        int of(MemorySegment pointer, MemorySegment error);
    }
'''
EXAMPLES = {"Engine": "carom_engine_set_jobs(p, jobs, e)", "World": "carom_world_cast_rays(p, rays, want, desc, hits, e)"}


def raw(api):
    types = Types(api)
    out = ["// Written by bindings/gen/generate from include/carom; do not edit.", "package carom;", "",
           "import static java.lang.foreign.ValueLayout.*;", "", "import java.lang.foreign.*;", "import java.lang.invoke.MethodHandle;", "import java.util.function.Consumer;", "",
           "/** All of include/carom: functions and constants under their own names, structs as classes. A handle is a long. */",
           "public final class Raw {", "    private Raw() {}", "",
           f'    public static final String VERSION = "{api["version"]}";', f'    public static final String SONAME = "{api["soname"]}";']
    for c in api["constants"]:
        out += docs(c["doc"], "    ") + ["    public static final {0} {2} = {1};".format(*value_of(c), c["name"])]
    for c in api["callbacks"]:
        out += docs(c["doc"], "    ") + [f"    public static final FunctionDescriptor {c['name']} = {types.descriptor(c['returns'], c['arguments'])};"]
    out += ["", "    private static int count(int given, int wanted) {",
            '        if (given != wanted) throw new IllegalArgumentException(wanted + " numbers are wanted, " + given + " given");',
            "        return given;", "    }", ""]
    for s in api["structs"]:
        owner = class_of(s["name"])
        out += docs(s["doc"], "    ") + [f"    public static final class {owner} {{", f"        public static final int SIZE = {s['size']};",
                                         "        public final MemorySegment segment;"]
        if s["init"]:
            fill = f" {s['init']}(segment, SIZE);"
        elif s["fields"][0]["name"] == "struct_size":
            fill = " segment.set(JAVA_INT, 0, SIZE);"
        else:
            fill = ""
        out += [f"        public {owner}(Arena arena) {{ segment = arena.allocate(SIZE, 8);{fill} }}",
                f"        public {owner}(MemorySegment at) {{ segment = at; }}"]
        for f in s["fields"]:
            if f["name"] not in ("struct_size", "reserved", "reserved2"):
                out += docs(f["doc"], "        ") + ["        " + line for line in types.field(owner, f)]
        out += ["    }", ""]
    names = [class_of(s["name"]) for s in api["structs"]]
    if len(names) != len(set(names)):
        raise HeaderError("two structs of one name in Java")
    for f in api["functions"]:
        given = ", ".join(f"{types.of(a['type'])[0]} {name_of(a['name'])}" for a in f["arguments"])
        passed = ", ".join(name_of(a["name"]) for a in f["arguments"])
        back, text = types.of(f["returns"])[0], f["returns"] == "const char *"
        call = f"({back}) {f['name']}_.CALL.invokeExact({passed})"
        if text:
            call = f"({call}).reinterpret(Long.MAX_VALUE).getString(0)"
        out += [f"    private static final class {f['name']}_ {{",
                f'        static final MethodHandle CALL = Library.call("{f["name"]}", {types.descriptor(f["returns"], f["arguments"])});', "    }"]
        out += docs(f["doc"], "    ")
        out += [f"    public static {'String' if text else back} {f['name']}({given}) {{",
                f"        try {{ return {call}; }} catch (Throwable problem) {{ throw Library.thrown(problem); }}", "    }", ""]
    out += [HELP, "    /** What this class was written for, as carom_abi_check() reads it. */", '    static final String LAYOUT = """', f"carom {api['version']}"]
    for s in api["structs"]:
        out.append(f"{s['name']} 0 {s['size']} struct")
        out += [f"{s['name']}.{f['name']} {f['offset']} {f['size']} {f['kind']}" for f in s["fields"]]
    return "\n".join(out + ['""";', "}", ""])


def kind_of(value):
    """Java's type of an argument, or of what comes back."""
    if value.kind in ("struct", "state"):
        return f"Raw.{class_of(value.base)}"
    if value.kind in ("text", "bytes"):
        return {"text": "String", "bytes": "byte[]"}[value.kind]
    java, _ = VALUES.get(value.base, VALUES["uint64_t"])
    if value.kind == "vector":
        return "Vec3" if value.count == 3 else "Quat" if value.count == 4 and "orientation" in value.name else "double[]"
    return java + "[]" if value.kind == "span" else java


def got(value, at):
    """What C wrote, as Java has it."""
    layout = VALUES.get(value.base, VALUES["uint64_t"])[1]
    numbers = f"{at}.toArray({layout})"
    return {"Vec3": f"Vec3.of({numbers})", "Quat": f"Quat.of({numbers})", "double[]": numbers}.get(kind_of(value), f"{at}.get({layout}, 0)")


def method(call):
    f, before, after, passed, results = call.function, [], [], {}, []
    for value in call.given:
        name, memory = name_of(value.name), name_of(value.name) + "_in"
        passed[value.name] = name
        if value.kind in ("struct", "state"):
            passed[value.name] = f"{name} == null ? MemorySegment.NULL : {name}.segment" if value.optional else f"{name}.segment"
        elif value.kind not in ("number", "handle"):
            before.append(f"var {memory} = Raw.in(local, {name});")
            passed[value.name] = memory
            if value.to:
                after.append(f"MemorySegment.copy({memory}, {VALUES.get(value.base, VALUES['uint64_t'])[1]}, 0, {name}, 0, {name}.length);")
    for value in call.back:
        memory = name_of(value.name) + "_out"
        if value.kind == "struct":
            before.append(f"var {memory} = new {kind_of(value)}(Arena.ofAuto());")
            passed[value.name] = f"{memory}.segment"
            results.append(memory)
        else:
            before.append(f"var {memory} = local.allocate({8 * value.count}, 8);")
            passed[value.name] = memory
            results.append(got(value, memory))
    for argument, how in call.passed.items():
        if isinstance(how, tuple):
            passed[argument] = {"list": "dst", "count": "count", "capacity": "capacity", "stride": f"Raw.{class_of(call.list)}.SIZE" if call.list else "",
                                "size": f"Raw.{class_of(getattr(how[1], 'base', ''))}.SIZE"}.get(how[0])
    for argument, (first, *others) in call.lengths.items():
        many = lambda v: f"{name_of(v.name)}.length" + (f" / {v.count}" if v.count > 1 else "")  # noqa: E731
        passed[argument] = many(first)
        before += [f"Raw.fits({name_of(o.name) + ' == null ? ' + many(first) + ' : ' if o.optional else ''}{many(o)}, {many(first)});" for o in others]
    words = ", ".join(["p", *(passed[a["name"]] for a in f["arguments"][1:-1]), "e"])
    raw_call, record = f"Raw.{f['name']}({words})", []
    if call.list:
        layout = VALUES.get(call.list, VALUES["uint64_t"])[1]
        struct = call.list.startswith("carom_") and call.list in STRUCTS
        arena, size = ("Arena.ofAuto()", f"Raw.{class_of(call.list)}.SIZE") if struct else ("local", {"uint8_t": 1, "uint32_t": 4}.get(call.list, 8))
        found = f"Raw.list(this::call, {arena}, {size}, (p, dst, capacity, count, e) -> {raw_call})"
        returns = f"Raw.{class_of(call.list)}[]" if struct else {"uint8_t": "byte[]", "uint32_t": "int[]"}.get(call.list, "long[]")
        last = [f"var all = {found};", f"var each = new Raw.{class_of(call.list)}[(int) (all.byteSize() / {size})];",
                f"for (int i = 0; i < each.length; i++) each[i] = new Raw.{class_of(call.list)}(all.asSlice((long) i * {size}, {size}));", "return each;"] \
            if struct else [f"return {found}.toArray({'JAVA_BYTE' if call.list == 'uint8_t' else layout});"]
        local = not struct or any("local" in line for line in before)
    else:
        last, local = [f"call((p, e) -> {raw_call});", *after], any("local" in line for line in before)
        returns = "void" if not results else kind_of(call.back[0])
        if len(results) > 1:
            returns = class_of(call.name)
            if returns != "Pose":
                record = [f"    public record {returns}({', '.join(f'{kind_of(v)} {name_of(v.name)}' for v in call.back)}) {{}}", ""]
            last.append(f"return new {returns}({', '.join(results)});")
        elif results:
            last.append(f"return {results[0]};")
    given = ", ".join(f"{kind_of(v)} {name_of(v.name)}" for v in call.given)
    given = given.removesuffix("double[] params") + "double... params" if given.endswith("double[] params") else given
    body = before + last
    if local:
        body = ["try (Arena local = Arena.ofConfined()) {", *("    " + line for line in body), "}"]
    return record + docs(f["doc"], "    ") + [f"    public {returns} {name_of(call.name)}({given}) {{", *("        " + line for line in body), "    }", ""]


def records(call):
    """Arrays of doubles: through memory that the thread keeps, since fresh pages would cost more than the copy."""
    f, given = call.function, next(v for v in call.given if v.kind == "records")
    name, to = name_of(given.name), given.to
    words = {"field": "field", "scalar": "Raw.CAROM_SCALAR_F64", "handles": "handles", "n": "n", given.name: "memory", "stride": "0"}
    copy = f"MemorySegment.copy(memory, JAVA_DOUBLE, 0, {name}, 0, {name}.length);" if to else f"MemorySegment.copy({name}, 0, memory, JAVA_DOUBLE, 0, {name}.length);"
    made = f"call((p, e) -> Raw.{f['name']}(p, {', '.join(words[a['name']] for a in f['arguments'][1:-1])}, e));"
    return docs(f["doc"], "    ") + [f"    public void {name_of(call.name)}(int field, long[] bodies, double[] {name}) {{",
        f"        long n = {name}.length / width(field, bodies, {name}.length);",
        f"        MemorySegment memory = Library.Scratch.get().buffer(8L * {name}.length);",
        *([] if to else ["        " + copy]),
        "        try (Arena local = Arena.ofConfined()) {", "            MemorySegment handles = Raw.in(local, bodies);", "            " + made, "        }",
        *(["        " + copy] if to else []), "    }", ""]


STRUCTS = set()


def calls(owner):
    def text_of(api):
        STRUCTS.update(s["name"] for s in api["structs"])
        name = owner.removeprefix("carom_").capitalize()
        lower, engine = name.lower(), name == "Engine"
        out = ["// Written by bindings/gen/generate from include/carom; do not edit.", "package carom;", "", "import static java.lang.foreign.ValueLayout.*;", "",
               "import java.lang.foreign.*;", "", f"/** Calls on {'an engine' if engine else 'a world'} that need no pointer of the caller's. A handle is a long. */",
               f"public abstract sealed class {name}Calls implements AutoCloseable permits {name} {{",
               *([CALL] if engine else []),
               OWNER.format(name=name, lower=lower, example=EXAMPLES[name], more=" Fails while worlds are open." if engine else "")]
        for o, methods in faces.calls(api):
            if o == owner:
                for call in methods:
                    if not any(v.kind == "records" for v in call.given):
                        out += method(call)
                    elif any(v.base == "carom_body" for v in call.given):  # of bodies; those of joints and particles are left to Raw
                        out += records(call)
        if not engine:
            widths = [re.match(r"(\d+): ", c["doc"]) for c in api["constants"] if re.fullmatch(r"CAROM_FIELD_(?!COUNT)[A-Z_]+", c["name"])]
            out += [f"    private static final int[] WIDTH = {{{', '.join(w[1] for w in widths)}}}; // numbers a body, by field", "", RECORDS]
        out[-1:] = [*out[-1].splitlines(), "}", ""]
        return "\n".join(out)
    return text_of


def small(text):
    return lambda api: "// Written by bindings/gen/generate from include/carom; do not edit.\npackage carom;\n\n" + text


VEC3 = small('''\
public record Vec3(double x, double y, double z) {
    static Vec3 of(double[] numbers) { return new Vec3(numbers[0], numbers[1], numbers[2]); }
}
''')
QUAT = small('''\
/** A rotation, of unit length. */
public record Quat(double x, double y, double z, double w) {
    public static final Quat IDENTITY = new Quat(0, 0, 0, 1);

    static Quat of(double[] numbers) { return new Quat(numbers[0], numbers[1], numbers[2], numbers[3]); }
}
''')
POSE = small('''\
/** A body's place, m, and its orientation. */
public record Pose(Vec3 position, Quat orientation) {}
''')
