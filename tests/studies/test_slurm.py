#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Sweeps under a real Slurm: what a sweep script on a cluster gets wrong.

usage: test_slurm.py EXECUTABLE MPIRUN

Scenarios go on side by side, for nearly all they do is wait. Exit status 77 where
Slurm is not installed.
"""
import concurrent.futures
import hashlib
import pathlib
import sys
import tempfile
import traceback

import slurm
from sweeps import SKIPPED, Sweep, overlaps

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

CASE = pathlib.Path(__file__).resolve().parents[2] / "parameters" / "epdm" \
    / "punctured_strip.prm"
# a strip that is torn within some seconds, in 300 steps: on a busy machine there has to
# be time to tell it to stop after the first ones
COARSE = {"Mesh/Refined surroundings": "", "Mesh/Adaptive levels": "0",
          "Geometry/Punctured strip/Cell size": "2.5", "Model/Length scale": "4",
          "Model/Coupling tolerance": "1e-4", "Load stepping/End time": "6",
          "Load stepping/First step": "0.02", "Load stepping/Largest step": "0.02",
          "Load stepping/Onset step": "0.02", "Output/Field format": "none"}
EXACT = ("state", "Notch height", "steps", "outcome", "start", "separated", "dofs")
CLOSE = ("peak_force_N", "displacement_at_peak_mm", "end_displacement_mm")


def gated(names, steps=8):
    """A sweep of cases that stop before step 4 until the file "gate" is there."""
    return "base = base.prm\ncommon = --set Model/Steps=%d --set Model/Seconds=0.01 " \
        "--set Model/Gate=gate\n%s" % (steps, "".join(
            "%s = --set Model/Name=%s\n" % (name, name) for name in names))


def all_steps(sweep, name):
    """That have come to their end, in order."""
    return [step for word, step in sweep.events_of(name) if word == "step"]


def jobs_of(cluster, name):
    """{id: state} of the tasks of an array."""
    return {job: words[0] for job, words in cluster.queue().items()
            if job.startswith(name + "_")}


def wait_for_end(cluster, sweep, *arrays):
    """Of arrays, and of the jobs behind them."""
    tokens = [path.name for path in (sweep.output / "submissions").iterdir()]
    sweep.wait_for(lambda: not any(
        words[1].startswith(tuple(tokens)) for words in cluster.queue().values()),
        "the end of %s" % (arrays,))


def strips(cluster, folder):
    """An array of real strips on two ranks: one is told to stop in mid-run, is
    requeued and resumed; one fails. The table is that of a sweep that nobody has
    disturbed."""
    text = "base = %s\ncommon = %s\ngrid = \"Geometry/Punctured strip/Notch height\" " \
        ": 8 12\nname = h_{Notch height}\n" % (CASE, " ".join(
            "--set '%s=%s'" % pair for pair in COARSE.items()))
    text += "torn = --set 'Boundary conditions/Displacement=top : all : 0 ; bottom : x " \
        ": 0 ; bottom : y : -3*sqrt(0.5-t)'\n"
    sweep = Sweep(folder / "array", text, program=sys.argv[1], launcher=None)
    array, said = sweep.submit("--ranks", 2)
    assert "srun --exact --mpi=pmix" in (
        next((sweep.output / "submissions").iterdir()) / "manifest.json").read_text()
    # looked up first: meanwhile the task could come to its end
    index = [line.split()[0] for line in sweep.call("plan").splitlines()].index("h_12")
    sweep.wait_for(lambda: len(rows_of(sweep, "h_12")) >= 3, "rows of h_12")
    cluster.said("scancel", "--batch", "--signal=USR1", "%s_%d" % (array, index),
                 check=True)
    sweep.wait_for(lambda: len(sweep.record("h_12")["pieces"]) == 2, "a second piece")
    first, second = sweep.record("h_12")["pieces"]
    assert first["exit_status"] == 5 and first["signal"] == 10, first
    assert second["resumed"] and second["from_step"] >= 2, second
    assert (first["job"], first["restart"], second["job"], second["restart"]) == (
        "%s_%d" % (array, index), 0, "%s_%d" % (array, index), 1)
    wait_for_end(cluster, sweep, array)

    alone = Sweep(folder / "alone", text, program=sys.argv[1], launcher=sys.argv[2])
    alone.call("run", "--ranks", 2, status=1)
    expected, found = alone.table(), sweep.table()
    assert list(found) == list(expected) == ["torn", "h_8", "h_12"]
    for name in ("h_8", "h_12"):
        assert found[name]["state"] == "complete", found[name]
        compare(found[name], expected[name])
        assert found[name]["case_id"] == expected[name]["case_id"]
    row = found["torn"]
    assert (row["state"], row["exit_status"]) == ("failed", "2"), row
    assert "Displacement" in row["reason"], row
    assert "failed: torn" in sweep.call("collect", status=1)
    log = next((sweep.output / "submissions").iterdir()) / "collect.log"
    assert "failed: torn" in log.read_text()
    return said


def rows_of(sweep, name):
    try:
        return program.rows(sweep.output / name)
    except OSError:
        return []


def compare(row, expected):
    for column in EXACT:
        assert row[column] == expected[column], (column, row, expected)
    for column in CLOSE:
        one, other = float(row[column]), float(expected[column])
        assert abs(one - other) <= 1e-5 * abs(other), (column, one, other)


def time_limit(cluster, folder):
    """A limit that hits ends a piece, not the case: it is requeued by itself, and no
    step is calculated twice. A case that gets nowhere is given up after two starts.

    A minute is the shortest limit, and Slurm looks every 30 s whether it is that close
    to the moment to ask: 25 s before the end is from 5 to 35 s after the begin."""
    sweep = Sweep(folder, "base = base.prm\n"
                  "a = --set Model/Steps=40 --set Model/Seconds=1\n"
                  "stuck = --set Model/Steps=9 --set Model/Stuck=2\n")
    array, _ = sweep.submit("--time", "1", "--signal", "25")
    wait_for_end(cluster, sweep, array)
    pieces = sweep.record("a")["pieces"]
    assert len(pieces) >= 2, pieces
    assert [piece.get("exit_status") for piece in pieces] == \
        [5] * (len(pieces) - 1) + [0], pieces
    assert all_steps(sweep, "a") == list(range(1, 41)), sweep.events_of("a")
    pieces = sweep.record("stuck")["pieces"]
    # the first brings steps, the next two none
    assert [piece["exit_status"] for piece in pieces] == [5, 5, 5], pieces
    assert [piece["to_step"] for piece in pieces] == [2, 2, 2], pieces
    row = sweep.table()["stuck"]
    assert row["state"] == "failed" and "given up" in row["reason"], row
    assert "without a new step after step 2" in sweep.call("status"), row


def a_line_is_added(cluster, folder):
    """While the array is queued: every task keeps its case, by name."""
    names = ["a", "b", "c"]
    sweep = Sweep(folder, gated(names))
    array, said = sweep.submit("--at-a-time", 1)
    assert "--array=0-2%1" in said, said
    sweep.wait_for_step(1)
    text = sweep.file.read_text()
    sweep.file.write_text(text.replace("a = ", "new = --set Model/Name=new\na = "))
    # what is queued is not submitted again
    second, said = sweep.submit()
    assert "--array=0-0\n" in said and "in the queue already: " in said, said
    sweep.gate.touch()
    wait_for_end(cluster, sweep, array, second)
    for name in names + ["new"]:
        settings = (sweep.output / name / "settings.txt").read_text()
        assert "Model/Name=%s\n" % name in settings, (name, settings)
        assert len(sweep.record(name)["pieces"]) == 1
    sweep.call("collect")
    assert "nothing is missing" in sweep.call("submit")


def the_base_is_changed(cluster, folder):
    """While the array is queued: what was submitted is not calculated with something
    else; results of before are stale, and stay as they are."""
    text = gated(["a", "b", "c"]).replace("a = ", "a = --set Model/Gate= ")
    sweep = Sweep(folder, text)
    array, _ = sweep.submit("--at-a-time", 1)
    sweep.wait_for(lambda: sweep.record("a").get("complete"), "the first case")
    before = contents(sweep.output / "a")
    sweep.base.write_text("Model/Law = b\n")
    sweep.gate.touch()  # c has not begun: b comes before it
    wait_for_end(cluster, sweep, array)
    states = sweep.states()
    assert (states["a"], states["c"]) == ("stale", "new"), states
    said = sweep.call("collect", status=1)
    assert "stale: a: what is there is of other parameters" in said, said
    row = sweep.table()["a"]
    assert (row["state"], row["exit_status"], row["peak_force_N"]) == ("stale", "", "")
    text = log_of(sweep, array, 2)
    assert "c: stale: " in text and "submit again" in text, text
    assert not (sweep.output / "c").exists()
    old = sweep.record("a")["id"]
    again, _ = sweep.submit()
    wait_for_end(cluster, sweep, again)
    assert set(sweep.states().values()) == {"complete"}
    assert sweep.record("a")["id"] != old
    assert contents(sweep.output / "cases" / old) == before
    assert old in sweep.call("clean")
    assert (sweep.output / "cases" / old).is_dir()
    assert "removed" in sweep.call("clean", "--stale")
    assert not (sweep.output / "cases" / old).exists()
    sweep.call("collect")


def log_of(sweep, array, index):
    return next(sweep.output.glob("submissions/*/%s_%d.log" % (array, index))).read_text()


def contents(folder):
    """{path: checksum} of all that is there."""
    folder = folder.resolve()  # the name is a link, and goes elsewhere later
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(folder.rglob("*")) if path.is_file()}


def two_in_one_directory(cluster, folder):
    """A second submission of the same sweep brings nothing twice; another sweep file
    is refused; sweeps that are started at the same moment do not mix."""
    sweep = Sweep(folder, gated(["a", "b"]))
    array, _ = sweep.submit()
    assert "nothing to submit" in sweep.call("submit")
    other = Sweep(folder / "other", "base = base.prm\na = --set Model/Name=other\n")
    other.output = sweep.output
    for command in ("plan", "run", "submit"):
        said = other.call(command, status=2)
        assert "holds the sweep of '%s'" % sweep.file in said, said
    # here and in jobs at the same time: nobody advances what the other has
    sweep.wait_for_step(3, 2)
    said = sweep.call("run", status=1)
    assert said.count("is in use by") == 2, said
    sweep.gate.touch()
    wait_for_end(cluster, sweep, array)
    sweep.call("collect")
    assert not overlaps(sweep.events())
    for name in ("a", "b"):
        assert "Model/Name=%s\n" % name in (
            sweep.output / name / "settings.txt").read_text()


def cancelled(cluster, folder):
    """scancel: a checkpoint, no requeue, and 'submit' goes on from there."""
    sweep = Sweep(folder, gated(["a"]))
    array, _ = sweep.submit()
    sweep.wait_for_step(3)
    cluster.said("scancel", array, check=True)
    wait_for_end(cluster, sweep, array)
    piece, = sweep.record("a")["pieces"]
    assert piece["exit_status"] == 5 and piece["signal"] == 15, piece
    assert sweep.states()["a"] == "stopped"
    assert "stopped" in sweep.call("collect", status=1)
    sweep.gate.touch()
    array, _ = sweep.submit()
    wait_for_end(cluster, sweep, array)
    assert all_steps(sweep, "a") == list(range(1, 9)), sweep.events_of("a")
    sweep.call("collect")


def held(cluster, folder):
    """Tasks that are held are found and submitted anew."""
    sweep = Sweep(folder, gated(["a", "b"]))
    array, _ = sweep.submit("--at-a-time", 1)
    cluster.said("scontrol", "hold", array + "_1", check=True)
    said = sweep.call("status")
    assert "held: submit puts it in again" in said, said
    again, said = sweep.submit()
    assert "submitted 1 cases" in said, said
    sweep.gate.touch()
    assert array + "_1" not in jobs_of(cluster, array)
    wait_for_end(cluster, sweep, array, again)
    sweep.call("collect")


def several_in_a_job(cluster, folder):
    """Small cases share a job, side by side; steps of srun."""
    sweep = Sweep(folder, gated(["a", "b", "c"]), launcher="srun --exact")
    array, said = sweep.submit("--cases-per-job", 2)
    assert "--ntasks=2\n" in said and "--array=0-1\n" in said, said
    sweep.wait_for_step(3, 3)  # all of them are at work
    sweep.gate.touch()
    wait_for_end(cluster, sweep, array)
    sweep.call("collect")
    jobs = {name: row["job"] for name, row in sweep.table().items()}
    assert jobs == {"a": array + "_0", "b": array + "_0", "c": array + "_1"}, jobs


def preempted(cluster, folder):
    """A job of more weight takes the node; Slurm requeues, the case goes on."""
    sweep = Sweep(folder, gated(["a"]))
    array, _ = sweep.submit()
    sweep.wait_for_step(3)
    cluster.said("sbatch", "--partition=urgent", "--exclusive", "--output=/dev/null",
                 "--wrap=sleep 2", check=True)
    sweep.wait_for(lambda: len(sweep.record("a")["pieces"]) == 2, "a second piece")
    sweep.gate.touch()
    wait_for_end(cluster, sweep, array)
    first, second = sweep.record("a")["pieces"]
    assert (first["exit_status"], first["signal"]) == (5, 15), first
    assert second["resumed"] and second["restart"] == 1, second
    assert all_steps(sweep, "a") == list(range(1, 9)), sweep.events_of("a")
    assert sweep.table()["a"]["state"] == "complete"


SIDE_BY_SIDE = (strips, time_limit, a_line_is_added, the_base_is_changed,
                two_in_one_directory, cancelled, held, several_in_a_job)
ALONE = (preempted,)  # it takes the node


def failures_of(cluster, folder):
    """Names of the scenarios that have gone wrong; says how."""
    failed = []

    def tried(scenario):
        try:
            scenario(cluster, folder / scenario.__name__)
            print("%s: as it should be" % scenario.__name__, flush=True)
        except Exception:
            failed.append(scenario.__name__)
            print("%s: WRONG\n%s" % (scenario.__name__, traceback.format_exc()),
                  flush=True)

    with concurrent.futures.ThreadPoolExecutor(len(SIDE_BY_SIDE)) as pool:
        list(pool.map(tried, SIDE_BY_SIDE))
    for scenario in ALONE:
        tried(scenario)
    return failed


def main():
    if slurm.missing():
        print("skipped: there is no Slurm here (%s); scripts/install-packages brings it"
              % ", ".join(slurm.missing()))
        return SKIPPED
    with tempfile.TemporaryDirectory() as temporary:
        pathlib.Path(temporary).chmod(0o755)  # munge wants everybody to get in
        cluster = slurm.Cluster(pathlib.Path(temporary) / "slurm", cpus=16)
        try:
            failed = failures_of(cluster, pathlib.Path(temporary))
        finally:
            cluster.stop()
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
