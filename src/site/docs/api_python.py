"""The Python package as a page of Markdown: classes, methods and functions with their signatures and docstrings.

usage: api_python.py PACKAGE_FOLDER      writes to the standard output; imports nothing of the package
"""
import ast
import pathlib
import sys

INTERNAL = {"raw", "_c", "_root", "_values", "support"}  # modules that are not for users
PARTS = (("robots", ("__init__", "robot", "problems")), ("gym", ("__init__", "env", "task", "tasks")))  # those of packages within that are


def signature(node):
    arguments = ast.unparse(node.args)
    for first in ("self, /, ", "self, /", "self, ", "self", "cls, ", "cls"):
        if arguments.startswith(first):
            arguments = arguments[len(first):]
            break
    returns = f" -> {ast.unparse(node.returns)}" if node.returns and ast.unparse(node.returns) != "None" else ""
    return f"{node.name}({arguments}){returns}"


def documented(node):
    text = ast.get_docstring(node) or ""
    return text.replace("<", "&lt;").strip()


def is_property(node):
    return any(isinstance(d, ast.Name) and d.id in ("property", "cached_property") for d in node.decorator_list)


def is_setter(node):
    return any(isinstance(d, ast.Attribute) and d.attr in ("setter", "deleter") for d in node.decorator_list)


def function(node, owner=""):
    name = f"`{owner}{node.name}`" if is_property(node) else f"`{owner}{signature(node)}`"
    if is_property(node) and node.returns:
        name = f"`{owner}{node.name}: {ast.unparse(node.returns)}`"
    text = documented(node)
    return f"- {name}" + (f"\\\n  {' '.join(text.split())}" if text else "")


def fields(node):
    return [f"`{item.target.id}: {ast.unparse(item.annotation)}`" for item in node.body
            if isinstance(item, ast.AnnAssign) and isinstance(item.target, ast.Name)
            and not item.target.id.startswith("_")]


def public(node):
    return not node.name.startswith("_")


def class_page(node):
    bases = ", ".join(f"`{ast.unparse(base)}`" for base in node.bases
                      if not ast.unparse(base).startswith(("Protocol", "_", "Generic", "NamedTuple", "TypedDict")))
    out = [f"### {node.name}"] + ([""] + [documented(node)] if documented(node) else [])
    if bases:
        out += ["", f"Has all of {bases}, too."]
    made = [item for item in node.body if isinstance(item, ast.FunctionDef) and item.name == "__init__"]
    if made and documented(made[0]):
        out += ["", f"`{node.name}{signature(made[0])[len('__init__'):]}`\\\n{' '.join(documented(made[0]).split())}"]
    if fields(node):
        out += ["", "Fields: " + ", ".join(fields(node)) + "."]
    methods = [item for item in node.body
               if isinstance(item, ast.FunctionDef) and public(item) and not is_setter(item)]
    if methods:
        out += [""] + [function(item) for item in methods]
    return out + [""]


def main(folder):
    print("# The Python package, name by name\n")
    print("Written from the docstrings of `bindings/python/carom`.",
          "Defaults of keywords are those of the C descriptors.\n")
    package = pathlib.Path(folder)
    modules = [(f"carom.{path.stem}", path) for path in sorted(package.glob("*.py")) if path.stem not in INTERNAL]
    modules += [(f"carom.{part}.{stem}", package / part / f"{stem}.py") for part, stems in PARTS for stem in stems]
    for name, path in modules:
        told = path.with_suffix(".pyi")  # where classes are made as the module is read
        tree = ast.parse((told if told.exists() else path).read_text(encoding="utf-8"))
        classes = [node for node in tree.body if isinstance(node, ast.ClassDef) and public(node)]
        functions = [node for node in tree.body if isinstance(node, ast.FunctionDef) and public(node)]
        if not classes and not functions:
            continue
        print(f"## {name.removesuffix('.__init__')}", end="\n\n")
        if ast.get_docstring(tree):
            print(documented(tree), end="\n\n")
        if functions:
            print("\n".join(function(node) for node in functions), end="\n\n")
        for node in classes:
            print("\n".join(class_page(node)))


main(sys.argv[1])
