# SPDX-License-Identifier: GPL-2.0-or-later
"""Starting the program from a test, and reading what it leaves. Tests of many kinds
share it; those in a folder find it by its path:

    sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
"""
import atexit
import csv
import functools
import json
import os
import pathlib
import subprocess
import tempfile
import threading


def environment(**more):
    """What mpirun needs on any machine, root and few cores included."""
    return dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMP_NUM_THREADS="1",
                OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                OMPI_MCA_rmaps_base_oversubscribe="1",
                OMPI_MCA_hwloc_base_binding_policy="none",
                OMPI_MCA_btl_vader_single_copy_mechanism="none", **more)


def command(executable, launcher=(), ranks=1):
    """The words before the options. One rank needs no launcher, which would take
    as long again as the start of the program."""
    if launcher and int(ranks) > 1:
        return [*launcher, "-n", str(ranks), executable]
    return [executable]


def as_options(settings):
    """--set for each entry; of several the last one holds, as an entry may be set
    once only."""
    words = []
    for setting in dict(setting.split("=", 1) for setting in settings).items():
        words += ["--set", "=".join(setting)]
    return words


def output_of(words, status=0, timeout=1200, **keywords):
    """What it says on both streams; its exit status has to be that one."""
    keywords.setdefault("env", environment())
    result = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, timeout=timeout,
                            check=False, **keywords)
    assert result.returncode == status, (words, result.returncode, result.stdout)
    return result.stdout


def rows(directory):
    path = pathlib.Path(directory) / "statistics.csv"
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def summary(directory):
    path = pathlib.Path(directory) / "summary.json"
    return json.loads(path.read_text(encoding="utf-8"))


class Program:
    """The program, which is started for each case."""

    def __init__(self, executable, launcher="", ranks=1):
        self.words = command(os.path.abspath(executable), [launcher], ranks)

    def run(self, words, folder=None):
        """(exit status, standard output, error stream) of these arguments there."""
        result = subprocess.run([*self.words, *words], cwd=folder, text=True,
                                errors="replace", stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                timeout=1200, check=False, env=environment())
        return result.returncode, result.stdout, result.stderr

    def output_of(self, words, status=0, cwd=None):
        """What it says on both streams; its exit status has to be that one."""
        found, out, err = self.run([str(word) for word in words], cwd)
        assert found == status, (words, found, out, err)
        return out + err


class CaseRunner(Program):
    """The same in one process on one rank for all cases (case_runner.cc): most of a
    short run is the start of the program. Not for questions, nor where a start or an
    end is what is looked at."""

    def __init__(self, executable):
        super().__init__(executable)
        self.lock = threading.Lock()
        self.scratch = tempfile.TemporaryDirectory()
        self.process = subprocess.Popen(
            self.words, text=True, errors="replace", env=environment(),
            stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        atexit.register(self.process.communicate)

    def run(self, words, folder=None):
        streams = [pathlib.Path(self.scratch.name) / name for name in ("out", "err")]
        with self.lock:
            self.process.stdin.write("\t".join(
                [os.path.abspath(folder or "."), *map(str, streams), *words]) + "\n")
            self.process.stdin.flush()
            answer = self.process.stdout.readline()
            out, err = (path.read_text(encoding="utf-8", errors="replace")
                        for path in streams)
        assert answer, ("the case runner has ended", words, out, err)
        return int(answer), out, err


class CaseServer(Program):
    """The same on several ranks, each of them a copy of a process that has loaded the
    libraries (case_server.cc). Ranks start MPI anew for each case: of communicators
    that come and go for many runs, some have waited for ever."""

    def __init__(self, folder, launcher, ranks):
        self.scratch = tempfile.TemporaryDirectory()
        socket = os.path.join(self.scratch.name, "socket")
        self.words = command(str(folder / "case_client"), [launcher], ranks) + [socket]
        self.process = subprocess.Popen(
            [str(folder / "case_server"), socket], env=environment(), text=True,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        atexit.register(self.process.communicate)
        assert self.process.stdout.readline() == "ready\n", "no case server"


@functools.lru_cache(maxsize=None)
def runner(executable, launcher, ranks):
    """What runs cases on so many ranks: made once, and without a start of the program
    for each where the helpers of the tests have been built beside it."""
    folder = pathlib.Path(executable).resolve().parent / "tests"
    if not all((folder / name).exists()
               for name in ("case_runner", "case_server", "case_client")):
        return Program(executable, launcher, ranks)
    if ranks == 1:
        return CaseRunner(folder / "case_runner")
    return CaseServer(folder, launcher, ranks)
