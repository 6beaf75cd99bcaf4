"""The recipes of CONTRIBUTING.md: each table lists as many files as its text says, every file exists (NAME stands for a
new one's), and every commit that a recipe shows is in the history, where there is one.

usage: check_recipes.py ROOT
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path


def in_history(root, commit):
    """None where the checkout has no history, or only the end of it, or no git is installed."""
    if not shutil.which("git"):
        return None
    git = ["git", "-c", "safe.directory=*", "-C", str(root)]
    shallow = subprocess.run(git + ["rev-parse", "--is-shallow-repository"], capture_output=True, text=True)
    if shallow.returncode or shallow.stdout.strip() == "true":
        return None
    return subprocess.run(git + ["cat-file", "-e", commit + "^{commit}"], capture_output=True).returncode == 0


def main():
    root = Path(sys.argv[1])
    recipes = re.split(r"^## Recipe: ", (root / "CONTRIBUTING.md").read_text(encoding="utf-8"), flags=re.M)[1:]
    recipes[-1] = recipes[-1].split("\n## ")[0]
    problems = []
    for recipe in recipes:
        title = recipe.split("\n", 1)[0]
        said = re.search(r"[Bb]y hand (\d+) files|(\d+) files by hand", recipe)
        cells = [row.split("|")[1] for row in re.findall(r"^\|.*$", recipe, flags=re.M)[2:]]
        files = [file for cell in cells for file in re.findall(r"`([^`]+)`", cell)]
        if said and int(said[1] or said[2]) != len(files):
            problems.append(f"{title}: says {said[0]}, and lists {len(files)}")
        problems += [f"{title}: {file} does not exist" for file in files if "NAME" not in file and not (root / file).exists()]
        for command in re.findall(r"`git show --stat ([^`]+)`", recipe):
            problems += [f"{title}: no commit {c}" for c in command.split() if in_history(root, c) is False]
    if len(recipes) < 5:
        problems.append(f"only {len(recipes)} recipes: shape, effect, joint, broad phase and function are five")
    if problems:
        sys.exit("\n".join(problems))
    print(f"{len(recipes)} recipes")


main()
