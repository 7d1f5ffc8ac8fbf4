#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Identify hyperelastic laws and energy release rates from tests on rubber.

    scripts/identify.py uniaxial:a.csv equibiaxial:b.csv --law Yeoh --picture fit.svg
    scripts/identify.py uniaxial:a.csv --linear-ranges 10,20,80,150,400
    scripts/identify.py --law Yeoh --constants C10=0.5,C20=-0.02,C30=0.002 --use 1:4
    scripts/identify.py --tear --width 196 --height 28 --thickness 1.8 \\
        uncracked:w.csv growing:c.csv

Tests: uniaxial, planar (pure shear), equibiaxial, volumetric; the kind before the
file, in a line '# test: KIND', or in a column 'test'. Columns: stretch, strain,
strain_percent or displacement_mm (with --gauge-length); nominal_stress_MPa, or force_N
(with --area); volumetric tests have volume_ratio, volumetric_strain or
displacement_mm, and pressure_MPa, nominal_stress_MPa or force_N.

Options of a test are VALUE for all, KIND=VALUE or FILE=VALUE, and may be repeated.
Prints the constants with their intervals of confidence, what is left over, where the
law is unstable, and the lines of a .prm. doc/identification.md has the formulas.

Needs SciPy and numpy, for pictures matplotlib (Debian: python3-scipy,
python3-matplotlib), and no display. Exit status: 0; 2 for wrong input or usage.
"""
import argparse
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from report_parts import interpreter, options, safe  # noqa: E402
from report_parts.errors import InputError  # noqa: E402


GENERAL = (
    ("tests", "KIND:FILE.csv", None, {"nargs": "*"}),
    ("--picture", "FILE", ".svg or .png"),
    ("--json", "FILE", "the results as numbers; - prints them instead of the text"))
LAWS = (
    ("--law", "NAME", "neo-Hooke, Mooney-Rivlin, Yeoh, Gent or Ogden"),
    ("--terms", "{1,2,3}", "of Ogden's law (2)",
     {"type": int, "choices": (1, 2, 3), "default": 2}),
    ("--constants", "NAME=VALUE,...", "look at these instead of fitting"),
    ("--relative", None, "least squares of relative errors"),
    ("--confidence", "SHARE", "of the intervals (0.95)", {"default": "0.95"}),
    ("--use", "LOW:HIGH", "stretches over which the law is checked (1 to the largest of "
     "the tests)"),
    ("--linear-ranges", "PERCENT,...", "Young's modulus of lines through the origin of "
     "the tensile curve, up to these strains"),
    ("--as-measured", None, "lines through the points as they are, instead of 200 evenly "
     "spaced ones"),
    ("--seating", None, "the line of the volumetric test need not pass through the "
     "origin"),
    ("--confined", None, "the volumetric test is confined compression, whose slope is "
     "K + 4/3 mu"))
MANY = {"action": "append"}
TESTS = (
    ("--range", "LOW:HIGH", "stretches that count; J with volumetric=", MANY),
    ("--weight", "FACTOR", "of the squared errors (1)", MANY),
    ("--area", "MM2", "undeformed, for force_N", MANY),
    ("--gauge-length", "MM", "undeformed, for displacement_mm", MANY))
TEAR = (
    ("--tear", None, "from pure-shear curves uncracked:FILE, LENGTH:FILE and "
     "growing:FILE; FILE may be the directory of a run"),
    ("--width", "MM", "of the specimen"),
    ("--height", "MM", "of the specimen"),
    ("--thickness", "MM", "of the specimen"),
    ("--onset", "MM", "displacement at which cracks that stand are evaluated (the "
     "smallest at a largest force)"),
    ("--component", "{x,y,z}", "of the force", {"choices": ("x", "y", "z")}),
    ("--crack-length", "WHERE", "statistics, path or a CSV file with displacement_mm and "
     "crack_length_mm"),
    ("--step", "MM", "smallest growth of which a rate is taken (a twentieth of all)"),
    ("--mean-from", "MM", "means are over cracks that have grown by more (0)",
     {"default": "0"}),
    ("--paper-formula", None, "also (U_w - U_c) / (a t)"))
GROUPS = (("laws", LAWS), ("tests (VALUE, KIND=VALUE or FILE=VALUE)", TESTS),
          ("energy release rates", TEAR))


def parser_of():
    parser = argparse.ArgumentParser(
        description="Identify hyperelastic laws and energy release rates from tests.")
    options.add(parser, GENERAL)
    for title, table in GROUPS:
        options.add(parser.add_argument_group(title), table)
    return parser


def checked_arguments():
    """The arguments, numbers read."""
    from identify_parts import settings
    arguments = parser_of().parse_args()
    if arguments.picture and not arguments.picture.endswith((".svg", ".png")):
        raise InputError("--picture: expected a name that ends in .svg or .png, found "
                         "'%s'" % arguments.picture)
    arguments.confidence = settings.positive(arguments.confidence, "--confidence")
    if arguments.confidence >= 1.:
        raise InputError("--confidence: expected a number between 0 and 1, found %g"
                         % arguments.confidence)
    for name in ("width", "height", "thickness", "onset", "step"):
        value = getattr(arguments, name)
        if value is not None:
            setattr(arguments, name, settings.positive(value, "--" + name))
        elif arguments.tear and name in ("width", "height", "thickness"):
            raise InputError("--tear: expected --%s in mm, found none" % name)
    arguments.mean_from = settings.number_in(arguments.mean_from, "--mean-from",
                                             least=0.)
    return arguments


def written(arguments, text, numbers):
    """Hand out the results: text to print, JSON where asked for."""
    if arguments.json:
        numbers = json.dumps(numbers, indent=1, allow_nan=False) + "\n"
        if arguments.json == "-":
            return numbers
        with open(arguments.json, "w", encoding="utf-8") as stream:
            stream.write(numbers)
    return text


def tear_answer(arguments):
    from identify_parts import tear, tear_curves
    specimen = tear_curves.Specimen(arguments.tests, arguments)
    onset, points = tear.evaluated(specimen, arguments)
    if arguments.picture:
        from identify_parts import drawings
        drawings.write_tear(arguments.picture, specimen, onset, points)
    given = specimen, onset, points, arguments.mean_from
    return written(arguments, tear.text_of(*given), tear.json_of(*given))


def ranges_answer(arguments, tests, ranges):
    """Lines through the origin alone, without a law."""
    from identify_parts import answer
    if arguments.picture:
        from identify_parts import drawings
        drawings.write_ranges(arguments.picture, tests, ranges)
    return written(arguments, "\n".join(answer.range_lines(ranges)) + "\n",
                   {"linear_ranges": answer.ranges_of(ranges)})


def law_answer(arguments):
    from identify_parts import answer, identification, stability
    tests = identification.tests_of(arguments)
    ranges = identification.measured_ranges(arguments, tests)
    if arguments.law is None:
        return ranges_answer(arguments, [test for test in tests
                                         if test.kind == "uniaxial"], ranges)
    fit = identification.fit_of(arguments, tests)
    interval = identification.interval_of_use(arguments, fit)
    ranges += identification.computed_ranges(arguments, fit)
    checked = stability.checked(fit.law, fit.constants, interval)
    if arguments.picture:
        from identify_parts import drawings
        drawings.write_fit(arguments.picture, fit, interval, ranges)
    given = fit, checked, interval, ranges
    return written(arguments, answer.text_of(*given), answer.json_of(*given))


def print_answer():
    arguments = checked_arguments()
    sys.stdout.write((tear_answer if arguments.tear else law_answer)(arguments))


def main():
    import numpy
    numpy.seterr(all="ignore")  # what is not finite is refused where it is written
    return safe.ended("identify.py", InputError, "nothing can be made of this",
                      print_answer)


if __name__ == "__main__":
    wants_picture = any(word.startswith("--pi") for word in sys.argv[1:])
    interpreter.use_one_with(("numpy", "scipy")
                             + (("matplotlib",) if wants_picture else ()))
    sys.exit(main())
