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
from report_parts import interpreter  # noqa: E402


def add_law_options(parser):
    group = parser.add_argument_group("laws")
    group.add_argument("--law", metavar="NAME", help="neo-Hooke, Mooney-Rivlin, Yeoh, "
                       "Gent or Ogden")
    group.add_argument("--terms", type=int, choices=(1, 2, 3), default=2,
                       help="of Ogden's law (2)")
    group.add_argument("--constants", metavar="NAME=VALUE,...",
                       help="look at these instead of fitting")
    group.add_argument("--relative", action="store_true",
                       help="least squares of relative errors")
    group.add_argument("--confidence", default="0.95", metavar="SHARE",
                       help="of the intervals (0.95)")
    group.add_argument("--use", metavar="LOW:HIGH", help="stretches over which the law "
                       "is checked (1 to the largest of the tests)")
    group.add_argument("--linear-ranges", metavar="PERCENT,...",
                       help="Young's modulus of lines through the origin of the "
                       "tensile curve, up to these strains")
    group.add_argument("--as-measured", action="store_true",
                       help="lines through the points as they are, instead of 200 "
                       "evenly spaced ones")
    group.add_argument("--seating", action="store_true", help="the line of the "
                       "volumetric test need not pass through the origin")
    group.add_argument("--confined", action="store_true", help="the volumetric test "
                       "is confined compression, whose slope is K + 4/3 mu")


def add_test_options(parser):
    group = parser.add_argument_group("tests (VALUE, KIND=VALUE or FILE=VALUE)")
    for name, metavar, text in (
            ("range", "LOW:HIGH", "stretches that count; J with volumetric="),
            ("weight", "FACTOR", "of the squared errors (1)"),
            ("area", "MM2", "undeformed, for force_N"),
            ("gauge-length", "MM", "undeformed, for displacement_mm")):
        group.add_argument("--" + name, action="append", metavar=metavar, help=text)


def add_tear_options(parser):
    group = parser.add_argument_group("energy release rates")
    group.add_argument("--tear", action="store_true", help="from pure-shear curves "
                       "uncracked:FILE, LENGTH:FILE and growing:FILE; FILE may be the "
                       "directory of a run")
    for name in ("width", "height", "thickness"):
        group.add_argument("--" + name, metavar="MM", help="of the specimen")
    group.add_argument("--onset", metavar="MM", help="displacement at which cracks "
                       "that stand are evaluated (the smallest at a largest force)")
    group.add_argument("--component", choices=("x", "y", "z"), help="of the force")
    group.add_argument("--crack-length", metavar="WHERE", help="statistics, path or a "
                       "CSV file with displacement_mm and crack_length_mm")
    group.add_argument("--step", metavar="MM", help="smallest growth of which a rate "
                       "is taken (a twentieth of all)")
    group.add_argument("--mean-from", default="0", metavar="MM",
                       help="means are over cracks that have grown by more (0)")
    group.add_argument("--paper-formula", action="store_true",
                       help="also (U_w - U_c) / (a t)")


def parser_of():
    parser = argparse.ArgumentParser(
        description="Identify hyperelastic laws and energy release rates from tests.")
    parser.add_argument("tests", nargs="*", metavar="KIND:FILE.csv")
    parser.add_argument("--picture", metavar="FILE", help=".svg or .png")
    parser.add_argument("--json", metavar="FILE", help="the results as numbers; - "
                        "prints them instead of the text")
    add_law_options(parser)
    add_test_options(parser)
    add_tear_options(parser)
    return parser


def checked_arguments():
    """The arguments, numbers read."""
    from identify_parts import settings
    from identify_parts.errors import InputError
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


def drawings():
    """The module, for those who want pictures."""
    import matplotlib
    matplotlib.use("Agg")
    from identify_parts import drawings as module
    return module


def tear_answer(arguments):
    from identify_parts import tear, tear_curves
    specimen = tear_curves.Specimen(arguments.tests, arguments)
    onset, points = tear.evaluated(specimen, arguments)
    if arguments.picture:
        drawings().write_tear(arguments.picture, specimen, onset, points)
    given = specimen, onset, points, arguments.mean_from
    return written(arguments, tear.text_of(*given), tear.json_of(*given))


def ranges_answer(arguments, tests, ranges):
    """Lines through the origin alone, without a law."""
    from identify_parts import answer
    if arguments.picture:
        drawings().write_ranges(arguments.picture, tests, ranges)
    return written(arguments, "\n".join(answer.range_lines(ranges)) + "\n",
                   {"linear_ranges": answer.ranges_of(ranges)})


def law_answer(arguments):
    from identify_parts import answer, identification
    tests = identification.tests_of(arguments)
    ranges = identification.measured_ranges(arguments, tests)
    if arguments.law is None:
        return ranges_answer(arguments, [test for test in tests
                                         if test.kind == "uniaxial"], ranges)
    fit = identification.fit_of(arguments, tests)
    interval = identification.interval_of_use(arguments, fit)
    ranges += identification.computed_ranges(arguments, fit)
    checked = identification.checked(fit, interval)
    if arguments.picture:
        drawings().write_fit(arguments.picture, fit, interval, ranges)
    given = fit, checked, interval, ranges
    return written(arguments, answer.text_of(*given), answer.json_of(*given))


def main():
    import numpy
    from identify_parts.errors import InputError
    numpy.seterr(all="ignore")  # what is not finite is refused where it is written
    try:
        arguments = checked_arguments()
        text = (tear_answer if arguments.tear else law_answer)(arguments)
    except (InputError, OSError) as error:
        print("identify.py: %s" % error, file=sys.stderr)
        return 2
    except Exception as error:  # whatever the files hold, no trace of the inside
        print("identify.py: nothing can be made of this (%s: %s)"
              % (type(error).__name__, " ".join(str(error).split())[:300]),
              file=sys.stderr)
        return 2
    sys.stdout.write(text)
    return 0


if __name__ == "__main__":
    wants_picture = any(word.startswith("--pi") for word in sys.argv[1:])
    interpreter.use_one_with(("numpy", "scipy")
                             + (("matplotlib",) if wants_picture else ()))
    sys.exit(main())
