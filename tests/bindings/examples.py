#!/usr/bin/env python3
"""The examples of a language: all features of the page of examples, 60 lines at most each. Each prints what the page says, and fails in
a world that does not step.

usage: examples.py LANGUAGE BUILD [STILL]     STILL: a library whose carom_world_step() does nothing, for programs that link ours
Exits 77, with the reason, where the language is not installed.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "src/site/docs/topics/examples.md"
FOLDERS = {"c": ("c/examples", "c"), "cpp": ("cpp/examples", "cpp"), "python": ("python/examples", "py"),
           "js": ("js/examples", "js"), "rust": ("rust/carom/examples", "rs")}
LONGEST = 60  # lines


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


class Examples:
    def __init__(self, language, build, still):
        self.language, self.build, self.still = language, build, still
        place, suffix = FOLDERS[language]
        self.folder = ROOT / "bindings" / place
        self.files = {file.stem: file for file in sorted(self.folder.glob(f"*.{suffix}"))}
        library = build / "lib" / "libcarom.so.0.9"
        self.environment = dict(
            os.environ, LD_LIBRARY_PATH=str(library.parent), CAROM_PLUGIN_PATH=str(build / "plugins"), CAROM_LIBRARY=str(library),
            PYTHONPATH=str(ROOT / "bindings/python"), PYTHONDONTWRITEBYTECODE="1", CAROM_LIBRARY_DIR=str(library.parent),
            CARGO_TARGET_DIR=str(build / "tests/bindings/examples"))
        if language == "js":
            if not shutil.which("node"):
                skip("node is not on the PATH")
            if not (ROOT / "bindings/js/dist/carom.wasm").exists():
                skip("preset wasm was not built in this checkout: bindings/js/dist/carom.wasm is missing")
        if language == "rust":
            if not shutil.which("cargo"):
                skip("cargo is not on the PATH")
            self.run(["cargo", "build", "--examples", "--locked", "--offline", "--quiet"], cwd=ROOT / "bindings/rust")

    def run(self, command, good=True, still=False, cwd=None):
        preload = {"LD_PRELOAD": str(self.still)} if still and self.still else {}
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, cwd=cwd, env={**self.environment, **preload})
        if good and (done.returncode or done.stderr):
            sys.exit(f"{' '.join(map(str, command))}: {done.returncode}\n{done.stdout}{done.stderr}")
        return done

    def command(self, name, still):
        """@param still  in a world that does not step, where the language can say so"""
        if self.language == "python":
            stop = "carom.raw.carom_world_step = lambda *_: 0; " if still else ""
            return [sys.executable, "-X", "dev", "-c", f"import carom, runpy; {stop}runpy.run_path({str(self.files[name])!r}, run_name='__main__')"]
        if self.language == "js":
            world = (ROOT / "bindings/js/src/world.js").as_uri()
            stop = ["--import", f"data:text/javascript,import {{ World }} from '{world}'; World.prototype.step = () => {{}};"]
            return ["node", *(stop if still else []), self.files[name]]
        if self.language == "rust":
            return [Path(self.environment["CARGO_TARGET_DIR"]) / "debug/examples" / name]
        return [self.build / "bin" / f"example_{self.language}_{name}"]

    def test(self):
        said = dict(re.findall(r"^@example (\w+)\n\n    (.*)$", PAGE.read_text(encoding="utf-8"), re.M))
        if len(said) < 15:
            sys.exit(f"{PAGE} names {len(said)} examples")
        missing, strange = set(said) - set(self.files), set(self.files) - set(said)
        if strange or missing:
            sys.exit(f"{self.folder}: the page of examples has {sorted(missing)} beside it, and not {sorted(strange)}")
        for name, file in self.files.items():
            lines = len(file.read_text(encoding="utf-8").splitlines())
            if lines > LONGEST:
                sys.exit(f"{file} has {lines} lines: {LONGEST} are enough for an example")
            printed = self.run(self.command(name, False)).stdout
            if printed != said[name] + "\n":
                sys.exit(f"{file} prints\n{printed}the page of examples says\n{said[name]}")
            if self.still or self.language in ("python", "js"):
                done = self.run(self.command(name, True), good=False, still=True)
                if done.returncode == 0:
                    sys.exit(f"{file} does not notice that its world does not step:\n{done.stdout}")
        print(f"{self.language}: {len(self.files)} of {len(said)} examples")


Examples(sys.argv[1], Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve() if sys.argv[3:] else None).test()
