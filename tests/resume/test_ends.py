#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A run that had ended ends again the same way, and goes on when it may.

usage: test_ends.py EXECUTABLE MPIRUN
"""

import pathlib
import shutil
import sys
import tempfile

from runs import Runner, result, rows, same_rows, summary

STOP = "Load stepping/Stop when force falls below=%g"
ITERATIONS = "Model/Largest number of coupling iterations=%d"


def ends_again(run, directory, *settings, status=0, says="", ranks=1):
    """Nothing is calculated, and everything is as it was."""
    before = (rows(directory), result(directory),
              summary(directory)["factorizations"],
              summary(directory)["wall_time_s"])
    out = run(directory, "--resume", settings=settings, status=status,
              ranks=ranks)
    assert "nothing is left to do: " + says in out, out
    after = (rows(directory), result(directory),
             summary(directory)["factorizations"],
             summary(directory)["wall_time_s"])
    assert before == after, (before, after)


def a_force_that_fell(run, folder):
    torn, fallen = folder / "torn", STOP % 0.6
    run(torn, settings=[fallen])
    ends_again(run, torn, fallen, says="the force fell")
    ends_again(run, torn, fallen, says="the force fell", ranks=2)
    # killed between the last checkpoint and the end: nothing but that is lost
    killed = folder / "killed"
    shutil.copytree(torn, killed)
    (killed / "summary.json").unlink()
    run(killed, "--resume", settings=[fallen])
    assert result(killed) == result(torn)
    # a lower fraction: on to where an uninterrupted run comes to
    whole = folder / "torn further"
    run(whole, settings=[STOP % 0])
    run(torn, "--resume", settings=[STOP % 0])
    assert len(rows(whole)) > len(rows(killed))
    same_rows(rows(torn), rows(whole))
    assert result(torn) == result(whole)
    ends_again(run, torn, STOP % 0, says="end time reached")
    # the cost is that of both pieces
    assert summary(torn)["factorizations"] > summary(killed)["factorizations"]
    assert summary(torn)["wall_time_s"] > summary(killed)["wall_time_s"]
    times = [float(row["wall_time_s"]) for row in rows(torn)]
    assert times == sorted(times), times


def an_end_time(run, folder):
    short, whole = folder / "short", folder / "long"
    # without checkpoints on the way, and cutting a step that counts on
    run(short, settings=["Load stepping/End time=2.6e-3",
                         "Output/Checkpoint every=0"])
    ends_again(run, short, "Load stepping/End time=2.6e-3",
               says="end time reached")
    run(short, "--resume", settings=["Load stepping/End time=4.6e-3"])
    run(whole, settings=["Load stepping/End time=4.6e-3"])
    times = [float(row["time_s"]) for row in rows(short)]
    steps = [after - before for before, after in zip(times, times[1:])]
    assert abs(steps[2] - 6e-4) < 1e-9 and abs(steps[3] - 1e-3) < 1e-9, steps
    assert abs(times[-1] - 4.6e-3) < 1e-9, times
    force, other = (float(rows(directory)[-1]["force_y_N"])
                    for directory in (short, whole))
    assert abs(force - other) < 1e-3 * abs(other), (force, other)


def an_onset(run, folder):
    directory = folder / "onset"
    # on so coarse a mesh the phase field falls slowly
    slow = ("Load stepping/Largest phase-field change=0.1",
            "Load stepping/Onset step=1e-3")
    onset = (*slow, "Load stepping/Stop at onset=true")
    run(directory, settings=onset)
    assert "onset" in result(directory)["exit_reason"]
    n_rows = len(rows(directory))
    ends_again(run, directory, *onset, says="onset")
    run(directory, "--resume", settings=slow)
    assert len(rows(directory)) > n_rows
    assert "the force fell" in result(directory)["exit_reason"]


def a_failure(run, folder):
    directory = folder / "failed"
    failing = (ITERATIONS % 3, "Load stepping/Smallest step=2.5e-4",
               "Output/Checkpoint every=0")
    run(directory, settings=failing, status=3)
    n_rows = len(rows(directory))
    assert summary(directory)["exit_status"] == 3
    ends_again(run, directory, *failing, status=3, says="the smallest load step")
    # the usual cure
    out = run(directory, "--resume", settings=failing[1:])
    assert "goes on with the parameters of now" in out, out
    assert len(rows(directory)) > n_rows
    assert summary(directory)["exit_status"] == 0
    assert summary(directory)["rejected_steps"] > 0


def an_expression_that_fails_later(run, folder):
    directory = folder / "expression"
    settings = ["Boundary conditions/Displacement=bottom : all : 0 ; top : x : 0 "
                "; top : y : t + 0*sqrt(3.5e-3 - t)", "Output/Checkpoint every=0"]
    for ranks in (1, 2):
        out = run(directory, *(["--resume"] if ranks == 2 else []),
                  settings=settings, status=2, ranks=ranks)
        assert out.count("mixed-cracks: error:") == 1, out
        assert len(rows(directory)) == 4, rows(directory)
        assert summary(directory)["exit_status"] == 2
    assert "resumed at step 3" in out, out


def an_expression_is_mended(run, folder):
    """The expression that has ended a run may be another one from there on."""
    directory = folder / "mended"
    load = ("Boundary conditions/Displacement=bottom : all : 0 ; top : x : 0 ; "
            "top : y : %s")
    out = run(directory, settings=[load % "if(t < 3.5e-3, t, 1/(t-t))"], status=2)
    assert "--resume" in out, out
    # another support is another case
    out = run(directory, "--resume", status=2,
              settings=[(load % "t").replace("top : x : 0 ; ", "")])
    assert "the case has changed" in out, out
    end = "Load stepping/End time=5e-3"
    out = run(directory, "--resume", settings=[load % "t", end])
    says = "the loads before t = 0.003 s are those of another expression"
    assert "warning: " + says in out, out
    assert float(rows(directory)[-1]["time_s"]) == 5e-3, rows(directory)
    # and is not forgotten
    run(directory, "--resume", ranks=2,
        settings=[load % "1.0 * t", "Load stepping/End time=6e-3"], status=2)
    run(directory, "--resume", ranks=2,
        settings=[load % " t", "Load stepping/End time=6e-3"])
    warnings = summary(directory)["warnings"]
    assert sum(says in each for each in warnings) == 1, warnings


def another_spelling(run, folder):
    directory = folder / "spelling"
    run(directory, settings=["Load stepping/End time=1e-3"])
    run(directory, "--resume", settings=[
        "Load stepping/End time=2e-3",
        "Geometry/Slit square/Cell size=0.1250", "Geometry/Box/Cell size=0.3"])


def what_was_not_computed(run, folder):
    directory = folder / "columns"
    run(directory, settings=["Load stepping/End time=2e-3"])
    late = ["Load stepping/End time=3e-3", "Output/Crack volume=true",
            "Output/Displacement at points=tip : 0.5, 0.5"]
    run(directory, "--resume", settings=late)
    table = rows(directory)
    for name in ("crack_volume_mm3", "tip_x_mm", "tip_y_mm"):
        assert [row[name] == "" for row in table] == [True] * 3 + [False], name
    assert float(table[-1]["crack_volume_mm3"]) > 0.


def another_problem(run, folder):
    directory = folder / "problem"
    run(directory, settings=["Load stepping/End time=1e-3"])
    out = run(directory, "--resume", status=2,
              settings=["Model/Residual stiffness=1e-3"])
    for words in ("Model/Residual stiffness", "Allowed to change",
                  "Largest number of coupling iterations", "Load stepping"):
        assert words in out, out
    run(directory, "--resume", settings=["Model/Coupling tolerance=1e-4",
                                         "Linear solver/Newton tolerance=1e-7",
                                         "Load stepping/End time=2e-3"])


def main():
    run = Runner(sys.argv[1], sys.argv[2:])
    with tempfile.TemporaryDirectory() as temporary:
        for test in (a_force_that_fell, an_end_time, an_onset, a_failure,
                     an_expression_that_fails_later, an_expression_is_mended,
                     another_spelling, what_was_not_computed,
                     another_problem):
            print(test.__name__, flush=True)
            test(run, pathlib.Path(temporary))


if __name__ == "__main__":
    main()
