# SPDX-License-Identifier: GPL-2.0-or-later
"""Curves of a run as inline SVG."""
import io
import re

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from . import moments
from .quantities import label, words

INK, GREY, FAINT = "#22303c", "#6b7884", "#d9dfe4"
BLUE, RED, GREEN, OCHRE = "#2f6690", "#b5403a", "#4f8a5b", "#c08a2d"

STYLE = {
    "svg.fonttype": "none", "font.family": "DejaVu Sans", "font.size": 10,
    "text.color": INK, "axes.edgecolor": GREY, "axes.labelcolor": INK,
    "axes.linewidth": 0.7, "xtick.color": GREY, "ytick.color": GREY,
    "xtick.labelcolor": INK, "ytick.labelcolor": INK,
    "xtick.major.width": 0.7, "ytick.major.width": 0.7,
    "axes.grid": True, "grid.color": FAINT, "grid.linewidth": 0.6,
    "axes.axisbelow": True, "axes.spines.top": False, "axes.spines.right": False,
    "legend.frameon": False, "figure.facecolor": "none", "axes.facecolor": "none",
}


def svg_of(figure, name):
    """The <svg> element alone, with a width that follows the page."""
    stream = io.StringIO()
    with matplotlib.rc_context({"svg.hashsalt": name, "svg.fonttype": "none"}):
        figure.savefig(stream, format="svg", metadata={"Date": None})
    text = stream.getvalue()
    text = text[text.index("<svg"):]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = re.sub(r'(<svg[^>]*?) height="[^"]*"', r"\1", text, count=1)
    text = re.sub(r'(<svg[^>]*?) width="[^"]*"', r'\1 width="100%"', text, count=1)
    # several drawings share one page: their ids must not meet
    return re.sub(r'((?:\bid="|url\(#|xlink:href="#))', r"\g<1>" + name + "-", text)


def drawing(width, height):
    figure = Figure(figsize=(width, height))
    return figure, figure.add_axes([0.085, 0.14, 0.895, 0.83])


def is_known(values):
    return values is not None and np.isfinite(values).any()


def displacement_of(results):
    """(values, label) of the horizontal axis: where nothing is moved, time."""
    known = [(results.column(name), label(name))
             for name in ("displacement_mm", "time_s") if is_known(results.column(name))]
    if not known:
        return np.arange(results.n_steps, dtype=float), "Step"
    return next((pair for pair in known if np.nanmax(np.abs(pair[0])) > 0.), known[0])


def annotated(axes, x, y, text, color, offset, align="left"):
    axes.plot([x], [y], "o", ms=7, mfc="white", mec=color, mew=1.6, zorder=5)
    axes.annotate(text, (x, y), xytext=offset, textcoords="offset points",
                  color=color, ha=align, va="center", zorder=6)


def force_curve(results, force):
    """Force over displacement, or None when no force was written."""
    if force.values is None:
        return None
    x, x_label = displacement_of(results)
    with matplotlib.rc_context(STYLE):
        figure, axes = drawing(9.2, 4.3)
        axes.axhline(0., color=GREY, lw=0.7)
        axes.plot(x, force.values, "-", color=BLUE, lw=1.6)
        axes.plot(x, force.values, "o", color=BLUE, ms=2.6)
        top = force.values[force.peak]
        if top > 0.:
            mark_peak_and_separation(axes, x, force,
                                     x_label.partition("(")[2].rstrip(")"))
            axes.set_ylim(min(0., np.nanmin(force.values)) - 0.02 * top, 1.14 * top)
        label_axes(axes, x, x_label, force.label)
        return svg_of(figure, "force")


def label_axes(axes, x, x_label, y_label):
    """With 0 in sight, where x is not 0 throughout."""
    if np.nanmax(x) > 0.:
        axes.set_xlim(min(0., np.nanmin(x)), 1.04 * np.nanmax(x))
    axes.set(xlabel=x_label, ylabel=y_label)


def mark_peak_and_separation(axes, x, force, unit):
    top = force.values[force.peak]
    annotated(axes, x[force.peak], top,
              "peak: %.4g N at %.4g %s" % (top, x[force.peak], unit), RED,
              (-11, 11), "right")
    if force.separation is not None:
        left = force.values[force.separation]
        annotated(axes, x[force.separation], left,
                  "%s: %.3g N left (%.0f %%)"
                  % (force.fall_in_words, left, 100. * left / top),
                  GREEN, (-11, 9 if left < 0.1 * top else -12), "right")


def energy_curves(results):
    """Energies over displacement, or None when none was written."""
    x, x_label = displacement_of(results)
    columns = {"external_work_mJ": INK, "elastic_energy_mJ": BLUE,
               "crack_energy_mJ": RED}
    with matplotlib.rc_context(STYLE):
        figure, axes = drawing(9.2, 3.7)
        drawn = []
        for name, color in columns.items():
            values = results.column(name)
            if is_known(values):
                drawn += axes.plot(x, values, color=color, lw=1.5, label=words(name))
        rest = moments.imbalance(results)
        if rest is not None:
            drawn += axes.plot(x, rest, "--", color=OCHRE, lw=1.5,
                               label="imbalance (work − elastic − crack growth)")
        if not drawn:
            return None
        axes.legend(loc="upper left", fontsize=9.5)
        label_axes(axes, x, x_label, "Energy (mJ)")
        return svg_of(figure, "energy")


def step_curves(results):
    """What a step cost and how far the phase field moved: for whoever wants
    to know whether the curve above was resolved. None without columns."""
    steps = results.column("step")
    rows = [(name, words(name).replace(" ", "\n"), color) for name, color in (
                ("newton_iterations", BLUE), ("coupling_iterations", GREEN))]
    rows += [("max_phase_field_change", "largest change\nof φ", RED),
             ("cells", words("cells"), INK)]
    rows = [row for row in rows if results.column(row[0]) is not None]
    if not rows or steps is None:
        return None
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(9.2, 0.5 + 1.05 * len(rows)))
        all_axes = figure.subplots(len(rows), 1, sharex=True, squeeze=False)[:, 0]
        for axes, (name, text, color) in zip(all_axes, rows):
            axes.step(steps, results.column(name), where="mid", color=color, lw=1.2)
            axes.set_ylabel(text, fontsize=8.5)
            axes.set_ylim(bottom=0.)
            axes.yaxis.set_major_locator(MaxNLocator(3))
            axes.tick_params(labelsize=8.5)
        all_axes[-1].set_xlabel("Accepted step")
        figure.align_ylabels()
        figure.subplots_adjust(left=0.105, right=0.98, top=0.98,
                               bottom=0.5 / (0.5 + 1.05 * len(rows)), hspace=0.22)
        return svg_of(figure, "steps")
