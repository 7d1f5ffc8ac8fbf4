#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Seconds per Newton iteration of the punctured strip, by phase.

usage: measure_performance.py EXECUTABLE [RANKS ...]     (default: 1 2)

Runs two load steps of parameters/epdm/punctured_strip.prm on uniform meshes
of three sizes and prints a table for doc/performance.md. Factorisation is per
factorisation, since factors are kept where the matrix is.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
CASE = ROOT / "parameters" / "epdm" / "punctured_strip.prm"
SIZES = (("2", ""), ("3", ""), ("3", "0,6:20,24:1"))


def run(executable, ranks, refinements, boxes):
    with tempfile.TemporaryDirectory() as directory:
        command = ["mpirun", "-n", str(ranks), executable, str(CASE),
                   "--output", directory,
                   "--set", f"Mesh/Global refinements={refinements}",
                   "--set", f"Mesh/Refined boxes={boxes}",
                   "--set", "Mesh/Refined surroundings=",
                   "--set", "Mesh/Adaptation=none",
                   "--set", "Mesh/Adaptive levels=0",
                   "--set", "Load stepping/End time=1.2",
                   "--set", "Load stepping/Largest step=0.6",
                   "--set", "Output/Checkpoint every=0"]
        environment = dict(os.environ, OMP_NUM_THREADS="1",
                           OMPI_ALLOW_RUN_AS_ROOT="1",
                           OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
        subprocess.run(command, check=True, env=environment,
                       stdout=subprocess.DEVNULL)
        return json.loads((pathlib.Path(directory) / "summary.json").read_bytes())


def main():
    executable = str(pathlib.Path(sys.argv[1]).resolve())
    print("| dofs | ranks | assembly | factorisation | solve | phase field "
          "| output and set-up of the run | wall time of the run |")
    print("|---|---|---|---|---|---|---|---|")
    for refinements, boxes in SIZES:
        for ranks in [int(r) for r in sys.argv[2:]] or [1, 2]:
            result = run(executable, ranks, refinements, boxes)
            phases = result["seconds_per_phase"]
            newton = result["newton_iterations"]
            print(f"| {result['dofs']:.0f} | {ranks} "
                  f"| {phases['assembly'] / newton:.3f} "
                  f"| {phases['factorisation'] / result['factorizations']:.3f} "
                  f"| {phases['solve'] / newton:.3f} "
                  f"| {phases['phase field'] / result['coupling_iterations']:.3f} "
                  f"| {phases['output'] + phases['setup']:.2f} "
                  f"| {result['wall_time_s']:.1f} |", flush=True)


if __name__ == "__main__":
    main()
