"""The pages of the interface (include/pages): every function has its entry, once, and every link leads somewhere.

    python3 tests/bindings/test_pages.py
"""
import json
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "include" / "pages"
API = json.loads((ROOT / "bindings" / "api.json").read_text(encoding="utf-8"))
TEXT = {path.name: path.read_text(encoding="utf-8") for path in PAGES.glob("*.md")}
HEADINGS = {name: re.findall(r"^#+ (.*)$", text, re.MULTILINE) for name, text in TEXT.items()}


class Pages(unittest.TestCase):
    def test_one_page_a_header_and_no_other(self):
        self.assertEqual(set(TEXT), {h["name"].replace(".h", ".md") for h in API["headers"]} | {"index.md"})

    def test_every_function_and_struct_has_one_entry(self):
        entries = [heading for headings in HEADINGS.values() for heading in headings]
        for kind in ("functions", "structs", "callbacks"):
            for thing in API[kind]:
                self.assertEqual(entries.count(thing["name"]), 1, thing["name"])

    def test_every_constant_stands_on_its_page(self):
        for constant in API["constants"]:
            self.assertIn(f"| `{constant['name']}` |", TEXT[constant["header"].replace(".h", ".md")])

    def test_every_link_leads_to_a_heading(self):
        links = [(name, link) for name, text in TEXT.items() for link in re.findall(r"\]\(([^)]+)\)", text)]
        self.assertGreater(len(links), len(API["functions"]))
        for name, link in links:
            file, _, anchor = link.partition("#")
            self.assertIn(file, TEXT, f"{name}: {link}")
            if anchor:
                self.assertIn(anchor, [heading.lower() for heading in HEADINGS[file]], f"{name}: {link}")

    def test_the_index_has_every_function(self):
        listed = re.findall(r"^- \[`(\w+)`\]", TEXT["index.md"], re.MULTILINE)
        self.assertEqual(listed, sorted(f["name"] for f in API["functions"]))

    def test_no_cell_of_a_table_is_empty(self):
        tables = 0
        for name, text in TEXT.items():
            for line in text.split("\n"):
                if line.startswith("|"):
                    cells = re.split(r"(?<!\\)\|", line.strip())[1:-1]
                    self.assertTrue(all(cell.strip() for cell in cells), f"{name}: {line}: write it in the header")
                    tables += set(cells) == {"---"}
        self.assertGreater(tables, len(API["functions"]))

    def test_every_function_says_which_threads_may_call_it(self):
        for function in API["functions"]:
            entry = TEXT[function["header"].replace(".h", ".md")].split(f"### {function['name']}\n", 1)[1].split("\n### ")[0]
            self.assertRegex(entry, r"\nThreads: \S", function["name"])

    def test_what_a_call_may_answer_is_on_its_page(self):
        for function in API["functions"]:
            page = TEXT[function["header"].replace(".h", ".md")]
            entry = page.split(f"### {function['name']}\n", 1)[1].split("\n### ")[0]
            for status in function.get("status") or []:
                self.assertIn(f"`{status}`", entry, function["name"])


if __name__ == "__main__":
    unittest.main()
