#!/usr/bin/env python3
"""The pages of docs/coming-from and what compares them with other programs, without these programs.

    coming_from.py ROOT SNIPPETS
"""

import ast
import re
import sys
import tempfile
import unittest
import unittest.mock
import xml.etree.ElementTree
from pathlib import Path

ROOT, SNIPPETS = Path(sys.argv.pop(1)), Path(sys.argv.pop(1)) / "docs/coming-from"
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "bench/coming_from"))

import check
import words

OVERVIEWS = {"README", "forces"}  # pages without a program
PAGES = {path.stem: path.read_text() for path in (ROOT / "docs/coming-from").glob("*.md") if path.stem not in OVERVIEWS}
CODE = re.compile(r"`([^`]+)`")
COMMENT = re.compile(r"//.*")
WORD = re.compile(r'(?<!["\w])[a-z_][a-z_0-9]{3,}\b(?!")')  # what the library names; shorter names are those of a model
MADE_UP = {"theta", "guess", "state", "parameters", "options", "ratio", "rest", "frame"}  # values


def rows_of(page):
    table = page.split("\n## Words\n")[1].split("\n## ")[0]
    return [line for line in table.splitlines() if line.startswith("| ")][1:]


class Pages(unittest.TestCase):
    def test_each_page_is_compared(self):
        self.assertEqual(set(PAGES), set(check.PAGES))
        index = (ROOT / "docs/coming-from/README.md").read_text()
        for name in PAGES:
            self.assertIn(f"]({name}.md)", index)
            self.assertTrue((SNIPPETS / name / "printed.text").exists())
            self.assertTrue((SNIPPETS / name / "ours.cpp").exists())

    def test_the_other_program_is_complete(self):
        for name, page in check.PAGES.items():
            for block in [*page.files, *([f"{page.block}.python"] if page.block else [])]:
                text = (SNIPPETS / name / block).read_text()
                if block.endswith(".python"):
                    ast.parse(text)
                if block.endswith(".xml"):
                    xml.etree.ElementTree.fromstring(text)

    def test_code_fits_two_columns(self):
        for name in PAGES:
            for block in (SNIPPETS / name).iterdir():
                for line in block.read_text().splitlines():
                    self.assertLessEqual(len(line), 66, f"{name}: {line}")

    def test_words_of_the_other_program(self):
        words.MODULES["made up"] = ["statistics"]
        page = "\n## Words\n\n| | |\n|---|---|\n| `mean(x)`, `from_samples`, `meen(\"text\")` | `mass` |\n"
        self.assertEqual(words.unknown("made up", page), ["meen"])

    def library(self):
        sources = [*(ROOT / "include").rglob("*.[hi]pp"), *(ROOT / "cmake").glob("*.cmake")]
        return {word for path in sources for word in re.findall(r"\w+", COMMENT.sub("", path.read_text()))}

    def test_words_for_forces(self):
        library = self.library() | MADE_UP | {"shapes", "Tmax", "gaps", "least", "greatest", "mu_s", "mu_d"}
        page = (ROOT / "docs/coming-from/forces.md").read_text()
        tables = [[line for line in table.splitlines() if line.startswith("| ")]
                  for table in re.findall(r"(?:^\|.*\n)+", page, re.MULTILINE)]
        for rows in tables:
            self.assertTrue(all(row.count(" |") == rows[0].count(" |") for row in rows), "a row has a cell too many")
        rows = [row for table in tables for row in table]
        for row in rows:
            named = {word for code in CODE.findall(row.rsplit(" | ", 1)[-1]) for word in WORD.findall(code)}
            self.assertEqual(named - library, set(), row)

    def test_words(self):
        library = self.library()
        for name, page in PAGES.items():
            rows = rows_of(page)
            self.assertTrue(15 <= len(rows) <= 35, f"{name}.md has {len(rows)} words")
            for row in rows:
                ours = row.split(" | ", 1)[1]
                named = {word for code in CODE.findall(ours) for word in WORD.findall(code)}
                self.assertEqual(named - library - MADE_UP, set(), row)


class Comparison(unittest.TestCase):
    def test_differences(self):
        self.assertEqual(check.difference([1, 2], [1, 2]), 0)
        self.assertEqual(check.difference([1, 2.5], [1, 2]), 0.25)
        self.assertEqual(check.difference([1], [1, 2]), float("inf"))
        self.assertEqual(check.difference([], []), float("inf"))
        self.assertEqual(check.difference([float("nan"), 1], [1, 2]), float("inf"))

    def test_states(self):
        source = check.random.Random(1)
        for q, u, r in check.random_states(check.PAGES["mujoco"], source):
            self.assertAlmostEqual(sum(value * value for value in q[:4]), 1)
            self.assertEqual((len(q), len(u), len(r)), (5, 4, 1))

    def test_a_disagreement_is_reported(self):
        """A page whose program gives twice the acceleration, compared with one that squares its number."""
        blocks = Path(self.enterContext(tempfile.TemporaryDirectory()))
        (blocks / "theirs.python").write_text("def accelerations(q, u):\n    return [factor * q[0] * q[0]]\nfactor = 1\nprint(3)\n")
        (blocks / "printed.text").write_text("3\n")
        program = blocks / "square"
        program.write_text("#!/bin/sh\nwhile read -r q u; do echo \"$q\" | awk '{printf \"%.17g\\n\", $1 * $1}'; done\n")
        program.chmod(0o755)
        self.enterContext(unittest.mock.patch.dict(check.PAGES, square=check.Page(1, 1, 0, check.with_speeds)))
        apart, sentence = check.check("square", blocks, program)
        self.assertEqual(sentence, "")
        self.assertLess(apart, 1e-15)
        block = (blocks / "theirs.python").read_text()
        (blocks / "theirs.python").write_text(block.replace("factor = 1", "factor = 2"))
        self.assertRegex(check.check("square", blocks, program)[1], "^the accelerations differ by 1.0e")
        (blocks / "printed.text").write_text("4\n")
        self.assertRegex(check.check("square", blocks, program)[1], "^the program prints\n3\ninstead of\n4\n")


if __name__ == "__main__":
    unittest.main()
