"""Finds public names without a documentation comment, and public names that no example uses.

    public_names.py PROJECT

A name is public if a header that include/kanexpr/*.hpp reaches declares it directly in namespace kanexpr, or if it is
in the namespace of a module and code in a guide or an example writes it with this namespace, as in symbolic::print.
Operators and forward declarations are not names. Examples are the blocks of C++ in README.md and docs/, and the files
of examples/. The reference on the site (docs/site/reference.py) takes its names and examples from here.
"""
import collections
import dataclasses
import pathlib
import re
import sys

INCLUDE = re.compile(r"^#include <(kanexpr/[^>]+\.hpp)>", re.M)
NOT_CODE = re.compile(r'R"([^()\\ ]*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])\''
                      r'|^#(?:[^\n]*\\\n)*[^\n]*', re.S | re.M)
ENTITY = re.compile(r"(struct|class|union|enum class|enum|concept) (\w+)(.?)")
QUALIFIED = re.compile(r"(?<![\w:.>])(?:kanexpr::)?(\w+)::(\w+)")
BLOCK = re.compile(r"^```cpp (\w+)\n(.*?)^```", re.M | re.S)
ENDS = re.compile(r"[{;}]$|^[A-Z_]+\(.*\)$")  # a line with which a declaration ends, or its body begins
ENTRY = re.compile(r"(struct|using|constexpr) .*;(\s*//.*)?$")
ITEM = re.compile(r"^\S.*,(\s*//.*)?$")
INSIDE = {"docs/extending.md", "docs/how-it-works.md", "docs/releasing.md"}  # pages for those who change the library
PROGRAMS = ("examples/gallery/", "examples/playground/")  # programs on top of the modules, which use their insides
APART = ("docs/reference/", "docs/coming-from/")  # pages whose examples are shown only for names that no other page uses


@dataclasses.dataclass
class Declaration:
    namespace: str  # "kanexpr::symbolic"
    kind: str  # "struct", "class", "enum class", "concept", "using", "function" or "variable"
    name: str
    is_template: bool
    header: str  # "kanexpr/describe/frame.hpp"
    line: int
    comment: str


@dataclasses.dataclass
class Example:
    page: str  # "docs/guide/forces.md" or "examples/bicycle.cpp"
    name: str  # of the block; empty for a file
    text: str


def blanked(text, keeps_documentation=False):
    """A text whose literals, directives and comments are blank, or all but documentation comments in the first column."""
    def blank(match):
        is_documentation = keeps_documentation and match.group(0).startswith("///") and text[match.start() - 1] == "\n"
        return match.group(0) if is_documentation else re.sub(r"[^\n]", "", match.group(0))

    return re.sub(r"[ \t]+$", "", NOT_CODE.sub(blank, text), flags=re.M)


def flat(text):
    """A text without what stands between angle brackets."""
    while (shorter := re.sub(r"<[^<>]*>", "", text)) != text:
        text = shorter
    return text


def named(declarator):
    """The kind and the name that the text of a declaration introduces, or nothing."""
    declarator = re.sub(r"\[\[.*?\]\] ?", "", declarator)
    if match := ENTITY.match(declarator):
        return None if match.group(3) in ("<", ":", ";") else (match.group(1), match.group(2))
    if match := re.match(r"using (?:[\w:]+::)?(\w+)\s*(?:=|;)", declarator):
        return "using", match.group(1)
    if match := re.match(r"KANEXPR_(?:COMPOSED_)?FUNCTION\((\w+)", declarator):
        return "function", match.group(1)
    if declarator.startswith(("using", "static_assert", "extern", "friend", "KANEXPR_UNSUPPORTED_")):
        return None
    front, after, _ = re.split(r"([({=;])", flat(declarator), maxsplit=1)
    match = re.search(r"(?<!::)\b(\w+)\s*$", front)
    if not match or re.search(r"\boperator\b", front):
        return None
    return ("function" if after == "(" else "variable"), match.group(1)


def is_prefix(line):
    return line.startswith(("template <", "  requires"))


def head(lines):
    """The text of a declaration behind template parameters and constraints, up to a body."""
    end = next(i for i, line in enumerate(lines) if not is_prefix(line) and ENDS.search(line)) + 1
    start = max(i for i, line in enumerate(lines[:end]) if line[:1] not in ("", " ") and not is_prefix(line))
    return " ".join(line.strip() for line in lines[start:end])


def is_whole(lines):
    """Whether lines are a whole declaration, with its body."""
    last, text = lines[-1], "".join(lines)
    if text.count("{") != text.count("}") or is_prefix(last):
        return False
    return ENDS.search(last) is not None


def declarations(header, text):
    """What a formatted header declares in namespaces: a line in the first column begins a declaration."""
    lines = blanked(text, keeps_documentation=True).splitlines()
    scopes, comment, place = [], [], 0
    while place < len(lines):
        line = lines[place]
        if line.startswith("///"):
            comment.append(line.removeprefix("///").strip())
            place += 1
            continue
        first = place
        place += 1
        if match := re.match(r"(?:inline )?namespace([\w: ]*)\{", line):
            scopes.append(match.group(1).strip())
        elif line.startswith("}") and scopes:
            scopes.pop()
        elif re.match(r"[A-Za-z_\[]", line):
            while not is_whole(lines[first:place]):
                place += 1
                if place > len(lines):
                    sys.exit(f"{header}:{first + 1}: this declaration does not end")
            declarator = head(lines[first:place])
            if found := named(declarator):
                is_template = line.startswith("template <")
                yield Declaration("::".join(scopes), *found, is_template, header, first + 1, "\n".join(comment))
        comment = []


def reached(project, headers):
    """The headers that some headers reach, themselves among them, each with its text."""
    root, texts, waiting = project / "include", {}, list(headers)
    while waiting:
        header = waiting.pop()
        if header not in texts:
            texts[header] = (root / header).read_text()
            waiting += INCLUDE.findall(texts[header])
    return texts


def examples(project):
    for page in [project / "README.md", *sorted(project.glob("docs/**/*.md"))]:
        where = str(page.relative_to(project))
        if where not in INSIDE:
            yield from (Example(where, name, text) for name, text in BLOCK.findall(page.read_text()))
    for path in sorted(project.glob("examples/**/*.[ch]pp")):
        if path.relative_to(project).as_posix().startswith(PROGRAMS):
            continue
        yield Example(str(path.relative_to(project)), "", path.read_text())


def public_names(project):
    """The declarations of each public name, by its name with its namespace except kanexpr."""
    code = [blanked(each.text) for each in examples(project)]
    written = {"::".join(pair) for each in code for pair in QUALIFIED.findall(each)}
    starts = [f"kanexpr/{path.name}" for path in (project / "include/kanexpr").glob("*.hpp")]
    starts += [header for each in examples(project) for header in INCLUDE.findall(each.text)]
    names = collections.defaultdict(list)
    for header, text in sorted(reached(project, starts).items()):
        for each in declarations(header, text):
            name = f"{each.namespace}::{each.name}".removeprefix("kanexpr::")
            if each.namespace == "kanexpr" or name in written:
                names[name].append(each)
    for found in names.values():
        found.sort(key=lambda each: ("/diagnostics/" in each.header, not each.comment))
    return {name: found for name, found in sorted(names.items())
            if not any(each.comment.startswith("@internal") for each in found)}


def use_of(name, found):
    """A pattern that finds the name where code uses it."""
    is_function, is_template = all(each.kind == "function" for each in found), all(each.is_template for each in found)
    after = "(?=[(<])" if is_function else r"(?=<| \w+[({ ])" if is_template else ""
    return re.compile(rf"(?:(?<![\w.>:])(?<!auto )(?<!using )|(?<=kanexpr::)){name}\b{after}(?! =|\.|->)")


def parts(example):
    """An example as it is shown: a block of a page, an entry of a list, or what stands between blank lines of longer ones."""
    lines = example.text.splitlines()
    short = example.name and len(lines) <= 16
    if example.name and (all(ENTRY.match(each) for each in lines) or all(ITEM.search(each) for each in lines[:-1])):
        found = lines
    else:
        found = [example.text] if short else re.split(r"\n\s*\n", example.text)
    for part in found:
        shown = re.sub(r"^(?:\} // )?namespace.*\n?", "", part, flags=re.M).strip("\n")
        yield Example(example.page, example.name, re.sub(r"(?<=\S) +(?= //|[:=] )", " ", shown) if found is lines else shown)


def examples_of(project, names):
    """The shortest example of each name that has one: in the guide, else in a page apart from it, else in a file."""
    all_parts = [part for each in examples(project) for part in parts(each)]
    all_parts.sort(key=lambda each: (not each.name, each.page.startswith(APART), len(each.text)))
    code = [blanked(each.text) for each in all_parts]
    found = {}
    for name, declared in names.items():
        pattern, bare = use_of(name, declared), name.split("::")[-1]
        place = next((i for i, each in enumerate(code) if bare in each and pattern.search(each)), None)
        if place is not None:
            found[name] = all_parts[place]
    return found


def complaints(project):
    names = public_names(project)
    shown = examples_of(project, names)
    for name, found in names.items():
        if not any(each.comment for each in found):
            yield f"{found[0].header}: {name} has no documentation comment"
        if name not in shown:
            yield f"{found[0].header}: {name} has no example in README.md, docs/ or examples/"


def test():
    """What has to be found, and what has not."""
    header = """#include <kanexpr/b.hpp>
namespace kanexpr {
class forward;
/// A word.
template <class Self, bool is = requires { sizeof(Self); }>
struct word : base<Self> {
  /// A member.
  int member() const { return '}'; }
};
template <class Number>
  requires(std::is_class_v<Number> &&
           is_number<Number>)
struct word<Number> {};
inline constexpr int count{2};
constexpr std::array<int, 2> pair(int x,
                                  int y) {
  return {x, y};
}
/// @internal For C++.
using hidden = int;
bool operator==(word<int>, int) { return true; }
KANEXPR_FUNCTION(sine)
KANEXPR_UNSUPPORTED_FUNCTION(floor)
namespace module {
enum class kind { first };
}
} // namespace kanexpr
"""
    found = [(each.namespace, each.kind, each.name, each.comment) for each in declarations("kanexpr/a.hpp", header)]
    assert found == [("kanexpr", "struct", "word", "A word."), ("kanexpr", "variable", "count", ""),
                     ("kanexpr", "function", "pair", ""), ("kanexpr", "using", "hidden", "@internal For C++."),
                     ("kanexpr", "function", "sine", ""), ("kanexpr::module", "enum class", "kind", "")], found
    by_name = {each.name: [each] for each in declarations("kanexpr/a.hpp", header)}
    for name, code, is_used in [("word", "struct W : word<W> {};", True), ("word", "word w = x;", True), ("word", "f(word);", False),
                                ("word", "std::word<int> w;", False), ("pair", "f(kanexpr::pair(1, 2));", True),
                                ("pair", "auto pair = x.pair(1);", False),
                                ("hidden", "using hidden = int;", False), ("count", "x.count + count", True)]:
        assert bool(use_of(name, by_name[name]).search(blanked(code))) == is_used, (name, code)


if __name__ == "__main__":
    test()
    mistakes = list(complaints(pathlib.Path(sys.argv[1])))
    print(*mistakes, sep="\n")
    sys.exit(bool(mistakes))
