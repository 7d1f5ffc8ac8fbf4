#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Rubber at finite strain is torn apart, in both formulations and on any ranks.

    test_torn_rubber.py EXECUTABLE MPIRUN

The punctured strip with a notch at 14 mm, on cells of twice the size and with twice
the length scale. Broken cells, stretched a hundredfold, used to stop Newton's method
in the mixed formulation. The energy balance holds up to the onset, the better the
smaller the steps, and a run that is stopped and resumed is the one that was not.
"""
import concurrent.futures
import os
import pathlib
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
CASE = os.path.join(ROOT, "parameters", "finite_strain", "punctured_strip.prm")
COARSER = ["Geometry/Punctured strip/Notch height=14", "Model/Length scale=0.6",
           "Mesh/Adaptive levels=2", "Mesh/Refined surroundings=hole : 0.5 : 1",
           "Output/Field format=none"]
MIXED = "Model/Formulation=mixed"


class Runs:
    def __init__(self, executable, mpirun, folder):
        self.executable, self.mpirun, self.folder = executable, mpirun, folder
        # those on one rank go side by side, as the test has two cores
        self.pool = concurrent.futures.ThreadPoolExecutor(2)

    def begin(self, *arguments, **keywords):
        """run(), whose result() is waited for later."""
        return self.pool.submit(self.run, *arguments, **keywords)

    def run(self, name, *settings, ranks=1, resume=False):
        directory = os.path.join(self.folder, name)
        words = program.command(self.executable, [self.mpirun], ranks)
        words += [CASE, "--output", directory]
        words += program.as_options([*COARSER, *settings])
        program.output_of(words + (["--resume"] if resume else []), timeout=None)
        return program.rows(directory), program.summary(directory)


def forces(rows):
    return [abs(float(row["force_y_N"])) for row in rows]


def check_torn(name, rows, summary):
    """From the notch, apart, with at most 3 % of the peak left."""
    assert summary["separated"] is True, (name, summary)
    assert summary["outcome_start"] == "notch", (name, summary)
    assert forces(rows)[-1] <= 0.03 * max(forces(rows)), (name, forces(rows))


def check_same(name, one, other, up_to):
    """The same up to the load step in which the crack runs, forces to 1e-6 of the
    peak; what is torn apart is so in the same step."""
    assert [row["time_s"] for row in one] == [row["time_s"] for row in other], name
    peak = max(forces(one))
    for a, b in list(zip(forces(one), forces(other)))[:up_to]:
        assert abs(a - b) <= 1e-6 * peak, (name, a, b)


def imbalance(rows, before_s):
    """Over the work of the loads, at the last step up to that time."""
    row = [row for row in rows if float(row["time_s"]) <= before_s][-1]
    return abs(float(row["energy_imbalance_mJ"]) / float(row["external_work_mJ"]))


def main():
    executable, mpirun = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(executable, mpirun, folder)
        first = runs.begin("mixed", MIXED)
        alone, summary = runs.begin("displacement").result()
        mixed, mixed_summary = first.result()
        check_torn("mixed", mixed, mixed_summary)
        check_torn("displacement", alone, summary)
        # in plane stress the two are one problem, on cells that are coarse at the
        # tip of the notch
        assert abs(max(forces(mixed)) / max(forces(alone)) - 1.) < 0.06, \
            (max(forces(mixed)), max(forces(alone)))
        before_the_run = forces(mixed).index(max(forces(mixed)))
        for ranks in (2, 3):
            other, _ = runs.run("mixed_%d" % ranks, MIXED, ranks=ranks)
            check_same("%d ranks" % ranks, mixed, other, before_the_run)
        # in the middle of it, on other ranks
        runs.run("resumed", MIXED, "Load stepping/End time=4.5", ranks=2)
        resumed = runs.begin("resumed", MIXED, resume=True)
        fine, _ = runs.begin("fine", MIXED, "Load stepping/End time=5.4",
                             "Load stepping/First step=0.45",
                             "Load stepping/Largest step=0.45").result()
        check_same("resumed", mixed, resumed.result()[0], before_the_run)
        assert imbalance(mixed, 5.4) < 0.01, imbalance(mixed, 5.4)
        assert imbalance(fine, 5.4) < 0.5 * imbalance(mixed, 5.4), imbalance(fine, 5.4)


if __name__ == "__main__":
    main()
