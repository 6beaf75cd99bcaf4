"""Names of the interface exist that pages give: the site's, those of bindings and of the kit. They are carom_... and CAROM_..., functions,
structs, fields, constants, callbacks of api.json, or macros. A name that ends in * stands for those that begin so. And each header is
in the tables of headers.

usage: check_names.py ROOT
"""

import json
import re
import sys
from pathlib import Path

PAGES = ("README.md", "include/README.md", "bindings/**/README.md", "src/kit/README.md", "src/site/docs/**/*.md")
NOT_OURS = {"CAROM_LIBRARY", "CAROM_LIBRARY_DIR", "CAROM_PLUGIN_PATH", "CAROM_GOLDEN", "CAROM_SITE_STEPS"}  # of the environment
TABLES = ("ABI.md", "include/README.md")
FILES = ("h", "hpp", "c", "so", "lua", "wasm", "py")
LEAST = 30  # names on the page of other engines


def known(root):
    api = json.loads((root / "bindings/api.json").read_text(encoding="utf-8"))
    kinds = ("functions", "structs", "constants", "handles", "opaque", "callbacks")
    names = {each["name"] for kind in kinds for each in api[kind]}
    for header in (root / "include/carom").glob("*.h"):
        names |= set(re.findall(r"^#define (CAROM_[A-Z0-9_]+)", header.read_text(encoding="utf-8"), re.M))  # macros, too
    return names | {f"{s['name']}.{f['name']}" for s in api["structs"] for f in s["fields"]}


def main():
    root = Path(sys.argv[1])
    names, found, wrong = known(root), {}, []
    for page in sorted({page for pattern in PAGES for page in root.glob(pattern) if "node_modules" not in page.parts}):
        text = page.read_text(encoding="utf-8")
        found[page] = set(re.findall(r"\b(?:carom|CAROM)_\w+(?:\.[a-z_]+\b(?!\())?\*?", text))
        for name in found[page] - NOT_OURS:
            if name.endswith("*"):
                good = any(each.startswith(name[:-1]) for each in names)
            else:
                good = name in names or name.split(".")[-1] in FILES
            if not good and not name.endswith("_"):
                wrong.append(f"{page.relative_to(root)}: {name}")
    for table in TABLES:
        text = (root / table).read_text(encoding="utf-8")
        missing = [header.name for header in sorted((root / "include/carom").glob("*.h")) if header.name != "carom.h" and header.name not in text]
        if missing:
            sys.exit(f"{table} does not name {', '.join(missing)} of include/carom")
    if len(found[root / "src/site/docs/topics/coming_from.md"]) < LEAST:
        sys.exit(f"coming_from.md has {len(found['coming_from.md'])} names: the pattern of this check no longer fits it")
    if wrong:
        sys.exit("names that the interface does not have:\n  " + "\n  ".join(wrong))
    print(f"{sum(map(len, found.values()))} names on {len(found)} pages")


if __name__ == "__main__":
    main()
