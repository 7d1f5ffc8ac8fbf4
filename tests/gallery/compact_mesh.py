#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Mesh of the compact tension specimen of ASTM E399, with the crack as a slit.

    compact_mesh.py FILE [crack length in mm]

W = 40 mm from the line of the pins, x = 0, to the back; the pins are at
y = +-0.275 W. Cells of 2 mm, rows of 1 mm beside the pins.
"""
import sys

LEFT, BACK, TOP = -10, 40, 24
COLUMNS = range(LEFT, BACK + 1, 2)
UPPER = [0, 2, 4, 6, 8, 10, 11, 12, 14, 16, 18, 20, 22, TOP]
ROWS = [-y for y in UPPER[:0:-1]] + UPPER


def compact_mesh(crack_length=20):
    """Gmsh 2.2; nodes of the crack twice, but for the one at its tip."""
    nodes, cells = {}, []

    def node(x, y, above):
        doubled = y == 0 and x < crack_length and above
        return nodes.setdefault((x, y, doubled), len(nodes) + 1)

    for low, high in zip(ROWS, ROWS[1:]):
        for left, right in zip(COLUMNS, COLUMNS[1:]):
            cells.append([node(left, low, low >= 0), node(right, low, low >= 0),
                          node(right, high, low >= 0), node(left, high, low >= 0)])
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(nodes))]
    lines += ["%d %d %d 0" % (number, x, y) for (x, y, _), number in nodes.items()]
    lines += ["$EndNodes", "$Elements", str(len(cells))]
    lines += ["%d 3 2 1 1 %d %d %d %d" % (i + 1, *cell) for i, cell in enumerate(cells)]
    return "\n".join(lines) + "\n$EndElements\n"


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(compact_mesh(*(int(word) for word in sys.argv[2:])))
