#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Output/Events in 3-d, against the tables of cracks of the same run; the same on one
rank and two and in a run that is killed and goes on.

usage: test_events_3d.py EXECUTABLE MPIRUN
"""
import math
import os
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

import small_runs
from small_runs import killed_after_rows, steps_with_fields, strict_json, table_of, \
    text_of, write
from test_crack_sheets import CASE, CELL

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from program import as_options, command  # noqa: E402

PROGRAM = []
AREA = 0.05  # mm^2
WATCHED = ["Output/Events=all", "Output/Event crack area=%g" % AREA,
           "Output/Field format=VTU", "Output/Fields every=0"]
# without the initial crack; damage begins where the body is weak
WEAK_AT = (0.35, 0.55, 0.1)
NO_FIELDS = ["Output/Field format=none", "Output/Checkpoint every=0"]  # quicker
WHOLE_BLOCK = [*NO_FIELDS, "Initial cracks/Discs=",
               "Material/Critical energy release rate="
               "1-0.8*exp(-((x-0.35)^2+(y-0.55)^2+(z-0.1)^2)/0.04)"]
# on a mesh that follows the crack
SLIT = pathlib.Path(__file__).resolve().parents[1] / "regression" / \
    "slit_cube_adaptive.prm"
# of the boundaries of the block: direction and coordinate
PLANES = {"left": (0, 0.), "right": (0, 1.), "bottom": (1, 0.), "top": (1, 1.2),
          "back": (2, 0.), "front": (2, 0.4)}


def place_of(row):
    return [float(row[name]) for name in ("x_mm", "y_mm", "z_mm")]


class Events(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        write(cls.folder, "case.prm", CASE)
        cls.run_it("whole")
        cls.run_it("block", settings=WHOLE_BLOCK)
        cls.run_it("slit", case=SLIT, settings=NO_FIELDS)
        cls.events = table_of(cls.path("whole"), "events.csv")

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name)

    @classmethod
    def run_it(cls, output, *options, settings=(), **more):
        small_runs.run(PROGRAM, cls.folder, "--output", output, *options,
                       settings=[*WATCHED, *settings], **more)

    def joined_first(self, output):
        """[(step, boundary)] as they come to 'joins' of crack_sheet.csv."""
        known, found = set(), []
        for row in table_of(self.path(output), "crack_sheet.csv"):
            met = set(row["joins"].split(" to ")) - {"tip", row["start"]} - known
            known |= met
            found += [(row["step"], name) for name in sorted(met)]
        return found

    def of_kind(self, kind, output="whole"):
        return [row for row in table_of(self.path(output), "events.csv")
                if row["event"] == kind]

    def expect_same(self, output, expected="whole"):
        one, other = (table_of(self.path(name), "events.csv")
                      for name in (output, expected))
        self.assertEqual(len(one), len(other))
        for row, wanted in zip(one, other):
            for name, value in wanted.items():
                if name in ("step", "event", "boundary") or "" in (value, row[name]):
                    self.assertEqual(row[name], value, name)
                else:
                    self.assertAlmostEqual(float(row[name]), float(value), delta=1e-4,
                                           msg=name)
        if expected == "whole":
            self.assertLessEqual({int(row["step"]) for row in other},
                                 steps_with_fields(self.path(output)))

    def test_growth_against_the_sheets(self):
        """One event for each step in which another multiple is passed."""
        for output in ("whole", "block", "slit"):
            areas = {}
            for row in table_of(self.path(output), "crack_sheet.csv"):
                step = int(row["step"])
                areas[step] = areas.get(step, 0.) + float(row["area_mm2"])
            rows = table_of(self.path(output), "events.csv")
            initial = areas.get(0, 0.)
            area, passed, expected = initial, 0, []
            for row in table_of(self.path(output), "statistics.csv"):
                area = areas.get(int(row["step"]), area)
                if int((area - initial) / AREA + 1e-9) > passed:
                    passed = int((area - initial) / AREA + 1e-9)
                    expected.append(row["step"])
            found = [row["step"] for row in rows if row["event"] == "crack area"]
            self.assertEqual(found, expected, output)
            self.assertGreaterEqual(len(expected), 1, output)
            for row in rows:
                if int(row["step"]) in areas:
                    self.assertAlmostEqual(float(row["crack_area_mm2"]),
                                           areas[int(row["step"])], delta=1e-8)
                self.assertAlmostEqual(
                    float(row["growth_mm2"]),
                    float(row["crack_area_mm2"]) - initial, delta=1e-8)

    def test_boundaries_against_what_sheets_join(self):
        for output in ("whole", "block", "slit"):
            rows = [row for row in table_of(self.path(output), "events.csv")
                    if row["boundary"]]
            self.assertEqual([(row["step"], row["boundary"]) for row in rows],
                             self.joined_first(output), output)
            for row in rows if output != "slit" else ():
                direction, position = PLANES[row["boundary"]]
                place = place_of(row)
                self.assertAlmostEqual(place[direction], position, delta=1e-6)
                self.assertAlmostEqual(place[1], 0.6, delta=1.5 * CELL)
        self.assertEqual([(row["event"], row["boundary"]) for row in self.events
                          if row["boundary"]],
                         [("start", "back"), ("start", "front"), ("start", "left"),
                          ("boundary", "right")])

    def test_separation(self):
        for output in ("whole", "block"):
            summary = strict_json(self.path(output), "summary.json")
            self.assertIs(summary["separated"], True)
            # which ends the run
            self.assertEqual([int(row["step"]) for row in
                              self.of_kind("separation", output)], [summary["steps"]])

    def test_an_initial_crack_begins_to_grow(self):
        (onset,) = self.of_kind("onset")
        # only then does anybody know where it began
        sheets = table_of(self.path("whole"), "crack_sheet.csv")
        self.assertEqual(onset["step"],
                         next(row["step"] for row in sheets if row["start"]))
        x, y, z = place_of(onset)
        # a node of the disc, the nearest to what broke first
        self.assertEqual(y, 0.6)
        self.assertLess(abs((x ** 2 + (z - 0.2) ** 2) ** 0.5 - 0.5), CELL)

    def test_onset_in_a_body_without_a_crack(self):
        (onset,) = self.of_kind("onset", "block")
        # the first step in which a node is broken
        smallest = {row["step"]: float(row["min_phase_field"])
                    for row in table_of(self.path("block"), "statistics.csv")}
        self.assertEqual(onset["step"],
                         next(step for step, value in smallest.items() if value < 0.3))
        self.assertLess(math.dist(place_of(onset), WEAK_AT), 1.5 * CELL)
        summary = strict_json(self.path("block"), "summary.json")
        self.assertEqual(summary["events"][1]["z_mm"], float(onset["z_mm"]))

    def test_fields_and_lines(self):
        with_fields = steps_with_fields(self.path("whole"))
        self.assertLessEqual({int(row["step"]) for row in self.events}, with_fields)
        lines = re.findall(r"^  event: (.*)$", text_of(self.path("whole"), "log.txt"),
                           re.M)
        self.assertEqual(len(lines), len(self.events) - len(self.of_kind("start")))
        self.assertTrue(any(re.fullmatch(r"a crack meets right at \(1, .*, .*\) mm", line)
                            for line in lines), lines)
        self.assertTrue(any(re.fullmatch(r"the cracks have grown by .* mm\^2 to .* mm\^2",
                                         line) for line in lines), lines)
        self.assertIn("events.csv",
                      text_of(self.path("whole"), "run_files.txt").split())
        told = strict_json(self.path("whole"), "summary.json")["events"]
        self.assertEqual([(str(entry["step"]), entry["event"]) for entry in told],
                         [(row["step"], row["event"]) for row in self.events])

    def test_two_ranks(self):
        self.run_it("two", ranks=2)
        self.expect_same("two")
        self.run_it("two", "--overwrite", settings=WHOLE_BLOCK, ranks=2)
        self.expect_same("two", "block")
        self.run_it("two", "--overwrite", case=SLIT, settings=NO_FIELDS, ranks=2)
        self.expect_same("two", "slit")

    def test_killed_and_resumed(self):
        # when its first crack has grown
        n_rows = len(self.of_kind("start")) + 1
        killed_after_rows(
            [*command(PROGRAM[0]), *as_options(WATCHED), "--output", "killed",
             "case.prm"], self.path("killed"), "events.csv", n_rows, cwd=self.folder)
        if not os.path.exists(os.path.join(self.path("killed"), "summary.json")):
            # rows of steps that will be computed again
            with open(os.path.join(self.path("killed"), "events.csv"), "a",
                      encoding="utf-8") as table:
                table.write("99,1,1,1,separation,1,1,,,,\n")
            self.run_it("killed", "--resume", ranks=2)
        self.expect_same("killed")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    PROGRAM[:] = [os.path.abspath(sys.argv[1]), *sys.argv[2:]]
    unittest.main(argv=sys.argv[:1])
