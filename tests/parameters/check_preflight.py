#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What --check finds out, and whether the run agrees.

    check_preflight.py EXECUTABLE MPIRUN

Counts are those of the run; a mesh of millions of cells is counted, not built;
supports that leave a rigid motion free and points that are not in the body are
refused; a body held and loaded at points only runs; load steps that are not
given follow from the end time; kappa = 0 runs, or is named where it cannot;
bodies that move as a whole; cracks that are not in the body; expressions at the
start.
"""
import csv
import math
import os
import re
import resource
import sys
import tempfile
import unittest

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import program  # noqa: E402

PROGRAM = []

MATERIAL = """\
subsection Material
  set Young's modulus = 1
  set Poisson ratio   = 0.3
end
"""
HELD = """\
subsection Boundary conditions
  set Displacement = bottom : all : 0 ; top : y : 0.001*t
end
"""
STRIP, BOX = "punctured strip", "box\n  set Dimension = 3"
SQUARE = "subsection Geometry\n  set Name = rectangle\nend\n" + MATERIAL
BEAM = """\
subsection Geometry
  set Name = rectangle
  subsection Rectangle
    set Upper corner = 8, 2
    set Cell size    = 0.5
  end
end
subsection Boundary conditions
  set Displacement at points = 0,0 : all : 0 ; 8,0 : y : 0 ; 4,2 : y : -1e-2*t
end
subsection Load stepping
  set End time = 0.1
end
""" + MATERIAL
# two rows of cells that are broken through and through, between held ones
BROKEN = """\
subsection Geometry
  set Name = rectangle
  subsection Rectangle
    set Cells = 8, 8
  end
end
subsection Model
  set Residual stiffness = 0
  set Length scale       = 0.25
end
subsection Initial cracks
  set Cracks     = 0,0.5 : 1,0.5
  set Half width = h
end
""" + MATERIAL + HELD


def set_all(settings):
    return [word for setting in settings for word in ("--set", setting)]


class Preflight(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.folder = self.directory.name

    def tearDown(self):
        self.directory.cleanup()

    def run_case(self, text, *arguments, ranks=1, status=0, anew=False):
        """Output of a run, and its error stream when the status is not 0; anew: of the
        program, started for it."""
        with open(os.path.join(self.folder, "case.prm"), "w") as stream:
            stream.write(text)
        starts = (program.Program if anew else program.runner)(*PROGRAM, ranks)
        found, out, err = starts.run([*arguments, "case.prm"], self.folder)
        self.assertEqual(found, status, out + err)
        return out if status == 0 else out + err

    def refused(self, text, *arguments):
        return self.run_case(text, "--check", *arguments, status=2)

    def rows(self):
        path = os.path.join(self.folder, "results", "statistics.csv")
        with open(path, newline="") as stream:
            return list(csv.DictReader(stream))

    # --- counts ---------------------------------------------------------------

    def test_counts_are_those_of_the_run(self):
        for more in ([], ["--set", "Mesh/Global refinements=1"],
                     ["--set", "Mesh/Refined boxes=0.3,0.3 : 0.6,0.6 : 2"]):
            more += ["--set", "Load stepping/Stop when force falls below=0.5",
                     "--set", "Load stepping/End time=0.1", "--overwrite"]
            lines = [[line for line in self.run_case(SQUARE + HELD, *arguments, ranks=2)
                      .splitlines() if re.match("ranks:|finest cells|memory:", line)]
                     for arguments in (["--check"] + more, more)]
            self.assertEqual(len(lines[0]), 3)
            self.assertEqual(*lines)

    def test_millions_of_cells_are_counted(self):
        cells = ["--set", "Geometry/Rectangle/Cell size=0.05",
                 "--set", "Mesh/Global refinements=7"]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        text = self.run_case(SQUARE + HELD, "--check", *cells, anew=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        # (20 * 2^7)^2 cells, nodes of degree 2, vertices
        n, nodes, vertices = 2560 ** 2, 5121 ** 2, 2561 ** 2
        self.assertIn("cells: %d; dofs: %d (u, p: %d; phi: %d)" % (
            n, 2 * nodes + 2 * vertices, 2 * nodes + vertices, vertices), text)
        self.assertIn("h = %.4g mm" % (0.05 / 2 ** 7), text)
        self.assertIn("not checked: the mesh itself", text)
        # that of the whole mesh: more than one value for each of the 4 vertices,
        # 9 nodes and 4 pressures of a cell
        size = float(re.search(r"checkpoint: about (\S+) MB", text).group(1))
        self.assertGreater(size, 1e-6 * 8 * (4 + 2 * 9 + 4) * n)
        # most of it is the start of the program
        self.assertLess(after.ru_utime - before.ru_utime, 4.)
        text = self.run_case(SQUARE + HELD, "--check", "--set",
                             "Mesh/Refined boxes=0.25,0.25 : 0.75,0.75 : 9")
        found = float(re.search(r"cells: about (\S+);", text).group(1))
        self.assertAlmostEqual(found / (0.25 * (10 * 2 ** 9) ** 2), 1., delta=0.1)

    def test_many_coarse_cells_are_counted(self):
        """As fast where no refinement but the coarse mesh makes the cells."""
        for name, many in (("", ["--set", "Geometry/Rectangle/Cells=800, 400"]),
                           (STRIP, ["--set", "Geometry/Punctured strip/Cell size=0.05"]),
                           (BOX, ["--set", "Geometry/Box/Cells=100, 100, 90"])):
            case = SQUARE.replace("rectangle\nend", name + "\nend") if name \
                else SQUARE
            case += HELD
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            text = self.run_case(case, "--check", *many, anew=True)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            self.assertLess(after.ru_utime - before.ru_utime, 4.)
            self.assertIn("not checked: the mesh itself", text)
            found = float(re.search(r"cells: about (\S+);", text).group(1))
            # [0, 20] x [0, 28] with a hole of radius 4, of squares of 0.05
            exact = {"": 320000, STRIP: (20 * 28 - math.pi * 16) / 0.05 ** 2,
                     BOX: 900000}[name]
            self.assertAlmostEqual(found / exact, 1., delta=0.12)

    def test_large_meshes_are_refused_for_what_small_ones_are(self):
        for more in ([], ["--set", "Mesh/Global refinements=8"]):
            text = self.refused(SQUARE + HELD, *more, "--set", "Boundary conditions/"
                                "Displacement at points=0.3333, 0.5 : x : 0")
            self.assertRegex(text, r"no vertex .*the nearest is \(0\.3.*, 0.5\)")
            text = self.refused(SQUARE + HELD, *more, "--set",
                                "Output/Displacement at points=far : 1, 1.2")
            self.assertRegex(text, r"outside of the mesh.* nearest vertex is \(1, 1\)")
            # a vertex of the whole mesh, not of the coarse one
            point = 0.1 + (0.1 / 2 ** 8 if more else 0.)
            self.run_case(SQUARE + HELD, "--check", *more, "--set", "Boundary "
                          "conditions/Displacement at points=%.10g, 0.1 : x : 0" % point)

    # --- supports -------------------------------------------------------------

    def test_free_rigid_motions_are_named(self):
        only_top = SQUARE + HELD.replace("bottom : all : 0 ; ", "")
        for ranks in (1, 2):
            text = self.run_case(only_top, "--check", ranks=ranks, status=2)
            self.assertIn("the body can move in x", text)
            self.assertEqual(text.count("error:"), 1)
        text = self.run_case(only_top, status=2)
        self.assertIn("the body can move in x", text)
        text = self.refused(BEAM.replace(" ; 8,0 : y : 0 ; 4,2 : y : -1e-2*t", ""))
        self.assertIn("the body can rotate about (0, 0)", text)

    def test_a_point_that_is_not_in_the_body(self):
        text = self.refused(SQUARE + HELD, "--set", "Boundary conditions/"
                            "Displacement at points=77, 77 : x : 0")
        self.assertRegex(text, r"'77 77'.*no vertex.*the nearest is \(1, 1\)")

    def test_a_body_held_and_loaded_at_points(self):
        forces = []
        for ranks in (1, 2):
            self.run_case(BEAM, "--overwrite", ranks=ranks)
            last = self.rows()[-1]
            force, moved = float(last["force_y_N"]), float(last["displacement_mm"])
            self.assertAlmostEqual(moved, 1e-3)
            self.assertLess(force, 0.)
            self.assertLess(abs(float(last["force_x_N"])), 1e-9 * abs(force))
            work = 0.5 * abs(force) * moved
            self.assertLess(abs(float(last["elastic_energy_mJ"]) / work - 1.), 0.01)
            forces.append(force)
        self.assertLess(abs(forces[1] / forces[0] - 1.), 1e-9)
        text = self.refused(BEAM, "--set", "Load stepping/Force boundary=top")
        self.assertIn("points only", text)

    def test_cracks_that_are_not_in_the_body(self):
        for name, crack in (("Cracks", "5,5 : 6,6"), ("Discs", "2,2 : 0.5")):
            setting = "Initial cracks/%s=%s" % (name, crack)
            for ranks, arguments in ((1, ["--check"]), (2, [])):
                text = self.run_case(SQUARE + HELD, *arguments, "--set", setting,
                                     ranks=ranks, status=2)
                self.assertIn("Initial cracks/%s: found '%s'" % (name, crack), text)
                self.assertIn("from (0 0) to (1 1) mm", text)
                self.assertEqual(text.count("error:"), 1)
        self.run_case(SQUARE + HELD, "--check", "--set",
                      "Initial cracks/Cracks=0.5,0.5 : 6,0.5")

    def test_expressions_in_h_are_those_of_the_mesh(self):
        for setting in ("Model/Length scale=0.3-h", "Model/Residual stiffness=2*h-0.1",
                        "Initial cracks/Half width=0.2-h"):
            for size, status in (("10, 10", 0), ("2, 2", 2 if "-h" in setting else 0)):
                text = self.run_case(
                    SQUARE + HELD, "--check", "--set", setting, "--set",
                    "Geometry/Rectangle/Cells=" + size, status=status)
                self.assertEqual("for h = 0.5 mm" in text, status == 2, text)

    def test_expressions_at_the_start_have_values(self):
        for name, value in (("Initial cracks/Phase field", "1/0"),
                            ("Initial cracks/Phase field", "sqrt(0-1)"),
                            ("Initial cracks/Phase field", "1/(x-0.5)"),
                            ("Fluid/Pressure", "log(0*t)"),
                            ("Boundary conditions/Body force", "x : exp(1000)"),
                            ("Boundary conditions/Traction", "left : x : sqrt(-1-y)"),
                            ("Boundary conditions/Displacement at points",
                             "0,0 : x : 1/t"),
                            ("Boundary conditions/Displacement",
                             "bottom : all : 0 ; top : y : log(x-1)")):
            for ranks, arguments in ((1, ["--check"]), (2, [])):
                text = self.run_case(SQUARE + HELD, *arguments, "--set",
                                     name + "=" + value, ranks=ranks, status=2)
                self.assertRegex(text, re.escape(name) + ": the expression .* gives "
                                 ".* at x = .*; it must be finite")
                self.assertEqual(text.count("error:"), 1)
        # in a mesh that is counted and not built, too
        text = self.refused(SQUARE + HELD, "--set", "Mesh/Global refinements=8",
                            "--set", "Initial cracks/Phase field=1/0")
        self.assertIn("Initial cracks/Phase field", text)

    # --- load steps -----------------------------------------------------------

    def test_load_steps_follow_from_the_end_time(self):
        text = self.run_case(SQUARE + HELD, "--check", "--set",
                             "Load stepping/End time=3.5e-3")
        self.assertIn("load steps: first 0.00035 s, largest 0.00035 s, onset 3.5e-05 s, "
                      "smallest 3.5e-07 s (derived: largest, first, onset, smallest)",
                      text)

    def test_a_schedule_of_steps(self):
        self.run_case(SQUARE + HELD, "--set", "Load stepping/End time=0.7", "--set",
                      "Load stepping/Step schedule=0:0.25, 0.5:0.1", "--set",
                      "Load stepping/Largest phase-field change=0")
        self.assertEqual([float("%.9g" % float(row["time_s"])) for row in self.rows()],
                         [0., 0.25, 0.5, 0.6, 0.7])

    def test_steps_that_are_lost_in_rounding(self):
        for schedule in ("0:2e-3, 0.004:1e-20", "0:1e-300"):
            text = self.refused(SQUARE + HELD, "--set",
                                "Load stepping/Step schedule=" + schedule)
            self.assertIn("lost in rounding", text)
        text = self.run_case(SQUARE + HELD, "--check", "--set",
                             "Load stepping/Step schedule=0:1e-9")
        self.assertIn("warning: at least 1e+09 load steps", text)

    def test_numbers_that_overflow_are_not_printed(self):
        text = self.run_case(SQUARE + HELD, "--check", "--set",
                             "Material/Young's modulus=1e300")
        self.assertNotRegex(text, r"\b(inf|nan)\b")

    # --- no residual stiffness ------------------------------------------------

    def test_no_residual_stiffness_without_broken_cells(self):
        self.run_case(SQUARE + HELD, "--set", "Model/Residual stiffness=0",
                      "--set", "Linear solver/Name=auto")
        reactions = [float(row["force_y_N"]) for row in self.rows()]
        self.run_case(SQUARE + HELD, "--overwrite")
        for kept, row in zip(reactions, self.rows()):
            self.assertAlmostEqual(kept, float(row["force_y_N"]), delta=1e-8)

    def test_no_residual_stiffness_where_cells_are_broken(self):
        for more in ([], ["--set", "Model/Formulation=displacement"]):
            text = self.run_case(BROKEN, "--overwrite", *more, status=3)
            self.assertRegex(text, r"Model/Residual stiffness \(kappa\) is 0")
            self.run_case(BROKEN, "--overwrite", "--set",
                          "Model/Residual stiffness=1e-6", *more)

    def test_block_amg_needs_residual_stiffness(self):
        for kappa in ("0", "if(h < 1, 0, 1)"):
            text = self.refused(SQUARE + HELD, "--set", "Linear solver/Name=block AMG",
                                "--set", "Model/Residual stiffness=" + kappa)
            self.assertIn("Linear solver/Name", text)
            self.assertIn("Model/Residual stiffness", text)
        text = self.run_case(SQUARE + HELD, "--check", "--set", "Mesh/Global refinements=8",
                             "--set", "Linear solver/Name=auto", "--set",
                             "Model/Residual stiffness=0")
        self.assertIn("linear solver 'direct'", text)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    PROGRAM = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1])
