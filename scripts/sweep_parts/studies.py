# SPDX-License-Identifier: GPL-2.0-or-later
"""What scripts/study.py reads: runs of a sweep, references for comparison."""
import collections
import csv
import fnmatch
import math
import os

from report_parts import moments
from report_parts.results import Results

FORCES = ("force_N_per_mm", "force_N")
# a column each for what lies below and above the mean of several tests
SCATTER = ("displacement_minus_mm", "displacement_plus_mm", "force_minus",
           "force_plus")

# unit: which of FORCES; scatter: (low, high) of displacement and force, or None
Reference = collections.namedtuple("Reference",
                                   "name displacement force unit scatter")


class StudyError(Exception):
    """What is wrong with the input; the text is for a person."""


class StudyRun:
    def __init__(self, name, directory):
        self.name = name
        self.results = Results(directory)
        self.summary = self.results.summary
        self.force = moments.Force(self.results)

    def choose_component(self, component):
        """Look at one component of the force: 'x', 'y' or 'z'."""
        self.force = moments.Force(self.results, component)

    @property
    def has_curve(self):
        return self.force.values is not None \
            and self.results.column("displacement_mm") is not None

    @property
    def thickness(self):
        """mm, or None."""
        value = self.summary.get("thickness_mm")
        if not isinstance(value, (int, float)):
            value = self.results.number("Material/Thickness")
        return float(value) if value and value > 0. else None

    @property
    def peak(self):
        """(displacement in mm, force in N), or None. The summary's are those of
        a run that has come to its end."""
        pair = [self.summary.get(key) for key in ("displacement_at_peak_mm",
                                                  "peak_force_N")]
        if all(isinstance(value, (int, float)) for value in pair):
            return tuple(pair)
        if not self.has_curve:
            return None
        return (float(self.results.column("displacement_mm")[self.force.peak]),
                float(self.force.values[self.force.peak]))

    @property
    def outcome(self):
        """In words: from the summary, otherwise how far the run has come."""
        words = [text + str(self.summary[key]) for key, text in
                 (("outcome", ""), ("outcome_start", "start: "))
                 if self.summary.get(key)]
        if not self.summary:
            words = ["unfinished"]
        elif not words:
            words = [{True: "separated", False: "not separated"}.get(
                self.summary.get("separated"), "")]
        if self.summary.get("exit_status") not in (None, 0):
            words.append("exit status %s" % self.summary["exit_status"])
        return ", ".join(word for word in words if word)

    @property
    def group(self):
        """The name without its last word: fine_1 and fine_2 belong together."""
        return self.name.rpartition("_")[0] or self.name


def runs_of(directory, patterns):
    """The runs in the order of sweep.csv; without one, by name."""
    if not os.path.isdir(directory):
        raise StudyError("there is no directory '%s'" % directory)
    try:
        with open(os.path.join(directory, "sweep.csv"), encoding="utf-8",
                  newline="") as stream:
            names = [row["name"] for row in csv.DictReader(stream) if row.get("name")]
    except (OSError, KeyError, ValueError, csv.Error):
        names = sorted(os.listdir(directory))
    names = [name for name in names
             if os.path.isfile(os.path.join(directory, name, "statistics.csv"))]
    for pattern in patterns or ():
        if not fnmatch.filter(names, pattern):
            raise StudyError("--only: there is no run '%s' in %s" % (pattern, directory))
    names = [name for name in names if not patterns or
             any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)]
    if not names:
        raise StudyError("'%s' holds no run (no directory with a statistics.csv)"
                         % directory)
    return [StudyRun(name, os.path.join(directory, name)) for name in names]


def reference_of(run_name, names):
    """Which of the names of references belongs to a run: its own, or its last word
    (of neo_hooke_12, 12), or none."""
    for name in (run_name, run_name.rpartition("_")[2]):
        if name in names:
            return name
    return None


def numbers(row, columns):
    values = [float(row[column]) for column in columns]
    if not all(map(math.isfinite, values)):
        raise ValueError
    return values


def reference_row(row, unit, has_scatter):
    displacement, force = numbers(row, ("displacement_mm", unit))
    scatter = None
    if has_scatter:
        below, above, weaker, stronger = numbers(row, SCATTER)
        scatter = ((displacement - below, displacement + above),
                   (force - weaker, force + stronger))
    return Reference(row.get("name", ""), displacement, force, unit, scatter)


def read_reference(path, name_needed):
    """[Reference] of a CSV file."""
    try:
        with open(path, encoding="utf-8") as stream:
            lines = [(number, line) for number, line in enumerate(stream, 1)
                     if line.strip() and not line.lstrip().startswith("#")]
    except (OSError, UnicodeDecodeError) as error:
        raise StudyError("%s cannot be read: %s" % (path, error))
    header = [name.strip() for name in next(csv.reader([lines[0][1]]))] \
        if lines else []
    force = next((name for name in FORCES if name in header), None)
    if force is None or "displacement_mm" not in header \
            or (name_needed and "name" not in header):
        raise StudyError("%s: expected a header with %sdisplacement_mm and %s"
                         % (path, "name, " if name_needed else "",
                            " or ".join(FORCES)))
    has_scatter = any(name in header for name in SCATTER)
    missing = [name for name in SCATTER if has_scatter and name not in header]
    if missing:
        raise StudyError("%s: scatter needs all of %s; there is no %s"
                         % (path, ", ".join(SCATTER), missing[0]))
    rows = []
    for number, line in lines[1:]:
        values = [value.strip() for value in next(csv.reader([line]))]
        try:
            if len(values) != len(header):
                raise ValueError
            rows.append(reference_row(dict(zip(header, values)), force, has_scatter))
        except (KeyError, ValueError):
            raise StudyError("%s:%d: expected %d values with numbers in "
                             "displacement_mm and %s, found '%s'"
                             % (path, number, len(header),
                                ", ".join((force,) + SCATTER) if has_scatter
                                else force, line.strip()))
    return rows
