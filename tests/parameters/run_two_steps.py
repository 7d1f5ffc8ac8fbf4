#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Every .prm in parameters/ runs its first two load steps.

    run_two_steps.py EXECUTABLE MPIRUN RANKS [part of a name ...]

A run must end with exit status 0, write nothing to the error stream, and leave
at least two accepted steps in statistics.csv, all of finite numbers. Cases with
fine meshes run on a coarser one here: SHORT has the entries.
"""
import csv
import json
import math
import os
import re
import sys
import tempfile

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import program  # noqa: E402

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))

SHORT = {
    "notched_tension.prm": ["Mesh/Refined boxes=0.3,0.45 : 0.7,0.55 : 1",
                            "Mesh/Adaptive levels=0"],
    "notched_shear.prm": ["Mesh/Refined boxes=", "Mesh/Adaptive levels=1"],
    "three_point_bending.prm": ["Mesh/Refined discs=",
                                "Mesh/Adaptive levels=1"],
    "l_shaped_panel.prm": ["Mesh/Adaptive levels=0"],
    "multiple_cracks_homogeneous.prm": ["Mesh/Adaptive levels=0"],
    "multiple_cracks_heterogeneous.prm": ["Mesh/Adaptive levels=0"],
    "rubber_strip.prm": ["Mesh/Refined boxes="],
    "sneddon_2d.prm": ["Mesh/Refined boxes=-1.5,-0.5 : 1.5,0.5 : 3"],
    "sneddon_2d_incompressible.prm": [
        "Mesh/Refined boxes=-1.5,-0.5 : 1.5,0.5 : 3"],
    "sneddon_3d.prm": ["Mesh/Refined boxes=-2,-2,-2 : 2,2,2 : 1"],
    "pure_shear.prm": ["Mesh/Refined surroundings=", "Mesh/Adaptive levels=0"],
    "tearing_strip.prm": ["Mesh/Refined boxes="],
    "slit_cube.prm": ["Mesh/Adaptive levels=0"],
    "punctured_strip_3d.prm": ["Mesh/Refined surroundings=",
                               "Mesh/Adaptive levels=0"],
    "heterogeneous_block.prm": ["Mesh/Adaptive levels=0"],
    "block_with_inclusion.prm": ["Mesh/Adaptive levels=0"],
}


def first_step(path):
    """Load stepping/First step of a file or of those it includes; or None."""
    with open(path) as stream:
        text = stream.read()
    found = re.search(r"^\s*set\s+First step\s*=\s*([^#\s]+)", text, re.MULTILINE)
    if found:
        return float(found.group(1))
    for name in re.findall(r"^\s*include\s+(\S+)", text, re.MULTILINE):
        step = first_step(os.path.join(os.path.dirname(path), name))
        if step is not None:
            return step
    return None


def offences(starts, path, folder):
    """Of a run in an empty working directory; starts: a program.Program."""
    results = os.path.join(folder, "results")
    step = first_step(path)
    if step is None:
        yield "no 'First step' in the file: two steps may take long"
        return
    sets = SHORT.get(os.path.basename(path), []) + [
        "Load stepping/End time=%.15g" % (2. * step)]
    arguments = [path, "--output", results]
    for each in sets:
        arguments += ["--set", each]
    status, _, errors = starts.run(arguments, folder)
    if status != 0 or errors:
        yield "exit status %d: %s" % (status, errors.strip())
        return
    with open(os.path.join(results, "statistics.csv")) as table:
        rows = list(csv.DictReader(table))
    if len(rows) < 3:
        yield "%d rows in statistics.csv" % len(rows)
    for row in rows:
        for name, text in row.items():
            if not math.isfinite(float(text)):
                yield "step %s: %s is %s" % (row["step"], name, text)
    with open(os.path.join(results, "summary.json")) as summary:
        if json.load(summary)["steps"] < 2:
            yield "fewer than two steps in summary.json"


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    starts = program.runner(*sys.argv[1:3], int(sys.argv[3]))
    paths = [os.path.join(folder, name)
             for folder, _, names in os.walk(os.path.join(ROOT, "parameters"))
             for name in names if name.endswith(".prm")
             and (len(sys.argv) == 4
                  or any(part in name for part in sys.argv[4:]))]
    n_failed = 0
    for path in sorted(paths):
        with tempfile.TemporaryDirectory() as folder:
            found = list(offences(starts, path, folder))
        n_failed += bool(found)
        print("%s: %s" % (os.path.relpath(path, ROOT), found or "ok"), flush=True)
    print("%d cases, %d failed" % (len(paths), n_failed))
    return 1 if n_failed or not paths else 0


if __name__ == "__main__":
    sys.exit(main())
