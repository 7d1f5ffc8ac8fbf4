# SPDX-License-Identifier: GPL-2.0-or-later
"""How a study that makes its own cases has them run: here, or by jobs of a cluster.
Python's own library only."""
import argparse
import contextlib
import time

from sweep_parts import (collect, command_run, command_submit, jobs, resources, runner,
                         slurm)

from .errors import StudyError

PAUSE = 10.  # s between two looks at the queue
OPTIONS = resources.options() + [
    ("--jobs", "J", "runs at a time, here or asked for at once (1)",
     {"type": resources.positive, "default": 1}),
    ("--submit", None, "by jobs of the cluster, waiting for them"),
    ("--no-wait", None, "with --submit: not waiting; the same command goes on when the "
     "jobs have ended")]


class Stopped(StudyError):
    """Not all has been run yet; the same command goes on."""
    exit_status = 5


class NotSubmitted(StudyError):
    """The queue has refused."""
    exit_status = 1


def runs_of(arguments, program):
    """What runs cases, as the options say. Raises StudyError."""
    if arguments.no_wait and not arguments.submit:
        raise StudyError("--no-wait goes with --submit")
    return Jobs(arguments) if arguments.submit else Runs(arguments, program)


class Runs:
    """Here, J at a time."""

    def __init__(self, arguments, program):
        self.arguments = arguments
        arguments.again = False  # as run has it
        self.launch = runner.launch_of(arguments, program)

    def bring(self, study, names):
        """Runs what is missing and writes the table of the study. Raises Stopped."""
        chosen = [study.cases[name] for name in names]
        with contextlib.closing(study.claim()):
            _, whole = command_run.run_those_left(chosen, self.launch, self.arguments)
            collect.write(study, collect.rows_of(list(study.cases.values())))
        if not whole:
            raise Stopped("stopped; the same command goes on from there")


class Jobs:
    """By an array of jobs for what is missing."""

    def __init__(self, arguments):
        self.arguments = arguments

    def bring(self, study, names):
        missing = [name for name in names if not study.cases[name].is_complete()]
        if not missing:
            return
        own = argparse.Namespace(**dict(vars(self.arguments), only=missing,
                                        dry_run=False, failed=False))
        if command_submit.run(own, study) != 0:
            raise NotSubmitted("nothing could be submitted")
        if self.arguments.no_wait:
            raise Stopped("submitted; the same command goes on when the jobs have ended")
        wait_for(study, missing)


def wait_for(study, names):
    """Until every case is complete, or neither running nor in the queue at two looks
    in a row: a job that has just ended may not have written its last word."""
    before = set()
    while True:
        try:
            queued = jobs.in_queue(study.output)
        except slurm.QueueError:
            queued = dict.fromkeys(names)  # no answer: they may all be there
        states = {name: study.cases[name].state()[0] for name in names}
        absent = {name for name in names
                  if name not in queued and states[name] != "running"}
        if all(states[name] == "complete" or name in absent & before for name in names):
            return
        before = absent
        time.sleep(PAUSE)
