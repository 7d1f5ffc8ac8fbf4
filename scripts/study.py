#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures and tables of the runs that scripts/sweep.py made.

    scripts/study.py curves  SWEEP_DIR --output curves.svg --per-thickness
    scripts/study.py cracks  SWEEP_DIR --output cracks.png
    scripts/study.py compare SWEEP_DIR peaks.csv --output peaks.md
    scripts/study.py paths   RUN_DIR OTHER_RUN_DIR
    scripts/study.py picture RUN_DIR --output crack.png
    scripts/study.py opening RUN_DIR --output opening.svg

curves: force over displacement of all runs; runs whose names differ in the last
word (fine_1, fine_2) share a colour. --reference takes CSV files with columns
displacement_mm, force_N_per_mm (or force_N) and, if they belong to runs, name: that
of a run, or the last word of several (1: fine_1, coarse_1). displacement_minus_mm,
displacement_plus_mm, force_minus and force_plus say how far tests scatter about the
mean, and are drawn as bars.

cracks: the phase field at the end of every run, with the path of the crack where
the run has written a crack_path.csv.

compare: the table of scripts/sweep.py compare for one reference, without its figures
and tolerances; the older name of it.

paths: how far the crack paths of two runs lie apart at the end.

picture: one field of a run (--field phase_field, displacement, displacement_y,
pressure, stress_xx, ...) at the moment nearest to --time, or at the end;
--deformed shows the deformed body without its broken cells, --window a part. In
3-d the outside is seen along z.

opening: crack_opening.csv of the last step, compared with exact values where --exact
gives an expression in x, the position along the line (mm).

Needs matplotlib and numpy (Debian: python3-matplotlib), and no display.
Exit status: 0; 2 for wrong input or usage.
"""
import argparse
import os
import pathlib
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from report_parts import interpreter, options, safe  # noqa: E402
from report_parts.errors import InputError  # noqa: E402


def deformation(text):
    """'auto' or a factor."""
    return text if text == "auto" else float(text)


SWEEP_DIR = ("directory", "SWEEP_DIR", "directory that sweep.py wrote")
RUN_DIR = ("directory", "RUN_DIR", None)
OUTPUT = ("--output", "FILE", None, {"required": True})
ONLY = ("--only", "NAME", "these runs only; patterns are allowed", {"nargs": "+"})
TITLE = ("--title", "TITLE", None, {"default": ""})
KINDS = {
    "curves": ("force over displacement of all runs", (
        SWEEP_DIR, OUTPUT, ONLY, TITLE,
        ("--per-thickness", None, "force per mm of thickness"),
        ("--component", "{x,y,z}", "this component of the force, also where others are "
         "as large", {"choices": ("x", "y", "z")}),
        ("--reference", "CSV", None, {"nargs": "+", "default": []}))),
    "cracks": ("phase field at the end of every run", (
        SWEEP_DIR, OUTPUT, ONLY, TITLE,
        ("--columns", "N", None, {"type": int, "default": 5}))),
    "compare": ("peaks compared with reference values", (
        SWEEP_DIR, ("reference", "REFERENCE.csv", None), OUTPUT[:3], ONLY)),
    "paths": ("distance between the crack paths of two runs", (
        RUN_DIR, ("other", "OTHER_RUN_DIR", None))),
    "picture": ("one field of a run", (
        RUN_DIR, OUTPUT,
        ("--field", "NAME", None, {"default": "phase_field"}),
        ("--time", "SECONDS", None, {"type": float}),
        ("--deformed", "FACTOR", "by how much; without a number, so that it can be seen",
         {"nargs": "?", "const": "auto", "type": deformation}),
        ("--window", ("X0", "Y0", "X1", "Y1"), None, {"nargs": 4, "type": float}),
        ("--mesh", None, "with its cells"),
        ("--pixels", "N", "longer side of the picture", {"type": int, "default": 480}))),
    "opening": ("opening along the lines of a run", (
        RUN_DIR, OUTPUT,
        ("--exact", "EXPRESSION", "in x, as '2e-3*sqrt(1-x**2)'")))}
SUFFIXES = {"curves": (".svg", ".png"), "cracks": (".png",), "picture": (".png",),
            "opening": (".svg", ".png")}


def read_arguments():
    parser = argparse.ArgumentParser(
        description="Figures and tables of the runs of a sweep.")
    kinds = parser.add_subparsers(dest="kind", metavar="KIND", required=True)
    for kind, (text, table) in KINDS.items():
        options.add(kinds.add_parser(kind, help=text, description=text), table)
    arguments = parser.parse_args()
    suffixes = SUFFIXES.get(arguments.kind)
    if suffixes and not arguments.output.endswith(suffixes):
        parser.error("--output: expected a name that ends in %s, found '%s'"
                     % (" or ".join(suffixes), arguments.output))
    for name, least in (("columns", 1), ("pixels", 50)):
        if getattr(arguments, name, least) < least:
            parser.error("--%s: expected a number of at least %d, found %d"
                         % (name, least, getattr(arguments, name)))
    return arguments


def write_curves(runs, arguments):
    from sweep_parts import study_curves
    if arguments.component:
        for run in runs:
            run.choose_component(arguments.component)
    study_curves.write(runs, arguments.output, arguments.title,
                       arguments.per_thickness, arguments.reference)


def table(runs, arguments):
    """The text, where it goes to the screen. The same as sweep.py compare, which has
    more to say, also draws, and knows tolerances."""
    from study_parts import comparison, comparison_text
    text = comparison_text.markdown(*comparison.compared(runs, [arguments.reference]))
    if arguments.output is None:
        return text
    pathlib.Path(arguments.output).write_text(text, encoding="utf-8")
    return None


def written(arguments):
    """What is asked for; the text for the screen, or None when it is a file."""
    from sweep_parts import (studies, study_cracks, study_opening, study_paths,
                             study_picture)
    if arguments.kind == "paths":
        return study_paths.written(arguments.directory, arguments.other)
    if arguments.kind == "picture":
        return study_picture.write(arguments.directory, arguments.output, arguments)
    if arguments.kind == "opening":
        return study_opening.write(arguments.directory, arguments.output,
                                   arguments.exact)
    runs = studies.runs_of(arguments.directory, arguments.only)
    if arguments.kind == "curves":
        return write_curves(runs, arguments)
    if arguments.kind == "cracks":
        return study_cracks.write(runs, arguments.output, arguments.columns,
                                  arguments.title)
    return table(runs, arguments)


def print_written(arguments):
    text = written(arguments)
    sys.stdout.write(arguments.output + "\n" if text is None else text)


def main():
    arguments = read_arguments()
    return safe.ended("study.py", InputError, arguments.kind + " cannot be drawn",
                      print_written, arguments)


if __name__ == "__main__":
    interpreter.use_one_with_matplotlib()
    sys.exit(main())
