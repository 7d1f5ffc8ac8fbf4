# SPDX-License-Identifier: GPL-2.0-or-later
"""Slurm: what is asked of it, and what it says. Needs sbatch, squeue, scontrol and
scancel, and no accounting."""
import collections
import os
import re
import shutil
import subprocess
import time

from .errors import SweepError

# of sbatch, and scontrol, when the controller does not answer
AWAY = re.compile(r"contact|timed out|timeout|connect|temporarily", re.IGNORECASE)
ATTEMPTS = 8
PAUSE = 5.  # s, between attempts
FORMAT = "%i|%F|%K|%j|%T|%r|%L"

# job: as scancel takes it; array, index: of the task; name: of the job; state,
# reason: words of Slurm; left: its time, as text
Task = collections.namedtuple("Task", "job array index name state reason left")


class QueueError(Exception):
    """Slurm does not do or tell what it is asked; the text is its own."""


def is_held(task):
    return task.state in ("PENDING", "SPECIAL_EXIT") and "held" in task.reason.lower()


def available():
    return shutil.which("sbatch") is not None


def require():
    if not available():
        raise SweepError("there is no sbatch on this machine; --dry-run shows what would "
                         "be submitted, and 'run' needs no queue")


def called(*words):
    """What a command of Slurm says; raises QueueError."""
    try:
        process = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True,
                                 text=True, timeout=120., check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise QueueError("%s: %s" % (words[0], error))
    if process.returncode != 0:
        lines = process.stderr.strip().splitlines() or ["no answer"]
        raise QueueError("%s: %s" % (words[0], lines[-1]))
    return process.stdout


def known_of(*words):
    """The same; '' where there is no answer."""
    try:
        return called(*words)
    except QueueError:
        return ""


def queue():
    """[Task] of this user: what waits, runs or is about to end. Raises QueueError."""
    text = called("squeue", "--noheader", "--array", "--user", str(os.getuid()),
                  "--format", FORMAT)
    lines = [line.strip().split("|") for line in text.splitlines()]
    return [Task(*words) for words in lines if len(words) == len(Task._fields)]


def patiently(function, patient=True):
    """Its result; tries again while the controller does not answer."""
    for attempt in range(ATTEMPTS):
        try:
            return function()
        except QueueError as error:
            if attempt + 1 == ATTEMPTS or not patient or not AWAY.search(str(error)):
                raise
            time.sleep(PAUSE)
    return None


def submit(script, name, *options):
    """Id of the job of that name, which is submitted once, even when the answer to
    the first attempt was lost. Raises QueueError."""
    tried = False

    def once():
        nonlocal tried
        if tried:
            for task in queue():
                if task.name == name:
                    return task.array
        tried = True
        return called("sbatch", "--parsable", *options, script).strip().split(";")[0]

    return patiently(once)


def cancel(jobs):
    """Takes tasks out of the queue. Raises QueueError."""
    jobs = list(jobs)
    for first in range(0, len(jobs), 100):
        part = jobs[first:first + 100]
        patiently(lambda part=part: called("scancel", *part))


def max_array_size():
    """One more than the largest index of an array; Slurm's default where there is no
    Slurm."""
    match = re.search(r"MaxArraySize\s*=\s*(\d+)", known_of("scontrol", "show", "config"))
    return int(match.group(1)) if match else 1001


def launcher():
    """What starts ranks within a job: srun, where it speaks pmix."""
    return "srun --exact --mpi=pmix" \
        if "pmix" in known_of("srun", "--mpi=list").split() else "mpirun"


# within a job

def own_job():
    """{"job", "restart"} of the job that this process belongs to, in any queue;
    empty without one."""
    known = os.environ
    if "SLURM_JOB_ID" in known:
        return {"job": own_id(), "restart": int(known.get("SLURM_RESTART_COUNT", "0"))}
    for name in ("PBS_JOBID", "JOB_ID", "LSB_JOBID"):
        if known.get(name):
            index = known.get("SGE_TASK_ID", "undefined")
            return {"job": known[name] + ("" if index == "undefined" else "." + index)}
    return {}


def own_id():
    return "%(SLURM_ARRAY_JOB_ID)s_%(SLURM_ARRAY_TASK_ID)s" % os.environ \
        if "SLURM_ARRAY_JOB_ID" in os.environ else os.environ["SLURM_JOB_ID"]


def requeue_own():
    """Puts the job of this process back into the queue, which ends the process.
    Raises QueueError."""
    patiently(lambda: called("scontrol", "requeue", own_id()))
