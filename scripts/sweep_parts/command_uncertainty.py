# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py uncertainty: the same case with one change at a time.

    sweep.py uncertainty parameters/epdm/punctured_strip.prm \\
        --parameters "Material/Shear modulus"

CASE is a .prm file, or a sweep file with --only NAME. The variations are a sweep of
their own, OUTPUT/uncertainty.sweep; OUTPUT/uncertainty.md has the tables, and
OUTPUT/uncertainty.svg the curves and the bundle of paths."""
import os

from report_parts import safe
from study_parts import derived, drawing, here, variations
from study_parts.errors import StudyError

from . import sweep_file
from .program import Program

HELP = "how sure peak, displacement and path are: one change at a time"
OPENS_ITSELF = True
BASE = "as_it_is"
OPTIONS = here.OPTIONS + [
    ("--parameters", "ENTRY", "these up and down as well, one at a time",
     {"nargs": "+", "default": []}),
    ("--by", "PERCENT", "how far (10)", {"type": float, "default": 10.}),
    ("--figure", "FILE", "the figure, .svg or .png (OUTPUT/uncertainty.svg)")]


def run(arguments, _):
    if not 0. < arguments.by < 100.:
        raise StudyError("--by: expected a percentage above 0 and below 100, found %g"
                         % arguments.by)
    drawing.require(arguments.figure, "--figure")
    source = derived.Source(arguments.file, arguments.only, arguments.extra)
    if len(source.runs) != 1:
        raise StudyError("expected one case; choose it from %s by --only"
                         % ", ".join(source.runs))
    name = next(iter(source.runs))
    output = os.path.abspath(arguments.output or os.path.join(
        "results", name + "_uncertainty"))
    program = Program(arguments.program)
    bringing = here.runs_of(arguments, program)
    entries = [sweep_file.entry_of(text) for text in arguments.parameters]
    several = source.allowed(name, program, entries, 0.01 * arguments.by)
    runs = {BASE: source.runs[name]}
    runs.update((variations.case_name(v), source.varied(name, v)) for v in several)
    study = derived.study_of("uncertainty", source, runs, output, program)
    bringing.bring(study, list(runs))
    return write_files(study, several, output, arguments.figure)


def write_files(study, several, output, figure):
    """1 when a case has no answer."""
    from study_parts import uncertainty, uncertainty_figure

    from . import studies
    runs = {name: studies.StudyRun(name, case.directory)
            for name, case in study.cases.items() if case.is_complete()}
    of_variations = [runs.get(variations.case_name(v)) for v in several]
    base = uncertainty.answer_of(runs.get(BASE))
    found = uncertainty.Uncertainty(base, [
        uncertainty.Difference(v, uncertainty.answer_of(run), base)
        for v, run in zip(several, of_variations)])
    text = uncertainty.markdown(found)
    path = os.path.join(output, "uncertainty.md")
    safe.write_whole(path, text)
    print(text)
    print(path)
    figure = figure or os.path.join(output, "uncertainty.svg")
    if drawing.drawn(figure, uncertainty_figure.draw, found, runs[BASE], of_variations):
        print(figure)
    return 1 if found.missing() else 0
