#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A run that was stopped and continued gives the results of one that was not.

usage: test_resume.py EXECUTABLE MPIRUN
"""

import pathlib
import sys
import tempfile

from runs import generations, program, rows, summary

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASE = ROOT / "parameters" / "epdm" / "punctured_strip.prm"
COARSE = ["Mesh/Refined surroundings=", "Mesh/Adaptive levels=1",
          "Model/Length scale=1.2", "Model/Coupling tolerance=1e-4",
          "Load stepping/End time=4.2", "Load stepping/Largest step=0.6",
          "Output/Checkpoint every=2",
          "Output/Displacement at points=left : 0.3, 20 ; right : 17, 13.37"]
CASE_3D = (ROOT / "tests" / "regression" / "strip_3d.prm",
           ["Mesh/Adaptation=predictor corrector", "Mesh/Adaptive levels=1",
            "Mesh/Refinement margin=0.1",
            "Output/Displacement at points=inside : 3, 4.5, 1.7"])
# what depends on the machine, or on how often factors were at hand, or is a
# small difference of columns that are compared
NOT_COMPARED = {"energy_imbalance_mJ",
                "wall_time_s", "factorizations", "newton_iterations",
                "linear_iterations", "coupling_change", "rejected_steps"}


def run(ranks, directory, *options, settings=(), status=0, case=(CASE, COARSE)):
    return program.output_of(
        [*program.command(sys.argv[1], sys.argv[2:], ranks), str(case[0]), "--output",
         str(directory), *options, *program.as_options((*case[1], *settings))], status)


def compare(found, expected):
    """Equal to 1e-5 of the largest value of a column.

    A continued run begins without factors, so its inexact iterations differ,
    by less than the tolerance of the coupling (1e-3) and its contraction.
    """
    assert len(found) == len(expected), (len(found), len(expected))
    for name in set(expected[0]) - NOT_COMPARED:
        largest = max(abs(float(row[name])) for row in expected)
        for one, other in zip(found, expected):
            a, b = float(one[name]), float(other[name])
            assert abs(a - b) <= 1e-5 * largest, (name, a, b)


def outcome(directory):
    """The last line of the crack paths, which is that of a whole run."""
    lines = (directory / "crack_path.csv").read_text().splitlines()
    assert lines[0].startswith("step,time_s,"), lines
    assert sum(line.startswith("#") for line in lines) == 1, lines
    return lines[-1]


def break_newest_checkpoint(directory):
    with open(generations(directory)[0] / "mesh_fixed.data", "r+b") as file:
        file.write(b"garbage")


def main():
    with tempfile.TemporaryDirectory() as temporary:
        whole = pathlib.Path(temporary) / "whole"
        parts = pathlib.Path(temporary) / "parts"
        run(1, whole)
        # stopped at once, by the clock; then continued on two ranks
        out = run(1, parts, settings=["Output/Wall time limit=1e-6"], status=5)
        assert "continue with --resume" in out, out
        run(2, parts, "--resume")
        compare(rows(parts), rows(whole))
        assert outcome(parts) == outcome(whole) == \
            "# outcome: none; start: none", (outcome(parts), outcome(whole))
        # the newest checkpoint is damaged: the one before it serves
        break_newest_checkpoint(whole)
        out = run(2, whole, "--resume")
        assert "resumed at step 6" in out, out
        compare(rows(whole), rows(parts))
        # another case must not be continued
        out = run(1, whole, "--resume", settings=["Material/Thickness=3"],
                  status=2)
        assert "Material/Thickness" in out, out
        assert "right_y_mm" in rows(whole)[0]
        # nor one whose columns mean something else
        out = run(1, whole, "--resume", status=2, case=(
            CASE, [*COARSE[:-1], "Output/Displacement at points=left : 1, 20"]))
        assert "Output/Displacement at points" in out, out
        changed_map(pathlib.Path(temporary))
        in_3d(pathlib.Path(temporary) / "whole 3d",
              pathlib.Path(temporary) / "parts 3d")


def changed_map(folder):
    """A table of the material that has changed makes another case of it."""
    table, results = folder / "map.csv", folder / "with map"
    table.write_text("x,y,value\n0,0,1\n20,0,1.1\n")
    settings = ["Material/Map/File name=%s" % table,
                "Material/Critical energy release rate=17*map"]
    stopped = settings + ["Output/Wall time limit=1e-6"]
    run(1, results, settings=stopped, status=5)
    text = table.read_text()
    table.write_text(text.replace("1.1", "1.2"))
    out = run(2, results, "--resume", settings=settings, status=2)
    assert "contents of Material/Map/File name" in out, out
    table.write_text(text)
    # no step fits into that time, and none ever will
    run(2, results, "--resume", settings=stopped, status=3)


def in_3d(whole, parts):
    """The same on an adaptive mesh in 3-d, where there are sheets."""
    run(1, whole, case=CASE_3D)
    run(1, parts, settings=["Output/Wall time limit=1e-6"], status=5, case=CASE_3D)
    run(2, parts, "--resume", case=CASE_3D)
    compare(rows(parts), rows(whole))
    assert int(rows(whole)[-1]["refinements"]) > 0
    assert float(rows(whole)[-1]["inside_z_mm"]) != 0.
    assert not list(whole.glob("crack_path*"))
    for name in ("outcome", "outcome_start", "separated"):
        assert summary(whole)[name] == summary(parts)[name], name
    for name in ("crack_sheet.csv", "crack_front.csv"):
        assert len((whole / name).read_text().splitlines()) == \
            len((parts / name).read_text().splitlines()), name
    # the cells of the last mesh, refined once
    coarse = whole.with_name("coarse")
    run(1, coarse, case=(CASE_3D[0], ["Load stepping/End time=12"]))
    assert summary(whole)["finest_cell_mm"] < 0.6 * summary(coarse)["finest_cell_mm"]


if __name__ == "__main__":
    main()
