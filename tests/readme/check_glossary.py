"""The glossary, src/GLOSSARY.md, is kept: one definition a term, and none of the words that it replaces in a README or
in a comment of a header. Code between backticks, fenced blocks, file names and identifiers do not count.

In C++ files of src the words of its table "not in src" stand nowhere: not in an identifier, a comment or a file's name.
Those of its table "not in texts" stand neither between quotes, where texts for users are, nor in a header's comment.

usage: check_glossary.py ROOT
"""

import re
import sys
from pathlib import Path

PAGES = ("README.md", "ABI.md", "CONTRIBUTING.md")
FOLDERS = ("include", "src", "plugins", "bindings", "tests")

# Folders of src whose texts are those of the library and of its program; where a word may stand in them: (word, text, why).
TEXTS = ("core", "collision", "dynamics", "abi", "tools/cli")
TEXT_KEPT = (
    ("rim", r"the rim of a coin|those of a rim between|cone's rim", "the edge circle of a disc, cylinder or cone"),
    ("who", r'^"who"$', "a key of the file that `carom jury` writes"),
)

# Where a word of that table may stand in src: (words, file, line, why). One that is not in use is a problem.
RIM = "the field's word for the edge circle of a disc, cylinder, cone or wheel"
KEPT = (
    ("rim", r"collision/(core\.h|volume\.cpp)", r"", RIM),
    ("rim", r"collision/manifold/(cache|facet|manifold|patch)\.", r"", RIM),
    ("rim rims", r"collision/narrow/(coaxial|pair|pair_half_space|narrow_phase)\.", r"", RIM),
    ("rim", r"dynamics/contact/(mean_motion|rolling|slide)\.", r"", RIM),
    ("rim", r"tools/(accuracy/(friction/coin|reference)|check/sets)\.", r"", RIM),
    ("rims", r"tools/scenefile/geometry\.", r"", RIM),
)


def rows(page):
    """[(terms, meaning, words instead of which)] of all tables"""
    found = []
    for line in page.read_text(encoding="utf-8").split("\n"):
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if line.startswith("|") and len(cells) == 3 and cells[0] != "term" and not set(cells[0]) <= {"-"}:
            split = lambda cell: [part.strip() for part in cell.split(",") if part.strip()]  # noqa: E731
            found.append((split(cells[0]), cells[1], split(cells[2])))
    return found


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def prose_of_page(text):
    text = re.sub(r"^```.*?^```", blank, text, flags=re.S | re.M)
    text = re.sub(r"`[^`\n]*`|<!--.*?-->", blank, text, flags=re.S)
    return "\n".join("" if line.startswith("    ") else line for line in text.split("\n"))


def prose_of_header(text):
    """Comments alone, on their lines."""
    out, end = [], 0
    for comment in re.finditer(r"/\*.*?\*/", text, flags=re.S):
        out.append(blank(re.match(r".*", text[end : comment.start()], flags=re.S)))
        out.append(re.sub(r"`[^`\n]*`", blank, comment.group()))
        end = comment.end()
    return "".join(out)


def code_words(page, heading):
    """{word: what to say instead}, of the page's table of two columns whose first is headed so"""
    table, inside = {}, False
    for line in page.read_text(encoding="utf-8").split("\n"):
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if not line.startswith("|") or len(cells) != 2:
            inside = False
        elif cells[0] == heading:
            inside = True
        elif inside and not set(cells[0]) <= {"-"}:
            table.update({word.strip(): cells[1] for word in cells[0].split(",")})
    return table


def without_texts(text):
    """C++ with blanks between quotes; names of included files stay."""
    quoted = re.compile(
        r'//[^\n]*|/\*.*?\*/|#include[^\n]*|R"([^()\s]*)\(.*?\)\1"|"(?:[^"\\\n]|\\.)*"|(?<!\w)\'(?:[^\'\\\n]|\\.)+\'',
        flags=re.S,
    )
    return quoted.sub(lambda m: m.group() if m.group()[0] in "/#" else blank(m), text)


def words_of(line):
    """Its words, small: Kept_by_kRim has kept, by, k and rim."""
    return [word.lower() for word in re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+", line)]


def check_code(root, table, problems):
    kept_in_use = set()
    files = sorted(file for file in (root / "src").rglob("*") if file.suffix in (".h", ".cpp"))
    for file in files:
        name = str(file.relative_to(root / "src"))
        text = file.read_text(encoding="utf-8")
        lines = [(0, name)] + list(enumerate(without_texts(text).split("\n"), 1))
        for at, line in lines:
            for word in words_of(line):
                if word not in table:
                    continue
                kept = [
                    i
                    for i, (words, where, how, _) in enumerate(KEPT)
                    if word in words.split() and re.search(where, name) and re.search(how, line)
                ]
                kept_in_use.update(kept)
                if not kept:
                    problems.append(f"src/{name}:{at}: {word}: {table[word]}")
    for i, (words, where, how, why) in enumerate(KEPT):
        if i not in kept_in_use:
            problems.append(f"KEPT: no {words} in {where or 'any file'} ({why})")
    if len(files) < 500 or len(table) < 15:
        sys.exit(f"only {len(files)} files and {len(table)} words of code: this check no longer reads src")
    return len(files)


def check_texts(root, table, problems):
    """Texts between quotes, and comments of the headers."""
    pattern = re.compile(r"(?<![\w.-])(" + "|".join(f"[{w[0].upper()}{w[0]}]{w[1:]}" for w in table) + r")(?![\w-])")
    kept_in_use, texts = set(), []
    for folder in TEXTS:
        for file in sorted((root / "src" / folder).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            text = file.read_text(encoding="utf-8")
            token = re.compile(r'//[^\n]*|/\*.*?\*/|#include[^\n]*|"(?:[^"\\\n]|\\.)*"|(?<!\w)\'(?:[^\'\\\n]|\\.)+\'', flags=re.S)
            for found in token.finditer(text):
                if found.group().startswith('"'):
                    texts.append((file, text.count("\n", 0, found.start()) + 1, found.group()))
    for header in sorted((root / "include").rglob("*.h")):
        prose = prose_of_header(header.read_text(encoding="utf-8"))
        texts += [(header, at, line) for at, line in enumerate(prose.split("\n"), 1) if line.strip()]
    for file, at, text in texts:
        for found in pattern.findall(text):
            word = found.lower()
            kept = [i for i, (of, where, _) in enumerate(TEXT_KEPT) if word == of and re.search(where, text)]
            kept_in_use.update(kept)
            if not kept:
                problems.append(f"{file.relative_to(root)}:{at}: {found}: {table[word]}")
    problems += [f"TEXT_KEPT: no {of} in {where}" for i, (of, where, _) in enumerate(TEXT_KEPT) if i not in kept_in_use]
    if len(texts) < 3000 or len(table) < 20:
        sys.exit(f"only {len(texts)} texts and {len(table)} words: this check no longer reads them")
    return len(texts)


def main():
    root = Path(sys.argv[1])
    glossary = root / "src/GLOSSARY.md"
    problems, seen, replaced = [], {}, {}
    for terms, meaning, instead in rows(glossary):
        for term in terms:
            if term in seen:
                problems.append(f"{glossary.name}: {term} is defined twice")
            seen[term] = meaning
        if not meaning:
            problems.append(f"{glossary.name}: {', '.join(terms)} has no meaning")
        for word in instead:
            if word in replaced:
                problems.append(f"{glossary.name}: {word} stands for two terms")
            replaced[word] = " or ".join(terms)
    for word in replaced:
        if word in seen:
            problems.append(f"{glossary.name}: {word} is a term and a word to avoid")
    if len(seen) < 40 or len(replaced) < 20:
        sys.exit(f"only {len(seen)} terms and {len(replaced)} words: this check no longer reads {glossary}")
    # As a sentence has them: small, or with a capital at its beginning. Capitals throughout are identifiers.
    pattern = re.compile(
        r"(?<![\w/.-])("
        + "|".join(
            f"[{word[0].upper()}{word[0]}]" + re.escape(word[1:]) for word in sorted(replaced, key=len, reverse=True)
        )
        + r")(?![\w/-])"
    )
    files = [root / name for name in PAGES]
    for folder in FOLDERS:
        files += [page for page in sorted((root / folder).rglob("README.md")) if "node_modules" not in page.parts]
    files += sorted((root / "include").rglob("*.h"))
    for file in files:
        text = file.read_text(encoding="utf-8")
        prose = prose_of_header(text) if file.suffix == ".h" else prose_of_page(text)
        for at, line in enumerate(prose.split("\n"), 1):
            for found in pattern.findall(line):
                word = found[0].lower() + found[1:]
                problems.append(f"{file.relative_to(root)}:{at}: {found}: {replaced[word]}")
    table = code_words(glossary, "not in src")
    sources = check_code(root, table, problems)
    text_table = code_words(glossary, "not in texts")
    texts = check_texts(root, text_table, problems)
    if problems:
        sys.exit("\n".join(problems) + f"\n{len(problems)} places; src/GLOSSARY.md has the words")
    print(f"{len(seen)} terms, {len(replaced)} words to avoid, {len(files)} files")
    print(f"{len(table)} words that code does not have, {sources} files of src")
    print(f"{len(text_table)} words that texts do not have, {texts} texts and lines of comments")


main()
