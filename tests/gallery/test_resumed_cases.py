#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs that are continued: with a prescribed phase field at points, on a mesh of cut
simplices, with forces on sets of points. Follower pressure with a crack, with both
linear solvers.

usage: test_resumed_cases.py EXECUTABLE RANKS MPIRUN
"""
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

EXECUTABLE, RANKS, MPIRUN = sys.argv[1], int(sys.argv[2]), sys.argv[3]
GALLERY = pathlib.Path(__file__).resolve().parents[2] / "parameters" / "gallery"


class Runs(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def start(self, case, directory, *settings, options=(), status=0, ranks=RANKS):
        program.runner(EXECUTABLE, MPIRUN, ranks).output_of(
            [GALLERY / (case + ".prm"), "--output", self.folder / directory, *options,
             *program.as_options(["Output/Field format=none", *settings])], status)
        return program.rows(self.folder / directory)

    def compare(self, rows, expected, part):
        self.assertEqual(len(rows), len(expected))
        for name in expected[0]:
            if name not in rows[0]:
                continue
            largest = max(abs(float(row[name] or 0.)) for row in expected)
            for row, other in zip(rows, expected):
                self.assertLessEqual(
                    abs(float(row[name] or 0.) - float(other[name] or 0.)),
                    part * largest + 1e-12, (name, row["time_s"]))

    def check_resumed(self, case, settings, half, names):
        whole = self.start(case, "whole", *settings)
        self.start(case, "parts", *settings, half)
        # on as many ranks as there were not
        parts = self.start(case, "parts", *settings, options=["--resume"],
                           ranks=3 - RANKS)
        self.compare([{name: row[name] for name in names} for row in parts],
                     [{name: row[name] for name in names} for row in whole], 1e-6)
        return whole


class Resumed(Runs):
    def test_phase_field_at_points(self):
        steps = ["Load stepping/First step=0.25", "Load stepping/Largest step=0.25",
                 "Load stepping/Onset step=0.1", "Load stepping/Largest phase-field change=0",
                 "Boundary conditions/Phase field at points=5, 0 : 1 - t"]
        rows = self.check_resumed(
            "three_point_points", steps, "Load stepping/End time=0.5",
            ("time_s", "min_phase_field", "crack_energy_mJ", "load_y_mm",
             "reaction_1_y_N", "external_work_mJ"))
        for row in rows:
            self.assertAlmostEqual(float(row["min_phase_field"]),
                                   1. - float(row["time_s"]), delta=1e-9)
        self.assertEqual(len(rows), 5)

    def test_cut_simplices(self):
        steps = ["Load stepping/First step=0.25", "Load stepping/Largest step=0.25",
                 "Mesh/Global refinements=1"]
        rows = self.check_resumed(
            "plate_of_triangles", steps, "Load stepping/End time=0.5",
            ("time_s", "cells", "force_y_N", "elastic_energy_mJ", "external_work_mJ"))
        self.assertAlmostEqual(float(rows[-1]["force_y_N"]) / 46.15385, 1., delta=1e-6)

    def test_forces_on_sets(self):
        self.check_resumed(
            "point_forces", ["Load stepping/First step=0.25",
                             "Load stepping/Largest step=0.25"],
            "Load stepping/End time=0.5",
            ("time_s", "end_x_mm", "left_force_x_N", "external_work_mJ"))


# a crack from within the wall of an inflated tube
CRACKED = [
    "Model/Formulation=displacement", "Model/Crack density=AT1",
    "Material/Bulk modulus=5",
    "Material/Critical energy release rate=0.4", "Initial cracks/Cracks=0.6, 0.6 : 1, 1",
    "Load stepping/Largest phase-field change=0", "Load stepping/First step=0.02",
    "Load stepping/Largest step=0.02", "Load stepping/Onset step=0.01"]


class FollowerPressure(Runs):
    """Together with a crack, at finite strain. Whatever the shape of the wall and of
    the crack in it, the pressure on a quarter is p times the side of the hole that
    is open in the deformed body."""

    def check_balance(self, rows, part):
        for row in (dict((name, float(value or 0.)) for name, value in line.items())
                    for line in rows[1:]):
            force = 0.428228 * row["time_s"] * (1. + row["inner_x_mm"])
            self.assertAlmostEqual(row["inner_force_x_N"] / force, 1., delta=part)
            self.assertAlmostEqual(row["left_force_x_N"] / force, -1., delta=part)

    def test_both_solvers(self):
        end = "Load stepping/End time=0.14"
        direct = self.start("inflated_rubber_tube", "direct", *CRACKED, end)
        iterative = self.start("inflated_rubber_tube", "iterative", *CRACKED, end,
                               "Linear solver/Name=block AMG")
        for rows in (direct, iterative):
            self.check_balance(rows, 1e-6)
            last = {name: float(value or 0.) for name, value in rows[-1].items()}
            # over-relaxed, the coupling went to and fro for ever at t = 0.1
            self.assertEqual(last["rejected_steps"], 0)
            # it opens, and what the load does is stored or spent on damage
            first = float(rows[0]["crack_energy_mJ"])
            self.assertGreater(last["crack_energy_mJ"], first)
            self.assertAlmostEqual(
                (last["elastic_energy_mJ"] + last["crack_energy_mJ"] - first)
                / last["external_work_mJ"], 1., delta=0.005)
        self.compare([{name: row[name] for name in ("time_s", "inner_x_mm",
                                                    "elastic_energy_mJ")}
                      for row in iterative], direct, 1e-4)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
