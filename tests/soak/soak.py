#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Kills and signals at random moments, resumes on other numbers of ranks, and
compares what comes out with a run that nobody disturbed.

    soak.py EXECUTABLE MPIRUN [--disturbances 100] [--seed N] [--case strip]
            [--ranks 1,2,3] [--keep DIRECTORY]

A run is started, disturbed and resumed until it ends; then its files are
compared (compare.py says with what tolerance, and what may differ for which
reason), it is resumed once more, which must change nothing, and the next run
begins. A kill may cost what came after the last checkpoint but one; a request
to stop may cost nothing. Prints figures, and every offence with what is needed
to repeat it; exit status 1 when there is one.
"""
import argparse
import collections
import os
import pathlib
import random
import shutil
import sys
import tempfile
import time

import cases
from compare import separation_step, table
from disturbances import LAUNCHER, LIMIT, Offence
from lives import live
from processes import Run


class Soak:
    """All that happens, from one seed."""

    def __init__(self, options, folder):
        self.options = options
        self.folder = folder
        self.random = random.Random(options.seed)
        self.case = cases.CASES[options.case]
        self.every = int(next(setting.split("=")[1] for setting in self.case[1]
                              if setting.startswith("Output/Checkpoint every")))
        self.counts = collections.Counter()
        self.largest = {}
        self.slowest_stop = 0.
        self.history = []

    def start(self, ranks, directory, *options, way=None, out="out.txt"):
        """A piece, started in one of the ways by chance."""
        ways = ["mpirun", LAUNCHER.name] + (["program"] if ranks == 1 else [])
        way = way or self.random.choice(ways)
        program = os.path.abspath(self.options.executable)
        begin = {"program": [program],
                 "mpirun": [self.options.mpirun, "-n", str(ranks), program],
                 LAUNCHER.name: [str(LAUNCHER), "-n", str(ranks)]}[way]
        run = Run(begin + cases.arguments(self.case, directory, *options),
                  program, self.folder / out, cwd=self.folder,
                  env=dict(MIXED_CRACKS_PROGRAM=program,
                           MIXED_CRACKS_MPIRUN=self.options.mpirun))
        run.way = way
        return run

    def finish(self, run):
        status = run.wait(LIMIT)
        if status is None:
            run.end()
            raise Offence("still running after %g s" % LIMIT)
        return status


def uninterrupted(soak):
    """What all others are compared with."""
    directory = soak.folder / "whole"
    run = soak.start(soak.options.ranks[0], directory, way="mpirun")
    try:
        status = soak.finish(run)
    except Offence as offence:
        status = str(offence)
    if status != 0:
        sys.exit("the uninterrupted run failed: %s\n%s" % (status, run.text()))
    rows, _ = table(directory / "statistics.csv")
    print("uninterrupted on %d ranks: %d steps, a crack runs in step %s"
          % (soak.options.ranks[0], int(rows[-1]["step"]),
             separation_step(directory)), flush=True)
    return directory


def largest_force(soak):
    return max([value for column, value in soak.largest.items()
                if " force_" in column] or [0.])


def read_options():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("executable")
    parser.add_argument("mpirun")
    parser.add_argument("--disturbances", type=int, default=100)
    parser.add_argument("--seed", type=int,
                        default=random.SystemRandom().randrange(10 ** 6))
    parser.add_argument("--case", choices=sorted(cases.CASES), default="strip")
    parser.add_argument("--ranks", default="1,2,3", type=lambda text: [
        int(word) for word in text.split(",")])
    parser.add_argument("--keep", help="a directory for what went wrong")
    return parser.parse_args()


def soak_all(soak):
    """The number of offences."""
    whole = uninterrupted(soak)
    n_left, n_failed, life = soak.options.disturbances, 0, 0
    while n_left > 0:
        directory = soak.folder / ("life-%d" % life)
        life += 1
        soak.history, before = [], sum(soak.counts.values())
        try:
            n_left -= live(soak, directory, whole, n_left)
        except Offence as offence:
            n_failed += 1
            n_left -= max(1, len(soak.history) // 2)
            print("OFFENCE in life %d: %s\n  after: %s"
                  % (life, offence, "; ".join(soak.history)), flush=True)
            if soak.options.keep:
                shutil.copytree(directory, os.path.join(
                    soak.options.keep, directory.name), dirs_exist_ok=True)
        assert sum(soak.counts.values()) > before
        shutil.rmtree(directory, ignore_errors=True)
    return n_failed


def main():
    options = read_options()
    print("seed %d" % options.seed, flush=True)
    with tempfile.TemporaryDirectory() as folder:
        soak = Soak(options, pathlib.Path(folder))
        begun = time.monotonic()
        n_failed = soak_all(soak)
    for what, count in sorted(soak.counts.items()):
        print("%5d %s" % (count, what))
    for column, value in sorted(soak.largest.items(), key=lambda each: -each[1])[:5]:
        print("%.1e largest difference in %s" % (value, column))
    print("forces differ by at most %.1e of the peak up to separation; slowest "
          "stop %.1f s; %d offences; %.0f s"
          % (largest_force(soak), soak.slowest_stop, n_failed,
             time.monotonic() - begun))
    return 1 if n_failed else 0


if __name__ == "__main__":
    sys.exit(main())
