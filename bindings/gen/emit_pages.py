"""Pages of the interface for people: one a header, and an index; Markdown, from what api.json has."""
import re

from emit_lua import named
from threads import tag_of, without_tag
from usual import read_usual, said_by_name, said_by_type

HEAD = "<!-- Written by bindings/gen/generate from include/carom; do not edit. -->\n"
TAGS = ("param", "status", "return", "thread", "owns")
THREADS = {
    "any": "any thread, at any time",
    "engine": "any thread, also while worlds of the engine step",
    "reader": "a reader of the world: beside other readers; `BUSY` beside a writer",
    "writer": "a writer of the world: `BUSY` beside any other call on it",
}


def page_of(header):
    return header.removesuffix(".h") + ".md"


def anchor(name):
    return name.lower()


def cell(text):
    return " ".join(text.split()).replace("|", "\\|")


def sections(doc):
    """[(tag, text)] of a comment: the text before the first tag has the tag ""."""
    parts = re.split(rf"\s*@({'|'.join(TAGS)})\b[ ]?", doc)
    return [("", parts[0])] + list(zip(parts[1::2], parts[2::2]))


def parameters(doc):
    """{name: text} of @param a, b text."""
    found = {}
    for tag, text in sections(doc):
        if tag != "param":
            continue
        names = re.match(r"(?:[a-z_0-9*]+)(?:, [a-z_0-9*]+)*", text)
        if names:
            for name in names.group(0).split(", "):
                found[name] = text[names.end():].strip()
    return found


def without_way(text):
    return re.sub(r"\bout(?:, or NULL)?(?:: |$)", "", text, count=1)  # the table says that in a column of its own


def own_text(name, known):
    """What is said of a parameter, also by a name that ends in a star: motion_* is motion_a and motion_b."""
    return known.get(name) or next((t for n, t in known.items() if n.endswith("*") and name.startswith(n[:-1])), "")


def said_of(argument, function, api, asked=frozenset()):
    """Its own text; that of the function whose arguments it has, or of the one that sets what this one gets; what its
    name means everywhere; its type."""
    functions = {f["name"]: f for f in api["functions"]}
    text = without_way(own_text(argument["name"], parameters(function["doc"]))).strip()
    others = re.findall(r"\bas (carom_\w+)\(\)", function["doc"]) + [function["name"].replace("_get", "_set", 1)]
    for other in others:
        if not text and other in functions and other not in asked | {function["name"]}:
            if any(a["name"] == argument["name"] for a in functions[other]["arguments"]):
                text = without_way(own_text(argument["name"], parameters(functions[other]["doc"]))).strip()
    by_type = said_by_type(argument["type"], api)
    return text or (by_type if by_type.startswith("handle") else "") or said_by_name(argument["name"], read_usual(api)) or by_type


def way(argument):
    """in, out, how many, NULL"""
    words = {"in": "in", "out": "out", "inout": "in, out"}[argument.get("direction", "in")]
    length = argument.get("length", "")
    if length:
        words += f", {length}" if length == "zero-terminated" else f" [{length}]"
    return words + (", or NULL" if argument.get("nullable") else "")


def signature(function):
    start = f"{function['returns']}{'' if function['returns'].endswith('*') else ' '}{function['name']}("
    arguments = [named(a["type"], a["name"]) for a in function["arguments"]] or ["void"]
    line = start + ", ".join(arguments) + ");"
    return line if len(line) <= 110 else start + "\n    " + ",\n    ".join(arguments) + ");"


def linked(text, links):
    """Names of functions and structs that have an entry of their own, as links to it."""
    return re.sub(r"\bcarom_\w+\b(?:\(\))?", lambda m: f"[`{m.group(0)}`]({links[m.group(0).removesuffix('()')]})"
                  if m.group(0).removesuffix("()") in links else m.group(0), text)


def with_tables(text):
    """Lines that begin with two blanks are columns: a block of their own, as they stand."""
    out, inside = [], False
    for line in text.split("\n"):
        if line.startswith("  ") != inside:
            inside = not inside
            out += ["", "```text"] if inside else ["```", ""]
        out.append(line)
    return "\n".join(out + (["```"] if inside else []))


def of_function(function, links, api):
    out = [f"### {function['name']}", "", "```c", signature(function), "```", ""]
    said = dict(sections(function["doc"]))
    if said[""].strip():
        out += [linked(" ".join(said[""].split()), links), ""]
    rows = [a for a in function["arguments"] if a["name"] != "error"]
    if rows:
        out += ["| argument | way | what |", "|---|---|---|"]
        for a in rows:
            text = cell(said_of(a, function, api))
            text = text.removeprefix(f"[{a.get('length')}]").strip() or text  # the column before has it
            out.append(f"| `{a['name']}` | {cell(way(a))} | {linked(text, links)} |")
        out += [""]
    for tag, title in (("return", "Returns"), ("owns", "Owner:")):
        if tag in said:
            out += [f"{title} {' '.join(said[tag].split())}", ""]
    if "thread" in function:
        more = (tag_of(function["doc"]) or ("", ""))[1]
        out += [f"Threads: {more or THREADS[function['thread']]}.", ""]
    if function.get("status"):
        out += ["Results: " + ", ".join(f"`{s}`" for s in function["status"]) + ".", ""]
    return out


def of_struct(struct, links, api):
    out = [f"### {struct['name']}", ""]
    if struct["doc"]:
        out += [linked(" ".join(struct["doc"].split()), links), ""]
    out += ["| field | type | what |", "|---|---|---|"]
    for f in struct["fields"]:
        count = f"[{f['count']}]" if "count" in f else ""
        text = f["doc"] or said_by_name(f["name"], read_usual(api))
        out.append(f"| `{f['name']}` | `{cell(f['type'])}{count}` | {linked(cell(text), links)} |")
    return out + [""]


def of_constants(constants, api):
    counted = {e["count"]: e["name"] for e in api["enumerations"] if e.get("count")}
    rows = [(c, cell(c["doc"]) or (f"number of values of {counted[c['name']]}; may grow" if c["name"] in counted else ""))
            for c in constants]
    return ["## Constants", "", "| name | value | what |", "|---|---|---|",
            *[f"| `{c['name']}` | `{c['value']}` | {text} |" for c, text in rows], ""] if rows else []


def links_of(api):
    return {thing["name"]: f"{page_of(thing['header'])}#{anchor(thing['name'])}"
            for kind in ("functions", "structs", "callbacks") for thing in api[kind]}


def page(api, header):
    links = links_of(api)

    def here(kind):
        return [thing for thing in api[kind] if thing["header"] == header["name"]]

    functions = [f for kind in ("functions", "callbacks") for f in here(kind)]
    out = [HEAD, f"# carom/{header['name']}", "", with_tables(linked(without_tag(header["doc"]), links)), ""]
    if header["thread"]:
        out += [f"Threads: {linked(tag_of(header['doc'])[1], links)}", ""]
    if functions:
        out += ["## Functions", ""] + [line for f in functions for line in of_function(f, links, api)]
    if here("structs"):
        out += ["## Structs", ""] + [line for s in here("structs") for line in of_struct(s, links, api)]
    return "\n".join(out + of_constants(here("constants"), api)).rstrip() + "\n"


def index(api):
    links = links_of(api)
    out = [HEAD, f"# The interface, version {api['version']}", "", "| header | what |", "|---|---|"]
    for header in api["headers"]:
        first = re.split(r"(?<=\.) ", " ".join(header["doc"].split()))[0]
        out.append(f"| [carom/{header['name']}]({page_of(header['name'])}) | {cell(first)} |")
    out += ["", "## Every function", ""]
    for f in sorted(api["functions"], key=lambda f: f["name"]):
        text = re.split(r"(?<=\.) ", " ".join(dict(sections(f["doc"]))[""].split()))[0]
        out.append(f"- [`{f['name']}`]({links[f['name']]})" + (f": {text}" if text else ""))
    return "\n".join(out) + "\n"


def pages(headers):
    """{file: text of it} for emit.FILES.   @param headers  their names"""
    def writer(name):
        return lambda api: page(api, next(h for h in api["headers"] if h["name"] == name))
    return {"include/pages/index.md": index, **{f"include/pages/{page_of(name)}": writer(name) for name in headers}}
