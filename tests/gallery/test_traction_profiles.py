#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""traction_profiles.csv: exact where the stress is uniform, near the force of
Output/Watched boundaries and nearer on finer meshes elsewhere; the same on any number
of ranks, whole when a run is continued, gone when another takes its place.

usage: test_traction_profiles.py EXECUTABLE RANKS MPIRUN
"""
import csv
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

EXECUTABLE, RANKS, MPIRUN = sys.argv[1], int(sys.argv[2]), sys.argv[3]
GALLERY = pathlib.Path(__file__).resolve().parents[2] / "parameters" / "gallery"
NAME = "traction_profiles.csv"
# a block that is stretched by 10 %, and free to contract
STRETCHED = [
    "Geometry/Rectangle/Cell size=0.25", "Output/Watched boundaries=top",
    "Output/Traction profiles=top", "Boundary conditions/Traction=",
    "Boundary conditions/Displacement at points=",
    "Boundary conditions/Displacement=left : symmetry ; bottom : y : 0 ; "
    "top : y : 0.1*t", "Geometry/Rectangle/Lower corner=0, 0",
    "Geometry/Rectangle/Upper corner=2, 1"]
SPACE = [
    "Geometry/Dimension=3", "Geometry/Name=box", "Geometry/Box/Upper corner=2, 1, 3",
    "Geometry/Box/Cell size=0.5", "Boundary conditions/Displacement="
    "left : symmetry ; bottom : symmetry ; back : symmetry ; top : y : 0.1*t"]


class TractionProfiles(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def start(self, directory, *settings, options=(), status=0, ranks=RANKS):
        return program.runner(EXECUTABLE, MPIRUN, ranks).output_of(
            [GALLERY / "traction_profile.prm", "--output", self.folder / directory, *options,
             *program.as_options(["Output/Field format=none", *settings])], status)

    def profile(self, directory):
        with open(self.folder / directory / NAME, encoding="utf-8", newline="") as file:
            return [{name: value if name == "boundary" else float(value)
                     for name, value in row.items()} for row in csv.DictReader(file)]

    def last(self, directory, boundary):
        """Rows of the last step, and that of statistics.csv."""
        rows = program.rows(self.folder / directory)
        return ([row for row in self.profile(directory)
                 if row["boundary"] == boundary and row["step"] == len(rows) - 1],
                {name: float(value) for name, value in rows[-1].items()})

    def near(self, found, expected, part=1e-8):
        self.assertLess(abs(found - expected), part * abs(expected), (found, expected))

    def check_uniform(self, directory, stress, area):
        rows, last = self.last(directory, "top")
        self.near(sum(row["area_mm2"] for row in rows), area)
        for row in rows:
            self.near(row["traction_y_MPa"], stress, 1e-6)
            self.assertLess(abs(row["traction_x_MPa"]), 1e-6 * stress)
        self.near(sum(row["traction_y_MPa"] * row["area_mm2"] for row in rows),
                  last["top_force_y_N"], 1e-6)
        return rows

    def test_uniform_stress(self):
        tough = "Material/Critical energy release rate=1e6"
        for number, formulation in enumerate(("displacement", "mixed")):
            settings = [*STRETCHED, tough, "Material/Thickness=5",
                        "Model/Formulation=" + formulation]
            self.start("plane%d" % number, *settings)
            # E eps, on 2 mm x 5 mm
            rows = self.check_uniform("plane%d" % number, 100., 10.)
            self.assertEqual(len(rows), 8 if number == 0 else 16)
            self.assertEqual([row["x_mm"] for row in rows],
                             sorted(row["x_mm"] for row in rows))

    def test_uniform_stress_in_space(self):
        self.start("space", *STRETCHED, *SPACE,
                   "Material/Critical energy release rate=1e6")
        rows = self.check_uniform("space", 100., 6.)
        self.assertEqual(len(rows), 4 * 6)
        self.assertEqual(set(row["z_mm"] for row in rows),
                         {0.25, 0.75, 1.25, 1.75, 2.25, 2.75})

    def test_finite_strain(self):
        """Of the undeformed area, so that it is the force that is told."""
        self.start("rubber", *STRETCHED, "Model/Strains=finite",
                   "Model/Kinematics=plane strain", "Model/Energy split=none",
                   "Material/Critical energy release rate=1e6")
        rows, last = self.last("rubber", "top")
        self.near(sum(row["area_mm2"] for row in rows), 2.)
        force = last["top_force_y_N"]
        for row in rows:
            self.near(row["traction_y_MPa"], force / 2., 1e-6)

    def test_two_materials(self):
        """Each part of a rigid end has the stress of what is beneath it."""
        self.start("parts", *STRETCHED, "Material/Critical energy release rate=1e6",
                   "Material/Poisson ratio=1e-9",
                   "Material/Young's modulus=if(x < 1, 1000, 3000)")
        rows, last = self.last("parts", "top")
        for row in rows:
            self.near(row["traction_y_MPa"], 100. if row["x_mm"] < 1. else 300., 1e-6)
        self.near(last["top_force_y_N"], 400., 1e-6)

    def test_broken_material_carries_next_to_nothing(self):
        self.start("broken", *STRETCHED, "Initial cracks/Cracks=0, 1 : 0.5, 1",
                   "Initial cracks/Half width=0.1", "Load stepping/End time=1e-3",
                   "Load stepping/First step=1e-3")
        rows, _ = self.last("broken", "top")
        self.assertLess(abs(rows[0]["traction_y_MPa"]),
                        0.3 * abs(rows[-1]["traction_y_MPa"]))

    def moment(self, directory, size, *settings):
        self.start(directory, "Geometry/Rectangle/Cell size=%g" % size, *settings)
        rows, last = self.last(directory, "left")
        return (sum(-row["y_mm"] * row["traction_x_MPa"] * row["area_mm2"]
                    for row in rows), last["left_moment_Nmm"], rows)

    def test_a_bent_beam(self):
        errors = []
        for level, size in enumerate((0.25, 0.125, 0.0625)):
            found, watched, rows = self.moment("bent%d" % level, size)
            self.near(watched, 0.1, 1e-5)
            errors.append(abs(found - watched))
            self.assertLess(abs(sum(row["traction_x_MPa"] * row["area_mm2"]
                                    for row in rows)), 1e-6)
        self.assertLess(errors[2], 0.01 * 0.1)
        for coarse, fine in zip(errors, errors[1:]):
            self.assertGreater(coarse / fine, 3.)
        for row in rows:
            self.assertLess(abs(row["traction_x_MPa"] + 1.2 * row["y_mm"]), 0.04)
        # elements that hold the exact solution
        found, watched, _ = self.moment("bent", 0.25, "Model/Displacement degree=2")
        self.near(found, watched, 1e-5)

    def test_ranks(self):
        self.start("some")
        self.start("one", ranks=1)
        some, one = self.profile("some"), self.profile("one")
        self.assertEqual(len(some), len(one))
        for row, expected in zip(some, one):
            for name in ("step", "boundary", "x_mm", "y_mm", "area_mm2"):
                self.assertEqual(row[name], expected[name])
            self.assertLess(abs(row["traction_x_MPa"] - expected["traction_x_MPa"]),
                            1e-6)

    def test_a_continued_run_has_all_rows_once(self):
        steps = ["Load stepping/First step=0.125", "Load stepping/Largest step=0.125",
                 "Output/Traction profiles every=3",
                 "Geometry/Rectangle/Cell size=0.25"]
        self.start("whole", *steps)
        whole = self.profile("whole")
        self.assertEqual(sorted(set(row["step"] for row in whole)), [0, 3, 6])
        self.start("parts", *steps, "Load stepping/End time=0.5")
        table = self.folder / "parts" / NAME
        table.write_text(table.read_text(encoding="utf-8") + "6,1,left,0,0,0,0,0\n",
                         encoding="utf-8")
        self.start("parts", *steps, options=["--resume"])
        self.start("stopped", *steps, "Output/Wall time limit=1e-6", status=5)
        self.start("stopped", *steps, options=["--resume"])
        for directory in ("parts", "stopped"):
            rows = self.profile(directory)
            self.assertEqual(len(rows), len(whole))
            for row, expected in zip(rows, whole):
                for name in ("step", "time_s", "boundary", "x_mm", "y_mm"):
                    self.assertEqual(row[name], expected[name])
                self.assertLess(
                    abs(row["traction_x_MPa"] - expected["traction_x_MPa"]), 1e-6)

    def test_overwriting(self):
        self.start("run")
        self.assertTrue((self.folder / "run" / NAME).exists())
        self.start("run", "Output/Traction profiles=", options=["--overwrite"])
        self.assertFalse((self.folder / "run" / NAME).exists())
        self.start("other", "Output/Traction profiles=")
        (self.folder / "other" / NAME).write_text("of the user\n", encoding="utf-8")
        out = self.start("other", options=["--overwrite"], status=4)
        self.assertIn(NAME, out)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
