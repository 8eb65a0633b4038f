#!/usr/bin/env python3
"""reference.py ROOT XML FOLDER: writes the pages of the reference to FOLDER, from the XML that Doxygen generated from the headers.

tests/rooms/public_names.py decides which names are public and finds their examples. Breathe, which shows Doxygen's XML in
Sphinx, would show neither examples nor the members that classes inherit from internal bases.
"""

import pathlib
import re
import shutil
import sys
import textwrap
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "tests/rooms"))
import public_names
from comments import Comments, first_sentence, label
from reference_pages import PAGES, place_of
from signatures import signature, template_of, text_of, tidy

WORDS = re.compile(r"kanexpr/(describe/(?!symbol_name)|animate/(elements|shapes|picture))")  # whose members are axes or internal
HIDDEN_TYPES = re.compile(r"\b(?:describe|derivation|mechanics|compiled|animate|lower|steps|symbolic::graph)::|_record\b|\bphrase\b")
HIDDEN_NAMES = re.compile(r"^~|_$|^fields$|^each_member$")  # destructors, private names and serialization


class Reference:
    """The public names with their examples, and what Doxygen knows of them."""

    def __init__(self, root, xml):
        self.root, self.xml = root, xml
        self.names = public_names.public_names(root)
        self.examples = public_names.examples_of(root, self.names)
        self.first = {name: min((each for each in found if "/diagnostics/" not in each.header),
                                key=lambda each: (not each.comment, place_of(each.header)[1])) for name, found in self.names.items()}
        self.included = {each for page in public_names.examples(root) for each in public_names.INCLUDE.findall(page.text)}
        self.comments = Comments(root, self.names)
        self.compounds, self.members, self.umbrellas = {}, {}, self.reach_of_umbrellas()
        for each in ElementTree.parse(xml / "index.xml").getroot():
            name, kind = each.find("name").text, each.get("kind")
            if kind in ("struct", "class", "concept") and name.startswith("kanexpr::"):
                self.compounds.setdefault(name.removeprefix("kanexpr::"), each.get("refid"))
            elif kind == "namespace" and name.split("::")[0] == "kanexpr":
                self.read_namespace(name, each.get("refid"))

    def read_namespace(self, name, refid):
        prefix = name.removeprefix("kanexpr").removeprefix("::")
        for member in self.compound(refid).iter("memberdef"):
            key = f"{prefix}::{member.find('name').text}" if prefix else member.find("name").text
            self.members.setdefault(key, []).append(member)

    def compound(self, refid):
        return ElementTree.parse(self.xml / f"{refid}.xml").getroot().find("compounddef")

    def reach_of_umbrellas(self):
        """The headers of include/kanexpr/ with the headers that they include, directly or indirectly; smallest first."""
        headers = [f"kanexpr/{path.name}" for path in (self.root / "include/kanexpr").glob("*.hpp")]
        found = {header: public_names.reached(self.root, [header]) for header in headers}
        return dict(sorted(found.items(), key=lambda pair: len(pair[1])))

    def header_of(self, header):
        """The header to include: kanexpr.hpp or symbolic.hpp, or one that names the module, or the header itself."""
        module = "/".join(header.split("/")[:2]) + "/"
        reaching = [each for each, reach in self.umbrellas.items() if header in reach]
        core = [each for each in ("kanexpr/kanexpr.hpp", "kanexpr/symbolic.hpp") if each in reaching]
        counts = {each: sum(included.startswith(module) for included in public_names.INCLUDE.findall(self.umbrellas[each][each]))
                  for each in reaching}
        own = sorted((each for each in reaching if counts[each]), key=lambda each: -counts[each])
        return next(iter([*core, *own, *([header] if header in self.included else []), *reaching, header]))

    def shown_members(self, compound, is_word, seen):
        """The public members of a class, followed by those of its bases that are not public names themselves."""
        bare = compound.find("compoundname").text.split("::")[-1]
        for member in compound.iter("memberdef"):
            name, kind, comment = member.find("name").text, member.get("kind"), self.comments.of(member)
            arguments = text_of(member.find("argsstring"))
            is_hidden = member.get("prot") != "public" or kind == "friend" or HIDDEN_NAMES.search(name) or arguments.endswith("=delete")
            declared = text_of(member.find("type"))
            is_machinery = "vector<" not in tidy(declared) if is_word else not comment and HIDDEN_TYPES.search(declared)
            is_plain = not comment and (name == bare or kind == "function" and not declared or name.startswith("operator"))
            if not (is_hidden or is_machinery or is_plain or (name, arguments) in seen):
                seen.add((name, arguments))
                yield member, comment
        for base in compound.findall("basecompoundref"):
            called = re.sub(r"<.*", "", base.text.removeprefix("kanexpr::")).strip()
            if base.get("refid") and base.get("prot") == "public" and called not in self.names:
                yield from self.shown_members(self.compound(base.get("refid")), is_word, seen)

    def class_entry(self, name):
        compound = self.compound(self.compounds[name])
        template = template_of(compound)
        bare = name.split("::")[-1]
        yield f"```cpp\n{template + chr(10) if template else ''}{compound.get('kind')} {bare}\n```"
        yield self.comments.of(compound)
        is_word = WORDS.match(self.first[name].header) is not None
        members = list(self.shown_members(compound, is_word, set()))
        if members:
            found = dict.fromkeys(member.find("name").text for member, _ in members if member.get("kind") != "typedef")
            found = [each for each in found if re.fullmatch(r"\w{3,}", each) and each not in self.names]
            yield f"```{{index}} {', '.join(f'!{name}' for name in found)}\n```" if found and not is_word else ""
            yield ":::{rubric} Members\n:::"
            yield from self.rows((signature(member, member.find("name").text), comment) for member, comment in members)

    def rows(self, members):
        """Members with comments as definitions, and consecutive members without comments as one block of code."""
        bare = []
        for code, comment in [*members, ("", "end")]:
            if not comment:
                bare.append(code)
                continue
            if bare:
                yield "```cpp\n" + "\n".join(bare) + "\n```"
            bare = []
            if code:
                line = " ".join(code.split()).replace("( ", "(")
                yield f"{{signature}}`{line}`\n: {textwrap.indent(comment, '  ').lstrip()}"

    def member_entry(self, members, header):
        """Functions, variables and types; those of other headers than the first one state theirs."""
        for member in sorted(members, key=lambda each: self.header_at(each) != header):
            if self.header_at(member) != header:
                header = self.header_at(member)
                yield f"{{signature}}`#include <{header}>`"
            yield f"```cpp\n{signature(member, member.find('name').text)}\n```"
            yield self.comments.of(member)
            yield from self.rows(self.comments.of_values(member) if member.get("kind") == "enum" else [])

    def header_at(self, member):
        return self.header_of(member.find("location").get("file"))

    def example(self, name):
        if (found := self.examples.get(name)) is None:
            return ""
        title = "the README" if found.page == "README.md" else found.page
        if found.page.startswith("docs/"):
            title = re.search(r"^# (.*)", (self.root / found.page).read_text(), re.M).group(1)
        return f":::{{rubric}} Example, from [{title}](../../{found.page})\n:::\n\n```cpp\n{found.text}\n```"

    def entry(self, name):
        yield f"({label(name)})=\n## `{name}`"
        header = self.header_of(self.first[name].header)
        yield f"{{signature}}`#include <{header}>`"
        if name in self.compounds:
            yield from self.class_entry(name)
        elif name not in self.members:
            sys.exit(f"docs/site/reference.py: Doxygen does not know {name}")
        kinds, inside = ("function", "variable", "typedef", "enum"), "/diagnostics/"
        yield from self.member_entry([member for member in self.members.get(name, []) if member.get("kind") in kinds
                                      and inside not in member.find("location").get("file")], header)
        yield self.example(name)

    def summary(self, name):
        return first_sentence(self.comments.markdown(self.first[name].comment.splitlines()))

    def write(self, folder):
        """Writes the pages, and replaces a comment in index.md by the list of pages."""
        for example in self.examples.values():
            if not example.name:
                copy = folder.parents[1] / example.page
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(self.root / example.page, copy)
        places = {name: (*place_of(first.header), first.header, first.line) for name, first in self.first.items()}
        listed = []
        for page, title, about, _ in PAGES:
            names = sorted((name for name in places if places[name][0] == page), key=lambda name: places[name])
            rows = [f"| [`{name}`](#{label(name)}) | {self.summary(name)} |" for name in names]
            parts = [f"# {title}: reference", about, "| | |\n|---|---|\n" + "\n".join(rows)]
            parts += [part for name in names for part in self.entry(name) if part]
            (folder / f"{page}.md").write_text("\n\n".join(parts) + "\n")
            listed.append(f"| [{title}]({page}.md) | {about} |")
        tree = "```{toctree}\n:hidden:\n\n" + "\n".join(f"{title} <{page}>" for page, title, *_ in PAGES) + "\nexamples\n```"
        index = folder / "index.md"
        index.write_text(index.read_text().replace("<!-- pages -->", "| | |\n|---|---|\n" + "\n".join(listed) + "\n\n" + tree))


if __name__ == "__main__":
    Reference(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])).write(pathlib.Path(sys.argv[3]))
