#!/usr/bin/env python3
"""single_header.py INCLUDE FILE: writes the headers that need only Eigen and Boost as one file.

INCLUDE is the folder include/ of kanexpr. Every header appears once, where it is first included. The compiled libraries
are not used: the definitions that they contain are part of the file. Comments are omitted, except the license.
"""

import pathlib
import re
import sys

ENTRIES = ["kanexpr", "joints", "reactions", "assemble", "fixed_step", "batch", "control", "symbolic", "algebra", "figures"]
INCLUDE = re.compile(r"^\s*#\s*include\s*<(kanexpr/[^>]+)>\s*$")
COMPILED = re.compile(r"^#ifndef KANEXPR_COMPILED_\w+\n(.*?)^#endif[^\n]*\n", re.M | re.S)
PIECE = re.compile(r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|//[^\n]*|/\*.*?\*/', re.S)


def without_comments(text):
    """The code with its literals, without comments and without lines that contain only comments."""
    text = PIECE.sub(lambda m: "" if m.group(0).startswith(("//", "/*")) else m.group(0), text)
    return re.sub(r"\n(?:[ \t]*\n)+", "\n", re.sub(r"[ \t]+\n", "\n", text))


def expand(folder, header, done, lines):
    if header in done:
        return
    done.add(header)
    text = COMPILED.sub(lambda m: m.group(1), (folder / header).read_text())
    for line in without_comments(text).split("\n"):
        include = INCLUDE.match(line)
        if include:
            expand(folder, include.group(1), done, lines)
        elif line and line != "#pragma once":
            lines.append(line)


def single_header(folder):
    license_lines = (folder.parent / "LICENSE").read_text().strip().split("\n")
    version = re.findall(r"#define KANEXPR_VERSION_\w+ (\d+)", (folder / "kanexpr/base/version.hpp").read_text())
    lines = [f"// kanexpr {'.'.join(version[:3])} in one header. Requires Eigen 3.4 and Boost 1.74; see docs/install.md.", "//"]
    lines += [f"// {line}".rstrip() for line in license_lines]
    lines.append("#pragma once")
    done = set()
    for entry in ENTRIES:
        expand(folder, f"kanexpr/{entry}.hpp", done, lines)
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 3 or not (pathlib.Path(sys.argv[1]) / "kanexpr/kanexpr.hpp").is_file():
        sys.exit("usage: single_header.py INCLUDE FILE, where INCLUDE contains kanexpr/kanexpr.hpp")
    pathlib.Path(sys.argv[2]).write_text(single_header(pathlib.Path(sys.argv[1]).resolve()))
