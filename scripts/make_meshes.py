#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Write the meshes of the benchmarks into meshes/ (Gmsh 2.2, ASCII).

  scripts/make_meshes.py [DIRECTORY]

Block meshes of quadrilaterals, coarse: the .prm refines them where the crack
is to run. Every mesh is a list of grid lines in two directions, a rule for
cells that are left out, a map of the plane, and names for pieces of the
boundary.
"""

import os
import sys


def cells_of(xs, ys, is_there):
    """Lower left grid indices of the cells that exist."""
    return [(i, j) for j in range(len(ys) - 1) for i in range(len(xs) - 1)
            if is_there(0.5 * (xs[i] + xs[i + 1]), 0.5 * (ys[j] + ys[j + 1]))]


def edges_of(cells):
    """Edges with one cell only, as pairs of grid indices."""
    count = {}
    for i, j in cells:
        ring = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
        for a, b in zip(ring, ring[1:] + ring[:1]):
            count.setdefault(frozenset((a, b)), []).append((a, b))
    return [pairs[0] for pairs in count.values() if len(pairs) == 1]


def write_mesh(path, xs, ys, is_there, boundary_of, names, place=None):
    """boundary_of(x, y) names the edge with this midpoint of the grid; names
    lists the names in the order of their numbers, 1 and up."""
    place = place or (lambda x, y: (x, y))
    cells = cells_of(xs, ys, is_there)
    nodes = sorted({(i + a, j + b) for i, j in cells
                    for a in (0, 1) for b in (0, 1)}, key=lambda n: n[::-1])
    number = {node: k + 1 for k, node in enumerate(nodes)}
    elements = []
    for a, b in edges_of(cells):
        x = 0.5 * (xs[a[0]] + xs[b[0]])
        y = 0.5 * (ys[a[1]] + ys[b[1]])
        tag = names.index(boundary_of(x, y)) + 1
        elements.append((1, tag, (number[a], number[b])))
    body = len(names) + 1
    for i, j in cells:
        ring = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
        elements.append((3, body, tuple(number[n] for n in ring)))
    with open(path, "w") as out:
        out.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n")
        out.write("%d\n" % (len(names) + 1))
        for k, name in enumerate(names):
            out.write('1 %d "%s"\n' % (k + 1, name))
        out.write('2 %d "body"\n$EndPhysicalNames\n' % body)
        out.write("$Nodes\n%d\n" % len(nodes))
        for node in nodes:
            x, y = place(xs[node[0]], ys[node[1]])
            out.write("%d %.15g %.15g 0\n" % (number[node], x, y))
        out.write("$EndNodes\n$Elements\n%d\n" % len(elements))
        for k, (kind, tag, vertices) in enumerate(elements):
            out.write("%d %d 2 %d %d %s\n" %
                      (k + 1, kind, tag, tag, " ".join(map(str, vertices))))
        out.write("$EndElements\n")


def bending_beam(path):
    """Beam 8 x 2 mm with a notch of 0.2 x 0.4 mm, loaded from above at its
    middle [Miehe10]."""
    right = [0.1, 0.3, 0.6, 1., 1.5, 2., 2.5, 3., 3.5, 4.]
    xs = [-x for x in reversed(right)] + right
    ys = [0.2 * k for k in range(11)]

    def boundary_of(x, y):
        if y > 1.99:
            return "load" if abs(x) < 0.1 else "top"
        if abs(x) > 3.99:
            return "left" if x < 0 else "right"
        return "bottom" if y < 0.01 else "notch"

    write_mesh(path, xs, ys, lambda x, y: abs(x) > 0.1 or y > 0.4, boundary_of,
               ["bottom", "right", "top", "left", "notch", "load"])


def cooks_membrane(path):
    """Cook's membrane: corners (0, 0), (48, 44), (48, 60), (0, 44) mm."""
    lines = [0.25 * k for k in range(5)]

    def place(a, b):
        return 48. * a, 44. * a * (1. - b) + (44. + 16. * a) * b

    def boundary_of(a, b):
        if a < 1e-9 or a > 1. - 1e-9:
            return "left" if a < 0.5 else "right"
        return "bottom" if b < 0.5 else "top"

    write_mesh(path, lines, lines, lambda a, b: True, boundary_of,
               ["bottom", "right", "top", "left"], place)


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    where = sys.argv[1] if len(sys.argv) > 1 else os.path.join(
        here, "..", "meshes")
    bending_beam(os.path.join(where, "bending_beam.msh"))
    cooks_membrane(os.path.join(where, "cooks_membrane.msh"))


if __name__ == "__main__":
    main()
