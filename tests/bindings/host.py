#!/usr/bin/env python3
"""A host in another language, against an installed library: in a project of its own it builds and runs what its README shows, then the
scene of scene.c, then its own tests. It must get C's bits, and refuse a library that is
missing, older or of another layout by an error that names the file and what to do.

usage: host.py LANGUAGE BUILD [--calls]       --calls: print what a call costs beside C, and test nothing
Exits 77, with the reason, where the language is not installed, or too old.
"""
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HERE = ROOT / "tests" / "bindings"
VERSION = re.findall(r"#define CAROM_VERSION_\w+ (\d+)u", (ROOT / "include/carom/base.h").read_text())


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


def version_of(command, pattern, least, name):
    """Skip where a tool is not there, or older than `least`, a tuple of numbers."""
    if not shutil.which(command[0]):
        skip(f"{name} is not installed: {command[0]} is not on the PATH")
    done = subprocess.run(command, capture_output=True, text=True)
    found = re.search(pattern, done.stdout + done.stderr)
    if not found or tuple(map(int, found.groups())) < least:
        skip(f"{name} is too old: {'.'.join(map(str, least))} is needed, {command[0]} says {(done.stdout + done.stderr).strip()}")


class Host:
    """What all languages have in common; `build` makes programs, `command` says how to run one."""

    said_when_missing = r"libcarom\.so\.0\.9"  # the loader's words
    checks_layout = True
    takes_path = False  # in $CAROM_LIBRARY; else the system's loader speaks, before the program does

    def __init__(self, language, build):
        self.build_dir = build
        self.place = build / "tests" / "bindings" / "hosts" / language
        self.prefix = self.place / "prefix"
        self.environment = dict(os.environ, CAROM_SCENE=str(build / "bin" / "bindings_scene"))
        for name in ("CAROM_PLUGIN_PATH", "CAROM_LIBRARY", "CAROM_LIBRARY_DIR"):
            self.environment.pop(name, None)

    def needs(self):
        """Skip where the language is not there."""

    def run(self, command, good=True, folder=None, **more):
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, cwd=folder or self.place,
                              env={**self.environment, **more})
        if good and done.returncode:
            sys.exit(f"{' '.join(map(str, command))}: {done.returncode}\n{done.stdout}{done.stderr}")
        return done

    def install(self):
        """As README's cmake --install, but for the command and the tests; and the template, which is to be copied, as a plugin of one's own."""
        shutil.rmtree(self.place, ignore_errors=True)
        self.place.mkdir(parents=True)
        for part in ("src", "plugins"):
            self.run(["cmake", "--install", self.build_dir / part, "--prefix", self.prefix])
        config = next(self.prefix.glob("lib*/**/carom.pc"))
        self.library = next(config.parents[1].glob("libcarom.so.0.9"))
        self.environment.update(PKG_CONFIG_PATH=str(config.parent), LD_LIBRARY_PATH=str(self.library.parent),
                                CAROM_PLUGIN_PATH=str(self.build_dir / "plugins"))

    def program(self, name):
        """A program of the README: its first block of the language; else the file of that name here."""
        if name != "hello":
            return (HERE / f"{name}.{self.suffix}").read_text()
        block = re.search(rf"^```{self.block}\n(.*?)^```", (ROOT / "bindings" / self.folder / "README.md").read_text(), re.S | re.M)
        return block[1]

    def doctored(self, name, *changes):
        """A folder with a library that says something else of itself."""
        image = self.library.read_bytes()
        for old, new in changes:
            if len(old) != len(new) or image.count(old) != 1:
                sys.exit(f"the library has {image.count(old)} times {old}")
            image = image.replace(old, new)
        folder = self.place / name
        folder.mkdir()
        (folder / "libcarom.so.0.9").write_bytes(image)
        return folder

    def altered(self):
        """Libraries that the loader refuses: (what, file)."""
        image = self.library.read_bytes()
        newest = max(re.findall(rb"GLIBC_2\.(\d\d)\0", image), default=None)
        for what, changed in (("other processor", image[:18] + b"\xf3\x00" + image[20:]),  # RISC-V
                              ("newer C library", image.replace(b"GLIBC_2." + newest, b"GLIBC_9." + newest) if newest else None)):
            if changed:
                folder = self.place / what.replace(" ", "_")
                folder.mkdir()
                (folder / "libcarom.so.0.9").write_bytes(changed)
                yield what, folder / "libcarom.so.0.9"

    def test(self):
        self.install()
        self.build(["hello", "scene"])
        hello = self.run(self.command("hello")).stdout
        if not re.fullmatch(r"after 3 s the ball lies at y = 0\.(49[5-9]|50[0-5]) m\n", hello):
            sys.exit(f"the README's program printed {hello}")
        of_c = self.run([self.environment["CAROM_SCENE"], self.build_dir / "plugins"]).stdout.split()
        of_host = self.run(self.command("scene")).stdout.split()
        if len(set(of_c)) != 3 or of_host != of_c * 2:
            sys.exit(f"C got {of_c}, the host {of_host}: the scene, then once more with a shape that the host wrote")
        here, older = ".".join(VERSION), "0.0.1"
        said = f"carom {here}\n".encode(), f"carom {older}\n".encode()
        self.refuses("older", self.doctored("older", said), rf"libcarom\.so\.0\.9 is of version {older}.*{here}.*(install|Install)")
        if self.checks_layout:
            image = self.library.read_bytes()
            row = next(iter(image[image.index(b"carom_contact.separation "):].splitlines()))
            change = row, row.replace(b" 8 f64", b" 4 f32")
            self.refuses("other layout", self.doctored("layout", change), r"libcarom\.so\.0\.9.*carom_contact\.separation.*(install|Install)")
        empty = self.place / "empty"
        empty.mkdir()
        self.refuses("missing", empty, self.said_when_missing)
        for what, file in self.altered():
            done = self.run(self.command("hello"), good=False, LD_LIBRARY_PATH=str(file.parent), **({"CAROM_LIBRARY": str(file)} if self.takes_path else {}))
            pattern = rf"cannot load {file}.*Remedy: install" if self.takes_path else r"libcarom\.so\.0\.9"
            if done.returncode == 0 or not re.search(pattern, done.stderr, re.S):
                sys.exit(f"a library for a {what}: exit {done.returncode}, and no {pattern} in\n{done.stderr}")
        self.refuses_plugin()
        self.own_tests()
        print(f"{self.folder}: hello, scene, {'own tests, ' if self.has_own_tests else ''}libraries that do not fit")

    has_own_tests = True

    def refuses_plugin(self):
        """A plugin of another processor: by file and cure, in the words of the language's own errors."""
        folder = self.place / "other_plugin"
        folder.mkdir()
        image = (self.build_dir / "plugins" / "sphere.so").read_bytes()
        (folder / "sphere.so").write_bytes(image[:18] + b"\xf3\x00" + image[20:])  # RISC-V
        done = self.run(self.command("hello"), good=False, CAROM_PLUGIN_PATH=str(folder))
        if done.returncode == 0 or not re.search(r"other_plugin/sphere\.so.*is for .*RISC-V.*build the plugin again", done.stderr, re.S):
            sys.exit(f"a plugin for another processor: exit {done.returncode}\n{done.stdout}{done.stderr}")

    def refuses(self, what, folder, pattern):
        done = self.run(self.command("hello"), good=False, LD_LIBRARY_PATH=str(folder))
        if done.returncode == 0 or not re.search(pattern, done.stderr, re.S):
            sys.exit(f"{what} library: exit {done.returncode}, and no {pattern} in\n{done.stderr}")

    def calls(self):
        self.install()
        self.build(["calls"])
        of_c = self.place / "calls_c"
        flags = self.run(["pkg-config", "--cflags", "--libs", "carom"]).stdout.split()
        self.run(["cc", "-O2", HERE / "calls.c", *flags, "-o", of_c])
        print(f"{'':8}{'one position':>16}{'10,000 positions':>20}")
        rounds = [[self.run(command).stdout.split() for command in ([of_c], self.command("calls"))] for _ in range(5)]  # in turn
        for name, *found in zip(("C", self.folder), *rounds):
            one, many = (min(float(row[i]) for row in found) for i in (0, 1))
            print(f"{name:8}{one:13.0f} ns{many / 1000:17.0f} us")


class Cpp(Host):
    folder, block, suffix = "cpp", "cpp", "cpp"
    checks_layout = False  # its structs are the headers'
    has_own_tests = False  # bindings/cpp

    def build(self, names):
        flags = self.run(["pkg-config", "--cflags", "--libs", "carom"]).stdout.split()
        for name in names:
            if name == "scene":
                continue
            (self.place / f"{name}.cpp").write_text(self.program(name))
            self.run(["c++", "-std=c++20", "-O2", f"{name}.cpp", *flags, "-o", name])

    def command(self, name):
        return [self.build_dir / "bin" / "bindings_cpp", "scene"] if name == "scene" else [self.place / name]

    def own_tests(self):
        pass


class Rust(Host):
    folder, block, suffix = "rust", "rust", "rs"

    def needs(self):
        version_of(["cargo", "--version"], r"(\d+)\.(\d+)", (1, 77), "Rust")

    def build(self, names):
        (self.place / "src" / "bin").mkdir(parents=True)
        for name in names:
            (self.place / "src" / "bin" / f"{name}.rs").write_text(self.program(name))
        (self.place / "Cargo.toml").write_text(
            '[package]\nname = "host"\nversion = "0.0.0"\nedition = "2021"\n[workspace]\n'
            f'[dependencies]\ncarom = {{ path = "{ROOT / "bindings/rust/carom"}" }}\n')
        self.environment["CARGO_TARGET_DIR"] = str(self.place / "target")
        self.run(["cargo", "build", "--release", "--offline", "--quiet"])

    def command(self, name):
        return [self.place / "target" / "release" / name]

    def own_tests(self):
        self.run(["cargo", "test", "--locked", "--offline", "--quiet"], folder=ROOT / "bindings" / "rust")
        done = self.run(["cargo", "build", "--offline", "--quiet"], good=False, PKG_CONFIG_PATH="", CAROM_LIBRARY_DIR="/no/such/folder")
        if done.returncode == 0 or not re.search(r"/no/such/folder/libcarom\.so does not exist\. Set CAROM_LIBRARY_DIR", done.stderr):
            sys.exit(f"a wrong CAROM_LIBRARY_DIR: {done.returncode}\n{done.stderr}")


class Go(Host):
    folder, block, suffix = "go", "go", "go"

    def needs(self):
        version_of(["go", "version"], r"go(\d+)\.(\d+)", (1, 24), "Go")
        self.environment.update(GOPROXY="off", GOFLAGS="-mod=mod -buildvcs=false", GOTOOLCHAIN="local")

    def build(self, names):
        (self.place / "go.mod").write_text("module host\n\ngo 1.24\n")
        self.run(["go", "mod", "edit", "-require", "carom@v0.0.0", "-replace", f"carom={ROOT / 'bindings/go'}"])
        for name in names:
            (self.place / name).mkdir()
            (self.place / name / "main.go").write_text(self.program(name))
            self.run(["go", "build", "-o", self.place / f"{name}.exe", f"./{name}"])

    def command(self, name):
        return [self.place / f"{name}.exe"]

    def own_tests(self):
        self.run(["go", "vet", "./..."], folder=ROOT / "bindings" / "go")
        self.run(["go", "test", "./..."], folder=ROOT / "bindings" / "go")


class Java(Host):
    folder, block, suffix = "java", "java", "java"
    said_when_missing = r"cannot load libcarom\.so\.0\.9. Remedy: .*CAROM_LIBRARY"
    takes_path = True

    def needs(self):
        """$JAVA_HOME, else what is on the PATH, else what the system has: the first that is new enough."""
        homes = [Path(os.environ.get("JAVA_HOME", "/none")), Path(shutil.which("javac") or "/none/bin/javac").resolve().parents[1]]
        for home in homes + sorted(Path("/usr/lib/jvm").glob("*")):
            javac = home / "bin" / "javac"
            if javac.exists():
                found = re.search(r"javac (\d+)", subprocess.run([javac, "-version"], capture_output=True, text=True).stdout)
                if found and int(found[1]) >= 22:
                    self.bin = home / "bin"
                    return
        skip("no javac of Java 22 or newer in JAVA_HOME, on the PATH or in /usr/lib/jvm: java.lang.foreign came with it")

    def build(self, names):
        self.run([self.bin / "javac", "--release", "22", "-d", "carom", *(ROOT / "bindings/java/carom").glob("*.java")])
        for name in names:
            (self.place / f"{name}.java").write_text(self.program(name))
            self.run([self.bin / "javac", "--release", "22", "-cp", "carom", "-d", "carom", f"{name}.java"])

    def java(self, main):
        return [self.bin / "java", "--enable-native-access=ALL-UNNAMED", "-cp", self.place / "carom", main]

    def command(self, name):
        return self.java(name)

    def own_tests(self):
        self.run([self.bin / "javac", "--release", "22", "-cp", "carom", "-d", "carom", ROOT / "bindings/java/test/CaromTest.java"])
        if not re.search(r"^[1-9]\d* passed, 0 failed$", self.run(self.java("carom.CaromTest")).stdout, re.M):
            sys.exit("CaromTest ran no test")
        done = self.run(self.command("hello"), good=False, CAROM_LIBRARY="/no/such/libcarom.so")
        if done.returncode == 0 or "cannot load /no/such/libcarom.so. Remedy: install" not in done.stderr:
            sys.exit(f"a wrong CAROM_LIBRARY: {done.returncode}\n{done.stderr}")


class Csharp(Host):
    folder, block, suffix = "csharp", "csharp", "cs"
    said_when_missing = r"cannot load libcarom\.so\.0\.9: .*Remedy: install.*CAROM_LIBRARY"
    takes_path = True

    def needs(self):
        """mcs, and a runtime: that of $DOTNET_ROOT, else of PyPI's package dotnetcore2."""
        if not shutil.which("mcs"):
            skip("C# is not installed: mcs (Debian: mono-mcs) is not on the PATH")
        package = importlib.util.find_spec("dotnetcore2")
        homes = [Path(os.environ.get("DOTNET_ROOT", "/none")), *(Path(at) / "bin" for at in (package.submodule_search_locations if package else []))]
        for home in homes:
            for core in sorted(home.glob("shared/Microsoft.NETCore.App/*/System.Private.CoreLib.dll")):
                self.home, self.core = home, core.parent
                return
        skip("no .NET runtime in $DOTNET_ROOT, and the package dotnetcore2 is not installed: pip install dotnetcore2")

    def compile(self, name, *more):
        core = [*self.core.glob("System*.dll"), self.core / "netstandard.dll", self.core / "mscorlib.dll"]
        (self.place / "core.rsp").write_text("\n".join(f'-r:"{file}"' for file in core))
        self.run(["mcs", "-nostdlib", "-noconfig", "-unsafe", "-langversion:latest", "-nowarn:1702", "@core.rsp", *more, f"-out:{name}.dll"])
        version = ".".join(self.core.name.split(".")[:2])
        framework = {"name": "Microsoft.NETCore.App", "version": f"{version}.0"}
        options = {"framework": framework, "configProperties": {"System.Globalization.Invariant": True}}
        (self.place / f"{name}.runtimeconfig.json").write_text(json.dumps({"runtimeOptions": options}))

    def build(self, names):
        package = sorted((ROOT / "bindings/csharp/Carom").glob("*.cs"))
        self.compile("Carom", "-target:library", *package)
        for name in names:
            (self.place / f"{name}.cs").write_text(self.program(name))
            self.compile(name, "-r:Carom.dll", f"{name}.cs")

    def command(self, name):
        return [self.home / "dotnet", f"{name}.dll"]

    def own_tests(self):
        self.compile("CaromTest", *sorted((ROOT / "bindings/csharp/Carom").glob("*.cs")), ROOT / "bindings/csharp/test/CaromTest.cs")
        if not re.search(r"^[1-9]\d* passed, 0 failed$", self.run(self.command("CaromTest")).stdout, re.M):
            sys.exit("CaromTest ran no test")
        done = self.run(self.command("hello"), good=False, CAROM_LIBRARY="/no/such/libcarom.so")
        if done.returncode == 0 or not re.search(r"cannot load /no/such/libcarom.so: .*No such file.*Remedy: install", done.stderr):
            sys.exit(f"a wrong CAROM_LIBRARY: {done.returncode}\n{done.stderr}")


HOSTS = {"cpp": Cpp, "rust": Rust, "go": Go, "java": Java, "csharp": Csharp}


def main():
    language, build = sys.argv[1], Path(sys.argv[2]).resolve()
    host = HOSTS[language](language, build)
    host.needs()
    host.calls() if sys.argv[3:] == ["--calls"] else host.test()


main()
