"""bindings/api.json against a C compiler and the library's symbols: each function, callback, field, handle and constant is
declared once more as api.json has it, which compiles only if the headers say the same; and a function's @since is the
version node of its symbol. usage: check_signatures.py ROOT C_COMPILER LIBRARY"""
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT, COMPILER, LIBRARY = Path(sys.argv[1]), sys.argv[2], sys.argv[3]


def declared(name, returns, arguments):
    return f"{returns} {name}({', '.join(a['type'] for a in arguments) or 'void'})"


def pointer_to(type):
    return type.replace("(*)", "(**)") if "(*)" in type else type + " *"


def program(api):
    """A C file that says all of api.json again."""
    lines = ["#include <carom/carom.h>"]
    for f in api["functions"]:
        lines.append(declared(f["name"], f["returns"], f["arguments"]) + ";")
    for c in api["callbacks"]:
        lines.append(f"extern {c['name']} one_{c['name']};")
        lines.append(f"extern {declared('(*one_' + c['name'] + ')', c['returns'], c['arguments'])};")
    for h in api["handles"]:
        lines.append(f"extern {h['name']} one_{h['name']}; extern uint64_t one_{h['name']};")
    for c in api["constants"]:
        if c["type"] == "string":
            lines.append(f"_Static_assert(sizeof {c['name']} == sizeof {json.dumps(c['value'])}, \"{c['name']}\");")
            continue
        type, suffix = {"i32": ("int", ""), "u32": ("unsigned", "u"), "u64": ("uint64_t", "u")}[c["type"]]
        lines.append(f"_Static_assert({c['name']} == {c['value']}{suffix} && _Generic({c['name']}, {type}: 1, default: 0), "
                     f"\"{c['name']}\");")
    for s in api["structs"]:
        for f in s["fields"]:
            type = f"{f['type']} (*)[{f['count']}]" if "count" in f else pointer_to(f["type"])
            lines.append(f"_Static_assert(_Generic(&(({s['name']} *)0)->{f['name']}, {type}: 1, default: 0), "
                         f"\"{s['name']}.{f['name']}\");")
    return "\n".join(lines) + "\n"


def compiles(text):
    done = subprocess.run([COMPILER, "-std=c11", "-fsyntax-only", "-I", ROOT / "include", "-x", "c", "-"],
                          input=text, capture_output=True, text=True)
    return done.returncode == 0, done.stderr


def main():
    text = (ROOT / "bindings/api.json").read_text()
    api = json.loads(text)
    good, said = compiles(program(api))
    if not good:
        sys.exit("api.json and the headers differ:\n" + said)
    # Would it notice? An argument, a constant, a field, a callback, a handle, each wrong in one way.
    wrongs = {
        "argument": lambda a: next(f for f in a["functions"] if f["name"] == "carom_world_step")["arguments"][1].update(type="float"),
        "const": lambda a: next(f for f in a["functions"] if f["name"] == "carom_world_read")["arguments"][3].update(type="carom_body *"),
        "returns": lambda a: next(f for f in a["functions"] if f["name"] == "carom_stage_name").update(returns="char *"),
        "constant": lambda a: next(c for c in a["constants"] if c["name"] == "CAROM_DIAL_SLEEP").update(value=7),
        "field": lambda a: next(s for s in a["structs"] if s["name"] == "carom_contact")["fields"][6].update(type="float"),
        "callback": lambda a: a["callbacks"][0]["arguments"].pop(),
    }
    for name, spoil in wrongs.items():
        spoiled = json.loads(text)
        spoil(spoiled)
        if compiles(program(spoiled))[0]:
            sys.exit(f"this check does not notice a wrong {name}")
    names = subprocess.run(["nm", "-D", "--defined-only", "--with-symbol-versions", LIBRARY], capture_output=True, text=True, check=True)
    nodes = dict(re.findall(r" T (carom_\w+)@@CAROM_([0-9.]+)", names.stdout))
    problems = [f"{f['name']}: @since {f['since']}, but symbol of CAROM_{nodes.get(f['name'])}"
                for f in api["functions"] if nodes.get(f["name"]) != f["since"]]
    problems += [f"{name}: exported, but not in api.json" for name in nodes.keys() - {f["name"] for f in api["functions"]}]
    if problems:
        sys.exit("\n".join(problems))
    print(f"{len(api['functions'])} functions, {len(api['structs'])} structs, {len(api['constants'])} constants")


main()
