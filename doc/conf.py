# SPDX-License-Identifier: GPL-2.0-or-later
"""Settings of Sphinx for the site of the documentation; scripts/build-docs builds it.

The source directory is the project, not doc/: README.md, CONTRIBUTING.md and
CHANGELOG.md are pages as well, and links to .prm files become downloads.
"""
import pathlib
import re

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

extensions = ["myst_parser", "sphinx.ext.graphviz"]
graphviz_output_format = "svg"
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


def drawn(match):
    """A chart of mermaid, which GitHub draws, as one of Graphviz."""
    lines = []
    for line in match.group(1).splitlines()[1:]:
        begin, _, ends = line.partition("-->")
        name, label = re.fullmatch(r"\s*(\w+)\[(.*)\]\s*", begin).groups()
        lines.append('%s [label="%s"];' % (name, label.replace("<br>", "\\n")))
        lines += ["%s -> %s;" % (name, end.strip()) for end in ends.split("&")
                  if end.strip()]
    return "```{graphviz}\ndigraph { node [shape=box fontname=Helvetica fontsize=11];\n" \
        "%s }\n```" % "\n".join(lines)


def with_charts(_app, _page, source):
    source[0] = re.sub(r"^```mermaid\n(.*?)^```$", drawn, source[0], flags=re.M | re.S)


def setup(app):
    app.connect("source-read", with_charts)
    return {"parallel_read_safe": True}
