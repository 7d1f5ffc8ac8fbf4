#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The site of the documentation is made without a warning, which would be a link, an
anchor or a figure that is not there; a fault that is put in is found; every page can
be reached from the first one; CITATION.cff names the version that is built.

Exit status 77 where Sphinx, MyST, the theme or Graphviz is not installed.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from html.parser import HTMLParser
from urllib.parse import unquote, urldefrag

from pages import ROOT, SKIPPED

FAULTS = {"[a](nowhere.md)": "nowhere.md", "[a](output.md#nowhere)": "output.md#nowhere",
          "[a](../parameters/nowhere.prm)": "nowhere.prm",
          "![a](figures/nowhere.png)": "nowhere.png"}


class Links(HTMLParser):
    """Targets of links and pictures of a page, and its anchors."""

    def __init__(self, path):
        super().__init__()
        self.targets, self.anchors = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value:
                self.targets.append(value)
            elif name == "id":
                self.anchors.add(value)


def build(project, site):
    """(exit status, what is said)"""
    process = subprocess.run(
        ["bash", str(project / "scripts" / "build-docs"), str(site)], text=True,
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        check=False, env=dict(os.environ, MIXED_CRACKS_NO_INSTALL="1"))
    return process.returncode, process.stdout


def is_missing(said):
    return re.search(r"there is no sphinx-build|Could not import extension|"
                     r"no theme named|No module named|dot command .* cannot",
                     said) is not None


def reached_from_the_first_page(site):
    """All pages; each target of their links has to be there, with its anchor."""
    pages, waiting = {}, [site / "index.html"]
    while waiting:
        path = waiting.pop()
        if path in pages:
            continue
        pages[path] = Links(path)
        for target in pages[path].targets:
            if re.match(r"[a-z]+:", target):
                continue  # elsewhere in the net
            name, anchor = urldefrag(target)
            file = (path.parent / unquote(name.split("?")[0])).resolve() if name else path
            assert file.is_file(), "%s leads to %s, which is not there" % (path, target)
            if file.suffix == ".html":
                waiting.append(file)
            if anchor and file.suffix == ".html":
                there = pages[file] if file in pages else Links(file)
                assert anchor in there.anchors, "%s: no anchor %s" % (path, target)
    return pages


def faults_are_found(folder):
    """In a copy of the project, all in one page."""
    project = folder / "project"
    for name in ("doc", "scripts", "parameters"):
        shutil.copytree(ROOT / name, project / name)
    for path in ROOT.iterdir():  # what README and its like lead to
        if path.is_file():
            shutil.copy(path, project)
    with open(project / "doc" / "reliability.md", "a", encoding="utf-8") as page:
        page.write("\n" + "\n".join(FAULTS) + "\n")
    status, said = build(project, folder / "faulty")
    assert status == 1, said
    warnings = [line for line in said.splitlines() if "WARNING" in line]
    for fault, words in FAULTS.items():
        assert any(words in line and "reliability.md" in line for line in warnings), \
            (fault, said)
    assert len(warnings) == len(FAULTS), said


def versions_agree():
    built = re.search(r"project\(mixed-cracks VERSION (\S+)",
                      (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)
    cited = re.search(r"^version: (\S+)$",
                      (ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.M).group(1)
    assert cited == built, (cited, built)


def main():
    versions_agree()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary).resolve()
        status, said = build(ROOT, folder / "site")
        if status != 0 and is_missing(said):
            print("skipped: there is no Sphinx with MyST, furo and Graphviz; "
                  "scripts/install-packages documentation brings them")
            return SKIPPED
        assert status == 0, said
        pages = reached_from_the_first_page(folder / "site")
        sources = [path for path in (ROOT / "doc").rglob("*.md")]
        unreached = [str(path) for path in sources
                     if folder / "site" / path.relative_to(ROOT).with_suffix(".html")
                     not in pages]
        assert not unreached, unreached
        print("%d pages" % len(pages))
        faults_are_found(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
