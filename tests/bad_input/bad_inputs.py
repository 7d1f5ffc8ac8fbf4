# SPDX-License-Identifier: GPL-2.0-or-later
"""The bad inputs, as data for run_bad_inputs.py.

Each case is a dictionary:
  name       of the case
  change     [(old, new)]: replacements in BASE, the good parameter file
  file       the whole parameter file (bytes) instead of BASE; None: none
  set        values of --set
  arguments  the whole command line instead of "--set ... case.prm"
  files      {name: bytes} other files beside it
  folders    [name] folders beside it
  status     expected exit status (default 2)
  says       regular expressions that the message must contain, all of them
  leaves     names that may be left behind (default: nothing may be)
  at_once    whether all such cases may be tried in one run: their mistakes
             are reported together, one line each
  later      that it is found not when the case is read and checked but in the
             body, on the disk or in a step
"""

BASE = """\
subsection Geometry
  set Name = punctured strip
  subsection Punctured strip
    set Cell size = 3
  end
end
subsection Model
  set Length scale       = 2*h
  set Residual stiffness = 0.001
end
subsection Material
  set Lame lambda   = 10
  set Shear modulus = 2.4
  set Critical energy release rate = 17
end
subsection Boundary conditions
  set Displacement = top : all : 0 ; bottom : x : 0 ; bottom : y : -t
end
subsection Load stepping
  set End time      = 1
  set First step    = 0.5
  set Largest step  = 0.5
  set Onset step    = 0.05
  set Smallest step = 1e-3
  set Force boundary = top
end
subsection Output
  set Directory = results
end
"""

STRIP = "Geometry/Punctured strip/"
FINITE = "must be finite"
DISPLACEMENT_POINTS = "Boundary conditions/Displacement at points"
FORCES = "Boundary conditions/Force at points"
PHASE_FIELDS = "Boundary conditions/Phase field at points"


def entry(name, value, *says, **more):
    """A bad value of one entry; the message names it."""
    return dict(more, name="%s = %s" % (name, value),
                set=["%s=%s" % (name, value)], says=(name,) + says)


def later(case):
    """The same, found after the case has been read and checked."""
    return dict(case, later=True)


def value(name, text, *says):
    """The same for a mistake that is found when the file is read."""
    return entry(name, text, *says, at_once=True)


def several(name, pairs, *says, **more):
    """Values that do not go together."""
    return dict(more, name=name, set=["%s=%s" % pair for pair in pairs], says=says)


def line(name, change, *says):
    """A bad line in the file; the message says where."""
    return dict(name=name, change=[change], says=(r"case\.prm:\d+",) + says)


def conditions(text, *says, **more):
    return entry("Boundary conditions/Displacement", text, *says, **more)


def table(name, content, *says, status=4, **more):
    """A bad file of loads over time."""
    return dict(more, name="table: " + name, status=status, says=(
        "Boundary conditions/Displacement", "load.csv") + says,
        set=['Boundary conditions/Displacement=top : all : table("load.csv") ; bottom : y : 0'],
        files={} if content is None else {"load.csv": content})


def usage(name, arguments, *says, **more):
    return dict(more, name="command line: " + name, arguments=arguments, says=says)


def mesh(name, content, *says, **more):
    """A bad mesh file."""
    return dict(more, name="mesh file: " + name, set=[
        "Geometry/Name=mesh file", "Geometry/Mesh file/File name=bad.msh",
        "Geometry/Mesh file/Boundary names=1 = bottom ; 3 = top"],
        files={} if content is None else {"bad.msh": content},
        says=("Geometry/Mesh file/", "bad.msh") + says)


MAP = ["Material/Critical energy release rate=17*map",
       "Material/Map/File name=bad.map"]


def material_map(name, content, *says, **more):
    """A bad picture or table for the material."""
    return dict(more, name="map: " + name, set=MAP, says=("Material/",) + says,
                files={} if content is None else {"bad.map": content})


TRIANGLES = b"""$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
4
1 1 2 1 1 1 2
2 1 2 3 3 3 4
3 2 2 7 7 1 2 3
4 2 2 7 7 1 3 4
$EndElements
"""
SQUARE = b"""$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
3
1 1 2 1 1 1 2
2 1 2 3 3 3 4
3 3 2 7 7 1 2 3 4
$EndElements
"""

PARAMETER_FILE = [
    line("unknown entry", ("set Residual stiffness", "set Colour"),
         "unknown entry 'Colour' in Model", "Entries of Model: .*Formulation"),
    line("misspelt entry", ("set Length scale ", "set Lenght scale "),
         "unknown entry 'Lenght scale'", "did you mean 'Length scale'"),
    line("unknown subsection", ("subsection Material", "subsection Weather"),
         "unknown subsection 'Weather'", "Subsections of .*Material"),
    line("misspelt subsection", ("subsection Load stepping", "subsection Load steping"),
         "unknown subsection 'Load steping'", "did you mean 'Load stepping'"),
    line("entry in the wrong subsection", ("set Length scale ", "set Thickness "),
         "'Thickness' in Model", "belongs in Material"),
    line("missing end", ("  end\nend\nsubsection Model", "  end\nsubsection Model"),
         "'?end'?", "Geometry"),
    line("one end too many", ("subsection Model", "end\nsubsection Model"),
         "end"),
    line("malformed line", ("set Shear modulus = 2.4", "set Shear modulus 2.4"),
         "Shear modulus 2.4", "="),
    line("no statement", ("set Shear modulus = 2.4", "Shear modulus = 2.4"),
         "Shear modulus = 2.4", "set"),
    line("duplicate entry",
         ("set Shear modulus = 2.4", "set Shear modulus = 2.4\n set Shear modulus = 3"),
         "Shear modulus", "twice|already"),
    dict(name="missing file", file=None, status=4,
         says=("case.prm", "does not exist")),
    dict(name="a directory as file", file=None, folders=["case.prm"], status=4,
         says=("case.prm", "is a directory")),
    dict(name="empty file", file=b"", says=("case.prm", "is empty")),
    dict(name="blanks only", file=b"  \n\t\n", says=("case.prm", "is empty")),
    dict(name="binary garbage", file=bytes(range(256)) * 4,
         says=("case.prm", "not a text file")),
    dict(name="included device", file=b"include /dev/zero\n",
         says=("/dev/zero", "more than 8 MB")),
    dict(name="included file missing", file=b"include other.prm\n", status=4,
         says=(r"case\.prm:1", "other.prm", "does not exist")),
]

VALUES = [
    value("Material/Thickness", "thick", "found 'thick'", "a number"),
    value("Material/Thickness", "nan", "found 'nan'", "a number"),
    value("Material/Thickness", "inf", "found 'inf'", "a number"),
    value("Material/Thickness", "-2", "found '-2'"),
    value("Material/Thickness", "0", "found '0'"),
    value("Material/Thickness", "", "no value", "a number"),
    entry("Material/Critical energy release rate", "0", "found '0'"),
    value("Mesh/Global refinements", "1.5", "found '1.5'", "a whole number between 0 and"),
    value("Mesh/Global refinements", "-1", "found '-1'", "a whole number between 0 and"),
    value("Mesh/Global refinements", "40", "found '40'", "a whole number between 0 and"),
    value("Model/Crack density", "AT3", "'AT3'", "AT1", "AT2", "Wu"),
    value("Model/Formulation", "mixd", "'mixd'", "did you mean 'mixed'"),
    value("Linear solver/Name", "guess", "'guess'", "direct", "block AMG", "matrix-free",
          "auto"),
    value("Linear solver/Ordering", "METI", "'METI'", "did you mean 'METIS'"),
    value("Linear solver/Relative tolerance", "2", "found '2'"),
    value("Linear solver/Largest number of linear iterations", "0", "found '0'"),
    value("Linear solver/Tolerated growth of iterations", "-1", "found '-1'"),
    several("loose and tight tolerance swapped",
            [("Linear solver/Relative tolerance", "1e-3"),
             ("Linear solver/Loose relative tolerance", "1e-6")],
            "Linear solver/Loose relative tolerance: found 1e-06", "0.001"),
    entry("Output/Directory", "", "found nothing", "allowed"),
    value("Output/Fields every", "-3", "found '-3'", "a whole number, at least 0"),
]

MATERIAL = [
    several("no elastic constants",
            [("Material/Lame lambda", ""), ("Material/Shear modulus", "")],
            "Material: none", "exactly two", "Material/Poisson ratio"),
    several("one elastic constant", [("Material/Lame lambda", "")],
            "Material: 1 of", "Material/Shear modulus = 2.4", "exactly two"),
    several("three elastic constants", [("Material/Bulk modulus", "100")],
            "Material: 3 of", "Material/Bulk modulus = 100", "exactly two"),
    entry("Material/Shear modulus", "-2.4", "-2.4", "positive|greater than 0"),
    entry("Material/Shear modulus", "soft", "soft", "number"),
    entry("Material/Lame lambda", "0", "0", "positive|greater than 0"),
    entry("Material/Lame lambda", "-1", "-1", "positive|greater than 0"),
    several("Poisson ratio 0.5", [
        ("Material/Lame lambda", ""), ("Material/Shear modulus", ""),
        ("Material/Young's modulus", "7"), ("Material/Poisson ratio", "0.5")],
        "Material/Poisson ratio = 0.5", "smaller than 0.5"),
    several("Poisson ratio -0.2", [
        ("Material/Lame lambda", ""), ("Material/Shear modulus", ""),
        ("Material/Young's modulus", "7"), ("Material/Poisson ratio", "-0.2")],
        "Material/Poisson ratio = -0.2", "larger than 0"),
    entry("Material/Critical energy release rate", "17*q", "unknown name 'q'",
          "x, y, z, map"),
    # at points that one rank owns
    later(entry("Material/Critical energy release rate", "if(x > 19, 9 - x, 17)",
          "found '-1", r"Found at \(19", "greater than 0")),
    later(entry("Material/Lame lambda", "10*(19 - x)", "Material/Lame lambda = -",
          r"Found at \(19")),
    later(entry("Material/Lame lambda", "10/(x - x)", FINITE)),
    several("no map", [("Material/Shear modulus", "2.4*map")],
            "Material/Map/File name", "uses 'map'"),
    later(entry("Material/By material id", "3 : Shear modulus = 5", "material id 3",
          "not in the mesh", "which has 0")),
    entry("Material/By material id", "0 : Shear modulsu = 5", "'Shear modulsu'",
          "did you mean 'Shear modulus'"),
    entry("Material/By material id", "0 : Bulk modulus = 5", "3 elastic constants",
          "exactly two"),
    entry("Material/By material id", "0 : Shear modulus = -5",
          "Shear modulus = -5", "positive"),
    entry("Material/By material id", "0", "'0'", "id : name = value"),
    entry("Material/Map/File name", "map.pgm", "map.pgm", "no expression"),
    value("Material/Map/Interpolation", "cubic", "'cubic'", "nearest", "linear"),
    material_map("missing", None, "No such file|does not exist", status=4),
    dict(material_map("device", None), status=4,
         set=[MAP[0], "Material/Map/File name=/dev/zero"],
         says=("Material/Map/File name", "/dev/zero", "regular file")),
    later(material_map("empty", b"", "no numbers", status=4)),
    later(material_map("of another format", b"\x89PNG\r\n\x1a\n", "PGM", status=4)),
    later(material_map("cut off", b"P5 20 20 255\nabc", "last pixel", status=4)),
    later(material_map("ragged table", b"0,0,1\n1,0,1,5\n", "line 2", status=4)),
    later(material_map("table with a hole", b"0,0,1\n1,0,1\n0,1,1\n", "no grid", status=4)),
    later(material_map("too dark", b"P2 2 1 9 9 0", "found '0'", r"Found at \(1")),
    later(dict(material_map("corners of a table", b"0,0,1\n1,0,1\n"), set=MAP + [
        "Material/Map/Lower corner=0, 0"],
        says=("Material/Map/Lower corner", "bad.map", "own coordinates"))),
    later(dict(material_map("inside out", b"P2 2 1 9 9 9"), set=MAP + [
        "Material/Map/Lower corner=5, 5", "Material/Map/Upper corner=1, 9"],
        says=("Material/Map/Upper corner", r"\(1, 9\)", r"\(5, 5\)"))),
    later(dict(material_map("half a corner", b"P2 2 1 9 9 9"), set=MAP + [
        "Material/Map/Lower corner=5"],
        says=("Material/Map/Lower corner", "'5'", "two numbers"))),
]

GEOMETRY = [
    value("Geometry/Name", "sphere", "'sphere'", "rectangle", "slit square"),
    entry(STRIP + "Height", "0", "Height is 0", "greater than 0"),
    value(STRIP + "Width", "-20", "found '-20'", "at least 0"),
    entry(STRIP + "Cell size", "0", "Cell size is 0", "greater than 0"),
    entry(STRIP + "Cell size", "300", "300", "shortest side of 20"),
    entry(STRIP + "Cell size", "1e-6", "coarse cells", "at most"),
    several("notch too close to the hole",
            [(STRIP + "Notch length", "7.99"), (STRIP + "Notch height", "18")],
            STRIP + "Notch height is 18", "Notch length 7.99", "too close", "x <= 7.92"),
    several("notch through the hole",
            [(STRIP + "Notch length", "15"), (STRIP + "Notch height", "18")],
            STRIP + "Notch height is 18", "Notch length 15", "runs into the hole",
            r"radius 4 at \(12, 18\)"),
    entry(STRIP + "Notch length", "20", "20", "less than the width of 20"),
    entry(STRIP + "Notch height", "28", "28", "between 0 and the height of 28"),
    entry(STRIP + "Hole center", "40, 18", r"\(40, 18\)", "inside the strip of 20 x 28"),
    value(STRIP + "Hole center", "12", "found '12'", "2 values"),
    several("hole wider than the strip", [(STRIP + "Hole radius", "12")],
            STRIP + "Hole center", "radius 12", "inside the strip of 20 x 28"),
    several("rectangle inside out", [
        ("Geometry/Name", "rectangle"),
        ("Geometry/Rectangle/Upper corner", "-1, 1")],
        "Geometry/Rectangle/Upper corner", r"\(-1, 1\)", r"\(0, 0\)"),
    entry("Mesh/Refined boxes", "0,10 : 20,22", "'0,10 : 20,22'", "lower corner"),
    entry("Mesh/Refined boxes", "0,10 : 20 : 1", "'20'", "2 numbers"),
    entry("Mesh/Refined boxes", "20,22 : 0,10 : 1", "20,22 : 0,10 : 1", "greater"),
    entry("Mesh/Refined boxes", "0,10 : 20,22 : 1.5", "1.5", "integer"),
    entry("Mesh/Refined boxes", "0,10 : 20,22 : 99", "99", "no more than 12"),
    entry("Mesh/Refined boxes", "0,40 : 20,50 : 1", r"\(0, 40\) to \(20, 50\)",
          "outside the domain", r"\(0, 0\) and \(20, 28\)"),
    entry("Mesh/Refined discs", "12,18 : 5", "'12,18 : 5'", "centre : radius : levels"),
    entry("Mesh/Refined discs", "12 : 5 : 1", "'12'", "2 numbers"),
    entry("Mesh/Refined discs", "12,18 : -5 : 1", "'-5'", "greater than 0"),
    entry("Mesh/Refined discs", "40,18 : 5 : 1", r"\(40, 18\)", "outside the domain"),
    entry("Mesh/Refined surroundings", "hole : 1", "'hole : 1'", "name : distance : levels"),
    entry("Mesh/Refined surroundings", "hloe : 1 : 1", "'hloe'", "hole"),
    entry("Mesh/Refined surroundings", "notch tip : 0 : 1", "'0'", "greater than 0"),
    entry("Mesh/Refined surroundings", "notch tip : 1 : 13", "'13'", "no more than 12"),
    entry("Mesh/Adaptive levels", "2", "2", "Mesh/Adaptation"),
    entry("Initial cracks/Cracks", "0,5", "'0,5'", "x0,y0 : x1,y1"),
    entry("Initial cracks/Cracks", "0,5 : 1", "'1'", "2 numbers"),
    entry("Initial cracks/Cracks", "0,5 : one,5", "one", "number"),
    entry("Initial cracks/Discs", "0,5 : 1,0 : 1", "center : radius"),
    entry("Initial cracks/Discs", "0,5 : 0", "'0'", "greater than 0"),
    later(entry("Initial cracks/Half width", "-h", "'-h' = -", "negative")),
    entry("Initial cracks/Half width", "2*x", "unknown name 'x'"),
    entry("Initial cracks/Phase field", "if(x<1, 0", "cannot understand"),
    later(entry("Initial cracks/Phase field", "1/(x-x)", FINITE, leaves=("results",))),
    entry("Fluid/Pressure", "1e-3 MPa", "cannot understand", "'MPa'"),
    later(entry("Fluid/Pressure", "1/t", "gives infinity", FINITE, leaves=("results",))),
    entry("Output/Crack opening", "0,5 : 4,5", "begin : end : number"),
    entry("Output/Crack opening", "0,5 : 4,5 : many", "'many'", "number"),
    entry("Output/Crack opening", "0,5 : 0,5 : 3", "normal"),
    entry("Output/Crack opening reach", "0", "found '0'"),
    mesh("missing", None, "No such file|does not exist", status=4),
    dict(mesh("device", None), status=4, set=[
        "Geometry/Name=mesh file", "Geometry/Mesh file/File name=/dev/zero",
        "Geometry/Mesh file/Boundary names=1 = bottom ; 3 = top"],
         says=("Geometry/Mesh file/File name", "/dev/zero", "regular file")),
    mesh("empty", b"", "empty"),
    mesh("garbage", bytes(range(256)) * 9, "binary"),
    mesh("triangles", TRIANGLES, "triangles", "Geometry/Mesh file/Cut simplices = true"),
    value("Geometry/Mesh file/Cut simplices", "perhaps", "'perhaps'"),
    mesh("STL", b"solid part\nfacet normal 0 0 1\n", "an STL file"),
    mesh("STEP", b"ISO-10303-21;\nHEADER;\n", "a STEP file"),
    mesh("binary Gmsh file, cut off",
         b"$MeshFormat\n4.1 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Nodes\n\x07\0\0",
         "cut off or broken"),
    mesh("decimal commas", SQUARE.replace(b"2 1 0 0", b"2 1,5 0 0"), "not commas"),
    mesh("cut off", SQUARE[:150]),
    mesh("twisted cell", SQUARE.replace(b"7 7 1 2 3 4", b"7 7 1 3 2 4")),
    mesh("missing node", SQUARE.replace(b"7 7 1 2 3 4", b"7 7 1 2 3 9")),
    dict(mesh("boundary id it does not have", SQUARE.replace(b"1 1 2 1 1", b"1 1 2 2 2")),
         says=("Geometry/Mesh file/Boundary names", r"id 1 \(bottom\)", "ids 0, 2, 3")),
    dict(mesh("unknown boundary names", SQUARE), set=[
        "Geometry/Name=mesh file", "Geometry/Mesh file/File name=bad.msh",
        "Geometry/Mesh file/Boundary names=1 = south ; 3 = north"],
        says=("Boundary conditions/Displacement", "'top'", "north", "south")),
    later(dict(mesh("refined box beside it", SQUARE), set=[
        "Geometry/Name=mesh file", "Geometry/Mesh file/File name=bad.msh",
        "Geometry/Mesh file/Boundary names=1 = bottom ; 3 = top",
        "Mesh/Refined boxes=50,50 : 60,60 : 1"],
        says=("Mesh/Refined boxes", "50"))),
]

REGIONS = "Geometry/Boundary regions"
POINT_SETS = "Geometry/Point sets"
AT_POINTS = "Boundary conditions/Displacement at points"
BY_POSITION = [
    later(entry(REGIONS, "grip : x > 21", "'grip : x > 21'", "coarse mesh",
          r"nearest are \(20, ")),
    later(entry(REGIONS, "a : x < 0.1 ; b : x < 1", "'a : x < 0.1'", "later region")),
    entry(REGIONS, "top : x > 1", "'top'", "has already", "notch lower"),
    entry(REGIONS, "notch tip : x > 1", "'notch tip'", "has already"),
    entry(REGIONS, "grip", "'grip'", "name : condition"),
    entry(REGIONS, "grip : x < t", "'x < t'", "unknown name 't'"),
    entry(REGIONS, "grip : x <", "'x <'", "cannot understand"),
    entry(REGIONS, "grip : y > 1 ; grip : y > 2", "second condition", r"'\|\|'"),
    later(entry(REGIONS, "grip : 1/(x - 20)", FINITE, "infinity at x = 20")),
    several("an unknown region", [(REGIONS, "grip : x > 19"), (
        "Boundary conditions/Traction", "grap : x : 1")], "Traction", "'grap'",
            "did you mean 'grip'"),
    entry(POINT_SETS, "pin", "'pin'", "name : condition"),
    entry(POINT_SETS, "2nd : x < 1", "'2nd'", "begin with a letter"),
    later(several("a point set without points", [
        (POINT_SETS, "pin : x > 30"), (AT_POINTS, "pin : x : 0")],
            POINT_SETS, "'pin : x > 30'", r"nearest are \(20, ")),
    several("an unknown point set", [
        (POINT_SETS, "pin : x > 5"), (AT_POINTS, "bin : x : 0")],
            AT_POINTS, "'bin'", "which are pin"),
    entry(AT_POINTS, "pin : x : 0", "'pin'", "there are none"),
    entry(FORCES, "pin : x : 0", "'pin'", "there are none"),
    several("a force on an unknown point set", [
        (POINT_SETS, "pin : x > 5"), (FORCES, "bin : x : 1")],
            FORCES, "'bin'", "which are pin"),
    later(several("a force on a point set without points", [
        (POINT_SETS, "pin : x > 30"), (FORCES, "pin : x : 1")],
            POINT_SETS, "'pin : x > 30'", r"nearest are \(20, ")),
    several("two forces on a point set", [
        (POINT_SETS, "pin : x > 5"), (FORCES, "pin : x : 1 ; pin : all : 1")],
            FORCES, "'pin'", "a second entry"),
    later(several("a force on a point set that is not finite", [
        (POINT_SETS, "pin : x > 19.9"), (FORCES, "pin : y : 1/(y - 28)")],
            FORCES, FINITE)),
]

MODEL = [
    # the profile of the notch is computed before the first load step
    later(dict(entry("Model/Largest number of coupling iterations", "1"), status=3,
         leaves=["results"],
         says=("initial state", "did not settle within 1 iterations"))),
    entry("Model/Length scale", "0", "'0' is 0", "positive"),
    entry("Model/Length scale", "-0.3", "-0.3", "positive"),
    entry("Model/Length scale", "2*", r"'2\*'"),
    entry("Model/Length scale", "2*x", r"'2\*x'", "unknown name 'x'"),
    later(entry("Model/Length scale", "1/(h-h)", FINITE)),
    # good for h = 1, bad for the h of the mesh
    later(entry("Model/Length scale", "if(h > 1.2, -1, 1)", "-1", "positive")),
    entry("Model/Residual stiffness", "1", "'1' is 1", "below 1"),
    later(entry("Model/Residual stiffness", "-h", "'-h' is -", "from 0")),
    later(several("no residual stiffness for multigrid", [
        ("Model/Residual stiffness", "0"), ("Linear solver/Name", "block AMG")],
        "Linear solver/Name", "Model/Residual stiffness", "direct, auto",
        leaves=["results"])),
    later(several("no residual stiffness for multigrid without a matrix", [
        ("Model/Formulation", "mixed"),
        ("Model/Residual stiffness", "0"), ("Linear solver/Name", "matrix-free")],
        "found 'matrix-free'", "Model/Residual stiffness", "direct, auto",
        leaves=["results"])),
    several("no products for the displacement formulation",
            [("Model/Formulation", "displacement"), ("Linear solver/Name", "matrix-free")],
            "Linear solver/Name", "'matrix-free'", "Formulation = displacement",
            "block AMG"),
    several("no products with pressures that follow the boundary",
            [("Model/Formulation", "mixed"), ("Model/Strains", "finite"),
             ("Model/Kinematics", "plane strain"), ("Model/Energy split", "none"),
             ("Boundary conditions/Pressure", "right : 0.1*t"),
             ("Linear solver/Name", "matrix-free")],
            "Linear solver/Name", "'matrix-free'", "Boundary conditions/Pressure"),
    several("Q1 displacement in the mixed formulation",
            [("Model/Displacement degree", "1")],
            "Model/Displacement degree", "found 1", "mixed", "auto, 2"),
    several("deviator of dimension 3 in plane stress",
            [("Model/Deviator dimension", "3")],
            "Model/Deviator dimension", "found 3", "plane stress", "auto, 2"),
    entry("Load stepping/First step", "2", "2 s", "Load stepping/Largest step", "0.5 s"),
    entry("Load stepping/Onset step", "0.7", "0.7 s", "Load stepping/Largest step"),
    entry("Load stepping/Smallest step", "0.1", "0.1 s", "Load stepping/Onset step"),
    several("load steps that contradict each other", [
        ("Load stepping/First step", "2"), ("Load stepping/Onset step", "3"),
        ("Load stepping/Smallest step", "4")],
        "First step: 2 s is larger than Load stepping/Largest step, 0.5 s",
        "Onset step: 3 s is larger", "Smallest step: 4 s is larger .*Onset step, 3 s"),
    entry("Load stepping/Step schedule", "0 : 0.1, 0.5", "'0.5'", "time : step"),
    entry("Load stepping/Step schedule", "0 : 0.1, 0.5 : 0", "'0.5 : 0'", "above 0"),
    entry("Load stepping/Step schedule", "1 : 0.1, 0.5 : 0.2", "ascending"),
    entry("Load stepping/Step schedule", "0 : 2", "2 s is larger", "Largest step"),
    value("Load stepping/End time", "0", "found '0'"),
    entry("Load stepping/Stop when force falls below", "1", "1", "below 1"),
    value("Load stepping/Largest phase-field change", "1.5", "1.5", "between 0 and 1"),
    entry("Load stepping/Force boundary", "right", "'right'", "top", "bottom",
          "prescribed"),
    entry("Load stepping/Force boundary", "tpo", "'tpo'", "did you mean 'top'"),
]

CONDITIONS = [
    conditions("", "no displacement", "top"),
    conditions("lid : all : 0", "'lid'", "bottom, hole, left, notch, notch lower, notch upper, "
               "right, top"),
    conditions("top : w : 0", "'w'", "all"),
    conditions("top : z : 0", "'z'", "all"),
    conditions("top : all", "'top : all'", "boundary : component : expression"),
    conditions("top : all : 0 : 0", "boundary : component : expression"),
    conditions("top : all : 2*(t", r"'2\*\(t'"),
    conditions("top : all : 0,5", "decimals"),
    conditions("top : all : velocity*t", "unknown name 'velocity'", "x, y, z, t"),
    conditions("top : all : ", "empty|boundary : component : expression"),
    later(conditions("top : all : 0 ; bottom : all : 1/t", "1/t", FINITE, "t = 0")),
    # at one node, which one rank owns
    later(conditions("top : all : 0 ; bottom : y : 1/(x-20)", FINITE, "x = 20, y = 0")),
    later(conditions("top : all : 0 ; bottom : y : if(x > 19.9, 1/(t-0.5), -t)", FINITE,
               "x = 20, y = 0", "t = 0.5", leaves=["results"])),
    later(conditions("top : all : 0 ; right : phase field : 1/(t-0.5)", FINITE, "t = 0.5",
               leaves=["results"])),
    entry("Boundary conditions/Traction", "rigth : x : 1", "'rigth'",
          "did you mean 'right'"),
    entry("Boundary conditions/Traction", "right : phase field : 1", "'phase field'"),
    entry("Boundary conditions/Traction", "right : x : 1; right : x : 2",
          "a second entry", "'right'"),
    entry("Boundary conditions/Traction", "right : normals : 1", "'normals'",
          "did you mean 'normal'"),
    entry("Boundary conditions/Traction", "right : normal : 1; right : normal : 2",
          "a second entry", "'right'"),
    later(entry("Boundary conditions/Traction", "right : normal : log(y-3)", FINITE, "x = 20")),
    entry("Boundary conditions/Pressure", "rigth : 1", "'rigth'", "did you mean 'right'"),
    entry("Boundary conditions/Pressure", "right : normal : 1", "'right : normal : 1'",
          "boundary : expression"),
    entry("Boundary conditions/Pressure", "right : 1; right : 2", "a second entry",
          "'right'"),
    entry("Boundary conditions/Pressure", "right : p", "unknown name 'p'", "x, y, z, t"),
    later(entry("Boundary conditions/Pressure", "right : log(y-3)", FINITE, "x = 20")),
    conditions("top : rotation : t", "'rotation'", "'rotation about 0, 0'"),
    conditions("top : rotation about 1 : t", "'rotation about 1'", "2 numbers"),
    conditions("top : rotation about 1, a : t", "'a'", "a number"),
    conditions("top : rotation about 0, 0 axis 0, 1 : t", "'rotation about 0, 0'"),
    conditions("top : twist about 0, 0 : t", "'twist about 0, 0'", "rotation about"),
    conditions("top : rotation about 0, 0 : t ; top : y : 1", "a second entry", "'top'"),
    later(conditions("top : rotation about 0, 0 : 1/t", "1/t", FINITE, "t = 0")),
    entry("Output/Watched boundaries", "tpo", "'tpo'", "did you mean 'top'"),
    entry("Output/Watched boundaries", "top ; top", "'top' twice"),
    entry("Output/Watched boundaries", "top moment about 1", "'top moment about 1'",
          "point of 2 numbers"),
    entry("Output/Watched boundaries", "top moment about 1, y", "'y'", "a number"),
    entry("Output/Watched boundaries", "top moment", "'top moment'", "moment about"),
    entry("Output/Traction profiles", "tpo", "'tpo'", "did you mean 'top'"),
    entry("Output/Traction profiles", "top ; hole ; top", "'top' twice"),
    value("Output/Traction profiles every", "0", "found '0'", "at least 1"),
    entry("Boundary conditions/Body force", "x : 1; all : 2", "a second entry"),
    later(entry("Boundary conditions/Traction", "right : x : log(y-3)", FINITE, "x = 20")),
    entry("Boundary conditions/Body force", "x : 1 : 2", "component : expression"),
    later(entry("Boundary conditions/Body force", "y : sqrt(26-y)", FINITE, "y = 2[67]")),
    entry("Boundary conditions/Displacement at points", "0 : y : 0", "'0'",
          "point of 2 numbers"),
    entry("Boundary conditions/Displacement at points", "0, 0 : w : 0", "'w'"),
    later(entry("Boundary conditions/Displacement at points", "0.123, 0.1 : y : 0",
          "'0.123 0.1'", "no vertex", leaves=["results"])),
    later(conditions("top : y : t", "the body can move in x", leaves=["results"])),
    later(several("a body held in x only", [
        ("Boundary conditions/Displacement", "left : x : t"),
        ("Load stepping/Force boundary", "left")],
        "Boundary conditions/Displacement", "can move in y", leaves=["results"])),
    later(several("a body that turns about a point", [
        ("Boundary conditions/Displacement", ""), ("Load stepping/Force boundary", ""),
        ("Boundary conditions/Displacement at points", "0, 28 : all : 0")],
        r"can rotate about \(0, 28\)", leaves=["results"])),
    several("a force boundary where only points are held", [
        ("Boundary conditions/Displacement", ""),
        ("Boundary conditions/Displacement at points", "0, 28 : all : 0")],
        "Load stepping/Force boundary", "'top'", "points only"),
    later(entry("Boundary conditions/Displacement at points", "0, 28 : y : 1/t", FINITE,
          "y = 28")),
    entry("Output/Displacement at points", "10, 5", "'10, 5'", "name : point"),
    entry("Output/Displacement at points", "tip : 10", "'10'", "point of 2 numbers"),
    entry("Output/Displacement at points", "tip : 10, y", "'y'", "a number"),
    entry("Output/Displacement at points", "1st, tip : 10, 5", "'1st, tip'", "letter"),
    entry("Output/Displacement at points", "a tip : 10, 5 ; a_tip : 1, 5", "'a_tip' twice"),
    later(entry("Output/Displacement at points", "tip : 10, 5 ; far : 10, 29", "'far : 10 29'",
          "outside of the mesh", leaves=["results"])),
    later(entry("Output/Displacement at points", "in the hole : 13, 18",
          "'in the hole : 13 18'", "outside of the mesh", leaves=["results"])),
    value("Boundary conditions/Unbreakable margin", "-1", "found '-1'", "at least 0"),
    entry(DISPLACEMENT_POINTS, "0, 28 : y : 0 ; 0,28 : y : t", "twice"),
    entry(FORCES, "0 : y : 0", "'0'", "point of 2 numbers"),
    entry(FORCES, "0, 28 : phase field : 0", "'phase field'"),
    entry(FORCES, "0, 28 : 5", "component : expression"),
    entry(FORCES, "0, 28 : y : 1 ; 0.0, 28 : all : 1", "twice"),
    later(entry(FORCES, "0.123, 0.1 : y : 0", "'0.123 0.1'", "no vertex", "nearest is",
          leaves=["results"])),
    later(entry(FORCES, "0, 28 : y : 1/t", FINITE, "y = 28")),
    later(entry(FORCES, "0, 28 : y : 1/(t-0.5)", FINITE, "t = 0.5", leaves=["results"])),
    entry(PHASE_FIELDS, "0, 28", "point : value"),
    entry(PHASE_FIELDS, "0, 28 : y : 0", "point : value"),
    later(entry(PHASE_FIELDS, "0.123, 0.1 : 0", "'0.123 0.1'", "no vertex",
          leaves=["results"])),
    later(entry(PHASE_FIELDS, "0, 28 : 1.5", "gives 1.5", "within 0")),
    later(entry(PHASE_FIELDS, "0, 28 : 0.6 + t", r"gives 1\.[16]", "within 0",
          leaves=["results"])),
    conditions("top : all : t ; bottom : x : symmetry", "'symmetry'"),
    later(conditions("top : all : t ; bottom : symmetry ; bottom : y : 0", "the same component",
               leaves=["results"])),
    later(conditions("top : all : t ; hole : symmetry", "'hole'", "a normal such as",
               leaves=["results"])),
    table("missing", None, "cannot read", "load.csv"),
    table("no numbers", b"time,force\n", "no row"),
    table("text", b"0,0\n1,one\n", "line 2 '1,one'"),
    table("decimal commas", b"t;u\n0,5;1,5\n1,5;2,5\n", "line 2", "decimals take a point"),
    table("times that fall", b"0,0\n1,1\n0.5,2\n", "line 3", "increase"),
    table("it ends too early", b"0,0\n0.5,1\n", "ends at t = 0.5", "End time = 1", status=2),
    conditions("top : all : table(load.csv)", "quotation marks"),
    conditions('top : all : table("load.csv", 2)', "quotation marks"),
]

RUN = {"results/statistics.csv": b"step\n0\n", "results/log.txt": b"log\n",
       "results/parameters.prm": b"\n"}

OUTPUT = [
    later(dict(name="output below a file", set=["Output/Directory=case.prm/results"],
         status=4, says=("Output/Directory", "case.prm/results"))),
    later(dict(name="new folders of a refused run", set=[
        "Output/Directory=a/b/c", "Boundary conditions/Displacement=top : all : 1/t"],
        says=("Boundary conditions/Displacement", FINITE))),
    later(dict(name="output is a file", set=["Output/Directory=case.prm"],
         status=4, says=("Output/Directory", "'case.prm'", "is a file", "directory"))),
    value("Output/Field format", "HDF", "'HDF'", "VTU", "XDMF", "both", "none"),
    later(dict(name="output cannot be made", set=["Output/Directory=/proc/results"],
         status=4, says=("Output/Directory", "/proc/results"))),
    later(dict(name="files cannot be written", set=["Output/Directory=/proc/self"],
         status=4, says=("Output/Directory", "/proc/self", "written"))),
    later(dict(name="existing results", files=RUN, status=4,
         says=("Output/Directory", "'results'", "already holds a run", "--overwrite"))),
    later(usage("--resume without a run", ["--resume", "case.prm"], "--resume", "results",
          "no whole checkpoint", status=4)),
    later(usage("--resume without a checkpoint", ["--resume", "case.prm"],
          "--resume", "results", "no whole checkpoint", files=RUN, status=4)),
    later(usage("--resume with a broken checkpoint", ["--resume", "case.prm"],
          "--resume", "results", "no whole checkpoint", status=4, files=dict(RUN, **{
              "results/checkpoint/generation-0/seal.txt": b"3\nmesh 12\n",
              "results/checkpoint/generation-1/seal.txt": b"\x00\xff"}))),
    later(usage("--output below a file", ["--output", "case.prm/x", "case.prm"],
          "Output/Directory", "case.prm/x", status=4)),
    usage("--overwrite with a bad mesh", [
        "--overwrite", "--set", "Geometry/Name=mesh file", "--set",
        "Geometry/Mesh file/File name=no.msh", "--set",
        "Geometry/Mesh file/Boundary names=1 = bottom ; 3 = top", "case.prm"],
        "no.msh", files=RUN, status=4),
]

COMMAND_LINE = [
    usage("nothing", [], "no parameter file", "Usage"),
    usage("unknown option", ["--chekc", "case.prm"], "'--chekc'",
          "did you mean '--check'"),
    usage("single dash", ["-x", "case.prm"], "'-x'", "--check"),
    usage("two files", ["case.prm", "other.prm"], "two parameter files", "other.prm"),
    usage("empty argument", ["", "case.prm"], "an argument is empty"),
    usage("--set without a value", ["case.prm", "--set"], "--set", "needs a value"),
    usage("--set without =", ["--set", "Material/Thickness", "case.prm"],
          "Material/Thickness", "Entry=value"),
    usage("--set without a name", ["--set", "=3", "case.prm"], "'=3'", "Entry=value"),
    usage("--set of an unknown entry", ["--set", "Material/Thicknes=3", "case.prm"],
          "'Thicknes'", "did you mean 'Thickness'"),
    usage("--set of an unknown subsection", ["--set", "Materail/Thickness=3", "case.prm"],
          "'Materail'", "did you mean 'Material'|belongs in"),
    usage("--set without subsection", ["--set", "Thickness=3", "case.prm"],
          "'Thickness'", "belongs in Material"),
    usage("--set with a bad value", ["--set", "Material/Thickness=x", "case.prm"],
          "--set", "Material/Thickness", "found 'x'", "a number"),
    usage("--set twice", ["--set", "Material/Thickness=1", "--set",
                          "Material/Thickness=2", "case.prm"],
          "Material/Thickness", "twice"),
    usage("--output without a value", ["case.prm", "--output"], "--output",
          "needs a value"),
    usage("--parameters nonsense", ["--parameters", "nonsense"], "--parameters",
          "'nonsense'", "prm", "json", "markdown"),
    usage("--check with a value", ["--check=yes", "case.prm"], "--check",
          "takes no value", "'yes'"),
    usage("--resume with --overwrite", ["--resume", "--overwrite", "case.prm"],
          "--resume", "--overwrite", "exclude"),
]

CASES = (PARAMETER_FILE + VALUES + MATERIAL + GEOMETRY + BY_POSITION + MODEL + CONDITIONS
         + OUTPUT + COMMAND_LINE)
