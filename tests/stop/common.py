# SPDX-License-Identifier: GPL-2.0-or-later
"""What the tests of stopping share: a short case, and runs that are watched.

The test scripts are called with EXECUTABLE and MPIRUN.
"""
import csv
import os
import pathlib
import signal
import subprocess
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program
from program import as_options  # noqa: E402, F401

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASE = ROOT / "parameters" / "epdm" / "punctured_strip.prm"
# 48 steps of one length, before anything breaks
COARSE = ["Mesh/Refined surroundings=", "Mesh/Adaptive levels=0",
          "Geometry/Punctured strip/Cell size=2",
          "Model/Length scale=4", "Model/Coupling tolerance=1e-4",
          "Load stepping/End time=4.8", "Load stepping/First step=0.1",
          "Load stepping/Largest step=0.1", "Output/Field format=none"]
LAUNCHER = ROOT / "scripts" / "mixed-cracks-run"
WAIT = 120.  # s, when the machine is busy


def set_environment():
    os.environ.update(program.environment(
        MIXED_CRACKS_PROGRAM=sys.argv[1], MIXED_CRACKS_MPIRUN=" ".join(sys.argv[2:])))


def direct():
    return program.command(sys.argv[1])


def by_mpirun(ranks):
    return [*sys.argv[2:], "-n", str(ranks), sys.argv[1]]


def by_launcher(ranks=None):
    return [str(LAUNCHER)] + (["-n", str(ranks)] if ranks else [])


def start(how, directory, *options, settings=(), case=CASE, coarse=COARSE, **keywords):
    """A process; how: the command before the options of the program."""
    command = how + [str(case), "--output", str(directory), *options]
    command += as_options((*coarse, *settings))
    return subprocess.Popen(command, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            text=True, start_new_session=True, **keywords)


def finish(process, status):
    output, _ = process.communicate(timeout=WAIT)
    assert process.returncode == status, (process.args, process.returncode, output)
    return output


def run(how, directory, *options, status=0, **keywords):
    return finish(start(how, directory, *options, **keywords), status)


def rows(directory):
    """Whole rows of statistics.csv, so far."""
    try:
        with open(directory / "statistics.csv", encoding="utf-8", newline="") as file:
            lines = [line for line in file if line.endswith("\n")]
    except OSError:
        return []
    return list(csv.DictReader(lines))


def wait_for(condition, process):
    """Until it holds; the process must not end before."""
    deadline = time.time() + WAIT
    while not condition():
        assert process.poll() is None, process.communicate()[0]
        assert time.time() < deadline, "waited in vain"
        time.sleep(0.01)


def wait_for_rows(directory, number, process):
    wait_for(lambda: len(rows(directory)) >= number, process)


def ask(process, number):
    process.send_signal(number)


def kill(process):
    """With all that it has started; each is in a session of its own."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.communicate()


def compare(found, expected, but=()):
    """Forces and energies to 1e-5 of the largest; steps and times exactly."""
    assert len(found) == len(expected), (len(found), len(expected))
    for name in ("step", "time_s", "displacement_mm", "cells", "dofs"):
        assert [row[name] for row in found] == [row[name] for row in expected], name
    for name in ("force_x_N", "force_y_N", "elastic_energy_mJ", "crack_energy_mJ",
                 "external_work_mJ", "min_phase_field"):
        largest = max(abs(float(row[name])) for row in expected)
        for one, other in zip(found, expected):
            a, b = float(one[name]), float(other[name])
            assert abs(a - b) <= 1e-5 * largest, (name, one["step"], a, b)
