# SPDX-License-Identifier: GPL-2.0-or-later
"""The opening along the lines of a run, compared with an exact one."""
import os

import matplotlib
import numpy as np
from matplotlib.figure import Figure

from report_parts import curves, safe
from study_parts import drawing

from . import studies
from .study_curves import HUES

NEEDED = ("step", "line", "x_mm", "y_mm", "opening_mm")
FUNCTIONS = {name: getattr(np, name) for name in
             ("sqrt", "sin", "cos", "exp", "log", "abs", "where", "pi")}


def read_lines(directory):
    """{number of the line: (coordinates, openings)} of the last step, mm. The
    coordinate is the one in which the line extends most."""
    path = os.path.join(directory, "crack_opening.csv")
    names, lines, _, _ = safe.csv_table(safe.read_text(path) or "")
    if any(name not in names for name in NEEDED):
        raise studies.StudyError("%s cannot be read: it has no header with the "
                                 "columns %s" % (path, ", ".join(NEEDED)))
    rows = [dict(zip(names, map(safe.finite, line))) for line in lines]
    rows = [row for row in rows if None not in row.values()]
    lines = safe.grouped((row for row in rows if row["step"] == rows[-1]["step"]),
                         lambda row: int(row["line"]))
    found = {}
    for number, line in lines.items():
        points = np.array([[row[name] for name in ("x_mm", "y_mm", "z_mm")
                            if name in row] for row in line])
        axis = int(np.ptp(points, axis=0).argmax())
        found[number] = points[:, axis], np.array([row["opening_mm"] for row in line])
    if not found:
        raise studies.StudyError("%s holds no openings" % path)
    return found


def exact_values(expression, x):
    """nan where it has no value, as a root beyond the tip of a crack."""
    try:
        with np.errstate(all="ignore"):
            values = eval(expression, {"__builtins__": {}},  # pylint: disable=W0123
                          dict(FUNCTIONS, x=x))
    except Exception as error:
        raise studies.StudyError("--exact: '%s' cannot be evaluated (%s)"
                                 % (expression, error))
    return np.broadcast_to(np.asarray(values, float), x.shape)


def draw(lines, exact):
    with matplotlib.rc_context(curves.STYLE):
        figure = Figure(figsize=(6.4, 3.6), facecolor="white")
        axes = figure.add_subplot()
        for i, (number, (x, opening)) in enumerate(sorted(lines.items())):
            axes.plot(x, opening, "o", ms=4, color=HUES[i % len(HUES)],
                      label="computed" if len(lines) == 1
                      else "computed, line %d" % number)
        if exact:
            every = np.concatenate([x for x, _ in lines.values()])
            x = np.linspace(every.min(), every.max(), 2001)
            axes.plot(x, exact_values(exact, x), "-", lw=1.4, color=curves.INK,
                      label="exact")
        axes.axhline(0., color=curves.GREY, lw=0.7)
        axes.set(xlabel="Position (mm)", ylabel="Opening (mm)")
        axes.legend()
        return figure


def write(directory, path, exact):
    drawing.save(draw(read_lines(directory), exact), path, "opening", 130)
