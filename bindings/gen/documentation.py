"""What the comments of the headers say, in a form that programs read: text, @since, @status."""
import re

from c_reader import HeaderError

HANDLE_CODES = ("INVALID_HANDLE", "STALE_HANDLE", "WRONG_KIND", "WRONG_WORLD")


def plain_text(comment):
    """A comment without its stars; lines are kept."""
    text = re.sub(r"^/\*+<?", "", comment)[:-2]
    return "\n".join(re.sub(r"^\s*\*? {0,2}", "", line).rstrip() for line in text.split("\n")).strip()


def one_line(comment):
    return " ".join(plain_text(comment).split())


def since_of(doc):
    match = re.search(r"@since (\d+\.\d+)", doc)
    return match.group(1) if match else None


def without_since(doc):
    return re.sub(r"\s*@since \d+\.\d+\s*$", "", doc).strip()


def split_list(text):
    """Parts between semicolons and commas that stand in no brackets."""
    parts, depth, part = [], 0, ""
    for c in text:
        depth += (c == "(") - (c == ")")
        if c in ";," and depth == 0:
            parts.append(part)
            part = ""
        else:
            part += c
    return [p.strip() for p in parts + [part] if p.strip()]


def status_paragraph(doc):
    """What stands behind @status: up to the next @, or the end of a line after which the list does not go on."""
    if "@status" not in doc:
        return ""
    text = ""
    for line in doc.split("@status", 1)[1].split("\n"):
        goes_on = not text or line.startswith(" ") or text[-1] in ";," or text.count("(") > text.count(")")
        if not goes_on:
            break
        part, at, _ = (" " + line).partition(" @")
        text = f"{text} {part.strip()}".strip()
        if at:
            break
    return text


def add_statuses(api):
    """functions[].status from @status, with "as carom_x()" followed; "*_HANDLE" is four codes."""
    known = {c["name"][len("CAROM_E_"):] for c in api["constants"] if c["name"].startswith("CAROM_E_")} | {"OK"}
    functions = {f["name"]: f for f in api["functions"]}

    def codes_of(function, asked):
        if function["name"] in asked:
            raise HeaderError(f"{function['name']}: its @status leads back to itself")
        text = status_paragraph(function["doc"])
        if not text:
            match = re.search(r"\bas\s+(carom_\w+)\(\)", function["doc"])
            text = f"as {match.group(1)}()" if match else ""
        codes = []
        for part in split_list(text):
            same = re.match(r"as (carom_\w+)\(\)", part)
            word = re.match(r"[A-Z_*]+", part)
            if same:
                codes += codes_of(functions[same.group(1)], asked | {function["name"]})
            elif word and word.group() == "*_HANDLE":
                codes += HANDLE_CODES
            elif word and word.group() in known:
                codes.append(word.group())
            else:
                raise HeaderError(f"{function['header']}: {function['name']}: @status names no code: {part!r}")
        return codes

    for function in api["functions"]:
        function["status"] = list(dict.fromkeys(codes_of(function, frozenset())))
        if function["returns"] == "int32_t" and not function["status"]:
            raise HeaderError(f"{function['header']}: {function['name']} has no @status")
