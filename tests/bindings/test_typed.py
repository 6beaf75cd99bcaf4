"""The package is typed all through: `mypy --strict` finds nothing in it, nothing in what uses it rightly, and each of ten
mistakes where it was made. Needs mypy 1.8 or newer (pip install mypy), and is skipped without it."""

import ast
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
PACKAGE = HERE.parents[1] / "bindings" / "python"
SKIPPED = 77  # what CTest takes for skipped


def mypy():
    """@return the command line that runs mypy, or None"""
    if importlib.util.find_spec("mypy"):
        command = [sys.executable, "-m", "mypy"]
    elif shutil.which("mypy"):
        command = [shutil.which("mypy"), "--python-executable", sys.executable]
    else:
        return None
    version = subprocess.run(command + ["--version"], capture_output=True, text=True)
    found = re.search(r"(\d+)\.(\d+)", version.stdout)
    return command if found and (int(found[1]), int(found[2])) >= (1, 8) else None


class Typed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cache = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.cache.cleanup()

    def check(self, *what):
        """@return {(file, line): what mypy says}"""
        said = subprocess.run(
            mypy() + ["--strict", "--cache-dir", self.cache.name, "--no-error-summary", *map(str, what)],
            capture_output=True,
            text=True,
            env={**os.environ, "MYPYPATH": str(PACKAGE)},
        )
        self.assertFalse(said.stderr, said.stderr)
        found = re.findall(r"^(.*?):(\d+): error: (.*)$", said.stdout, flags=re.M)
        self.assertEqual(bool(found), said.returncode != 0, said.stdout)
        return {(Path(file).name, int(line)): text for file, line, text in found}

    def test_the_package_itself(self):
        self.assertEqual(self.check("-p", "carom"), {})

    def test_what_is_right(self):
        self.assertEqual(self.check(HERE / "typed/right.py"), {})

    def test_ten_mistakes(self):
        wrong = HERE / "typed/wrong.py"
        marked = {("wrong.py", at) for at, line in enumerate(wrong.read_text().split("\n"), 1) if "# mistake" in line}
        self.assertEqual(len(marked), 10)
        found = self.check(wrong)
        self.assertEqual(set(found), marked, found)

    def test_every_public_name_has_a_type(self):
        """No public method, property or function is without the type of what it gives."""
        said = []
        for file in sorted((PACKAGE / "carom").glob("[a-z]*.py")):
            if file.name == "raw.py":  # raw.pyi has its types
                continue
            for function in ast.walk(ast.parse(file.read_text())):
                if isinstance(function, ast.FunctionDef) and not function.name.startswith("_") and function.returns is None:
                    said.append(f"{file.name}: {function.name}")
        self.assertEqual(said, [])


if __name__ == "__main__":
    if mypy() is None:
        print("skipped: no mypy 1.8 or newer (pip install mypy)")
        sys.exit(SKIPPED)
    unittest.main()
