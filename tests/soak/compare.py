# SPDX-License-Identifier: GPL-2.0-or-later
"""Whether a run in pieces gives the results of an uninterrupted one.

What may differ, and why, stands in MAY_DIFFER and nowhere else.
"""
import csv
import json
import math
import pathlib
import re

# relative to the largest magnitude of a column
TOLERANCE = 1e-6
# In the step in which a crack runs through, and after it, the equations are
# as good as singular: rounding, which depends on the number of ranks and on
# which factors are at hand, is amplified.
TOLERANCE_SEPARATED = 1e-4

MACHINE = "depends on the machine and its load"
FACTORS = "a continued run begins without factors and makes them anew"
RANKS = "the number of ranks is what was changed"
SMALL = "difference of large columns that are compared, or a rest that " \
        "only has to be below its tolerance"

MAY_DIFFER = {
    "statistics.csv": {
        "wall_time_s": MACHINE,
        "factorizations": FACTORS,
        "newton_iterations": FACTORS,
        "linear_iterations": FACTORS,
        "coupling_iterations": FACTORS,
        "coupling_change": SMALL,
        "energy_imbalance_mJ": SMALL,
    },
    "summary.json": {
        "wall_time_s": MACHINE,
        "seconds_per_phase": MACHINE,
        "peak_memory_MB": MACHINE,
        "memory_MB_per_phase": MACHINE,
        "revision": "may change between two pieces",
        "ranks": RANKS,
        "linear_solver": RANKS,
        "factorizations": FACTORS,
        "newton_iterations": FACTORS,
        "coupling_iterations": FACTORS,
        "warnings": "a figure in it is rounded; their number is compared",
    },
    "crack_path.csv": {},
    "crack_opening.csv": {},
    "traction_profiles.csv": {},
}

# Figures of the mesh that are compared up to the step in which a crack runs through, but not
# from it on: that step goes through states that are far from equilibrium, and
# which of them asks for finer cells depends on rounding. What is found on either
# mesh is compared as everywhere.
WHILE_RUNNING = {"cells", "dofs", "active_set_size", "finest_cell_mm"}


class Difference(Exception):
    """What is not as in the uninterrupted run."""


def number(text):
    """The value of a cell, or None for one that is not a number."""
    try:
        return float(text)
    except ValueError:
        return None


def is_count(text):
    return re.fullmatch(r"[+-]?\d+", text) is not None


def table(path):
    """(rows, comments) of a CSV; each row must have all the columns."""
    lines = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    comments = [line for line in lines if line.startswith("#")]
    rows = list(csv.DictReader(line for line in lines
                               if not line.startswith("#")))
    for row in rows:
        if None in row or None in row.values():
            raise Difference("%s: a row has not the columns of the header: %r"
                             % (path, row))
    return rows, comments


def strict_json(path):
    """A JSON file; NaN and Infinity, which Python would read, are refused."""
    def refuse(word):
        raise ValueError("%s is no JSON" % word)
    text = pathlib.Path(path).read_text(encoding="utf-8")
    return json.loads(text, parse_constant=refuse)


def separation_step(directory):
    """The first step after the peak with less than half its force: that in
    which a crack has run; infinity without one."""
    peak = 0.
    for row in table(directory / "statistics.csv")[0]:
        force = math.sqrt(sum(float(value) ** 2 for name, value in row.items()
                              if name.startswith("force_")))
        if force < 0.5 * peak:
            return int(row["step"])
        peak = max(peak, force)
    return math.inf


def compare_cell(where, found, expected, largest, tolerance):
    """The difference relative to the largest magnitude of the column."""
    a, b = number(found), number(expected)
    if a is None or b is None or (is_count(found) and is_count(expected)):
        if found != expected:
            raise Difference("%s: %r, uninterrupted %r" % (where, found, expected))
        return 0.
    difference = abs(a - b) / largest if largest > 0. else abs(a - b)
    if not difference <= tolerance:
        raise Difference("%s: %s, uninterrupted %s: %.1e of the largest value "
                         "of the column, allowed %.0e"
                         % (where, found, expected, difference, tolerance))
    return difference


def compare_table(name, found_in, expected_in, separated):
    """{column: largest relative difference up to separation}."""
    found, found_comments = table(found_in / name)
    expected, comments = table(expected_in / name)
    if found_comments != comments:
        raise Difference("%s: %r, uninterrupted %r"
                         % (name, found_comments, comments))
    if len(found) != len(expected):
        raise Difference("%s: %d rows, uninterrupted %d"
                         % (name, len(found), len(expected)))
    if found and list(found[0]) != list(expected[0]):
        raise Difference("%s: columns %r, uninterrupted %r"
                         % (name, list(found[0]), list(expected[0])))
    result = {}
    for column in expected[0] if expected else []:
        if column in MAY_DIFFER[name]:
            continue
        values = [abs(number(row[column]) or 0.) for row in expected]
        for one, other in zip(found, expected):
            apart = int(other["step"]) >= separated
            if apart and column in WHILE_RUNNING:
                continue
            difference = compare_cell(
                "%s, step %s, %s" % (name, other["step"], column), one[column],
                other[column], max(values),
                TOLERANCE_SEPARATED if apart else TOLERANCE)
            if not apart:
                result[column] = max(result.get(column, 0.), difference)
    return result


def compare_summary(found_in, expected_in, separated):
    found = strict_json(found_in / "summary.json")
    expected = strict_json(expected_in / "summary.json")
    if set(found) != set(expected):
        raise Difference("summary.json: other keys: %s"
                         % sorted(set(found) ^ set(expected)))
    if len(found["warnings"]) != len(expected["warnings"]):
        raise Difference("summary.json: %d warnings, uninterrupted %d"
                         % (len(found["warnings"]), len(expected["warnings"])))
    for key, value in expected.items():
        if key in MAY_DIFFER["summary.json"] or (
                separated < math.inf and key in WHILE_RUNNING):
            continue
        if isinstance(value, float) and isinstance(found[key], (int, float)):
            scale = max(abs(value), 1.)
            # figures of the last step are those of the separated body
            if not abs(found[key] - value) <= TOLERANCE_SEPARATED * scale:
                raise Difference("summary.json: %s is %r, uninterrupted %r"
                                 % (key, found[key], value))
        elif found[key] != value:
            raise Difference("summary.json: %s is %r, uninterrupted %r"
                             % (key, found[key], value))


def listed_files(directory):
    text = (directory / "fields.pvd").read_text()
    return set(re.findall(r'file="([^"]+)"', text))


def compare_fields(found_in, expected_in):
    """Every file of fields is listed, there and whole."""
    if not (expected_in / "fields.pvd").exists():
        return
    listed = listed_files(found_in)
    missing = listed_files(expected_in) - listed
    if missing:
        raise Difference("fields.pvd does not list %s" % sorted(missing))
    for name in listed:
        path = found_in / name
        if not path.exists() or "</VTKFile>" not in path.read_text(
                errors="replace")[-200:]:
            raise Difference("%s is not whole" % name)


def compare(found_in, expected_in):
    """{column: largest relative difference}; raises Difference."""
    separated = separation_step(expected_in)
    result = {}
    for name in MAY_DIFFER:
        if not name.endswith(".csv"):
            continue
        if (found_in / name).exists() != (expected_in / name).exists():
            raise Difference("%s is there in one of the two only" % name)
        if (expected_in / name).exists():
            for column, value in compare_table(name, found_in, expected_in,
                                               separated).items():
                result[name + " " + column] = value
    compare_summary(found_in, expected_in, separated)
    compare_fields(found_in, expected_in)
    return result
