"""The raw layer has all of api.json with types, and does not load beside a library of another layout."""
import ctypes
import json
import unittest
from pathlib import Path

from carom import _c, errors, raw

API = json.loads((Path(__file__).resolve().parents[2] / "bindings" / "api.json").read_text(encoding="utf-8"))
MANIFEST = raw.carom_abi_manifest().decode()


class Complete(unittest.TestCase):
    def test_every_function_has_types(self):
        self.assertGreater(len(API["functions"]), 150)
        scalars = {"int32_t": ctypes.c_int32, "uint32_t": ctypes.c_uint32, "uint64_t": ctypes.c_uint64, "double": ctypes.c_double,
                   "const char *": ctypes.c_char_p, "void": None, **{h["name"]: ctypes.c_uint64 for h in API["handles"]}}
        for f in API["functions"]:
            function = getattr(raw, f["name"])
            self.assertEqual(len(function.argtypes), len(f["arguments"]), f["name"])
            self.assertIs(function.restype, scalars[f["returns"]], f["name"])
            for argument, type in zip(f["arguments"], function.argtypes):
                where = f"{f['name']}({argument['name']})"
                if argument["type"] in scalars:
                    self.assertIs(type, scalars[argument["type"]], where)
                elif argument["type"].endswith("*"):
                    self.assertTrue(issubclass(type, (ctypes.c_void_p, ctypes._Pointer)), where)
                    name = argument["type"].replace("const ", "").split(" ")[0]
                    if name in raw.STRUCTS and argument["type"].count("*") == 1:
                        self.assertIs(type._type_, raw.STRUCTS[name], where)

    def test_every_constant_and_struct(self):
        for c in API["constants"]:
            self.assertEqual(getattr(raw, c["name"]), c["value"])
        self.assertEqual(set(raw.STRUCTS), {s["name"] for s in API["structs"]})
        for s in API["structs"]:
            self.assertEqual([n for n, _ in raw.STRUCTS[s["name"]]._fields_], [f["name"] for f in s["fields"]])

    def test_every_function_can_be_called(self):
        """With nothing: each that can fail says NULL_ARGUMENT or the like, none crashes."""
        called = 0
        for f in API["functions"]:
            if f["returns"] != "int32_t":
                continue
            function = getattr(raw, f["name"])
            empty = [t() if issubclass(t, ctypes._CFuncPtr) else None if issubclass(t, (ctypes.c_void_p, ctypes._Pointer, ctypes.c_char_p)) else 0 for t in function.argtypes]
            self.assertLess(function(*empty), 0, f["name"])
            called += 1
        self.assertGreater(called, 150)

    def test_every_code_has_an_exception(self):
        codes = {c["value"]: c["name"] for c in API["constants"] if c["name"].startswith("CAROM_E_")}
        self.assertEqual(set(errors.BY_CODE), set(codes))
        stubs = Path(errors.__file__).with_suffix(".pyi").read_text()
        for code, kind in errors.BY_CODE.items():
            self.assertTrue(issubclass(kind, errors.CaromError))
            self.assertIn(f"class {kind.__name__}(", stubs)  # a new code wants a line there
            self.assertEqual(kind.__name__.lower(), codes[code][len("CAROM_E_"):].replace("_", "").lower())


class Layout(unittest.TestCase):
    def refused(self, manifest, why):
        with self.assertRaisesRegex(ImportError, why):
            raw.check_layout(manifest)

    def test_own_library(self):
        raw.check_layout(MANIFEST)

    def test_names_struct_and_field(self):
        line = next(l for l in MANIFEST.splitlines() if l.startswith("carom_contact.separation "))
        self.refused(MANIFEST.replace(line, line.replace("8 f64", "4 f32")), "field separation of carom_contact is f32 of 4 bytes")
        self.refused(MANIFEST.replace(line + "\n", ""), "field separation of carom_contact is not there")
        name, offset, rest = line.split(" ", 2)
        self.refused(MANIFEST.replace(line, f"{name} {int(offset) + 8} {rest}"), "disagree: field separation of carom_contact")

    def test_newer_library(self):
        """More lines and longer structs are welcome; shorter ones are not."""
        line = next(l for l in MANIFEST.splitlines() if l.startswith("carom_step_report 0 "))
        size = int(line.split()[2])
        raw.check_layout(MANIFEST.replace(line, line.replace(str(size), str(size + 8))) + "carom_new 0 8 struct\n")
        self.refused(MANIFEST.replace(line, line.replace(str(size), str(size - 8))), "carom_step_report")

    def test_every_row_of_the_manifest_is_compared(self):
        here = raw.layout()
        self.assertEqual(len(here), len(MANIFEST.splitlines()) - 1)
        for name, (offset, size, kind) in here.items():
            with self.assertRaises(ImportError, msg=name):
                raw.check_layout(MANIFEST, {name: (offset, size, kind + "?")})

    def test_version(self):
        self.assertEqual(_c.VERSION, API["version"])


if __name__ == "__main__":
    unittest.main()
