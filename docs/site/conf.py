"""Configuration of the site: the pages of docs/ and the files that they link to, staged by stage.py, and the reference written by reference.py."""

import pathlib
import re

from docutils import nodes
from pygments.lexers.c_cpp import CppLexer
from pygments.token import Error, Text

project = "kanexpr"
author = "the kanexpr authors"
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
root_doc = "docs/index"
exclude_patterns = ["docs/site"]

myst_enable_extensions = ["colon_fence", "deflist"]
myst_heading_anchors = 4
suppress_warnings = ["toc.not_included"]  # pages of the source tree, which others link to

html_theme = "furo"
html_title = "kanexpr"
html_extra_path = ["extra"]
html_static_path = ["static"]
html_search_scorer = str(pathlib.Path(__file__).parent / "static/scorer.js")
html_css_files = ["reference.css", "side_by_side.css"]
html_copy_source = False
html_show_sphinx = False
highlight_language = "none"
pygments_style = "friendly"
pygments_dark_style = "monokai"


def leave_room(app, pagename, templatename, context, doctree):
    """Pages with two programs next to each other have no table of contents on the right."""
    if pagename.startswith("docs/coming-from/") and not pagename.endswith("README"):
        context["furo_hide_toc"] = True


class Cpp(CppLexer):
    """C++ that may contain the letters of formulas, and … for omitted parts."""

    def get_tokens_unprocessed(self, text, stack=("root",)):
        for place, kind, value in super().get_tokens_unprocessed(text, stack):
            yield place, Text if kind is Error and not value.isascii() else kind, value


def signature(name, rawtext, text, lineno, inliner, options=None, content=None):
    """The role for declarations that are shown inline."""
    return [nodes.literal(text, text, classes=["signature", "code"], language="cpp")], []


def enclosing(node):
    while node := node.parent:
        yield node


def link_names(app, doctree, page):
    """Links code that is a public name, or begins with one as in lqr(A, B, Q, R), to its entry in the reference."""
    labels = app.env.get_domain("std").anonlabels
    for literal in list(doctree.findall(nodes.literal)):
        name = "api-" + re.split(r"[<({]", literal.astext())[0].removeprefix("kanexpr::").replace("::", "-").replace("_", "-")
        if name not in labels or isinstance(literal.parent, (nodes.reference, nodes.title)):
            continue
        target, anchor, *_ = labels[name]
        if any(anchor in section.get("ids") for section in enclosing(literal)):
            continue
        link = nodes.reference("", "", internal=True, refuri=f"{app.builder.get_relative_uri(page, target)}#{anchor}")
        literal.replace_self(link)
        link += literal


def setup(app):
    app.add_lexer("cpp", Cpp)
    app.add_lexer("hpp", Cpp)
    app.add_role("signature", signature)
    app.connect("doctree-resolved", link_names)
    app.connect("html-page-context", leave_room, priority=900)  # after the theme
