"""Put the package, a built library and its shape plugins together and make a wheel of them: no network, no compiler.

    python3 build_wheel.py LIBRARY PLUGIN_DIR OUT_DIR

Needs setuptools and wheel (Debian: python3-setuptools python3-wheel). CMake: the target `python_wheel`.
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


def build(library, plugins, out):
    """@return the wheel's path"""
    out = Path(out).resolve()
    with tempfile.TemporaryDirectory() as folder:
        stage = Path(folder, "stage")
        shutil.copytree(HERE, stage, ignore=shutil.ignore_patterns("__pycache__", "build", "dist", "*.egg-info", "lib"))
        lib = stage / "carom" / "lib"
        (lib / "plugins").mkdir(parents=True)
        shutil.copy(Path(library).resolve(), lib / soname())
        found = sorted(Path(plugins).glob("*.so"))
        if not found:
            sys.exit(f"no shape plugins in {plugins}: build the target that makes them")
        for plugin in found:
            if plugin.stem != "template":  # the one to copy, not to use
                shutil.copy(plugin, lib / "plugins")
        done = subprocess.run([sys.executable, "setup.py", "-q", "bdist_wheel", "-d", str(out)], cwd=stage, capture_output=True, text=True)
        if done.returncode:
            sys.exit(done.stdout + done.stderr)
    return max(out.glob("carom-*.whl"), key=lambda path: path.stat().st_mtime)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    print(build(*sys.argv[1:]))
