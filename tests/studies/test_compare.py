#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py compare with runs whose curves and paths are formulas."""
import os
import sys
import unittest

import common

sys.path.insert(0, os.path.join(common.HERE, os.pardir, "report"))
import synthetic_run  # noqa: E402


def write_run(directory, peak, path=((0., 10.), (20., 10.)), separated=True):
    """A straight rise to the peak (N) at 20 mm, then nothing at 20 mm."""
    os.makedirs(directory)
    rows = ["step,time_s,displacement_mm,force_x_N,force_y_N", "0,0,0,0,0",
            "1,1,20,0,%g" % peak, "2,2,20,0,0"]
    synthetic_run.write(os.path.join(directory, "statistics.csv"),
                        "\n".join(rows) + "\n")
    synthetic_run.write_summary(directory, peak_force_N=peak, thickness_mm=2.,
                                displacement_at_peak_mm=20., separated=separated)
    synthetic_run.write_fields(directory)
    synthetic_run.write(os.path.join(directory, "crack_path.csv"),
                        "step,crack,x_mm,y_mm\n%s# end\n" % "".join(
                            "2,0,%g,%g\n" % point for point in path))


class Compare(common.Case):
    def setUp(self):
        super().setUp()
        write_run(self.path("out", "soft_12"), 100.)
        write_run(self.path("out", "hard_12"), 200.)

    def compare(self, *arguments, status=0):
        return self.called("compare", "out", "--reference", *arguments, status=status)

    def rows(self):
        return {(row["run"], row["quantity"]): row
                for row in self.table("out", "comparison.csv")}

    def test_peaks_with_scatter_in_three_forms(self):
        for header, values in (
                ("displacement_minus_mm,displacement_plus_mm,force_minus,force_plus",
                 "1,2,30,20"), ("displacement_min_mm,displacement_max_mm,force_min,"
                                "force_max", "18,21,80,130")):
            self.write("e.csv", "name,displacement_mm,force_N,%s\n12,19,110,%s\n"
                       % (header, values))
            output, _ = self.compare("e.csv")
            self.assertIn("| soft_12 | 20 | 19 (18 to 21) | +5.3 %, within | 100 | "
                          "110 (80 to 130) | -9.1 %, within |", output)
            self.assertIn("- hard: 1 of 2 figures lie within the scatter.", output)
        # a standard deviation, once and twice
        self.write("e.csv", "displacement_mm,force_N,force_sd\n19,110,6\n")
        self.assertIn("110 (104 to 116) | -9.1 %, **outside** |", self.compare("e.csv")[0])
        self.assertIn("110 (98 to 122) | -9.1 %, within |",
                      self.compare("e.csv", "--deviations", "2")[0])
        row = self.rows()["soft_12", "peak"]
        self.assertEqual((row["computed"], row["reference"], row["low"], row["high"],
                          row["inside"], row["unit"]),
                         ("100", "110", "98", "122", "1", "N"))
        # per thickness: 50 and 100 N/mm
        self.write("e.csv", "displacement_mm,force_N_per_mm\n20,50\n")
        self.assertIn("| hard_12 | 20 | 20 | +0.0 % | 100 | 50 | +100.0 % |",
                      self.compare("e.csv")[0])

    def test_curves(self):
        # 120 at 20 mm: off by a sixth everywhere; the mean of the sizes is the same
        self.write("c.csv", "name,displacement_mm,force_N,force_min,force_max\n"
                   "soft_12,0,0,-1,1\nsoft_12,10,60,45,70\nsoft_12,20,120,110,130\n")
        output, _ = self.compare("c.csv", "--tolerance", "curve=17%", "area=17%")
        row = self.rows()["soft_12", "curve"]
        self.assertAlmostEqual(float(row["computed"]), 1. / 6., 8)
        # at 0 and 10 mm within, at 20 mm outside
        self.assertAlmostEqual(float(row["inside"]), 2. / 3., 8)
        self.assertEqual(row["tolerance_met"], "true")
        self.assertAlmostEqual(float(self.rows()["soft_12", "area"]["computed"]),
                               1. / 6., 8)
        self.assertIn("| soft_12 | 16.7 %, **outside** (67 % within) | 16.7 % | – | – |",
                      output)
        # a body that has come apart carries nothing: half of the area is missing
        self.write("c.csv", "name,displacement_mm,force_N\nsoft_12,0,0\nsoft_12,20,100\n"
                   "soft_12,20,50\nsoft_12,40,50\n")
        self.compare("c.csv")
        self.assertAlmostEqual(float(self.rows()["soft_12", "area"]["computed"]), 0.5)

    def test_paths(self):
        # parallel, 1 mm above, of the same length
        self.write("p.csv", "x_mm,y_mm,scatter_mm\n0,11,0.5\n20,11,0.5\n")
        output, _ = self.compare("p.csv")
        self.assertIn("| soft_12 | – | – | 1, **outside** (0 % within) | 1 |", output)
        # to the middle only: from there to the end 0 to 10 mm, half of the length
        self.write("p.csv", "name,x_mm,y_mm\nsoft_12,0,10\nsoft_12,10,10\n")
        self.compare("p.csv")
        rows = self.rows()
        self.assertAlmostEqual(float(rows["soft_12", "path"]["computed"]), 1.25, 3)
        self.assertEqual(float(rows["soft_12", "hausdorff"]["computed"]), 10.)
        self.assertNotIn(("hard_12", "path"), rows)

    def test_tolerances_decide(self):
        self.write("e.csv", "name,displacement_mm,force_N,force_sd\n12,20,104,1\n")
        self.compare("e.csv", "--only", "soft_12", "--tolerance", "peak=5%",
                     "displacement=0.01", "scatter=1")
        for words, said in ((("peak=1%",), "soft_12: peak is off by -0.0385"),
                            (("peak=5%",), "hard_12: peak is off by +0.923"),
                            (("scatter=1",), "scatter: 2 figures lie outside"),
                            (("path=1",), "path: no run has such a reference")):
            output, _ = self.compare("e.csv", "--tolerance", *words, status=1)
            self.assertIn("- Tolerance not met: " + said, output)
        self.write("e.csv", "name,displacement_mm,force_N\nsoft_12,20,100\n")
        os.remove(self.path("out", "soft_12", "crack_path.csv"))
        self.write("p.csv", "x_mm,y_mm\n0,11\n20,11\n")
        output, _ = self.compare("e.csv", "p.csv", "--tolerance", "path=2", status=1)
        self.assertIn("soft_12: path is not known", output)

    def test_figures(self):
        self.write("e.csv", "name,displacement_mm,force_N,force_sd\nsoft_12,19,110,5\n")
        self.write("p.csv", "name,x_mm,y_mm\nhard_12,0,11\nhard_12,20,11\n")
        self.compare("e.csv", "p.csv")
        self.assertEqual(sorted(os.listdir(self.path("out", "comparison"))),
                         ["hard_12.svg", "soft_12.svg"])
        text = self.text("out", "comparison", "soft_12.svg")
        for word in (">soft_12<", ">reference, peak<", ">Force (N)<"):
            self.assertIn(word, text)
        self.compare("e.csv", "--figures", "f", "--format", "png")
        self.assertEqual(os.listdir(self.path("f")), ["soft_12.png"])

    def test_a_sweep_file(self):
        self.write("a.sweep", "base = strip.prm\nlow_9 = --set \"%s=9\"\nlow_7 = --set "
                   "\"%s=7\"\n" % (common.HEIGHT, common.HEIGHT))
        self.write("e.csv", "name,displacement_mm,force_N\n9,20,80\n7,20,80\n")
        arguments = ("a.sweep", "--program", common.PROGRAM, "--output", "s",
                     "--reference", "e.csv")
        self.assertIn("no case of a.sweep has been run", self.called(
            "compare", *arguments, status=2)[1])
        self.study("run", "a.sweep", "--only", "low_9", "--output", "s")
        output, errors = self.called("compare", *arguments)
        self.assertIn("| low_9 | 20 | 20 | +0.0 % | 80 | 80 | +0.0 % |", output)
        self.assertIn("low_7: there is nothing to compare yet", errors)
        # what is missing does not meet a tolerance
        output, _ = self.called("compare", *arguments, "--tolerance", "peak=1%",
                                status=1)
        self.assertIn("low_7 has not been run", output)
        self.study("run", "a.sweep", "--output", "s")
        self.called("compare", *arguments, "--tolerance", "peak=1%")

    def test_names_that_lead_elsewhere(self):
        self.write("e.csv", "displacement_mm,force_N\n20,100\n")
        # results of other parameters are none; without links the table tells the place
        os.makedirs(self.path("out", "cases"))
        os.rename(self.path("out", "hard_12"), self.path("out", "cases", "1a"))
        self.write(os.path.join("out", "sweep.csv"), "name,state,case_id\n"
                   "soft_12,stale,2b\nhard_12,complete,1a\n")
        self.compare("e.csv")
        self.assertEqual({run for run, _ in self.rows()}, {"hard_12"})

    def test_what_is_wrong_is_named(self):
        self.write("good.csv", "displacement_mm,force_N\n20,100\n")
        for text, word in (
                ("a,b\n1,2\n", "expected a header"),
                ("x_mm,y_mm\n1,2\n", "two points"), ("x_mm,y_mm\n1,a\n", "p.csv:2:"),
                ("displacement_mm,force_N\n20,1\n10,2\n", "goes back from 20 to 10"),
                ("displacement_mm,force_N,force_min\n1,1,1\n", "there is no force_max"),
                ("displacement_mm,force_N,force_min,force_max\n1,1,2,1\n",
                 "is above the largest"),
                ("displacement_mm,force_N,force_sd\n1,1,-1\n", "not below 0"),
                ("displacement_mm,force_N,force_sd,force_min\n1,1,1,1\n", "given twice"),
                ("displacement_mm,force_N\n1,1,1\n", "expected 2 fields"),
                ("name,displacement_mm,force_N\nother,1,1\n", "no run has a reference")):
            self.write("p.csv", text)
            errors = self.compare("p.csv", status=2)[1]
            self.assertIn(word, errors)
            self.assertEqual(errors.count("\n"), 1)
        for arguments, word in ((("none.csv",), "cannot be read"),
                                (("good.csv", "good.csv"), "given twice"),
                                (("good.csv", "--tolerance", "peak"), "--tolerance"),
                                (("good.csv", "--tolerance", "weight=1"), "--tolerance"),
                                (("good.csv", "--deviations", "0"), "--deviations")):
            self.assertIn(word, self.compare(*arguments, status=2)[1])
        self.assertFalse(os.path.exists(self.path("out", "comparison.md")))


if __name__ == "__main__":
    unittest.main()
