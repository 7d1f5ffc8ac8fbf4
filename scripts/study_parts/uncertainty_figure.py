# SPDX-License-Identifier: GPL-2.0-or-later
"""The bundle of paths and curves of a case and its variations."""
import matplotlib
import numpy as np
from matplotlib.figure import Figure

from report_parts import curves, pictures
from sweep_parts.study_curves import HUES

from . import comparison_figure, variations

COLORS = HUES[:7]
DASHES = ("-", (0, (4, 1.5)), (0, (1.5, 1.2)))


def styles(found):
    """[(color, dashes)] of the differences: a colour per group."""
    groups, used, result = found.groups(), {}, []
    for d in found.differences:
        group = d.variation.group
        result.append((COLORS[groups.index(group) % len(COLORS)],
                       DASHES[used.get(group, 0) % len(DASHES)]))
        used[group] = used.get(group, 0) + 1
    return result


def label_of(variation):
    return "%s: %s" % (variations.title_of(variation.group),
                       variation.name.replace("_", " "))


def draw_curve(axes, run, color, dash, label, width):
    if run is None or not run.has_curve:
        return
    x, y = run.results.column("displacement_mm"), run.force.values
    axes.plot(x, y, ls=dash, color=color, lw=width, label=label)
    axes.plot(x[run.force.peak], y[run.force.peak], "o", color=color, ms=3.5)


def draw_paths(axes, found, base_run, kinds):
    comparison_figure.draw_outline(axes, base_run)
    for d, (color, dash) in zip(found.differences, kinds):
        for line in d.answer.lines if d.answer else ():
            axes.plot(line[:, 0], line[:, 1], ls=dash, color=color, lw=0.9)
    for line in found.base.lines:
        axes.plot(line[:, 0], line[:, 1], "-", color=curves.INK, lw=1.5)


def draw(found, base_run, runs):
    """runs: StudyRun or None for every difference. Curves to the left; the paths over
    the body in the middle and, where there are any, as near as they lie to the right."""
    kinds = styles(found)
    with matplotlib.rc_context(curves.STYLE):
        figure = Figure(figsize=(11.5, 4.6), facecolor="white")
        axes = figure.subplots(1, 3, width_ratios=(1.45, 0.85, 1.15))
        for d, run, (color, dash) in zip(found.differences, runs, kinds):
            draw_curve(axes[0], run, color, dash, label_of(d.variation), 1.)
        draw_curve(axes[0], base_run, curves.INK, "-", "as it is", 1.6)
        axes[0].set(xlabel="Displacement (mm)", ylabel="Force (N)")
        axes[0].legend(loc="upper left", fontsize=7.6, handlelength=2.4)
        for part in axes[1:]:
            draw_paths(part, found, base_run, kinds)
        lines = found.base.lines + [line for d in found.differences if d.answer
                                    for line in d.answer.lines]
        if lines:
            pictures.show(axes[2], pictures.window_of(np.concatenate(lines)))
        figure.subplots_adjust(left=0.06, right=0.995, top=0.98, bottom=0.11,
                               wspace=0.08)
        return figure
