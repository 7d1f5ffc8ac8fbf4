# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py task: what a job of any queue calls, and the only thing it has to call.

A complete case is left alone; one with a checkpoint goes on from it; any other is
begun. When the program has been stopped with a checkpoint, because the time of the job
is over, a job of Slurm is requeued. A case that has been started twice without a new
step is given up.

SIGUSR1, SIGTERM, SIGINT and SIGHUP to this process make the program write a
checkpoint. After SIGTERM, by which a queue ends a job, the job is not requeued from
here: Slurm does so itself where it has preempted it.

Exit status: 0 complete; 2 wrong input, or other parameters than were submitted; 3 no
solution, or given up; 4 trouble with files, or somebody else has the case; 5 stopped,
to be called again; another one is that of the program. Of several cases the first of
5, 4, 3, 2, others that occurs.
"""
import os
import sys
import time

from . import manifest, resources, runner, slurm, study
from .advance import FAILED, FILES, OF_ITSELF, PATIENCE, REFUSED, STOPPED, TOO_EARLY
from .errors import SweepError
from .program import Program

HELP = "calculate cases by name; for a job of any queue"
OPENS_ITSELF = True
OPTIONS = [
    ("names", "NAME", "of cases; several run side by side", {"nargs": "*"}),
    ("--group", "K", "of a manifest: the cases of its K-th task, from 0",
     {"type": int})] + resources.options("ranks", "launcher")


def run(arguments, _):
    workers = runner.Runner()
    workers.listen()  # before anything that takes time
    cases, launch = opened(arguments)
    changed = {case.name: REFUSED for case in cases if has_changed(case, launch.program)}
    left = [case for case in cases if case.name not in changed]
    workers.launch, workers.jobs = launch, max(len(left), 1)
    statuses = dict(workers.all(left, report), **changed)
    status = worst([statuses.get(case.name, STOPPED) for case in cases])
    if status == STOPPED and "SLURM_JOB_ID" in os.environ \
            and workers.signal in OF_ITSELF:
        requeue()
    return status


def opened(arguments):
    """([Case], Launch)."""
    if arguments.file.endswith(".json"):
        return of_manifest(arguments)
    if arguments.group is not None or not arguments.names:
        raise SweepError("task expects names of cases; --group is for a manifest")
    found = study.opened(arguments, arguments.names)
    if not found.owner():
        found.claim(PATIENCE).release()
    return (list(found.cases.values()),
            runner.launch_of(arguments, found.program, slurm.own_job()))


def of_manifest(arguments):
    frozen = manifest.read(arguments.file)
    names = list(arguments.names)
    if arguments.group is not None:
        names += frozen.group(arguments.group)
    for name in names:
        if name not in frozen.cases:
            raise SweepError("%s has no case '%s'" % (arguments.file, name))
    if not names:
        raise SweepError("task expects names of cases, or --group")
    program = Program(arguments.program or frozen.content["program"])
    program.expect(frozen.content.get("checksum"), frozen.content["revision"])
    return [frozen.cases[name] for name in names], runner.Launch(
        program, resources.launcher_words(frozen.content["launcher"]),
        frozen.content["ranks"], slurm.own_job())


def has_changed(case, program):
    """Whether a case is not what it was when it was submitted; says so. Raises
    SweepError."""
    found = program.case_id(case.base, case.options)
    if found == case.id.partition("-")[0]:
        return False
    print("%s: stale: '%s' or a file that it reads has changed since this was "
          "submitted, or the program (the id is %s and was %s); nothing is calculated, "
          "submit again" % (case.name, case.base, found, case.id), file=sys.stderr)
    return True


def report(case, status, reason, seconds):
    print("%s: exit status %d after %.0f s%s" % (
        case.name, status, seconds, "; " + reason if reason else ""), flush=True)


def worst(statuses):
    statuses = [STOPPED if status == TOO_EARLY else status for status in statuses]
    for status in (STOPPED, FILES, FAILED, REFUSED):
        if status in statuses:
            return status
    return max(statuses, key=abs) % 256


def requeue():
    try:
        slurm.requeue_own()
    except slurm.QueueError as error:
        print("not requeued: %s; 'sweep.py submit' goes on from the checkpoint" % error,
              file=sys.stderr)
        return
    print("requeued", flush=True)
    time.sleep(60.)  # until Slurm ends this job
