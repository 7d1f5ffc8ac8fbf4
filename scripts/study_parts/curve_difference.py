# SPDX-License-Identifier: GPL-2.0-or-later
"""How far a curve lies from a reference: force over displacement, straight between
points. Integrals are exact for such curves.

    relative L2  = sqrt( int (F - R)^2 du / int R^2 du )
    area         = int |F - R| du                     (mJ when forces are in N)
    relative area = area / int |R| du

over the displacements u that both have. `covered` is their share of the reference's."""
import collections

import numpy as np

from .errors import StudyError

Difference = collections.namedtuple("Difference",
                                    "relative_l2 area relative_area covered")


def increasing(x, y, what):
    """(x, y) as arrays without what is not finite. Raises StudyError where there are
    fewer than two points, or x goes back, which leaves no force to a displacement."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    known = np.isfinite(x) & np.isfinite(y)
    x, y = x[known], y[known]
    if (np.diff(x) < 0.).any():
        at = int(np.argmax(np.diff(x) < 0.))
        raise StudyError("%s: the displacement goes back from %g to %g mm: not one "
                         "force per displacement" % (what, x[at], x[at + 1]))
    if len(x) < 2 or x[-1] == x[0]:
        raise StudyError("%s: a curve needs two points with different displacements"
                         % what)
    return x, y


def values_on_pieces(x, y, knots):
    """Left and right values of the curve on the pieces between the knots, where the
    curve may jump at a knot (two points with one x)."""
    middles = 0.5 * (knots[:-1] + knots[1:])
    piece = np.clip(np.searchsorted(x, middles, side="right") - 1, 0, len(x) - 2)
    slope = (y[piece + 1] - y[piece]) / (x[piece + 1] - x[piece])
    return (y[piece] + slope * (knots[:-1] - x[piece]),
            y[piece] + slope * (knots[1:] - x[piece]))


def integral_of_square(widths, left, right):
    """Of a function that is straight on every piece."""
    return float((widths * (left**2 + left * right + right**2)).sum() / 3.)


def integral_of_size(widths, left, right):
    """Of its modulus: where it changes its sign, of two triangles."""
    same = left * right >= 0.
    total = np.abs(left) + np.abs(right)
    crossing = (left**2 + right**2) / np.where(total > 0., total, 1.)
    return float((widths * 0.5 * np.where(same, total, crossing)).sum())


def difference(curve, reference, held=False):
    """Difference of two pairs (x, y) of arrays that increasing() has passed; None
    where they have no displacement in common. held: the curve ended because the body
    had come apart, and its last force goes on to the end of the reference."""
    (x, y), (rx, ry) = curve, reference
    if held and x[-1] < rx[-1]:
        x, y = np.append(x, rx[-1]), np.append(y, y[-1])
    low, high = max(x[0], rx[0]), min(x[-1], rx[-1])
    if not high > low:
        return None
    knots = np.unique(np.concatenate([x, rx, [low, high]]))
    knots = knots[(knots >= low) & (knots <= high)]
    widths = np.diff(knots)
    left, right = values_on_pieces(x, y, knots)
    r_left, r_right = values_on_pieces(rx, ry, knots)
    square = integral_of_square(widths, r_left, r_right)
    size = integral_of_size(widths, r_left, r_right)
    if not square > 0.:
        return None
    area = integral_of_size(widths, left - r_left, right - r_right)
    return Difference(
        float(np.sqrt(integral_of_square(widths, left - r_left, right - r_right)
                      / square)),
        area, area / size, float((high - low) / (rx[-1] - rx[0])))


def share_inside(curve, x, low, high):
    """Share of the points x at which the curve lies between low and high; None where
    it reaches none of them. x, low, high: arrays of one length."""
    known = (x >= curve[0][0]) & (x <= curve[0][-1])
    if not known.any():
        return None
    y = np.interp(x[known], *curve)
    return float(((low[known] <= y) & (y <= high[known])).mean())
