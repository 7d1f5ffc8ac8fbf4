# SPDX-License-Identifier: GPL-2.0-or-later
"""Force-displacement curves of pure-shear specimens with and without a crack.

    uncracked:FILE   no crack
    LENGTH:FILE      a crack of LENGTH mm that does not grow up to the onset
    growing:FILE     a crack whose length is known over the displacement

FILE is a CSV file with displacement_mm, force_N (or force_x_N, force_y_N, force_z_N)
and, for growing cracks, crack_length_mm, or the directory of a run of mixed-cracks:
statistics.csv, with the length of the cracks from crack_path.csv where that knows it
from the first step on, otherwise from its column crack_length_mm.
"""
import os

import numpy as np

from report_parts.csv_table import Table, number_in
from report_parts.errors import InputError

FORCES = ("force_N", "force_x_N", "force_y_N", "force_z_N")
UNCRACKED, GROWING = "uncracked", "growing"
STANDING = 0.005
LARGEST_DIFFERENCE = 0.02  # of the work of a run from that of its force, relative


class Curve:
    """displacement (mm), force (N), both from the origin on. length:
    of the crack, mm, per row where it grows. stored: elastic energy in mJ per row, or
    None. end: displacement up to which the crack stands."""

    def __init__(self, kind, path, displacement, force):
        self.kind, self.path = kind, path
        self.name = os.path.normpath(path)
        self.length = self.stored = None
        self.displacement, self.force = displacement, force
        increasing = np.append(True, displacement[1:]
                               > np.maximum.accumulate(displacement)[:-1])
        u, f = displacement[increasing], force[increasing]
        if len(u) < 3:
            raise InputError("%s: expected a column displacement_mm with at least 3 "
                             "increasing values, found %d" % (path, len(u)))
        from scipy.interpolate import PchipInterpolator
        self.force_at = PchipInterpolator(u, f)
        self.work_at = self.force_at.antiderivative()
        self.last = float(u[-1])
        self.end = float(u[f.argmax()])

    def work(self, displacement):
        """The integral of the force over the displacement, mJ."""
        if np.max(displacement) > self.last * (1. + 1e-9):
            raise InputError("%s: expected displacements up to %.5g mm, found %.5g as "
                             "the largest" % (self.path, np.max(displacement),
                                              self.last))
        return self.work_at(displacement) - self.work_at(0.)

    def take_growth(self, lengths, step):
        """lengths: of the crack in each row, mm; step: smallest growth of which a
        rate is taken. The crack stands up to row `first`, until it has grown by a
        part STANDING of all its growth: damage around a tip counts as length, too."""
        self.length, self.step = lengths, step
        limit = min(0.1 * step, STANDING * (lengths[-1] - lengths[0]))
        self.first = int(np.flatnonzero(lengths < lengths[0] + limit)[-1])
        self.end = float(self.displacement[self.first])


def split_source(text):
    """(kind, length in mm or None, path)."""
    kind, colon, path = text.partition(":")
    if colon and kind in (UNCRACKED, GROWING):
        return kind, None, path
    try:
        length = float(kind) if colon else None
    except ValueError:
        length = None
    if length is None:
        raise InputError("--tear: expected uncracked:FILE, LENGTH:FILE or growing:FILE,"
                         " found '%s'" % text)
    return "standing", number_in(kind, "--tear: crack length of '%s'" % text,
                                 above=0.), path


def force_of(table, component):
    """N, positive where it is largest."""
    allowed = FORCES if component is None else ("force_%s_N" % component,)
    table.chosen(allowed, "force")
    columns = [table.column(name) for name in allowed if name in table.names]
    force = max(columns, key=lambda values: np.abs(values).max())
    return force * np.sign(force[np.abs(force).argmax()])


def check_work(table, displacement, force):
    """Of a run: what does the work is the force over this displacement."""
    if "external_work_mJ" not in table.names:
        return
    work = table.column("external_work_mJ")[-1]
    own = float(np.sum(0.5 * (force[1:] + force[:-1]) * np.diff(displacement)))
    if abs(own - work) > LARGEST_DIFFERENCE * abs(work):
        raise InputError("%s: expected the integral of the force over displacement_mm "
                         "to be external_work_mJ, found %.5g and %.5g at the end: more "
                         "than one boundary moves, or --component is another"
                         % (table.path, own, work))


def read_one(text, options):
    kind, length, path = split_source(text)
    is_run = os.path.isdir(path)
    table = Table(os.path.join(path, "statistics.csv") if is_run else path, is_run)
    if len(table.rows) < 3:
        raise InputError("%s: expected at least 3 rows, found %d"
                         % (table.path, len(table.rows)))
    displacement = table.column(
        table.chosen(("displacement_mm",), "displacement"), least=0.)
    force = force_of(table, options.component)
    check_work(table, displacement, force)
    stored = table.column("elastic_energy_mJ") \
        if "elastic_energy_mJ" in table.names else None
    lengths = lengths_of(table, path, displacement, options.crack_length) \
        if kind == GROWING else None
    if displacement[0] > 0.:  # tests begin at the pre-load
        displacement, force = np.append(0., displacement), np.append(0., force)
        stored = None if stored is None else np.append(0., stored)
        lengths = None if lengths is None else np.append(lengths[0], lengths)
    curve = Curve(kind, path, displacement, force)
    curve.stored, curve.length = stored, length
    if kind == GROWING:
        # a length that is measured anew in every picture is not below an earlier one
        lengths = np.maximum.accumulate(lengths)
        curve.take_growth(lengths, step_of(path, lengths[-1] - lengths[0],
                                           options.step))
    return curve


def step_of(path, growth, given):
    """A twentieth of the growth where none is given, mm."""
    if growth <= 0.:
        raise InputError("%s: expected a crack length that grows, found that it does "
                         "not from the first to the last row" % path)
    if given is not None and given > growth:
        raise InputError("--step: expected at most the growth of the crack in %s, %.4g "
                         "mm, found %g" % (path, growth, given))
    return given or 0.05 * growth


def lengths_of(table, path, displacement, source):
    """mm, for each row. source: None, 'statistics', 'path' or a CSV file."""
    folder = path if os.path.isdir(path) else None
    own_path = os.path.join(folder, "crack_path.csv") if folder else ""
    if source == "path" and not folder:
        raise InputError("--crack-length path: expected the directory of a run after "
                         "growing:, found '%s'" % path)
    if source == "path" or (source is None and os.path.isfile(own_path)):
        lengths, from_begin = traced_lengths(table, own_path)
        if from_begin or source == "path":
            return lengths
    if source in (None, "statistics"):
        return table.column(table.chosen(("crack_length_mm",), "crack length"),
                            least=0.)
    other = Table(source)
    u = other.column(other.chosen(("displacement_mm",), "displacement"))
    a = other.column(other.chosen(("crack_length_mm",), "crack length"), least=0.)
    if len(u) < 2 or np.any(np.diff(u) < 0.):
        raise InputError("%s: expected at least 2 rows and values in column "
                         "'displacement_mm' that do not fall" % source)
    return np.interp(displacement, u, a)


def traced_lengths(table, path):
    """(sum of the lengths of all cracks in each row, whether they are known from the
    first row on). A length stays until the next step that is written; before the
    first one it is taken to be that one."""
    traced = Table(path, may_be_cut=True)
    columns = [traced.column(traced.chosen((name,), name.rpartition("_")[0] or name))
               for name in ("step", "crack", "length_mm")]
    totals = {}
    for step, crack, length in zip(*columns):
        totals.setdefault(step, {})[crack] = length
    if not totals:
        raise InputError("%s: expected rows with a crack, found none" % path)
    steps = np.array(sorted(totals))
    lengths = np.array([sum(totals[step].values()) for step in steps])
    own = table.column(table.chosen(("step",), "step"))
    return (lengths[np.maximum(np.searchsorted(steps, own, side="right") - 1, 0)],
            bool(steps[0] <= own[0]))


class Specimen:
    """curves by kind; width, height, thickness (mm)."""

    def __init__(self, texts, options):
        self.width, self.height, self.thickness = (
            options.width, options.height, options.thickness)
        curves = [read_one(text, options) for text in texts]
        uncracked = [curve for curve in curves if curve.kind == UNCRACKED]
        if len(uncracked) > 1:
            raise InputError("--tear: expected one uncracked:FILE, found %d"
                             % len(uncracked))
        self.uncracked = uncracked[0] if uncracked else None
        self.growing = [curve for curve in curves if curve.kind == GROWING]
        self.standing = sorted((curve for curve in curves
                                if curve.kind == "standing"), key=lambda c: c.length)
        for curve in self.standing + self.growing:
            length = np.ravel(curve.length)[0]
            if not length < self.width:
                raise InputError("--tear: expected a crack shorter than --width %g in "
                                 "'%s', found %g" % (self.width, curve.path, length))
        if not self.standing and not self.growing:
            raise InputError("--tear: expected a curve with a crack (LENGTH:FILE or "
                             "growing:FILE), found none")
        for one, other in zip(self.standing, self.standing[1:]):
            if one.length == other.length:
                raise InputError("--tear: expected one file for each crack length, "
                                 "found '%s' and '%s' for %g mm"
                                 % (one.path, other.path, one.length))
