"""The version stands in include/carom/base.h. Manifests of registries cannot read it: each says the same.

Usage: check_versions.py ROOT"""
import json
import re
import sys
from pathlib import Path

# File: what the version stands behind. All matches count.
PLACES = {
    "packages/carom/vcpkg.json": r'"version": "([^"]*)"',
    "packages/debian/changelog": r"^carom \(([^)]*)\)",
    "bindings/rust/Cargo.toml": r'^version = "([^"]*)"',
    "bindings/rust/carom/Cargo.toml": r'carom-sys = \{ path = "[^"]*", version = "([^"]*)"',
    "bindings/js/package.json": r'"version": "([^"]*)"',
    "bindings/csharp/Carom/Carom.csproj": r"<Version>([^<]*)</Version>",
}
# Read by a tool as such.
JSON = ("packages/carom/vcpkg.json", "bindings/js/package.json")


def main():
    root = Path(sys.argv[1])
    version = ".".join(re.findall(r"#define CAROM_VERSION_\w+ (\d+)u", (root / "include/carom/base.h").read_text()))
    wrong = []
    for name, pattern in PLACES.items():
        text = (root / name).read_text()
        found = set(re.findall(pattern, text, re.M))
        if found != {version}:
            wrong.append(f"{name} says {sorted(found)}, include/carom/base.h {version}")
        if name in JSON:
            json.loads(text)
    print("\n".join(wrong) or f"{len(PLACES)} manifests say {version}")
    return bool(wrong)


sys.exit(main())
