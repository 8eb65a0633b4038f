#!/usr/bin/env python3
"""reference.py ROOT XML FOLDER: writes the pages of the reference to FOLDER, from the XML that Doxygen generated from the headers.

tests/rooms/public_names.py decides which names are public and finds their examples. PAGES assigns headers to pages in
the order of a textbook; a header without a page is an error.
"""

import fnmatch
import pathlib
import re
import shutil
import sys
import textwrap
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "tests/rooms"))
import public_names  # noqa: E402

# file, title, description, headers in the order in which their names appear
PAGES = [
    ("symbols", "Symbols", "The symbols of a model: coordinates, speeds, parameters, inputs and time.",
     "describe/symbol.hpp describe/symbol_name.hpp"),
    ("functions", "Functions", "Functions of scalar expressions. All arguments and results are scalars; angles are in rad.",
     "describe/functions.hpp describe/composed.hpp describe/external.hpp"),
    ("vectors", "Vectors", "Vectors, dyadics, their products, and derivatives in a frame.",
     "describe/expression.hpp describe/operators.hpp describe/motion.hpp"),
    ("frames", "Frames", "Reference frames, their orientations and angular velocities.", "describe/frame.hpp"),
    ("points", "Points", "Points, their positions and velocities.", "describe/point.hpp"),
    ("bodies", "Masses and inertia", "Particles, rigid bodies and inertia dyadics.", "describe/body.hpp"),
    ("joints", "Joints", "Mechanisms described by their joints, and constraints that couple joints.",
     "describe/joints/joints.hpp describe/joints/lower_pairs.hpp describe/joints/*.hpp compiled/reactions.hpp"),
    ("loads", "Forces and torques", "Forces, torques, springs, dampers and gravity.", "describe/load.hpp"),
    ("systems", "Systems", "Systems for Kane's method and for Lagrange's.", "describe/system.hpp describe/extended.hpp"),
    ("constraints", "Constraints", "Configuration and velocity constraints, and auxiliary speeds.", "describe/constraint.hpp"),
    ("results", "Results", "The equations of motion as compiled functions, their arguments and their status.",
     "compiled/equations_of_motion.hpp compiled/function.hpp compiled/state.hpp compiled/named_values.hpp compiled/status.hpp "
     "base/status.hpp base/outcome.hpp derivation/model_error.hpp mechanics/quantity.hpp compiled/*.hpp numeric/fixed_matrix.hpp "
     "numeric/as_eigen.hpp base/text.hpp base/file_path.hpp"),
    ("linearization", "Linearization", "Linearized equations, second derivatives, the regressor and base parameters.",
     "compiled/linearization.hpp compiled/second_order.hpp compiled/regressor.hpp runtime/base_parameters.hpp "
     "runtime/linearization_point.hpp"),
    ("consistency", "Consistent states", "States that satisfy the constraints.",
     "steps/assemble.hpp runtime/assemble.hpp steps/check_independence.hpp steps/least_multipliers.hpp numeric/*.hpp"),
    ("control", "Control", "Discretization, linear-quadratic regulators, gain schedules and Kalman filters.", "control/*.hpp"),
    ("steps", "Steps of fixed length", "Integration in real time, and the derivatives of a step.", "steps/*.hpp"),
    ("simulation", "Simulation", "Adaptive integration by SUNDIALS, events, trajectories and operating points.",
     "simulations/simulate.hpp simulations/simulation.hpp simulations/settings.hpp simulations/model.hpp simulations/trajectory/*.hpp "
     "simulations/events/*.hpp base/crossing.hpp simulations/*.hpp simulations/*/*.hpp base/statistics.hpp"),
    ("ensembles", "Ensembles", "Many simulations of one system, on threads and machines.",
     "ensembles/ensemble.hpp ensembles/study.hpp ensembles/runs.hpp ensembles/distribution.hpp ensembles/run_output.hpp "
     "ensembles/reduction.hpp ensembles/*.hpp ensembles/hdf5/*.hpp mpi/*.hpp"),
    ("batches", "Batches", "Many systems side by side, in SIMD vectors and on several threads.", "batches/*.hpp"),
    ("figures", "Figures", "Textbook figures drawn from the model.", "figures/*.hpp"),
    ("animation", "Animation", "Animated pictures on a page that a browser can open.",
     "animate/write_page.hpp animate/animated.hpp animate/*.hpp"),
    ("robots", "Robots", "Robots from URDF and SDF files.", "robots/*.hpp robots/*/*.hpp"),
    ("run-time", "At run time", "Models derived at run time, which can be printed and evaluated, and models without types.",
     "runtime/model.hpp runtime/builder.hpp runtime/*.hpp symbolic/printing/*.hpp symbolic/*.hpp symbolic/*/*.hpp mechanics/*/*.hpp"),
    ("export", "Export", "Models as C, CasADi functions and FMUs.", "exporting/*.hpp exporting/*/*.hpp"),
]
WORDS = re.compile(r"kanexpr/(describe/(?!symbol_name)|animate/(elements|shapes|picture))")  # of whose members only axes are shown
HIDDEN_TYPES = re.compile(r"\b(?:describe|derivation|mechanics|compiled|animate|lower|steps|symbolic::graph)::|_record\b|\bphrase\b")
WIDTH = 92


def place_of(header):
    """The page of a header and its rank on the page, by the first matching pattern without a star, or else the first with one."""
    for exactly in (True, False):
        for page, *_, patterns in PAGES:
            for rank, pattern in enumerate(patterns.split()):
                if ("*" not in pattern) == exactly and fnmatch.fnmatch(header.removeprefix("kanexpr/"), pattern) \
                        and pattern.count("/") == header.count("/") - 1:
                    return page, rank
    sys.exit(f"docs/site/reference.py: PAGES has no page for {header}")


class Comments:
    """Documentation comments as MyST; public names in code are linked to their entries."""

    def __init__(self, root, names):
        self.root, self.names, self.lines = root, names, {}

    def of(self, entity):
        """The comment of a Doxygen entity: the /// lines above its declaration, or the ///< comment after it."""
        place = entity.find("location")
        file, at = place.get("file"), int(place.get("line")) - 1
        if file not in self.lines:
            self.lines[file] = (self.root / "include" / file).read_text().splitlines()
        lines, found = self.lines[file], []
        first = at
        while first > 0 and continues(lines[first - 1]):
            first -= 1
        while first > 0 and lines[first - 1].strip().startswith("///") and "///<" not in lines[first - 1]:
            first -= 1
            found.insert(0, lines[first].strip()[3:])
        while not found and at < len(lines) and (match := re.search(r"///<(.*)", lines[at]) or re.search(r"[^;{]$", lines[at])):
            found += match.groups()
            if match.groups() and not re.match(r" *///<", lines[min(at + 1, len(lines) - 1)]):
                break
            at += 1
        return self.markdown(found)

    def markdown(self, lines):
        """Paragraphs; indented lines are code."""
        parts = []
        for line in textwrap.dedent("\n".join(lines)).splitlines():
            is_code = line.startswith("    ")
            if is_code != (parts[-1].startswith("```") if parts else False) or not parts or not line:
                parts.append("```cpp" if is_code else "")
            parts[-1] += "\n" + (line[4:] if is_code else line)
        return "\n\n".join(part.strip() + "\n```" if part.startswith("```") else self.prose(part.strip()) for part in parts if part.strip())

    def prose(self, text):
        pieces = re.split(r"(`[^`]+`)", text)
        return "".join(self.code(piece[1:-1]) if piece.startswith("`") and len(piece) > 1 else escaped(piece) for piece in pieces)

    def code(self, text):
        text = " ".join(text.split())
        linked = re.fullmatch(r"(?:kanexpr::)?([\w:]+)(?:<[^<>]*>)?(?:\(\))?", text)
        return f"[`{text}`](#{label(linked.group(1))})" if linked and linked.group(1) in self.names else f"`{text}`"


def continues(line):
    """Whether a declaration continues after a line."""
    return bool(line.strip()) and not line.strip().startswith(("//", "#")) and not line.rstrip().endswith((";", "{", "}", ":"))


def escaped(text):
    return re.sub(r"(?<!^)([\\*_\[\]<>{}$|~])|^([\\*_\[\]<>{}$|~])", r"\\\1\2", text or "")


def first_sentence(comment):
    text = re.sub(r"\]\(#[^)]*\)", "]", comment.split("\n\n")[0]).replace("\n", " ")
    text = re.sub(r"\[(`[^`]*`)\]", r"\1", text)
    return re.split(r"(?<=[^.])\.(?: |$)|:? `[^`]*[<({][^`]*`\.?$|: ", text + " ", maxsplit=1)[0].strip()


def label(name):
    return "api-" + name.replace("::", "-").replace("_", "-")


def text_of(element):
    return " ".join("".join(element.itertext()).split()) if element is not None else ""


def tidy(code):
    """Code as it is formatted in the sources."""
    code = re.sub(r"\bKANEXPR_\w+\b|\binline\b", "", code)
    code = code.replace("< ", "<").replace(" >", ">").replace(" &", "&").replace(" *", "*").replace("auto()", "auto")
    code = re.sub(r"\bkanexpr::(?=\w)", "", code)
    return " ".join(code.split())


def parameters_of(member):
    found = []
    for each in member.findall("param"):
        kind, name, default, array = (text_of(each.find(tag)) for tag in ("type", "declname", "defval", "array"))
        found.append(tidy(f"{kind} {name}{array}" + (f" = {default}" if default else "")))
    return found


def template_of(entity):
    listed = entity.find("templateparamlist")
    if listed is None:
        return ""
    found = []
    for each in listed:
        kind, name, default = (text_of(each.find(tag)) for tag in ("type", "declname", "defval"))
        found.append(tidy(f"{kind} {name}" + (f" = {default}" if default else "")))
    return f"template <{', '.join(found)}>"


def wrapped(start, parameters, end):
    """A call wrapped at WIDTH, with as many parameters in each line as fit."""
    line = f"{start}({', '.join(parameters)}){end}"
    if len(line) <= WIDTH:
        return line
    lines = [""]
    for each in [*(f"{each}, " for each in parameters[:-1]), *parameters[-1:]]:
        if lines[-1] and len(lines[-1]) + len(each) > WIDTH - 4:
            lines.append("")
        lines[-1] += each
    return f"{start}(\n    " + "\n    ".join(line.rstrip() for line in lines) + f"){end}"


def signature(member, name):
    kind, lines = member.get("kind"), [template_of(member)]
    if requires := text_of(member.find("requiresclause")):
        lines.append(f"  requires {tidy(requires)}")
    declared = tidy(text_of(member.find("type"))).removesuffix("()")
    if kind == "function":
        words = ["explicit"] * (member.get("explicit") == "yes") + ["static"] * (member.get("static") == "yes" and "static" not in declared)
        qualifiers = re.search(r"\)([^()]*)$", text_of(member.find("argsstring")))
        end = tidy(qualifiers.group(1).split("=")[0]) if qualifiers else ""
        lines.append(wrapped(" ".join([*words, declared, name]).strip(), parameters_of(member), f" {end}" if end else ""))
    elif kind == "typedef":
        lines.append(f"using {name} = {declared}")
    elif kind == "enum":
        lines.append(f"enum class {name}")
    else:
        start = tidy(text_of(member.find("initializer")))
        value = f" {start}" if re.fullmatch(r"= [-\w.+]+(?:::\w+)?", start) else ""
        is_static = member.get("static") == "yes" and not declared.startswith("static")
        lines.append(f"{'static ' * is_static}{declared} {name}{value}")
    return "\n".join(each for each in lines if each)


class Reference:
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
            is_hidden = member.get("prot") != "public" or kind == "friend" or re.search(r"^~|_$|^fields$|^each_member$", name) or arguments.endswith("=delete")
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
            found = dict.fromkeys(member.find("name").text for member, _ in members if re.fullmatch(r"\w+", member.find("name").text))
            yield f"```{{index}} {', '.join(found)}\n```" if found and not is_word else ""
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
            yield f"```cpp\n{self.source(member) if member.get('kind') == 'enum' else signature(member, member.find('name').text)}\n```"
            yield self.comments.of(member)

    def header_at(self, member):
        return self.header_of(member.find("location").get("file"))

    def source(self, enumeration):
        """An enumeration as it is written in the header, with the comments of its values."""
        place = enumeration.find("location")
        lines = (self.root / "include" / place.get("file")).read_text().splitlines()
        return "\n".join(lines[int(place.get("bodystart")) - 1 : int(place.get("bodyend"))])

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
        tree = "```{toctree}\n:hidden:\n\n" + "\n".join(f"{title} <{page}>" for page, title, *_ in PAGES) + "\n```"
        index = folder / "index.md"
        index.write_text(index.read_text().replace("<!-- pages -->", "| | |\n|---|---|\n" + "\n".join(listed) + "\n\n" + tree))


if __name__ == "__main__":
    Reference(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])).write(pathlib.Path(sys.argv[3]))
