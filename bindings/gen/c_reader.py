"""Reads C declarations of the plain kind that include/carom is written in.

Not a C compiler: what it does not know is an error with file and line, never a guess. That the compiler reads the same
in them is checked where compilers are (tests/bindings/check_signatures.cmake, tests/abi/test_manifest.cpp).
"""
import re

TOKEN = re.compile(
    r"""(?P<comment>/\*.*?\*/)|(?P<newline>\n)|(?P<blank>[ \t\r]+|\\\n)|(?P<string>"[^"\n]*")
      |(?P<number>0[xX][0-9A-Fa-f]+[uU]?|[0-9]+[uU]?)|(?P<name>[A-Za-z_]\w*)|(?P<mark>\.\.\.|[-#{}()\[\];,*=~&<>./+|!?:])""",
    re.S | re.X)


class HeaderError(Exception):
    """The header says something that this reader, or the house's rules for the boundary, do not know."""


class Token:
    __slots__ = ("kind", "text", "line")

    def __init__(self, kind, text, line):
        self.kind, self.text, self.line = kind, text, line

    def __repr__(self):
        return self.text


def tokens_of(text, path):
    """All tokens but blanks; comments and ends of lines are tokens, since both carry meaning here."""
    found, at, line = [], 0, 1
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise HeaderError(f"{path}:{line}: cannot read {text[at:at + 20]!r}")
        if match.lastgroup != "blank":
            found.append(Token(match.lastgroup, match.group(), line))
        line += match.group().count("\n")
        at = match.end()
    return found


class Type:
    """`base` behind pointers, innermost first, each const or not; of a function pointer, what it returns and takes."""

    def __init__(self, base, base_const=False, pointers=(), function=None):
        self.base, self.base_const, self.pointers, self.function = base, base_const, tuple(pointers), function

    def spelled(self):
        """As C writes it, without a name: "const char *const *"; of a function pointer "int32_t (*)(double)"."""
        if self.function:
            returns, arguments = self.function
            return f"{returns.spelled()} (*)({', '.join(a.type.spelled() for a in arguments) or 'void'})"
        text = ("const " if self.base_const else "") + self.base
        if self.pointers:
            text += " " + "".join("*const " if const else "*" for const in self.pointers).rstrip()
        return text

    def pointer_to(self):
        return Type(self.base, self.base_const, self.pointers + (False,))


class Variable:
    """A field or an argument: name, type, and the number of elements where it is an array (else None)."""

    def __init__(self, name, type, count, doc=""):
        self.name, self.type, self.count, self.doc = name, type, count, doc


class Cursor:
    """Walks over one declaration's tokens."""

    def __init__(self, tokens, where):
        self.tokens, self.at, self.where = tokens, 0, where

    def peek(self):
        return self.tokens[self.at].text if self.at < len(self.tokens) else ""

    def next(self):
        token = self.peek()
        self.at += 1
        return token

    def take(self, text):
        if self.peek() == text:
            self.at += 1
            return True
        return False

    def need(self, text):
        if not self.take(text):
            self.refuse(f"expected {text!r} before {self.peek()!r}")

    def name(self):
        if self.at >= len(self.tokens) or self.tokens[self.at].kind != "name":
            self.refuse(f"expected a name, found {self.peek()!r}")
        return self.next()

    def refuse(self, why):
        raise HeaderError(f"{self.where}: {why} in: {' '.join(t.text for t in self.tokens)}")


def read_specifier(cursor):
    """const, struct and the type's name."""
    const = cursor.take("const")
    cursor.take("struct")
    base = cursor.name()
    if base in ("unsigned", "signed", "long", "short", "int", "bool", "_Bool", "enum", "union", "float", "size_t"):
        cursor.refuse(f"{base!r} has no place at this boundary: see ABI.md, conventions")
    return base, const or cursor.take("const")


def read_declarator(cursor, base, const):
    """Stars, name, and what stands behind it; the name may be missing."""
    pointers = []
    while cursor.take("*"):
        pointers.append(cursor.take("const"))
    plain = Type(base, const, pointers)
    if cursor.take("("):  # (*name)(arguments): a pointer to a function
        cursor.need("*")
        name = cursor.name()
        cursor.need(")")
        return Variable(name, Type(None, function=(plain, read_arguments(cursor))), None)
    name = cursor.name() if cursor.peek() not in (",", ")", ";", "[", "") else ""
    count = None
    if cursor.take("["):
        count = int(cursor.next(), 0)
        cursor.need("]")
        if cursor.peek() == "[":
            cursor.refuse("arrays of arrays are not known")
    return Variable(name, plain, count)


def read_arguments(cursor):
    """(void), or declarations with commas between; arrays are pointers there, and remember their length."""
    cursor.need("(")
    if cursor.peek() == "void" and cursor.tokens[cursor.at + 1].text == ")":
        cursor.at += 2
        return []
    arguments = []
    while True:
        argument = read_declarator(cursor, *read_specifier(cursor))
        if argument.count is not None:
            argument.type = argument.type.pointer_to()
        arguments.append(argument)
        if cursor.take(")"):
            return arguments
        cursor.need(",")
