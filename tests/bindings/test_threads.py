"""bindings/api.json says of every function which threads may call it, and the library locks as it says.

A reader of a world enters its gate through Reading, a writer through Changing or Recorded (src/abi/world.h); what says
neither enters none. The entry point of a call, or a function of src/abi that it calls, names the gate.

    python3 tests/bindings/test_threads.py
"""
import json
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
API = json.loads((ROOT / "bindings" / "api.json").read_text(encoding="utf-8"))
GATES = {"Reading": "reader", "Changing": "writer", "Recorded": "writer", "enter_alone": "writer", "ChangingBatch": "writer"}


def block(text, start):
    """From a brace to the one that closes it."""
    depth = 0
    for at in range(start, len(text)):
        depth += (text[at] == "{") - (text[at] == "}")
        if depth == 0:
            return text[start : at + 1]
    raise ValueError(f"no end of a block: {text[start : start + 60]}")


def functions_of(folder):
    """{file: {name: [bodies]}} of every function that is defined at the beginning of a line, or two blanks in."""
    found = {}
    for file in sorted(folder.glob("*.cpp")) + sorted(folder.glob("*.h")):
        text = re.sub(r"//[^\n]*", "", file.read_text(encoding="utf-8"))
        bodies = found.setdefault(file.name, {})
        for head in re.finditer(r"^(?:  )?(?!return|else|namespace)[a-zA-Z_][\w:<>,*& ]*?[ *&](?:\w+::)?(\w+)\(", text, flags=re.M):
            depth, at = 1, head.end()
            while depth:
                depth += (text[at] == "(") - (text[at] == ")")
                at += 1
            after = re.match(r"(?: const| noexcept)*\s*(\{)", text[at:])
            if after:
                bodies.setdefault(head.group(1), []).append(block(text, at + after.start(1)))
    return found


KIT = functions_of(ROOT / "src" / "kit")
SOURCES = functions_of(ROOT / "src" / "abi") | KIT
ENTRIES = {name: file for file, bodies in SOURCES.items() for name in bodies if name.startswith("carom_")}


def gates_of(name, file, asked):
    """Which gates a function of this file names, itself or in functions that it calls."""
    if name in asked:
        return set()
    asked.add(name)
    gates = set()
    where = KIT if file in KIT else {file: SOURCES[file]}
    for body in [body for bodies in where.values() for body in bodies.get(name, ())]:
        gates |= {GATES[word] for word in re.findall(r"\w+", body) if word in GATES}
        if not gates:
            for called in re.findall(r"(\w+)(?:<[^<>()]*>)?\(", body):
                gates |= gates_of(called, ENTRIES.get(called, file), asked)
    return gates


class Threads(unittest.TestCase):
    def test_every_function_says_it(self):
        for function in API["functions"]:
            self.assertIn(function.get("thread"), ("any", "engine", "reader", "writer"), function["name"])

    def test_every_header_with_functions_says_it(self):
        for name in {function["header"] for function in API["functions"]}:
            header = next(h for h in API["headers"] if h["name"] == name)
            self.assertIn(header["thread"], ("any", "engine", "world", "batch"), name)

    def test_it_follows_from_what_a_call_takes(self):
        for function in API["functions"]:
            takes = {a["type"] for a in function["arguments"]}
            want = ("writer",) if "carom_batch *" in takes else ("reader", "writer") if "carom_world *" in takes else ("engine", "writer") if "carom_engine *" in takes else ("any",)
            self.assertIn(function["thread"], want, function["name"])

    def test_a_call_may_be_busy_where_it_enters_the_gate_of_a_world(self):
        for function in API["functions"]:
            gated = any(a["type"].removeprefix("const ") in ("carom_world *", "carom_batch *", "carom_device *") for a in function["arguments"])
            self.assertEqual("BUSY" in function["status"], gated, function["name"])

    def test_the_library_locks_as_it_says(self):
        checked = 0
        for function in API["functions"]:
            name = function["name"]
            if not any(a["type"] in ("carom_world *", "carom_batch *") for a in function["arguments"]):
                continue
            self.assertIn(name, ENTRIES)
            gates = gates_of(name, ENTRIES[name], set())
            # A call of the kit is made of other calls, and reads before it writes; one of a batch may read a world.
            if (ENTRIES[name] in KIT or name.startswith("carom_batch")) and "writer" in gates:
                gates = {"writer"}
            self.assertEqual(gates, {function["thread"]}, name)
            checked += 1
        self.assertGreater(checked, 140)


if __name__ == "__main__":
    unittest.main()
