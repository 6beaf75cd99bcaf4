#!/usr/bin/env python3
"""What carom.wasm is made of: sections, and functions by what they belong to; bytes, and bytes by gzip.

    em++ ... -o named.wasm --profiling-funcs      the module with the names of its functions (ninja -t commands carom_module)
    bindings/js/wasm/sizes.py named.wasm [--functions N]
"""
import argparse
import gzip
import re
import subprocess
from collections import Counter
from pathlib import Path

SECTIONS = ["custom", "type", "import", "function", "table", "memory", "global", "export", "start", "element", "code", "data", "data count", "tag"]


class Reader:
    def __init__(self, data, at=0):
        self.data, self.at = data, at

    def number(self):
        value = shift = 0
        while True:
            byte = self.data[self.at]
            self.at += 1
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    def take(self, n):
        self.at += n
        return self.data[self.at - n : self.at]

    def text(self):
        return self.take(self.number()).decode()


def group_of(name):
    """Of a C++ name: namespace::class, or the kind of function."""
    if re.search(r"LaneRunOf<(double|float)>", name):
        return f"kernels of contacts, {re.search(r'LaneRunOf<(double|float)>', name)[1]}"
    if re.search(r"JointRun", name):
        return "kernels of joints"
    for pattern, group in (
        (r"std::|__cxx|operator new|__cxa|__dynamic_cast|_Unwind|libunwind", "C++ library"),
        (r"^(dl)?(malloc|free|calloc|realloc|memcpy|memset|memmove|str\w+|printf\w*|\w*printf\w*|__\w+|fmt_fp|pop_arg|abort|emscripten\w*)", "C library"),
        (r"Eigen::", "Eigen"),
    ):
        if re.search(pattern, name.split("(")[0]):
            return group
    found = re.search(r"carom::((?:\(anonymous namespace\)::|\w+::)*)", name)
    if found:
        return "carom::" + (found[1].replace("(anonymous namespace)::", "").rstrip(":") or "")
    return "carom_* (the interface)" if name.startswith("carom_") else "other"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("module", type=Path)
    options.add_argument("--functions", type=int, default=0, help="list the largest functions, too")
    given = options.parse_args()
    read = Reader(given.module.read_bytes(), 8)
    sections, bodies, names, imported = Counter(), [], {}, 0
    while read.at < len(read.data):
        kind, size = read.number(), read.number()
        inner = Reader(read.data, read.at)
        read.at += size
        label = SECTIONS[kind]
        if kind == 0:
            label = f"custom {inner.text()}"
        sections[label] += size
        if kind == 2:
            for _ in range(inner.number()):
                inner.text(), inner.text()
                what = inner.number()
                if what == 0:
                    inner.number()
                    imported += 1
                elif what == 1:
                    inner.number(), inner.number(), inner.number()
        if kind == 10:
            for _ in range(inner.number()):
                size_of = inner.number()
                bodies.append(inner.take(size_of))
        if label == "custom name":
            while inner.at < read.at:
                what, length = inner.number(), inner.number()
                if what == 1:
                    for _ in range(inner.number()):
                        index = inner.number()
                        names[index] = inner.text()
                    break
                inner.take(length)
    print("\n".join(f"{size:9}  {label}" for label, size in sections.most_common()))
    plain = [names.get(i + imported, f"function {i}") for i in range(len(bodies))]
    plain = subprocess.run(["c++filt"], input="\n".join(plain), capture_output=True, text=True, check=True).stdout.split("\n")
    groups = {}
    for name, body in zip(plain, bodies):
        groups.setdefault(group_of(name), []).append(body)
    rows = [(sum(map(len, group)), len(gzip.compress(b"".join(group), 9)), name) for name, group in groups.items()]
    print(f"\n{'bytes':>9} {'gzip':>8}")
    print("\n".join(f"{size:9} {packed:8}  {name}" for size, packed, name in sorted(rows, reverse=True)[:30]))
    print()
    for size, name in sorted(((len(body), name) for name, body in zip(plain, bodies)), reverse=True)[: given.functions]:
        print(f"{size:9}  {name[:150]}")


main()
