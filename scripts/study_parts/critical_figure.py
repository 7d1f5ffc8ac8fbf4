# SPDX-License-Identifier: GPL-2.0-or-later
"""The answers of a bisection over the value that was varied, a line per run."""
import matplotlib
from matplotlib.figure import Figure

from report_parts import curves
from sweep_parts.study_curves import HUES

ROW = 0.42  # inches


def draw(critical):
    names = list(critical.known)
    answers = list(dict.fromkeys(
        answer for known in critical.known.values()
        for _, answer in sorted(known.items()) if answer is not None))
    with matplotlib.rc_context(curves.STYLE):
        figure = Figure(figsize=(7.6, 1.3 + ROW * len(names)), facecolor="white")
        axes = figure.subplots()
        for answer in answers:
            points = [(value, -row) for row, name in enumerate(names)
                      for value, own in critical.known[name].items() if own == answer]
            axes.plot(*zip(*points), "o", ms=6,
                      color=HUES[answers.index(answer) % len(HUES)], label=answer)
        for row, bracket in enumerate(critical.brackets().values()):
            axes.plot(bracket[:2], (-row, -row), "-", color=curves.INK, lw=5.,
                      alpha=0.35, solid_capstyle="butt")
        axes.set_yticks([-row for row in range(len(names))], names)
        axes.set_ylim(0.6 - len(names), 0.6)
        axes.grid(axis="y", visible=False)
        axes.set_xlabel(critical.entry.split("/")[-1])
        axes.legend(loc="lower left", bbox_to_anchor=(0., 1.), ncols=3, fontsize=8.8)
        return figure
