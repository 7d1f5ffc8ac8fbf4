#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Cracks of a run in 3-d, from the first step to a body in two parts: their files,
the same on one rank and two and after a resume, and what summary.json says.

usage: test_crack_sheets.py EXECUTABLE MPIRUN
"""
import os
import re
import shutil
import sys
import tempfile
import unittest

import small_runs
from small_runs import strict_json, table_of, text_of, write

PROGRAM = []
WIDTH, DEPTH, CELL = 1, 0.4, 0.1

# A block with a crack from the left side, half of a disc, that is pulled apart
CASE = """\
subsection Geometry
  set Dimension = 3
  set Name = box
  subsection Box
    set Lower corner = 0, 0, 0
    set Upper corner = 1, 1.2, 0.4
    set Cell size = 0.1
  end
end
subsection Model
  set Formulation = displacement
  set Crack density = AT2
  set Energy split = spectral
  set Pressure law = degraded bulk
  set Length scale = 0.2
  set Residual stiffness = 1e-4
  set Coupling tolerance = 1e-4
end
subsection Material
  set Young's modulus = 1000
  set Poisson ratio = 0.2
  set Critical energy release rate = 1
end
subsection Initial cracks
  set Discs = 0, 0.6, 0.2 : 0, 1, 0 : 0.5
  set Half width = 0.05
end
subsection Boundary conditions
  set Displacement = bottom : all : 0 ; top : x : 0 ; top : z : 0 ; top : y : 0.1*t
  set Unbreakable margin = 0.3
end
subsection Load stepping
  set End time = 2
  set First step = 0.25
  set Largest step = 0.25
  set Onset step = 0.05
  set Smallest step = 0.01
  set Stop when separated = true
  set Force boundary = top
end
subsection Output
  set Checkpoint every = 1
  set Field format = none
end
"""
FILES = ("crack_sheet.csv", "crack_sheet.pvd", "crack_front.csv",
         "crack_front.pvd")


def is_float(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


class CrackSheets(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        write(cls.folder, "case.prm", CASE)
        small_runs.run(PROGRAM, cls.folder, "--output", "whole")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def expect_same(self, one, other, tolerance=1e-4):
        """Tables and lists, numbers but for a part of the length of the body."""
        for name in FILES:
            a, b = ([re.split(r"[,\s]+", text_of(self.path(folder), name))
                     for folder in (one, other)])
            self.assertEqual(len(a), len(b), name)
            for x, y in zip(a, b):
                if is_float(x) and is_float(y):
                    self.assertLess(abs(float(x) - float(y)),
                                    tolerance * max(1, abs(float(x))), (name, x, y))
                else:
                    self.assertEqual(x, y, name)

    def test_sheets_grow_until_the_body_is_in_two(self):
        sheets = table_of(self.path("whole"), "crack_sheet.csv")
        areas = [float(row["area_mm2"]) for row in sheets]
        self.assertEqual(sheets[0]["joins"], "back to front to left to tip")
        # the disc within the body, to the nodes that it breaks
        self.assertLess(abs(areas[0] - 0.1943), CELL * DEPTH)
        self.assertLess(abs(areas[-1] - WIDTH * DEPTH), 0.1 * CELL)
        for one, other in zip(areas, areas[1:]):
            self.assertGreater(other, one - 0.1 * CELL * DEPTH)
        last = sheets[-1]
        self.assertEqual(last["joins"], "left to back to front to right")
        self.assertEqual(last["front_length_mm"], "0")
        self.assertGreater(abs(float(last["normal_y"])), 0.99)

    def test_outcome(self):
        summary = strict_json(self.path("whole"), "summary.json")
        self.assertIs(summary["separated"], True)
        self.assertEqual(summary["outcome"], "other")
        self.assertEqual(summary["outcome_start"], "left")
        self.assertIn("separated", summary["exit_reason"])
        self.assertIn("# outcome: other; start: left; joins: left to back to front "
                      "to right\n", text_of(self.path("whole"), "crack_sheet.csv"))

    def test_fronts(self):
        rows = table_of(self.path("whole"), "crack_front.csv")
        first = [row for row in rows if row["step"] == rows[0]["step"]]
        for row in first:
            radius = (float(row["x_mm"]) ** 2 +
                      (float(row["z_mm"]) - 0.2) ** 2) ** 0.5
            self.assertLess(abs(radius - 0.5), CELL)
            self.assertEqual(row["tip_speed_mm_per_s"], "")
        later = [row for row in rows if row not in first]
        for row in later:
            self.assertGreaterEqual(float(row["tip_speed_mm_per_s"]), 0)
        self.assertTrue(any(float(row["opening_angle_deg"] or 0) > 0
                            for row in rows))

    def test_every_file_is_listed(self):
        listed = text_of(self.path("whole"), "run_files.txt").splitlines()
        steps = {row["step"] for row in
                 table_of(self.path("whole"), "crack_sheet.csv")}
        for kind, piece in (("crack_sheet", "Polys"), ("crack_front", "Lines")):
            names = re.findall('file="([^"]*)"',
                               text_of(self.path("whole"), kind + ".pvd"))
            self.assertEqual(len(names), len(steps))
            for name in names:
                self.assertIn(name, listed)
                text = text_of(self.path("whole"), name)
                self.assertTrue(text.endswith("</VTKFile>\n"))
                self.assertIn("NumberOf" + piece, text)

    def test_two_ranks_find_the_same(self):
        small_runs.run(PROGRAM, self.folder, "--output", "two", ranks=2)
        self.expect_same("two", "whole")

    def test_a_resumed_run_has_the_same_files(self):
        steps = [int(row["step"]) for row in
                 table_of(self.path("whole"), "statistics.csv")]
        self.assertGreater(len(steps), 3)
        small_runs.run(PROGRAM, self.folder, "--output", "parts", status=5,
                       settings=["Output/Wall time limit=1e-6"])
        small_runs.run(PROGRAM, self.folder, "--output", "parts", "--resume",
                       settings=["Load stepping/End time=0.5"])
        # what the checkpoint does not know of must not stay
        write(self.path("parts"), "crack_front.csv", "cut o")
        small_runs.run(PROGRAM, self.folder, "--output", "parts", "--resume")
        self.expect_same("parts", "whole")


if __name__ == "__main__":
    PROGRAM[:] = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
