# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py bisect: where an answer changes between two values of an entry.

    sweep.py bisect FILE --vary "Geometry/Punctured strip/Notch height" 6 10 \\
        --on outcome --to 0.1

FILE is a sweep file, each of whose runs is bisected, or a .prm file. The cases are a
sweep of their own, OUTPUT/bisect.sweep, which all commands work on. OUTPUT/bisect.csv
has the brackets with the cases that carry them."""
import os

from report_parts import safe
from study_parts import bisection, critical, derived, drawing, here, spread
from study_parts.errors import StudyError

from . import sweep_file
from .program import Program

HELP = "the value of an entry at which an answer changes, by bisection"
OPENS_ITSELF = True
OPTIONS = here.OPTIONS + [
    ("--vary", ("ENTRY", "LOW", "HIGH"), "what is varied, and its range",
     {"nargs": 3, "required": True}),
    ("--on", "QUESTION", "keys of summary.json whose change is looked for, as outcome or "
     "outcome,outcome_start, or a bound, as 'peak_force_N > 160'", {"required": True}),
    ("--to", "WIDTH", "of the bracket, in the unit of the entry",
     {"type": float, "required": True}),
    ("--variations", None, "the same with each change of 'uncertainty', one at a time: "
     "how sure the value is"),
    ("--parameters", "ENTRY", "with --variations: these by 10 %% up and down as well",
     {"nargs": "+", "default": []}),
    ("--figure", "FILE", "a drawing of all answers, .svg or .png")]


def range_of(words):
    entry = sweep_file.entry_of(words[0])
    try:
        low, high = float(words[1]), float(words[2])
    except ValueError:
        raise StudyError("--vary: expected \"Subsection/Entry\" and two numbers, found "
                         "'%s'" % " ".join(words))
    if "/" not in entry or not low < high:
        raise StudyError("--vary: expected \"Subsection/Entry\", a smaller and a larger "
                         "number, found '%s'" % " ".join(words))
    return entry, low, high


def run(arguments, _):
    question = bisection.Question(arguments.on)
    entry, low, high = range_of(arguments.vary)
    if not arguments.to > 0.:
        raise StudyError("--to: expected a width above 0, found %g" % arguments.to)
    if arguments.figure:
        drawing.require(arguments.figure, "--figure")
    source = derived.Source(arguments.file, arguments.only, arguments.extra)
    output = os.path.abspath(arguments.output or os.path.join(
        "results", source.stem + "_bisect"))
    program = Program(arguments.program)
    runs = here.runs_of(arguments, program)
    wanted = spread.runs_of(source, program, arguments.parameters) \
        if arguments.variations else source.runs
    found = critical.Critical(entry, low, high, arguments.to, question, wanted)
    study = critical.solve(found, source, output, program, runs, arguments.jobs)
    for line in critical.report(found, study):
        print(line)
    write_files(found, study, output, arguments)
    return 0


def write_files(found, study, output, arguments):
    path = os.path.join(output, "bisect.csv")
    safe.write_whole(path, critical.table(found, study))
    print(path)
    if arguments.variations:
        print(spread.report(found), end="")
    if arguments.figure:
        from study_parts import critical_figure
        drawing.save(critical_figure.draw(found), arguments.figure, "bisect")
        print(arguments.figure)
