# SPDX-License-Identifier: GPL-2.0-or-later
"""The cases of a sweep in the queue, and the text of the jobs that are submitted."""
import os
import re
import shlex
import sys

from report_parts import safe

from . import manifest, slurm
from .program import ENVIRONMENT

SWEEP = os.path.join(os.path.dirname(os.path.dirname(os.path.realpath(__file__))),
                     "sweep.py")


def in_queue(output):
    """{name of a case: (Task, id of the case)} of what this user has in the queue of
    the submissions of a directory; the newest counts. Raises QueueError."""
    tasks, found = safe.grouped(slurm.queue(), lambda task: task.name), {}
    for frozen in manifest.all_of(output):
        for array in frozen.content["arrays"]:
            for task in tasks.get(array["job_name"], ()):
                index = int(task.index) if task.index.isdigit() else -1
                for name in frozen.names_of(task.name, index):
                    found[name] = task, frozen.cases[name].id
    return found


def quoted(text):
    """A word of an #SBATCH line."""
    return text if re.fullmatch(r"[\w+=./,:%@-]*", text) else \
        '"%s"' % text.replace("\\", "\\\\").replace('"', '\\"')


def script(options, given, *words):
    """A job with these options of sbatch, and the user's; words: the last lines."""
    options = options + ["%s=%s" % (key, given[key]) for key in ("partition", "account")
                         if given[key]]
    lines = ["#!/bin/bash"] + ["#SBATCH " + quoted("--" + option) for option in options]
    lines += ["#SBATCH " + word for word in given["sbatch"].split()]
    lines += ["export %s=%s" % pair for pair in ENVIRONMENT.items()
             if pair[0].endswith("_THREADS")]
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        lines += ["export %s=%s" % pair for pair in ENVIRONMENT.items()
                  if "ROOT" in pair[0]]
    return "\n".join(lines + given["setup"].strip().splitlines() + list(words)) + "\n"


def command(*words):
    return shlex.join((sys.executable, SWEEP) + words)


def array_text(frozen, array, given):
    """The script of one array of a manifest."""
    limit = "%%%d" % given["at a time"] if given["at a time"] else ""
    options = ["job-name=" + array["job_name"],
               "array=0-%d%s" % (array["count"] - 1, limit),
               "output=" + os.path.join(frozen.folder, "%A_%a.log"),
               "open-mode=append", "requeue",
               "signal=B:USR1@%d" % given["signal"],
               "ntasks=%d" % (given["ranks"] * given["cases per job"]),
               "cpus-per-task=1"]
    options += ["time=" + given["time"]] if given["time"] else []
    options += ["mem-per-cpu=" + given["memory"]] if given["memory"] else []
    number = "$SLURM_ARRAY_TASK_ID"
    if array["first"]:
        number = "$((%d + SLURM_ARRAY_TASK_ID))" % array["first"]
    return script(options, given,
                  "# the last line of all: what ends the job is to reach it",
                  "exec %s --group %s" % (command("task", frozen.path), number))


def collect_text(frozen, given, study):
    """The script that writes the table behind the arrays."""
    options = ["job-name=" + frozen.content["token"] + ".collect",
               "output=" + os.path.join(frozen.folder, "collect.log"),
               "open-mode=append", "ntasks=1", "time=30"]
    return script(options, given, "exec " + command(
        "collect", os.path.abspath(study.sweep.path), "--output", study.output,
        "--program", study.program.path))
