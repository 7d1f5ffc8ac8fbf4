#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Periodic cells with cracks, after parameters/gallery/periodic_cell.prm: a crack that
leaves through one side and enters through the other, bodies of several cells, resumed
runs, meshes that are refined.

    test_cracked_cells.py EXECUTABLE LAUNCHER RANKS
"""
import pathlib
import sys
import tempfile

from runs import FIXED_STEPS, PERIODIC_3D, Runs, alike, near, stresses

CELL = pathlib.Path(__file__).resolve().parents[2] / "parameters/gallery/periodic_cell.prm"
QUIET = "Output/Field format=none"
TIGHT = ("Model/Coupling tolerance=1e-7", "Model/Largest number of coupling iterations=1000",
         "Linear solver/Newton tolerance=1e-10")
EVEN = ("Mesh/Adaptation=none", "Mesh/Adaptive levels=0", QUIET, *FIXED_STEPS,
        *TIGHT)
STRAIN = "Boundary conditions/Mean strain="


def cracks(nx, ny, segment=((0.75, 0.5), (0.9, 0.5))):
    """That of one cell in each of several."""
    return "Initial cracks/Cracks=" + " ; ".join(
        " : ".join("%g, %g" % (x + i, y + j) for x, y in segment)
        for i in range(nx) for j in range(ny))


def of_cells(nx, ny):
    return ("Geometry/Rectangle/Upper corner=%d, %d" % (nx, ny),
            "Geometry/Rectangle/Cells=%d, %d" % (16 * nx, 16 * ny), cracks(nx, ny))


def test_repeated_cell(runs):
    """2 x 2 cells, step by step until the crack has begun to run."""
    for model in ((), ("Model/Formulation=mixed", "Model/Displacement degree=2",
                       "Geometry/Rectangle/Cells=8, 8", "Model/Length scale=0.15")):
        steps = (*EVEN, "Load stepping/End time=0.6", *model)
        one = runs.rows(*steps, case=CELL)
        cells = (16, 16) if model else (32, 32)
        four = runs.rows(*steps, *of_cells(2, 2),
                         "Geometry/Rectangle/Cells=%d, %d" % cells, case=CELL)
        assert len(one) == len(four) > 3
        for row, larger in zip(one[1:], four[1:]):
            alike(stresses(row), stresses(larger), 1e-6)
            near(larger["crack_energy_mJ"], 4 * row["crack_energy_mJ"], 1e-6)
            near(larger["min_phase_field"], row["min_phase_field"], 1e-6)
            near(row["energy_imbalance_mJ"], 0., 0.03 * row["external_work_mJ"])
    assert one[-1]["max_phase_field_change"] > 1e-3


def test_crack_through_the_side(runs):
    """It runs all the way on a mesh that follows it; forces vanish, stress and force
    are one thing."""
    rows = runs.rows(QUIET, case=CELL)
    peak = max(row["mean_stress_yy_MPa"] for row in rows)
    assert rows[-1]["mean_stress_yy_MPa"] < 0.2 * peak
    assert rows[-1]["refinements"] > 0
    for row in rows:
        near(row["force_y_N"], row["mean_stress_yy_MPa"], 1e-6 * peak)
    # the same pattern, cut where the crack is not in the middle
    moved = runs.rows(QUIET, "Geometry/Rectangle/Lower corner=0.5, 0.25",
                      "Geometry/Rectangle/Upper corner=1.5, 1.25",
                      cracks(1, 1), case=CELL)
    near(max(row["mean_stress_yy_MPa"] for row in moved), peak, 1e-3 * peak)


def test_crack_at_a_side(runs):
    """One that is given at one side only, at its image, or half at each."""
    steps = (*EVEN, "Load stepping/End time=0.4")
    right, left, both = ("Initial cracks/Cracks=" + text for text in (
        "0.9, 0.5 : 1, 0.5", "1.9, 0.5 : 2, 0.5", "0.4, 0.5 : 0.5, 0.5"))
    row = runs.last(*steps, right, case=CELL)
    same = runs.last(*steps, left, "Geometry/Rectangle/Lower corner=1, 0",
                     "Geometry/Rectangle/Upper corner=2, 1", case=CELL)
    alike(stresses(row), stresses(same), 1e-6)
    inside = runs.last(*steps, both.replace("0.4", "0.9").replace("0.5 : 0.5", "0.5 : 1"),
                       "Geometry/Rectangle/Lower corner=0.5, 0",
                       "Geometry/Rectangle/Upper corner=1.5, 1", case=CELL)
    alike(stresses(row), stresses(inside), 1e-6)
    near(row["crack_energy_mJ"], inside["crack_energy_mJ"], 1e-6)


def test_resume(runs):
    """As if it had not been interrupted, between steps with new meshes."""
    # at 0.9 the crack begins to run: there the answer hangs on rounding
    settings = (QUIET, *TIGHT, "Load stepping/End time=0.85", "Load stepping/First step=0.05",
                "Load stepping/Largest step=0.05")
    whole = runs.rows(*settings, case=CELL)
    kept = ("Output/Checkpoint every=1",)
    first = runs.rows(*settings, *kept, "Load stepping/End time=0.75", case=CELL,
                      name="resumed")
    both = runs.rows(*settings, *kept, more=("--resume",), case=CELL, name="resumed")
    assert len(first) < len(both) == len(whole)
    assert whole[len(first) - 1]["cells"] < whole[-1]["cells"]
    for row, other in zip(whole, both):
        for key in row:
            if key not in ("wall_time_s", "factorizations", "newton_iterations",
                           "linear_iterations", "coupling_iterations", "coupling_change",
                           "active_set_size"):
                near(other[key] or 0., row[key] or 0., 1e-6 * max(1., abs(row[key] or 0.)))


def test_finite_strain(runs):
    """A hole's worth of soft rubber; large steps, which the predictor cuts."""
    rubber = ("Model/Strains=finite", "Material/Young's modulus=", "Material/Poisson ratio=",
              "Material/Lame lambda=30",
              "Material/Shear modulus=1 + 9*((x-floor(x)-0.45)^2 + (y-floor(y)-0.5)^2 < 0.04)",
              "Material/Critical energy release rate=0.1", STRAIN + "yy : 0.3*t ; xy : 0.1*t")
    steps = (*EVEN, "Load stepping/End time=0.5")
    one = runs.rows(*steps, *rubber, case=CELL)
    two = runs.rows(*steps, *rubber, *of_cells(2, 1), case=CELL)
    for row, larger in zip(one[1:], two[1:]):
        alike(stresses(row), stresses(larger), 1e-6)
        near(larger["crack_energy_mJ"], 2 * row["crack_energy_mJ"], 1e-6)
    assert one[-1]["max_phase_field_change"] > 1e-3


def test_solid(runs):
    """A penny that meets two sides in space, with multigrid; 2 x 1 x 1 cells."""
    solid = ("Geometry/Dimension=3", "Geometry/Name=box",
             PERIODIC_3D, *EVEN, "Load stepping/End time=0.4",
             "Model/Length scale=0.4", "Material/Young's modulus=100",
             STRAIN + "zz : 0.03*t ; xz : 0.01*t")
    sizes = ("Geometry/Box/Upper corner=1, 1, 1", "Geometry/Box/Cells=6, 6, 6",
             "Initial cracks/Cracks=",
             "Initial cracks/Discs=1, 0.5, 0.5 : 0, 0, 1 : 0.3 ; 0, 0.5, 0.5 : 0, 0, 1 : 0.3")
    more = ("Geometry/Box/Upper corner=2, 1, 1", "Geometry/Box/Cells=12, 6, 6",
            "Initial cracks/Discs=" + " ; ".join(
                "%d, 0.5, 0.5 : 0, 0, 1 : 0.3" % x for x in range(3)))
    one = runs.rows(*solid, *sizes, case=CELL)
    two = runs.rows(*solid, *sizes, *more, "Linear solver/Name=block AMG", case=CELL)
    for row, larger in zip(one[1:], two[1:]):
        alike(stresses(row, "xyz"), stresses(larger, "xyz"), 1e-5)
        near(larger["crack_energy_mJ"], 2 * row["crack_energy_mJ"], 1e-6)


def main():
    with tempfile.TemporaryDirectory() as directory:
        runs = Runs(*sys.argv[1:4], directory)
        for test in (test_repeated_cell, test_crack_through_the_side, test_crack_at_a_side,
                     test_resume, test_finite_strain, test_solid):
            test(runs)
            print(test.__name__, "ok", flush=True)
        print("%d runs" % runs.n_runs)


if __name__ == "__main__":
    main()
