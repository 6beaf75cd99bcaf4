"""What a C type says, as raw layers need it."""
import re


def pointers(spelled):
    """("carom_body", [True]) of "const carom_body *": the type below all pointers, and for each pointer, from the inside out, whether what
    it points to is const."""
    parts = spelled.split("*")
    base = re.sub(r"\bconst\b", "", parts[0]).strip()
    return base, [re.search(r"\bconst\b", part) is not None for part in parts[:-1]]


def function(spelled):
    """("int32_t", ["void *", ...]) of a pointer to a function, or None."""
    match = re.fullmatch(r"(.*?) \(\*\)\((.*)\)", spelled)
    return match and (match.group(1), [a for a in match.group(2).split(", ") if a != "void"])
