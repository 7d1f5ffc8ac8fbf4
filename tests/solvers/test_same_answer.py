#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Every linear solver gives the same results, up to the tolerance of the coupling.

usage: test_same_answer.py EXECUTABLE RANKS MPIRUN [options of mpirun]
"""

import pathlib
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from program import as_options, command, output_of, rows  # noqa: E402

CASES = pathlib.Path(__file__).resolve().parents[1] / "regression"
# displacement formulation, broken in two; mixed formulation, refined as the
# crack begins to grow; mixed, nearly incompressible; mixed in 3-d, until the crack
# has run and broken cells are compressed; rubber at finite strain
COUPLED = ("Model/Coupling tolerance=1e-7", "Model/Running crack tolerance=1e-7")
RUNS = (("slit_square_at2", COUPLED),
        ("slit_square_adaptive", (*COUPLED, "Load stepping/End time=0.0045")),
        ("strip_intact", ()),
        ("slit_cube_adaptive", COUPLED),
        ("strip_intact", ("Model/Strains=finite", "Model/Kinematics=plane strain",
                          "Model/Energy split=none", "Model/Pressure law=relaxed bulk")))
DISPLACEMENT_FORMULATION = "slit_square_at2"
COMPARED = ("displacement_mm", "force_x_N", "force_y_N", "elastic_energy_mJ",
            "crack_energy_mJ", "external_work_mJ", "min_phase_field",
            "max_phase_field_change", "cells", "dofs")
# relative to the largest of a column; of the coupling's 1e-7 a crack that is
# about to run leaves this
TOLERANCE = 1e-5


def run(case, solver, settings):
    executable, ranks, *mpirun = sys.argv[1:]
    with tempfile.TemporaryDirectory() as directory:
        text = output_of(
            [*command(executable, mpirun, ranks), str(CASES / (case + ".prm")),
             "--output", directory + "/results",
             *as_options(("Linear solver/Name=" + solver, *settings))])
        named = [line for line in text.splitlines()
                 if line.startswith("linear solver: ")]
        assert named and named[0].startswith("linear solver: " + solver), named
        return rows(directory + "/results")


def compare(case, found, expected):
    assert len(found) == len(expected), (case, len(found), len(expected))
    for name in COMPARED:
        largest = max(abs(float(row[name])) for row in expected)
        # a component of a force that symmetry makes zero
        if name.startswith("force"):
            largest = max(abs(float(row[force])) for row in expected
                          for force in ("force_x_N", "force_y_N"))
        for one, other in zip(found, expected):
            difference = abs(float(one[name]) - float(other[name]))
            assert difference <= TOLERANCE * largest, (case, name, one[name],
                                                       other[name])


def main():
    for case, settings in RUNS:
        expected = run(case, "direct", settings)
        for solver in ("block AMG", "matrix-free"):
            if solver == "matrix-free" and case == DISPLACEMENT_FORMULATION:
                continue
            found = run(case, solver, settings)
            compare(case, found, expected)
            print("%s, %s: %d rows agree" % (case, solver, len(found)))


if __name__ == "__main__":
    main()
