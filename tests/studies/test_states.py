#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What cases are and what state they are in, without a queue: ids, immutability,
stale results, mixtures, tasks that are called by anything."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

from sweeps import Sweep

PAIR = "base = base.prm\na = --set Model/Height=6\nb = --set Model/Height=7\n"


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name) / "my studies"

    def sweep(self, text, **keywords):
        return Sweep(self.folder, text, **keywords)

    def ids(self, sweep):
        sweep.call("collect", "--mixed", status=None)
        return {name: row["case_id"] for name, row in sweep.table().items()}


class Ids(Case):
    def test_what_does_not_change_an_id(self):
        sweep = self.sweep(PAIR)
        sweep.call("run")
        before = sweep.output.joinpath("a").resolve()
        sweep.base.write_text("# a comment\nOutput/Fields every = 9\n\nModel/Law = a\n"
                              "Load stepping/End time = 7\nModel/Steps = 0\n")
        sweep.file.write_text("# changed\nbase = base.prm\nb = --set Model/Height=7e0\n"
                              "a = --set 'Model / Height = 6.0'\n")
        self.assertIn("2 of 2 runs are complete", sweep.call("run"))
        self.assertEqual(sweep.output.joinpath("a").resolve(), before)

    def test_files_that_are_read_count(self):
        sweep = self.sweep("base = base.prm\na = --set 'Mesh/File name=m.inp'\n")
        said = sweep.call("plan", status=2)
        self.assertIn("a: ", said)
        self.assertIn("there is no file", said)
        (self.folder / "m.inp").write_text("one")
        sweep.call("run")
        self.assertEqual(sweep.states(), {"a": "complete"})
        # of the same size, within the same second
        (self.folder / "m.inp").write_text("two")
        self.assertEqual(sweep.states(), {"a": "stale"})
        (self.folder / "m.inp").write_text("one")
        self.assertEqual(sweep.states(), {"a": "complete"})

    def test_entries_that_the_id_leaves_out(self):
        """Load steps do not count, unless the sweep is about them."""
        entry = "Load stepping/First step"
        text = "base = base.prm\nplain =\n" + "".join(
            "%s = --set '%s=%s'\n" % (name, entry, value) for name, value in (
                ("default", "1.0"), ("half", "0.5"), ("same", "5e-1")))
        sweep = self.sweep(text)
        sweep.call("run")
        ids = self.ids(sweep)
        self.assertEqual(ids["plain"], ids["default"])
        self.assertEqual(ids["half"], ids["same"])
        self.assertNotEqual(ids["plain"], ids["half"])
        # a line more, or fewer, changes no id
        sweep.file.write_text("base = base.prm\nhalf = --set '%s=0.5'\n" % entry)
        self.assertEqual(self.ids(sweep)["half"], ids["half"])
        # in common they may change when a run goes on
        sweep.file.write_text("base = base.prm\ncommon = --set '%s=0.5'\nplain =\n"
                              % entry)
        self.assertEqual(self.ids(sweep)["plain"], ids["plain"])
        # on the command line they are meant, unless a run is to go on
        words = ("--", "--set", entry + "=0.25")
        self.assertIn("stale", sweep.call_with("plan", *words))
        self.assertIn("complete", sweep.call_with("plan", *words, "--resume"))

    def test_a_program_without_ids(self):
        old = self.folder / "old"
        sweep = self.sweep(PAIR, program=old)
        old.write_text("#!/bin/sh\necho \"error: unknown option '--case-id'\" >&2\n"
                       "exit 2\n")
        old.chmod(0o755)
        said = sweep.call("plan", status=2)
        self.assertIn("has no --case-id", said)
        self.assertEqual(said.count("\n"), 1)


class Results(Case):
    def test_a_complete_case_is_read_only(self):
        sweep = self.sweep(PAIR)
        sweep.call("run")
        directory = (sweep.output / "a").resolve()
        for path in [directory] + list(directory.rglob("*")):
            self.assertEqual(path.stat().st_mode & 0o222, 0, path)
        # rights do not bind root
        script = "import os, sys\n" \
            "if os.geteuid() == 0: os.setgid(65534); os.setuid(65534)\n" \
            "for name in ('case.json', 'new'):\n" \
            "    try: open(os.path.join(sys.argv[1], name), 'a'); sys.exit(1)\n" \
            "    except PermissionError: pass\n"
        for path in [directory, *directory.parents]:
            if not path.stat().st_mode & 0o5 and path.owner() != "nobody":
                path.chmod(path.stat().st_mode | 0o055)
            if path == pathlib.Path(tempfile.gettempdir()).resolve():
                break
        subprocess.run([sys.executable, "-c", script, str(directory)], check=True)
        # and a page goes elsewhere
        sweep.call("run")
        self.assertIn("2 of 2", sweep.call("run"))

    def test_other_parameters_are_stale(self):
        sweep = self.sweep(PAIR)
        sweep.call("run")
        sweep.file.write_text(PAIR.replace("Height=7", "Height=8"))
        said = sweep.call("collect", status=1)
        self.assertIn("stale: b: what is there is of other parameters, in cases/", said)
        row = sweep.table()["b"]
        self.assertEqual((row["state"], row["peak_force_N"]), ("stale", ""))
        sweep.call("collect", "--mixed", status=1)
        row = sweep.table()["b"]
        self.assertEqual((row["state"], row["peak_force_N"]), ("stale", "160"))
        self.assertEqual(row["case_id"], sweep.record("b")["id"])
        sweep.call("run")
        self.assertEqual(set(sweep.states().values()), {"complete"})
        sweep.call("collect")

    def test_failures_are_no_blank_rows(self):
        sweep = self.sweep(PAIR + "bad = --set Model/Fail=3\nmissing =\n")
        sweep.call("run", "--only", "a", "b", "bad", status=1)
        said = sweep.call("collect", status=1)
        self.assertIn("failed: bad: mixed-cracks: error: the smallest step", said)
        self.assertIn("new: missing", said)
        self.assertIn("2 of 4 cases are complete", said)
        row = sweep.table()["bad"]
        self.assertEqual((row["state"], row["exit_status"]), ("failed", "3"))
        self.assertIn("the smallest step is reached", row["reason"])
        said = sweep.call("status")
        self.assertRegex(said, "bad +failed +mixed-cracks: error: the smallest step")

    def test_several_revisions(self):
        sweep = self.sweep(PAIR)
        sweep.call("run", "--only", "a")
        os.environ["FAKE_REVISION"] = "newer"
        self.addCleanup(os.environ.pop, "FAKE_REVISION")
        said = sweep.call("run")
        self.assertIn("warning: results of several revisions of the program: fake (a); "
                      "newer (b)", said)
        before = (sweep.output / "sweep.csv").read_bytes()
        (sweep.output / "sweep.csv").unlink()
        said = sweep.call("collect", status=1)
        self.assertIn("refused: results of several revisions", said)
        self.assertFalse((sweep.output / "sweep.csv").exists())
        sweep.call("collect", "--mixed")
        self.assertEqual((sweep.output / "sweep.csv").read_bytes(), before)
        self.assertEqual([row["revision"] for row in sweep.table().values()],
                         ["fake", "newer"])
        # calculated again, what was there is kept
        sweep.call("run", "--again", "--only", "a")
        self.assertIn(sweep.record("a")["id"] + ".1",
                      os.listdir(sweep.output / "cases"))
        sweep.call("collect")

    def test_an_entry_of_a_run_overrides_common(self):
        sweep = self.sweep("base = base.prm\ncommon = --set Model/Height=5\n"
                           "set tall = --set Model/Height=9\n"
                           "a =\nb = --set Model/Height=7\nc = tall\n"
                           "d = tall --set Model/Height=10\n")
        sweep.call("run")
        for name, height in (("a", 5), ("b", 7), ("c", 9), ("d", 10)):
            self.assertEqual((sweep.output / name / "settings.txt").read_text(),
                             "Model/Height=%d\n" % height)

    def test_two_names_of_one_case(self):
        sweep = self.sweep("base = base.prm\na = --set Model/Height=6\n"
                           "b = --set Model/Height=6.0\n")
        self.assertIn("the same case as b", sweep.call("plan"))
        sweep.call("run", "--jobs", 2)
        self.assertEqual([event[3] for event in sweep.events()], ["start", "end"])
        self.assertEqual(os.readlink(sweep.output / "a"), os.readlink(sweep.output / "b"))
        sweep.call("collect")


class Tasks(Case):
    def steps(self, sweep, name="a"):
        return [step for word, step in sweep.events_of(name) if word == "step"]

    def test_a_complete_case_is_left_alone(self):
        sweep = self.sweep(PAIR)
        sweep.call("task", "a")
        sweep.call("task", "a")
        self.assertEqual([event[3] for event in sweep.events()], ["start", "end"])
        self.assertIn("there is no run 'c'", sweep.call("task", "c", status=2))
        self.assertIn("expects names", sweep.call("task", status=2))
        self.assertEqual(sweep.call("plan", "--names"), "b\n")

    def started(self, sweep, *options):
        def starts():
            return [event[3] for event in sweep.events()].count("start")

        before = starts()
        process = subprocess.Popen(sweep.words("task", "a", *options),
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.addCleanup(process.stdout.close)
        sweep.wait_for(lambda: starts() > before, "a start")
        sweep.wait_for_step(2)
        return process

    def test_stopped_and_called_again(self):
        sweep = self.sweep("base = base.prm\ncommon = --set Model/Steps=30 "
                           "--set Model/Seconds=0.2\na =\n")
        for number, status in ((signal.SIGUSR1, 5), (signal.SIGTERM, 5)):
            process = self.started(sweep)
            process.send_signal(number)
            self.assertEqual(process.wait(60.), status)
            self.assertEqual(sweep.states(), {"a": "stopped"})
        sweep.file.write_text(sweep.file.read_text().replace("Seconds=0.2", "Seconds=0"))
        # entries of the fake program that count: the stopped case stays what it was
        self.assertEqual(sweep.states(), {"a": "stale"})

    def test_goes_on_from_its_checkpoint(self):
        sweep = self.sweep("base = base.prm\ncommon = --set Model/Steps=8 "
                           "--set Model/Gate=gate\na =\n")
        process = self.started(sweep)
        sweep.wait_for_step(3)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(60.), 5)
        self.assertEqual(sweep.record("a")["pieces"][0]["signal"], signal.SIGTERM)
        sweep.gate.touch()
        sweep.call("task", "a")
        self.assertEqual(self.steps(sweep), list(range(1, 9)))
        self.assertEqual([piece["resumed"] for piece in sweep.record("a")["pieces"]],
                         [False, True])

    def test_given_up_after_two_starts_without_a_new_step(self):
        sweep = self.sweep("base = base.prm\ncommon = --set Model/Steps=8 "
                           "--set Model/Stuck=2\na =\n")
        for status in (5, 5, 3):
            sweep.call("task", "a", status=status)
        self.assertIn("given up: 2 starts in a row without a new step after step 2",
                      sweep.call("status"))
        self.assertEqual(sweep.states(), {"a": "failed"})
        # somebody tries again
        sweep.call("task", "a", status=5)
        self.assertEqual(self.steps(sweep), [1, 2])

    def test_the_starter_is_killed(self):
        """The program goes on: nobody else advances its case, and when it has come to
        its end nothing is calculated again."""
        sweep = self.sweep("base = base.prm\ncommon = --set Model/Steps=8 "
                           "--set Model/Gate=gate\na =\n")
        process = self.started(sweep)
        sweep.wait_for_step(3)
        process.kill()
        process.wait()
        self.assertEqual(sweep.states(), {"a": "running"})
        self.assertIn("is in use", sweep.call("task", "a", status=4))
        sweep.gate.touch()
        sweep.wait_for(lambda: sweep.events()[-1][3] == "end", "its end")
        sweep.wait_for(lambda: sweep.states() != {"a": "running"}, "its lock")
        self.assertEqual(sweep.states(), {"a": "stopped"})
        sweep.call("task", "a")
        self.assertEqual(sweep.states(), {"a": "complete"})
        self.assertEqual([event[3] for event in sweep.events()].count("start"), 1)

    def test_killed_on_its_way_out(self):
        """With everything written, the case is complete."""
        sweep = self.sweep("base = base.prm\na = --set Model/Killed=1\n")
        sweep.call("task", "a")
        sweep.call("task", "a")
        self.assertEqual(sweep.states(), {"a": "complete"})
        self.assertEqual([event[3] for event in sweep.events()], ["start", "end"])

    def test_two_tasks_at_a_time(self):
        sweep = self.sweep("base = base.prm\ncommon = --set Model/Steps=4 "
                           "--set Model/Gate=gate\na =\n")
        first = self.started(sweep)
        second = sweep.call("task", "a", status=4)
        self.assertIn("is in use by process %d on host" % first.pid, second)
        sweep.gate.touch()
        self.assertEqual(first.wait(60.), 0)
        self.assertEqual([event[3] for event in sweep.events()].count("start"), 1)


class Directories(Case):
    def test_one_sweep_file_has_it(self):
        sweep = self.sweep(PAIR)
        sweep.call("run")
        other = Sweep(self.folder / "other", PAIR)
        other.output = sweep.output
        for command in ("plan", "run", "collect", "clean"):
            self.assertIn("holds the sweep of '%s'" % sweep.file,
                          other.call(command, status=2))
        # unless that is gone
        sweep.file.rename(self.folder / "moved")
        self.assertIn("2 of 2", other.call("run"))

    def test_results_of_an_earlier_kind_are_not_touched(self):
        sweep = self.sweep(PAIR)
        (sweep.output / "a").mkdir(parents=True)
        (sweep.output / "a" / "summary.json").write_text("{}")
        self.assertIn("is no link", sweep.call("run", status=2))
        self.assertEqual(os.listdir(sweep.output), ["a"])

    def test_clean(self):
        sweep = self.sweep(PAIR + "bad = --set Model/Fail=3\n")
        sweep.call("run", status=1)
        bad = sweep.output.joinpath("bad").resolve()
        b = sweep.output.joinpath("b").resolve()
        sweep.file.write_text(PAIR.replace("Height=7", "Height=8")
                              + "bad = --set Model/Fail=3\n")
        said = sweep.call("clean")
        self.assertIn(str(b), said)
        self.assertIn(str(bad), said)
        self.assertTrue(b.is_dir() and bad.is_dir())
        sweep.call("clean", "--stale", "--failed", "--checkpoints")
        self.assertFalse(b.exists() or bad.exists())
        self.assertFalse(os.path.lexists(sweep.output / "b"))
        self.assertEqual(sweep.states(), {"a": "complete", "b": "new", "bad": "new"})
        self.assertFalse((sweep.output / "a" / "checkpoint").exists())


class Resources(Case):
    def refused(self, text, word):
        sweep = self.sweep(PAIR)
        (self.folder / "cluster.ini").write_text(text)
        said = sweep.call("submit", "--dry-run", status=2)
        self.assertIn("cluster.ini", said)
        self.assertIn(word, said)
        self.assertEqual(said.count("\n"), 1, said)

    def test_what_is_wrong_is_named(self):
        self.refused("ranks = 2\n", "no section headers")
        self.refused("[slurm]\n", "expected the one section [cluster]")
        self.refused("[cluster]\nrank = 2\n", "there is no 'rank'; there are ranks")
        self.refused("[cluster]\nranks = 0\n", "ranks: expected a number of at least 1")
        self.refused("[cluster]\ntime = soon\n", "time: expected a time as")
        self.refused("[cluster]\nmemory = 2 G\n", "memory: expected a size as")

    def test_what_is_submitted(self):
        sweep = self.sweep(PAIR, launcher=None)
        (self.folder / "cluster.ini").write_text(
            "[cluster]\nranks = 4\ntime = 2:00:00\npartition = main\nmemory = 2G\n"
            "at a time = 20\nsignal = 60\nsbatch = --constraint=avx2 --nice\n"
            "setup = module load one\n  module load two\n")
        said = sweep.call("submit", "--dry-run", "--partition", "other")
        for line in ("array=0-1%20", "open-mode=append", "requeue",
                     "signal=B:USR1@60", "ntasks=4", "time=2:00:00", "partition=other",
                     "mem-per-cpu=2G", "constraint=avx2", "nice"):
            self.assertIn("#SBATCH --%s\n" % line, said)
        self.assertIn("\nmodule load one\nmodule load two\n", said)
        self.assertIn("export OMP_NUM_THREADS=1\n", said)
        self.assertIn("not submitted: 2 cases", said)
        self.assertFalse(sweep.output.exists())

    def test_resources_change_no_id(self):
        sweep = self.sweep(PAIR)
        sweep.call("run")
        (self.folder / "cluster.ini").write_text("[cluster]\nranks = 7\n")
        self.assertIn("2 of 2", sweep.call("run"))

    def test_without_a_queue(self):
        sweep = self.sweep(PAIR)
        path = os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        folder = self.folder / "bin"
        folder.mkdir()
        (folder / "python3").symlink_to(sys.executable)
        (folder / "env").symlink_to("/usr/bin/env")
        os.environ["PATH"] = str(folder)
        self.assertIn("there is no sbatch", sweep.call("submit", status=2))
        self.assertIn("2 cases: 2 new", sweep.call("status"))
        sweep.launcher = None
        sweep.call("submit", "--dry-run")


if __name__ == "__main__":
    unittest.main()
