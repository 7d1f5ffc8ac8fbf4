#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Mesh files as Gmsh writes them, in all its formats and options, and damaged
ones: each is read, with as many cells as it has, or refused with one message
and exit status 2 or 4.

Cells are counted in the ASCII file of version 2.2 that Gmsh makes of the same
mesh, not by the program. Without Gmsh the test is skipped.

usage: test_mesh_files.py EXECUTABLE MESH_READER
"""

import collections
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

EXECUTABLE, READER = sys.argv[1:3]
SKIPPED = 77

SQUARE = """
Point(1)={0,0,0,.4}; Point(2)={2,0,0,.4}; Point(3)={2,1,0,.4}; Point(4)={0,1,0,.4};
Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,4}; Line(4)={4,1};
Curve Loop(1)={1:4}; Plane Surface(1)={1};
"""
NAMES_2D = """
Physical Curve("bottom",1)={1}; Physical Curve("top",3)={3};
Physical Surface("body",7)={1};
"""
NAMES_3D = """
Physical Volume("body",7)={e[1]}; Physical Surface("bottom",1)={e[2]};
Physical Surface("top",3)={e[4]};
"""
EXTRUDED = "e[] = Extrude{0,0,.5}{Surface{1}; Layers{2}; Recombine;};\n"
RECOMBINED = "Transfinite Surface{1}; Recombine Surface{1};\n"

# name: dimension, script, what is at each place of Gmsh's types of first order
MESHES = {
    "quadrilaterals": (2, SQUARE + RECOMBINED + NAMES_2D),
    "triangles": (2, SQUARE + NAMES_2D),
    "hexahedra": (3, SQUARE + RECOMBINED + EXTRUDED + NAMES_3D),
    "tetrahedra": (3, SQUARE + "e[] = Extrude{0,0,.5}{Surface{1};};\n" + NAMES_3D),
    "prisms": (3, SQUARE + EXTRUDED + NAMES_3D),
}
CORNERS = {"3": 4, "2": 3, "5": 8, "4": 4, "6": 6}  # Gmsh's types
CELLS = {2: {"2", "3"}, 3: {"4", "5", "6"}}

# name of the file: options of Gmsh, before it is saved
FORMATS = {
    "v22.msh": "Mesh.MshFileVersion=2.2;",
    "v22_binary.msh": "Mesh.MshFileVersion=2.2; Mesh.Binary=1;",
    "v22_parametric.msh": "Mesh.MshFileVersion=2.2; Mesh.SaveParametric=1;",
    "v22_binary_parametric.msh":
        "Mesh.MshFileVersion=2.2; Mesh.Binary=1; Mesh.SaveParametric=1;",
    "v40.msh": "Mesh.MshFileVersion=4.0;",
    "v41.msh": "",
    "v41_binary.msh": "Mesh.Binary=1;",
    "v41_parametric.msh": "Mesh.SaveParametric=1;",
    "v41_binary_parametric.msh": "Mesh.Binary=1; Mesh.SaveParametric=1;",
    "all.msh": "Mesh.SaveAll=1;",
    "all_binary.msh": "Mesh.SaveAll=1; Mesh.Binary=1;",
    "gmsh.inp": "",
    "gmsh.vtk": "",
}
SECOND_ORDER = {
    "second_v22.msh": "Mesh.MshFileVersion=2.2;",
    "second_v22_binary.msh": "Mesh.MshFileVersion=2.2; Mesh.Binary=1;",
    "second_v41.msh": "",
    "second_v41_binary.msh": "Mesh.Binary=1;",
    "second.inp": "",
    "second.vtk": "",
}
# what is refused, and a word of the reason
REFUSED = {
    "v1.msh": ("Mesh.MshFileVersion=1;", "version 1"),
    "v3.msh": ("Mesh.MshFileVersion=3;", "versions 2, 4.0 and 4.1"),
    "v3_binary.msh": ("Mesh.MshFileVersion=3; Mesh.Binary=1;", "2 and 4.1"),
    "binary.vtk": ("Mesh.Binary=1;", "binary VTK"),
    "x.unv": ("", "I-deas"),
    "x.stl": ("", "STL"),
    "binary.stl": ("Mesh.Binary=1;", "STL"),
    "x.bdf": ("", "Nastran"),
    "x.mesh": ("", "Medit"),
    "x.key": ("", "LS-DYNA"),
    "x.su2": ("", "SU2"),
    "x.diff": ("", "Diffpack"),
    "x.wrl": ("", "VRML"),
    "x.x3d": ("", "XML"),
    "x.m": ("", "Matlab"),
    "x.ir3": ("", "neither"),
    "x.mail": ("", "neither"),
    "x.ply2": ("", "neither"),
}
DEFAULTS = ("Mesh.MshFileVersion=4.1; Mesh.Binary=0; Mesh.SaveParametric=0; "
            "Mesh.SaveAll=0; Mesh.SaveGroupsOfNodes=0;")

CASE = """
subsection Geometry
  set Dimension = {dim}
  set Name = mesh file
  subsection Mesh file
    set File name = {file}
    set Boundary names = {names}
    set Cut simplices = {cut}
  end
end
subsection Material
  set Young's modulus = 210000
  set Poisson ratio = 0.3
  set Critical energy release rate = 2.7
end
subsection Boundary conditions
  set Displacement = bottom : all : 0 ; top : y : 1e-5*t
end
"""


def write_meshes(folder):
    """All files of all meshes, one run of Gmsh for each mesh."""
    for name, (dim, script) in MESHES.items():
        place = folder / name
        place.mkdir()
        saves = [f"{DEFAULTS} {options} Save \"{file}\";"
                 for file, options in FORMATS.items()]
        if name == "triangles":
            saves += [f"{DEFAULTS} {options} Save \"{file}\";"
                      for file, (options, _) in REFUSED.items()]
        saves += ["SetOrder 2;"] + [f"{DEFAULTS} {options} Save \"{file}\";"
                                    for file, options in SECOND_ORDER.items()]
        text = script + f"Mesh {dim};\n" + "\n".join(saves) + "\n"
        (place / "mesh.geo").write_text(text, encoding="utf-8")
        subprocess.run(["gmsh", "-v", "1", "-", "mesh.geo"], cwd=place, check=True,
                       stdout=subprocess.DEVNULL, timeout=120)


def count_by_type(path):
    """Elements of an ASCII file of version 2.2 by Gmsh's type."""
    section = path.read_text(encoding="utf-8").split("$Elements\n")[1].split("\n")
    return collections.Counter(line.split()[1]
                               for line in section[1:1 + int(section[0])])


def cells_when_read(path, dim):
    """How many cells are to come out: one for each corner, where there is one that
    is no quadrilateral or hexahedron."""
    numbers = {kind: n for kind, n in count_by_type(path).items()
               if kind in CELLS[dim]}
    if set(numbers) <= {"3", "5"}:
        return sum(numbers.values())
    return sum(n * CORNERS[kind] for kind, n in numbers.items())


def names_in(path):
    return "bottom = bottom ; top = top" if path.suffix == ".inp" \
        else "1 = bottom ; 3 = top"


def ask_program(path, dim, cut="true"):
    """Exit status and what is said."""
    case = path.with_suffix(path.suffix + ".prm")
    case.write_text(CASE.format(dim=dim, file=path.name, names=names_in(path),
                                cut=cut),
                    encoding="utf-8")
    status, out, err = program.runner(EXECUTABLE, "", 1).run(["--check", str(case)])
    return status, out + err


class MeshFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        write_meshes(cls.folder)
        cls.reader = subprocess.Popen([READER], env=program.environment(), text=True,
                                      errors="replace", stdin=subprocess.PIPE,
                                      stdout=subprocess.PIPE)

    @classmethod
    def tearDownClass(cls):
        cls.reader.communicate()
        cls.scratch.cleanup()

    def check(self, path, dim, cut="true"):
        """The same as ask_program(), of a process that has been started once."""
        self.reader.stdin.write("%d\t%s\t%s\t%s\n" % (dim, cut, names_in(path), path))
        self.reader.stdin.flush()
        status, _, text = self.reader.stdout.readline().partition("\t")
        self.assertTrue(status, "the reader has died of " + str(path))
        return int(status), text.replace("\v", "\n")

    def expect_refusal(self, result, about, *words):
        status, text = result
        self.assertIn(status, (2, 4), (about, text))
        lines = text.strip().split("\n")
        self.assertEqual(len(lines), 1, (about, text))
        self.assertTrue(lines[0].startswith("mixed-cracks: error: "), (about, text))
        for word in words:
            self.assertIn(word, text, about)

    def expect_cells(self, result, n_cells, about):
        status, text = result
        self.assertEqual(status, 0, (about, text))
        found = re.search(r"mesh of the file: (\d+) cells", text)
        self.assertEqual(int(found.group(1)), n_cells, (about, text))

    def test_formats_and_options(self):
        for name, (dim, _) in MESHES.items():
            place = self.folder / name
            n_cells = cells_when_read(place / "v22.msh", dim)
            for file in {**FORMATS, **SECOND_ORDER}:
                with self.subTest(mesh=name, file=file):
                    self.expect_cells(self.check(place / file, dim), n_cells, file)
            for file in ("v22.msh", "v41_binary.msh", "gmsh.inp"):
                self.expect_cells(ask_program(place / file, dim), n_cells, file)

    def test_second_order_is_said(self):
        _, text = ask_program(self.folder / "quadrilaterals" / "second_v41.msh", 2)
        self.assertIn("cells of second order the corners", text)

    def test_simplices_are_refused_without_the_entry(self):
        for name, dim in (("triangles", 2), ("tetrahedra", 3), ("prisms", 3)):
            for file in ("v22.msh", "v41_binary.msh", "gmsh.inp", "gmsh.vtk"):
                with self.subTest(mesh=name, file=file):
                    self.expect_refusal(
                        self.check(self.folder / name / file, dim, "false"), file,
                        name, "Geometry/Mesh file/Cut simplices = true")

    def test_other_dimension(self):
        self.expect_refusal(self.check(self.folder / "tetrahedra" / "v41.msh", 2), "",
                            "Geometry/Dimension")
        self.expect_refusal(self.check(self.folder / "triangles" / "v41.msh", 3), "",
                            "Geometry/Dimension")

    def test_other_formats_are_refused_by_name(self):
        for file, (_, word) in REFUSED.items():
            path = self.folder / "triangles" / file
            with self.subTest(file=file):
                self.assertGreater(path.stat().st_size, 0)
                self.expect_refusal(self.check(path, 2), file, word)
        self.expect_refusal(self.check(self.folder / "triangles" / "mesh.geo", 2), "",
                            "script of Gmsh")

    def changed(self, source, name, change):
        path = source.with_name(name + "_" + source.name)
        path.write_bytes(change(source.read_bytes()))
        return path

    def test_line_ends_and_byte_order_marks(self):
        changes = {
            "mark": lambda text: b"\xef\xbb\xbf" + text,
            "windows": lambda text: text.replace(b"\n", b"\r\n"),
            "old": lambda text: text.replace(b"\n", b"\r"),
            "blanks": lambda text: text.replace(b"\n", b"  \n\n"),
        }
        place = self.folder / "quadrilaterals"
        n_cells = cells_when_read(place / "v22.msh", 2)
        for file in ("v22.msh", "v41.msh", "gmsh.inp", "gmsh.vtk"):
            for name, change in changes.items():
                with self.subTest(file=file, change=name):
                    path = self.changed(place / file, name, change)
                    self.expect_cells(self.check(path, 2), n_cells, path)

    def test_decimal_commas_are_named(self):
        def with_commas(text):
            return re.sub(rb"(\d)\.(\d{3})", rb"\1,\2", text)
        for file in ("v22.msh", "v41.msh", "gmsh.inp", "gmsh.vtk"):
            path = self.changed(self.folder / "quadrilaterals" / file, "comma",
                                with_commas)
            with self.subTest(file=file):
                self.expect_refusal(self.check(path, 2), path, "commas")

    def test_damage(self):
        """Cut off, or with other bytes: no trace, no signal, no more than one
        message."""
        for mesh, dim in (("triangles", 2), ("hexahedra", 3)):
            for file in ("v22.msh", "v22_binary.msh", "v41.msh", "v41_binary.msh",
                         "gmsh.inp", "gmsh.vtk"):
                for seed in range(4):
                    with self.subTest(mesh=mesh, file=file, seed=seed):
                        self.damage(self.folder / mesh / file, dim, seed)

    def damage(self, source, dim, seed):
        dice = random.Random(f"{source.name} {seed}")
        data = bytearray(source.read_bytes())
        if seed % 2 == 0:
            del data[dice.randrange(len(data)):]
        else:
            for _ in range(3):
                data[dice.randrange(len(data))] = dice.randrange(256)
        path = self.changed(source, f"damaged{seed}", lambda _: bytes(data))
        result = self.check(path, dim)
        if result[0] != 0:
            self.expect_refusal(result, path)


if __name__ == "__main__":
    if shutil.which("gmsh") is None:
        print("skipped: there is no gmsh, which makes the mesh files (Debian's "
              "package gmsh)")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1])
