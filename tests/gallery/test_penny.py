#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A penny in nearly incompressible rubber under tension: opening and volume come to the
exact solution of an unbounded body in proportion to the size of cells.

usage: test_penny.py EXECUTABLE RANKS MPIRUN
"""
import csv
import math
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

EXECUTABLE, RANKS, MPIRUN = sys.argv[1], sys.argv[2], sys.argv[3:]
CASE = pathlib.Path(__file__).resolve().parents[2] / "parameters" / "benchmarks" \
    / "penny_tension.prm"
BOXES = ["0,0,0 : 4,4,4 : 1", "0,0,0 : 2.5,1.5,2.5 : 2", "0,0,0 : 1.75,0.75,1.75 : 3",
         "0,0,0 : 1.375,0.375,1.375 : 4", "0,0,0 : 1.25,0.25,1.25 : 5"]
# of an eighth of the body, see the case
NU = 0.4999
OPENING = 4e-3 * (1. - NU**2) / math.pi
VOLUME = 2e-3 * (1. - NU**2) / 3.


class Penny(unittest.TestCase):
    def measured(self, n_levels):
        """(opening in the middle, volume) over the exact ones, less 1"""
        with tempfile.TemporaryDirectory() as folder:
            program.output_of(
                [*program.command(EXECUTABLE, MPIRUN, RANKS), str(CASE), "--output",
                 folder + "/run",
                 *program.as_options(["Output/Field format=none",
                                      "Mesh/Refined boxes="
                                      + " ; ".join(BOXES[:n_levels])])])
            volume = float(program.rows(folder + "/run")[-1]["crack_volume_mm3"])
            with open(folder + "/run/crack_opening.csv", newline="") as stream:
                table = list(csv.DictReader(stream))
        first = [row for row in table if row["step"] == table[-1]["step"]][0]
        return float(first["opening_mm"]) / OPENING - 1., volume / VOLUME - 1.

    # first order, the volume with something left of the second
    def test_errors_fall_with_h(self):
        coarse, fine = self.measured(4), self.measured(5)
        for before, after in zip(coarse, fine):
            self.assertLess(0., after)
            self.assertLess(after, 0.7 * before, (coarse, fine))
            self.assertLess(after, 0.3, (coarse, fine))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
