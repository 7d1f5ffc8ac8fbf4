#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A run that is asked to stop writes a checkpoint and leaves with exit status 5,
whichever signal asks and whoever hands it on; continued, it gives the rows of a run
that was not stopped.

usage: test_signals.py EXECUTABLE MPIRUN
"""
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
    """Two seconds after the first one, and not sooner."""
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


def main():
    common.set_environment()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        whole = folder / "whole"
        common.run(direct(), whole)
        stopped_again_and_again(whole, folder / "parts")
        a_closed_terminal_does_not_stop_what_is_under_nohup(folder)
        before_the_first_state(folder)
        a_second_ctrl_c_ends_what_does_not_stop(folder)


if __name__ == "__main__":
    main()
