# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of a sweep: their commands, whether they are done, several at a time."""
import os
import shlex
import signal
import subprocess
import threading
import time
from concurrent.futures import ThreadPoolExecutor, as_completed

from . import lock, table

# One thread per rank; no binding, for several runs share the cores. Open MPI
# refuses root, the usual user of a container, unless told.
ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1",
               "OMPI_MCA_hwloc_base_binding_policy": "none",
               "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
               "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1",
               "DEAL_II_NUM_THREADS": "1"}
# They do not change what a run comes to.
WITHOUT_EFFECT = ("--overwrite", "--resume")


class Run:
    def __init__(self, sweep, name, arguments):
        self.name = name
        self.directory = os.path.join(os.path.abspath(arguments.output), name)
        options = sweep.options(name, arguments.extra)
        self.options = [word for word in options if word not in WITHOUT_EFFECT]
        self.base, self.checksum = sweep.base, sweep.base_checksum()
        self.launcher = shlex.split(arguments.mpirun)
        if self.launcher:
            self.launcher += ["-n", str(arguments.ranks)]
        self.program = arguments.program
        self.resume = "--resume" in options and os.path.isdir(
            os.path.join(self.directory, "checkpoint"))
        self.status = None

    @property
    def command(self):
        return self.launcher + [
            self.program, "--resume" if self.resume else "--overwrite",
            "--output", self.directory] + self.options + [self.base]

    def is_complete(self):
        """Whether it has been run to its end, with these options."""
        summary = table.summary_of(self.directory)
        return summary.get("exit_status") == 0 \
            and table.exit_status_of(self.directory, summary) == 0 \
            and self.is_described_by(table.record_of(self.directory))

    def is_described_by(self, record):
        return record.get("options") == shlex_joined(self.options) \
            and record.get("base") == self.checksum

    def differs(self):
        """Whether what is there was made with other options or another base."""
        record = table.record_of(self.directory)
        return bool(record) and not self.is_described_by(record)

    def note(self, status=None):
        with open(os.path.join(self.directory, table.COMMAND_FILE), "w",
                  encoding="utf-8") as stream:
            stream.write("%s\n# options: %s\n# base: %s\n"
                         % (shlex_joined(self.command), shlex_joined(self.options),
                            self.checksum))
            if status is not None:
                stream.write("# exit status: %d\n" % status)


def shlex_joined(words):
    return " ".join(shlex.quote(word) for word in words)


class Runner:
    """Runs several at a time; stop() ends those that are going on."""

    def __init__(self, jobs):
        self.jobs = jobs
        self.going_on = set()
        self.stopped = False
        self.stopped_at = 0.
        self.lock = threading.RLock()

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
            self.stopped = True
            for process in self.going_on:
                try:
                    process.send_signal(how)
                except OSError:
                    pass

    def status_of(self, process):
        """Waits for it. A launcher that has just started may lose a signal."""
        while True:
            try:
                return process.wait(5.)
            except subprocess.TimeoutExpired:
                if self.stopped:
                    process.send_signal(signal.SIGUSR1)

    def one(self, run):
        """Sets run.status; returns the seconds it took."""
        begin = time.time()
        try:
            os.makedirs(run.directory, exist_ok=True)
            lock.require_free(run.directory)
            # an old summary must not pass for that of a run that is killed
            summary = os.path.join(run.directory, "summary.json")
            if os.path.exists(summary):
                os.remove(summary)
            run.note()
            with open(os.path.join(run.directory, "screen.txt"), "wb") as screen:
                with self.lock:
                    if self.stopped:
                        return 0.
                    # a session of its own: Ctrl-C must not kill it half-way
                    process = subprocess.Popen(
                        run.command, stdin=subprocess.DEVNULL, stdout=screen,
                        stderr=subprocess.STDOUT, start_new_session=True,
                        env=dict(ENVIRONMENT, **os.environ))
                    self.going_on.add(process)
                run.status = self.status_of(process)
                with self.lock:
                    self.going_on.discard(process)
            run.note(run.status)
        except lock.InUse as error:
            run.status = 4
            print("%s: %s" % (run.name, error), flush=True)
        except OSError as error:
            run.status = 127
            print("%s: %s" % (run.name, error), flush=True)
        return time.time() - begin

    def all(self, runs, when_done):
        with ThreadPoolExecutor(max_workers=self.jobs) as pool:
            futures = {}
            for run in runs:
                futures[pool.submit(self.one, run)] = run
            for future in as_completed(futures):
                if futures[future].status is not None:
                    when_done(futures[future], future.result())


def last_words(run):
    """Why a run failed: its error message, the reason in its summary, or what it
    wrote last."""
    try:
        with open(os.path.join(run.directory, "screen.txt"), encoding="utf-8",
                  errors="replace") as stream:
            lines = [line.strip() for line in stream if line.strip()]
    except OSError:
        return ""
    errors = [line for line in lines if "error:" in line]
    reason = table.summary_of(run.directory).get("exit_reason")
    return errors[-1] if errors else str(reason) if reason else (lines or [""])[-1]
