# SPDX-License-Identifier: GPL-2.0-or-later
"""How far sets of polylines, the paths of cracks, lie apart. Lengths in mm.

A path is a list of polylines, each an array (n, 2) of points, n >= 2. Distances are
those of points along the one, close together and each standing for the same length, to
the nearest point of the other, on its segments as well as at its points."""
import collections

import numpy as np

SAMPLES = 2000  # along all polylines of a path
ROUNDING = 1e-12  # of the length: what is nearer is the same

# of one path from another, both ways: mean over the length, and Hausdorff distance
Apart = collections.namedtuple("Apart", "mean hausdorff")


def length_of(line):
    return float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())


def distances_to_segment(points, begin, end):
    along = end - begin
    square = float(along @ along)
    part = np.zeros(len(points)) if square == 0. \
        else np.clip((points - begin) @ along / square, 0., 1.)
    return np.linalg.norm(points - begin - part[:, None] * along, axis=1)


def distances(points, lines):
    """Of points (n, 2) to the nearest of the polylines."""
    nearest = np.full(len(points), np.inf)
    for line in lines:
        for begin, end in zip(line[:-1], line[1:]):
            np.minimum(nearest, distances_to_segment(points, begin, end), out=nearest)
    return nearest


def sampled(line, n):
    """n points in the middle of n equal lengths of a polyline, (n, 2)."""
    arc = np.concatenate([[0.], np.cumsum(
        np.linalg.norm(np.diff(line, axis=0), axis=1))])
    at = (np.arange(n) + 0.5) * arc[-1] / n
    return np.column_stack([np.interp(at, arc, line[:, k]) for k in (0, 1)])


def samples_of(lines, n=SAMPLES):
    """Points along all polylines, about n, as many per length on each."""
    total = sum(map(length_of, lines))
    if total == 0.:
        return np.concatenate(lines)
    return np.concatenate([sampled(line, max(1, round(n * length_of(line) / total)))
                           for line in lines])


def one_way(lines, others):
    """(mean over the length, largest) distance of `lines` from `others`."""
    along = distances(samples_of(lines), others)
    # the farthest point is mostly an end or a corner, which no sample hits
    corners = distances(np.concatenate(lines), others)
    found = float(along.mean()), float(max(along.max(), corners.max()))
    small = ROUNDING * sum(map(length_of, lines))
    return tuple(0. if value <= small else value for value in found)


def apart(first, second):
    """Apart of two paths; symmetric: the mean of both mean distances, and the larger
    of both largest ones. A path that ends early is far from what the other one has
    beyond its end."""
    there, back = one_way(first, second), one_way(second, first)
    return Apart(0.5 * (there[0] + back[0]), max(there[1], back[1]))


def share_within(lines, others, width):
    """Share of the length of `lines` that is no farther than `width` from `others`."""
    return float((distances(samples_of(lines), others) <= width).mean())
