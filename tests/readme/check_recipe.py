"""CONTRIBUTING.md's recipe for an effect with an attribute, executed: its patch is applied to a copy of the sources, the generator
runs, the library is built, README's program says what it always says, and tests/readme/thrust.c finds the new attribute.

Only what depends on the patched files is compiled, without optimisation and many files at a time; the other objects are those
of BUILD. The patch edits those files that the recipe's table names.

usage: check_recipe.py ROOT BUILD [KEEP]   with KEEP, a folder, the copy stays there
"""
import concurrent.futures
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77  # what CTest takes for skipped
AT_A_TIME = 72  # files: what they include is compiled once
PARTS = ("carom_collision", "carom_dynamics", "carom_batch", "carom_kit", "carom_abi", "carom")  # targets that the shared library is made of
OWN_SOURCES = {"include/carom/force.h", "src/dynamics/force/sources.h", "src/dynamics/force/magnetism.cpp"}  # of the table's example alone


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


def recipe_of(root):
    text = (root / "CONTRIBUTING.md").read_text(encoding="utf-8")
    return re.search(r"^## Recipe: an effect, with an attribute of bodies\n(.*?)^## ", text, flags=re.M | re.S)[1]


def hunks_of(recipe):
    """[(file, its lines)]: a place in a file, or a file that is new."""
    patches = re.findall(r"^```diff\n(.*?)^```", recipe, flags=re.M | re.S)
    if len(patches) != 1:
        sys.exit(f"the recipe has {len(patches)} patches, not one")
    hunks, file = [], None
    for line in patches[0].splitlines():
        if line.startswith("--- "):
            hunks.append([line[4:], []])
        elif line.startswith("+++ "):
            hunks[-1][0] = line[4:] + " (new)"
        elif line[:1] in "+- " and line:
            hunks[-1][1].append(line)
        else:
            sys.exit(f"the recipe's patch has a line that begins with none of +, - and a space: {line!r}")
    return hunks


def apply(hunk, tree):
    file, lines = hunk
    if file.endswith(" (new)"):
        path = tree / file[:-len(" (new)")]
        if path.exists():
            sys.exit(f"{path.relative_to(tree)} of the recipe's patch is there already")
        path.write_text("".join(line[1:] + "\n" for line in lines), encoding="utf-8")
        return
    text = (tree / file).read_text(encoding="utf-8")
    before = [line[1:] for line in lines if line[0] != "+"]
    # A line may go on where the patch ends it; {N} is a number.
    pattern = "\n".join(re.escape(line).replace(r"\{N\}", "(?P<N>[0-9]+)") for line in before)
    found = list(re.finditer("^" + pattern, text, flags=re.M))
    if len(found) != 1:
        sys.exit(f"the recipe's patch of {file}: there are {len(found)} places with\n" + "\n".join(before))
    number = found[0].groupdict().get("N")

    def filled(line):
        return line if number is None else line.replace("{N}", number).replace("{N+1}", str(int(number) + 1))

    tail = text[found[0].end():]  # of the last line that stays or goes
    after = [filled(line[1:]) for line in lines if line[0] != "-"]
    (tree / file).write_text(text[:found[0].start()] + "\n".join(after) + tail, encoding="utf-8")


def same_as_the_table(recipe, hunks):
    """The files that the patch edits are those of the table, but for those of the table's own example."""
    rows = re.findall(r"^\| `((?:include|src)/[^`]+)` \|", recipe, flags=re.M)
    edited = {file for file, _ in hunks if not file.endswith(" (new)")}
    if edited != set(rows) - OWN_SOURCES:
        sys.exit(f"the recipe's patch edits {sorted(edited)}, its table names {sorted(set(rows) - OWN_SOURCES)}")


def copy(root, tree):
    for name in ("include", "src", "bindings", "README.md"):
        if (root / name).is_dir():
            shutil.copytree(root / name, tree / name, ignore=shutil.ignore_patterns("node_modules", "dist", "site", "__pycache__", "*.png", "*.webp"))
        else:
            shutil.copy(root / name, tree / name)


def changed(root, tree):
    """Files of the copy that are not as in ROOT, relative to it."""
    found = set()
    for folder in ("include", "src"):
        for path in (tree / folder).rglob("*"):
            original = root / path.relative_to(tree)
            if path.is_file() and not (original.is_file() and original.read_bytes() == path.read_bytes()):
                found.add(path.relative_to(tree))
    return found


def ninja(build, *arguments):
    done = subprocess.run(["ninja", "-C", str(build), *arguments], capture_output=True, text=True)
    if done.returncode:
        skip(f"no build by ninja in {build}: {done.stderr.strip()}")
    return done.stdout


def dependencies(build):
    """{object: files that it was made from}"""
    found, at = {}, None
    for line in ninja(build, "-t", "deps").splitlines():
        if line.startswith(" "):
            found[at].append(Path(os.path.normpath(build / line.strip())))
        elif ": #deps" in line:
            at = line.split(":")[0]
            found[at] = []
    return found


def sources_of(command):
    """What is compiled: one file, or those that CMake put into one."""
    file = Path(command["file"])
    if "Unity" not in file.parts:
        return [file]
    return [Path(path) for path in re.findall(r'^#include "([^"]+)"', file.read_text(encoding="utf-8"), flags=re.M)]


def compiler_line(command, root, tree):
    """The build's own, on the copy, without what takes time or is about one file."""
    kept, words = [], iter(shlex.split(command["command"]))
    for word in words:
        if word in ("-o", "-c", "-MT", "-MF"):
            next(words)
        elif word == "-MD" or re.match(r"-O|-g|-W|-[DU]_FORTIFY_SOURCE", word):
            continue
        else:
            kept.append(word.replace(str(root), str(tree)))
    return (*kept, "-O0", "-w")


def compile_files(line, files, tree, name):
    """Objects of files, all in one but for those that do not go together. @return objects, or what the compiler says of a file"""
    unit, result = tree / "objects" / f"{name}.cpp", tree / "objects" / f"{name}.o"
    unit.write_text("".join(f'#include "{file}"\n' for file in files), encoding="utf-8")
    environment = {**os.environ, "CCACHE_BASEDIR": str(tree), "CCACHE_NOHASHDIR": "1"}  # a copy elsewhere finds it again
    done = subprocess.run([*line, "-c", str(unit), "-o", str(result)], capture_output=True, text=True, cwd=tree, env=environment)
    if done.returncode == 0:
        return [result]
    if len(files) == 1:
        raise RuntimeError(f"{files[0]} of the recipe's patch does not compile:\n{done.stderr[:3000]}")
    named = {str(Path(tree, path)) for path in re.findall(r"^([^\s:]+):[0-9]+:[0-9]+: error", done.stderr, flags=re.M)}
    apart = [file for file in files if str(file) in named] or files[:1]  # two of them have a name in common: one goes by itself
    rest = [file for file in files if file not in apart]
    objects = [one for k, file in enumerate(apart) for one in compile_files(line, [file], tree, f"{name}_{k}")]
    return objects + (compile_files(line, rest, tree, name + "_rest") if rest else [])


def build_library(root, build, tree):
    """@return the shared library, and how many files were compiled"""
    different = changed(root, tree)
    commands = [command for command in json.loads(ninja(build, "-t", "compdb"))
                if re.match(r"src/CMakeFiles/(?:" + "|".join(PARTS) + r")(?:_seldom)?\.dir/", command["output"])]
    made_from = dependencies(build)
    objects, to_compile = [], {}
    for command in commands:
        result = command["output"]
        if result not in made_from or not (build / result).exists():
            skip(f"{result} is not built: ninja -C {build} carom")
        patched = any(path.is_relative_to(root) and path.relative_to(root) in different for path in made_from[result])
        if not patched:
            objects.append(build / result)
            continue
        for source in sources_of(command):
            line = compiler_line(command, root, tree)
            alone = source.name if "_kernels" in source.name or source.name == "stages.cpp" else ""  # names that others have, too
            copied = tree / source.relative_to(root)
            to_compile.setdefault((line, alone), []).append(copied if copied.exists() else source)  # CMake wrote it: not copied
    line = next(line for line, alone in to_compile if any("dynamics" in file.parts for file in to_compile[line, alone]) and not alone)
    to_compile[line, ""] += [tree / file for file in different if file.suffix == ".cpp" and not (root / file).exists()]
    (tree / "objects").mkdir()
    groups = []
    for number, ((line, _), files) in enumerate(to_compile.items()):
        files.sort()
        for begin in range(0, len(files), AT_A_TIME):
            groups.append((line, files[begin:begin + AT_A_TIME], tree, f"unit_{number}_{begin}"))
    with concurrent.futures.ThreadPoolExecutor(min(2, os.cpu_count() or 1)) as executor:
        for done in [executor.submit(compile_files, *group) for group in groups]:
            objects += done.result()
    compiler = [word for word in line if not word.startswith("-")]  # with its launcher
    library = tree / "libcarom.so"
    subprocess.run([compiler[1] if len(compiler) > 1 and "ccache" in compiler[0] else compiler[0], "-shared", "-o", str(library),
                    f"-Wl,--version-script={tree}/src/abi/carom.map", *map(str, objects), "-lpthread", "-ldl"], check=True)
    return library, sum(map(len, to_compile.values()))


def run_program(source, library, tree, build, expected):
    program = tree / source.stem
    subprocess.run([os.environ.get("CC", "cc"), "-std=c11", str(source), f"-I{tree}/include", str(library), f"-Wl,-rpath,{library.parent}",
                    "-lm", "-o", str(program)], check=True)
    done = subprocess.run([str(program)], capture_output=True, text=True, timeout=60,
                          env={**os.environ, "CAROM_PLUGIN_PATH": str(build / "plugins")})
    if done.returncode or not re.search(expected, done.stdout):
        sys.exit(f"{source.name} after the recipe: exit code {done.returncode}, it says\n{done.stdout}{done.stderr}")
    print(done.stdout.strip())


def main():
    root, build = (Path(os.path.abspath(argument)) for argument in sys.argv[1:3])
    cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
    if re.search(r"^CAROM_SANITIZE:\w+=.+$", cache, flags=re.M):
        skip("a library with sanitizers takes minutes to build")
    if not (build / "build.ninja").exists() or not shutil.which("ninja") or not shutil.which("cc"):
        skip("needs ninja, cc and a build by them")
    recipe = recipe_of(root)
    hunks = hunks_of(recipe)
    same_as_the_table(recipe, hunks)
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(sys.argv[3] if len(sys.argv) > 3 else folder).resolve() / "recipe"
        tree.mkdir(parents=True)
        copy(root, tree)
        for hunk in hunks:
            apply(hunk, tree)
        subprocess.run([sys.executable, str(tree / "bindings/gen/generate")], check=True, stdout=subprocess.DEVNULL)
        try:
            library, count = build_library(root, build, tree)
        except RuntimeError as problem:
            sys.exit(str(problem))
        print(f"{count} files compiled")
        hello = re.search(r"^```c\n(#include.*?)^```", (root / "README.md").read_text(encoding="utf-8"), flags=re.M | re.S)[1]
        (tree / "hello.c").write_text(hello, encoding="utf-8")
        # As readme/hello: a ball of 0.5 m on the ground. A recipe that took its weight away left it at 3 m.
        run_program(tree / "hello.c", library, tree, build, r"y = 0\.(49[5-9]|50[0-5])")
        run_program(root / "tests/readme/thrust.c", library, tree, build, "thrust pushes what has it")


main()
