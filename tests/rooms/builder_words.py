"""Finds words of types that a builder lacks.

    builder_words.py PROJECT

A word is a public name that a header of include/kanexpr/describe/ declares. It must be the name of a function of the
builder, or builder_words.txt must state what takes its place.
"""
import pathlib
import re
import sys

import public_names

FUNCTION = re.compile(r"^  (?:static |constexpr |template <.*> )*[\w:<>&]+ (\w+)\(", re.M)


def words(names):
    return {name for name, found in names.items() if any("/describe/" in each.header for each in found)}


def functions(texts):
    """The names of the public functions that some headers declare."""
    return {name for text in texts for part in re.findall(r"^public:\n(.*?)(?=^(?:protected|private):|^\})", text, re.M | re.S)
            for name in FUNCTION.findall(part)}


def replaced(table):
    rows = [line.split("\t") for line in table.splitlines() if line and not line.startswith("#")]
    return {word: instead for listed, instead in rows for word in listed.split()}


def complaints(all_words, functions_there, instead):
    for word in sorted(all_words - functions_there - set(instead)):
        yield f"{word} is a word of types, but not of a builder; add a function, or a row to builder_words.txt"
    for word in sorted(set(instead) - all_words):
        yield f"builder_words.txt lists {word}, which is not a word of types"
    for word in sorted(set(instead) & functions_there):
        yield f"builder_words.txt lists {word}, which is a function of a builder"


def test():
    """What has to be found, and what has not."""
    header = "class a {\npublic:\n  void drag(int);\n  expression length_of(int along);\nprotected:\n  int b();\nprivate:\n  int c();\n};\n"
    there = functions([header])
    assert there == {"drag", "length_of"}, there
    found = list(complaints({"drag", "loads", "spring"}, there, {"loads": "", "drag": "", "gone": ""}))
    assert found == ["spring is a word of types, but not of a builder; add a function, or a row to builder_words.txt",
                     "builder_words.txt lists gone, which is not a word of types",
                     "builder_words.txt lists drag, which is a function of a builder"], found


if __name__ == "__main__":
    test()
    project = pathlib.Path(sys.argv[1])
    runtime = project / "include/kanexpr/runtime"
    texts = [path.read_text() for path in [runtime / "builder.hpp", *runtime.glob("building/*_builder.hpp")]]
    table = (pathlib.Path(__file__).parent / "builder_words.txt").read_text()
    mistakes = list(complaints(words(public_names.public_names(project)), functions(texts), replaced(table)))
    print(*mistakes, sep="\n")
    sys.exit(bool(mistakes))
