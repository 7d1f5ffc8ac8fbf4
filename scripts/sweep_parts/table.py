# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of a run, from its summary.json and statistics.csv, and files of tables.
Python's own library only: a cluster may have no numpy."""
import csv
import io
import math
import os

from report_parts import safe

RESULTS = ("separated", "force_fell", "outcome", "start",
           "peak_force_N", "displacement_at_peak_mm", "end_displacement_mm",
           "remaining_force_fraction", "steps", "rejected_steps", "refinements",
           "coupling_iterations", "factorizations", "dofs", "proportional_steps",
           "wall_time_s")
SOFTENING = 0.02  # fall of force / displacement that ends proportionality


def summary_of(directory):
    """summary.json; empty when it is missing or damaged."""
    text = safe.read_text(os.path.join(directory, "summary.json"))
    try:
        return safe.json_object(text or "")
    except ValueError:
        return {}


def statistics_of(directory):
    """[{column: number}] of the rows that are whole, without what is empty or not
    finite."""
    text = safe.read_text(os.path.join(directory, "statistics.csv"))
    names, lines, _, _ = safe.csv_table(text or "")
    return [{name: safe.finite(value) for name, value in zip(names, line)
             if safe.finite(value) is not None}
            for line in lines if all(map(safe.is_number_or_empty, line))]


def last_step(directory):
    """Number of the last accepted step in statistics.csv; -1 without any."""
    rows = statistics_of(directory)
    return int(rows[-1].get("step", -1)) if rows else -1


def force_column(rows):
    """The component along the load: the largest one."""
    names = [name for name in ("force_x_N", "force_y_N", "force_z_N")
             if any(name in row for row in rows)]
    return max(names, key=lambda name: max(abs(row.get(name, 0.)) for row in rows),
               default=None)


def proportional_steps(rows):
    """Accepted load steps before the first one whose force / displacement is
    more than 2 % below that of the first load step; None without any."""
    rows = [row for row in rows if row.get("step", 0) >= 1
            and row.get("displacement_mm")]
    if not rows:
        return None
    force = force_column(rows)
    if force is None:
        return None
    stiffness = [abs(row.get(force, 0.)) / abs(row["displacement_mm"])
                 for row in rows]
    return next((count for count, value in enumerate(stiffness)
                 if not value >= (1. - SOFTENING) * stiffness[0]), len(rows))


def results_of(directory):
    """{column of RESULTS: value}; None for what is not known."""
    summary, rows = summary_of(directory), statistics_of(directory)
    last = rows[-1] if rows else {}

    def total(column):
        values = [row[column] for row in rows if column in row]
        return sum(values) if values else None

    # without a summary
    known = {"steps": last.get("step"), "wall_time_s": last.get("wall_time_s"),
             "end_displacement_mm": last.get("displacement_mm")}
    known.update((column, total(column)) for column in (
        "rejected_steps", "coupling_iterations", "factorizations"))
    results = {column: summary.get(column, known.get(column)) for column in RESULTS}
    results.update(start=summary.get("outcome_start"),
                   refinements=last.get("refinements"),
                   dofs=last.get("dofs", summary.get("dofs")),
                   proportional_steps=proportional_steps(rows))
    return results


def as_text(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return "%.10g" % value if math.isfinite(value) else ""
    return "" if value is None else str(value)


def csv_text(columns, rows):
    """A CSV file, as text: the names of the columns, and rows of values."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(map(as_text, row) for row in rows)
    return stream.getvalue()
