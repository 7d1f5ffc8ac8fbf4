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
import re
import shutil
import signal
import sys
import tempfile
import time

import cases
from compare import Difference, compare, strict_json, table
from processes import MESSAGE, Run, is_alive

LIMIT = 300.  # s that one piece may take; a loaded machine is slow
START_UP = 2.  # s in which a process starts, more or less
STOPPED = 5

# (signal, to whom, whether the program has to stop in good order)
DISTURBANCES = [
    ("KILL", "all ranks", False), ("KILL", "one rank", False),
    ("KILL", "mpirun", False), ("TERM", "mpirun", False),
    ("TERM", "one rank", True), ("TERM", "all ranks", True),
    ("INT", "one rank", True), ("HUP", "one rank", True),
    ("HUP", "all ranks", True), ("USR1", "one rank", True),
    ("USR1", "mpirun", True)]


class Offence(Exception):
    """A promise that was not kept."""


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

    def command(self, ranks, words):
        """On one rank with and without mpirun, in turn by chance."""
        program = [os.path.abspath(self.options.executable), *words]
        if ranks == 1 and self.random.random() < 0.5:
            return program
        return [self.options.mpirun, "-n", str(ranks), *program]

    def start(self, ranks, directory, *options):
        words = cases.arguments(self.case, directory, *options)
        return Run(self.command(ranks, words), self.folder / "out.txt",
                   cwd=self.folder)

    def finish(self, run):
        status = run.wait(LIMIT)
        if status is None:
            run.end()
            raise Offence("still running after %g s" % LIMIT)
        return status


def last_step(directory):
    """Of the last row that is whole; -1 without one."""
    try:
        lines = (directory / "statistics.csv").read_text().split("\n")[1:-1]
        return int(lines[-1].split(",")[0])
    except (OSError, IndexError, ValueError):
        return -1


def has_checkpoint(directory):
    return any((directory / "checkpoint").glob("generation-*/seal.txt"))


def reached(run, step):
    """Whether a piece has come to a step, or has ended."""
    if run.process.poll() is not None:
        return True
    steps = re.findall(r"^step (\d+):", run.text(), re.MULTILINE)
    return bool(steps) and int(steps[-1]) >= step


def moment(soak, run, at):
    """Wait for a random moment: in the start-up, or in one of the next steps."""
    if soak.random.random() < 0.15:
        time.sleep(soak.random.uniform(0., START_UP))
        return
    step = max(at, 0) + soak.random.randint(0, 2 * soak.every)
    deadline = time.monotonic() + LIMIT
    while not reached(run, step):
        if time.monotonic() > deadline:
            raise Offence("step %d is not reached within %g s" % (step, LIMIT))
        time.sleep(0.01)
    time.sleep(soak.random.uniform(0., 0.3))


def targets(soak, run, to_whom):
    """(whom to send the signal, all processes of the run)."""
    ranks = run.ranks()
    everyone = list(ranks)
    if run.launched():
        everyone.append(run.own)
    if to_whom == "one rank" and ranks:
        return [soak.random.choice(ranks)], everyone
    if to_whom == "mpirun" and run.launched():
        return [run.own], everyone
    return ranks, everyone


def disturb(soak, run, at):
    """Send one signal; (its name, whether the program must stop in order)."""
    name, to_whom, polite = soak.random.choice(DISTURBANCES)
    moment(soak, run, at)
    begun = "\nstep " in run.text() or "resumed at step" in run.text()
    whom, everyone = targets(soak, run, to_whom)
    sent = time.monotonic()
    whom = [each for each in whom if is_alive(each)]
    run.send(getattr(signal, "SIG" + name), whom)
    soak.counts["%s to %s" % (name, to_whom if run.launched() else
                              "the program without mpirun")] += bool(whom)
    status = soak.finish(run)
    if polite and begun:
        soak.slowest_stop = max(soak.slowest_stop, time.monotonic() - sent)
    run.end(everyone)
    return "%s to %s" % (name, to_whom), polite and begun and bool(whom), status


def resumed_at(text):
    found = re.search(r"resumed at step (\d+)", text)
    return int(found.group(1)) if found else None


class Life:
    """One run in its directory, from its first start to its end."""

    def __init__(self, soak, directory):
        self.soak, self.directory = soak, directory
        self.safe = -1  # the step from which it must go on, or a later one
        self.stopped = False  # in good order: nothing may be lost

    def options(self):
        if has_checkpoint(self.directory):
            return ["--resume"]
        if self.safe > 0:
            raise Offence("no checkpoint is left, step %d was safe" % self.safe)
        return ["--overwrite"] if self.directory.exists() else []

    def check_start(self, text, options):
        """That a resumed piece goes on from where it has to."""
        step = resumed_at(text)
        if "--resume" not in options or step is None:
            return
        if step < self.safe or (self.stopped and step != self.safe):
            raise Offence("resumed at step %d, safe was %d" % (step, self.safe))
        self.safe = step

    def check_end(self, name, polite, status, text):
        """What a disturbed piece leaves; true when the run has ended."""
        if status == 0:
            return True
        if "internal error" in text or "Signal: Segmentation" in text:
            raise Offence("exit status %d:\n%s" % (status, text[-2000:]))
        self.stopped = status == STOPPED
        step = last_step(self.directory)
        if self.stopped:
            if strict_json(self.directory / "summary.json")["exit_status"] != 5:
                raise Offence("summary.json does not say that it was stopped")
            if step >= 0:
                self.safe = step
        elif polite:
            raise Offence("%s: exit status %d, expected 5:\n%s"
                          % (name, status, text[-2000:]))
        elif MESSAGE in text:
            raise Offence("%s: exit status %d:\n%s" % (name, status, text[-2000:]))
        else:
            every = self.soak.every
            self.safe = max(self.safe, step // every * every - every)
        return False

    def piece(self, ranks, disturbed):
        """One start; true when the run has come to its end."""
        soak, options = self.soak, self.options()
        at = last_step(self.directory) if "--resume" in options else -1
        run = soak.start(ranks, self.directory, *options)
        soak.counts["pieces"] += 1
        soak.history.append("%d ranks %s" % (ranks, " ".join(options)))
        name, polite = "undisturbed", False
        try:
            if disturbed:
                name, polite, status = disturb(soak, run, at)
            else:
                status = soak.finish(run)
        finally:
            run.end()
        text = run.text()
        soak.history.append("%s: exit status %d, step %d"
                            % (name, status, last_step(self.directory)))
        self.check_start(text, options)
        if not disturbed and status != 0:
            raise Offence("exit status %d:\n%s" % (status, text[-2000:]))
        return self.check_end(name, polite, status, text)


def compare_life(soak, directory, whole, what):
    try:
        for column, value in compare(directory, whole).items():
            soak.largest[column] = max(soak.largest.get(column, 0.), value)
    except (Difference, OSError, ValueError, KeyError) as difference:
        raise Offence("%s: %s" % (what, difference)) from difference


def live(soak, directory, whole, n_left):
    """One life with at most n_left disturbances; how many it took."""
    life, n_disturbed, ranks = Life(soak, directory), 0, None
    ended = False
    while not ended:
        ranks = soak.random.choice(
            [each for each in soak.options.ranks if each != ranks]
            or soak.options.ranks)
        disturbed = n_disturbed < n_left
        n_disturbed += disturbed
        ended = life.piece(ranks, disturbed)
    compare_life(soak, directory, whole, "in pieces")
    # what has ended stays as it is
    life.stopped = False
    if has_checkpoint(directory):
        life.piece(soak.random.choice(soak.options.ranks), False)
        compare_life(soak, directory, whole, "resumed after its end")
    soak.counts["lives"] += 1
    return n_disturbed


def uninterrupted(soak):
    """One run for each number of ranks; the first is what is compared with."""
    wholes = []
    for ranks in soak.options.ranks:
        directory = soak.folder / ("whole-%d" % ranks)
        run = soak.start(ranks, directory)
        status = soak.finish(run)
        if status != 0:
            sys.exit("the uninterrupted run failed:\n" + run.text())
        wholes.append(directory)
    for other in wholes[1:]:
        compare_life(soak, other, wholes[0], other.name)
    rows, _ = table(wholes[0] / "statistics.csv")
    print("uninterrupted on %s ranks: %d steps, separated: %s, largest "
          "difference of a force %.1e" %
          (soak.options.ranks, int(rows[-1]["step"]),
           strict_json(wholes[0] / "summary.json")["separated"],
           largest_force(soak)), flush=True)
    return wholes[0]


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
