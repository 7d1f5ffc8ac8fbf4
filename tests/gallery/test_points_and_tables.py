#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Cases of parameters/gallery that are held and loaded at points, over time by a
table, and by symmetry, beside exact values.

usage: test_points_and_tables.py EXECUTABLE RANKS MPIRUN
"""

import pathlib
import shutil
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402
from compact_mesh import compact_mesh  # noqa: E402

EXECUTABLE, RANKS, MPIRUN = sys.argv[1], int(sys.argv[2]), sys.argv[3]
GALLERY = pathlib.Path(__file__).resolve().parents[2] / "parameters" / "gallery"


class Case(unittest.TestCase):
    kept = {}  # rows of what several tests look at

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.results = pathlib.Path(self.folder.name) / "results"

    def look_at_case(self, name):
        """A run of a case as it stands, made once."""
        if name not in self.kept:
            self.run_case(name)
            self.kept[name] = self.rows
            shutil.rmtree(self.results)
        self.rows = self.kept[name]
        self.last = self.rows[-1]

    def run_case(self, name, *settings, options=(), status=0):
        text = program.runner(EXECUTABLE, MPIRUN, RANKS).output_of(
            [name, "--output", self.results, *options,
             *program.as_options(["Output/Field format=none", *settings])], status)
        if status in (0, 5):
            self.rows = [{key: float(value) for key, value in row.items()}
                         for row in program.rows(self.results)]
            self.last = self.rows[-1]
        return text


class Points(Case):
    """Supports and loads at single points."""

    def test_a_beam_bends_as_beams_do(self):
        self.look_at_case(GALLERY / "three_point_points.prm")
        P, L, E, nu, b, h = 100., 20., 1000., 0.3, 5., 2.
        k = 10 * (1 + nu) / (12 + 11 * nu)
        deflection = P * L**3 / (48 * E * b * h**3 / 12) + \
            P * L / (4 * k * E / (2 * (1 + nu)) * b * h)
        found = (self.last["left_y_mm"] + self.last["right_y_mm"]) / 2 \
            - self.last["middle_y_mm"]
        self.assertAlmostEqual(found / deflection, 1., delta=0.02)

    def test_reactions_balance_the_load(self):
        self.look_at_case(GALLERY / "three_point_points.prm")
        for row in self.rows:
            load = 100. * row["time_s"]
            for name in ("reaction_1_y_N", "reaction_2_y_N"):
                self.assertAlmostEqual(row[name], load / 2, delta=1e-6)
            self.assertAlmostEqual(row["reaction_1_x_N"], 0., delta=1e-6)
        self.assertNotIn("reaction_2_x_N", self.last)

    def test_the_force_does_the_work_that_is_stored(self):
        self.look_at_case(GALLERY / "three_point_points.prm")
        work = -0.5 * 100. * self.last["load_y_mm"]
        self.assertAlmostEqual(self.last["external_work_mJ"] / work, 1., delta=1e-8)
        self.assertAlmostEqual(self.last["elastic_energy_mJ"] / work, 1., delta=1e-6)
        self.assertAlmostEqual(self.last["energy_imbalance_mJ"] / work, 0., delta=1e-6)

    def test_a_force_is_the_reaction_of_a_displacement(self):
        self.look_at_case(GALLERY / "three_point_points.prm")
        sunk = self.last["load_y_mm"]
        self.run_case(GALLERY / "three_point_points.prm",
                      "Boundary conditions/Force at points=",
                      "Boundary conditions/Displacement at points=0, 0 : all : 0 ; "
                      "20, 0 : y : 0 ; 10, 2 : y : %.12g*t" % sunk)
        self.assertAlmostEqual(self.last["reaction_3_y_N"], -100., delta=1e-5)
        self.assertAlmostEqual(self.last["force_y_N"], -100., delta=1e-5)
        self.assertAlmostEqual(sum(self.last["reaction_%d_y_N" % n]
                                   for n in (1, 2, 3)), 0., delta=1e-6)

    def test_the_phase_field_is_as_prescribed(self):
        self.run_case(GALLERY / "three_point_points.prm",
                      "Boundary conditions/Phase field at points=10, 0 : 1 - t/2")
        self.assertAlmostEqual(self.last["min_phase_field"], 0.5, delta=1e-9)

    def test_a_resumed_run_has_all_rows(self):
        case = GALLERY / "three_point_points.prm"
        self.run_case(case, "Boundary conditions/Force at points=10, 2 : y : -100*t^2")
        whole = self.rows
        shutil.rmtree(self.results)
        half = ["Boundary conditions/Force at points=10, 2 : y : -100*t^2"]
        self.run_case(case, *half, "Load stepping/End time=0.5")
        self.run_case(case, *half, options=["--resume"])
        for row, expected in zip(self.rows, whole):
            for name in ("time_s", "reaction_1_y_N", "reaction_2_y_N", "load_y_mm",
                         "external_work_mJ"):
                self.assertAlmostEqual(row[name], expected[name], delta=1e-6)
        self.assertEqual(len(self.rows), len(whole))


class CompactTension(Case):
    """Toughness by the formula of the standard."""

    def energy(self, crack_length):
        mesh = pathlib.Path(self.folder.name) / "compact.msh"
        mesh.write_text(compact_mesh(crack_length), encoding="utf-8")
        self.run_case(GALLERY / "compact_tension.prm",
                      "Geometry/Mesh file/File name=%s" % mesh,
                      "Mesh/Refined discs=%d, 0 : 5 : 2" % crack_length)
        shutil.rmtree(self.results)
        return self.last["elastic_energy_mJ"]

    def test_the_stress_intensity_is_that_of_E399(self):
        E, nu, B, W, P, x = 210000., 0.3, 20., 40., 1000., 0.5
        release_rate = (self.energy(22) - self.energy(18)) / (4. * B)
        f = (2 + x) * (0.886 + 4.64 * x - 13.32 * x**2 + 14.72 * x**3 - 5.6 * x**4) \
            / (1 - x)**1.5
        K = (E / (1 - nu**2) * release_rate)**0.5
        self.assertAlmostEqual(K / (P / (B * W**0.5) * f), 1., delta=0.03)

    def test_only_the_pins_carry(self):
        self.run_case(GALLERY / "compact_tension.prm")
        for name in ("reaction_1_x_N", "reaction_1_y_N", "reaction_2_y_N"):
            self.assertAlmostEqual(self.last[name], 0., delta=1e-3)


class CompactTensionFracture(Case):
    """Onset of a crack in the specimen, pulled by rigid pins."""

    def test_it_breaks_at_its_toughness(self):
        self.run_case(GALLERY / "compact_tension_fracture.prm")
        force = max(row["reaction_upper_pin_y_N"] for row in self.rows)
        E, nu, B, W, x = 210000., 0.3, 20., 40., 0.5
        f = (2 + x) * (0.886 + 4.64 * x - 13.32 * x**2 + 14.72 * x**3 - 5.6 * x**4) \
            / (1 - x)**1.5
        tough = (E / (1 - nu**2) * 2.7 * (1 + 3. / 8. / 4.))**0.5
        self.assertAlmostEqual(force / (B * W**0.5) * f / tough, 1., delta=0.03)
        # it has run, and the pins carry all of it
        self.assertLess(self.last["reaction_upper_pin_y_N"], 0.96 * force)
        for row in self.rows:
            self.assertAlmostEqual(row["reaction_upper_pin_y_N"],
                                   -row["reaction_lower_pin_y_N"], delta=1e-3)
            for name in ("reaction_1_x_N", "reaction_2_x_N"):
                self.assertAlmostEqual(row[name], 0., delta=0.01 * force)


class Tables(Case):
    """Loads over time from a file."""

    def test_the_load_is_that_of_the_file(self):
        self.run_case(GALLERY / "load_table.prm")
        expected = {0.: 0., 0.5: 2., 1.: 4., 2.: 8., 2.5: 10., 3.: 10., 3.5: 7., 4.: 4.}
        found = {row["time_s"]: row["force_y_N"] for row in self.rows}
        for time, force in expected.items():
            self.assertAlmostEqual(found[time], force, delta=1e-7)

    def copy(self):
        for name in ("load_table.prm", "load.csv"):
            shutil.copy(GALLERY / name, self.folder.name)
        return pathlib.Path(self.folder.name) / "load_table.prm"

    def test_the_record_of_the_run_holds_the_path(self):
        case = self.copy()
        self.run_case(case)
        text = (self.results / "parameters.prm").read_text(encoding="utf-8")
        self.assertIn('table("%s")' % (case.parent / "load.csv"), text)
        first = self.rows
        again = pathlib.Path(self.folder.name) / "again.prm"
        again.write_text(text, encoding="utf-8")
        shutil.rmtree(self.results)
        self.run_case(again)
        self.assertEqual([row["force_y_N"] for row in first],
                         [row["force_y_N"] for row in self.rows])

    def identity(self, case):
        return program.output_of([EXECUTABLE, "--case-id", str(case)]).strip()

    def test_the_file_is_part_of_the_case(self):
        case = self.copy()
        self.assertEqual(self.identity(case),
                         self.identity(GALLERY / "load_table.prm"))
        self.run_case(case, "Load stepping/End time=2")
        table = case.parent / "load.csv"
        same = case.parent / "same.csv"
        shutil.copy(table, same)
        moved = 'Boundary conditions/Displacement=top : y : table("%s") ; ' \
            'bottom : y : 0' % same
        self.run_case(case, moved, options=["--resume"])
        before = self.identity(case)
        table.write_text(table.read_text(encoding="utf-8").replace("0.004", "0.005"),
                         encoding="utf-8")
        self.assertNotEqual(self.identity(case), before)
        text = self.run_case(case, options=["--resume"], status=2)
        self.assertIn("the case has changed", text)
        self.assertIn("Boundary conditions/Displacement", text)


class Symmetry(Case):
    """Half a body for the whole."""

    def test_a_quarter_is_half_the_force(self):
        self.run_case(GALLERY / "symmetric_quarter.prm")
        quarter = self.last
        shutil.rmtree(self.results)
        self.run_case(
            GALLERY / "symmetric_quarter.prm", "Geometry/Rectangle/Lower corner=-2, -1",
            "Boundary conditions/Displacement=top : y : 1e-3*(1 + x^2/4)*t ; "
            "bottom : y : -1e-3*(1 + x^2/4)*t",
            "Boundary conditions/Displacement at points=0, -1 : x : 0")
        for name, parts in (("force_y_N", 2), ("elastic_energy_mJ", 4)):
            self.assertAlmostEqual(self.last[name] / (parts * quarter[name]), 1.,
                                   delta=1e-8)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
