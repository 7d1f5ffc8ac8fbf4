# SPDX-License-Identifier: GPL-2.0-or-later
"""Entries of parameter files. Python's own library only.

Nothing is checked: that is what the program is for."""
import os
import re

from .safe import read_text

DEEPEST = 20  # files that include files


def read_parameters(path):
    """{"Subsection/Entry": value} of a .prm file and of those it includes; empty when
    there is none."""
    return parameters_of(read_text(path) or "", os.path.dirname(path))


def parameters_of(text, folder="", depth=0):
    """The same of a text; files it includes are relative to the folder."""
    values, section = {}, []
    for line in text.replace("\\\n", "").splitlines():
        line = line.split("#", 1)[0].strip()
        if line.startswith("subsection "):
            section.append(line[len("subsection "):].strip())
        elif line == "end":
            del section[-1:]
        elif line.startswith("include ") and depth < DEEPEST:
            name = os.path.join(folder, line[len("include "):].strip())
            values.update(parameters_of(read_text(name) or "", os.path.dirname(name),
                                        depth + 1))
        else:
            found = re.match(r"set\s+(.*?)\s*=\s*(.*)$", line)
            if found:
                values["/".join(section + [found.group(1)])] = found.group(2).strip()
    return values
