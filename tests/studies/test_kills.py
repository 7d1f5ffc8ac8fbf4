#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""200 cases through submit under a real Slurm, on a program that is none, with random
kills of tasks and of the controller: no case is advanced by two processes at a time,
no complete case is calculated again, held tasks are found, none is lost.

usage: test_kills.py [--cases N] [--kills N] [--seed N]

Exit status 77 where Slurm is not installed.
"""
import argparse
import os
import pathlib
import random
import signal
import sys
import tempfile
import time

import slurm
from sweeps import SKIPPED, Sweep, overlaps

SWEEP = """base = base.prm
common = --set Model/Steps=4 --set Model/Seconds=0.4
grid = "Model/Case" : 1:%d:1
name = c{Case}
"""
ROUNDS = 12  # submissions, at most, until all are complete


class Disturber:
    """Kills one thing after another, while tasks run."""

    def __init__(self, cluster, sweep, dice):
        self.cluster, self.sweep, self.dice = cluster, sweep, dice
        self.done = {}

    def running(self):
        """[process] of programs that have begun and not ended."""
        begun = {}
        for _, case, process, word, _ in self.sweep.events():
            if word == "start":
                begun[process] = case
            elif word in ("end", "stopped", "refused"):
                begun.pop(process, None)
        return [process for process in begun if is_fake(process)]

    def tasks(self):
        """{id: state} of the arrays of the sweep."""
        return {job: words[0] for job, words in self.cluster.queue().items()
                if "_" in job}

    def disturb(self):
        """Whether there was something to kill."""
        ways = (self.program, self.task, self.task, self.job, self.controller,
                self.hold, self.requeue_held)
        way = self.dice.choice(ways)
        if not way():
            return False
        self.done[way.__name__] = self.done.get(way.__name__, 0) + 1
        return True

    def program(self):
        running = self.running()
        return bool(running) and ended(self.dice.choice(running))

    def task(self):
        """The starter of a program, which goes on without it for a moment."""
        running = self.running()
        if not running:
            return False
        parent = parent_of(self.dice.choice(running))
        return parent is not None and parent > 1 and ended(parent)

    def job(self):
        return self.one("RUNNING", "scancel", "--signal=KILL", "--full")

    def controller(self):
        """Goes on from its state after a moment without."""
        self.cluster.kill_controller()
        time.sleep(self.dice.uniform(0., 2.))
        self.cluster.start_controller()
        return True

    def hold(self):
        return self.one("PENDING", "scontrol", "hold")

    def requeue_held(self):
        return self.one("RUNNING", "scontrol", "requeuehold")

    def one(self, state, *words):
        jobs = [job for job, found in self.tasks().items() if found == state]
        if not jobs:
            return False
        self.cluster.said(*words, self.dice.choice(jobs))
        return True


def is_fake(process):
    """Whether the number is still that of a program of this test."""
    try:
        text = pathlib.Path("/proc/%d/cmdline" % process).read_bytes()
    except OSError:
        return False
    return b"/mixed-cracks\0" in text


def parent_of(process):
    try:
        text = pathlib.Path("/proc/%d/stat" % process).read_text()
    except OSError:
        return None
    parent = int(text.rpartition(")")[2].split()[1])
    try:
        line = pathlib.Path("/proc/%d/cmdline" % parent).read_bytes()
    except OSError:
        return None
    return parent if b"sweep.py" in line else None


def ended(process):
    try:
        os.kill(process, signal.SIGKILL)
        return True
    except ProcessLookupError:
        return False


def waiting_or_running(tasks):
    """Of (state, name, reason): what is not held, and not the table behind."""
    return [job for job, (state, name, reason) in tasks.items()
            if not name.endswith(".collect") and "held" not in reason.lower()]


def until_complete(cluster, sweep, disturber, kills):
    """Submits, again and again; returns how often."""
    left = kills
    for number in range(1, ROUNDS + 1):
        said = sweep.call("submit", "--cases-per-job", 2)
        print("submission %d: %s" % (number, said.splitlines()[-1]), flush=True)
        if "nothing is missing" in said and not left:
            return number
        if "nothing to submit" in said:  # a program that has outlived its starter
            time.sleep(2.)
        compared = time.monotonic()
        while waiting_or_running(cluster.queue()):
            if left and disturber.disturb():
                left -= 1
            cluster.resume_node()
            if not left and time.monotonic() > compared + 20.:
                compared = time.monotonic()
                cluster.compare_notes()
            time.sleep(disturber.dice.uniform(0.2, 2.) if left else 0.5)
    raise AssertionError("not complete after %d submissions" % ROUNDS)


def check(sweep, number):
    """Nothing is lost, nothing done twice."""
    events = sweep.events()
    assert not overlaps(events), overlaps(events)
    over = {}
    for moment, case, process, word, step in events:
        if case in over:
            raise AssertionError("%s: %s after its end" % (case, word))
        if word == "end":
            over[case] = moment
    assert len(over) == number, len(over)
    sweep.call("collect")
    table = sweep.table()
    assert list(table) == ["c%d" % k for k in range(1, number + 1)]
    assert len({row["case_id"] for row in table.values()}) == number
    for name, row in table.items():
        assert row["state"] == "complete" and row["Case"] == name[1:], row
    return events


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=random.randrange(10**6))
    arguments = parser.parse_args()
    if slurm.missing():
        print("skipped: there is no Slurm here (%s); scripts/install-packages brings it"
              % ", ".join(slurm.missing()))
        return SKIPPED
    print("seed %d" % arguments.seed, flush=True)
    with tempfile.TemporaryDirectory() as temporary:
        pathlib.Path(temporary).chmod(0o755)  # munge wants everybody to get in
        cluster = slurm.Cluster(pathlib.Path(temporary) / "slurm", cpus=8,
                                max_array_size=41)
        try:
            sweep = Sweep(pathlib.Path(temporary) / "sweep", SWEEP % arguments.cases)
            disturber = Disturber(cluster, sweep, random.Random(arguments.seed))
            number = until_complete(cluster, sweep, disturber, arguments.kills)
            events = check(sweep, arguments.cases)
        finally:
            cluster.stop()
    starts = sum(event[3] == "start" for event in events)
    print("%d cases complete after %d submissions and %d starts; killed: %s; refused "
          "by the lock of the program: %d" % (
              arguments.cases, number, starts, disturber.done,
              sum(event[3] == "refused" for event in events)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
