# SPDX-License-Identifier: GPL-2.0-or-later
"""Starting the program, finding its ranks, and disturbing them.

Only processes that descend from one that was started here are ever touched.
"""
import os
import pathlib
import signal
import subprocess
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

MESSAGE = "mixed-cracks: error: "


def environment(**more):
    return program.environment(
        OMPI_MCA_mpi_yield_when_idle="1",  # others need the cores, too
        OPENBLAS_NUM_THREADS="1", DEAL_II_NUM_THREADS="1", **more)


def status_of(pid):
    """(state, parent, start time) of a process, or None when it is gone."""
    try:
        with open("/proc/%d/stat" % pid) as stream:
            fields = stream.read().rsplit(")", 1)[1].split()
    except OSError:
        return None
    return fields[0], int(fields[1]), fields[19]


def is_alive(identity):
    pid, begun = identity
    status = status_of(pid)
    return status is not None and status[2] == begun and status[0] not in "ZX"


def descendants(pid):
    """[(pid, start time)] of all below a process."""
    children = {}
    for name in os.listdir("/proc"):
        if name.isdigit():
            status = status_of(int(name))
            if status is not None and status[0] not in "ZX":
                children.setdefault(status[1], []).append((int(name), status[2]))
    found, open_ends = [], [pid]
    while open_ends:
        for child in children.get(open_ends.pop(), []):
            found.append(child)
            open_ends.append(child[0])
    return found


def name_of(pid):
    try:
        return os.path.basename(os.readlink("/proc/%d/exe" % pid))
    except OSError:
        return ""


class Run:
    """One start of the program; its output goes to a file, so that it never
    waits for a reader."""

    def __init__(self, command, program, output, **options):
        self.output = output
        self.program = os.path.basename(program)
        with open(output, "wb") as stream:
            self.process = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=stream,
                stderr=subprocess.STDOUT, start_new_session=True,
                env=environment(**options.pop("env", {})), **options)
        status = status_of(self.process.pid)
        self.own = (self.process.pid, status[2] if status else "")

    def ranks(self):
        """[(pid, start time)] of the program itself, launchers left out."""
        return sorted(each for each in self.everyone()
                      if name_of(each[0]) == self.program)

    def mpirun(self):
        return [each for each in self.everyone()
                if name_of(each[0]) in ("mpirun", "orterun", "mpiexec")]

    def everyone(self):
        return [self.own] + descendants(self.process.pid)

    def text(self):
        with open(self.output, errors="replace") as stream:
            return stream.read()

    def send(self, number, identities):
        for identity in identities:
            if is_alive(identity):
                try:
                    os.kill(identity[0], number)
                except ProcessLookupError:
                    pass

    def wait(self, seconds):
        """The exit status, or None when it takes too long."""
        try:
            return self.process.wait(timeout=max(0., seconds))
        except subprocess.TimeoutExpired:
            return None

    def end(self, known=()):
        """Kill whatever is left and wait until it is gone: a rank that lost
        its mpirun needs a moment to notice."""
        left = set(known) | set(descendants(self.process.pid))
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        deadline = time.monotonic() + 10.
        while any(is_alive(each) for each in left):
            if time.monotonic() > deadline:
                self.send(signal.SIGKILL, left)
            time.sleep(0.02)
