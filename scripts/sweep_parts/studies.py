# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of a sweep with their results, as figures and comparisons need them."""
import csv
import os

from report_parts import moments
from report_parts.results import Results
from study_parts.errors import StudyError

from .sweep_file import matching


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


def places_of(directory):
    """{name: directory} of the runs that have rows, in the order of sweep.csv; without
    one, by name. A stale name leads to results of other parameters and is no run; where
    a file system has no links, the table tells the case."""
    try:
        with open(os.path.join(directory, "sweep.csv"), encoding="utf-8",
                  newline="") as stream:
            rows = [row for row in csv.DictReader(stream)
                    if row.get("name") and row.get("state") != "stale"]
    except (OSError, ValueError, csv.Error):
        rows = []
    found = {}
    for row in rows or [{"name": name} for name in sorted(os.listdir(directory))]:
        for place in (row["name"], os.path.join("cases", row.get("case_id") or "")):
            path = os.path.join(directory, place)
            if os.path.isfile(os.path.join(path, "statistics.csv")):
                found.setdefault(row["name"], path)
    return found


def runs_of(directory, patterns):
    """[StudyRun] of a directory that sweep.py wrote."""
    if not os.path.isdir(directory):
        raise StudyError("there is no directory '%s'" % directory)
    places = places_of(directory)
    for pattern in patterns or ():
        if not matching(places, [pattern]):
            raise StudyError("--only: there is no run '%s' in %s" % (pattern, directory))
    if not places:
        raise StudyError("'%s' holds no run (no directory with a statistics.csv)"
                         % directory)
    return [StudyRun(name, places[name]) for name in matching(places, patterns)]
