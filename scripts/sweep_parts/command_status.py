# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py status: where each case stands, by its files and the queue."""
import os
import signal
import sys
import time

from . import collect, jobs, slurm, table

HELP = "tell what is queued, running (step, load, age, time left), failed (why)"
OPTIONS = ()


def run(arguments, study):
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    queued = {}
    if slurm.available():
        try:
            queued = jobs.in_queue(study.output)
        except slurm.QueueError as error:
            print("the queue does not answer (%s); what follows is from files only"
                  % error, file=sys.stderr)
    chosen = study.chosen(arguments.only)
    lines = [line_of(case, queued) for case in chosen]
    width = max(len(line[0]) for line in lines)
    for name, state, job, words in lines:
        print("%-*s  %-8s  %-22s  %s" % (width, name, state, job, words))
    collect.print_counts(chosen, (state for _, state, _, _ in lines))
    return 0


def line_of(case, queued):
    """(name, state, job, words)."""
    state, reason = case.state()
    task, queued_id = queued.get(case.name, (None, None))
    words, job = [reason] if reason and state != "running" else [], ""
    if task:
        job = "%s %s" % (task.job, task.state.lower())
        if task.state == "PENDING":
            words.insert(0, "%s%s" % ("held: submit puts it in again; "
                                      if slurm.is_held(task) else "", task.reason))
        if queued_id != case.id:
            words.insert(0, "queued with other parameters, and will not be calculated")
        if state == "stopped" and task.state == "RUNNING" and "killed" in reason:
            # on another host, where its lock is not seen
            state, words = "running", []
    if state == "running":
        words = progress(case, task)
    return case.name, state, job, "; ".join(words)


def progress(case, task):
    """Of a case that is running: step, load, age of the last row, time left."""
    path = case.path("statistics.csv")
    rows = table.statistics_of(case.directory)
    words = [] if rows else ["no step yet"]
    if rows:
        force = table.force_column(rows)
        words = ["step %d" % rows[-1].get("step", 0)]
        words += ["%.4g mm" % rows[-1]["displacement_mm"]] \
            if "displacement_mm" in rows[-1] else []
        words += ["%.4g N" % rows[-1].get(force, 0.)] if force else []
        words.append("last row %.0f s ago" % (time.time() - os.path.getmtime(path)))
    if task and task.left not in ("", "INVALID", "NOT_SET"):
        words.append("%s left" % task.left)
    return [", ".join(words)]
