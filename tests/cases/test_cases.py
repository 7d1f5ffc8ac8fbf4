#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Set-ups that went wrong without a word: slits of mesh files, slits that
close, cracks that close with a tiny residual stiffness, dead loads.

usage: test_cases.py EXECUTABLE RANKS MPIRUN
"""

import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

EXECUTABLE, RANKS, MPIRUN = sys.argv[1], int(sys.argv[2]), sys.argv[3]

COMMON = """
subsection Model
  set Formulation = displacement
  set Kinematics = plane strain
  set Crack density = AT2
  set Energy split = spectral
  set Pressure law = degraded bulk
  set Length scale = 0.5
  set Residual stiffness = 1e-6
end
subsection Material
  set Young's modulus = 210000
  set Poisson ratio = 0.3
  set Critical energy release rate = 2.7
end
subsection Load stepping
  set End time = 1
  set First step = 1
  set Largest step = 1
  set Onset step = 0.6
  set Smallest step = 0.6
  set Force boundary = top
end
subsection Boundary conditions
  set Displacement = bottom : y : 0 ; top : y : 1e-4*t
  set Displacement at points = 0, 0 : x : 0
end
subsection Output
  set Field format = none
end
"""

SLIT_SQUARE = """
subsection Geometry
  set Name = slit square
  subsection Slit square
    set Cell size = 0.125
  end
end
"""

MESH_FILE = """
subsection Geometry
  set Name = mesh file
  subsection Mesh file
    set File name = slit.msh
    set Boundary names = 1 = bottom ; 3 = top
  end
end
"""

# everything as it is by default but the density
CLOSED_CRACK = """
subsection Geometry
  set Name = rectangle
  subsection Rectangle
    set Cell size = 0.05
  end
end
subsection Initial cracks
  set Cracks = 0,0.5 : 0.5,0.5
  set Half width = h
end
"""
CLOSED = ["Model/Formulation=mixed", "Model/Length scale=0.1",
          "Model/Energy split=volumetric-deviatoric",
          "Model/Pressure law=relaxed bulk",
          "Boundary conditions/Displacement=bottom : y : 0 ; top : y : -1e-4*t"]

DEAD_LOAD = ["Model/Crack density=AT1", "Model/Energy split=none",
             "Model/Length scale=0.25",
             "Boundary conditions/Displacement=bottom : y : 0",
             "Boundary conditions/Traction=top : y : 10*t",
             "Load stepping/Force boundary=bottom",
             "Load stepping/End time=100", "Load stepping/First step=5",
             "Load stepping/Largest step=5", "Load stepping/Onset step=1",
             "Load stepping/Smallest step=1e-4"]


def slit_mesh(n):
    """n x n cells on the unit square, n even; the nodes of the left half of
    the middle line twice, but for the one at the tip. Ids: 1 below, 3 above."""
    middle, nodes, cells, lines = n // 2, {}, [], []

    def node(i, j, above):
        doubled = j == middle and i < middle and above
        return nodes.setdefault((i, j, doubled), len(nodes) + 1)

    for j in range(n):
        for i in range(n):
            above = j >= middle
            cells.append((node(i, j, above), node(i + 1, j, above),
                          node(i + 1, j + 1, above), node(i, j + 1, above)))
            if j == 0:
                lines.append((1, *cells[-1][:2]))
            if j == n - 1:
                lines.append((3, *cells[-1][2:]))
    text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n" % len(nodes)
    for (i, j, _), number in nodes.items():
        text += "%d %.16g %.16g 0\n" % (number, i / n, j / n)
    text += "$EndNodes\n$Elements\n%d\n" % (len(lines) + len(cells))
    for k, (group, *corners) in enumerate(lines):
        text += "%d 1 2 %d 1 %d %d\n" % (k + 1, group, *corners)
    for k, corners in enumerate(cells):
        text += "%d 3 2 7 1 %d %d %d %d\n" % (len(lines) + k + 1, *corners)
    return text + "$EndElements\n"


class Run:
    """One run of COMMON with more text and settings, in its own directory."""

    def __init__(self, text, *settings, status=0, files=()):
        with tempfile.TemporaryDirectory() as name:
            directory = pathlib.Path(name)
            (directory / "case.prm").write_text(COMMON + text, encoding="utf-8")
            for file, content in files:
                (directory / file).write_text(content, encoding="utf-8")
            self.output = program.runner(EXECUTABLE, MPIRUN, RANKS).output_of(
                ["case.prm", "--output", "results", *program.as_options(settings)],
                status, directory)
            if status != 2:
                results = directory / "results"
                self.summary = program.summary(results)
                self.rows = program.rows(results)

    def force(self):
        return float(self.rows[-1]["force_y_N"])


class Slits(unittest.TestCase):
    """Doubled nodes in mesh files are slits; slits have no contact."""

    def test_doubled_nodes_of_a_file_are_broken_as_asked(self):
        files = [("slit.msh", slit_mesh(8))]
        broken = Run(MESH_FILE, files=files)
        self.assertIn("slits: 4 faces of the coarse mesh", broken.output)
        self.assertEqual(float(broken.rows[0]["min_phase_field"]), 0)
        whole = Run(MESH_FILE, "Initial cracks/Broken slits=false", files=files)
        self.assertIn("Broken slits is false", whole.output)
        self.assertGreater(float(whole.rows[0]["min_phase_field"]), 0.99)

    def test_a_file_and_the_geometry_give_the_same(self):
        of_file = Run(MESH_FILE, files=[("slit.msh", slit_mesh(8))])
        built_in = Run(SLIT_SQUARE)
        self.assertAlmostEqual(of_file.force() / built_in.force(), 1, 6)

    def test_faces_that_pass_through_each_other_are_warned_of(self):
        closed = "Boundary conditions/Displacement=bottom : y : 0 ; top : y : -1e-4*t"
        run = Run(SLIT_SQUARE, closed)
        warnings = [w for w in run.summary["warnings"] if "pass through" in w]
        self.assertEqual(len(warnings), 1, run.summary["warnings"])
        self.assertRegex(warnings[0], r"by up to 0\.0001\d* mm at \(0, 0\.5\) at t = 1 s")
        self.assertIn("(in 1 steps)", warnings[0])
        self.assertIn("the faces of a slit pass through each other", run.output)
        opened = Run(SLIT_SQUARE)
        self.assertFalse([w for w in opened.summary["warnings"]
                          if "pass through" in w])


class ClosedCracks(unittest.TestCase):
    """A crack that closes carries, however small the residual stiffness."""

    def test_a_tiny_residual_stiffness_converges(self):
        tiny = Run(CLOSED_CRACK, *CLOSED)
        larger = Run(CLOSED_CRACK, *CLOSED, "Model/Residual stiffness=1e-5")
        self.assertEqual(tiny.summary["exit_status"], 0)
        self.assertLess(larger.force(), 0)
        self.assertAlmostEqual(tiny.force() / larger.force(), 1, delta=0.01)


class DeadLoads(unittest.TestCase):
    """A run ends where its loads have torn the body apart."""

    def test_the_load_at_failure_is_named(self):
        run = Run(SLIT_SQUARE, *DEAD_LOAD)
        self.assertIn("no equilibrium", run.summary["exit_reason"])
        self.assertIn("load at failure: between", run.summary["exit_reason"])
        self.assertLess(float(run.rows[-1]["time_s"]), 99)
        # what breaks without equilibrium says nothing about the numbers
        self.assertEqual([text for text in run.summary["warnings"]
                          if "damage fills" in text], [])

    def test_the_peak_is_a_load_that_was_carried(self):
        run = Run(SLIT_SQUARE, *DEAD_LOAD)
        forces = [abs(float(row["force_y_N"])) for row in run.rows]
        self.assertEqual(max(forces), forces[-1])
        self.assertAlmostEqual(run.summary["peak_force_N"], forces[-2], delta=1e-6)
        self.assertEqual(run.summary["step_at_peak"], len(forces) - 2)

    def test_parts_that_are_held_may_come_apart(self):
        run = Run(SLIT_SQUARE,
                  "Boundary conditions/Body force=y : -1e-3",
                  "Boundary conditions/Displacement=bottom : y : 0 ; top : y : 0.05*t",
                  "Load stepping/End time=2")
        self.assertNotIn("no equilibrium", run.summary["exit_reason"])


class Messages(unittest.TestCase):
    """A boundary that has no name is answered with what the file has."""

    def test_ids_of_the_file_are_listed(self):
        run = Run(MESH_FILE, "Geometry/Mesh file/Boundary names=", status=2,
                  files=[("slit.msh", slit_mesh(4))])
        self.assertIn("unknown 'bottom'. None is known.", run.output)
        self.assertIn("has the ids 0, 1, 3; Geometry/Mesh file/Boundary names "
                      "gives them names", run.output)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
