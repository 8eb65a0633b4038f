"""Finds phrases of plain_words.txt in comments and texts of the library, in its guides and in the README.

    plain_words.py PROJECT [--test]
"""
import pathlib
import re
import sys

LITERAL_OR_COMMENT = re.compile(r'R"([^()\\ ]*)\((.*?)\)\1"|"((?:\\.|[^"\\\n])*)"|//([^\n]*)|/\*(.*?)\*/|\'(?:\\.|[^\'\\\n])+\'', re.S)
INCLUDE = re.compile(r'^\s*#\s*include[^\n]*$', re.M)
CODE_IN_TEXT = re.compile(r'^```.*?^```[^\n]*$|`[^`\n]+`|\]\([^)]*\)|\$[^$\n]+\$', re.M | re.S)


def phrases(table):
    rows = (line.split("\t") for line in table.splitlines() if line and not line.startswith("#"))
    return [(re.compile(rf"(?<![\w-])(?:{pattern})(?![\w-])", re.I), advice) for pattern, advice in rows]


def blank(match):
    return re.sub(r"[^\n]", " ", match.group(0))


def prose_of_source(text):
    """Comments and string literals in their lines; code and what comments quote as code is blank."""
    text = INCLUDE.sub(blank, text)
    out, end = [], 0
    for match in LITERAL_OR_COMMENT.finditer(text):
        out.append(re.sub(r"[^\n]", " ", text[end:match.start()]))
        is_letter = match.group(0).startswith("'")
        out.append(blank(match) if is_letter else match.group(0))
        end = match.end()
    return CODE_IN_TEXT.sub(blank, "".join(out))


def prose_of_page(text):
    return CODE_IN_TEXT.sub(blank, text)


def found_in(name, prose, table):
    lines = prose.splitlines()
    joined = "\n".join(re.sub(r'^(\s*)(///?<?|\*|")', lambda m: " " * len(m.group(0)), line) for line in lines)
    for pattern, advice in table:
        for match in re.finditer(pattern.pattern.replace(" ", r"[\s\"]+"), joined, re.I):
            line = joined.count("\n", 0, match.start()) + 1
            yield f"{name}:{line}: “{' '.join(match.group(0).split())}”: {advice}"


def files(project):
    for pattern in ("include/**/*.hpp", "include/**/*.ipp", "include/**/*.cpp"):
        for path in sorted(project.glob(pattern)):
            yield path, prose_of_source
    for path in [*sorted(project.glob("docs/**/*.md")), *sorted(project.glob("include/**/*.md")), project / "README.md"]:
        yield path, prose_of_page


def check(project):
    table = phrases((pathlib.Path(__file__).parent / "plain_words.txt").read_text())
    return [each for path, prose_of in files(project)
            for each in found_in(path.relative_to(project), prose_of(path.read_text()), table)]


def test():
    """Cases that must be found, and cases that must not."""
    table = phrases("told\treport\nlooks at\tchecks\n")
    source = '#include "told.hpp"\nint told(int); // a rank that is\n// told\nf("it looks " "at it");\n/// `told` is code\n'
    found = [each.split(":")[1] for each in found_in("a.hpp", prose_of_source(source), table)]
    assert found == ["3", "4"], found
    page = "He told it.\n```cpp\ntold();\n```\n[link](told.md) `told`\nit looks\nat it, untold\n"
    found = [each.split(":")[1] for each in found_in("a.md", prose_of_page(page), table)]
    assert found == ["1", "6"], found


if __name__ == "__main__":
    test()
    mistakes = check(pathlib.Path(sys.argv[1]))
    print(*mistakes, sep="\n")
    sys.exit(bool(mistakes))
