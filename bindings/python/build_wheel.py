"""Put the package, a built library and its shape plugins together and make a wheel of them: no network, no compiler.

    python3 build_wheel.py LIBRARY PLUGIN_DIR OUT_DIR [PLATFORM]

PLATFORM is the tag of another platform that the library is built for: win_amd64, macosx_11_0_arm64. Needs setuptools and wheel (Debian: python3-setuptools python3-wheel). CMake: the target `python_wheel`.
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent


def soname():
    """What carom/raw.py looks for: one line of what bindings/gen writes, read without loading a library."""
    text = (HERE / "carom" / "_c.py").read_text(encoding="utf-8")
    return re.search(r"^SONAME = '(.+)'$", text, re.MULTILINE)[1]


def build(library, plugins, out, platform=None):
    """@return the wheel's path"""
    library, out = Path(library).resolve(), Path(out).resolve()
    name = {".dll": "carom.dll", ".dylib": soname().replace(".so", "") + ".dylib"}.get(library.suffix, soname())  # as raw.FILE
    ending = ".dll" if library.suffix == ".dll" else ".so"
    with tempfile.TemporaryDirectory() as folder:
        stage = Path(folder, "stage")
        shutil.copytree(HERE, stage, ignore=shutil.ignore_patterns("__pycache__", "build", "dist", "*.egg-info", "lib"))
        lib = stage / "carom" / "lib"
        (lib / "plugins").mkdir(parents=True)
        shutil.copy(library, lib / name)
        found = sorted(Path(plugins).glob("*" + ending))
        if not found:
            sys.exit(f"no shape plugins, *{ending}, in {plugins}: build the target that makes them")
        for plugin in found:
            if plugin.stem != "template":  # the one to copy, not to use
                shutil.copy(plugin, lib / "plugins")
        tag = ["--plat-name", platform] if platform else []
        done = subprocess.run([sys.executable, "setup.py", "-q", "bdist_wheel", *tag, "-d", str(out)], cwd=stage, capture_output=True, text=True)
        if done.returncode:
            sys.exit(done.stdout + done.stderr)
    return max(out.glob("carom-*.whl"), key=lambda path: path.stat().st_mtime)


if __name__ == "__main__":
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    print(build(*sys.argv[1:]))
