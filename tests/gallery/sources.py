#!/usr/bin/env python3
"""sources.py REPOSITORY: every source of the gallery is complete: it has a title, a chapter of site/chapters.json, what to see and where
the literature describes it, checks its motion, and shows a picture; and docs/gallery.md lists it."""
import json
import re
import sys
from pathlib import Path

repository = Path(sys.argv[1])
gallery = repository / "examples" / "gallery"
chapters = {each["title"] for each in json.loads((gallery / "site" / "chapters.json").read_text())}
listed = (repository / "docs" / "gallery.md").read_text()


def words(text, member):
    """The string of a member of gallery::entry, which may be split over several literals."""
    found = re.search(rf"\.{member} =\s*((?:\"(?:[^\"\\]|\\.)*\"\s*)+)", text)
    return "".join(re.findall(r"\"((?:[^\"\\]|\\.)*)\"", found[1])) if found else ""


def faults(name, text):
    if not text.startswith("// "):
        yield "does not begin with a comment on the system"
    if not words(text, "title"):
        yield "has no title"
    if words(text, "kind") not in chapters:
        yield f"is in no chapter of site/chapters.json: {words(text, 'kind')!r}"
    if not 2 <= len(re.findall(r"\.(?: |$)", words(text, "see"))) <= 3:
        yield "does not say what to see in two or three sentences"
    if not re.search(r"\d{4}", words(text, "source")):
        yield "names no source in the literature with its year"
    if not re.search(r"page\.expect\w*\(", text):
        yield "checks nothing"
    if "page.show<" not in text:
        yield "shows no picture"
    if words(text, "title") not in listed:
        yield "is not listed in docs/gallery.md"


sources = sorted(gallery.glob("*.cpp"))
found = [f"examples/gallery/{each.name} {fault}" for each in sources for fault in faults(each.stem, each.read_text())]
if not sources:
    found.append("examples/gallery has no sources")
print("\n".join(found))
sys.exit(bool(found))
