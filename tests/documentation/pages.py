# SPDX-License-Identifier: GPL-2.0-or-later
"""The pages of the documentation as the tests see them."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77  # the exit status of a test that cannot be made here
BLOCK = re.compile(r"^<!-- test: ([a-z-]+) -->\n```sh\n(.*?)^```$", re.M | re.S)


def text_of(page):
    return (ROOT / page).read_text(encoding="utf-8")


def blocks(page):
    """[(mark, commands)]: the pieces of code of a page that have a mark before them,

        <!-- test: run -->

    which no reader sees. "run": as it stands; "set-up": what the test does in its
    own way, since it installs or compiles."""
    text = text_of(page)
    found = BLOCK.findall(text)
    assert len(found) == text.count("<!-- test: "), page + ": a mark without ```sh"
    return found
