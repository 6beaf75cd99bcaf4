"""Fetch the newest Drake that this Python can load, and numpy, from the Python registry by pip; unpack both in FOLDER.

    python3 fetch_drake.py FOLDER

What is there already is kept: remove the folder for a newer one.
"""
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path


def fetch(folder):
    folder = Path(folder)
    if not (folder / "pydrake").exists():
        with tempfile.TemporaryDirectory() as downloads:
            subprocess.run([sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary=:all:",
                            "--dest", downloads, "drake", "numpy"], check=True, timeout=600)
            for wheel in sorted(Path(downloads).glob("*.whl"), reverse=True):  # Drake last: if it is there, all is
                with zipfile.ZipFile(wheel) as archive:
                    archive.extractall(folder)
    return folder / "pydrake"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print(fetch(sys.argv[1]))
