#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Write the meshes of the benchmarks into meshes/ (Gmsh 2.2, ASCII).

  scripts/make_meshes.py [DIRECTORY]

Block meshes of quadrilaterals, coarse: the .prm refines them where the crack
is to run. Every mesh is a list of grid lines in two directions, a rule for
nodes that are doubled along slits, a place for every node, and names for pieces
of the boundary.
"""

import os
import sys


def rings_of(xs, ys, opened):
    """The nodes of every cell as (column, row, side); side is -1 or 1 where
    opened(x, y) says that the node is doubled, and 0 elsewhere."""
    rings = []
    for i in range(len(xs) - 1):
        for j in range(len(ys) - 1):
            corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            rings.append([(a, b, (1 if a == i else -1)
                           if opened(xs[a], ys[b]) else 0) for a, b in corners])
    return rings


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
    body = len(names) + 1
    for ring in rings:
        elements.append((3, body, tuple(number[n] for n in ring)))
    with open(path, "w") as out:
        out.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n")
        out.write("%d\n" % (len(names) + 1))
        for k, name in enumerate(names):
            out.write('1 %d "%s"\n' % (k + 1, name))
        out.write('2 %d "body"\n$EndPhysicalNames\n' % body)
        out.write("$Nodes\n%d\n" % len(nodes))
        for node in nodes:
            x, y = place(xs[node[0]], ys[node[1]], node[2])
            out.write("%d %.15g %.15g 0\n" % (number[node], x, y))
        out.write("$EndNodes\n$Elements\n%d\n" % len(elements))
        for k, (kind, tag, vertices) in enumerate(elements):
            out.write("%d %d 2 %d %d %s\n" %
                      (k + 1, kind, tag, tag, " ".join(map(str, vertices))))
        out.write("$EndElements\n")


def bending_beam(path):
    """Beam 8 x 2 mm with a triangular notch, 0.4 mm wide and 0.4 mm deep,
    loaded from above at its middle [Miehe10]."""
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


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    where = sys.argv[1] if len(sys.argv) > 1 else os.path.join(
        here, "..", "meshes")
    bending_beam(os.path.join(where, "bending_beam.msh"))


if __name__ == "__main__":
    main()
