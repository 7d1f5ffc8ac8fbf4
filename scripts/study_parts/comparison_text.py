# SPDX-License-Identifier: GPL-2.0-or-later
"""A comparison as Markdown, and as CSV with a row per run and quantity."""
import csv
import io

from . import comparison

PEAK_HEAD = ("| run | displacement at peak (mm) | reference | deviation | "
             "peak force (%s) | reference | deviation |\n"
             "|---|---:|---:|---:|---:|---:|---:|\n")
SHAPE_HEAD = ("| run | curve, relative L2 | area between | path, mean distance (mm) | "
              "Hausdorff distance (mm) |\n|---|---:|---:|---:|---:|\n")
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
    if figure.computed is None:
        cells = [NONE]
    else:
        cells = ["%.4g" % figure.computed]
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
    counts = {}
    for entry in found:
        for figure in entry.figures:
            if figure.inside is not None:
                count = counts.setdefault(entry.run.group, [0, 0])
                count[0] += figure.is_inside
                count[1] += 1
    return ["%s: %d of %d figures lie within the scatter." % (group, *count)
            for group, count in counts.items()]


def markdown(found, known, missed=()):
    text = PEAK_HEAD % comparison.UNITS[known.unit]
    for entry in found:
        cells = sum(map(peak_cells, entry.figures[:2]), [])
        text += "| %s |\n" % " | ".join([entry.run.name] + cells)
    if known.curves or known.paths:
        text += "\n" + SHAPE_HEAD
        for entry in found:
            by_name = {figure.quantity: figure for figure in entry.figures}
            text += "| %s |\n" % " | ".join([entry.run.name] + [
                shape_cell(by_name.get(name))
                for name in ("curve", "area", "path", "hausdorff")])
    used = set().union(*(known.used_by(entry.run.name) for entry in found))
    unused = [name for name in known.names() if name not in used]
    remarks = [remark for entry in found for remark in entry.remarks]
    remarks += scatter_counts(found)
    if unused:
        remarks.append("In the reference only: %s." % ", ".join(unused))
    remarks += ["Tolerance not met: %s." % line for line in missed]
    return text + ("\n" + "".join("- %s\n" % remark for remark in remarks)
                   if remarks else "")


def as_text(value):
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else "%.10g" % value


def table(found, known):
    """The text of a CSV file; shares as numbers, 0.05 for 5 %."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(COLUMNS)
    for entry in found:
        for figure in entry.figures:
            unit = comparison.QUANTITIES[figure.quantity][0]
            unit = {None: comparison.UNITS[known.unit], "%": "1"}.get(unit, unit)
            low, high = figure.band or (None, None)
            writer.writerow(map(as_text, (
                entry.run.name, figure.quantity, unit, figure.computed,
                figure.reference, figure.deviation, low, high, figure.inside,
                figure.met)))
    return stream.getvalue()
