# SPDX-License-Identifier: GPL-2.0-or-later
"""Meshes of a notched beam in three-point bending: triangles or tetrahedra of Gmsh,
and quadrilaterals or hexahedra in rows and columns, with the size of the cells at
the crack, the ligament above the notch.

Sizes in mm. y goes from the notched side to the load, z along the thickness.
"""
import subprocess

HALF_LENGTH, HEIGHT, THICKNESS = 1.5, 1., 0.3
NOTCH, HALF_WIDTH = 0.3, 0.05
HALF_BAND = 0.2  # to either side of the ligament: as fine as at the crack

SCRIPT = """
Point(1)={{-{l},0,0}}; Point(2)={{-{w},0,0}}; Point(3)={{-{w},{a},0}};
Point(4)={{{w},{a},0}}; Point(5)={{{w},0,0}}; Point(6)={{{l},0,0}};
Point(7)={{{l},{h},0}}; Point(8)={{0,{h},0}}; Point(9)={{-{l},{h},0}};
Line(1)={{1,2}}; Line(2)={{2,3}}; Line(3)={{3,4}}; Line(4)={{4,5}}; Line(5)={{5,6}};
Line(6)={{6,7}}; Line(7)={{7,8}}; Line(8)={{8,9}}; Line(9)={{9,1}};
Curve Loop(1)={{1:9}}; Plane Surface(1)={{1}};
Field[1]=Box; Field[1].VIn={fine}; Field[1].VOut={coarse}; Field[1].Thickness=1;
Field[1].XMin=-{b}; Field[1].XMax={b}; Field[1].YMin=0; Field[1].YMax={h};
Field[1].ZMin=0; Field[1].ZMax={t};
Background Field=1; Mesh.MeshSizeExtendFromBoundary=0; Mesh.MshFileVersion=2.2;
"""


def write_simplices(path, dim, h):
    """Which after each is cut into one piece for each of its corners have about that
    size at the crack; returns which it is. Gmsh takes the length of an edge as a wish:
    several are tried, and the mesh that is next to it stays."""
    edge, best = {2: 2.55, 3: 3.1}[dim] * h, None
    for _ in range(6):
        found = mesh_simplices(path, dim, edge)
        if best is None or abs(found / h - 1.) < abs(best[0] / h - 1.):
            best = found, path.read_bytes()
        if abs(found / h - 1.) < 0.01:
            break
        edge *= (h / found)**0.7
    path.write_bytes(best[1])
    return best[0]


def mesh_simplices(path, dim, edge):
    text = SCRIPT.format(l=HALF_LENGTH, w=HALF_WIDTH, a=NOTCH, h=HEIGHT, b=HALF_BAND,
                         t=THICKNESS, fine=edge, coarse=max(0.25, 2 * edge))
    if dim == 3:
        text += "Extrude{0,0,%g}{Surface{1};}\nPhysical Volume(1)={1};\n" % THICKNESS
    else:
        text += "Physical Surface(1)={1};\n"
    script = path.with_suffix(".geo")
    script.write_text(text, encoding="utf-8")
    subprocess.run(["gmsh", "-v", "1", "-%d" % dim, str(script), "-o", str(path)],
                   check=True)
    nodes, cells = read(path, {2: "2", 3: "4"}[dim])
    measures = [measure([nodes[n] for n in cell], dim) for cell in cells
                if is_at_crack([nodes[n] for n in cell])]
    return (sum(measures) / len(measures) / (dim + 1))**(1. / dim)


def write_bricks(path, dim, h):
    """With about that size of cells at the crack; returns which it is."""
    fine = part(0, HALF_WIDTH, h)[:-1] + part(HALF_WIDTH, HALF_BAND, h)[:-1]
    half = fine + growing(HALF_BAND, HALF_LENGTH, h)
    x = [-c for c in half[:0:-1]] + half
    y = part(0, NOTCH, h)[:-1] + part(NOTCH, HEIGHT, h)
    z = part(0, THICKNESS, h) if dim == 3 else [0.]
    numbers, cells = {}, []

    def node(i, j, k):
        return numbers.setdefault((x[i], y[j], z[k]), len(numbers) + 1)

    for i in range(len(x) - 1):
        for j in range(len(y) - 1):
            if abs(x[i] + x[i + 1]) < 2 * HALF_WIDTH and y[j + 1] <= NOTCH:
                continue
            layers = range(max(len(z) - 1, 1))
            for k in layers:
                around = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                cells.append([node(*p, k + up) for up in range(dim - 1)
                              for p in around])
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(numbers))]
    lines += ["%d %.12g %.12g %.12g" % (n, *p) for p, n in numbers.items()]
    lines += ["$EndNodes", "$Elements", str(len(cells))]
    kind = {2: 3, 3: 5}[dim]
    lines += [" ".join(map(str, [n + 1, kind, 2, 1, 1, *cell]))
              for n, cell in enumerate(cells)]
    path.write_text("\n".join(lines) + "\n$EndElements\n", encoding="utf-8")
    places = {n: p for p, n in numbers.items()}
    volumes = []
    for cell in cells:
        corners = [places[n] for n in cell]
        if is_at_crack(corners):
            volumes.append(extent(corners, dim))
    return (sum(volumes) / len(volumes))**(1. / dim)


def part(begin, end, h):
    n = max(1, round((end - begin) / h))
    return [begin + (end - begin) * i / n for i in range(n + 1)]


def growing(begin, end, h):
    """Each cell half as long again as the one before, up to 0.25."""
    places, size = [begin], h
    while places[-1] + 1.5 * size < end:
        places.append(places[-1] + size)
        size = min(1.5 * size, 0.25)
    return places + [end]


def is_at_crack(corners):
    x, y = (sum(c[d] for c in corners) / len(corners) for d in (0, 1))
    return abs(x) < 0.75 * HALF_BAND and NOTCH < y


def extent(corners, dim):
    result = 1.
    for d in range(dim):
        places = [corner[d] for corner in corners]
        result *= max(places) - min(places)
    return result


def measure(corners, dim):
    """Area of a triangle, volume of a tetrahedron."""
    a, b, c = ([p - q for p, q in zip(corner, corners[0])]
               for corner in [*corners[1:], [0., 0., 1.]][:3])
    if dim == 2:
        return abs(a[0] * b[1] - a[1] * b[0]) / 2
    return abs(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
               + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6


def read(path, kind):
    """Nodes and cells of a kind of Gmsh's, from a file of version 2.2."""
    lines = path.read_text(encoding="utf-8").split("\n")
    begin = lines.index("$Nodes") + 2
    nodes = {}
    for line in lines[begin:begin + int(lines[begin - 1])]:
        words = line.split()
        nodes[words[0]] = [float(word) for word in words[1:]]
    begin = lines.index("$Elements") + 2
    cells = []
    for line in lines[begin:begin + int(lines[begin - 1])]:
        words = line.split()
        if words[1] == kind:
            cells.append(words[3 + int(words[2]):])
    return nodes, cells
