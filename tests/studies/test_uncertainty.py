#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py uncertainty with a strip whose answers are formulas."""
import math
import unittest

import common


class Uncertainty(common.Case):
    def test_of_a_parameter_file(self):
        output, errors = self.study(
            "uncertainty", "strip.prm", "--output", "u", "--jobs", "2", "--parameters",
            "Material/Shear modulus", "Material/Critical energy release rate", "--by",
            "21", "--", "--set", "Geometry/Punctured strip/Notch height=9")
        text = self.text("u", "uncertainty.md")
        self.assertIn(text, output)
        # 10 sqrt(4 * 16) = 80 N; 21 % up is 10 % of the root, down 11.1 %
        down = 80. * (1. - math.sqrt(0.79))
        for line in ("| as it is | 80 |  | 20 |  |  |  | through hole, start: notch |",
                     "| Material/Shear modulus: plus | 88 | +8 (+10 %) | 20 | +0 (+0 %) "
                     "| 0 | 0 | through hole, start: notch |",
                     # the step is 0.3 s shorter or 0.6 s longer: -0.6 %, +1.2 %
                     "| load steps: half | 79.52 | -0.48 (-0.6 %) | 20 | +0 (+0 %) | 0 "
                     "| 0 | through hole, start: notch |",
                     "| load steps | 0.96 (1.2 %) | 0 (0 %) | 0 |",
                     "| Material/Shear modulus | %.3g (%.2g %%) | 0 (0 %%) | 0 |"
                     % (down, down / 0.8),
                     "| **parameters** | %.3g (%.2g %%) | 0 (0 %%) | 0 |"
                     % (math.sqrt(2.) * down, math.sqrt(2.) * down / 0.8)):
            self.assertIn(line, text.splitlines())
        self.assertEqual(len(self.starts()), 12)
        # what the program refuses is left out
        self.assertIn("left out: mesh: mirrored_in_y", errors)
        self.assertIn("their own mirror image", errors)
        # a level more turns the path about (0, 9), from (20, 10) to (20, 9): half of 1
        # on average but for the angle, and no more than 1 at the end
        row = next(line for line in text.splitlines() if line.startswith("| h/l: half"))
        mean, hausdorff = (float(cell) for cell in row.split("|")[6:8])
        self.assertAlmostEqual(mean, 0.5, delta=0.01)
        self.assertAlmostEqual(hausdorff, 1., delta=0.01)
        figure = self.text("u", "uncertainty.svg")
        for word in (">as it is<", ">mesh: mirrored in x<", ">h/l: two thirds<",
                     ">Shear modulus: minus<", ">Displacement (mm)<"):
            self.assertIn(word, figure)

    def test_of_a_run_of_a_sweep(self):
        self.write("strip.prm", "subsection Model\n  set Coupling = lagged\nend\n")
        self.write("a.sweep", "base = strip.prm\na =\nb =\n")
        errors = self.refused("uncertainty", "a.sweep")
        self.assertIn("expected one case", errors)
        output, _ = self.study("uncertainty", "a.sweep", "--only", "b", "--output", "u")
        # what is not iterated has no tolerance
        self.assertNotIn("coupling", output)
        self.assertEqual(len(self.starts()), 6)
        self.study("uncertainty", "a.sweep", "--only", "b", "--output", "u")
        self.assertEqual(len(self.starts()), 6)

    def test_failed_variations(self):
        # it fails with cells of 0.8 mm
        self.write("strip.prm", "subsection Model\n  set Fails with cells below = 1\n"
                   "end\n")
        output, _ = self.study("uncertainty", "strip.prm", "--output", "u", status=1)
        self.assertIn("- Without an answer: h_over_l_two_thirds.", output)
        self.assertIn("failed", self.text("u", "sweep.csv"))

    def test_what_is_wrong_is_named(self):
        for arguments, word in ((("--parameters", "Material/Nu"), "no entry of the case"),
                                (("--by", "0"), "--by"), (("--no-wait",), "--no-wait"),
                                (("--figure", "a.pdf"), "--figure"),
                                (("--figure", "no/a.svg"), "no directory")):
            self.assertIn(word, self.refused("uncertainty", "strip.prm", *arguments))
        self.assertEqual(self.starts(), [])


if __name__ == "__main__":
    unittest.main()
