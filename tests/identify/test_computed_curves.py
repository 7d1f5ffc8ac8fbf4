#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""scripts/identify.py --tear on curves that the program computes: the pure-shear
specimen of parameters/finite_strain/pure_shear.prm with cracks that cannot grow.

    test_computed_curves.py MIXED_CRACKS

The energy release rate of a strip between clamps is G = W h0 (Rivlin and Thomas,
J. Polym. Sci. 10 (1953)), neo-Hookean W = mu/2 (s - 1/s)^2 at the stretch s: 17.0
N/mm at 11.676 mm. The energy difference of two cracks is to be within 2 % of it, W h0
of a specimen that contracts at its free edges within 4 %.
"""
import json
import pathlib
import sys
import tempfile
import unittest

from common import called, skip_without_scipy

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from program import as_options, output_of  # noqa: E402

CASE = (pathlib.Path(__file__).resolve().parents[2] / "parameters" / "finite_strain" /
        "pure_shear.prm")
MU, HEIGHT, DISPLACEMENT = 2.40, 28., 11.676
NOT_TO_GROW = ("Material/Critical energy release rate=1e9",
               "Load stepping/Stop at onset=false",
               f"Load stepping/End time={DISPLACEMENT}",
               f"Load stepping/First step={DISPLACEMENT / 10}",
               f"Load stepping/Largest step={DISPLACEMENT / 10}",
               f"Load stepping/Onset step={DISPLACEMENT / 10}",
               "Mesh/Adaptation=none", "Mesh/Adaptive levels=0",
               "Mesh/Refined surroundings=notch tip : 3 : 2", "Output/Fields every=100")
WITHOUT_A_CRACK = ("Geometry/Punctured strip/Notch length=0",
                   "Mesh/Refined surroundings=")


class ComputedCurves(unittest.TestCase):
    def run_with(self, name, *settings):
        directory = pathlib.Path(self.directory.name) / name
        output_of([EXECUTABLE, str(CASE), *as_options(NOT_TO_GROW + settings),
                   "--output", str(directory)])
        return str(directory)

    def setUp(self):
        skip_without_scipy()
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)

    def test_energy_release_rate_is_that_of_the_strip(self):
        curves = [f"{a}:" + self.run_with(f"a{a}",
                                          f"Geometry/Punctured strip/Notch length={a}")
                  for a in (45, 49)]
        curves.append("uncracked:" + self.run_with("whole", *WITHOUT_A_CRACK))
        found = called("--tear", "--width", "196", "--height", str(HEIGHT),
                       "--thickness", "1.8", "--onset", str(DISPLACEMENT), "--json", "-",
                       *curves)
        self.assertEqual(found.returncode, 0, found.stderr)
        stretch = 1. + DISPLACEMENT / HEIGHT
        expected = MU / 2. * (stretch - 1. / stretch)**2 * HEIGHT
        self.assertAlmostEqual(expected, 17., delta=0.01)
        points = json.loads(found.stdout)["points"]
        for method, share in (("energy difference", 0.02), ("W h0", 0.04)):
            rates = [point["G_N_per_mm"] for point in points
                     if point["method"] == method]
            self.assertTrue(rates, method)
            for rate in rates:
                self.assertAlmostEqual(rate, expected, delta=share * expected,
                                       msg=method)


if __name__ == "__main__":
    EXECUTABLE = sys.argv.pop()
    unittest.main()
