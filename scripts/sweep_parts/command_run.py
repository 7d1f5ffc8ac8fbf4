# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py run: what is missing, on this machine."""
import contextlib
import os
import shlex
import signal
import sys

from report_parts import safe

from . import collect, resources, runner
from .progress import Progress

HELP = "run what is missing here, several at a time, and write the table"
OPTIONS = resources.options("ranks", "launcher") + [
    ("--jobs", "J", "runs at a time (1)", {"type": resources.positive, "default": 1}),
    ("--mpirun", "COMMAND", "the same as --launcher (mpirun)", {"dest": "launcher"}),
    ("--list", None, "print one line with the command of each run"),
    ("--table-only", None, "run nothing, write the table of what there is"),
    ("--again", None, "repeat runs that are complete as well; what was there is kept "
     "beside it")]


def run(arguments, study):
    chosen = study.chosen(arguments.only)
    if arguments.table_only:
        os.makedirs(study.output, exist_ok=True)
        return write_table(study, chosen, {}, True)
    launch = runner.launch_of(arguments, study.program, needed=not arguments.list)
    if arguments.list:
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # as in "--list | head -1"
        for case in chosen:
            print(shlex.join(launch.command(case, case.has_checkpoint())))
        return 0
    with contextlib.closing(study.claim()):
        statuses, whole = run_those_left(chosen, launch, arguments)
        return write_table(study, chosen, statuses, whole)


def run_those_left(chosen, launch, arguments):
    """({name: exit status} of what was run, whether that is all of it)."""
    if arguments.again:
        for case in {case.id: case for case in chosen}.values():
            case.move_aside()
    left = missing_of(chosen)
    n_complete = sum(case.is_complete() for case in chosen)
    if n_complete:
        print("%d of %d runs are complete already" % (n_complete, len(chosen)),
              flush=True)
    workers = runner.Runner(launch, arguments.jobs)
    workers.listen()
    progress = Progress(len(left), arguments.jobs)
    statuses = workers.all(left, progress.done, progress.begin)
    progress.end()
    for case in chosen:  # names of a case that another name has brought
        if case.record():
            case.make_link()
    if workers.stopped:
        print("stopped; %d runs were not started" % (len(left) - progress.n_done))
    return statuses, not workers.stopped


def missing_of(chosen):
    """The cases that are not complete, each id once."""
    left = safe.grouped((case for case in chosen if not case.is_complete()),
                        lambda case: case.id)
    return [own[0] for own in left.values()]


def write_table(study, chosen, statuses, whole):
    """Of the whole file, also when only some have been run; the exit status."""
    rows = collect.rows_of(list(study.cases.values()))
    print(collect.write(study, rows))
    names = [case.name for case in chosen]
    for row in rows:
        if row["name"] in names and row["state"] == "stale":
            print("stale: %s: %s" % (row["name"], row["reason"]), file=sys.stderr)
    mixture = collect.mixture_of(rows)
    if mixture:
        print("warning: " + mixture, file=sys.stderr)
    failed = [row["name"] for row in rows if row["name"] in names
              and (row["state"] == "failed" or statuses.get(row["name"]))]
    if failed:
        print("failed: " + ", ".join(failed), file=sys.stderr)
    return 1 if failed or not whole else 0
