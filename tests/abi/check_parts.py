"""Who receives a mutable World: whoever edits one between steps, and what runs the stages. Stages receive the parts that
they write (dynamics/part.h). Prints every other place in src/dynamics where `World&` is not const, and fails if there
is one, or if there are more than MOST where it may be.

Usage: check_parts.py SRC"""
import os
import re
import sys

# Editing functions, snapshots, what steps copies of a world, and what hands parts to stages.
ALLOWED = ("world.", "edit.cpp", "snapshot/", "force/edit.cpp", "joint/edit.cpp", "part.h", "stages.", "step.cpp",
           "sleep/wake.cpp", "accuracy/growth.")
# Declarations of editing functions in headers of stages, and what collects events.
EDITS = {"sleep/sleep.h", "force/force.h", "events/events.h", "events/events.cpp"}
EDIT_NAMES = r"\b(wake|wake_all|wake_touching|wake_wearing|mark_touched_by_host|unlist_collider|unlist_body|remove_springs_of|collect)\(World& world"
MOST = 53


def mutable(text):
    """Lines that name a mutable World by reference or pointer, without comments."""
    for number, line in enumerate(text.split("\n"), 1):
        code = line.split("//")[0]
        if re.search(r"(?<!const )\bWorld\s*[&*]", code) or "const_cast<World" in code:
            yield number, code


def main(src):
    allowed, stray, files = 0, [], 0
    root = os.path.join(src, "dynamics")
    for folder, _, names in os.walk(root):
        for name in sorted(names):
            if not name.endswith((".h", ".cpp")):
                continue
            files += 1
            path = os.path.relpath(os.path.join(folder, name), root)
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                for number, code in mutable(file.read()):
                    if path.startswith(ALLOWED) or (path in EDITS and re.search(EDIT_NAMES, code)):
                        allowed += 1
                    else:
                        stray.append(f"src/dynamics/{path}:{number}: {code.strip()}")
    if files == 0:
        sys.exit(f"{root} has no sources: this check looks in the wrong place")
    print(f"a mutable World: {allowed} times where worlds are edited or stages are run (at most {MOST}), {len(stray)} elsewhere")
    for place in stray:
        print(f"  {place}\n    a stage receives `const World&` and the parts that it writes, see dynamics/part.h")
    return bool(stray) or allowed > MOST


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
