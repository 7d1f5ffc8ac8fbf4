# SPDX-License-Identifier: GPL-2.0-or-later
"""Reference values in CSV files: peaks, curves and digitised paths.

The header tells what a file holds; lines with # are comments.

peaks and curves   displacement_mm, force_N or force_N_per_mm (per thickness); name:
                   which runs they belong to. One row of a name is a peak, several
                   are a curve.
scatter            how far tests lie apart, of each quantity in one of three forms:
                     displacement_minus_mm, displacement_plus_mm   below, above the mean
                     displacement_min_mm, displacement_max_mm      smallest, largest
                     displacement_sd_mm                            standard deviation
                   and force_minus, force_plus; force_min, force_max; force_sd, in the
                   unit of the force.
paths              x_mm, y_mm in order; name; crack: a number per piece; scatter_mm:
                   how far tests lie to both sides of the path."""
import collections

from report_parts.csv_table import Table
from report_parts.safe import grouped

from .errors import StudyError

FORCES = ("force_N_per_mm", "force_N")
FORMS = (("minus", "plus"), ("min", "max"), ("sd",))
QUANTITIES = (("displacement_%s_mm", "displacement_mm"), ("force_%s", None))

# unit: which of FORCES; scatter: ((low, high) of the displacement, of the force), each
# None where it is not known; None for both
Reference = collections.namedtuple("Reference",
                                   "name displacement force unit scatter")
# lines: [[(x, y)]]; scatter: mm or None
Path = collections.namedtuple("Path", "name lines scatter")


def forms_in(table):
    """The form of scatter of displacement and of force: names of columns, or None."""
    found = []
    for pattern, _ in QUANTITIES:
        columns = [tuple(pattern % word for word in form) for form in FORMS]
        used = [names for names in columns if any(n in table.names for n in names)]
        if len(used) > 1:
            raise StudyError("%s: scatter is given twice, by %s and %s"
                             % (table.path, used[0][0], used[1][0]))
        for name in used[0] if used else ():
            if name not in table.names:
                raise StudyError("%s: scatter needs all of %s; there is no %s"
                                 % (table.path, ", ".join(used[0]), name))
        found.append(used[0] if used else None)
    return found


def band_of(table, line, row, columns, mean, deviations):
    """(low, high), or None."""
    if columns is None:
        return None
    values = [table.number(line, column, row[column]) for column in columns]
    if "_min" in columns[0] and "_minus" not in columns[0]:
        low, high = values
    else:
        if min(values) < 0.:
            raise StudyError("%s:%d: scatter is a distance from the mean and not below "
                             "0, found %g" % (table.path, line, min(values)))
        below, above = values if len(values) == 2 else 2 * [deviations * values[0]]
        low, high = mean - below, mean + above
    if low > high:
        raise StudyError("%s:%d: the smallest value, %g, is above the largest, %g"
                         % (table.path, line, low, high))
    return low, high


def read_points(path, deviations=1.):
    """[Reference] of a file of peaks or curves. deviations: how many standard
    deviations a band reaches to each side."""
    table = Table(path)
    unit = next((name for name in FORCES if name in table.names), None)
    if unit is None or "displacement_mm" not in table.names:
        raise StudyError("%s: expected a header with displacement_mm and %s"
                         % (path, " or ".join(FORCES)))
    forms, found = forms_in(table), []
    for line, row in table.records():
        means = [table.number(line, name, row[name])
                 for name in ("displacement_mm", unit)]
        bands = [band_of(table, line, row, columns, mean, deviations)
                 for columns, mean in zip(forms, means)]
        found.append(Reference(row.get("name", ""), means[0], means[1], unit,
                               tuple(bands) if any(bands) else None))
    return found


def read_paths(path):
    """{name: Path}; the name is '' in a file of one path."""
    table = Table(path)
    lines, scatters = {}, {}
    for number, row in table.records():
        point = tuple(table.number(number, axis, row[axis]) for axis in ("x_mm", "y_mm"))
        name = row.get("name", "")
        pieces = lines.setdefault(name, {})
        pieces.setdefault(row.get("crack", ""), []).append(point)
        if "scatter_mm" in row:
            scatters[name] = max(table.number(number, "scatter_mm", row["scatter_mm"]),
                                 scatters.get(name, 0.))
    for name, pieces in lines.items():
        if any(len(piece) < 2 for piece in pieces.values()):
            raise StudyError("%s: a path needs two points%s"
                             % (path, " (%s)" % name if name else ""))
    if not lines:
        raise StudyError("%s: there is no point of a path" % path)
    return {name: Path(name, list(pieces.values()), scatters.get(name))
            for name, pieces in lines.items()}


def name_for(run_name, names):
    """Which of the names of references belongs to a run: its own, its last word
    (of neo_hooke_12, 12), or '', which belongs to all; None without one."""
    return next((name for name in (run_name, run_name.rpartition("_")[2], "")
                 if name in names), None)


class References:
    """What several files hold together: points {name: [Reference]}, of which one is
    a peak and several are a curve; paths {name: Path}; unit of the forces."""

    def __init__(self, files, deviations=1.):
        self.points, self.curves, self.paths, self.unit = {}, {}, {}, None
        for path in files:
            if {"x_mm", "y_mm"} <= set(Table(path).names):
                self.add(self.paths, read_paths(path), path)
            else:
                self.add_points(read_points(path, deviations), path)

    @staticmethod
    def add(known, found, path):
        for name in found:
            if name in known:
                raise StudyError("%s: '%s' is given twice" % (path, name))
        known.update(found)

    def add_points(self, points, path):
        for point in points:
            if self.unit not in (None, point.unit):
                raise StudyError("%s: its forces are %s, those before it %s"
                                 % (path, point.unit, self.unit))
            self.unit = point.unit
        groups = grouped(points, lambda point: point.name)
        # one row and several of a name are two things: its peak and its curve
        self.add(self.points, {n: p[0] for n, p in groups.items() if len(p) == 1}, path)
        self.add(self.curves, {n: p for n, p in groups.items() if len(p) > 1}, path)

    def names(self):
        return list({**self.points, **self.curves, **self.paths})

    def of(self, run_name):
        """(Reference of the peak or None, [Reference] of the curve, Path or None)."""
        peak, curve, path = (
            known.get(name_for(run_name, known))
            for known in (self.points, self.curves, self.paths))
        if peak is None and curve:
            peak = max(curve, key=lambda point: point.force)
        return peak, curve or [], path

    def used_by(self, run_name):
        return {name_for(run_name, known)
                for known in (self.points, self.curves, self.paths)} - {None}
