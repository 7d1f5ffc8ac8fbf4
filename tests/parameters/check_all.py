#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Every .prm in the tree passes --check.

    check_all.py EXECUTABLE [directory of the project]

Each must leave with exit status 0, say something, complain about nothing on the
error stream, and leave no files, from an empty working directory: paths in a
.prm are relative to it. What it warns of is what the case is known for.
"""
import os
import sys
import tempfile

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import program  # noqa: E402

RATE_EFFECT = "coupling '%s': a running crack advances about one cell per load step"
COARSE = "l/h = %s: the length scale is resolved by fewer than two cells"
# beginnings, by the name of the .prm: coarse for speed, lagged for comparison
KNOWN_WARNINGS = {
    "shear_timing.prm": [RATE_EFFECT % "extrapolated"],
    "block_with_inclusion.prm": [COARSE % "1.77"],
    "fluid_growing_crack.prm": [COARSE % "1.6"],
    "hinged_block.prm": [RATE_EFFECT % "extrapolated"],
    "l_shape_at1_lagged.prm": [RATE_EFFECT % "time-lagged"],
    "penny_tension.prm": [COARSE % "1"],
    "rectangle_initial_crack.prm": [RATE_EFFECT % "extrapolated"],
    "slit_square_onset.prm": [COARSE % "1"],
    "strip_3d.prm": [COARSE % "1.57", "66 % of the body are within"],
}


def parameter_files(root):
    for top in ("parameters", "tests"):
        for folder, _, names in sorted(os.walk(os.path.join(root, top))):
            for name in sorted(names):
                if name.endswith(".prm"):
                    yield os.path.join(folder, name)


def strange_warnings(path, text):
    known = KNOWN_WARNINGS.get(os.path.basename(path), [])
    found = [line.split("warning: ", 1)[1] for line in text.splitlines()
             if "warning: " in line]
    for warning in found:
        if not any(warning.startswith(each) for each in known):
            yield "warned of: " + warning
    for each in known:
        if not any(warning.startswith(each) for warning in found):
            yield "not warned of any more: " + each


def offences(starts, path):
    """starts: a program.Program."""
    with tempfile.TemporaryDirectory() as folder:
        status, text, errors = starts.run(["--check", path], folder)
        left = os.listdir(folder)
    if status != 0:
        yield "exit status %d" % status
    if errors:
        yield errors.strip()
    if "case: " not in text or "cells: " not in text:
        yield "no preflight is printed: %r" % text[:200]
    yield from strange_warnings(path, text)
    for name in left:
        yield "left behind: " + name


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    here = os.path.dirname(os.path.abspath(__file__))
    root = os.path.abspath(sys.argv[2] if len(sys.argv) > 2
                           else os.path.join(here, os.pardir, os.pardir))
    starts = program.runner(sys.argv[1], "", 1)
    n_files, n_failed = 0, 0
    for path in parameter_files(root):
        found = list(offences(starts, path))
        n_files += 1
        n_failed += bool(found)
        for text in found:
            print("%s: %s" % (os.path.relpath(path, root), text))
    print("%d parameter files, %d failed" % (n_files, n_failed))
    return 1 if n_failed or n_files == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
