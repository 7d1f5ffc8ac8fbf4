#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""parameters/gallery/plate_of_triangles.prm: the force is the exact one of an even
stretch, on triangles that were cut.

usage: test_cut_case.py EXECUTABLE RANKS MPIRUN
"""

import pathlib
import sys
import tempfile
import unittest

TESTS = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(TESTS))
import program  # noqa: E402

EXECUTABLE, RANKS, MPIRUN = sys.argv[1], sys.argv[2], sys.argv[3:]
CASE = TESTS.parent / "parameters" / "gallery" / "plate_of_triangles.prm"
EXACT = 210000. / (1. - 0.3**2) * 1e-4 * 2.  # N


class CutCase(unittest.TestCase):
    def test_force_is_exact(self):
        with tempfile.TemporaryDirectory() as folder:
            text = program.output_of(
                [*program.command(EXECUTABLE, MPIRUN, RANKS), str(CASE),
                 "--output", folder])
            self.assertIn("each cell of the file cut at its corners", text)
            row = program.rows(folder)[-1]
            self.assertEqual(float(row["time_s"]), 1.)
            # the stiffness of broken material is added to that of the whole one
            self.assertAlmostEqual(float(row["force_y_N"]) / EXACT, 1., delta=1e-6)
            self.assertAlmostEqual(float(row["min_phase_field"]), 1., delta=1e-9)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
