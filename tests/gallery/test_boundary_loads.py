#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Cases of parameters/gallery with loads on boundaries: the values in their heads,
balance of what is watched, and a run that is continued.

usage: test_boundary_loads.py EXECUTABLE RANKS MPIRUN
"""
import math
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

EXECUTABLE, RANKS, MPIRUN = sys.argv[1], int(sys.argv[2]), sys.argv[3]
GALLERY = pathlib.Path(__file__).resolve().parents[2] / "parameters" / "gallery"


class Gallery(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def start(self, case, *options, settings=(), status=0, directory="results"):
        return program.runner(EXECUTABLE, MPIRUN, RANKS).output_of(
            [GALLERY / (case + ".prm"), "--output", self.folder / directory, *options,
             *program.as_options(["Output/Field format=none", *settings])], status)

    def last(self, case, *settings, directory="results"):
        self.start(case, settings=settings, directory=directory)
        return {name: float(value)
                for name, value in program.rows(self.folder / directory)[-1].items()}

    def near(self, found, expected, part):
        self.assertLess(abs(found - expected), part * abs(expected), (found, expected))

    def test_pressurised_cylinder(self):
        row = self.last("pressurised_cylinder")
        self.near(row["inner_x_mm"], 2. * 1.3 / 100. * 4.4 / 3., 2e-3)
        for first, second in (("x", "left"), ("y", "bottom")):
            force = row["inner_force_%s_N" % first]
            self.near(force, 2., 1e-5)
            self.near(row["%s_force_%s_N" % (second, first)], -force, 1e-6)
        # the same as a traction along the normal
        other = self.last("pressurised_cylinder", "Boundary conditions/Pressure=",
                          "Boundary conditions/Traction=inner : normal : -2*t",
                          directory="other")
        self.near(other["inner_x_mm"], row["inner_x_mm"], 1e-8)
        # in proportion to the load, so that the work is that of the energy
        self.near(row["external_work_mJ"], row["elastic_energy_mJ"], 1e-5)

    def test_inflated_rubber_tube(self):
        row = self.last("inflated_rubber_tube")
        self.near(row["inner_x_mm"], 0.5, 2e-3)
        self.near(row["external_work_mJ"], row["elastic_energy_mJ"], 2e-3)
        # the quarter of the deformed wall, seen from each side
        force = 0.428228 * (1. + row["inner_x_mm"])
        self.near(row["inner_force_x_N"], force, 1e-3)
        self.near(row["left_force_x_N"], -row["inner_force_x_N"], 1e-6)

    def test_twisted_bar(self):
        row = self.last("twisted_bar")
        torque = row["front_moment_z_Nmm"]
        self.near(torque, 0.140577 * 5. * 1e-4, 1e-2)
        self.near(row["back_moment_z_Nmm"], -torque, 1e-6)
        for name in ("front_moment_x_Nmm", "front_moment_y_Nmm", "front_force_x_N",
                     "front_displacement_x_mm"):
            self.assertLess(abs(row[name]), 1e-6 * torque, name)

    def test_turned_block(self):
        row = self.last("turned_block")
        self.near(row["middle_x_mm"], 2.5 * math.sin(1.2), 1e-6)
        self.near(row["middle_y_mm"], 2.5 * (1. - math.cos(1.2)), 1e-6)
        self.assertLess(abs(row["elastic_energy_mJ"]), 1e-8)
        for name in ("left_force_x_N", "left_force_y_N", "left_moment_Nmm"):
            self.assertLess(abs(row[name]), 1e-5, name)
        # the mean of the displacements of a straight side is that of its middle
        self.near(row["left_displacement_x_mm"],
                  math.cos(1.2) * -1. - math.sin(1.2) * -2.5 + 1., 1e-6)

    def test_watched_boundaries_survive_a_stop(self):
        case = "inflated_rubber_tube"
        self.start(case, settings=["Output/Wall time limit=1e-6"], status=5)
        self.start(case, "--resume")
        rows = program.rows(self.folder / "results")
        whole = self.last(case, directory="whole")
        self.assertEqual(len(rows), 11)
        for name in ("inner_force_x_N", "left_force_x_N", "inner_displacement_y_mm"):
            self.near(float(rows[-1][name]), whole[name], 1e-6)
        self.assertNotEqual(rows[1]["inner_force_x_N"], "")
        # points may be added to a run that is continued, boundaries may not
        out = self.start(case, "--resume", status=2, settings=[
            "Output/Watched boundaries=inner"])
        self.assertIn("Output/Watched boundaries", out)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
