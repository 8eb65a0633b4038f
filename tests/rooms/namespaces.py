"""Finds namespaces that do not have the name of a folder, and headers of one module that share a basename.

    namespaces.py PROJECT

A file of include/kanexpr/M/ opens kanexpr, kanexpr::M, namespaces within it that have the name of a folder or the
basename in its own path, and `detail`. Unnamed namespaces, Eigen, std and forward declarations are exempt.
"""
import collections
import pathlib
import re
import sys

COMMENT_OR_LITERAL = re.compile(r'R"([^()\\ ]*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)
BRACE = re.compile(r"\bnamespace\s+(\w+(?:::\w+)*)?\s*\{|[{}]")
FORWARD = re.compile(r"(?:template <[^;{}()]*>\s*)?(?:struct|class|enum class) \w+;")
FORMATS = {"robots/urdf", "robots/sdf", "flexible/sid", "flexible/modes"} # parallel folders, in which files of one purpose have one name


def opened(text):
    """The namespaces in which a text defines something, as lists of names: ["kanexpr", "base"]."""
    code, found, names, blocks, end = COMMENT_OR_LITERAL.sub(" ", text), [], [], [["", 0]], 0
    for match in BRACE.finditer(code):
        blocks[-1][0] += code[end:match.start()]
        end = match.end()
        if match.group(0) != "}":
            blocks.append(["", len(names)])
            names += match.group(1).split("::") if match.group(1) else []
            continue
        content, outside = blocks.pop()
        if len(names) == outside:
            blocks[-1][0] += "{}"  # the body of a class or function
        elif FORWARD.sub("", content).strip():
            found.append(list(names))
        del names[outside:]
    return found


def is_allowed(names, file):
    """Whether a file, "base/status.hpp", may define something in a namespace."""
    if names[0] in ("Eigen", "std"):
        return True
    *folders, name = file.split("/")
    within = names[1:]
    if folders and within[:1] == folders[:1]:
        within = within[1:]
        return {*within} <= {"detail", name.split(".")[0], *folders[1:]}
    return names[0] == "kanexpr" and {*within} <= {"detail"}


def misnamed(files):
    for file, text in sorted(files.items()):
        for path in opened(text):
            if not is_allowed(path, file):
                yield f"{file} opens {'::'.join(path)}, which has the name of none of its folders"


def repeated(files):
    """Files of one module with the same basename, except an x.ipp or x.cpp next to its x.hpp."""
    seen = collections.defaultdict(set)
    for file in files:
        folder, _, name = file.rpartition("/")
        seen[file.split("/")[0] if folder else "", name.split(".")[0]].add(folder)
    for (module, name), folders in sorted(seen.items()):
        if len(folders) > 1 and not folders <= FORMATS:
            yield f"{module}: {name} is the basename of files in {', '.join(sorted(folders))}"


def files_in(project):
    root = project / "include/kanexpr"
    return {str(path.relative_to(root)): path.read_text() for path in root.rglob("*.*") if path.suffix in (".hpp", ".ipp", ".cpp")}


def test():
    """Cases that must be found, and cases that must not."""
    files = {
        "a/x.hpp": 'namespace kanexpr::a {\nnamespace detail {\nint f() { return 0; }\n}\nclass "}" y;\n}\nnamespace kanexpr {\nnamespace b {\nclass z;\n}\nint g(b::z);\n}\n',
        "a/x.ipp": "namespace kanexpr::b {\nint h();\n}\nnamespace Eigen {\nstruct traits {};\n}\n",
        "a/c/x.hpp": "namespace kanexpr::a {\nnamespace c {\nstruct s {};\n}\nnamespace x {\nint i;\n}\nnamespace d {\nstruct t {};\n}\n}\n",
    }
    found = list(misnamed(files))
    assert found == ["a/c/x.hpp opens kanexpr::a::d, which has the name of none of its folders",
                     "a/x.ipp opens kanexpr::b, which has the name of none of its folders"], found
    assert list(repeated(files)) == ["a: x is the basename of files in a, a/c"]
    assert not list(repeated(["a/x.hpp", "a/x.ipp", "b/x.hpp", "robots/urdf/y.hpp", "robots/sdf/y.hpp"]))


if __name__ == "__main__":
    test()
    files = files_in(pathlib.Path(sys.argv[1]))
    mistakes = [*misnamed(files), *repeated(files)]
    print(*mistakes, sep="\n")
    sys.exit(bool(mistakes))
