"""include/carom as data: functions, structs, constants, handles, callbacks, each with its documentation.

`read_api(folder)` gives the dictionary that bindings/api.json holds; bindings/README.md says what is in it.
"""
import re
from pathlib import Path

from c_reader import Cursor, HeaderError, read_arguments, read_declarator, read_specifier, tokens_of
from documentation import add_statuses, one_line, plain_text, since_of, without_since
from enumerations import add_enumerations
from layout import lay_out
from pointers import add_owners, add_pointers
from threads import add_threads


class Header:
    """One file's declarations, in its order."""

    def __init__(self, path, api):
        self.path, self.api = path, api
        self.tokens = tokens_of(path.read_text(encoding="utf-8"), path.name)
        self.at = 0
        self.doc = ""          # of the declaration that comes next
        self.doc_still = ""    # of the one before: holds for those that follow it without a blank line
        self.file_since = None
        self.read()

    def refuse(self, line, why):
        raise HeaderError(f"{self.path.name}:{line}: {why}")

    def read(self):
        newlines = 0
        while self.at < len(self.tokens):
            token = self.tokens[self.at]
            if token.kind == "newline":
                newlines += 1
                self.at += 1
                if newlines > 1:
                    self.doc = self.doc_still = ""
            elif token.kind == "comment":
                newlines = 0
                self.at += 1
                self.note_comment(token)
            elif token.text == "#":
                newlines = 0
                self.read_directive()
            else:
                newlines = 0
                self.read_declaration()

    def note_comment(self, token):
        if "@file" in token.text:
            self.api["headers"].append({"name": self.path.name, "doc": re.sub(r"^@file \S+\s*", "", plain_text(token.text))})
            self.file_since = since_of(token.text)
        elif token.text.startswith("/**") and not token.text.startswith("/**<") and "@{" not in token.text:  # the name of a group
            self.doc = plain_text(token.text)

    # ---- lines that begin with # ----

    def read_directive(self):
        line = []
        while self.at < len(self.tokens) and self.tokens[self.at].kind != "newline":
            line.append(self.tokens[self.at])
            self.at += 1
        words = [t.text for t in line if t.kind != "comment"][1:]
        if words[0] in ("if", "ifdef") and words[1] in ("__cplusplus", "defined"):
            self.skip_block()  # what only C++, or only one platform's linker, reads
        elif words[0] == "define":
            self.read_define(line, words)
        elif words[0] not in ("include", "ifndef", "endif"):
            self.refuse(line[0].line, f"unknown directive #{words[0]}")

    def skip_block(self):
        depth = 1
        while depth:
            if self.at >= len(self.tokens):
                self.refuse(self.tokens[-1].line, "#if without #endif")
            if self.tokens[self.at].text == "#":
                word = self.tokens[self.at + 1].text
                depth += word in ("if", "ifdef", "ifndef")
                depth -= word == "endif"
                self.at += 1
            self.at += 1

    def read_define(self, line, words):
        name, value = words[1], words[2:]
        if not value or value[0] == "{":  # an include guard; an initialiser
            return
        comments = [t for t in line if t.kind == "comment"]
        doc = " ".join(one_line(t.text) for t in comments) or self.doc
        type, number = self.constant(value, line[0].line)
        self.api["constants"].append({
            "name": name, "type": type, "value": number, "header": self.path.name,
            "since": since_of(doc) or self.file_since, "doc": without_since(doc)})
        self.doc = ""

    def constant(self, words, line):
        """Type and value of a number with or without u, a sign, a cast to uint64_t and brackets; or of a string."""
        if words[0].startswith('"'):
            return "string", words[0][1:-1]
        text = "".join(words)
        match = re.fullmatch(r"\(?(~?)(?:\((uint64_t)\))?(-?)(0[xX][0-9A-Fa-f]+|\d+)([uU]?)\)?", text)
        if not match:
            self.refuse(line, f"a constant of an unknown form: {text}")
        inverted, wide, minus, digits, unsigned = match.groups()
        number = int(digits, 0) * (-1 if minus else 1)
        if wide:
            return "u64", (~number if inverted else number) & (2**64 - 1)
        if unsigned:
            return "u32", (~number if inverted else number) & (2**32 - 1)
        return "i32", ~number if inverted else number

    # ---- declarations ----

    def read_declaration(self):
        start, depth = self.at, 0
        while True:
            if self.at >= len(self.tokens):
                self.refuse(self.tokens[start].line, "a declaration without its end")
            text = self.tokens[self.at].text
            depth += (text == "{") - (text == "}")
            self.at += 1
            if text == ";" and depth == 0:
                break
        trailing = ""
        if self.at < len(self.tokens) and self.tokens[self.at].kind == "comment":
            trailing = one_line(self.tokens[self.at].text)
            self.at += 1
        tokens = self.tokens[start:self.at]
        doc = self.doc or trailing or self.doc_still
        self.doc, self.doc_still = "", doc
        where = f"{self.path.name}:{tokens[0].line}"
        bare = [t for t in tokens if t.kind not in ("newline", "comment")]
        words = [t.text for t in bare]
        cursor = Cursor(bare, where)
        if cursor.take("extern"):  # what a plugin exports; nothing of ours
            return
        common = {"header": self.path.name, "since": since_of(doc) or self.file_since, "doc": doc}
        if cursor.take("CAROM_API"):
            self.read_function(cursor, common)
        elif cursor.take("typedef"):
            if words[1] == "struct" and words[3] == "{":
                self.read_struct(tokens, words[2], common)
            elif words[1] == "struct":
                self.api["opaque"].append(dict(name=words[2], **common))
            else:
                self.read_typedef(cursor, common)
        else:
            cursor.refuse("not a function, struct or typedef")

    def read_function(self, cursor, common):
        returned = read_declarator(cursor, *read_specifier(cursor))  # its name is the function's
        arguments = read_arguments(cursor)
        cursor.need(";")
        for argument in arguments:
            if not argument.name:
                cursor.refuse("an argument without a name")
        self.api["functions"].append({
            "name": returned.name, "returns": returned.type.spelled(), "arguments": described(arguments), **common})

    def read_typedef(self, cursor, common):
        named = read_declarator(cursor, *read_specifier(cursor))
        cursor.need(";")
        if named.type.function:
            returned, arguments = named.type.function
            self.api["callbacks"].append({"name": named.name, "returns": returned.spelled(),
                                          "arguments": described(arguments), **common})
        elif named.type.spelled() == "uint64_t":
            common["doc"] = without_since(common["doc"])
            self.api["handles"].append(dict(name=named.name, **common))
        else:
            cursor.refuse("a typedef of an unknown form")

    def read_struct(self, tokens, name, common):
        """Fields one by one; a comment behind a field is its own, one before it, too."""
        body = tokens[[t.text for t in tokens].index("{") + 1:]
        fields, before, at = [], "", 0
        while body[at].text != "}":
            if body[at].kind == "newline":
                at += 1
                continue
            if body[at].kind == "comment":
                before = one_line(body[at].text)
                at += 1
                continue
            end = at
            while body[end].text != ";":
                end += 1
            declaration = [t for t in body[at:end + 1] if t.kind not in ("newline", "comment")]
            at = end + 1
            after = []
            while body[at].kind == "comment":
                after.append(one_line(body[at].text))
                at += 1
            fields += self.read_fields(declaration, " ".join(after) or before, common["since"])
            before = ""
        cursor = Cursor([t for t in body[at + 1:] if t.kind not in ("newline", "comment")], self.path.name)
        if cursor.name() != name:
            cursor.refuse(f"struct {name} and its typedef have different names")
        self.api["structs"].append({"name": name, "fields": fields, **common})

    def read_fields(self, declaration, doc, since):
        cursor = Cursor(declaration, f"{self.path.name}:{declaration[0].line}")
        base, const = read_specifier(cursor)
        fields = []
        while True:
            variable = read_declarator(cursor, base, const)
            fields.append({"name": variable.name, "type": variable.type.spelled(),
                           **({} if variable.count is None else {"count": variable.count}), "since": since_of(doc) or since, "doc": without_since(doc)})
            if cursor.take(";"):
                return fields
            cursor.need(",")


def described(arguments):
    return [{"name": a.name, "type": a.type.spelled(), **({} if a.count is None else {"count": a.count})} for a in arguments]


def add_since(api):
    """What says nothing of @since came with the oldest function of its header, or of its struct."""
    version = lambda text: tuple(int(part) for part in text.split("."))  # noqa: E731
    oldest = {}
    for function in api["functions"]:
        function["since"] = function["since"] or "0.9"
        oldest[function["header"]] = min(function["since"], oldest.get(function["header"], function["since"]), key=version)
    for kind in ("constants", "handles", "opaque", "callbacks", "structs"):
        for thing in api[kind]:
            thing["since"] = thing["since"] or oldest.get(thing["header"], "0.9")
            for field in thing.get("fields", ()):
                field["since"] = field["since"] or thing["since"]


def read_api(folder):
    """@param folder include/carom   @return the dictionary of bindings/api.json"""
    api = {"version": "", "soname": "", "headers": [], "handles": [], "opaque": [], "constants": [], "callbacks": [], "structs": [],
           "functions": []}
    umbrella = "carom.h"
    for path in sorted(Path(folder).glob("*.h"), key=lambda p: (p.name != "base.h", p.name == umbrella, p.name)):
        Header(path, api)
    values = {c["name"]: c["value"] for c in api["constants"]}
    api["version"] = ".".join(str(values[f"CAROM_VERSION_{part}"]) for part in ("MAJOR", "MINOR", "PATCH"))
    # What a loader looks for: before 1.0 a minor version may break clients (src/CMakeLists.txt).
    major, minor, _ = api["version"].split(".")
    api["soname"] = "libcarom.so." + (major if major != "0" else f"0.{minor}")
    add_since(api)
    add_statuses(api)
    lay_out(api)
    add_enumerations(api)
    add_pointers(api)
    add_owners(api)
    add_threads(api)
    functions = {f["name"] for f in api["functions"]}
    for struct in api["structs"]:
        struct["init"] = next((n for n in (struct["name"] + "_init",) if n in functions), None)
    return api
