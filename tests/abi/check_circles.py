"""Include circles: x.h and x.cpp are one module. Prints every circle of more than MOST modules and fails if there is one.

Usage: check_circles.py SRC. A file that puts a layer together out of all its modules makes no circle: ROOTS."""
import collections
import os
import re
import sys

LAYERS = ("core", "collision", "dynamics", "abi", "tools")
MOST = 4
ROOTS = {"dynamics/world.cpp", "dynamics/effects.cpp", "dynamics/step.cpp"}


def files_of(src, layer):
    for folder, _, names in os.walk(os.path.join(src, layer)):
        for name in names:
            if name.endswith((".h", ".hpp", ".cpp", ".inc")):
                yield os.path.relpath(os.path.join(folder, name), src)


def arrows_of(src, layer):
    """{module: {module: {file, ...}}}: which file of the one includes the other."""
    arrows = collections.defaultdict(lambda: collections.defaultdict(set))
    bases = [src, os.path.join(src, "tools")]  # what the compiler is given to look in
    for file in files_of(src, layer):
        module = os.path.splitext(file)[0]
        with open(os.path.join(src, file), encoding="utf-8") as text:
            included = re.findall(r'^#include "([^"]+)"', text.read(), re.M)
        for name in included:
            for base in bases + [os.path.dirname(os.path.join(src, file))]:
                found = os.path.join(base, name)
                if os.path.exists(found):
                    other = os.path.splitext(os.path.relpath(found, src))[0]
                    if other != module and other.startswith(layer + "/"):
                        arrows[module][other].add(file)
                    break
    return arrows


def circles(arrows):
    """Strongly connected components of two modules or more (Tarjan's, without recursion)."""
    index, low, stack, on_stack, found = {}, {}, [], set(), []
    for root in list(arrows):
        if root in index:
            continue
        work = [(root, iter(arrows[root]))]
        index[root] = low[root] = len(index)
        stack.append(root), on_stack.add(root)
        while work:
            node, rest = work[-1]
            for other in rest:
                if other not in index:
                    index[other] = low[other] = len(index)
                    stack.append(other), on_stack.add(other)
                    work.append((other, iter(arrows.get(other, ()))))
                    break
                if other in on_stack:
                    low[node] = min(low[node], index[other])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == index[node]:
                    circle = []
                    while not circle or circle[-1] != node:
                        circle.append(stack.pop())
                        on_stack.discard(circle[-1])
                    if len(circle) > 1:
                        found.append(sorted(circle))
    return found


def main(src):
    failed = False
    for layer in LAYERS:
        arrows = arrows_of(src, layer)
        if not arrows:
            sys.exit(f"{src}/{layer} has no includes: this check looks in the wrong place")
        for module in arrows:
            for other in list(arrows[module]):
                if arrows[module][other] <= ROOTS:
                    del arrows[module][other]
        found = circles(arrows)
        print(f"{layer}: {sum(map(len, arrows.values()))} arrows between modules, circles of {[len(c) for c in found] or 'none'}")
        for circle in found:
            if len(circle) > MOST:
                failed = True
                print(f"  {len(circle)} modules include each other in a circle, more than {MOST}:")
                for module in circle:
                    ways = [f"{other} (by {', '.join(sorted(arrows[module][other]))})" for other in sorted(arrows[module]) if other in circle]
                    print(f"    {module} -> " + "; ".join(ways))
            elif "-v" in sys.argv:
                print("  " + " ".join(circle))
    return failed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
