#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A notched beam breaks at the same load on triangles or tetrahedra that were cut as
on quadrilaterals or hexahedra of the same mean size at the crack: within 3 %. Without
Gmsh, which makes the simplices, the test is skipped.

usage: test_cut_beam.py EXECUTABLE RANKS MPIRUN
       test_cut_beam.py EXECUTABLE RANKS MPIRUN --compare DIM H LENGTH

H: wanted size of cells at the crack, LENGTH: l of the phase field, mm. The second
form only prints what it finds (doc/your_own_mesh.md).
"""

import pathlib
import shutil
import sys
import tempfile
import unittest

TESTS = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(TESTS))
import beam  # noqa: E402
import program  # noqa: E402

EXECUTABLE, RANKS = sys.argv[1], sys.argv[2]
MPIRUN = [word for word in sys.argv[3:4] if word != "--compare"]
SKIPPED = 77
CASE = """
subsection Geometry
  set Dimension = {dim}
  set Name = mesh file
  set Point sets = left : x < -1.499 && y < 1e-6 ; right : x > 1.499 && y < 1e-6 ; \
load : abs(x) < 1e-6 && y > 0.999
  subsection Mesh file
    set File name = {file}
    set Cut simplices = {cut}
  end
end
subsection Model
  set Formulation = displacement
  set Kinematics = plane strain
  set Crack density = AT1
  set Energy split = none
  set Length scale = {length}
end
subsection Material
  set Young's modulus = 1000
  set Poisson ratio = 0.2
  set Critical energy release rate = 0.01
  set Thickness = 0.3
end
subsection Boundary conditions
  set Displacement at points = left : y : 0 ; right : y : 0 ; load : y : -t ; {held}
  set Unbreakable margin = 0.2
end
subsection Load stepping
  set End time = 0.05
  set Largest step = 1e-3
  set Onset step = 4e-5
  set Stop when force falls below = 0.9
end
subsection Linear solver
  set Name = auto
end
"""
HELD = {2: "load : x : 0", 3: "load : x : 0 ; 0, 1, 0 : z : 0 ; -1.5, 0, 0 : z : 0"}


def peak(folder, mesh, dim, length):
    case = folder / (mesh.stem + ".prm")
    cut = "true" if mesh.stem == "simplices" else "false"
    case.write_text(CASE.format(dim=dim, file=mesh, length=length, cut=cut,
                                held=HELD[dim]), encoding="utf-8")
    program.output_of(
        [*program.command(EXECUTABLE, MPIRUN, RANKS), str(case), "--output",
         str(folder / mesh.stem), "--set", "Output/Field format=none"], timeout=7200)
    rows = program.rows(folder / mesh.stem)
    forces = [abs(float(row["force_y_N"])) for row in rows]
    assert forces[-1] < 0.91 * max(forces), forces  # it has broken
    return max(forces), float(rows[-1]["wall_time_s"])


def compare(dim, h, length):
    """What both meshes give: size of cells at the crack, peak, time."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        simplices, bricks = folder / "simplices.msh", folder / "bricks.msh"
        brick_h = beam.write_bricks(bricks, dim, h)
        cut_h = beam.write_simplices(simplices, dim, brick_h)
        return [(cut_h, *peak(folder, simplices, dim, length)),
                (brick_h, *peak(folder, bricks, dim, length))]


class CutBeam(unittest.TestCase):
    def expect_same(self, dim, h, length):
        cut, whole = compare(dim, h, length)
        self.assertAlmostEqual(cut[0] / whole[0], 1., delta=0.03)
        self.assertAlmostEqual(cut[1] / whole[1], 1., delta=0.03)

    def test_triangles(self):
        self.expect_same(2, 0.025, 0.1)

    def test_tetrahedra(self):
        self.expect_same(3, 0.05, 0.1)


def main():
    if shutil.which("gmsh") is None:
        print("skipped: there is no gmsh, which makes the mesh files (Debian's "
              "package gmsh)")
        sys.exit(SKIPPED)
    if "--compare" not in sys.argv:
        unittest.main(argv=sys.argv[:1])
    dim, h, length = sys.argv[sys.argv.index("--compare") + 1:]
    for name, found in zip(("cut simplices", "not cut"),
                           compare(int(dim), float(h), float(length))):
        print("%-14s h = %.4f mm, peak %.5g N, %.0f s" % (name, *found))


if __name__ == "__main__":
    main()
