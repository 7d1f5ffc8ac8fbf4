# SPDX-License-Identifier: GPL-2.0-or-later
"""The cracks at the last step, as crack_path.csv has their paths and in 3-d
crack_sheet.csv their sheets."""
import os

from .safe import csv_table, finite as as_number, read_text

PATHS, SHEETS = "crack_path.csv", "crack_sheet.csv"
NEEDED = ("step", "crack", "x_mm", "y_mm")


class Crack:
    """points [(x, y)] in order, from where the crack starts to where it ends."""

    def __init__(self, number, row):
        self.number = number
        self.start = (row.get("start") or "").strip()
        self.end = (row.get("end") or "").strip()
        self.length = as_number(row.get("length_mm"))
        self.angle = as_number(row.get("kink_angle_deg"))
        self.points = []


def rows_at_end(directory, name, remarks):
    """[(number of the crack, row as a dictionary)] at the last step of that file; None
    when there is no file. A step that was being written when the run was killed is
    left out when there is one before it."""
    text = read_text(os.path.join(directory, name))
    if text is None:
        return None
    lines = [line for line in text.splitlines() if line.strip()]
    closed = bool(lines) and lines[-1].startswith("#")
    names, rows, n_bad, cut = csv_table(text)
    cut = cut and not closed
    if any(name not in names for name in NEEDED):
        remarks.append("%s cannot be read: it has no header with the columns %s."
                       % (name, ", ".join(NEEDED)))
        return []
    steps = {}
    for values in rows:
        row = dict(zip(names, values))
        numbers = [as_number(row.get(column)) for column in NEEDED]
        if None in numbers:
            n_bad += 1
            continue
        steps.setdefault(int(numbers[0]), []).append((int(numbers[1]), row))
    if n_bad:
        remarks.append("%d line%s of %s could not be read."
                       % (n_bad, "" if n_bad == 1 else "s", name))
    if cut and len(steps) > 1:
        del steps[max(steps)]
    if not closed:
        remarks.append(
            "%s is incomplete: the run is still going on, or it was killed. " % name
            + ("The cracks shown are those of step %d." % max(steps) if steps
               else "It holds no step yet."))
    return steps[max(steps)] if steps else []


def cracks_at_end(directory, remarks):
    """The Cracks in the plane at the last step; None when there is no file."""
    rows = rows_at_end(directory, PATHS, remarks)
    if rows is None:
        return None
    cracks = {}
    for number, row in rows:
        crack = cracks.setdefault(number, Crack(number, row))
        crack.points.append((float(row["x_mm"]), float(row["y_mm"])))
    return [cracks[number] for number in sorted(cracks)]


def lines_at_end(directory):
    """Their points where there are several; None when there is no file."""
    cracks = cracks_at_end(directory, [])
    return cracks and [crack.points for crack in cracks if len(crack.points) > 1]
