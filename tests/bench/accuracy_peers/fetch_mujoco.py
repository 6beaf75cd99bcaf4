"""Fetch the newest MuJoCo from the Python registry by pip, and unpack its C library and headers: mujoco/ in FOLDER.

    python3 fetch_mujoco.py FOLDER

What is there already is kept: remove the folder for a newer one.
"""
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path


def fetch(folder):
    folder = Path(folder)
    if not list(folder.glob("mujoco/libmujoco.so*")):
        with tempfile.TemporaryDirectory() as downloads:
            subprocess.run([sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary=:all:", "--dest", downloads,
                            "mujoco-core"], check=True, timeout=300)
            wheel = next(Path(downloads).glob("*.whl"))
            with zipfile.ZipFile(wheel) as archive:
                for name in archive.namelist():
                    if name.startswith(("mujoco/include/", "mujoco/libmujoco.so")):
                        archive.extract(name, folder)
    return next(folder.glob("mujoco/libmujoco.so*"))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print(fetch(sys.argv[1]))
