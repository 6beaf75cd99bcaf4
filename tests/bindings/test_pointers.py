"""bindings/api.json says of every pointer which way it goes, whether it may be NULL and how long it is.

What it says of NULL is compared with the library: each argument in turn is NULL while the others are right. The library
refuses those that are not nullable with NULL_ARGUMENT, and no others.
"""

import ctypes
import json
import re
import unittest
from pathlib import Path

import carom
from carom import raw

ROOT = Path(__file__).resolve().parents[2]
API = json.loads((ROOT / "bindings/api.json").read_text())
FUNCTIONS = {f["name"]: f for f in API["functions"]}
STRUCTS = {s["name"]: s for s in API["structs"]}
# What ends the engine or world that the others need.
ENDS = {"carom_engine_destroy", "carom_world_destroy", "carom_batch_destroy", "carom_device_destroy"}


def pointers(owner, members="arguments"):
    return [m for m in owner[members] if "*" in m["type"] and "(*)" not in m["type"]]


class Said(unittest.TestCase):
    def test_of_every_pointer(self):
        for kind, members in (("functions", "arguments"), ("callbacks", "arguments"), ("structs", "fields")):
            for owner in API[kind]:
                for pointer in pointers(owner, members):
                    with self.subTest(of=owner["name"], pointer=pointer["name"]):
                        self.assertIn(pointer["direction"], ("in", "out", "inout"))
                        self.assertIsInstance(pointer["nullable"], bool)

    def test_const_is_in(self):
        for function in API["functions"]:
            for pointer in pointers(function):
                if pointer["type"].startswith("const ") and pointer["type"].count("*") == 1:
                    self.assertEqual(pointer["direction"], "in", (function["name"], pointer["name"]))

    def test_lengths_name_arguments(self):
        """Each name in a length or stride is an argument or field beside it, or the count of what else is passed."""
        for kind, members in (("functions", "arguments"), ("structs", "fields")):
            for owner in API[kind]:
                beside = {m["name"] for m in owner[members]}
                for pointer in pointers(owner, members):
                    text = pointer.get("length", "") + " " + pointer.get("stride", "")
                    text = re.sub("width of |(each )?zero-terminated", "", text)
                    for name in re.findall(r"\b[a-z_]+\b", re.sub(r"\b(?:rays|shapes|pairs)->count", "", text)):
                        self.assertIn(name, beside, (owner["name"], pointer["name"], text))

    def test_void_and_arrays_have_lengths(self):
        for function in API["functions"]:
            for pointer in pointers(function):
                if (
                    pointer["type"] in ("void *", "const void *")
                    and pointer["name"] != "user"
                    or pointer["name"] in ("dst", "indices")
                ):
                    self.assertIn("length", pointer, (function["name"], pointer["name"]))


class Owners(unittest.TestCase):
    def test_of_every_handle(self):
        owners = {h["name"]: h["owner"] for h in API["handles"] + API["opaque"]}
        self.assertEqual(tuple(owners[f"carom_{kind}"] for kind in ("engine", "world", "batch", "device")), ("caller",) * 4)
        self.assertEqual((owners["carom_plugin"], owners["carom_shape"]), ("engine", "engine"))
        roots = ("carom_engine", "carom_world", "carom_batch", "carom_device", "carom_plugin", "carom_shape")
        self.assertEqual({owners[name] for name in owners if name not in roots}, {"world"})

    def test_what_makes_and_ends_them_exists(self):
        for thing in API["handles"] + API["opaque"]:
            self.assertTrue(thing["made_by"])
            for name in thing["made_by"] + ([thing["ended_by"]] if thing["ended_by"] else []):
                self.assertIn(name, FUNCTIONS)


class Enumerations(unittest.TestCase):
    values = {c["name"]: c["value"] for c in API["constants"]}

    def test_choices_count_from_nothing_and_bits_are_bits(self):
        for group in API["enumerations"]:
            numbers = [self.values[name] for name in group["values"]]
            if group["kind"] == "choice":
                first = 1 if group["name"] in ("fault", "log") else 0
                self.assertEqual(numbers, list(range(first, first + len(numbers))), group["name"])
            elif group["kind"] == "bits":
                joined = [n for n in numbers if n & (n - 1)]  # several bits at once: LOCK_ALL
                single = 0
                for n in numbers:
                    single |= n if not n & (n - 1) else 0
                self.assertTrue(all(n & ~single == 0 for n in joined), group["name"])
            else:
                self.assertEqual(numbers, list(range(0, -len(numbers), -1)), group["name"])

    def test_every_constant_that_is_named_by_a_star_has_a_group(self):
        """Where a header says CAROM_MODE_*, a group has these names."""
        starts = {name for group in API["enumerations"] for name in group["values"]}
        for text in set(re.findall(r"CAROM_[A-Z_]+_\*", json.dumps(API))) - {"CAROM_VERSION_*"}:
            self.assertTrue(any(name.startswith(text[:-1]) for name in starts), text)


class Since(unittest.TestCase):
    def test_nothing_is_older_than_its_header(self):
        """A constant came with the oldest function of its header, or later."""
        version = lambda text: tuple(map(int, text.split(".")))  # noqa: E731
        oldest = {}
        for function in API["functions"]:
            header, since = function["header"], version(function["since"])
            oldest[header] = min(since, oldest.get(header, since))
        for kind in ("constants", "structs", "callbacks"):
            for thing in API[kind]:
                self.assertGreaterEqual(version(thing["since"]), oldest.get(thing["header"], (0, 9)), thing["name"])


class Nullable(unittest.TestCase):
    """All arguments are right but the one that is NULL: objects of a small world, memory with numbers that pass."""

    NUMBERS = {
        "orientation": (0, 0, 0, 1),
        "normal": (0, 1, 0),
        "direction": (1, 0, 0),
        "dirs": (1, 0, 0),
        "params": (0.5,),
    }
    WHOLE = {"scalar": raw.CAROM_SCALAR_F64, "substeps": 1, "fewest": 1, "most": 2, "mask": 1}

    def setUp(self):
        self.engine = carom.Engine()
        self.world = self.engine.world()
        mesh = self.engine.mesh([(0, 0, 0), (0, 0, 1), (1, 0, 0)], [(0, 1, 2)])
        ball = self.engine.sphere(0.5)
        body = self.world.body()
        six = self.world.joint("six_axis", body, position=(0, 0, 0))
        self.joints = {
            "axis": six,
            "limit": self.world.joint("hinge", body, position=(0, 0, 0), axis=(1, 0, 0)),
            "transmission": self.world.joint("gear", body, self.world.body(), position=(0, 0, 0), axis=(1, 0, 0)),
            "drive": six,
        }
        self.leader = self.world.joint("slider", body, position=(0, 0, 0), axis=(1, 0, 0))
        self.joints["coupling"] = self.world.couple(self.joints["limit"], self.leader)
        self.handles = {
            "carom_plugin": self.engine.plugin("carom.sphere"),
            "carom_shape": ball.handle,
            "carom_body": body.handle,
            "carom_collider": body.collider(ball).handle,
            "carom_material": self.world.material().handle,
            "carom_particles": self.world.particles().handle,
            "carom_joint": six.handle,
            "carom_force_field": self.world.force_field().handle,
            "carom_spring": self.world.spring(body, None, rest=1, stiffness=1).handle,
        }
        self.mesh = mesh.handle
        self.alone = self.world.body(mass=1, inertia=(1, 0, 0, 0, 1, 0, 0, 0, 1)).handle  # a tree of six coordinates
        self.one = (ctypes.c_double * 3)(1, 0, 0)
        self.world.keep_ledger()
        self.batch, first = ctypes.c_void_p(), ctypes.c_uint64()
        raw.carom_batch_create(self.engine._pointer, ctypes.byref(self.batch), None)
        raw.carom_batch_add_worlds(self.batch, self.world._pointer, 1, ctypes.byref(first), None)
        self.gravity = self.column()
        raw.carom_batch_add_column(self.batch, ctypes.byref(self.gravity), None, None)

    def tearDown(self):
        raw.carom_batch_destroy(self.batch, None)
        self.engine.close()

    def column(self):
        """Of one number that each world has, at `one`."""
        made = raw.carom_batch_column()
        raw.carom_batch_column_init(ctypes.byref(made), ctypes.sizeof(made))
        made.source, made.n, made.data = raw.CAROM_COLUMN_GRAVITY, 1, ctypes.addressof(self.one)
        return made

    def handle(self, kind, function):
        if kind == "carom_shape" and re.search("scenery|triangles", function):
            return self.mesh
        if kind == "carom_joint":
            found = [joint for word, joint in self.joints.items() if word in function]
            return found[0].handle if found else self.joints["limit"].handle
        return self.alone if function.startswith("carom_tree_") else self.handles[kind]

    def memory(self, argument, function):
        """Room for anything: a struct with its defaults and objects, numbers, text, or zeros."""
        base, name = re.sub(r"\bconst\b|\*", "", argument["type"]).strip(), argument["name"]
        block = ctypes.create_string_buffer(1 << 16)
        if base in STRUCTS:
            struct, made = STRUCTS[base], ctypes.cast(block, ctypes.POINTER(getattr(raw, base)))
            if struct["init"]:
                getattr(raw, struct["init"])(made, struct["size"])
            elif struct["fields"][0]["name"] == "struct_size":
                made.contents.struct_size = struct["size"]
            for field in struct["fields"]:
                if field["type"] in self.handles and field["name"] in ("shape", "body_a"):
                    setattr(made.contents, field["name"], self.handle(field["type"], function))
                if field["name"] == "scalar":
                    made.contents.scalar = raw.CAROM_SCALAR_F64
            if base == "carom_joint_coupling" and function == "carom_joint_couple":
                made.contents.follower, made.contents.leader = self.joints["limit"].handle, self.leader.handle
            if base == "carom_batch_column":
                made.contents.source, made.contents.n, made.contents.data = self.gravity.source, 1, self.gravity.data
            if base == "carom_pairs":
                one = ctypes.cast(block, ctypes.POINTER(raw.carom_pairs)).contents
                one.count, self.pair = 1, ((ctypes.c_uint64 * 1)(self.handles["carom_shape"]), (ctypes.c_double * 4)(1, 0, 0, 0))
                one.shapes_a = one.shapes_b = ctypes.cast(self.pair[0], ctypes.POINTER(ctypes.c_uint64))
                one.positions_a = one.positions_b = ctypes.cast(self.pair[1], ctypes.POINTER(ctypes.c_double))
                one.orientations_a = one.orientations_b = one.positions_a
            if base in ("carom_query_shapes", "carom_rays"):  # one question
                made.contents.count = 1
                for name in ("positions",) if base == "carom_query_shapes" else ("origins", "directions"):
                    setattr(made.contents, name, ctypes.addressof(self.one))
        elif base in self.handles:
            ctypes.cast(block, ctypes.POINTER(ctypes.c_uint64))[0] = self.handle(base, function)
        elif base == "double" or base == "void":
            numbers = next((v for k, v in self.NUMBERS.items() if name.startswith(k)), ())
            for i, number in enumerate(numbers):
                ctypes.cast(block, ctypes.POINTER(ctypes.c_double))[i] = number
        elif base == "uint64_t" and name == "handles":
            ctypes.cast(block, ctypes.POINTER(ctypes.c_uint64))[0] = self.handles["carom_body"]
        return block

    def number(self, argument, function):
        type, name = argument["type"], argument["name"]
        if type in self.handles:
            return self.handle(type, function)
        if name == "n" and function.startswith("carom_tree_"):
            return 6
        if name == "stride" and function.endswith("pairs_distance"):
            return ctypes.sizeof(raw.carom_distance)
        return self.WHOLE.get(
            name, 1 if name in ("n", "count", "steps", "shape_count", "dt", "frequency", "stiffness", "rest") else 0
        )

    def call(self, function, null):
        """@return (result, position of the argument at fault) with the argument at position `null`, 1-based, NULL"""
        kinds = {"double": ctypes.c_double, "int32_t": ctypes.c_int32, "uint32_t": ctypes.c_uint32}
        callback = lambda a: "_fn" in a["type"]  # noqa: E731
        prototype = ctypes.CFUNCTYPE(
            ctypes.c_int32,
            *[
                ctypes.c_void_p if "*" in a["type"] or callback(a) else kinds.get(a["type"], ctypes.c_uint64)
                for a in function["arguments"]
            ],
        )
        write = raw.carom_write_fn(lambda user, bytes, size: 0)
        values, alive = [], [write]
        for at, argument in enumerate(function["arguments"], 1):
            if callback(argument):
                values.append(ctypes.cast(write, ctypes.c_void_p))
            elif "*" not in argument["type"]:
                values.append(self.number(argument, function["name"]))
            elif at == null:
                values.append(None)
            elif argument["type"] == "carom_device *":
                values.append(None)  # not every machine has one
            elif argument["type"] == "carom_batch *":
                values.append(self.batch)
            elif argument["type"] in ("carom_engine *", "carom_world *"):
                values.append((self.engine if "engine" in argument["type"] else self.world)._pointer)
            else:
                error = argument["name"] == "error"
                alive.append(
                    raw.carom_error(struct_size=ctypes.sizeof(raw.carom_error))
                    if error
                    else self.memory(argument, function["name"])
                )
                values.append(ctypes.addressof(alive[-1]))
        result = prototype((function["name"], raw.lib))(*values)
        for argument, value in zip(function["arguments"], values):  # an engine or a world that it made goes again
            if argument["type"].endswith(" **") and result == raw.CAROM_OK and value:
                made = ctypes.cast(value, ctypes.POINTER(ctypes.c_void_p))[0]
                if re.search("carom_(engine|world|batch)", argument["type"]):
                    getattr(raw, argument["type"].split()[0] + "_destroy")(made, None)
        return result, next((a.argument for a in alive if isinstance(a, raw.carom_error)), 0)

    def test_what_the_library_refuses(self):
        asked = 0
        wrong = []
        for function in API["functions"]:
            if function["returns"] != "int32_t" or function["name"] in ENDS:
                continue
            for at, argument in enumerate(function["arguments"], 1):
                if "*" not in argument["type"] or argument["name"] == "error":
                    continue
                self.tearDown(), self.setUp()
                result, position = self.call(function, at)
                if result == raw.CAROM_E_NULL_ARGUMENT and position not in (at, 0):
                    continue  # another is looked at first: a callback, memory of NULL within a struct
                asked += 1
                if (result == raw.CAROM_E_NULL_ARGUMENT) == argument["nullable"]:
                    wrong.append(
                        f"{function['name']}, {argument['name']}: nullable is {argument['nullable']}, but {result}"
                    )
        self.assertFalse(wrong, "\n" + "\n".join(wrong))
        self.assertGreater(asked, 300)


if __name__ == "__main__":
    unittest.main()
