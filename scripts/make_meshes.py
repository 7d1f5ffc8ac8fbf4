#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Write the meshes of the benchmarks into meshes/ (Gmsh 2.2, ASCII).

  scripts/make_meshes.py [DIRECTORY]

Block meshes, coarse: the .prm refines them where the crack is to run. Every mesh
of the plane is a list of grid lines in two directions, a rule for nodes that are
doubled along slits, a place for every node, and names for pieces of the
boundary. Meshes in 3-d are made of nested cubes that are drawn out to spheres.
"""

import functools
import itertools
import math
import os
import sys


def rings_of(xs, ys, opened):
    """The nodes of every cell as (column, row, side); side is -1 or 1 where
    opened(x, y) says that the node is doubled, and 0 elsewhere."""
    return [[(a, b, (1 if a == i else -1) if opened(xs[a], ys[b]) else 0)
             for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
            for i in range(len(xs) - 1) for j in range(len(ys) - 1)]


def boundary_edges(rings):
    """Edges with one cell only."""
    count = {}
    for ring in rings:
        for a, b in zip(ring, ring[1:] + ring[:1]):
            count.setdefault(frozenset((a, b)), []).append((a, b))
    return [pairs[0] for pairs in count.values() if len(pairs) == 1]


def write_mesh(path, xs, ys, boundary_of, names, place, opened=None):
    """place(x, y, side): the point of a node. boundary_of(x, y, side) names the
    edge with this midpoint of the grid; names lists the names in the order of
    their numbers, 1 and up."""
    rings = rings_of(xs, ys, opened or (lambda x, y: False))
    nodes = sorted({node for ring in rings for node in ring},
                   key=lambda n: (n[1], n[0], n[2]))
    number = {node: k + 1 for k, node in enumerate(nodes)}
    elements = []
    for a, b in boundary_edges(rings):
        x = 0.5 * (xs[a[0]] + xs[b[0]])
        y = 0.5 * (ys[a[1]] + ys[b[1]])
        tag = names.index(boundary_of(x, y, a[2] or b[2])) + 1
        elements.append((1, tag, (number[a], number[b])))
    elements += [(3, len(names) + 1, tuple(number[n] for n in ring)) for ring in rings]
    write_gmsh(path, [(1, name) for name in names] + [(2, "body")],
               [place(xs[node[0]], ys[node[1]], node[2]) + (0.,)
                for node in nodes], elements)


def write_gmsh(path, physical, points, elements):
    """physical: (dimension, name) of the numbers 1 and up. elements: (Gmsh's
    type, physical number, nodes from 1)."""
    with open(path, "w") as out:
        out.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n")
        out.write("%d\n" % len(physical))
        for k, (dimension, name) in enumerate(physical):
            out.write('%d %d "%s"\n' % (dimension, k + 1, name))
        out.write("$EndPhysicalNames\n$Nodes\n%d\n" % len(points))
        for k, point in enumerate(points):
            out.write("%d %.15g %.15g %.15g\n" % ((k + 1,) + tuple(point)))
        out.write("$EndNodes\n$Elements\n%d\n" % len(elements))
        for k, (kind, tag, vertices) in enumerate(elements):
            out.write("%d %d 2 %d %d %s\n" %
                      (k + 1, kind, tag, tag, " ".join(map(str, vertices))))
        out.write("$EndElements\n")


def bending_beam(path):
    """Beam 8 x 2 mm with a triangular notch, 0.4 mm wide and 0.4 mm deep,
    loaded from above at its middle [Miehe10b]."""
    right = [0.1, 0.3, 0.6, 1., 1.5, 2., 2.5, 3., 3.5, 4.]
    xs = [-x for x in reversed(right)] + [0.] + right
    ys = [0.2 * k for k in range(11)]
    depth, width = 0.4, 0.4

    def opened(x, y):
        return abs(x) < 1e-9 and y < depth - 1e-9

    def place(x, y, side):
        # the sides of the notch, and the lines beside it, make room for it
        room = max(0., 1. - y / depth) * 0.5 * width
        if side != 0:
            return side * room, y
        if 0. < abs(x) < 2.:
            shift = room * (2. - abs(x)) / 2.
            return x + (shift if x > 0. else -shift), y
        return x, y

    def boundary_of(x, y, side):
        if side != 0 and abs(x) < 1e-9:
            return "notch"
        if y > 1.99:
            return "load" if abs(x) < 0.1 else "top"
        if abs(x) > 3.99:
            return "left" if x < 0 else "right"
        return "bottom"

    write_mesh(path, xs, ys, boundary_of,
               ["bottom", "right", "top", "left", "notch", "load"], place, opened)


def numbered(place):
    """(node, points): node(corner, layer) is the number of a node, from 1 on, which is
    at place(corner, layer); points are these places."""
    points = []

    @functools.lru_cache(maxsize=None)
    def node(corner, layer):
        points.append(place(corner, layer))
        return len(points)
    return node, points


def sides_of_cube(n):
    """(normal's axis, its sign, quadrilateral) of the n * n faces of each side;
    corners are integers from 0 to n, counterclockwise from outside."""
    for axis, end in itertools.product(range(3), (0, n)):
        for i, j in itertools.product(range(n), repeat=2):
            quad = []
            for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                corner = [0, 0, 0]
                corner[axis] = end
                corner[(axis + 1) % 3], corner[(axis + 2) % 3] = a, b
                quad.append(tuple(corner))
            yield axis, end, quad if end else quad[::-1]


def block_with_inclusion(path):
    """Cube of 2 mm around the origin with a sphere of radius 0.4 mm."""
    n, n_inside, n_outside = 4, 1, 3
    core, radius, half = 0.2, 0.4, 1.
    n_layers = n_inside + n_outside

    def place(corner, layer):
        """Layer 0: the innermost cube; n_inside: the sphere; last: the block."""
        cube = [2. * i / n - 1. for i in corner]
        if not any(i in (0, n) for i in corner):
            return tuple(core * x for x in cube)
        to_sphere = radius / sum(x * x for x in cube) ** 0.5
        share, ends = (layer / n_inside, (core, to_sphere)) if layer <= n_inside \
            else ((layer - n_inside) / n_outside, (to_sphere, half))
        return tuple(x * ((1. - share) * ends[0] + share * ends[1]) for x in cube)

    node, points = numbered(place)
    unit = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))
    elements = [(3, 2 * axis + (end > 0) + 1,
                 tuple(node(corner, n_layers) for corner in quad))
                for axis, end, quad in sides_of_cube(n)]
    elements += [(5, 8, tuple(
        node(tuple(c + s for c, s in zip(corner, (x, y, z + up))), 0)
        for up in (0, 1) for x, y, z in unit))
        for corner in itertools.product(range(n), repeat=3)]
    elements += [(5, 8 if layer < n_inside else 7, tuple(
        node(corner, layer + up) for up in (0, 1) for corner in quad))
        for layer in range(n_layers) for _, _, quad in sides_of_cube(n)]
    write_gmsh(path, [(2, name) for name in ("left", "right", "bottom", "top",
                                             "back", "front")]
               + [(3, "matrix"), (3, "inclusion")], points, elements)


def thick_cylinder(path):
    """A quarter of a ring, radii 1 and 2 mm."""
    n = 4

    def boundary_of(radius, angle, side):
        if min(abs(angle), abs(angle - math.pi / 2.)) < 1e-9:
            return "bottom" if angle < 1. else "left"
        return "inner" if radius < 1.5 else "outer"

    write_mesh(path, [1. + i / n for i in range(n + 1)],
               [0.5 * math.pi * j / n for j in range(n + 1)], boundary_of,
               ["inner", "outer", "bottom", "left"],
               lambda radius, angle, side: (radius * math.cos(angle),
                                            radius * math.sin(angle)))


def thick_sphere(path):
    """An eighth of a spherical shell, radii 1 and 2 mm: the three far sides of a
    cube of n^3, drawn out to spheres, in layers."""
    n, n_layers = 2, 2

    def place(corner, layer):
        angles = [math.tan(0.25 * math.pi * i / n) for i in corner]
        size = sum(x * x for x in angles) ** 0.5
        return tuple((1. + layer / n_layers) * x / size for x in angles)

    node, points = numbered(place)
    elements = []
    quads = [quad for _, end, quad in sides_of_cube(n) if end]
    for quad in quads:
        for layer, tag in ((0, 1), (n_layers, 2)):
            elements.append((3, tag, tuple(node(c, layer) for c in quad)))
        for a, b in zip(quad, quad[1:] + quad[:1]):
            for axis in range(3):
                if a[axis] == b[axis] == 0:
                    for layer in range(n_layers):
                        elements.append((3, 3 + axis, (
                            node(a, layer), node(b, layer),
                            node(b, layer + 1), node(a, layer + 1))))
        for layer in range(n_layers):
            elements.append((5, 6, tuple(node(c, layer + up) for up in (0, 1)
                                         for c in quad)))
    elements.sort(key=lambda element: (element[0], element[1]))
    write_gmsh(path, [(2, name) for name in ("inner", "outer", "left", "bottom",
                                             "back")] + [(3, "shell")],
               [tuple(0. if abs(x) < 1e-14 else x for x in point)
                for point in points], elements)


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    where = sys.argv[1] if len(sys.argv) > 1 else os.path.join(
        here, "..", "meshes")
    for write in (bending_beam, block_with_inclusion, thick_cylinder, thick_sphere):
        write(os.path.join(where, write.__name__ + ".msh"))


if __name__ == "__main__":
    main()
