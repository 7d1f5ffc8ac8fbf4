#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The figures of a run are those of the state that doc/output.md says they are.

    test_figures.py EXECUTABLE MPIRUN RANKS

Columns are compared with sums done by hand here, for a square that stays even,
so that each unknown is one number.
"""

import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

PROGRAM = []
LAMBDA, MU, G_C, LENGTH, KAPPA, RELAXATION = 100., 80., 1., 1., 1e-3, 0.7

# steps so long that the lag shows
SQUARE = """
subsection Geometry
  set Name = rectangle
  subsection Rectangle
    set Lower corner = 0, 0
    set Upper corner = 2, 2
    set Cell size    = 1
  end
end
subsection Model
  set Crack density       = AT2
  set Energy split        = none
  set Kinematics          = plane strain
  set Length scale        = 1
  set Residual stiffness  = 1e-3
  set Relaxation constant = 0.7
end
subsection Material
  set Lame lambda   = 100
  set Shear modulus = 80
  set Critical energy release rate = 1
  set Thickness     = 3
end
subsection Boundary conditions
  set Displacement = bottom : y : 0 ; left : x : 0 ; right : x : 0 ; top : y : t
end
subsection Load stepping
  set End time      = 0.25
  set First step    = 0.05
  set Largest step  = 0.05
  set Onset step    = 0.05
  set Smallest step = 0.001
  set Largest phase-field change = 0
  set Force boundary = top
end
"""

# a fluid presses on the crack from the start; nothing changes afterwards
CRACK = """
subsection Geometry
  set Name = rectangle
  subsection Rectangle
    set Lower corner = -3, -3
    set Upper corner = 3, 3
    set Cell size    = 0.25
  end
end
subsection Model
  set Formulation        = displacement
  set Crack density      = AT2
  set Energy split       = none
  set Pressure law       = degraded bulk
  set Length scale       = 2*h
  set Residual stiffness = 1e-8
end
subsection Material
  set Young's modulus = 1
  set Poisson ratio   = 0.2
  set Critical energy release rate = 1
end
subsection Fluid
  set Pressure = 1e-3
end
subsection Boundary conditions
  set Displacement = left : all : 0 ; right : all : 0 ; bottom : all : 0 ; top : all : 0
end
subsection Initial cracks
  set Cracks     = -1,0 : 1,0
  set Half width = h
end
subsection Load stepping
  set End time      = 2
  set First step    = 1
  set Largest step  = 1
  set Onset step    = 1
  set Smallest step = 0.1
end
subsection Output
  set Crack volume = true
end
"""


class Run:
    """One finished run of a case with other settings."""

    def __init__(self, case, *settings, arguments=()):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "case.prm").write_text(case, encoding="utf-8")
            self.log = program.runner(*PROGRAM).output_of(
                [folder / "case.prm", "--output", folder / "results", *arguments,
                 *program.as_options((*settings, "Output/Field format=none"))])
            if "--check" in arguments:
                return
            results = folder / "results"
            self.rows = [{name: float(value) for name, value in row.items()}
                         for row in program.rows(results)]
            self.warnings = program.summary(results)["warnings"]

    def warns_of(self, words):
        return any(words in warning for warning in self.warnings)


class EvenSquare:
    """The same square on paper: strain t/2 in y, and nothing else moves."""

    AREA, THICKNESS, WIDTH = 4., 3., 2.

    def __init__(self, law, coupling):
        self.law, self.coupling = law, coupling
        self.phi, self.earlier = [1.], 1.
        self.force, self.stored, self.work = [0.], [0.], [0.]
        for i in range(1, 6):
            self.step(0.05 * i)

    @staticmethod
    def degradation(phi):
        return (1. - KAPPA) * phi * phi + KAPPA

    def bulk(self, g):
        """Volumetric stiffness of the stress, MPa."""
        if self.law == "relaxed bulk":
            return 1. / (1. / LAMBDA + (1. - g) / (g * RELAXATION * MU))
        return LAMBDA * (g * g if self.law == "degraded divergence" else g)

    def driving_bulk(self, g):
        """That of the pressure which drives the crack, MPa."""
        if self.law == "relaxed bulk":
            return self.bulk(g) / g
        return LAMBDA * (g if self.law == "degraded divergence" else 1.)

    def step(self, time):
        strain = time / 2.
        lagged = self.phi[-1]
        if self.coupling == "extrapolated" and len(self.phi) > 1:
            lagged = max(0., 2. * self.phi[-1] - self.phi[-2])
        g = self.degradation(lagged)
        drive = (2. * MU + self.driving_bulk(g)) * strain**2
        phi = min(self.phi[-1],
                  G_C / LENGTH / (G_C / LENGTH + (1. - KAPPA) * drive))
        force = self.THICKNESS * self.WIDTH * (2. * MU * g + self.bulk(g)) * strain
        new = self.degradation(phi)
        self.stored.append(0.5 * self.AREA * self.THICKNESS * strain**2 *
                           (2. * MU * new + self.bulk(new)))
        self.work.append(self.work[-1] + 0.5 * (force + self.force[-1]) * 0.05)
        self.force.append(force)
        self.phi.append(phi)

    def cracked(self):
        return [self.AREA * self.THICKNESS * G_C * (1. - phi)**2 / (2. * LENGTH)
                for phi in self.phi]


class ColumnsAreThoseOfTheirState(unittest.TestCase):
    def compare(self, law, coupling, formulation):
        expected = EvenSquare(law, coupling)
        run = Run(SQUARE, "Model/Pressure law=" + law,
                  "Model/Coupling=" + coupling,
                  "Model/Formulation=" + formulation)
        cracked = expected.cracked()
        columns = {"force_y_N": expected.force,
                   "elastic_energy_mJ": expected.stored,
                   "crack_energy_mJ": cracked,
                   "min_phase_field": expected.phi,
                   "external_work_mJ": expected.work,
                   "energy_imbalance_mJ":
                       [w - e - c for w, e, c in
                        zip(expected.work, expected.stored, cracked)]}
        self.assertEqual(len(run.rows), 6)
        for name, values in columns.items():
            for row, value in zip(run.rows, values):
                self.assertAlmostEqual(
                    row[name], value, delta=1e-6 * max(map(abs, values)),
                    msg="%s, step %d" % (name, row["step"]))
        # the lag is no small matter here, and the balance shows it
        self.assertGreater(abs(columns["energy_imbalance_mJ"][-1]),
                           0.05 * expected.work[-1])
        self.assertTrue(run.warns_of("energy balance: "), run.warnings)

    def test_time_lagged(self):
        for law in "relaxed bulk", "degraded divergence", "degraded bulk":
            with self.subTest(law):
                self.compare(law, "time-lagged", "mixed")
        self.compare("relaxed bulk", "time-lagged", "displacement")

    def test_extrapolated(self):
        self.compare("relaxed bulk", "extrapolated", "mixed")

    def test_iterated_has_no_lag(self):
        run = Run(SQUARE, "Model/Pressure law=degraded bulk",
                  "Model/Coupling tolerance=1e-9")
        for row in run.rows[1:]:
            phi, strain = row["min_phase_field"], row["time_s"] / 2.
            self.assertAlmostEqual(
                row["elastic_energy_mJ"],
                6. * EvenSquare.degradation(phi) * (2. * MU + LAMBDA) * strain**2,
                delta=1e-7)


class RunsStartFromEquilibrium(unittest.TestCase):
    def test_whatever_the_coupling(self):
        iterated = Run(CRACK, "Model/Coupling=iterated").rows[0]
        for coupling in "time-lagged", "extrapolated":
            with self.subTest(coupling):
                run = Run(CRACK, "Model/Coupling=" + coupling)
                for name in ("crack_volume_mm3", "elastic_energy_mJ",
                             "crack_energy_mJ"):
                    self.assertAlmostEqual(run.rows[0][name] / iterated[name],
                                           1., delta=1e-6, msg=name)
                    # and nothing is left to happen
                    self.assertAlmostEqual(run.rows[-1][name] / iterated[name],
                                           1., delta=1e-2, msg=name)
                self.assertFalse(run.warns_of("energy balance"), run.warnings)


class ImplausibleNumbersAreWarnedOf(unittest.TestCase):
    def expect(self, words, *settings):
        check = Run(SQUARE, *settings, arguments=("--check",))
        self.assertRegex(check.log, "(?m)^warning: .*" + words)
        run = Run(SQUARE, *settings)
        self.assertTrue(run.warns_of(words), run.warnings)
        self.assertRegex(run.log, "(?m)^warning: .*" + words)
        return run

    def test_length_scale_larger_than_the_body(self):
        self.expect("l = 1000 mm in a body 2 mm wide", "Model/Length scale=1000*h")

    def test_toughness_of_nothing(self):
        run = self.expect("times what the material bears",
                          "Material/Critical energy release rate=1e-9",
                          "Model/Length scale=0.5")
        # what came of it, and that it came in one step
        self.assertTrue(run.warns_of("of the body after step 1, 0 % before it"),
                        run.warnings)

    def test_a_margin_as_wide_as_the_body(self):
        self.expect("100 % of the body are within",
                    "Boundary conditions/Unbreakable margin=2")
        check = Run(SQUARE, "Boundary conditions/Unbreakable margin=0.01",
                    "Model/Length scale=0.5", arguments=("--check",))
        self.assertNotIn("Unbreakable", check.log)

    def test_others_are_not(self):
        check = Run(SQUARE, "Model/Length scale=0.5", "Geometry/Rectangle/Cell size=0.25",
                    arguments=("--check",))
        self.assertNotIn("warning", check.log)
        self.assertIn("sigma_c", check.log)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    PROGRAM = [*sys.argv[1:3], int(sys.argv[3])]
    unittest.main(argv=sys.argv[:1])
