#!/usr/bin/env python3
"""The extension for Godot 4: compiled against Godot's interface header of each version that is here, and run in a stand-in for Godot
(bindings/godot/test/host.c), which is no Godot: it has the functions of the interface that the extension calls, as the header declares them.

usage: godot.py BUILD
The header is that of $GODOT_INTERFACE, a folder, or those of the crate gdextension-api 0.3, where cargo has fetched it. Exits 77, with the
reason, where there is none.
"""
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCE = ROOT / "bindings" / "godot"
HEADER = "gdextension_interface.h"
CRATES = Path(os.environ.get("CARGO_HOME", Path.home() / ".cargo")) / "registry" / "src"


def run(*command, **environment):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env={**os.environ, **environment})
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    build = Path(sys.argv[1]).resolve()
    given = os.environ.get("GODOT_INTERFACE")
    headers = [Path(given) / HEADER] if given else sorted(CRATES.glob(f"*/gdextension-api-0.3.*/versions/*/res/{HEADER}"))
    if not headers or not headers[0].exists():
        print(f"skipped: {HEADER} is in none of $GODOT_INTERFACE and cargo's registry (crate gdextension-api 0.3): bindings/godot/README.md")
        return 77
    place = build / "tests" / "bindings" / "godot"
    place.mkdir(parents=True, exist_ok=True)
    extension, host = place / "libcarom_godot.so", place / "host"
    warnings = ["-Wall", "-Wextra", "-Werror", "-Wno-cast-function-type"]  # a function of Godot's has no prototype until it is found
    carom = [f"-I{ROOT / 'include'}", f"-L{build / 'lib'}", "-lcarom", "-lm"]
    for header in headers:
        with_godot = ["-isystem", header.parent]
        run("cc", "-std=c11", "-O2", *warnings, "-fPIC", "-shared", "-fvisibility=hidden", SOURCE / "carom_godot.c", *with_godot, *carom, "-o", extension)
        run("cc", "-std=gnu11", "-O1", *warnings, SOURCE / "test" / "host.c", *with_godot, *carom, "-ldl", "-o", host)
        symbols = set(re.findall(r" T (\w+)", run("nm", "-D", "--defined-only", extension)))
        if symbols != {"carom_godot_init"}:
            sys.exit(f"the extension exports {sorted(symbols)}")
        said = run(host, extension, LD_LIBRARY_PATH=str(build / "lib"), CAROM_PLUGIN_PATH=str(build / "plugins"))
        if not re.fullmatch(r"after 3 s the ball lies at y = 0\.(49[5-9]|50[0-5]) m\n[1-9]\d* methods\n", said):
            sys.exit(f"the stand-in said {said}")
        print(f"{header.parts[-3]}: {said.splitlines()[1]}, with C's bits")
    return 0


sys.exit(main())
