# SPDX-License-Identifier: GPL-2.0-or-later
"""The runs of a sweep beside references: peak, displacement at the peak, the whole
curve, the path of the crack; what lies inside the scatter, what meets a tolerance."""
import math

import numpy as np

from report_parts import crack_path

from . import curve_difference, polylines, references
from .errors import StudyError

# quantity: (unit, whether a tolerance is a share of the reference)
QUANTITIES = {"displacement": ("mm", True), "peak": (None, True),
              "curve": ("%", False), "area": ("%", False),
              "path": ("mm", False), "hausdorff": ("mm", False)}
UNITS = {"force_N_per_mm": "N/mm", "force_N": "N", None: "N"}


class Figure:
    """One quantity of one run. computed is None where the run does not tell it.
    reference: None for distances, which are to be 0. band: (low, high) or None.
    inside: whether the scatter holds it, a share of the points of curves and paths;
    None without scatter. met: whether the tolerance is; None without one."""

    def __init__(self, quantity, computed, reference=None, band=None, inside=None):
        self.quantity, self.computed, self.reference = quantity, computed, reference
        self.band, self.inside, self.met = band, inside, None
        if band is not None and computed is not None:
            self.inside = float(band[0] <= computed <= band[1])

    @property
    def deviation(self):
        """Share by which it is off, or None."""
        if self.computed is None or not self.reference:
            return None
        return self.computed / self.reference - 1.

    @property
    def is_inside(self):
        return None if self.inside is None else self.inside >= 1.

    def judge(self, tolerances):
        limit = tolerances.get(self.quantity)
        if limit is None:
            return
        off = self.deviation if QUANTITIES[self.quantity][1] else self.computed
        self.met = off is not None and abs(off) <= limit


class Comparison:
    """run: a StudyRun; figures: [Figure]; remarks: lines; points, path: of the
    reference; scale: of the forces of the run to those of the reference."""

    def __init__(self, run, known):
        self.run, self.figures, self.remarks = run, [], []
        self.peak, self.curve, self.path = known.of(run.name)
        self.has_reference = bool(self.peak or self.path)
        self.scale = 1.
        if known.unit == "force_N_per_mm":
            self.scale = 1. / run.thickness if run.thickness else math.nan
            if not run.thickness:
                self.remarks.append("%s: the thickness is not known." % run.name)
        if run.summary.get("exit_status") != 0:
            self.remarks.append("%s has not finished: the peak is that of the steps so "
                                "far." % run.name)
        self.add_peak()
        self.add_curve()
        self.add_path()

    def add_peak(self):
        displacement, force = self.run.peak or (None, None)
        force = None if force is None or math.isnan(self.scale) else force * self.scale
        bands = (self.peak.scatter if self.peak else None) or (None, None)
        means = (self.peak.displacement, self.peak.force) if self.peak else (None, None)
        self.figures += [Figure("displacement", displacement, means[0], bands[0]),
                         Figure("peak", force, means[1], bands[1])]

    def own_curve(self):
        """(x, y) with forces as the reference has them, or None with a remark."""
        if not self.run.has_curve or math.isnan(self.scale):
            return None
        try:
            return curve_difference.increasing(
                self.run.results.column("displacement_mm"),
                self.scale * self.run.force.values, self.run.name)
        except StudyError as error:
            self.remarks.append(str(error))
            return None

    def add_curve(self):
        if not self.curve:
            return
        own = self.own_curve()
        found = own and curve_difference.difference(
            own, points_of(self.curve), self.run.summary.get("separated") is True)
        inside = None
        bands = [point.scatter and point.scatter[1] for point in self.curve]
        if own and all(bands):
            low, high = np.array(bands).T
            inside = curve_difference.share_inside(own, points_of(self.curve)[0],
                                                   low, high)
        self.figures += [
            Figure("curve", found.relative_l2 if found else None, inside=inside),
            Figure("area", found.relative_area if found else None)]
        if found and found.covered < 0.999:
            self.remarks.append("%s: the curves have %.0f %% of the reference's "
                                "displacements in common." % (self.run.name,
                                                              100. * found.covered))

    def own_path(self):
        return [np.array(line) for line in
                crack_path.lines_at_end(self.run.results.directory) or ()]

    def add_path(self):
        if not self.path:
            return
        own, others = self.own_path(), [np.array(line) for line in self.path.lines]
        if not own:
            self.remarks.append("%s: no path of a crack." % self.run.name)
            self.figures += [Figure("path", None), Figure("hausdorff", None)]
            return
        found, inside = polylines.apart(own, others), None
        if self.path.scatter is not None:
            inside = polylines.share_within(own, others, self.path.scatter)
        self.figures += [Figure("path", found.mean, inside=inside),
                         Figure("hausdorff", found.hausdorff)]


def points_of(curve):
    return (np.array([point.displacement for point in curve]),
            np.array([point.force for point in curve]))


def compared(runs, files, deviations=1.):
    """([Comparison], References). Raises StudyError for what is wrong with a file."""
    known = references.References(files, deviations)
    for name, curve in known.curves.items():
        curve_difference.increasing(*points_of(curve),
                                    "the reference '%s'" % (name or "of all runs"))
    found = [Comparison(run, known) for run in runs]
    if not any(entry.has_reference for entry in found):
        raise StudyError("no run has a reference: the runs are %s; the references "
                         "are for %s" % (", ".join(run.name for run in runs),
                                         ", ".join(known.names()) or "none"))
    return found, known


def read_tolerances(words):
    """{quantity: limit}, shares as 0.05 or 5%, distances in mm; 'scatter' is the
    number of figures that may lie outside."""
    found = {}
    for word in words:
        name, equals, text = word.partition("=")
        try:
            value = float(text.rstrip("%")) * (0.01 if text.endswith("%") else 1.)
        except ValueError:
            value = -1.
        if not equals or name not in list(QUANTITIES) + ["scatter"] \
                or not 0. <= value < math.inf:
            raise StudyError("--tolerance: expected NAME=NUMBER with %s or scatter, "
                             "shares as 0.05 or 5%%, found '%s'"
                             % (", ".join(QUANTITIES), word))
        found[name] = value
    return found


def judged(found, tolerances):
    """Lines that say what does not meet a tolerance; [] when all does. Without a
    figure of a quantity with a tolerance nothing is met."""
    missed, figures = [], [(entry.run.name, figure) for entry in found
                           if entry.has_reference for figure in entry.figures]
    for run, figure in figures:
        figure.judge(tolerances)
        if figure.met is False:
            missed.append("%s: %s %s, allowed %g" % (
                run, figure.quantity, shown_deviation(figure),
                tolerances[figure.quantity]))
    for name in tolerances:
        if not any(f.inside is not None if name == "scatter" else f.quantity == name
                   and (f.reference or not QUANTITIES[name][1]) for _, f in figures):
            missed.append("%s: no run has such a reference" % name)
    n_outside = sum(figure.is_inside is False for _, figure in figures)
    if n_outside > tolerances.get("scatter", math.inf):
        missed.append("scatter: %d figures lie outside, allowed %g"
                      % (n_outside, tolerances["scatter"]))
    return missed


def shown_deviation(figure):
    if figure.computed is None:
        return "is not known"
    if figure.deviation is not None:
        return "is off by %+.3g" % figure.deviation
    return "is %.4g" % figure.computed
