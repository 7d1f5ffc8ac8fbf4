#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A run that is asked to stop writes a checkpoint and leaves with exit status 5,
whichever signal asks and whoever hands it on; continued, it gives the rows of a run
that was not stopped.

usage: test_signals.py EXECUTABLE MPIRUN
"""
import concurrent.futures
import json
import os
import pathlib
import signal
import tempfile
import time

import common
from common import by_launcher, by_mpirun, direct

# who starts the run, which signal the starter gets
WAYS = [(direct(), signal.SIGTERM), (direct(), signal.SIGINT),
        (direct(), signal.SIGHUP), (direct(), signal.SIGUSR1),
        (by_mpirun(1), signal.SIGUSR1), (by_mpirun(2), signal.SIGUSR1),
        (by_launcher(2), signal.SIGTERM), (by_launcher(2), signal.SIGINT),
        (by_launcher(2), signal.SIGHUP), (by_launcher(2), signal.SIGUSR1),
        (by_launcher(), signal.SIGTERM)]


def stopped_again_and_again(whole, parts):
    """One run in as many pieces as there are ways to stop it."""
    done = 0
    for number, (how, name) in enumerate(WAYS):
        options = ["--resume"] if number > 0 else []
        process = common.start(how, parts, *options)
        common.wait_for_rows(parts, done + 2, process)
        common.ask(process, name)
        output = common.finish(process, 5)
        assert "asked to stop by SIG" in output, output
        done = len(common.rows(parts))
        assert done < len(common.rows(whole)), "it should have been stopped earlier"
        summary = json.loads((parts / "summary.json").read_text())
        assert summary["exit_status"] == 5, summary
    common.run(by_mpirun(2), parts, "--resume")
    common.compare(common.rows(parts), common.rows(whole))


def a_closed_terminal_does_not_stop_what_is_under_nohup(folder):
    process = common.start(["nohup"] + direct(), folder / "nohup")
    common.wait_for_rows(folder / "nohup", 1, process)
    common.ask(process, signal.SIGHUP)
    common.wait_for_rows(folder / "nohup", 4, process)
    common.ask(process, signal.SIGTERM)
    assert "asked to stop by SIGTERM" in common.finish(process, 5)


def a_second_ctrl_c_ends_what_does_not_stop(folder):
    """Two seconds after the first one, and not sooner. Waits for most of its time."""
    deaf = folder / "deaf"
    deaf.write_text("#!/bin/sh\ntrap '' USR1\necho ready >'%s/ready'\n"
                    "exec sleep 60\n" % folder)
    deaf.chmod(0o755)
    for how, status in ((by_launcher(), 128 + signal.SIGINT),
                        (by_launcher(2), 128 + signal.SIGTERM)):
        environment = dict(os.environ, MIXED_CRACKS_PROGRAM=str(deaf),
                           MIXED_CRACKS_MPIRUN=str(deaf))
        process = common.start(how, folder / "none", env=environment)
        common.wait_for((folder / "ready").exists, process)
        common.ask(process, signal.SIGINT)
        time.sleep(0.5)
        common.ask(process, signal.SIGINT)
        time.sleep(2.5)
        assert process.poll() is None, process.returncode
        common.ask(process, signal.SIGINT)
        common.finish(process, status)
        (folder / "ready").unlink()


def before_the_first_state(folder):
    """There is nothing to continue then, and nothing is left behind."""
    for how in (direct(), by_mpirun(2)):
        directory = folder / "early"
        process = common.start(how, directory, coarse=[], settings=[
            "Geometry/Punctured strip/Cell size=0.15"])
        common.wait_for((directory / "log.txt").exists, process)
        common.ask(process, signal.SIGUSR1)
        output = common.finish(process, 6)
        assert "there is nothing to continue" in output, output
        assert not directory.exists(), list(directory.iterdir())


FORGETFUL = """#!/bin/bash
# a launcher that has no ranks yet when it is asked first, as mpirun may
asked=0
trap 'asked=$((asked + 1)); [ $asked -lt 2 ] || exit 5' USR1
echo begun >'%s/begun'
for i in $(seq 200); do sleep 0.1; done
"""


def a_request_that_gets_lost_is_repeated(folder):
    launcher = folder / "forgetful"
    launcher.write_text(FORGETFUL % folder)
    launcher.chmod(0o755)
    process = common.start(by_launcher(2), folder / "none", env=dict(
        os.environ, MIXED_CRACKS_MPIRUN=str(launcher)))
    common.wait_for((folder / "begun").exists, process)
    common.ask(process, signal.SIGTERM)
    common.finish(process, 5)


def a_request_in_the_start_up_is_heard(folder):
    """Whatever the moment: before mpirun listens, before it has ranks, before
    these listen, before there is a state. 138: killed by SIGUSR1, no harm done."""
    for hundredths in (10, 20, 30, 60):
        directory = folder / ("start %d" % hundredths)
        process = common.start(by_launcher(2), directory, settings=[
            "Load stepping/End time=1000"])
        time.sleep(0.01 * hundredths)
        common.ask(process, signal.SIGTERM)
        output, _ = process.communicate(timeout=common.WAIT)
        assert process.returncode in (5, 6, 128 + signal.SIGUSR1), output
        assert process.returncode != 6 or not directory.exists(), output


def repeated_requests_are_one(folder):
    """Also while the checkpoint is written."""
    directory = folder / "hammered"
    process = common.start(direct(), directory)
    common.wait_for_rows(directory, 2, process)
    while process.poll() is None:
        common.ask(process, signal.SIGUSR1)
        time.sleep(0.002)
    common.finish(process, 5)
    common.run(direct(), directory, "--resume",
               settings=["Load stepping/End time=1"])


def nobody_reads_what_it_says(folder):
    """A run goes on without its screen, and can be stopped in order."""
    for how in (direct(), by_launcher(2)):
        for name in (None, signal.SIGTERM):
            directory = folder / ("unread %d %s" % (len(how), name))
            process = common.start(how, directory, settings=[
                "Load stepping/End time=%g" % (4.8 if name else 1.)])
            process.stdout.readline()
            process.stdout.close()
            if name:
                common.wait_for_rows(directory, 2, process)
                common.ask(process, name)
            assert process.wait(common.WAIT) == (5 if name else 0), (how, name)
            last = float(common.rows(directory)[-1]["time_s"])
            assert name or abs(last - 1.) < 1e-9, last
            log = (directory / "log.txt").read_text().splitlines()
            assert log[-1].startswith("seconds:"), log[-3:]


def main():
    common.set_environment()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        whole = folder / "whole"
        common.run(direct(), whole)
        with concurrent.futures.ThreadPoolExecutor(1) as beside:
            ended = beside.submit(a_second_ctrl_c_ends_what_does_not_stop, folder)
            stopped_again_and_again(whole, folder / "parts")
            ended.result()
        a_closed_terminal_does_not_stop_what_is_under_nohup(folder)
        before_the_first_state(folder)
        a_request_that_gets_lost_is_repeated(folder)
        a_request_in_the_start_up_is_heard(folder)
        repeated_requests_are_one(folder)
        nobody_reads_what_it_says(folder)


if __name__ == "__main__":
    main()
