#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures and tables of the runs that scripts/sweep.py made.

    scripts/study.py curves  SWEEP_DIR --output curves.svg --per-thickness
    scripts/study.py cracks  SWEEP_DIR --output cracks.png
    scripts/study.py compare SWEEP_DIR peaks.csv --output peaks.md
    scripts/study.py paths   RUN_DIR OTHER_RUN_DIR

curves: force over displacement of all runs; runs whose names differ in the last
word (fine_1, fine_2) share a colour. --reference takes CSV files with columns
displacement_mm, force_N_per_mm (or force_N) and, if they belong to runs, name.

cracks: the phase field at the end of every run, with the path of the crack where
the run has written a crack_path.csv.

compare: peak displacement and force beside those of a CSV file with columns
name, displacement_mm, force_N_per_mm; lines with # are comments.

paths: how far the crack paths of two runs lie apart at the end.

Needs matplotlib and numpy (Debian: python3-matplotlib), and no display.
Exit status: 0; 2 for wrong input or usage.
"""
import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from report_parts import interpreter  # noqa: E402


def read_arguments():
    parser = argparse.ArgumentParser(
        description="Figures and tables of the runs of a sweep.")
    kinds = parser.add_subparsers(dest="kind", metavar="KIND", required=True)
    all_kinds = {}
    for kind, text in (("curves", "force over displacement of all runs"),
                       ("cracks", "phase field at the end of every run"),
                       ("compare", "peaks beside reference values"),
                       ("paths", "distance between the crack paths of two runs")):
        all_kinds[kind] = kinds.add_parser(kind, help=text, description=text)
        if kind == "paths":
            all_kinds[kind].add_argument("directory", metavar="RUN_DIR")
            all_kinds[kind].add_argument("other", metavar="OTHER_RUN_DIR")
            continue
        all_kinds[kind].add_argument("directory", metavar="SWEEP_DIR",
                                     help="directory that sweep.py wrote")
        if kind == "compare":
            all_kinds[kind].add_argument("reference", metavar="REFERENCE.csv")
        all_kinds[kind].add_argument("--output", metavar="FILE",
                                     required=kind != "compare")
        all_kinds[kind].add_argument("--only", nargs="+", metavar="NAME",
                                     help="these runs only; patterns are allowed")
    for kind in ("curves", "cracks"):
        all_kinds[kind].add_argument("--title", default="")
    all_kinds["curves"].add_argument("--per-thickness", action="store_true",
                                     help="force per mm of thickness")
    all_kinds["curves"].add_argument("--component", choices=("x", "y", "z"),
                                     help="this component of the force, also "
                                     "where others are as large")
    all_kinds["curves"].add_argument("--reference", nargs="+", default=[],
                                     metavar="CSV")
    all_kinds["cracks"].add_argument("--columns", type=int, default=5, metavar="N")
    arguments = parser.parse_args()
    suffixes = {"curves": (".svg", ".png"), "cracks": (".png",)}.get(arguments.kind)
    if suffixes and not arguments.output.endswith(suffixes):
        parser.error("--output: expected a name that ends in %s, found '%s'"
                     % (" or ".join(suffixes), arguments.output))
    if arguments.kind == "cracks" and arguments.columns < 1:
        parser.error("--columns: expected a number of at least 1, found %d"
                     % arguments.columns)
    return arguments


def main():
    arguments = read_arguments()
    import matplotlib
    matplotlib.use("Agg")
    from sweep_parts import (studies, study_compare, study_cracks, study_curves,
                             study_paths)
    try:
        if arguments.kind == "paths":
            sys.stdout.write(study_paths.written(arguments.directory,
                                                 arguments.other))
            return 0
        runs = studies.runs_of(arguments.directory, arguments.only)
        if arguments.kind == "curves":
            if arguments.component:
                for run in runs:
                    run.choose_component(arguments.component)
            study_curves.write(runs, arguments.output, arguments.title,
                               arguments.per_thickness, arguments.reference)
        elif arguments.kind == "cracks":
            study_cracks.write(runs, arguments.output, arguments.columns,
                               arguments.title)
        else:
            text = study_compare.written(runs,
                                         study_compare.read_peaks(arguments.reference))
            if arguments.output is None:
                sys.stdout.write(text)
                return 0
            with open(arguments.output, "w", encoding="utf-8") as stream:
                stream.write(text)
    except (studies.StudyError, OSError) as error:
        print("study.py: %s" % error, file=sys.stderr)
        return 2
    print(arguments.output)
    return 0


if __name__ == "__main__":
    interpreter.use_one_with_matplotlib()
    sys.exit(main())
