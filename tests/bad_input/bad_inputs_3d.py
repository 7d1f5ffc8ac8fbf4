# SPDX-License-Identifier: GPL-2.0-or-later
"""Bad inputs about the dimension and in 3-d, as in bad_inputs.py."""
from bad_inputs import SQUARE, TRIANGLES, entry, later, several, value

IN_3D = ("Geometry/Dimension", "3")
HELD = {"Boundary conditions/Displacement": "top : all : 0 ; bottom : all : t"}


def box(name, pairs, *says, **more):
    """Values of a box in 3-d that do not go together."""
    settings = list(dict(HELD, **dict(pairs)).items())
    return several("in 3-d: " + name,
                   [IN_3D, ("Geometry/Name", "box")] + settings, *says, **more)


CUBE = b"""$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
8
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
$EndNodes
$Elements
3
1 3 2 1 1 1 2 6 5
2 3 2 3 3 3 4 8 7
3 5 2 7 7 1 2 3 4 5 6 7 8
$EndElements
"""


def mesh(name, content, *says, more=(), names_file=True):
    """A bad mesh file in 3-d."""
    return dict(name="mesh file in 3-d: " + name, files={"bad.msh": content}, set=[
        "Geometry/Dimension=3", "Geometry/Name=mesh file",
        "Geometry/Mesh file/File name=bad.msh",
        "Geometry/Mesh file/Boundary names=1 = bottom ; 3 = top"] + list(more),
        says=("Geometry/Mesh file/",) + (("bad.msh",) if names_file else ()) + says)


CASES = [
    value("Geometry/Dimension", "4", "'4'", "2", "3"),
    value("Geometry/Dimension", "", "no value"),
    entry("Geometry/Name", "box", "'box'", "in 3-d only", "Geometry/Dimension = 2",
          "slit square, rectangle"),
    entry("Geometry/Name", "slit cube", "'slit cube'", "in 3-d only"),
    several("rectangle in 3-d", [IN_3D, ("Geometry/Name", "rectangle")],
            "Geometry/Name", "'rectangle'", "in 2-d only", "slit cube, box"),
    mesh("of the plane", SQUARE, "Geometry/Dimension is 3", "quadrilaterals"),
    mesh("triangles", TRIANGLES, "no hexahedra", "Geometry/Dimension is 3"),
    mesh("tetrahedra", CUBE.replace(b"3 5 2 7 7 1 2 3 4 5 6 7 8", b"3 4 2 7 7 1 2 3 7"),
         "tetrahedra", "Geometry/Mesh file/Cut simplices = true"),
    mesh("pyramids", CUBE.replace(b"3 5 2 7 7 1 2 3 4 5 6 7 8", b"3 7 2 7 7 1 2 3 4 7"),
         "pyramids", "cannot be cut",
         more=("Geometry/Mesh file/Cut simplices=true",)),
    mesh("cut off", CUBE[:180]),
    mesh("twisted cell", CUBE.replace(b"1 2 3 4 5 6 7 8", b"1 3 2 4 5 6 7 8"),
         "degenerate or twisted"),
    mesh("missing node", CUBE.replace(b"1 2 3 4 5 6 7 8", b"1 2 3 4 5 6 7 9"),
         "does not list"),
    mesh("a circle in the plane of a line", CUBE, "cylinder", "sphere",
         more=["Geometry/Mesh file/Circles=bottom : 0 : 1"], names_file=False),
    several("a mesh of hexahedra in 2-d", [
        ("Geometry/Name", "mesh file"), ("Geometry/Mesh file/File name", "bad.msh"),
        ("Geometry/Mesh file/Boundary names", "1 = bottom ; 3 = top")],
        "Geometry/Mesh file/File name", "Geometry/Dimension is 2", "hexahedra",
        files={"bad.msh": CUBE}),
    several("a strip of many cells", [
        IN_3D, ("Geometry/Punctured strip/Thickness cells", "1000000")],
        "Punctured strip/Thickness cells", "1000000", "at most"),
    value("Geometry/Punctured strip/Thickness cells", "0", "found '0'"),
    box("two coordinates", [("Geometry/Box/Upper corner", "1, 1")],
        "Geometry/Box/Upper corner", "'1, 1'"),
    box("inside out", [("Geometry/Box/Upper corner", "1, 1, -1")],
        "Geometry/Box/Upper corner", r"\(1, 1, -1\)"),
    box("two numbers of cells", [("Geometry/Box/Cells", "2, 2")],
        "Geometry/Box/Cells", "'2, 2'", "3 numbers"),
    box("half a cell", [("Geometry/Box/Cells", "2, 2, 0.5")],
        "Geometry/Box/Cells", "0.5", "integers"),
    box("words for cells", [("Geometry/Box/Cells", "2, 2, two")],
        "Geometry/Box/Cells", "two"),
    box("a flat refined box", [("Mesh/Refined boxes", "0,0 : 1,1 : 1")],
        "Mesh/Refined boxes", "point of 3 numbers"),
    box("a refined box outside", [("Mesh/Refined boxes", "0,0,2 : 1,1,3 : 1")],
        "Mesh/Refined boxes", "outside the domain", r"\(1, 1, 1\)"),
    box("no boundary of that name", [
        ("Boundary conditions/Displacement", "hind : all : 0")],
        "'hind'", "back, bottom, front, left, right, top"),
    box("no component of that name", [
        ("Boundary conditions/Displacement", "top : w : 0")],
        "'w'", "x, y, z"),
    box("a rotation without an axis", [
        ("Boundary conditions/Displacement", "top : rotation about 0, 0, 0 : t")],
        "'rotation about 0, 0, 0'", "axis 0, 0, 1"),
    box("a rotation about no axis", [
        ("Boundary conditions/Displacement",
         "top : rotation about 0, 0, 0 axis 0, 0, 0 : t")], "length 0"),
    box("a twist about a slanting axis", [
        ("Boundary conditions/Displacement",
         "top : twist about 0, 0, 0 axis 0, 1, 1 : t")], "twist", "along x, y or z"),
    box("a moment about a point of the plane", [
        ("Output/Watched boundaries", "top moment about 0, 0")],
        "Output/Watched boundaries", "point of 3 numbers"),
    box("events of the plane", [("Output/Events", "onset, crack length")],
        "Output/Events", "'crack length' with Geometry/Dimension = 3",
        "'none', 'all', or a list of: onset, crack area, boundary, separation"),
    several("events of space in the plane", [("Output/Events", "crack area")],
            "Output/Events", "'crack area' with Geometry/Dimension = 2",
            "'none', 'all', or a list of: onset, crack length, boundary, separation"),
    box("all events and one more", [("Output/Events", "all, crack area")],
        "Output/Events", "'all' alone", "onset, crack area, boundary, separation"),
    value("Output/Event crack area", "-1", "found '-1'", "at least 0"),
    box("events at every growth", [("Output/Event crack area", "0")],
        "Output/Event crack area", "found 0", "above 0"),
    # at one node, which one rank owns
    later(box("an expression that fails", [
        ("Boundary conditions/Displacement", "top : all : 0 ; bottom : z : 1/(z-1)")],
        "must be finite", "z = 1")),
]
