#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""No state is accepted that is not finite: whatever grows beyond all measure ends
the run with a reason, and what was computed before stays, in files that hold
numbers only.

usage: test_not_finite.py EXECUTABLE MPIRUN
"""
import math
import os
import sys
import tempfile

import small_runs
from small_runs import strict_json, table_of

MOVE = "Boundary conditions/Displacement=bottom : all : 0 ; top : x : 0 ; top : y : "
LATER = "if(t > 0.6, 1e200, 0)"  # finite itself, but no square of it is
# {what is too large: setting}: from the start, and after some steps
AT_START = {
    "displacement": MOVE + "1e300*exp(t*1000)",
    "traction": "Boundary conditions/Traction=right : x : 1e305",
    "body force": "Boundary conditions/Body force=x : -1e300",
    "fluid pressure": "Fluid/Pressure=1e300",
    "toughness": "Material/Critical energy release rate=1e307",
    "point": "Boundary conditions/Displacement at points=1, 0.5 : x : 1e250"}
LATER_ON = {
    "displacement": MOVE + "0.1*t + " + LATER,
    "traction": "Boundary conditions/Traction=right : x : " + LATER,
    "body force": "Boundary conditions/Body force=y : " + LATER,
    "fluid pressure": "Fluid/Pressure=" + LATER,
    "point": "Boundary conditions/Displacement at points=1, 0.5 : x : " + LATER}
# {what: (setting, why no step can be calculated)}; of what is merely too large
# for the body, whatever fails first
FIRST_STEP = {
    "displacement that grows": (MOVE + "0.1*t*exp(800*t)", "load step failed"),
    "stiffness": ("Material/Shear modulus=1e300",
                  "constants of the material are too large, or the matrix is "
                  "singular")}
INFINITE = {
    "displacement": (MOVE + "0.1*t/(t < 0.7)", "Displacement"),
    "traction": ("Boundary conditions/Traction=right : x : exp(2000*(t - 0.6))",
                 "Traction"),
    "fluid pressure": ("Fluid/Pressure=sqrt(0.6 - t)", "Fluid/Pressure"),
    "phase field": (MOVE + "0.1*t ; right : phase field : log(0.6 - t)",
                    "Displacement")}


def check_tables(folder, n_rows):
    rows = table_of(folder, "statistics.csv")
    assert len(rows) >= n_rows, rows
    for row in rows:
        for name, value in row.items():
            assert math.isfinite(float(value)), (name, value)
    for name in ("crack_path.csv", "crack_opening.csv") if n_rows else ():
        for row in table_of(folder, name):
            assert not {"nan", "inf", "-nan", "-inf"} & set(row.values()), row


def main():
    program = [os.path.abspath(sys.argv[1])] + sys.argv[2:3]
    with tempfile.TemporaryDirectory() as folder:
        small_runs.prepare(folder)

        def run(setting, status, number):
            return small_runs.run(
                program, folder, "--output", "run%d" % number, status=status,
                ranks=1 + number % 2, settings=[setting])

        number = 0
        for name, setting in AT_START.items():
            number += 1
            out = run(setting, 3, number)
            assert "initial state cannot be computed" in out, (name, out)
            assert "finite" in out, (name, out)
            check_tables(os.path.join(folder, "run%d" % number), 0)
        for name, setting in LATER_ON.items():
            number += 1
            out = run(setting, 3, number)
            summary = strict_json(folder, "run%d" % number, "summary.json")
            assert "finite" in summary["exit_reason"], (name, summary)
            check_tables(os.path.join(folder, "run%d" % number), 2)
        for name, (setting, why) in FIRST_STEP.items():
            number += 1
            run(setting, 3, number)
            summary = strict_json(folder, "run%d" % number, "summary.json")
            assert why in summary["exit_reason"], (name, summary)
            # that is no cure
            assert "kappa" not in summary["exit_reason"], (name, summary)
            check_tables(os.path.join(folder, "run%d" % number), 1)
        for name, (setting, entry) in INFINITE.items():
            number += 1
            out = run(setting, 2, number)
            assert entry in out and "must be finite" in out and "t = " in out, out
            check_tables(os.path.join(folder, "run%d" % number), 2)


if __name__ == "__main__":
    main()
