#!/usr/bin/env python3
"""pages.py GALLERY NAME...: the index and the pages of the gallery are whole: links lead to files, equations and source are there, nothing
refers to a network, and the index with its thumbnails is below a megabyte."""
import re
import sys
from html.parser import HTMLParser
from pathlib import Path

gallery, names = Path(sys.argv[1]), sys.argv[2:]
found = []


class links(HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.file, self.images, self.classes = file, [], set()
        self.feed(file.read_text())

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.classes.update((given.get("class") or "").split())
        if tag == "script":
            found.append(f"{self.file} has a script")
        for each in ("href", "src"):
            address = given.get(each)
            if address is None:
                continue
            if re.match(r"[a-z]+:", address):
                found.append(f"{self.file} refers to {address}")
            elif not (self.file.parent / address).is_file():
                found.append(f"{self.file} refers to {address}, which does not exist")
            elif tag == "img":
                self.images.append(self.file.parent / address)


index = links(gallery / "index.html")
size = sum(each.stat().st_size for each in [index.file, gallery / "assets" / "style.css", *index.images])
if size > 1_000_000:
    found.append(f"the index and its thumbnails have {size} bytes")
if len(index.images) < len(names):
    found.append(f"the index shows {len(index.images)} pages, not {len(names)}")
for name in names:
    page = links(gallery / name / "index.html")
    for wanted in ("katex", "equation", "hljs", "proofs", "counts", "files"):
        if wanted not in page.classes:
            found.append(f"{page.file} has no {wanted}")
    if len(list((gallery / name).glob("*.fmu"))) != 1 or len(list((gallery / name).glob("*.c"))) != 2:
        found.append(f"{gallery / name} lacks exported files")
if "url(data:font/woff2" not in (gallery / "assets" / "katex.css").read_text():
    found.append("the style of the equations does not contain its fonts")
print("\n".join(found))
sys.exit(bool(found))
