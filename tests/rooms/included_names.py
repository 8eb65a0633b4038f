"""Finds headers that use one of the names of included_names.txt without including its header.

    included_names.py PROJECT [--fix]

A header that the defining header needs itself is exempt, and so is a forward declaration.
"""
import pathlib
import re
import sys

COMMENT_OR_LITERAL = re.compile(r'R"([^()\\ ]*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)
INCLUDE = re.compile(r'^#include <([^>]+)>', re.M)
FORWARD = re.compile(r'^(?:struct|class|enum class) \w+;', re.M)


def rows(table):
    for line in table.splitlines():
        if line and not line.startswith("#"):
            pattern, header = line.split("\t")
            yield re.compile(rf"(?<![\w:.>])(?:{pattern})(?:(?<=[<&*])|(?!\w))"), header


def code_of(text):
    """Without comments, texts and forward declarations; names of namespaces are blank, to find qualified names too."""
    text = FORWARD.sub("", COMMENT_OR_LITERAL.sub(" ", INCLUDE.sub("", text)))
    return re.sub(r"\b(?:kanexpr|symbolic|mechanics|compiled|lower|deriving|derive|graphs)::", "", text)


def reaches(headers, start, goal):
    """Whether one header includes another, directly or indirectly."""
    seen, stack = set(), [start]
    while stack:
        here = stack.pop()
        if here == goal:
            return True
        if here in headers and here not in seen:
            seen.add(here)
            stack += INCLUDE.findall(headers[here])
    return False


def missing(headers, table):
    for name, text in sorted(headers.items()):
        code, included = code_of(text), set(INCLUDE.findall(text))
        for pattern, header in table:
            is_there = header in included or (header.endswith("/") and any(each.startswith(header) for each in included))
            if is_there or name == header or not pattern.search(code) or reaches(headers, header, name):
                continue
            yield name, header


def add(text, header):
    line = f"#include <{header}>\n"
    own, others = [m for m in INCLUDE.finditer(text) if m.group(1).startswith("kanexpr/")], list(INCLUDE.finditer(text))
    is_own = header.startswith("kanexpr/")
    block = own if is_own else [m for m in others if "/" not in m.group(1) and m not in own]
    if block:
        place = next((m.start() for m in block if m.group(1) > header), block[-1].end() + 1)
        return text[:place] + line + text[place:]
    if not others:
        place = text.index("#pragma once\n") + len("#pragma once\n")
        return text[:place] + "\n" + line + text[place:]
    if is_own:
        return text[:others[0].start()] + line + "\n" + text[others[0].start():]
    return text[:others[-1].end() + 1] + "\n" + line + text[others[-1].end() + 1:]


def headers_in(project):
    root = project / "include"
    return {str(path.relative_to(root)): path.read_text() for path in root.rglob("*.[hi]pp")}


def test():
    """Cases that must be found, and cases that must not."""
    table = list(rows("sequence<\tkanexpr/base/sequence.hpp\nstd::array\tarray\nEigen::\\w+\tEigen/"))
    headers = {
        "kanexpr/base/sequence.hpp": "#pragma once\n#include <kanexpr/base/below.hpp>\n",
        "kanexpr/base/below.hpp": "#pragma once\nsequence<int> a();\n",
        "kanexpr/a.hpp": "#pragma once\n// std::array\nkanexpr::sequence<int> a(std::array<int, 2>);\nstruct array;\n",
        "kanexpr/b.hpp": "#pragma once\n\n#include <Eigen/Core>\n\n#include <array>\nEigen::Vector3d b(std::array<int, 2>);\n",
    }
    assert list(missing(headers, table)) == [("kanexpr/a.hpp", "kanexpr/base/sequence.hpp"), ("kanexpr/a.hpp", "array")]
    assert add(headers["kanexpr/b.hpp"], "vector").endswith("#include <array>\n#include <vector>\nEigen::Vector3d b(std::array<int, 2>);\n")


if __name__ == "__main__":
    test()
    project = pathlib.Path(sys.argv[1])
    table = list(rows((pathlib.Path(__file__).parent / "included_names.txt").read_text()))
    headers = headers_in(project)
    found = list(missing(headers, table))
    if "--fix" in sys.argv:
        for name, header in found:
            path = project / "include" / name
            path.write_text(add(path.read_text(), header + "Core" if header.endswith("/") else header))
    for name, header in found:
        print(f"include/{name} uses names of <{header}> and does not include it")
    sys.exit(bool(found))
