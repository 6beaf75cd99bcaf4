"""bindings/gen reads the plain C of the boundary, and refuses the rest with file and line."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bindings" / "gen"))
from c_reader import HeaderError  # noqa: E402
from headers import read_api  # noqa: E402

BASE = """/** @file base.h\n *  First.\n *  @thread any. */
#define CAROM_VERSION_MAJOR 1u
#define CAROM_VERSION_MINOR 2u
#define CAROM_VERSION_PATCH 3u
#define CAROM_OK 0
#define CAROM_E_BUSY (-12) /* at
                              work */
#define CAROM_FILTER_MASK (~(uint64_t)0)
typedef uint64_t carom_body; /* it   @since 1.4 */
"""


def api_of(more, thread="any"):
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "base.h").write_text(BASE.replace("@thread any", f"@thread {thread}" if thread else "") + more)
        return read_api(folder)


class Reads(unittest.TestCase):
    def test_constants(self):
        constants = {c["name"]: c for c in api_of("")["constants"]}
        self.assertEqual(constants["CAROM_E_BUSY"]["value"], -12)
        self.assertEqual(constants["CAROM_E_BUSY"]["doc"], "at work")
        self.assertEqual(constants["CAROM_FILTER_MASK"]["value"], 2**64 - 1)

    def test_handle_since(self):
        handle = api_of("")["handles"][0]
        self.assertEqual((handle["since"], handle["doc"]), ("1.4", "it"))

    def test_struct_is_laid_out_with_padding(self):
        struct = api_of("typedef struct carom_a {\n  uint32_t n; /**< first */\n  double x[3], y;\n  carom_body b;\n"
                        "  const char *const *names;\n  void (*log)(void *user, uint32_t level);\n  uint32_t tail;\n} carom_a;\n")["structs"][0]
        at = {f["name"]: (f["offset"], f["size"], f["kind"]) for f in struct["fields"]}
        self.assertEqual(at, {"n": (0, 4, "u32"), "x": (8, 24, "f64[3]"), "y": (32, 8, "f64"), "b": (40, 8, "u64"),
                              "names": (48, 8, "ptr"), "log": (56, 8, "fn"), "tail": (64, 4, "u32")})
        self.assertEqual(struct["size"], 72)
        self.assertEqual(struct["fields"][0]["doc"], "first")

    def test_function_with_arrays_and_callbacks(self):
        api = api_of("typedef int32_t (*carom_fn)(const double *p, double out[3]);\n"
                     "/** Do it.\n *  @status OK; *_HANDLE;\n *          BUSY (now)   @since 1.2 */\n"
                     "CAROM_API int32_t carom_do(const double at[3], carom_fn f);\n"
                     "CAROM_API int32_t carom_do_too(void);\n")
        do, too = api["functions"]
        self.assertEqual([(a["type"], a.get("count")) for a in do["arguments"]], [("const double *", 3), ("carom_fn", None)])
        self.assertEqual(do["status"], ["OK", "INVALID_HANDLE", "STALE_HANDLE", "WRONG_KIND", "WRONG_WORLD", "BUSY"])
        self.assertEqual(too["since"], "1.2")  # without a blank line the comment holds for both
        self.assertEqual(api["callbacks"][0]["arguments"][1], {"name": "out", "type": "double *", "count": 3, "direction": "out",
                                                               "nullable": False, "length": "3"})

    def test_status_of_another(self):
        api = api_of("/** @status OK; BUSY */\nCAROM_API int32_t carom_a(void);\n\n"
                     "/** Arguments as carom_a(). */\nCAROM_API int32_t carom_b(void);\n")
        self.assertEqual(api["functions"][1]["status"], ["OK", "BUSY"])


    def test_threads(self):
        declared = ("typedef struct carom_engine carom_engine;\ntypedef struct carom_world carom_world;\n"
                    "/** @status OK */\nCAROM_API int32_t carom_a(uint32_t n);\n\n"
                    "/** @thread reader, and slow\n *  @status OK */\nCAROM_API int32_t carom_b(carom_world *world);\n\n"
                    "/** @status OK */\nCAROM_API int32_t %s(%s);\n")
        for rule, name, takes, want in (("world", "carom_get_it", "carom_world *world", "reader"),
                                        ("world", "carom_getter", "carom_world *world", "writer"),
                                        ("engine", "carom_get_it", "carom_engine *engine", "engine")):
            functions = api_of(declared % (name, takes), rule)["functions"]
            self.assertEqual([f["thread"] for f in functions], ["any", "reader", want])


class Refuses(unittest.TestCase):
    def refused(self, more, why):
        with self.assertRaisesRegex(HeaderError, why):
            api_of(more)

    def test_types_of_no_fixed_size(self):
        for type in ("long", "bool", "float", "unsigned", "enum"):
            self.refused(f"/** @status OK */\nCAROM_API int32_t carom_f({type} x);\n", r"base\.h:13.*no place at this boundary")

    def test_functions_without_thread(self):
        takes_a_world = ("typedef struct carom_world carom_world;\n/** @status OK%s */\n"
                         "CAROM_API int32_t carom_f(carom_world *world);\n")
        self.refused(takes_a_world % "", "carom_f: say its @thread")
        self.refused(takes_a_world % "   @thread tired", "carom_f: @thread tired is none of")
        with self.assertRaisesRegex(HeaderError, "@thread none of a header"):
            api_of("", "none")
        with self.assertRaisesRegex(HeaderError, "its opening comment has no @thread"):
            api_of("/** @status OK */\nCAROM_API int32_t carom_f(void);\n", None)

    def test_functions_without_status(self):
        self.refused("/** Nothing. */\nCAROM_API int32_t carom_f(void);\n", "has no @status")

    def test_unknown_status(self):
        self.refused("/** @status OK; TIRED */\nCAROM_API int32_t carom_f(void);\n", "names no code: 'TIRED'")

    def test_circle_of_statuses(self):
        self.refused("/** @status as carom_b() */\nCAROM_API int32_t carom_a(void);\n\n"
                     "/** @status as carom_a() */\nCAROM_API int32_t carom_b(void);\n", "leads back")

    def test_constants_of_no_enumeration(self):
        self.refused("#define CAROM_HUMOUR_GOOD 0u\n", "CAROM_HUMOUR_GOOD: which enumeration is it of")
        self.refused("#define CAROM_MODE_FORBID 1u\n#define CAROM_MODE_FORCE 1u\n", "two values of mode are the same")
        self.refused("#define CAROM_MODE_FORBID 0u\n#define CAROM_MODE_COUNT 2u\n", "is 2, but there are 1")

    def test_structs_in_structs_and_matrices(self):
        self.refused("typedef struct carom_a {\n  carom_b b;\n} carom_a;\n", "'carom_b' is not known")
        self.refused("typedef struct carom_a {\n  double m[3][3];\n} carom_a;\n", "arrays of arrays")

    def test_what_is_not_c_of_ours(self):
        self.refused("int x;\n", "no place|not a function")
        self.refused("#define CAROM_TWICE(x) 2\n", "unknown form")
        self.refused("#pragma once\n", "unknown directive")
        self.refused("CAROM_API int32_t carom_f(void)\n", "without its end")


if __name__ == "__main__":
    unittest.main()
