#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""One process at a time has an output directory; a second one says who has it, and
changes nothing.

usage: test_lock.py EXECUTABLE MPIRUN
"""
import os
import pathlib
import re
import signal
import tempfile
import time

import common
from common import by_mpirun, direct


def contents(directory):
    """{path: bytes} of all that is there."""
    return {path.relative_to(directory): path.read_bytes()
            for path in sorted(directory.rglob("*")) if path.is_file()}


def a_second_one_is_refused(directory):
    first = common.start(direct(), directory, settings=["Output/Checkpoint every=1"])
    common.wait_for_rows(directory, 3, first)
    # so that what is compared stands still
    os.kill(first.pid, signal.SIGSTOP)
    before = contents(directory)
    for how in (direct(), by_mpirun(2)):
        for options in ([], ["--overwrite"], ["--resume"]):
            output = common.run(how, directory, *options, status=4)
            assert re.search(r"'%s' is in use by process %d on host \S+ since 20"
                             % (directory, first.pid), output), output
            assert output.count("mixed-cracks: error:") == 1, output
    assert contents(directory) == before
    # to look at it is allowed
    common.run(direct(), directory, "--check")
    os.kill(first.pid, signal.SIGCONT)
    common.ask(first, signal.SIGUSR1)
    common.finish(first, 5)
    assert not (directory / ".lock").exists()


def holder_of(directory):
    for line in (directory / ".lock").read_text().splitlines():
        if line.startswith("process "):
            return int(line.split()[1])
    raise AssertionError("no process in .lock")


def end(number):
    """A rank may outlive its mpirun by a moment, and has the lock until then."""
    try:
        os.kill(number, signal.SIGKILL)
    except ProcessLookupError:
        return
    deadline = time.monotonic() + common.WAIT
    while os.path.exists("/proc/%d" % number) and time.monotonic() < deadline:
        time.sleep(0.05)


def a_killed_one_is_none(directory):
    """Whatever it left behind, a run can go on where one was killed."""
    for how in (direct(), by_mpirun(2)):
        before = len(common.rows(directory))
        process = common.start(how, directory, "--resume",
                               settings=["Output/Checkpoint every=1"])
        common.wait_for(lambda: (directory / ".lock").exists(), process)
        common.wait_for(lambda: len(common.rows(directory)) >= before + 2, process)
        holder = holder_of(directory)
        common.kill(process)
        end(holder)
    output = common.run(direct(), directory, "--resume")
    assert "in use" not in output
    assert not (directory / ".lock").exists()


def one_of_two_at_the_same_time(folder):
    """Started in the same moment, in a directory that is not there yet."""
    processes = [common.start(direct(), folder / "race" / "below") for _ in range(4)]
    statuses = []
    for process in processes:
        output, _ = process.communicate(timeout=common.WAIT)
        statuses.append(process.returncode)
        if process.returncode:
            assert "in use by" in output or "already holds a run" in output, output
    assert sorted(statuses)[0] == 0 and set(statuses[:]) <= {0, 4}, statuses
    assert statuses.count(0) == 1, statuses
    common.compare(common.rows(folder / "race" / "below"),
                   common.rows(folder / "run"))


def main():
    common.set_environment()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        a_second_one_is_refused(folder / "run")
        a_killed_one_is_none(folder / "run")
        one_of_two_at_the_same_time(folder)


if __name__ == "__main__":
    main()
