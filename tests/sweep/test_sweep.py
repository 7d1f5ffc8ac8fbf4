#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""scripts/sweep.py with a program that is none, and scripts/study.py on made-up
runs."""
import csv
import fcntl
import glob
import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, os.pardir, os.pardir)
sys.path.insert(0, os.path.join(HERE, os.pardir, "report"))
import synthetic_run  # noqa: E402

FAKE = os.path.join(HERE, "fake_program.py")
SWEEP = os.path.join(ROOT, "scripts", "sweep.py")
STUDY = os.path.join(ROOT, "scripts", "study.py")
FILE = """# two materials
base   = base.prm
common = --set "Mesh/Adaptive levels=1" --set Model/Name=a

first_1 = --set "Material/Lame lambda=10"
first_2 = --set 'Mesh/Adaptive levels=2'
plain   =
"""


def called(script, *arguments, **options):
    return subprocess.run([sys.executable, "-B", script] + list(arguments),
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, **options)


class Case(unittest.TestCase):
    def setUp(self):
        # a blank in the name, as users have it
        self.directory = os.path.join(tempfile.mkdtemp(), "my sweeps")
        os.mkdir(self.directory)
        self.addCleanup(self.remove, os.path.dirname(self.directory))
        self.output = self.path("out")
        # without a search for an interpreter, which takes longer than all it does
        self.program = self.path("mixed-cracks")
        synthetic_run.write(self.program, "#!%s -B\nimport runpy\nrunpy.run_path(%r, "
                            "run_name='__main__')\n" % (sys.executable, FAKE))
        os.chmod(self.program, 0o755)
        synthetic_run.write(self.path("base.prm"), "# nothing\n")

    @staticmethod
    def remove(directory):
        """With complete cases, which are read-only."""
        for parent, folders, _ in os.walk(directory):
            for name in folders:
                if not os.path.islink(os.path.join(parent, name)):
                    os.chmod(os.path.join(parent, name), 0o755)
        shutil.rmtree(directory)

    def path(self, *names):
        return os.path.join(self.directory, *names)

    def text(self, *names):
        with open(self.path(*names), encoding="utf-8") as stream:
            return stream.read()

    def sweep(self, text, *arguments, status=0):
        synthetic_run.write(self.path("a.sweep"), text)
        own = [self.path("a.sweep"), "--output", self.output, "--program", self.program,
               "--mpirun", ""]
        process = called(SWEEP, *(own + list(arguments)))
        self.assertNotIn("Traceback", process.stderr)
        self.assertEqual(process.returncode, status, process.stderr)
        return process

    def started(self):
        """Names of the runs that have been started, in any order."""
        try:
            events = [line.split() for line in
                      self.text("out", "cases", "events.txt").splitlines()]
        except OSError:
            return []
        names = {}
        for path in glob.glob(glob.escape(self.path("out", "cases")) + "/*/case.json"):
            with open(path, encoding="utf-8") as stream:
                record = json.load(stream)
            names[record["id"]] = record["names"][0]
        return sorted(names[event[1]] for event in events if event[3] == "start")

    def record(self, name):
        return json.loads(self.text("out", name, "case.json"))

    def table(self):
        with open(self.path("out", "sweep.csv"), newline="") as stream:
            return {row["name"]: row for row in csv.DictReader(stream)}


class Files(Case):
    def refused(self, text, *words, arguments=()):
        process = self.sweep(text, *arguments, status=2)
        self.assertEqual(process.stderr.count("\n"), 1, process.stderr)
        for word in words:
            self.assertIn(word, process.stderr)
        self.assertEqual(self.started(), [])

    def test_what_is_wrong_is_named_with_its_line(self):
        for line, word in (("x = --set \"A/B=1", "quotation"),
                           ("x --set A/B=1", "expected 'base = FILE'"),
                           ("x y = --set A/B=1", "expected 'base = FILE'"),
                           ("../x = --set A/B=1", "expected 'base = FILE'"),
                           ("x = --output there", "only --set"),
                           ("x = --set A/B = 1", "--set expects"),
                           ("x = --set A/B=1 2", "only --set"),
                           ("x = --set", "--set expects"),
                           ("x = --set =1", "--set expects"),
                           ("x = --set A/B=1 --set 'A/B =2'", "'A/B' is set twice"),
                           ("first_1 =", "the first is in line 5"),
                           ("base = base.prm", "the first is in line 2"),
                           ("common = --set Model/Name=b", "'Model/Name' is set twice"),
                           ("names = base.prm", "only --set"),
                           ("cases = --set A/B=1", "cannot be called 'cases'"),
                           ("set soft = 1", "only --set"),
                           ("grid = A/B", "expected '\"Subsection/Entry\" :"),
                           ("grid = A/B :", "expected '\"Subsection/Entry\" :"),
                           ("grid = /B : 1", "before the ':'"),
                           ("grid = A/B : 1 2 1", "has the value 1 twice"),
                           ("grid = A/B : 6:18:-2", "leads nowhere"),
                           ("grid = A/B : 6:18:0", "leads nowhere"),
                           ("grid = A/B : 0:1e9:1", "leads nowhere"),
                           ("grid = material : soft", "no line 'set soft"),
                           ("name = h", "expects a pattern"),
                           ("name = h_{x}", "there is none")):
            with self.subTest(line=line):
                self.refused(FILE + line + "\n", "a.sweep:8:", word)

    def test_grids_are_wrong_in_other_ways(self):
        for lines, word in (
                ("grid = A/B : 1\nzip = A/B : 1", "a.sweep:9: 'A/B' has a second grid"),
                ("zip = A/B : 1 2\nzip = A/C : 1", "a.sweep:9: 'A/C' has 1 values"),
                ("grid = A/B : 1 2\nname = h_{C}", "a.sweep:8: name: there is no grid"),
                ("grid = A/B : 1 2\nname = {B}\n1 =", "two runs of the name '1'"),
                ("grid = A/B : 1 1.0\nname = x{B}\nname = y{B}", "a second time"),
                ("grid = A/B : -1 2\nname = {B}", "'-1' is no name"),
                ("grid = A/B : 0:999:1\ngrid = A/C : 0:999:1", "1000000 points")):
            with self.subTest(lines=lines):
                self.refused(FILE + lines + "\n", "a.sweep:", word)

    def test_grids(self):
        text = """base = base.prm
common = --set A/B=0
set soft = --set M/x=1 --set A/B=9
set hard = --set M/x=2
grid = material : soft hard
zip = "A/The height" : 6 10
zip = "A/Levels": fine coarse
name = {material}_{The height}_{Levels}
mine = soft --set M/x=3
"""
        lines = [shlex.split(line) for line in self.sweep(
            text, "--list").stdout.splitlines()]
        settings = [[word for word in line if "=" in word] for line in lines]
        self.assertEqual(settings, [
            ["A/B=9", "M/x=3"],
            ["A/B=9", "M/x=1", "A/The height=6", "A/Levels=fine"],
            ["A/B=9", "M/x=1", "A/The height=10", "A/Levels=coarse"],
            ["A/B=0", "M/x=2", "A/The height=6", "A/Levels=fine"],
            ["A/B=0", "M/x=2", "A/The height=10", "A/Levels=coarse"]])
        self.sweep(text)
        table = self.table()
        self.assertEqual(list(table), ["mine", "soft_6_fine", "soft_10_coarse",
                                       "hard_6_fine", "hard_10_coarse"])
        row = table["hard_10_coarse"]
        self.assertEqual((row["material"], row["The height"], row["Levels"]),
                         ("hard", "10", "coarse"))

    def test_ranges(self):
        text = "base = base.prm\ngrid = A/B : 6 10 12:18:2 0.1:0.3:0.1 5:3:-1\n"
        self.sweep(text)
        self.assertEqual(list(self.table()), ["B_" + value for value in (
            "6 10 12 14 16 18 0.1 0.2 0.3 5 4 3".split())])

    def test_base_and_runs_are_needed(self):
        self.refused("base = nowhere.prm\nx =\n", "a.sweep:1:", "no base file",
                     "nowhere.prm")
        self.refused("base = a b\nx =\n", "a.sweep:1:", "one file")
        self.refused("x =\n", "a.sweep:", "no line 'base")
        self.refused("base = base.prm\n", "a.sweep:", "there is no run")
        self.assertIn("cannot be read", called(SWEEP, self.path("none")).stderr)

    def test_command_line(self):
        self.refused(FILE, "no run 'second*'", arguments=("--only", "second*"))
        self.refused(FILE, "may stand after --", arguments=("--", "--check"))
        self.refused(FILE, "cannot be run", arguments=("--program", "/nowhere/x"))
        self.assertIn("at least 1", self.sweep(FILE, "--jobs", "0", status=2).stderr)

    def test_list(self):
        process = self.sweep(FILE, "--list", "--mpirun", "srun", "--ranks", "3",
                             "--", "--set", "Model/Name=b")
        lines = [shlex.split(line) for line in process.stdout.splitlines()]
        self.assertEqual(lines[1], [
            "srun", "-n", "3", self.program, "--overwrite", "--output",
            lines[1][6], "--set", "Mesh/Adaptive levels=2", "--set",
            "Model/Name=b", self.path("base.prm")])
        self.assertEqual(os.path.dirname(lines[1][6]), self.path("out", "cases"))
        self.assertEqual(len({line[6] for line in lines}), 3)
        self.assertEqual(self.started(), [])
        self.assertFalse(os.path.exists(self.output))

    def test_those_of_the_project(self):
        found = glob.glob(os.path.join(ROOT, "parameters", "**", "*.sweep"),
                          recursive=True)
        self.assertGreaterEqual(len(found), 2)
        sys.path.insert(0, os.path.join(ROOT, "scripts"))
        from sweep_parts.sweep_file import Sweep, options_of
        for path in found:
            sweep = Sweep(path)
            options = [tuple(options_of(sweep.settings(name))) for name in sweep.runs]
            self.assertEqual(len(options), len(set(options)), path)
            self.assertGreaterEqual(len(options), 2)
            if os.path.join("epdm", "notch_heights.sweep") in path:
                self.assertEqual(len(options), 10)
                self.assertEqual(list(sweep.runs)[::9], ["neo_hooke_6", "fit150_18"])


class Runs(Case):
    def test_table(self):
        process = self.sweep(FILE, "--jobs", "2")
        self.assertIn("[3/3]", process.stdout)
        table = self.table()
        self.assertEqual(list(table), ["first_1", "first_2", "plain"])
        wanted = dict(exit_status="0", separated="true", force_fell="true",
                      outcome="past the hole", start="notch", peak_force_N="160",
                      displacement_at_peak_mm="20",
                      end_displacement_mm="22", remaining_force_fraction="0.0625",
                      steps="12", rejected_steps="4", refinements="",
                      coupling_iterations="36", factorizations="", dofs="50",
                      proportional_steps="10", wall_time_s="17", name="plain",
                      state="complete", reason="", revision="fake", job="",
                      case_id=self.record("plain")["id"])
        wanted.update({"Lame lambda": "", "Adaptive levels": ""})
        self.assertEqual(dict(table["plain"]), wanted)
        # of several settings the last one holds
        self.assertEqual(self.text("out", "first_2", "settings.txt"),
                         "Mesh/Adaptive levels=2\nModel/Name=a\n")
        self.assertEqual(self.record("first_1")["settings"], {
            "Mesh/Adaptive levels": "1", "Model/Name": "a",
            "Material/Lame lambda": "10"})
        self.assertIn("a line of the log", self.text("out", "plain", "screen.txt"))

    def test_complete_runs_are_not_repeated(self):
        self.sweep(FILE)
        self.assertEqual(self.started(), ["first_1", "first_2", "plain"])
        process = self.sweep(FILE, "--ranks", "2")
        self.assertIn("3 of 3 runs are complete", process.stdout)
        self.assertEqual(len(self.started()), 3)
        # with another option it is another run
        self.sweep(FILE.replace("lambda=10", "lambda=11"))
        self.assertEqual(self.started(), ["first_1", "first_1", "first_2", "plain"])
        self.sweep(FILE.replace("lambda=10", "lambda=11"), "--again", "--only", "pl*")
        self.assertEqual(self.started().count("plain"), 2)
        self.assertEqual(len(self.started()), 5)
        # as with another base file, but not with another comment in it
        synthetic_run.write(self.path("base.prm"), "# something\n")
        self.sweep(FILE, "--only", "plain")
        self.assertEqual(self.started().count("plain"), 2)
        synthetic_run.write(self.path("base.prm"), "Model/Law = another\n")
        self.sweep(FILE, "--only", "plain")
        self.assertEqual(self.started().count("plain"), 3)

    def test_failing_runs_do_not_stop_the_others(self):
        text = FILE + "bad = --set Model/Fail=3\nworse = --set Model/Fail=9\n" \
            "last = --set Model/Last=1\n"
        process = self.sweep(text, status=1)
        self.assertIn("bad: exit status 3", process.stdout)
        self.assertIn("the smallest step is reached", process.stdout)
        self.assertIn("no memory is left", process.stdout)
        self.assertIn("failed: bad, worse", process.stderr)
        table = self.table()
        self.assertEqual([table[name]["exit_status"] for name in
                          ("plain", "bad", "worse", "last")], ["0", "3", "9", "0"])
        self.assertEqual(table["bad"]["outcome"], "through hole")
        self.assertEqual(table["bad"]["start"], "")
        self.assertEqual(table["worse"]["peak_force_N"], "")
        self.assertEqual(table["worse"]["proportional_steps"], "10")
        self.sweep(text, status=1)  # they are tried again, nothing else is
        self.assertEqual(self.started(), ["bad", "bad", "first_1", "first_2", "last",
                                          "plain", "worse", "worse"])

    def test_status_of_a_launcher(self):
        text = FILE + "bad = --set Model/Fail=3 --set Model/Launcher=1\n"
        process = self.sweep(text, "--only", "bad", status=1)
        self.assertIn("bad: exit status 3", process.stdout)
        self.assertEqual(self.table()["bad"]["exit_status"], "3")

    def test_a_column_that_is_empty_at_first(self):
        sys.path.insert(0, os.path.join(ROOT, "scripts"))
        from sweep_parts.table import statistics_of
        with tempfile.TemporaryDirectory() as directory:
            with open(os.path.join(directory, "statistics.csv"), "w",
                      encoding="utf-8") as stream:
                stream.write("step,force_y_N,crack_volume_mm3\n"
                             "0,0,\n1,2.5,\n2,3.5,0.25\n")
            rows = statistics_of(directory)
        self.assertEqual([row["force_y_N"] for row in rows], [0., 2.5, 3.5])
        self.assertEqual(rows[2]["crack_volume_mm3"], 0.25)

    def test_only_and_table_only(self):
        self.sweep(FILE, "--only", "plain")
        self.assertEqual(self.table()["first_1"]["state"], "new")
        os.remove(self.path("out", "sweep.csv"))
        process = self.sweep(FILE.replace("Name=a", "Name=b"), "--table-only")
        self.assertIn("stale: plain: what is there is of other parameters",
                      process.stderr)
        row = self.table()["plain"]
        self.assertEqual((row["state"], row["exit_status"], row["peak_force_N"]),
                         ("stale", "", ""))
        self.assertEqual(self.started(), ["plain"])

    def started_and_waiting(self):
        """A sweep of two runs, the first of which waits for SIGUSR1."""
        synthetic_run.write(self.path("a.sweep"), "base = base.prm\n"
                            "common = --set Model/Wait=1\n"
                            "a = --set A/B=1\nb = --set A/B=2\n")
        process = subprocess.Popen(
            [sys.executable, "-B", SWEEP, self.path("a.sweep"), "--output",
             self.output, "--program", self.program, "--mpirun", ""],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        deadline = time.time() + 60.
        waits = self.path("out", "a", "waits.txt")
        while not (os.path.exists(waits) and os.path.getsize(waits)):
            self.assertLess(time.time(), deadline)
            time.sleep(0.05)
        return process

    def test_stopped(self):
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            process = self.started_and_waiting()
            process.send_signal(number)
            output, _ = process.communicate(timeout=60.)
            self.assertEqual(process.returncode, 1)
            self.assertIn("1 runs were not started", output)
            self.assertEqual(self.started(), ["a"])
            # in order, and not killed
            self.assertEqual(self.table()["a"]["exit_status"], "5")
            self.remove(self.output)

    def test_one_sweep_at_a_time(self):
        first = self.started_and_waiting()
        before = self.text("out", "cases", "events.txt")
        for arguments in ((), ("--again", "--only", "b")):
            process = called(SWEEP, self.path("a.sweep"), "--output", self.output,
                             "--program", self.program, "--mpirun", "", *arguments)
            self.assertEqual(process.returncode, 2)
            self.assertRegex(process.stderr, r"is in use by process %d on host \S+ "
                             r"since 20" % first.pid)
            self.assertEqual(process.stderr.count("\n"), 1, process.stderr)
        self.assertEqual(self.text("out", "cases", "events.txt"), before)
        # to look at what there is does no harm
        self.sweep(FILE, "--table-only")
        first.kill()
        first.communicate()
        os.kill(int(self.text("out", "a", "waits.txt")), signal.SIGKILL)
        self.sweep(FILE)
        self.assertEqual(self.table()["plain"]["exit_status"], "0")
        self.assertFalse(os.path.exists(self.path("out", ".lock")))

    def test_a_run_that_goes_on_is_left_alone(self):
        line = self.sweep(FILE, "--list").stdout.splitlines()[2]
        case = shlex.split(line)[3]
        # by the lock of the program, and by that of a task that has begun it
        for lock in (os.path.join(case, ".lock"), case + ".lock"):
            os.makedirs(case, exist_ok=True)
            with open(lock, "w") as stream:
                fcntl.flock(stream, fcntl.LOCK_EX)
                stream.write("host here\nprocess 7\nsince today\n")
                stream.flush()
                process = self.sweep(FILE, status=1)
                self.assertEqual(self.table()["plain"]["state"], "running")
                self.assertIn("is in use by process 7 on host here since today",
                              process.stdout)
            self.assertIn("failed: plain", process.stderr)
            self.assertEqual(os.listdir(case) in ([".lock"], []), True)
            self.remove(case)
        self.assertEqual(self.started(), ["first_1", "first_2"])


# Of two cells with points of their own, one above the other: how many edges the
# outline has when they touch, and when they part on the left.
SLIT = """
import sys
sys.path.insert(0, %r)
from report_parts import interpreter
interpreter.use_one_with_matplotlib()
import numpy as np
from report_parts import pictures, vtu
from sweep_parts import study_picture
points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0],
                   [0, 1, 0], [1, 1, 0], [1, 2, 0], [0, 2, 0]], float)
faces = np.arange(8).reshape(2, 4)
for opening in (0., 1e-3):
    displacement = np.zeros((8, 3))
    displacement[[4, 6, 7], 1] = opening, 1., 1.
    fields = vtu.Fields(points, faces, {"displacement": displacement})
    print(len(pictures.outline_of(study_picture.told_apart(fields), faces)))
"""


class Studies(Case):
    def setUp(self):
        super().setUp()
        for name in ("soft_1", "soft_2", "hard_1"):
            os.makedirs(self.path("out", name))
            synthetic_run.write_run(self.path("out", name))
        synthetic_run.write_summary(self.path("out", "soft_2"), thickness_mm=2.,
                                    displacement_at_peak_mm=20.)
        os.remove(self.path("out", "hard_1", "crack_path.csv"))

    def study(self, kind, *arguments, status=0):
        process = called(STUDY, kind, self.output, *arguments)
        if "no Python with matplotlib" in process.stderr:
            self.skipTest("no Python with matplotlib on this machine")
        self.assertNotIn("Traceback", process.stderr)
        self.assertNotIn("Warning", process.stderr)
        self.assertEqual(process.returncode, status, process.stderr)
        return process

    def test_curves(self):
        synthetic_run.write(self.path("measured.csv"),
                            "# from a drawing\ndisplacement_mm,force_N_per_mm\n"
                            "0,0\n10,50\n20,81\n")
        self.study("curves", "--output", self.path("c.svg"), "--title", "A & B",
                   "--reference", self.path("measured.csv"), "--only", "soft_2")
        text = self.text("c.svg")
        for word in ("soft_2", "measured", "A &amp; B", "Force (N)"):
            self.assertIn(">%s<" % word, text)
        self.assertNotIn("soft_1", text)
        process = self.study("curves", "--output", self.path("c.png"),
                             "--per-thickness", status=2)
        self.assertIn("tells no thickness", process.stderr)
        # a component of its own is another curve than the chosen one
        self.study("curves", "--output", self.path("x.svg"), "--component", "x",
                   "--title", "A & B", "--reference", self.path("measured.csv"),
                   "--only", "soft_2")
        self.assertNotEqual(self.text("x.svg"), text)
        self.study("curves", "--output", self.path("y.svg"), "--component", "y",
                   "--title", "A & B", "--reference", self.path("measured.csv"),
                   "--only", "soft_2")
        self.assertEqual(self.text("y.svg"), text)
        self.study("curves", "--output", self.path("c.png"))
        with open(self.path("c.png"), "rb") as stream:
            self.assertEqual(stream.read(4), b"\x89PNG")

    def test_cracks(self):
        shutil.rmtree(self.path("out", "soft_1", "fields"))
        self.study("cracks", "--output", self.path("k.png"), "--columns", "2")
        with open(self.path("k.png"), "rb") as stream:
            with_path = stream.read()
        self.assertEqual(with_path[:4], b"\x89PNG")
        self.assertLess(len(with_path), 50000)
        os.remove(self.path("out", "soft_2", "crack_path.csv"))
        self.study("cracks", "--output", self.path("k.png"), "--columns", "2")
        with open(self.path("k.png"), "rb") as stream:
            self.assertNotEqual(stream.read(), with_path)
        self.study("cracks", "--output", self.path("k.svg"), status=2)

    def test_compare(self):
        synthetic_run.write(self.path("r.csv"), "# peaks\n"
                            "name,displacement_mm,force_N_per_mm\n"
                            "soft_2,25,64\nelse,1,2\n")
        self.study("compare", self.path("r.csv"), "--output", self.path("t.md"))
        lines = self.text("t.md").splitlines()
        # 160 N over 2 mm
        self.assertIn("| soft_2 | 20 | 25 | -20.0 % | 80 | 64 | +25.0 % |", lines)
        self.assertIn("| hard_1 | 20 | – | – | – | – | – |", lines)
        self.assertIn("- In the reference only: else.", lines)
        for text, word in (("name,force_N_per_mm\n", "expected a header"),
                           ("name,displacement_mm,force_N_per_mm\na,1\n", "r.csv:2:"),
                           ("name,displacement_mm,force_N_per_mm\na,1,x\n", "r.csv:2:"),
                           ("name,displacement_mm,force_N_per_mm\na,1,2\na,1,2\n",
                            "different displacements"), ("", "expected a header")):
            synthetic_run.write(self.path("r.csv"), text)
            process = self.study("compare", self.path("r.csv"), status=2)
            self.assertIn(word, process.stderr)

    def test_scatter(self):
        head = ("name,displacement_mm,displacement_minus_mm,displacement_plus_mm,"
                "force_N,force_minus,force_plus\n")
        synthetic_run.write(self.path("tests.csv"), head + "2,19,2,1,170,5,5\n")
        # rows with the last word of a name belong to it
        lines = self.study("compare", self.path("tests.csv")).stdout.splitlines()
        self.assertIn("| soft_2 | 20 | 19 (17 to 20) | +5.3 %, within | 160 | "
                      "170 (165 to 175) | -5.9 %, **outside** |", lines)
        self.assertIn("- soft: 1 of 2 figures lie within the scatter.", lines)
        self.assertNotIn("hard: ", "".join(lines))
        self.study("curves", "--output", self.path("c.svg"), "--only", "soft_2",
                   "--reference", self.path("tests.csv"))
        with_bars = self.text("c.svg")
        synthetic_run.write(self.path("tests.csv"),
                            "name,displacement_mm,force_N\n2,19,170\n")
        self.study("curves", "--output", self.path("c.svg"), "--only", "soft_2",
                   "--reference", self.path("tests.csv"))
        self.assertGreater(with_bars.count("<path"), self.text("c.svg").count("<path"))
        synthetic_run.write(self.path("tests.csv"),
                            head.replace(",force_plus", "") + "2,19,2,1,170,5\n")
        self.assertIn("there is no force_plus", self.study(
            "compare", self.path("tests.csv"), status=2).stderr)

    def test_paths(self):
        header = "step,crack,x_mm,y_mm\n"
        a, b = self.path("out", "soft_1"), self.path("out", "soft_2")
        synthetic_run.write(os.path.join(a, "crack_path.csv"),
                            header + "1,0,0,0\n1,0,4,0\n# outcome: other\n")
        synthetic_run.write(os.path.join(b, "crack_path.csv"),
                            header + "1,0,0,1\n1,0,2,0\n1,0,4,0\n# outcome: other\n")
        process = called(STUDY, "paths", a, b)
        if "no Python with matplotlib" in process.stderr:
            self.skipTest("no Python with matplotlib on this machine")
        self.assertEqual(process.returncode, 0, process.stderr)
        # (0, 0) lies 2 / sqrt(5) from the slope, (0, 1) lies 1 from the axis
        self.assertIn("soft_1: at most 0.8944 mm, 0.4472 mm", process.stdout)
        self.assertIn("soft_2: at most 1 mm, 0.3333 mm", process.stdout)
        os.remove(os.path.join(b, "crack_path.csv"))
        process = called(STUDY, "paths", a, b)
        self.assertEqual(process.returncode, 2)
        self.assertIn("there is no crack_path.csv", process.stderr)

    def picture(self, *arguments, status=0):
        """The bytes, or what is said."""
        run, target = self.path("out", "soft_1"), self.path("p.png")
        process = called(STUDY, "picture", run, "--output", target, *arguments)
        if "no Python with matplotlib" in process.stderr:
            self.skipTest("no Python with matplotlib on this machine")
        self.assertNotIn("Traceback", process.stderr)
        self.assertNotIn("Warning", process.stderr)
        self.assertEqual(process.returncode, status, process.stderr)
        if status:
            return process.stderr
        with open(target, "rb") as stream:
            return stream.read()

    def test_picture(self):
        # each choice makes another picture
        pictures = [self.picture(*arguments) for arguments in (
            (), ("--time", "0"), ("--field", "displacement"),
            ("--field", "displacement_y"), ("--deformed",), ("--deformed", "3"),
            ("--mesh",), ("--window", "0", "0", "1", "1"), ("--pixels", "200"))]
        self.assertEqual(len(set(pictures)), len(pictures))
        for data in pictures:
            self.assertEqual(data[:4], b"\x89PNG")
            self.assertLess(len(data), 100000)
        self.assertEqual(pictures[0], self.picture("--time", "1e9"))
        self.assertIn("'heat' is not in", self.picture("--field", "heat", status=2))
        self.assertIn("--pixels", self.picture("--pixels", "1", status=2))
        shutil.rmtree(self.path("out", "soft_1", "fields"))
        self.assertIn("no fields", self.picture(status=2))

    def test_slits_are_outlined(self):
        synthetic_run.write(self.path("slit.py"), SLIT % os.path.dirname(STUDY))
        process = called(self.path("slit.py"))
        if "no Python with matplotlib" in process.stderr:
            self.skipTest("no Python with matplotlib on this machine")
        self.assertEqual(process.stdout.split(), ["6", "8"], process.stderr)

    def test_opening(self):
        run = self.path("out", "soft_1")
        synthetic_run.write(os.path.join(run, "crack_opening.csv"),
                            "step,time_s,line,position_mm,x_mm,y_mm,opening_mm\n"
                            "0,0,0,0,2,-1,5\n"
                            "1,1,0,0,2,-1,0\n1,1,0,1,2,0,1\n1,1,0,2,2,1,0\n")
        for exact, status in (("sqrt(1-x**2)", 0), ("1+", 2), ("open('f')", 2)):
            process = called(STUDY, "opening", run, "--output", self.path("o.svg"),
                             "--exact", exact)
            if "no Python with matplotlib" in process.stderr:
                self.skipTest("no Python with matplotlib on this machine")
            self.assertNotIn("Traceback", process.stderr)
            self.assertEqual(process.returncode, status, process.stderr)
        text = self.text("o.svg")
        for word in ("computed", "exact", "Opening (mm)", "Position (mm)"):
            self.assertIn(">%s<" % word, text)
        # over the coordinate in which the line extends; not the step before
        numbers = re.findall(r">([\u2212]?[\d.]+)<", text)
        numbers = [float(number.replace("\u2212", "-")) for number in numbers]
        self.assertEqual((min(numbers), max(numbers)), (-1., 1.), numbers)

    def test_nothing_to_draw(self):
        self.remove(self.output)
        self.assertIn("there is no directory", self.study(
            "curves", "--output", self.path("c.svg"), status=2).stderr)
        os.mkdir(self.output)
        self.assertIn("holds no run", self.study(
            "curves", "--output", self.path("c.svg"), status=2).stderr)


if __name__ == "__main__":
    unittest.main()
