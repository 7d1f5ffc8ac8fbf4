# SPDX-License-Identifier: GPL-2.0-or-later
"""One run over its reference: force and displacement, and the path of the crack."""
import matplotlib
import numpy as np
from matplotlib.figure import Figure

from report_parts import curves, pictures
from sweep_parts import study_cracks

from . import comparison, drawing

OWN, OTHER, BAND = curves.BLUE, curves.INK, "#c9d0d6"


def draw_outline(axes, run):
    """Of the body at the end, if it is flat, in axes without a frame."""
    fields, _ = study_cracks.fields_at_end(run)
    if fields is not None and pictures.is_flat(fields):
        pictures.draw_outline(axes, fields)
        pictures.show(axes, pictures.window_of(fields.points))
    axes.set_aspect("equal")
    axes.axis("off")


def draw_reference_curve(axes, points):
    x, y = comparison.points_of(points)
    bands = [point.scatter and point.scatter[1] for point in points]
    if all(bands):
        low, high = np.array(bands).T
        axes.fill_between(x, low, high, color=BAND, lw=0., label="scatter")
    axes.plot(x, y, ls=(0, (4, 1.5)), color=OTHER, lw=1.6, label="reference")


def draw_reference_peak(axes, peak):
    means = peak.displacement, peak.force
    for key, mean, band in zip(("xerr", "yerr"), means, peak.scatter or ()):
        if band is not None:
            axes.errorbar(*([value] for value in means), color=OTHER, lw=1., capsize=3.,
                          **{key: [[mean - band[0]], [band[1] - mean]]})
    axes.plot(*means, "x", color=OTHER, ms=8, mew=1.8, label="reference, peak")


def draw_curves(axes, entry, unit):
    run = entry.run
    if run.has_curve and not np.isnan(entry.scale):
        x = run.results.column("displacement_mm")
        y = entry.scale * run.force.values
        axes.plot(x, y, "-", color=OWN, lw=1.6, label=run.name, zorder=3)
        axes.plot(x[run.force.peak], y[run.force.peak], "o", color=OWN, ms=5, zorder=4)
    if entry.curve:
        draw_reference_curve(axes, entry.curve)
    elif entry.peak:
        draw_reference_peak(axes, entry.peak)
    drawing.label(axes, unit != "N")
    axes.legend(loc="best", fontsize=8.8)


def draw_paths(axes, entry):
    draw_outline(axes, entry.run)
    for line in entry.path.lines if entry.path else ():
        axes.plot(*zip(*line), ls=(0, (4, 1.5)), color=OTHER, lw=1.6)
    for line in entry.own_path():
        axes.plot(line[:, 0], line[:, 1], "-", color=OWN, lw=1.6)


def draw(entry, known):
    """The figure of a Comparison: the curves, and beside them the paths where the run
    or the reference has one."""
    with matplotlib.rc_context(curves.STYLE):
        has_path = bool(entry.path or entry.own_path())
        figure = Figure(figsize=(9.2 if has_path else 6.2, 4.2), facecolor="white")
        axes = figure.subplots(1, 2, width_ratios=(1.7, 1.)) if has_path \
            else [figure.subplots()]
        draw_curves(axes[0], entry, comparison.UNITS[known.unit])
        axes[0].set_title(entry.run.name, loc="left", fontsize=11.)
        if has_path:
            draw_paths(axes[1], entry)
        return figure
