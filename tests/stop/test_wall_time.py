#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Output/Wall time limit ends a run in order before the time is over, and says so
where no load step fits into it.

usage: test_wall_time.py EXECUTABLE MPIRUN
"""
import json
import pathlib
import tempfile

import common
from common import by_mpirun, direct


def limit(seconds):
    return ["Output/Wall time limit=%g" % seconds]


def it_ends_in_time(folder):
    """A run of which the whole takes longer, as the same run shows."""
    common.run(direct(), folder / "whole")
    summary = json.loads((folder / "whole" / "summary.json").read_text())
    # short enough also where the machine has become faster meanwhile
    allowed = 0.25 * summary["wall_time_s"]
    directory = folder / "pieces"
    options = []
    for piece in range(20):
        # each piece has more time than the one before
        process = common.start(direct(), directory, *options,
                               settings=limit(allowed * (1 + piece)))
        output, _ = process.communicate(timeout=common.WAIT)
        assert process.returncode in (0, 3, 5), output
        if process.returncode != 0:
            assert "Output/Wall time limit" in output, output
        options = ["--resume"]
        if process.returncode == 0:
            break
    assert process.returncode == 0 and piece > 0, piece
    common.compare(common.rows(directory), common.rows(folder / "whole"))


def it_does_not_loop(folder):
    """Nothing is gained by continuing with a limit that is too short."""
    for ranks, how in ((1, direct()), (2, by_mpirun(2))):
        directory = folder / ("short %d" % ranks)
        # the start is a state, too
        common.run(how, directory, settings=limit(1e-6), status=5)
        assert len(common.rows(directory)) == 1
        summary = json.loads((directory / "summary.json").read_text())
        assert "Output/Wall time limit" in summary["exit_reason"], summary
        assert "on request" not in summary["exit_reason"], summary
        output = common.run(how, directory, "--resume", settings=limit(1e-6),
                            status=3)
        assert "Output/Wall time limit" in output, output
        summary = json.loads((directory / "summary.json").read_text())
        assert summary["exit_status"] == 3, summary
        assert "larger" in summary["exit_reason"], summary
        # the checkpoint is none the worse for it
        common.run(how, directory, "--resume", settings=[
            "Load stepping/End time=0.4"])


def main():
    common.set_environment()
    with tempfile.TemporaryDirectory() as temporary:
        it_ends_in_time(pathlib.Path(temporary))
        it_does_not_loop(pathlib.Path(temporary))


if __name__ == "__main__":
    main()
