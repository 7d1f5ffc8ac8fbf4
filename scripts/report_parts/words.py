# SPDX-License-Identifier: GPL-2.0-or-later
"""A run in words and in tables: title, case, figures, remarks."""
import math
import os

from . import moments
from .quantities import label, words_and_unit
from .safe import finite


# of a summary, in the table of a run: what comes first, and what has another name
FIRST = ("program", "version", "revision", "case", "ranks", "cells", "dofs", "steps",
         "coupling", "peak_force_N", "displacement_at_peak_mm", "time_at_peak_s",
         "remaining_force_fraction", "separated", "force_fell", "outcome",
         "outcome_start", "exit_reason", "exit_status", "wall_time_s")
LABELS = {"dofs": "Unknowns", "steps": "Accepted steps", "wall_time_s": "Wall time",
          "remaining_force_fraction": "Remaining force / peak",
          "outcome_start": "Crack starts at"}


def title_of(results):
    name = os.path.basename(os.path.realpath(results.directory))
    name = name.replace("_", " ").replace("-", " ").strip() or "result"
    return name[0].upper() + name[1:]


def number(value, unit="", digits=4):
    """A number as one writes it: 12 345, 0.0031, 4.2e-7."""
    try:
        value = float(value)
    except (TypeError, ValueError, OverflowError):
        return str(value)
    if not math.isfinite(value):
        return "–"
    text = "{:,}".format(int(value)).replace(",", "\u202f") \
        if value == int(value) and abs(value) < 1e15 else "%.*g" % (digits, value)
    return text + ("\u00a0" + unit if unit else "")


def known(value):
    return "–" if value is None else number(value)


def duration(seconds):
    known_seconds = finite(seconds)
    if known_seconds is None or known_seconds < 120.:
        return number(seconds, "s", 3)
    minutes = int(round(known_seconds / 60.))
    return "%d\u00a0min" % minutes if minutes < 120 else \
        "%d\u00a0h %02d\u00a0min" % divmod(minutes, 60)


def geometry_in_words(results):
    name = results.parameter("Geometry/Name")
    if name is None:
        return ""
    text = name[:1].upper() + name[1:]
    own = "Geometry/%s/" % text
    width, height = results.number(own + "Width"), results.number(own + "Height")
    if width is not None and height is not None:
        text += " of %s × %s" % (number(width), number(height, "mm"))
    details = []
    for what, entry, where, other in (
            ("a hole of radius %s", "Hole radius", " at (%s)", "Hole center"),
            ("a notch of %s", "Notch length", " at height %s", "Notch height")):
        size, at = results.number(own + entry), results.parameter(own + other)
        if size:  # a center is no number, and stays as it is
            details.append(what % number(size, "mm")
                           + (where % number(at, "mm") if at else ""))
    return text + (" with " + " and ".join(details) if details else "")


def case_in_words(results):
    """Sentences on geometry, model and material; what is not known is left
    out."""
    geometry = geometry_in_words(results) or results.summary.get("case")
    sentences = [geometry] if geometry else []
    model, left_out = [], set()
    if results.parameter("Model/Strains") != "finite":
        left_out |= {"Strains", "Hyperelastic law"}
    if results.parameter("Model/Formulation") == "displacement":
        left_out.add("Pressure law")
    for entry, text in (("Formulation", "%s formulation"), ("Kinematics", "%s"),
                        ("Strains", "%s strain"), ("Hyperelastic law", "%s law"),
                        ("Crack density", "crack density %s"),
                        ("Energy split", "split %s"),
                        ("Pressure law", "pressure law %s"),
                        ("Length scale", "length scale ℓ = %s"),
                        ("Coupling", "%s coupling")):
        value = results.parameter("Model/" + entry)
        if entry == "Kinematics" and results.is_3d:
            value = "3-d"
        if entry == "Length scale" and is_number(value):
            value = number(value, "mm")
        if value and entry not in left_out:
            model.append(text % value)
    if model:
        text = ", ".join(model)
        sentences.append(text[0].upper() + text[1:])
    return ". ".join(sentences) + ("." if sentences else "")


def is_number(text):
    return finite(text) is not None


def outcome_in_words(results, force):
    """(short, longer) on how the run ended and what became of the body."""
    summary = results.summary
    separated, fell = summary.get("separated"), summary.get("force_fell") is True
    state = "separated" if separated is True else "the force fell" if fell \
        else "not separated" if separated is False else ""
    if not summary:
        return "unfinished", "no summary was written"
    status = summary.get("exit_status")
    words = {0: "finished", 3: "cannot go on", 5: "stopped"}.get(status, "ended")
    longer = summary.get("outcome") or summary.get("exit_reason") or ""
    return ", ".join(word for word in (words, state) if word), str(longer)


def key_figures(results, force):
    """[(label, value, remark)] for the head of the page."""
    summary, figures = results.summary, []
    x = results.column("displacement_mm")
    if force.peak is not None:
        at = None if x is None else x[force.peak]
        figures.append(("Peak force", number(force.values[force.peak], "N"),
                        "" if at is None else "at " + number(at, "mm")))
    elif "peak_force_N" in summary:
        figures.append(("Peak force", number(summary["peak_force_N"], "N"), ""))
    fraction = summary.get("remaining_force_fraction")
    if fraction is None and force.peak is not None \
            and force.peak < len(force.values) - 1 and force.values[force.peak] > 0:
        fraction = force.values[-1] / force.values[force.peak]
    if is_number(fraction):
        figures.append(("Force left at the end",
                        "%.1f\u00a0%%" % (100. * float(fraction)), "of the peak"))
    short, _ = outcome_in_words(results, force)
    n_steps = summary.get("steps", results.n_steps)
    figures.append(("Outcome", short[0].upper() + short[1:],
                    "%s accepted steps" % number(n_steps)))
    if summary.get("outcome"):
        crack = str(summary["outcome"])
        start = summary.get("outcome_start")
        figures.append(("Crack", crack[0].upper() + crack[1:],
                        "starts at: %s" % start
                        if start and start not in (crack, "not traced") else ""))
    area = results.column("crack_area_mm2")
    if area is not None:
        text, unit = words_and_unit("crack_area_mm2")
        figures.append((text.capitalize(), number(area[-1], unit),
                        number(area[0], unit) + " at the start"))
    dofs = last_known(results, "dofs")
    if dofs is not None:
        cells = last_known(results, "cells")
        figures.append(("Unknowns", number(dofs), "" if cells is None else
                        number(cells) + " cells"))
    wall = last_known(results, "wall_time_s")
    if wall is not None:
        ranks = summary.get("ranks")
        figures.append(("Computing time", duration(wall), "" if ranks is None else
                        "%s rank%s" % (ranks, "" if ranks == 1 else "s")))
    return figures


def last_known(results, name):
    """From the summary, otherwise from the last step."""
    value = results.summary.get(name)
    column = results.column(name)
    if value is None and column is not None:
        value = column[-1]
    return value if is_number(value) and math.isfinite(float(value)) else None


def remarks_of(results, force):
    """What a reader has to know before believing the page."""
    remarks = []
    summary = results.summary
    if summary.get("exit_status") not in (None, 0):
        remarks.append("The run did not finish: %s (exit status %s)."
                       % (str(summary.get("exit_reason", "no reason was given"))
                          .rstrip("."), summary["exit_status"]))
    remarks += results.remarks
    rest, work = moments.imbalance(results), results.column("external_work_mJ")
    stored = results.column("elastic_energy_mJ")
    scale = max(moments.largest_size(work), moments.largest_size(stored))
    if rest is not None and moments.largest_size(work) > 0.:
        share = rest[-1] / scale
        if abs(share) > 0.05:
            remarks.append(
                "The energies do not balance: at the end %.0f %% of the largest "
                "external work or stored energy is neither stored nor spent on the crack. A crack "
                "that runs through in one step loses energy in reality too (as "
                "motion); elsewhere it means that steps or cells are too coarse."
                % (100. * share))
    coupling = results.parameter("Model/Coupling", summary.get("coupling"))
    if coupling in ("time-lagged", "extrapolated"):
        remarks.append(
            "The coupling is %s: a running crack advances by about a cell per "
            "step, so force and displacement at the drop depend on the step."
            % coupling)
    if summary.get("separated") is True:
        fraction = summary.get("remaining_force_fraction")
        if is_number(fraction) and float(fraction) > 0.1:
            remarks.append(
                "The separated body still carries %.0f %% of the peak force: the "
                "residual stiffness and the pressure in the damaged band "
                "(doc/model.md, section 3)." % (100. * float(fraction)))
    # the log has those of a run that has not come to its summary
    return remarks + list(map(str, summary.get("warnings", results.log_warnings)))


def run_table(results):
    """[(label, value)] of what the summary says."""
    summary, rows = results.summary, []
    for name in dict.fromkeys(FIRST + tuple(summary)):
        value = summary.get(name)
        if not isinstance(value, (str, int, float)):
            continue
        if name == "wall_time_s":
            value = duration(value)
        elif isinstance(value, bool):
            value = "yes" if value else "no"
        elif not isinstance(value, str):
            value = number(value)
        rows.append((LABELS.get(name) or label(name), value))
    return rows + [("Time for " + name, duration(seconds)) for name, seconds
                   in summary.get("seconds_per_phase", {}).items()]
