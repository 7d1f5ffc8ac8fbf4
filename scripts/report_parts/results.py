# SPDX-License-Identifier: GPL-2.0-or-later
"""What a run left in its directory, however far it came."""
import os
import re

import numpy as np

from .parameters import read_parameters
from .safe import csv_table, finite, is_number_or_empty, json_object, read_text


class Results:
    """statistics (name -> array), summary, parameters, and remarks on gaps."""

    def __init__(self, directory):
        self.directory = directory
        self.remarks = []
        self.statistics = read_statistics(
            os.path.join(directory, "statistics.csv"), self.remarks)
        self.summary = read_summary(
            os.path.join(directory, "summary.json"), self.remarks)
        self.parameters = read_parameters(
            os.path.join(directory, "parameters.prm"))
        self.log_warnings = read_log_warnings(os.path.join(directory, "log.txt"))

    @property
    def n_steps(self):
        return len(next(iter(self.statistics.values()), []))

    @property
    def is_3d(self):
        return self.parameter("Geometry/Dimension") == "3"

    def column(self, name):
        """A column of the statistics, or None."""
        return self.statistics.get(name) if self.n_steps else None

    def parameter(self, path, default=None):
        """The value of "Subsection/Entry", or the default."""
        value = self.parameters.get(path, "")
        return value if value != "" else default

    def number(self, path, default=None):
        """The same as a number; the default when it is none."""
        value = finite(self.parameter(path))
        return default if value is None else value


def read_statistics(path, remarks):
    """Columns by name; what is empty, not finite or beyond all measure is nan."""
    text = read_text(path)
    if text is None:
        remarks.append("There is no statistics.csv: no step has been accepted yet.")
        return {}
    names, lines, n_bad, cut = csv_table(text)
    if cut and names:
        remarks.append("The last line of statistics.csv is incomplete and was left "
                       "out.")
    if not names:
        remarks.append("statistics.csv is empty.")
        return {}
    rows = [line for line in lines if all(map(is_number_or_empty, line))]
    n_bad += len(lines) - len(rows)
    if n_bad:
        remarks.append("%d line%s of statistics.csv could not be read."
                       % (n_bad, "" if n_bad == 1 else "s"))
    if not rows:
        remarks.append("statistics.csv holds no step yet.")
    values = [[finite(text) for text in row] for row in rows]
    n_odd = sum(value is None and bool(text.strip())
                for row, texts in zip(values, rows) for value, text in zip(row, texts))
    if n_odd:
        remarks.append("%d number%s in statistics.csv %s not finite, or too large for "
                       "any body, and left out." % (
                           (n_odd,) + (("", "is") if n_odd == 1 else ("s", "are"))))
    table = np.array([[np.nan if value is None else value for value in row]
                      for row in values], dtype=float).reshape(-1, len(names))
    return {name: table[:, i] for i, name in reversed(list(enumerate(names)))}


def read_summary(path, remarks):
    """summary.json; empty when the run has not come to its end."""
    text = read_text(path)
    if text is None:
        remarks.append("There is no summary.json: the run is still going on, "
                       "or it was killed.")
        return {}
    try:
        return json_object(text)
    except ValueError as error:
        remarks.append("summary.json cannot be read (%s)." % error)
        return {}


def read_log_warnings(path, largest=8):
    """Lines of the log that begin with "warning", each once."""
    lines = map(str.strip, (read_text(path) or "").splitlines())
    found = list(dict.fromkeys(
        line for line in lines if re.match(r"warning\b", line, re.IGNORECASE)))
    if len(found) > largest:
        found[largest:] = ["… and %d more in log.txt" % (len(found) - largest)]
    return found
