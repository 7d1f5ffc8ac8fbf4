# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of what was identified, as SVG or PNG."""
import contextlib
import os

import matplotlib
import numpy as np
from matplotlib.figure import Figure

from report_parts import curves
from study_parts import drawing
from sweep_parts.study_curves import HUES

from . import tear
from .laws import MODES, existing

MARKS = ("o", "s", "^", "D", "v", "P", "X", "*")


@contextlib.contextmanager
def panels(path, n_panels, name="identify"):
    """Axes side by side, to be drawn in; then they are saved."""
    with matplotlib.rc_context(curves.STYLE):
        figure = Figure(figsize=(5.4 * n_panels + 0.6, 3.9), facecolor="white")
        figure.subplots_adjust(wspace=0.24)
        yield figure.subplots(1, n_panels, squeeze=False)[0]
        drawing.save(figure, path, name, 130)


def draw_law(axes, fit, interval):
    """Data of each test, and the law in every mode that is tested or, without
    tests, in all."""
    modes = [mode for mode in MODES if mode in [test.kind for test in fit.tests]]
    for mode in modes or MODES:
        stretch = existing(fit.law, fit.constants, mode, np.linspace(
            *drawn_range(fit, mode, interval), 400))
        axes.plot(stretch, fit.law.nominal_stress(fit.constants, mode, stretch),
                  "-", lw=1.5, color=HUES[MODES.index(mode)],
                  label="%s, %s" % (fit.law.name, mode))
    for i, test in enumerate(fit.tests):
        color = HUES[MODES.index(test.kind)]
        axes.plot(test.stretch, test.stress, MARKS[i % len(MARKS)], ms=4.5,
                  color=color, mfc="none", label="%s, %s" % (test.name, test.kind))
        if len(test.outside[0]):
            axes.plot(*test.outside, MARKS[i % len(MARKS)], ms=3.5, mfc="none",
                      color=curves.GREY, alpha=0.6, label="not used")
    axes.set(xlabel="Stretch", ylabel="Nominal stress (MPa)")
    axes.legend(fontsize=8.5)


def drawn_range(fit, mode, interval):
    """Of the tests of that mode, from the state at rest on."""
    own = [test.stretch for test in fit.tests if test.kind == mode]
    if not own:
        return interval
    every = np.append(np.concatenate(own), 1.)
    return every.min(), every.max()


def draw_bulk(axes, bulk):
    for test in bulk.tests:
        for values, color in ((test.outside, curves.GREY),
                              ((test.stretch, test.stress), HUES[0])):
            axes.plot(values[0], -values[1], "o", ms=4.5, mfc="none", color=color)
    volume = np.array([min(test.stretch.min() for test in bulk.tests),
                       max(test.stretch.max() for test in bulk.tests)])
    axes.plot(volume, -bulk.slope * (volume - bulk.zero), "-", color=HUES[1],
              label="K = %.5g MPa" % bulk.modulus)
    axes.set(xlabel="Volume ratio J", ylabel="Pressure (MPa)")
    axes.legend()


def draw_ranges(axes, tests, fit, ranges):
    """The tensile curve with its lines through the origin; fit: may be None."""
    largest = max(percent for _, values in ranges for percent, _ in values)
    for test in tests:
        axes.plot(100. * (test.stretch - 1.), test.stress, "o", ms=4.5, mfc="none",
                  color=curves.INK, label=test.name)
    if fit is not None:
        strain = np.linspace(0., 0.01 * largest, 300)
        axes.plot(100. * strain, fit.law.nominal_stress(
            fit.constants, "uniaxial", 1. + strain), "-", lw=1.2, color=curves.INK,
            label=fit.law.name)
    for i, (percent, modulus) in enumerate(ranges[0][1]):
        axes.plot([0., percent], [0., 0.01 * percent * modulus], "-", lw=1.8,
                  color=HUES[i % len(HUES)],
                  label="up to %g %%: E = %.3g MPa" % (percent, modulus))
    axes.set(xlim=(0., 1.05 * largest), xlabel="Engineering strain (%)",
             ylabel="Nominal stress (MPa)")
    axes.legend(fontsize=8.5)


def write_fit(path, fit, interval, ranges):
    with panels(path, 1 + (fit.bulk is not None) + bool(ranges)) as axes:
        draw_law(axes[0], fit, interval)
        if fit.bulk is not None:
            draw_bulk(axes[1], fit.bulk)
        if ranges:
            draw_ranges(axes[-1], [test for test in fit.tests
                                   if test.kind == "uniaxial"], fit, ranges)


def write_ranges(path, tests, ranges):
    """Without a law: the first test and its lines."""
    with panels(path, 1) as axes:
        draw_ranges(axes[0], tests[:1], None, ranges)


def draw_forces(axes, specimen, onset):
    every = ([] if specimen.uncracked is None else [specimen.uncracked]) \
        + specimen.standing + specimen.growing
    for i, curve in enumerate(every):
        axes.plot(curve.displacement, curve.force, "-", lw=1.4,
                  color=HUES[i % len(HUES)],
                  label=os.path.basename(curve.name))
    axes.axvline(onset, color=curves.GREY, lw=0.9, ls=(0, (4, 2)), label="onset")
    axes.set(xlabel="Displacement (mm)", ylabel="Force (N)")
    axes.legend(fontsize=8.5)


def draw_rates(axes, points):
    names = list(dict.fromkeys(point.curve for point in points))
    for i, method in enumerate(tear.METHODS):
        for name in names:
            own = [point for point in points
                   if point.method == method and point.curve == name]
            if own:
                axes.plot([point.length for point in own],
                          [point.value for point in own], "-", lw=1., ms=4.5,
                          marker=MARKS[i], mfc="none", color=HUES[i], label=method)
    axes.set_ylim(bottom=min(0., axes.dataLim.y0))
    axes.set(xlabel="Crack length (mm)", ylabel="Energy release rate G (N/mm)")
    known = dict(reversed(list(zip(*reversed(axes.get_legend_handles_labels())))))
    axes.legend(known.values(), known.keys(), fontsize=8.5)


def write_tear(path, specimen, onset, points):
    with panels(path, 2, "tear") as axes:
        draw_forces(axes[0], specimen, onset)
        draw_rates(axes[1], points)
