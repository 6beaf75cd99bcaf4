"""What arguments and fields are of which a comment says nothing: by their name, from base.h, or by their type.

base.h's opening comment has the names in columns, behind a line that ends in USUAL. A name that begins with a star
stands for every name that ends so.
"""
import re

USUAL = "mean the same everywhere:"


def read_usual(api):
    """{name: text}"""
    doc = next(header["doc"] for header in api["headers"] if header["name"] == "base.h")
    found, name = {}, None
    for line in doc.partition(USUAL)[2].lstrip("\n").split("\n"):
        if not line.startswith("  "):
            break
        row = re.match(r"  (\S(?:.*?\S)?)  +(\S.*)$", line)
        if row and not line.startswith("   "):
            names = row.group(1).split(", ")
            for name in names:
                found[name] = row.group(2)
        else:
            for name in names:
                found[name] += " " + line.strip()
    return found


def said_by_name(name, usual):
    return usual.get(name) or next((t for n, t in usual.items() if n.startswith("*") and name.endswith(n[1:])), "")


def said_by_type(type, api):
    """Of a handle, or a pointer to a struct or a root."""
    bare = re.sub(r"\bconst\b|[*\s]", "", type)
    if not bare.startswith("carom_"):
        return ""
    noun = bare.removeprefix("carom_").replace("_", " ")
    if any(bare == handle["name"] for handle in api["handles"]):
        return f"handle of {'an' if noun[0] in 'aeiou' else 'a'} {noun}"
    return bare if any(bare == thing["name"] for kind in ("structs", "callbacks") for thing in api[kind]) else ""
