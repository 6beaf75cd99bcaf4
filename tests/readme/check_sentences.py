"""Words a sentence, page by page: README.md files and the headers of include/carom may average 20 at most.

What counts is prose: paragraphs and list items of a page, the text before the first @tag of a header's comments. Code,
tables, headings and @param lines don't. A sentence ends at . ! or ? before a space and a capital, or where its paragraph
or item ends; a colon or semicolon ends none. Code between backticks is one word. NOTES.md files are not measured.

usage: check_sentences.py ROOT [PAGE ...]     prints a line a page, and exits 1 if one is beyond the bound
"""

import re
import sys
from pathlib import Path

MOST = 20  # words a sentence, on average
LONGEST = 60  # words in one sentence: beyond it nobody finds the verb
FEW = 3  # pages of fewer sentences have no average worth the name
FOLDERS = ("include", "src", "plugins", "bindings", "tests")
ALSO = ("README.md", "ABI.md", "CONTRIBUTING.md", "SECURITY.md")


def markdown_blocks(text):
    """Paragraphs and list items, as text."""
    text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
    text = re.sub(r"^(```|~~~).*?^\1\s*$", "\n", text, flags=re.S | re.M)
    block, in_list = [], False
    for line in text.split("\n") + [""]:
        item = re.match(r"\s*(?:[-*]|\d+\.)\s+(.*)", line)
        if item:
            yield " ".join(block)
            block, in_list = [item.group(1)], True
        elif not line.strip():
            yield " ".join(block)
            block = []
        elif re.match(r"#|\||!\[|>", line.strip()) or (line.startswith("    ") and not block and not in_list):
            yield " ".join(block)
            block = []
        else:
            in_list = in_list and line.startswith(" ")
            block.append(line.strip())


def header_blocks(text):
    """What the comments say before their first @tag, paragraph by paragraph; @file's own line is prose."""
    for comment in re.findall(r"/\*\*(?!<)(.*?)\*/", text, flags=re.S):
        lines = [re.sub(r"^\s*\*? {0,2}", "", line) for line in comment.split("\n")]
        prose = re.sub(r"@file \S+", "", "\n".join(lines))
        prose = re.split(r"@\w+", prose)[0]
        block = []
        for line in prose.split("\n") + [""]:
            if not line.strip() or line.startswith("  "):  # an indented line is a table of a comment
                yield " ".join(block)
                block = []
            else:
                block.append(line.strip())


def sentences(block):
    block = re.sub(r"``[^`]*``|`[^`]*`", "Code", block)
    block = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", block)
    block = re.sub(r"[*_]{2}", "", block)
    block = re.sub(r"\b(e\.g|i\.e|vs|cf|fig|resp)\.", r"\1", block, flags=re.I)
    for sentence in re.split(r"(?<=[.!?])[)\"']*\s+(?=[\"'(]*[A-Z0-9])", block):
        words = [w for w in sentence.split() if re.search(r"\w", w)]
        if len(words) > 1:
            yield words


def measure(page):
    text = page.read_text(encoding="utf-8")
    blocks = header_blocks(text) if page.suffix == ".h" else markdown_blocks(text)
    return [s for block in blocks for s in sentences(block)]


def pages_of(root):
    found = [root / name for name in ALSO]
    for folder in FOLDERS:
        found += [page for page in sorted((root / folder).rglob("README.md")) if "node_modules" not in page.parts]
    return found + sorted((root / "include").rglob("*.h"))


def main():
    root = Path(sys.argv[1])
    pages = [root / name for name in sys.argv[2:]] or pages_of(root)
    wrong = []
    print("mean  longest  sentences  page")
    for page in pages:
        found = measure(page)
        if not found:
            continue
        mean, longest = sum(map(len, found)) / len(found), max(found, key=len)
        beyond = len(found) >= FEW and mean > MOST or len(longest) > LONGEST
        print(
            f"{mean:4.1f}  {len(longest):7}  {len(found):9}  {page.relative_to(root)}{'   <-- beyond' if beyond else ''}"
        )
        if beyond:
            wrong.append((page, longest))
    for page, longest in wrong:
        print(
            f"\n{page.relative_to(root)}: its longest sentence has {len(longest)} words: {' '.join(longest[:25])} ..."
        )
    if wrong:
        sys.exit(
            f"\n{len(wrong)} pages are beyond {MOST} words a sentence, or have one of more than {LONGEST}: split them, "
            "or move what was measured to NOTES.md beside the page"
        )


if __name__ == "__main__":
    main()
