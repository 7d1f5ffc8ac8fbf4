# SPDX-License-Identifier: GPL-2.0-or-later
"""A comparison as Markdown, and as CSV with a row per run and quantity."""
from sweep_parts.table import csv_text

from . import comparison

SHAPES = ("run", "curve, relative L2", "area between", "path, mean distance (mm)",
          "Hausdorff distance (mm)")
COLUMNS = ("run", "quantity", "unit", "computed", "reference", "deviation", "low",
           "high", "inside", "tolerance_met")
NONE = "–"


def verdict(figure):
    """Behind a value; of a curve or a path with the share that lies inside."""
    if figure.inside is None:
        return ""
    word = ", within" if figure.is_inside else ", **outside**"
    if figure.band is None and not figure.is_inside:
        word += " (%.0f %% within)" % (100. * figure.inside)
    return word


def peak_cells(figure):
    cells = [NONE if figure.computed is None else "%.4g" % figure.computed]
    if figure.reference is None:
        return cells + [NONE, NONE]
    band = " (%.4g to %.4g)" % figure.band if figure.band else ""
    off = NONE if figure.deviation is None else "%+.1f %%" % (100. * figure.deviation)
    return cells + ["%.4g%s" % (figure.reference, band), off + verdict(figure)]


def shape_cell(figure):
    if figure is None or figure.computed is None:
        return NONE
    text = "%.1f %%" % (100. * figure.computed) \
        if comparison.QUANTITIES[figure.quantity][0] == "%" else \
        "%.3g" % figure.computed
    return text + verdict(figure)


def scatter_counts(found):
    """A line per group of runs, of those that have scatter."""
    groups = {}
    for entry in found:
        groups.setdefault(entry.run.group, []).extend(
            figure.is_inside for figure in entry.figures if figure.inside is not None)
    return ["%s: %d of %d figures lie within the scatter." % (group, sum(own), len(own))
            for group, own in groups.items() if own]


def grid(head, rows):
    """A table in Markdown; what stands behind the first column is numbers."""
    return "| %s |\n|%s\n%s" % (
        " | ".join(head), "---|" + (len(head) - 1) * "---:|",
        "".join("| %s |\n" % " | ".join(row) for row in rows))


def markdown(found, known, missed=()):
    text = grid(("run", "displacement at peak (mm)", "reference", "deviation",
                 "peak force (%s)" % comparison.UNITS[known.unit], "reference",
                 "deviation"), (
        [entry.run.name] + sum(map(peak_cells, entry.figures[:2]), [])
        for entry in found))
    if known.curves or known.paths:
        by_name = [{figure.quantity: figure for figure in entry.figures}
                   for entry in found]
        text += "\n" + grid(SHAPES, (
            [entry.run.name] + [shape_cell(own.get(name)) for name in
                                ("curve", "area", "path", "hausdorff")]
            for entry, own in zip(found, by_name)))
    used = set().union(*(known.used_by(entry.run.name) for entry in found))
    unused = [name for name in known.names() if name not in used]
    remarks = [remark for entry in found for remark in entry.remarks]
    remarks += scatter_counts(found)
    if unused:
        remarks.append("In the reference only: %s." % ", ".join(unused))
    remarks += ["Tolerance not met: %s." % line for line in missed]
    return text + ("\n" + "".join("- %s\n" % remark for remark in remarks)
                   if remarks else "")


def table(found, known):
    """The text of a CSV file; shares as numbers, 0.05 for 5 %."""
    units = {None: comparison.UNITS[known.unit], "%": "1", "mm": "mm"}
    return csv_text(COLUMNS, (
        (entry.run.name, figure.quantity, units[comparison.QUANTITIES[figure.quantity][0]],
         figure.computed, figure.reference, figure.deviation,
         *(figure.band or (None, None)), figure.inside, figure.met)
        for entry in found for figure in entry.figures))
