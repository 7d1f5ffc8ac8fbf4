# SPDX-License-Identifier: GPL-2.0-or-later
"""Force-displacement curves of all runs of a sweep in one figure."""
import os

import matplotlib
import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from report_parts import curves, safe
from study_parts import drawing, references
from study_parts.errors import StudyError

# Told apart by hue and, where that fails, by lightness.
HUES = ("#2f6690", "#b5403a", "#4f8a5b", "#c08a2d", "#6d4c8f", "#3a8f93",
        "#8a5a3c", "#5c6670")
DASHES = ("-", (0, (5, 1.5)), (0, (1.5, 1.2)), (0, (6, 1.5, 1.5, 1.5)))


def shade(color, share):
    """Lighter for a share below 1, as it is for 1."""
    rgb = np.array(to_rgb(color))
    return tuple(1. - (1. - rgb) * (0.4 + 0.6 * share))


def styles_of(runs):
    """{name: (color, dashes)}: a hue per group, within it from light to full,
    in the order of the sweep. A hue per run where grouping tells nothing."""
    groups = safe.grouped(runs, lambda run: run.group)
    if len(groups) in (1, len(runs)):
        groups = {run.name: [run] for run in runs}
    styles = {}
    for i, own in enumerate(groups.values()):
        for k, run in enumerate(own):
            share = (k + 1.) / len(own)
            # from the ninth group on hues repeat: another dash tells
            dash = DASHES[(i // len(HUES) + len(own) - 1 - k) % len(DASHES)]
            styles[run.name] = shade(HUES[i % len(HUES)], share), dash
    return styles


class ReferenceCurve:
    """Points of a file that belong together; bars where tests scatter."""

    def __init__(self, label, name, points):
        self.label, self.name = label, name
        self.x = np.array([point.displacement for point in points])
        self.y = np.array([point.force for point in points])
        self.bars = None  # below and above of x, and of y
        if points[0].scatter is not None:
            # lengths below and above the means, (2, n)
            self.bars = [np.abs(np.array([
                point.scatter and point.scatter[k] or (mean, mean)
                for point, mean in zip(points, means)]).T - means)
                         for k, means in enumerate((self.x, self.y))]

    def scale_forces(self, factor):
        self.y *= factor
        if self.bars:
            self.bars[1] *= factor

    def draw(self, axes, color):
        if self.bars:
            axes.errorbar(self.x, self.y, xerr=self.bars[0], yerr=self.bars[1],
                          fmt="x", color=color, ms=7, mew=1.6, lw=1., capsize=2.5,
                          label=self.label)
        elif len(self.x) > 2:
            axes.plot(self.x, self.y, ls=(0, (1, 1.5)), color=color, lw=2.2,
                      label=self.label)
        else:
            axes.plot(self.x, self.y, "x", color=color, ms=8, mew=2.,
                      label=self.label)


def reference_curves(paths, runs, per_thickness):
    """[ReferenceCurve], with forces as the curves of the runs have them."""
    found = []
    for path in paths:
        groups = safe.grouped(references.read_points(path), lambda point: point.name)
        stem = os.path.splitext(os.path.basename(path))[0]
        for name, points in groups.items():
            curve = ReferenceCurve((stem + " " + name).strip(), name, points)
            if (points[0].unit == "force_N_per_mm") != per_thickness:
                # of the runs that it belongs to, or of the first one
                t = (runs_for(name, runs) or runs)[0].thickness
                if t is None:
                    raise StudyError(
                        "%s: no run tells its thickness, which its forces need" % path)
                curve.scale_forces(1. / t if per_thickness else t)
            found.append(curve)
    return found


def runs_for(name, runs):
    return [run for run in runs if references.name_for(run.name, (name,))]


def color_for(name, runs, styles):
    """That of the run, if the reference belongs to one only."""
    own = runs_for(name, runs)
    return styles[own[0].name][0] if len(own) == 1 else curves.INK


def draw(runs, title, per_thickness, references):
    """The figure."""
    drawn = [run for run in runs if run.has_curve]
    if not drawn:
        raise StudyError("no run has a force and a displacement yet")
    if per_thickness and any(run.thickness is None for run in drawn):
        raise StudyError(
            "--per-thickness: '%s' tells no thickness, neither in summary.json nor "
            "in parameters.prm" % next(r.name for r in drawn if r.thickness is None))
    references = reference_curves(references, drawn, per_thickness)
    styles = styles_of(drawn)
    n_entries = len(drawn) + len(references)
    with matplotlib.rc_context(curves.STYLE):
        figure = Figure(figsize=(9.6, max(5., 0.21 * n_entries + 1.)), facecolor="white")
        axes = figure.add_subplot()
        for run in drawn:
            color, dash = styles[run.name]
            scale = 1. / run.thickness if per_thickness else 1.
            x, y = run.results.column("displacement_mm"), scale * run.force.values
            axes.plot(x, y, ls=dash, color=color, lw=1.5, label=run.name)
            axes.plot(x[run.force.peak], y[run.force.peak], "o", color=color, ms=4)
        for reference in references:
            reference.draw(axes, color_for(reference.name, drawn, styles))
        axes.axhline(0., color=curves.GREY, lw=0.7)
        drawing.label(axes, per_thickness)
        if title:
            axes.set_title(title, loc="left", fontsize=11.5)
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.), fontsize=8.8,
                    handlelength=2.6, borderaxespad=0.)
        return figure


def write(runs, path, title, per_thickness, references):
    drawing.save(draw(runs, title, per_thickness, references), path, "curves", 130)
