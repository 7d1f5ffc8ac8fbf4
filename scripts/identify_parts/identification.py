# SPDX-License-Identifier: GPL-2.0-or-later
"""From the command line to a law: which tests, which constants, which range."""
import numpy as np

from report_parts.csv_table import number_in
from report_parts.errors import InputError

from . import fitting, laws, linear_ranges, rubber_tests, settings

DEFAULT_USE = 1., 5.


def tests_of(arguments):
    tests = rubber_tests.read(arguments.tests, arguments)
    if arguments.law is None and arguments.constants:
        raise InputError("--constants: expected --law NAME with them, found none")
    if arguments.law is None and not arguments.linear_ranges:
        raise InputError("expected --law NAME with one of %s, --linear-ranges or "
                         "--tear, found none" % ", ".join(laws.LAWS))
    if not tests and not arguments.constants:
        raise InputError("expected tests, KIND:FILE with one of %s, found none"
                         % ", ".join(rubber_tests.KINDS))
    return tests


def percents_of(arguments):
    return settings.numbers(arguments.linear_ranges, "--linear-ranges")


def measured_ranges(arguments, tests):
    """[(name, [(percent, E)])] of the tensile tests."""
    if not arguments.linear_ranges:
        return []
    uniaxial = [test for test in tests if test.kind == "uniaxial"]
    if not uniaxial and not arguments.constants:
        raise InputError("--linear-ranges: expected a uniaxial test, found none")
    return [(test.name, linear_ranges.of_test(test, percents_of(arguments),
                                              arguments.as_measured))
            for test in uniaxial]


def computed_ranges(arguments, fit):
    """The same of the law, where its constants are given."""
    if not arguments.linear_ranges or not arguments.constants:
        return []
    percents = percents_of(arguments)
    fit.law.check(fit.constants, laws.largest_invariant(
        "uniaxial", np.array([1. + 0.01 * percents[-1]])))
    return [(fit.law.name, linear_ranges.of_law(fit.law, fit.constants, percents))]


def given_constants(law, text):
    """'C10=1, C20=2' as numbers in the law's order."""
    values = {}
    for pair in text.split(","):
        name, equals, value = (word.strip() for word in pair.partition("="))
        if not equals or name not in law.names or name in values:
            raise InputError("--constants: expected NAME=VALUE once for each of %s, "
                             "found '%s'" % (", ".join(law.names), pair.strip()))
        values[name] = number_in(value, "--constants: " + name)
    missing = [name for name in law.names if name not in values]
    if missing:
        raise InputError("--constants: expected %s of %s, found none"
                         % (", ".join(missing), law.name))
    return np.array([values[name] for name in law.names])


def fit_of(arguments, tests):
    law = laws.law_of(arguments.law, arguments.terms)
    own = [test for test in tests if test.kind != rubber_tests.VOLUMETRIC]
    volumetric = [test for test in tests if test.kind == rubber_tests.VOLUMETRIC]
    if arguments.constants:
        fit = fitting.given(law, given_constants(law, arguments.constants), own,
                            arguments.relative)
    elif not own:
        raise InputError("--law %s: expected a test of one of %s, found volumetric "
                         "ones only" % (law.name, ", ".join(laws.MODES)))
    else:
        fit = fitting.fitted(law, own, arguments.relative, arguments.confidence)
    if volumetric:
        shear = law.shear_modulus(fit.constants) if arguments.confined else 0.
        fit.bulk = fitting.Bulk(volumetric, arguments.confidence, arguments.seating,
                                shear)
    return fit


def interval_of_use(arguments, fit):
    """(low, high) in stretches, both finite."""
    if not arguments.use:
        largest = max([test.stretch.max() for test in fit.tests]
                      or [DEFAULT_USE[1]])
        return (1., float(largest)) if largest > 1. else DEFAULT_USE
    low, high = settings.interval(arguments.use, "--use")
    if not 0. < low or not np.isfinite(high):
        raise InputError("--use: expected LOW above 0 and a number for HIGH, found '%s'"
                         % arguments.use)
    return low, high
