# SPDX-License-Identifier: MIT
"""Builds the manual: python3 -m sphinx -b html packaging/manual OUTPUT. The help of the window (F1) shows the same pages."""
import pathlib
import re

from docutils import nodes

project = "Tiller"
author = copyright = "The Tiller maintainers"
_cmake = (pathlib.Path(__file__).parents[2] / "CMakeLists.txt").read_text(encoding="utf-8")
version = release = re.search(r"project\(tiller VERSION (\S+)", _cmake)[1]
html_theme = "alabaster"
html_theme_options = {"description": "Jog, teach, run and monitor a robot arm from a PC", "fixed_sidebar": True}
html_show_sphinx = False
html_copy_source = False
nitpicky = True

# For the window (-t window): text and links, without the page elements for browsers.
if tags.has("window"):  # noqa: F821: defined by Sphinx
    html_theme = "window"
    html_theme_path = ["theme"]
    html_theme_options = {}
    html_permalinks = False
    html_use_index = False


def give_pictures_a_line(app, doctree, page):
    """Puts pictures into paragraphs. Otherwise, the help of the window would draw them on the line of the heading above."""
    for picture in list(doctree.findall(nodes.image)):
        if isinstance(picture.parent, nodes.section):
            paragraph = nodes.paragraph()
            picture.replace_self(paragraph)
            paragraph += picture


def setup(app):
    app.connect("doctree-resolved", give_pictures_a_line)
