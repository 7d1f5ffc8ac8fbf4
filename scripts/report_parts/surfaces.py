# SPDX-License-Identifier: GPL-2.0-or-later
"""Surfaces in bodies of hexahedra: where a field has a value, plane sections,
and the edges of the body. Numpy only."""
import itertools

import numpy as np

from . import vtu

# Six tetrahedra around the diagonal from corner 0 to corner 6 (as VTK counts).
TETRAHEDRA = np.array([(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6),
                       (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)])


def pieces_of_cut():
    """{(which of four corners lie below): [triangle of three crossed edges]}"""
    table = {}
    for below in itertools.product((False, True), repeat=4):
        low = [i for i in range(4) if below[i]]
        high = [i for i in range(4) if not below[i]]
        if len(low) == 2:
            a, b, c, d = ((low[i], high[j]) for i, j in ((0, 0), (0, 1), (1, 1), (1, 0)))
            table[below] = [(a, b, c), (a, c, d)]
        elif low and high:
            table[below] = [tuple((i, j) for i in low for j in high)]
    return table


def level_set(points, cells, field, level, carried=None):
    """Triangles (n, 3, 3) of the surface where the field, given at the points,
    has the level, and the values (n, 3) there of another field. Linear in each
    of six tetrahedra of a cell."""
    carried = field if carried is None else carried
    # a level that is met at a corner exactly leaves no triangle out
    above = field - level
    above = np.where(above == 0., 1e-12 * (np.abs(field).max() or 1.), above)
    sides = above[cells] < 0.
    crossed = cells[sides.any(axis=1) & ~sides.all(axis=1)]
    corners = crossed[:, TETRAHEDRA].reshape(-1, 4)
    below = above[corners] < 0.
    triangles, values = [np.zeros((0, 3, 3))], [np.zeros((0, 3))]
    for pattern, pieces in pieces_of_cut().items():
        chosen = corners[(below == np.array(pattern)).all(axis=1)]
        for piece in pieces if len(chosen) else ():
            vertices, numbers = [], []
            for i, j in piece:
                a, b = chosen[:, i], chosen[:, j]
                share = above[a] / (above[a] - above[b])
                vertices.append(points[a] + share[:, None] * (points[b] - points[a]))
                numbers.append(carried[a] + share * (carried[b] - carried[a]))
            triangles.append(np.stack(vertices, axis=1))
            values.append(np.stack(numbers, axis=1))
    return np.concatenate(triangles), np.concatenate(values)


def plane_section(points, cells, field, axis, position):
    """(triangles, values of the field) in the plane where that coordinate has
    this value; a plane of nodes is cut beside them."""
    extent = float(np.ptp(points, axis=0).max()) or 1.
    middle = 0.5 * (points[:, axis].min() + points[:, axis].max())
    shift = 1e-5 * extent * (1. if position <= middle else -1.)
    return level_set(points, cells, points[:, axis], position + shift, field)


def caps(points, faces, field, level):
    """Polygons of the parts of faces where the field is below the level."""
    polygons = []
    below = field[faces] < level
    for face in faces[below.any(axis=1)]:
        polygon = []
        for a, b in zip(face, np.roll(face, -1)):
            if field[a] < level:
                polygon.append(points[a])
            if (field[a] < level) != (field[b] < level):
                share = (level - field[a]) / (field[b] - field[a])
                polygon.append(points[a] + share * (points[b] - points[a]))
        if len(polygon) > 2:
            polygons.append(np.array(polygon))
    return polygons


def unit(vectors):
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(length > 0., length, 1.)


def normals_of(points, cells, faces):
    """Unit normals of outer faces, away from the cell behind. A face whose cell
    is not found keeps the sign of its corners' order."""
    first, second = (points[faces[:, 2]] - points[faces[:, 0]],
                     points[faces[:, 3]] - points[faces[:, 1]])
    normals = unit(np.cross(first, second))
    cell_of = np.full(len(points), -1)
    cell_of[cells] = np.arange(len(cells))[:, None]
    # points are not shared by cells in what deal.II writes
    inside = points[cells[cell_of[faces[:, 0]]]].mean(axis=1)
    outward = np.einsum("ij,ij->i", points[faces].mean(axis=1) - inside, normals)
    return normals * np.where(outward < 0., -1., 1.)[:, None]


def halved(points, pairs, owners):
    """Edges beside hanging nodes as their halves."""
    for _ in range(4):
        middle = vtu.found_at(points, points[pairs].mean(axis=1))
        split = middle >= 0
        if not split.any():
            break
        long, between = pairs[split], middle[split]
        pairs = np.concatenate([pairs[~split],
                                np.stack([long[:, 0], between], axis=1),
                                np.stack([between, long[:, 1]], axis=1)])
        owners = np.concatenate([owners[~split], owners[split], owners[split]])
    return pairs, owners


def feature_edges(points, faces, normals, sharp=0.85):
    """[(two points, normals of the faces there)]: edges where outer faces meet
    at an angle."""
    used, local = np.unique(faces, return_inverse=True)
    points, faces = points[used], local.reshape(faces.shape)
    pairs = np.concatenate([faces[:, [i, (i + 1) % 4]] for i in range(4)])
    owners = np.tile(np.arange(len(faces)), 4)
    place = vtu.merged_points(points)
    proper = place[pairs[:, 0]] != place[pairs[:, 1]]
    pairs, owners = halved(points, pairs[proper], owners[proper])
    keys = np.sort(place[pairs], axis=1)
    _, first, inverse = np.unique(keys, axis=0, return_index=True,
                                  return_inverse=True)
    by_edge = [[] for _ in first]
    for edge, owner in zip(inverse.ravel(), owners):
        by_edge[edge].append(normals[owner])
    edges = [(points[pairs[i]], np.array(all_normals))
             for i, all_normals in zip(first, by_edge)]
    return [(ends, directions) for ends, directions in edges
            if (directions @ directions.T).min() < sharp]
