# SPDX-License-Identifier: GPL-2.0-or-later
"""Advances cases, several at a time, on this machine or within a job of a queue."""
import contextlib
import signal
import subprocess
import threading
import time
from concurrent.futures import ThreadPoolExecutor, as_completed

from . import lock, resources
from .advance import FILES, Piece
from .program import environment


class Launch:
    """How the program is started: launcher: words that take -n RANKS, may be none."""

    def __init__(self, program, launcher, ranks, job=None):
        self.program, self.ranks, self.job = program, ranks, job or {}
        self.launcher = [*launcher, "-n", str(ranks)] if launcher else []

    def command(self, case, resume):
        return self.launcher + [
            self.program.path, "--resume" if resume else "--overwrite",
            "--output", case.directory] + case.options + [case.base]


def launch_of(arguments, program, job=None, needed=True):
    """A Launch as options and cluster.ini say; needed: on this machine."""
    given = resources.resources_of(arguments)
    return Launch(program, resources.launcher_words(given["launcher"], needed),
                  given["ranks"], job)


class Runner:
    """Runs several at a time; stop() ends those that are going on."""

    def __init__(self, launch=None, jobs=1):
        self.launch, self.jobs = launch, jobs
        self.going_on = set()
        self.signal = None  # that asked for an end
        self.stopped_at = 0.
        self.lock = threading.RLock()

    @property
    def stopped(self):
        return self.signal is not None

    def listen(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGUSR1):
            signal.signal(number, self.stop)

    def stop(self, number, *_):
        """A handler of signals: asks the runs to write a checkpoint and end; a
        second Ctrl-C, two seconds later, ends them as they are."""
        # mpirun passes SIGUSR1 on and waits; after SIGTERM it kills within 1 s
        how = signal.SIGUSR1
        with self.lock:
            if not self.stopped:
                self.stopped_at = time.monotonic()
            elif number == signal.SIGINT and time.monotonic() > self.stopped_at + 2.:
                how = signal.SIGTERM
            self.signal = self.signal or number
            for process in self.going_on:
                with contextlib.suppress(OSError):
                    process.send_signal(how)

    def status_of(self, process):
        """Waits for it. A launcher that has just started may lose a signal."""
        while True:
            try:
                return process.wait(5.)
            except subprocess.TimeoutExpired:
                if self.stopped:
                    process.send_signal(signal.SIGUSR1)

    def started(self, command, screen):
        """(exit status, signal that stopped it or None)."""
        with self.lock:
            if self.stopped:
                return 6, int(self.signal)
            # a session of its own: Ctrl-C must not kill it half-way
            process = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=screen,
                stderr=subprocess.STDOUT, start_new_session=True, env=environment())
            self.going_on.add(process)
        status = self.status_of(process)
        with self.lock:
            self.going_on.discard(process)
            return status, int(self.signal) if self.stopped else None

    def one(self, case, when_begun=None):
        """(exit status, why, seconds); None for a status when it was not begun."""
        begin = time.monotonic()
        status, reason = None, ""
        if not self.stopped:
            if when_begun:
                when_begun(case)
            piece = Piece(case, self.launch.program, self.launch.ranks,
                          self.launch.job)
            try:
                status, reason = piece.advance(self.launch.command, self.started)
            except lock.InUse as error:
                status, reason = FILES, str(error)
            except OSError as error:
                status, reason = 127, str(error)
        return status, reason, time.monotonic() - begin

    def all(self, cases, when_done, when_begun=None):
        """{name: exit status} of those that were begun; when_begun(case) before and
        when_done(case, status, reason, seconds) after each."""
        statuses = {}
        with ThreadPoolExecutor(max_workers=self.jobs) as pool:
            futures = {pool.submit(self.one, case, when_begun): case
                       for case in cases}
            for future in as_completed(futures):
                status, reason, seconds = future.result()
                if status is not None:
                    statuses[futures[future].name] = status
                    when_done(futures[future], status, reason, seconds)
        return statuses
