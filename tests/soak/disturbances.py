# SPDX-License-Identifier: GPL-2.0-or-later
"""What is done to a run, when, and by whom."""
import re
import signal
import time

import cases
from processes import MESSAGE, is_alive

LIMIT = 300.  # s that one piece may take; a loaded machine is slow
START_UP = 2.  # s in which a process starts, more or less
LAUNCHER = cases.ROOT / "scripts" / "mixed-cracks-run"

INTRUDER = "another process"

# Ways to start the program, and for each (signal, to whom, whether the program
# has to stop in good order). A signal to mpirun other than USR1 is no such
# request: Open MPI kills the ranks soon after.
RANKS = [
    ("KILL", "all ranks", False), ("KILL", "one rank", False),
    ("TERM", "one rank", True), ("TERM", "all ranks", True),
    ("INT", "one rank", True), ("HUP", "one rank", True),
    ("HUP", "all ranks", True), ("USR1", "one rank", True),
    (INTRUDER, "the directory", False)]
DISTURBANCES = {
    "program": RANKS,
    "mpirun": RANKS + [("KILL", "mpirun", False), ("TERM", "mpirun", False),
                       ("INT", "mpirun", False), ("USR1", "mpirun", True)],
    LAUNCHER.name: [("TERM", "launcher", True), ("INT", "launcher", True),
                    ("HUP", "launcher", True), ("USR1", "launcher", True)],
}


class Offence(Exception):
    """A promise that was not kept."""


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
    if to_whom == "launcher":
        return [run.own]
    if to_whom == "mpirun":
        return run.mpirun()
    ranks = run.ranks()
    return [soak.random.choice(ranks)] if to_whom == "one rank" and ranks else ranks


def intrude(soak, run, directory):
    """A second process in the directory of one that runs is refused."""
    other = soak.start(1, directory, "--resume", way="program",
                       out="other.txt")
    status, text = soak.finish(other), other.text()
    # the first may have ended meanwhile, and may have had no checkpoint
    if run.process.poll() is None and (status != 4 or text.count(MESSAGE) != 1):
        raise Offence("a second process in the directory: exit status %s:\n%s"
                      % (status, text[-1000:]))


def disturb(soak, run, at, directory):
    """Send one signal; (its name, whether the program must stop in order,
    exit status)."""
    name, to_whom, polite = soak.random.choice(DISTURBANCES[run.way])
    moment(soak, run, at)
    if name == INTRUDER:
        if (directory / "statistics.csv").exists():
            soak.counts["another process in the directory"] += 1
            intrude(soak, run, directory)
        return name, False, soak.finish(run)
    begun = "\nstep " in run.text() or "resumed at step" in run.text()
    everyone, whom = run.everyone(), targets(soak, run, to_whom)
    sent = time.monotonic()
    whom = [each for each in whom if is_alive(each)]
    run.send(getattr(signal, "SIG" + name), whom)
    soak.counts["%s to %s of %s" % (name, to_whom, run.way)] += bool(whom)
    status = soak.finish(run)
    if polite and begun:
        soak.slowest_stop = max(soak.slowest_stop, time.monotonic() - sent)
    run.end(everyone)
    return "%s to %s of %s" % (name, to_whom, run.way), \
        polite and begun and bool(whom), status


