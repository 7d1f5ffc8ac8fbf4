# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests on rubber as stretches and nominal stresses.

A file is given as KIND:FILE, or says what it is itself: a comment '# test: KIND', a
column 'test' with a kind per row, or a stress column 'KIND_nominal_stress_MPa'.
"""
import os

import numpy as np

from report_parts.csv_table import Table
from report_parts.errors import InputError

from . import settings
from .laws import MODES

VOLUMETRIC = "volumetric"
KINDS = MODES + (VOLUMETRIC,)
OTHER_NAMES = {"tensile": "uniaxial", "pure shear": "planar", "biaxial": "equibiaxial",
               "pure_shear": "planar"}
# name: (factor, offset) to a stretch
STRETCHES = {"stretch": (1., 0.), "strain": (1., 1.), "strain_percent": (0.01, 1.)}
VOLUMES = {"volume_ratio": (1., 0.), "volumetric_strain": (1., 1.),
           "volumetric_strain_percent": (0.01, 1.)}
STRESSES = ("nominal_stress_MPa", "stress_MPa", "force_N")


class RubberTest:
    """stretch (of a volumetric test: J) and stress (MPa, positive in tension) of
    the points in range; `outside` has the others, [(stretch, stress)]."""

    def __init__(self, kind, path, stretch, stress, given):
        self.kind, self.path = kind, path
        self.name = os.path.basename(path)
        self.weight = given["weight"].of(kind, path, 1.)
        low, high = given["range"].of(kind, path, (-np.inf, np.inf),
                                      general=kind != VOLUMETRIC)
        inside = (stretch >= low) & (stretch <= high)
        if not inside.any():
            raise InputError("%s: no point of the %s test lies in the range %g:%g, its "
                             "points lie in %g:%g" % (path, kind, low, high,
                                                      stretch.min(), stretch.max()))
        self.stretch, self.stress = stretch[inside], stress[inside]
        self.outside = stretch[~inside], stress[~inside]


def given_settings(arguments):
    """The options per test, by name."""
    readers = {"range": settings.interval, "weight": settings.positive,
               "area": settings.positive, "gauge_length": settings.positive}
    return {name: settings.Setting("--" + name.replace("_", "-"),
                                   getattr(arguments, name), read, KINDS)
            for name, read in readers.items()}


def kind_of(word, place):
    word = word.strip().lower()
    kind = OTHER_NAMES.get(word, word)
    if kind not in KINDS:
        raise InputError("%s: expected a kind of test (%s), found '%s'"
                         % (place, ", ".join(KINDS), word))
    return kind


def split_source(text):
    """(kind or None, path) of 'KIND:FILE' or 'FILE'."""
    word, colon, path = text.partition(":")
    known = OTHER_NAMES.get(word.lower(), word.lower())
    if colon and known in KINDS:
        return known, path
    if not os.path.isfile(text):
        raise InputError("there is no file '%s'; expected FILE or KIND:FILE with one "
                         "of %s" % (text, ", ".join(KINDS)))
    return None, text


def stress_column(table, kind):
    """(name of the column, kind that it tells or None)."""
    return next(((name, known) for name in table.names for known in KINDS
                 if name.lower().startswith(known + "_")
                 and name[len(known) + 1:] in STRESSES and kind in (None, known)),
                (None, None))


def kinds_of_rows(table, kind):
    """The kind of each row; `kind` is that of the command line, or None."""
    if kind is None and "test" in table.names:
        return np.array([kind_of(text, "%s:%d: column 'test'" % (table.path, line))
                         for line, text in table.texts("test")])
    if kind is None and "test" in table.settings:
        line, text = table.settings["test"]
        kind = kind_of(text, "%s:%d: 'test'" % (table.path, line))
    kind = kind or stress_column(table, None)[1]
    if kind is None:
        raise InputError("%s: what test it is, is not known: expected KIND:FILE, a "
                         "line '# test: KIND' or a column 'test', with one of %s"
                         % (table.path, ", ".join(KINDS)))
    return np.array([kind] * len(table.rows))


def needed(table, kind, name, given, option, column):
    """A measure of the specimen, of the option or the file."""
    value = given[option].of(kind, table.path, table.setting(name))
    if value is None:
        raise InputError("%s:%d: column '%s' needs --%s or a line '# %s: VALUE', found "
                         "neither" % (table.path, table.header_line, column,
                                      option.replace("_", "-"), name))
    return value


def stretches_of(table, kind, given):
    known = VOLUMES if kind == VOLUMETRIC else STRETCHES
    name = table.chosen(tuple(known) + ("displacement_mm",),
                        "volume" if kind == VOLUMETRIC else "stretch")
    factor, offset = known[name] if name in known else (1. / needed(
        table, kind, "gauge_length_mm", given, "gauge_length", name), 1.)
    return factor * table.column(name, above=0. - offset / factor) + offset


def stresses_of(table, kind, given):
    """MPa, positive in tension."""
    if kind == VOLUMETRIC and "pressure_MPa" in table.names:
        return -table.column("pressure_MPa")
    name = stress_column(table, kind)[0] or table.chosen(
        STRESSES + (("pressure_MPa",) if kind == VOLUMETRIC else ()), "stress")
    values = table.column(name)
    if name.endswith("force_N"):
        values = values / needed(table, kind, "area_mm2", given, "area", name)
    return values


def tests_in(text, given):
    """The tests of one word of the command line."""
    kind, path = split_source(text)
    table = Table(path)
    if not table.rows:
        raise InputError("%s: expected rows of numbers below the header, found none"
                         % path)
    kinds = kinds_of_rows(table, kind)
    every_row, tests = table.rows, []
    for kind in [kind for kind in KINDS if kind in kinds]:
        table.rows = [row for row, own in zip(every_row, kinds) if own == kind]
        tests.append(RubberTest(kind, path, stretches_of(table, kind, given),
                                stresses_of(table, kind, given), given))
    return tests


def read(texts, arguments):
    """All tests, in the order given."""
    given = given_settings(arguments)
    tests = [test for text in texts for test in tests_in(text, given)]
    for setting in given.values():
        setting.check_used()
    return tests
