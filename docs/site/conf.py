"""The site: pages of docs/ and what they link to, staged by stage.py, with the reference that reference.py writes."""

from pygments.lexers.c_cpp import CppLexer

project = "kanexpr"
author = "the kanexpr authors"
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
root_doc = "docs/index"
exclude_patterns = ["docs/site"]

myst_enable_extensions = ["deflist"]
myst_heading_anchors = 4
suppress_warnings = ["toc.not_included"]  # pages of the source tree, which others link to

html_theme = "furo"
html_title = "kanexpr"
html_extra_path = ["extra"]
html_static_path = ["static"]
html_css_files = ["side_by_side.css"]
html_copy_source = False
html_show_sphinx = False
highlight_language = "none"
pygments_style = "friendly"
pygments_dark_style = "monokai"


def leave_room(app, pagename, templatename, context, doctree):
    """Pages with two programs next to each other have no table of contents at their right."""
    if pagename.startswith("docs/coming-from/") and not pagename.endswith("README"):
        context["furo_hide_toc"] = True


def setup(app):
    app.add_lexer("hpp", CppLexer)
    app.connect("html-page-context", leave_room, priority=900)  # after the theme
