#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py bisect with a strip whose answer is known."""
import os
import unittest

import common

FILE = """base = strip.prm
soft =
hard = --set "Mesh/Adaptive levels=4"
"""


class Bisect(common.Case):
    def bisect(self, *more, file="a.sweep", status=0, vary=("6", "10")):
        return self.study("bisect", file, "--vary", common.HEIGHT, *vary, "--on",
                          "outcome", "--to", "0.1", *more, status=status)

    def test_both_materials(self):
        self.write("a.sweep", FILE)
        output, _ = self.bisect("--output", "b", "--figure", "b.svg")
        rows = {row["run"]: row for row in self.table("b", "bisect.csv")}
        for name, change in (("soft", 7.3), ("hard", 7.5)):
            low, high = (float(rows[name][key]) for key in ("low", "high"))
            self.assertLessEqual(high - low, 0.1)
            self.assertTrue(low <= change < high + 1e-9)
            self.assertEqual(rows[name]["low_answer"], "below hole")
            self.assertEqual(rows[name]["high_answer"], "through hole")
            # the cases that carry it
            for side in ("low", "high"):
                case = rows[name][side + "_case"]
                self.assertEqual(case, "%s_%.12g" % (name, float(rows[name][side])))
                self.assertEqual(os.path.realpath(self.path("b", case)),
                                 os.path.realpath(self.path(
                                     "b", "cases", rows[name][side + "_case_id"])))
        self.assertIn("Notch height = 7.28125 +- 0.03125", output)
        # 40 widths take 6 halvings
        self.assertEqual(len(self.starts()), 2 * (2 + 6))
        for word in (">soft<", ">below hole<", ">Notch height<"):
            self.assertIn(word, self.text("b.svg"))
        # every command works on the sweep of the bisection
        output, _ = self.called("plan", self.path("b", "bisect.sweep"), "--output", "b",
                                "--program", common.PROGRAM)
        self.assertIn("16 cases: 16 complete", output)

    def test_taken_up_again(self):
        self.write("a.sweep", FILE)
        self.bisect("--only", "soft")
        n_first = len(self.starts())
        # the same once more runs nothing; several at a time know it all as well
        self.bisect("--only", "soft")
        self.bisect("--only", "soft", "--jobs", "3")
        self.assertEqual(len(self.starts()), n_first)
        # narrower goes on from there
        self.study("bisect", "a.sweep", "--vary", common.HEIGHT, "6", "10", "--on",
                   "outcome", "--to", "0.05", "--only", "soft")
        self.assertEqual(len(self.starts()), n_first + 1)

    def test_a_parameter_file_and_a_bound(self):
        output, _ = self.study(
            "bisect", "strip.prm", "--vary", "Material/Shear modulus", "1", "9", "--on",
            "peak_force_N > 60", "--to", "0.5", "--", "--set", common.HEIGHT + "=9")
        # 10 sqrt(16 mu) = 60 at mu = 2.25
        self.assertIn("strip: 'not peak_force_N > 60' up to 2, 'peak_force_N > 60' from "
                      "2.5 on", output)
        self.assertEqual(set(self.starts()), {9.})

    def test_failed_runs(self):
        self.write("a.sweep", FILE + "common = --set 'Model/Fails from=7.9' "
                   "--set 'Model/Fails to=8.1'\n")
        output, _ = self.bisect("--only", "soft", "--output", "b")
        self.assertIn("without an answer: 8", output)
        row = self.table("b", "bisect.csv")[0]
        self.assertTrue(float(row["low"]) <= 7.3 < float(row["high"]))
        self.assertLessEqual(float(row["high"]) - float(row["low"]), 0.1)
        errors = self.bisect("--only", "soft", "--output", "c", vary=("8", "10"),
                             status=2)[1]
        self.assertIn("the run at 8 has failed", errors)

    def test_variations(self):
        self.write("a.sweep", FILE)
        output, _ = self.bisect("--only", "soft", "--variations", "--output", "b",
                                vary=("7", "8"))
        # finer cells move the change by 0.2, the mirrored mesh by 0.05
        changes = {line.split()[0]: float(line.split()[1])
                   for line in output.splitlines() if line.startswith("  ")
                   and len(line.split()) == 2}
        self.assertAlmostEqual(changes["h_over_l_half"], 0.2, delta=0.07)
        self.assertAlmostEqual(changes["mesh_mirrored_in_x"], 0.05, delta=0.07)
        self.assertEqual(changes["coupling_tenth"], 0.)
        self.assertEqual(len(changes), 7)

    def test_what_is_wrong_is_named(self):
        self.write("a.sweep", FILE)
        for arguments, word in (
                (("--vary", "x", "1", "2", "--on", "outcome", "--to", "1"), "--vary"),
                (("--vary", "a/b", "2", "1", "--on", "outcome", "--to", "1"), "--vary"),
                (("--vary", "a/b", "1", "2", "--on", "?", "--to", "1"), "--on"),
                (("--vary", "a/b", "1", "2", "--on", "outcome", "--to", "0"), "--to"),
                (("--vary", "a/b", "1", "2", "--on", "outcome", "--to", "1",
                  "--figure", "a.gif"), "--figure"),
                (("--vary", "a/b", "1", "2", "--on", "outcome", "--to", "1",
                  "--only", "none"), "no run of a.sweep is called 'none'")):
            self.assertIn(word, self.refused("bisect", "a.sweep", *arguments))
        self.assertEqual(self.starts(), [])
        self.assertIn("both give 'through hole'", self.bisect(
            vary=("8", "10"), status=2)[1])
        self.assertIn("no file", self.refused(
            "bisect", "none.prm", "--vary", "a/b", "1", "2", "--on", "outcome", "--to",
            "1"))


if __name__ == "__main__":
    unittest.main()
