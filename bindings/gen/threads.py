"""functions[].thread: which threads may make a call, and what may run beside it.

    any     neither an engine nor a world: any thread, at any time
    engine  any thread, also while worlds of the engine step; not while the engine is destroyed
    reader  reads a world: beside other readers; BUSY beside a writer
    writer  changes, steps or destroys what it is given: BUSY beside any other call on that world or batch

A header with functions has one @thread in its opening comment, and a function its own where that does not hold:
    @thread any     no call takes an engine or a world
    @thread engine  calls that take an engine: engine
    @thread world   calls that take a world: reader if the name has one of READING in it, else writer
    @thread batch   calls that take a batch: writer
"""
import re

from c_reader import HeaderError

KINDS = ("any", "engine", "reader", "writer")
RULES = ("any", "engine", "world", "batch")
READING = ("get", "is", "read")


def tag_of(doc):
    """(word, text) behind @thread, or None."""
    match = re.search(r"@thread (\w+)((?:(?!\s@[a-z]+\b|\*/)[\s\S])*)", doc)
    return match and (match.group(1), " ".join(match.group(2).lstrip(":,").split()))


def without_tag(doc):
    return re.sub(r"\s*@thread \w+(?:(?!\s@[a-z]+\b|\*/)[\s\S])*", "", doc, count=1).rstrip()


def by_rule(function, rule):
    takes = {argument["type"].split()[0] for argument in function["arguments"] if argument["type"].count("*") == 1}
    if "carom_world" in takes and rule == "world":
        return "reader" if set(READING) & set(function["name"].split("_")) else "writer"
    if "carom_engine" in takes and rule == "engine":
        return "engine"
    if "carom_batch" in takes and rule == "batch":
        return "writer"
    if takes & {"carom_world", "carom_engine", "carom_batch"}:
        raise HeaderError(f"{function['header']}: {function['name']}: say its @thread; the header's is {rule!r}")
    return "any"


def add_threads(api):
    rules = {}
    for header in api["headers"]:
        tag = tag_of(header["doc"])
        header["thread"] = tag[0] if tag else None
        if tag and tag[0] not in RULES:
            raise HeaderError(f"{header['name']}: @thread {tag[0]} of a header is none of {', '.join(RULES)}")
        rules[header["name"]] = header["thread"]
    for function in api["functions"]:
        rule = rules[function["header"]]
        if rule is None:
            raise HeaderError(f"{function['header']}: its opening comment has no @thread")
        tag = tag_of(function["doc"])
        function["thread"] = tag[0] if tag else by_rule(function, rule)
        if function["thread"] not in KINDS:
            raise HeaderError(f"{function['header']}: {function['name']}: @thread {tag[0]} is none of {', '.join(KINDS)}")
