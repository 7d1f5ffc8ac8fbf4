# SPDX-License-Identifier: GPL-2.0-or-later
"""Energy release rates G (N/mm) from pure-shear specimens of width w, height h0 and
thickness t (mm), u the displacement and a the length of the crack (mm):

    energy difference  -(U(u, a2) - U(u, a1)) / (t (a2 - a1)), two cracks that stand,
                       U = integral of F du; also of growing cracks up to the onset
    energy balance     (integral of F du - change of stored energy) / (t (a2 - a1))
                       between two rows of a growing crack, where the stored energy is
                       known (column elastic_energy_mJ)
    force ratio        -(U_w / t) d(F / F_w) / da of a growing crack: U(u, a) is taken
                       as U_w(u) F / F_w, which holds where a crack takes a piece out
                       of the specimen as long as it is, plus a constant
    W h0               U_w / (w t), Rivlin and Thomas, without edges
    paper              (U_w - integral of F du) / (a t), as [Mang21] does

U_w and F_w are those of the specimen without a crack.
"""
import collections

import numpy as np

from report_parts.errors import InputError

from .tear_curves import GROWING

DIFFERENCE, BALANCE, RATIO, PLANE, PAPER = METHODS = (
    "energy difference", "energy balance", "force ratio", "W h0", "paper")


# G at a crack length and a displacement, by a method, of a curve
Point = collections.namedtuple("Point", "method curve length displacement value")


def standing_curves(specimen):
    """[(length, curve)] with cracks that stand, up to curve.end; ascending."""
    found = [(curve.length, curve) for curve in specimen.standing]
    found += [(float(curve.length[0]), curve) for curve in specimen.growing]
    return sorted(found, key=lambda pair: pair[0])


def differences(specimen, displacement):
    """[(name, mean length, G)] of neighbouring lengths at a displacement. A crack
    that has grown by then has spent work, and does not count."""
    pairs = [(length, curve) for length, curve in standing_curves(specimen)
             if curve.kind != GROWING or displacement <= curve.end * (1. + 1e-9)]
    found = []
    for (a1, one), (a2, other) in zip(pairs, pairs[1:]):
        if a2 - a1 > 1e-9 * specimen.width:
            change = other.work(displacement) - one.work(displacement)
            found.append(("%s, %s" % (one.name, other.name), 0.5 * (a1 + a2),
                          -change / (specimen.thickness * (a2 - a1))))
    return found


def of_standing(specimen, onset, paper):
    points = [Point(DIFFERENCE, name, length, onset, value)
              for name, length, value in differences(specimen, onset)]
    if specimen.uncracked is None:
        return points
    whole = specimen.uncracked.work(onset)
    for curve in specimen.standing:
        points.append(Point(PLANE, curve.name, curve.length, onset,
                            whole / (specimen.width * specimen.thickness)))
        if paper:
            points.append(Point(PAPER, curve.name, curve.length, onset,
                                (whole - curve.work(onset))
                                / (curve.length * specimen.thickness)))
    return points


def growth_rows(curve):
    """Rows between which the crack grows by at least the step, from the last one on
    in which it stands."""
    a, rows = curve.length, [curve.first]
    for i in range(rows[0] + 1, len(a)):
        if a[i] >= a[rows[-1]] + curve.step * (1. - 1e-9):
            rows.append(i)
    return np.array(rows)


def accumulated_work(curve):
    """The integral of F du up to each row, mJ."""
    parts = 0.5 * (curve.force[1:] + curve.force[:-1]) * np.diff(curve.displacement)
    return np.append(0., np.cumsum(parts))


def of_growing(specimen, curve, paper):
    rows = growth_rows(curve)
    a, u = curve.length[rows], curve.displacement[rows]
    middle, at = 0.5 * (a[1:] + a[:-1]), 0.5 * (u[1:] + u[:-1])
    area = specimen.thickness * np.diff(a)
    rates = {}
    if curve.stored is not None:
        left = accumulated_work(curve)[rows] - curve.stored[rows]
        rates[BALANCE] = np.diff(left) / area
    if specimen.uncracked is not None:
        whole = specimen.uncracked.work(u)
        mean = 0.5 * (whole[1:] + whole[:-1])
        ratio = curve.force[rows] / specimen.uncracked.force_at(u)
        rates[RATIO] = -mean * np.diff(ratio) / area
        rates[PLANE] = mean / (specimen.width * specimen.thickness)
        if paper:
            lost = whole - accumulated_work(curve)[rows]
            lost = 0.5 * (lost[1:] + lost[:-1])
            rates[PAPER] = lost / (middle * specimen.thickness)
    return [Point(method, curve.name, *values) for method in rates
            for values in zip(middle, at, rates[method])]


def means_of(points, specimen, mean_from):
    """[(method, curve, mean G, smallest, largest, number)] of growing cracks, over
    those that have grown by more than mean_from."""
    found = []
    for curve in specimen.growing:
        for method in METHODS:
            values = [point.value for point in points
                      if point.method == method and point.curve == curve.name
                      and point.length - curve.length[0] >= mean_from]
            if values:
                found.append((method, curve.name, float(np.mean(values)),
                              min(values), max(values), len(values)))
    return found


def evaluated(specimen, options):
    """(onset in mm, points)."""
    onset = options.onset or min(curve.end for _, curve in standing_curves(specimen))
    points = of_standing(specimen, onset, options.paper_formula)
    for curve in specimen.growing:
        points += of_growing(specimen, curve, options.paper_formula)
    if not points:
        raise InputError("--tear: expected uncracked:FILE, cracks of two lengths, or a "
                         "growing crack with the column elastic_energy_mJ beside '%s', "
                         "found none of them"
                         % standing_curves(specimen)[0][1].path)
    return onset, points


def table_lines(points):
    """A line per crack length of a curve, a column per method."""
    methods = [method for method in METHODS
               if any(point.method == method for point in points)]
    rows = {}
    for point in points:
        place = point.curve, point.length, point.displacement
        rows.setdefault(place, {})[point.method] = point.value
    yield "%12s %17s" % ("crack (mm)", "displacement (mm)") \
        + "".join(" %17s" % method for method in methods) + "  of"
    for place in sorted(rows):
        yield "%12.5g %17.5g" % place[1:] + "".join(
            " %17s" % ("%.4g" % rows[place][method] if method in rows[place] else "-")
            for method in methods) + "  " + place[0]


def text_of(specimen, onset, points, mean_from):
    """What is printed."""
    lines = ["Pure shear, %g x %g x %g mm; G in N/mm"
             % (specimen.width, specimen.height, specimen.thickness),
             "Standing cracks are evaluated at %.5g mm, stretch %.4g"
             % (onset, 1. + onset / specimen.height), *table_lines(points)]
    for method, name, *numbers in means_of(points, specimen, mean_from):
        lines.append("mean by %s of %s, growth beyond %g mm: %.4g N/mm "
                     "(%.4g to %.4g, %d values)" % (method, name, mean_from, *numbers))
    return "\n".join(lines) + "\n"


def json_of(specimen, onset, points, mean_from):
    return {"specimen_mm": {"width": specimen.width, "height": specimen.height,
                            "thickness": specimen.thickness},
            "onset_displacement_mm": onset,
            "points": [dict(zip(("method", "curve", "crack_length_mm", "displacement_mm",
                                 "G_N_per_mm"), point)) for point in points],
            "means": [dict(zip(("method", "curve", "G_N_per_mm", "smallest", "largest",
                                "values"), mean))
                      for mean in means_of(points, specimen, mean_from)]}
