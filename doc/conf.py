# SPDX-License-Identifier: GPL-2.0-or-later
"""Settings of Sphinx for the site of the documentation; scripts/build-docs builds it.

The source directory is the project, not doc/: README.md, CONTRIBUTING.md and
CHANGELOG.md are pages as well, and links to .prm files become downloads.
"""
import pathlib
import re

from pygments.lexers.special import TextLexer

ROOT = pathlib.Path(__file__).resolve().parents[1]

project = "mixed-cracks"
author = "the authors of mixed-cracks"
version = re.search(r"project\(mixed-cracks VERSION (\S+)",
                    (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)
release = version

root_doc = "doc/index"
include_patterns = ["doc/**", "README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
exclude_patterns = ["build*", "results", ".git", "source", "include", "tests", "scripts",
                    "parameters", "meshes"]

extensions = ["myst_parser"]
myst_heading_anchors = 4  # as GitHub makes them
myst_enable_extensions = ["html_image"]
nitpicky = True
smartquotes = False  # --check is to be copied as it is

html_theme = "furo"
html_title = "mixed-cracks " + version
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_copyright = False


def setup(app):
    """GitHub draws blocks of mermaid; here they are shown as they are written."""
    app.add_lexer("mermaid", TextLexer)
    return {"parallel_read_safe": True}
