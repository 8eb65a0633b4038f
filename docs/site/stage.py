#!/usr/bin/env python3
"""stage.py ROOT FOLDER: copies the pages of the project, and the files that they link to, to FOLDER in the same layout.

Links between the pages work both in the repository and on the site. For each folder that a page links to, a page that
lists its files is added.
"""

import pathlib
import re
import shutil
import sys

LINK = re.compile(r"(?<!\\)\]\(([^)#\s]+)(#[^)\s]*)?\)")
FENCE = re.compile(r"^```.*?^```", re.M | re.S)


def links_of(text):
    return [match.group(1) for match in LINK.finditer(FENCE.sub("", text)) if "://" not in match.group(1)]


def page_of_folder(source, root):
    title = source.relative_to(root).as_posix()
    files = sorted(path for path in source.iterdir() if not path.name.startswith("."))
    rows = [f"- [{path.name}]({path.name}{'/index.md' if path.is_dir() else ''})" for path in files if path.is_file()]
    return f"# {title}\n\n" + "\n".join(rows) + "\n"


def stage(root, folder):
    waiting, done = [root / "docs/index.md", root / "README.md"], set()
    waiting += sorted((root / "docs").rglob("*.md"))
    while waiting:
        source = waiting.pop().resolve()
        if source in done or not source.is_relative_to(root):
            continue
        done.add(source)
        target = folder / source.relative_to(root)
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            target.mkdir(exist_ok=True)
            page = target / "index.md"
            page.write_text(page_of_folder(source, root))
            waiting += [path for path in source.iterdir() if path.is_file() and not path.name.startswith(".")]
            continue
        if source.suffix != ".md":
            shutil.copyfile(source, target)
            continue
        text = source.read_text()
        for link in links_of(text):
            linked = (source.parent / link).resolve()
            if not linked.exists():
                sys.exit(f"{source.relative_to(root)} links to {link}, which does not exist")
            waiting.append(linked)
        target.write_text(
            LINK.sub(
                lambda match: f"]({match.group(1).rstrip('/')}/index.md)"
                if "://" not in match.group(1) and (source.parent / match.group(1)).is_dir()
                else match.group(0),
                text,
            )
        )


if __name__ == "__main__":
    stage(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
