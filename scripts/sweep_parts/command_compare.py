# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py compare: the cases of a sweep beside an experiment or published figures.

    sweep.py compare FILE --reference parameters/epdm/experiments.csv
    sweep.py compare results/strips --reference a.csv path.csv --tolerance peak=10%

FILE is a sweep file, or a directory with the runs of one. How references are written
stands at the head of scripts/study_parts/references.py: peaks, curves and paths, with
the scatter of tests. A reference belongs to the run of its name, or to all whose last
word it is (12: soft_12, hard_12), or without a name to all.

Writes OUTPUT/comparison.md and .csv and a figure for each case, OUTPUT/comparison/NAME.
Exit status: 0; 1 when a tolerance is not met or a case is missing that has one."""
import os
import sys

from report_parts import safe
from study_parts import drawing
from study_parts.errors import StudyError

HELP = "compare peaks, curves and paths with references; what lies within the scatter"
OPENS_ITSELF = True
OPTIONS = (
    ("--reference", "CSV", "peaks, curves and digitised paths",
     {"nargs": "+", "required": True}),
    ("--deviations", "K", "standard deviations to each side of a mean that are within "
     "the scatter (1)", {"type": float, "default": 1.}),
    ("--tolerance", "NAME=LIMIT", "peak, displacement, curve, area as 5%%, path, "
     "hausdorff in mm, scatter: how many figures may lie outside; decides on the exit "
     "status",
     {"nargs": "+", "default": []}),
    ("--figures", "DIR", "figures of the cases (OUTPUT/comparison); '' for none"),
    ("--format", "{svg,png}", "of the figures (svg)",
     {"choices": ("svg", "png"), "default": "svg"}))


def run(arguments, _):
    if not arguments.deviations > 0.:
        raise StudyError("--deviations: expected a number above 0, found %g"
                         % arguments.deviations)
    drawing.require()
    from study_parts import comparison, comparison_text
    tolerances = comparison.read_tolerances(arguments.tolerance)
    runs, missing, output = runs_of(arguments)
    found, known = comparison.compared(runs, arguments.reference, arguments.deviations)
    missed = comparison.judged(found, tolerances)
    missed += ["%s has not been run" % name for name in missing
               if tolerances and known.used_by(name)]
    text = comparison_text.markdown(found, known, missed)
    safe.write_whole(os.path.join(output, "comparison.md"), text)
    safe.write_whole(os.path.join(output, "comparison.csv"),
                     comparison_text.table(found, known))
    sys.stdout.write(text)
    folder = os.path.join(output, "comparison") if arguments.figures is None \
        else arguments.figures
    if folder:
        draw(found, known, folder, arguments.format)
    print(os.path.join(output, "comparison.md"))
    return 1 if missed else 0


def runs_of(arguments):
    """([StudyRun], names of cases without results, directory to write to)."""
    from . import studies
    if os.path.isdir(arguments.file):
        runs = studies.runs_of(arguments.file, arguments.only)
        return runs, [], arguments.output or arguments.file
    from . import study
    opened = study.opened(arguments)
    chosen = opened.chosen(arguments.only)
    there = [case for case in chosen if os.path.isfile(case.path("statistics.csv"))]
    missing = [case.name for case in chosen if case not in there]
    for name in missing:
        print("%s: there is nothing to compare yet" % name, file=sys.stderr)
    if not there:
        raise StudyError("no case of %s has been run yet" % arguments.file)
    return ([studies.StudyRun(case.name, case.directory) for case in there], missing,
            opened.output)


def draw(found, known, folder, suffix):
    from study_parts import comparison_figure
    os.makedirs(folder, exist_ok=True)
    for entry in found:
        if entry.has_reference:
            drawing.drawn(os.path.join(folder, "%s.%s" % (entry.run.name, suffix)),
                          comparison_figure.draw, entry, known)
