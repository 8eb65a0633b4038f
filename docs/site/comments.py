"""Documentation comments of the headers as MyST, for the reference."""

import re
import textwrap


def label(name):
    """The target of links to the entry of a name."""
    return "api-" + name.replace("::", "-").replace("_", "-")


class Comments:
    """Documentation comments as MyST; public names in code are linked to their entries."""

    def __init__(self, root, names):
        self.root, self.names, self.lines = root, names, {}

    def of(self, entity):
        """The comment of a Doxygen entity: the /// lines above its declaration, or the ///< comment after it."""
        place = entity.find("location")
        lines, at = self.lines_of(place.get("file")), int(place.get("line")) - 1
        return self.markdown(above(lines, at) or behind(lines, at))

    def of_values(self, enumeration):
        """The values of an enumeration, which Doxygen does not locate, with their comments."""
        place = enumeration.find("location")
        lines, first, last = self.lines_of(place.get("file")), int(place.get("bodystart")), int(place.get("bodyend"))
        for name in (value.find("name").text for value in enumeration.findall("enumvalue")):
            at = next((i for i in range(first, last) if re.match(rf" *{name}\b", lines[i])), None)
            yield name, self.markdown(above(lines, at) or behind(lines, at)) if at else ""

    def lines_of(self, file):
        if file not in self.lines:
            self.lines[file] = (self.root / "include" / file).read_text().splitlines()
        return self.lines[file]

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


def above(lines, at):
    """The comment above the declaration that contains a line."""
    while at > 0 and continues(lines[at - 1]):
        at -= 1
    found = []
    while at > 0 and lines[at - 1].strip().startswith("///") and "///<" not in lines[at - 1]:
        at -= 1
        found.insert(0, lines[at].strip()[3:])
    return found


def behind(lines, at):
    """The ///< comment after the declaration that contains a line."""
    while "///<" not in lines[at] and continues(lines[at]) and at + 1 < len(lines):
        at += 1
    found = [lines[at].split("///<")[1]] if "///<" in lines[at] else []
    while found and at + 1 < len(lines) and lines[at + 1].strip().startswith("///<"):
        at += 1
        found.append(lines[at].split("///<")[1])
    return found


def escaped(text):
    return re.sub(r"([\\*_\[\]<>{}$|~])", r"\\\1", text)


def first_sentence(comment):
    """The first sentence of a comment without links, and without the code that follows a colon."""
    text = re.sub(r"\]\(#[^)]*\)", "]", comment.split("\n\n")[0]).replace("\n", " ")
    text = re.sub(r"\[(`[^`]*`)\]", r"\1", text)
    return re.split(r"(?<=[^.])\.(?: |$)|:? `[^`]*[<({][^`]*`\.?$|: ", text + " ", maxsplit=1)[0].strip()
