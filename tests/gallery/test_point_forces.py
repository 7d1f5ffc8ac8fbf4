#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Forces on sets of points, in the plane and in space: each vertex has the force, as
beside single points, with exact values and balance; hanging vertices, both faces of a
slit, adaptation, a run that is continued; planes of symmetry in space.

usage: test_point_forces.py EXECUTABLE RANKS MPIRUN
"""
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

EXECUTABLE, RANKS, MPIRUN = sys.argv[1], int(sys.argv[2]), sys.argv[3]
CASE = pathlib.Path(__file__).resolve().parents[2] / "parameters" / "gallery" \
    / "point_forces.prm"
SETS, FORCES = "Geometry/Point sets=", "Boundary conditions/Force at points="
# of a block of 1 x 1 x 2 mm, pulled along z
BLOCK = [
    "Geometry/Dimension=3", "Geometry/Name=box", "Geometry/Box/Upper corner=1, 1, 2",
    "Geometry/Box/Cell size=0.25", "Output/Watched boundaries=back",
    "Boundary conditions/Displacement=left : symmetry ; bottom : symmetry ; "
    "back : symmetry",
    "Output/Displacement at points=end : 1, 0.5, 2 ; corner : 1, 1, 2",
    SETS + "edges : z > 1.999 && (x < 0.01 || x > 0.99 || y < 0.01 || y > 0.99) ; "
    "corners : z > 1.999 && (x < 0.01 || x > 0.99) && (y < 0.01 || y > 0.99) ; "
    "all of it : z > 1.999"]
# p h^2, half of it at the edges, a quarter at the corners: what is too much is
# taken away
PULL = FORCES + "all of it : z : 0.0625*t ; edges : z : -0.03125*t ; " \
    "corners : z : -0.015625*t"


class PointForces(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.n_runs = 0

    def start(self, directory, *settings, options=(), status=0):
        return program.runner(EXECUTABLE, MPIRUN, RANKS).output_of(
            [CASE, "--output", self.folder / directory, *options,
             *program.as_options(["Output/Field format=none", *settings])], status)

    def last(self, *settings):
        self.n_runs += 1
        directory = "run%d" % self.n_runs
        self.start(directory, *settings)
        return {name: float(value)
                for name, value in program.rows(self.folder / directory)[-1].items()}

    def near(self, found, expected, part=1e-6):
        self.assertLess(abs(found - expected), part * abs(expected), (found, expected))

    def test_the_stress_is_uniform(self):
        row = self.last()
        self.near(row["end_x_mm"], 2e-3)
        self.near(row["corner_x_mm"], 2e-3)
        self.near(row["corner_y_mm"], -3e-4)
        self.near(row["left_force_x_N"], -5.)
        work = 0.5 * 5. * 2e-3
        for name in ("external_work_mJ", "elastic_energy_mJ"):
            self.near(row[name], work)
        self.assertLess(abs(row["energy_imbalance_mJ"]), 1e-6 * work)

    def test_a_set_is_each_of_its_points(self):
        of_set = self.last(FORCES + "corners : all : 0.5*t")
        of_points = self.last(FORCES + "2, 0 : all : 0.5*t ; 2, 1 : all : 0.5*t")
        both = self.last(FORCES + "corners : all : 0.25*t ; 2, 0 : all : 0.25*t ; "
                         "2, 1 : all : 0.25*t")
        self.near(of_set["left_force_x_N"], -1.)
        for row in (of_points, both):
            for name in ("end_x_mm", "corner_y_mm", "external_work_mJ"):
                self.near(row[name], of_set[name], 1e-9)

    def test_space(self):
        row = self.last(*BLOCK, PULL)
        self.near(row["end_z_mm"], 2e-3)
        self.near(row["corner_z_mm"], 2e-3)
        self.near(row["corner_x_mm"], -3e-4)
        self.near(row["corner_y_mm"], -3e-4)
        self.near(row["back_force_z_N"], -1.)
        self.near(row["external_work_mJ"], 0.5 * 2e-3)

    def test_single_points_in_space(self):
        forces = " ; ".join("%d, %d, 2 : z : 0.25*t" % (x, y)
                            for x in (0, 1) for y in (0, 1))
        points = self.last(*BLOCK, FORCES + forces)
        of_set = self.last(*BLOCK, FORCES + "corners : z : 0.25*t")
        self.near(points["back_force_z_N"], -1.)
        for name in ("corner_z_mm", "corner_x_mm", "elastic_energy_mJ"):
            self.near(points[name], of_set[name], 1e-9)

    def test_symmetry_in_space(self):
        """An eighth of a block, pulled at the corners of its end, for the whole."""
        eighth = self.last(*BLOCK, FORCES + "1, 1, 2 : z : 0.25*t")
        forces = " ; ".join("%d, %d, %d : z : %g*t" % (x, y, z, 0.25 * z / 2)
                            for x in (-1, 1) for y in (-1, 1) for z in (-2, 2))
        whole = self.last(
            *BLOCK, "Geometry/Box/Lower corner=-1, -1, -2", "Output/Watched boundaries=",
            SETS, "Boundary conditions/Displacement=",
            "Boundary conditions/Displacement at points=0, 0, 0 : all : 0 ; "
            "1, 0, 0 : y : 0 ; 1, 0, 0 : z : 0 ; 0, 1, 0 : z : 0", FORCES + forces)
        self.near(whole["elastic_energy_mJ"], 8 * eighth["elastic_energy_mJ"], 1e-8)
        for name in ("corner_x_mm", "corner_y_mm", "corner_z_mm"):
            self.near(whole[name], eighth[name], 1e-8)
        self.near(eighth["back_force_z_N"], -0.25)

    def test_a_hanging_vertex(self):
        """Its force goes to the two nodes that it lies between."""
        finer = "Mesh/Refined boxes=1.55, 0.3 : 3, 3 : 1"
        name = "between : abs(x - 1.5) < 1e-3 && abs(y - 0.625) < 1e-3"
        clamped = ["Boundary conditions/Displacement=left : all : 0", finer,
                   "Output/Watched boundaries=left moment about 0, 0"]
        row = self.last(*clamped, SETS + name, FORCES + "between : y : 3*t")
        halves = self.last(*clamped, SETS,
                           FORCES + "1.5, 0.5 : y : 1.5*t ; 1.5, 0.75 : y : 1.5*t")
        self.near(row["left_force_y_N"], -3.)
        self.near(row["left_moment_Nmm"], -4.5)
        for name in ("end_y_mm", "external_work_mJ"):
            self.near(row[name], halves[name], 1e-9)

    def test_both_faces_of_a_slit(self):
        slit = ["Geometry/Name=slit square", "Geometry/Slit square/Cell size=0.125",
                "Initial cracks/Broken slits=false", "Output/Displacement at points=",
                "Output/Watched boundaries=bottom",
                "Boundary conditions/Displacement=bottom : all : 0",
                SETS + "mouth : x < 1e-6 && abs(y - 0.5) < 1e-6"]
        row = self.last(*slit, FORCES + "mouth : x : 2*t")
        self.near(row["bottom_force_x_N"], -4.)
        text = self.start("refused", *slit, FORCES + "0, 0.5 : x : 2*t", status=2)
        self.assertIn("slit has two vertices", text)

    def test_adaptation_adds_no_force(self):
        """Cells become finer at the loaded side in the first mesh already, around a
        crack; the nodes of the mesh before bear the load, also when continued."""
        settings = [
            "Mesh/Adaptation=predictor corrector", "Mesh/Adaptive levels=1",
            "Model/Length scale=0.1", "Initial cracks/Cracks=2, 0.5 : 1.75, 0.5",
            SETS + "side : x > 1.999", FORCES + "side : x : t/5",
            "Boundary conditions/Displacement=left : symmetry ; bottom : symmetry"]
        self.start("whole", *settings)
        rows = program.rows(self.folder / "whole")
        self.assertGreater(int(rows[-1]["cells"]), 32)
        self.start("parts", *settings, "Load stepping/End time=0.5")
        self.start("parts", *settings, options=["--resume"])
        for directory in ("whole", "parts"):
            rows = program.rows(self.folder / directory)
            self.assertEqual(len(rows), 3)
            for row in rows[1:]:
                self.near(float(row["left_force_x_N"]), -float(row["time_s"]), 1e-5)

    def test_what_is_refused(self):
        for settings, words in (
                ((FORCES + "nobody : x : t",), ("'nobody'", "corners", "between")),
                ((SETS, FORCES + "corners : x : t"), ("'corners'", "there are none")),
                ((FORCES + "corners : x : t ; corners : x : 2",), ("'corners'",)),
                ((FORCES + "corners : w : t",), ("'w'",)),
                ((FORCES + "corners : x : 1/t",), ("finite",)),
                ((SETS + "corners : x > 5 ; between : x > 1",),
                 ("Geometry/Point sets", "x > 5", "nearest"))):
            with self.subTest(settings=settings):
                text = self.start("refused", *settings, status=2)
                for word in ("oint", *words):
                    self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
