#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What the program says when asked, and whether it understands it again.

    check_questions.py EXECUTABLE MPIRUN

--help, --version and --parameters in all formats; --parameters prm is a
parameter file; a run's parameters.prm gives the same run; --set and --output do
what they say; --overwrite replaces a run.
"""
import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                os.pardir, "bad_input"))
from bad_inputs import BASE  # the good file that bad ones are made of

COMMAND = []
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, os.pardir)


class Questions(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.folder = self.directory.name
        with open(os.path.join(self.folder, "case.prm"), "w") as stream:
            stream.write(BASE)

    def tearDown(self):
        self.directory.cleanup()

    def ask(self, *arguments, ranks=1):
        """Output of a call that must succeed; ranks=None: without launcher."""
        launcher = [] if ranks is None else [COMMAND[1], "-n", str(ranks)]
        process = subprocess.run(
            launcher + [COMMAND[0]] + list(arguments),
            cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, universal_newlines=True, timeout=60)
        self.assertEqual(process.stderr, "")
        self.assertEqual(process.returncode, 0)
        return process.stdout

    def rows(self, *path):
        """statistics.csv without times."""
        with open(os.path.join(self.folder, *path), newline="") as stream:
            return [{name: value for name, value in row.items()
                     if name != "wall_time_s"} for row in csv.DictReader(stream)]

    def test_help_once_on_two_ranks(self):
        text = self.ask("--help", ranks=2)
        self.assertEqual(text.count("Usage: "), 1)
        for option in ("--set", "--output", "--check", "--case-id", "--resume",
                       "--overwrite", "--parameters", "--example", "--cite", "--version",
                       "--help", "Exit status"):
            self.assertIn(option, text)

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_answers_that_cannot_be_written(self):
        for words in (["--help"], ["--version"], ["--parameters", "json"],
                      ["--check", "case.prm"]):
            with open("/dev/full", "w") as full:
                process = subprocess.run(
                    [COMMAND[0]] + words, cwd=self.folder, stdout=full,
                    stderr=subprocess.PIPE, universal_newlines=True, timeout=60)
            self.assertEqual(process.returncode, 4, words)
            self.assertEqual(process.stderr.count("error:"), 1, process.stderr)
            self.assertIn("standard output", process.stderr)
        # a run has its log.txt
        with open("/dev/full", "w") as full:
            subprocess.run([COMMAND[0], "case.prm", "--output", "unseen"],
                           cwd=self.folder, stdout=full, timeout=60, check=True)
        self.assertEqual(len(self.rows("unseen", "statistics.csv")), 3)

    def test_version(self):
        text = self.ask("--version")
        for name in ("mixed-cracks ", "deal.II ", "Trilinos ", "p4est ", "MPI"):
            self.assertIn(name, text)

    def test_how_to_cite(self):
        with open(os.path.join(ROOT, "CITATION.cff"), encoding="utf-8") as stream:
            self.assertEqual(self.ask("--cite", ranks=2), stream.read())

    def test_unknown_example(self):
        for launcher in ([], [COMMAND[1], "-n", "2"]):
            process = subprocess.run(
                launcher + [COMMAND[0], "--example", "punctured_stripe"],
                cwd=self.folder, stderr=subprocess.PIPE, universal_newlines=True,
                timeout=60)
            self.assertEqual(process.returncode, 2)
            self.assertIn("punctured_strip", process.stderr)
            self.assertEqual(process.stderr.count("error:"), 1, process.stderr)

    def test_parameters_json(self):
        entries = json.loads(self.ask("--parameters", "json"))
        self.assertGreater(len(entries), 50)
        for entry in entries:
            self.assertTrue(entry["documentation"], entry["full_name"])
            self.assertTrue(entry["allowed"], entry["full_name"])

    def test_parameters_markdown(self):
        text = self.ask("--parameters=markdown")
        self.assertIn("Length scale", text)
        self.assertIn("#", text)

    def test_printed_parameters_are_read_again(self):
        with open(os.path.join(self.folder, "printed.prm"), "w") as stream:
            stream.write(self.ask("--parameters"))
        settings = ["--set", "Material/Lame lambda=10", "--set",
                    "Material/Shear modulus=2.4", "--set",
                    "Boundary conditions/Displacement=top : all : 0"]
        self.assertIn("cells: ", self.ask("--check", *settings, "printed.prm"))

    def test_check_leaves_nothing(self):
        self.ask("--check", "case.prm", ranks=2)
        self.assertEqual(os.listdir(self.folder), ["case.prm"])

    def test_effective_parameters_give_the_same_run(self):
        self.ask("--set", "Material/Thickness=3", "--output", "first", "case.prm")
        self.ask("--output", "second", os.path.join("first", "parameters.prm"))
        first = self.rows("first", "statistics.csv")
        self.assertEqual(len(first), 3)
        self.assertNotEqual(float(first[-1]["force_y_N"]), 0.)
        self.assertEqual(first, self.rows("second", "statistics.csv"))
        texts = []
        for name in ("first", "second"):
            with open(os.path.join(self.folder, name, "parameters.prm")) as stream:
                texts.append(stream.read().replace("= " + name, "= here"))
        self.assertEqual(*texts)
        self.assertIn("set Thickness", texts[0])

    def test_with_and_without_launcher(self):
        for name, ranks in (("two", 2), ("one", 1), ("none", None)):
            self.assertIn("ranks: %d;" % (ranks or 1), self.ask(
                "--output", name, "case.prm", ranks=ranks))
        alone = self.rows("none", "statistics.csv")
        self.assertEqual(len(alone), 3)
        self.assertEqual(alone, self.rows("one", "statistics.csv"))

    def test_settings_of_open_mpi_are_left_alone(self):
        if "Open MPI" not in self.ask("--version"):
            self.skipTest("another implementation of MPI")
        # were they set over, the program would start
        for name in ("OMPI_MCA_pml", "OMPI_MCA_btl"):
            process = subprocess.run(
                [COMMAND[0], "--check", "case.prm"], cwd=self.folder, env=dict(os.environ, **{name: "unheard-of"}),
                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT, universal_newlines=True, timeout=60)
            self.assertNotEqual(process.returncode, 0, name)

    def files(self, *path):
        """Names of the fields that a run has left, or of their list."""
        found = os.listdir(os.path.join(self.folder, *path))
        return sorted(name for name in found if "fields" in name)

    def test_without_fields(self):
        none = ("--set", "Output/Field format=none")
        for ranks in (1, 2):
            self.ask("case.prm", "--overwrite", *none, ranks=ranks)
            self.assertEqual(self.files("results"), [])
            for name in ("parameters.prm", "log.txt", "summary.json"):
                self.assertGreater(
                    os.path.getsize(os.path.join(self.folder, "results", name)), 0)
        self.ask("case.prm", "--output", "with", ranks=2)
        self.assertEqual(self.files("with"), ["fields", "fields.pvd"])
        self.assertEqual(self.rows("results", "statistics.csv"),
                         self.rows("with", "statistics.csv"))

    def test_fields_of_a_continued_run_without(self):
        # the force is largest at t = 1; its state is gone when the run goes on
        settings = ("--set", "Output/Checkpoint every=1", "--set",
                    "Boundary conditions/Displacement=top : all : 0 ; "
                    "bottom : x : 0 ; bottom : y : -0.1*t*(2-t)", "case.prm")
        self.ask("--set", "Output/Field format=none",
                 "--set", "Load stepping/End time=1.5", *settings)
        self.ask("--resume", "--set", "Load stepping/End time=2", *settings)
        forces = [float(row["force_y_N"])
                  for row in self.rows("results", "statistics.csv")]
        self.assertEqual(forces.index(max(forces)), 2)
        self.assertEqual(self.files("results", "fields"),
                         ["fields_00004.0.vtu", "fields_00004.pvtu"])

    def test_overwrite(self):
        self.ask("case.prm")
        once = self.rows("results", "statistics.csv")
        self.ask("--overwrite", "--set", "Load stepping/End time=0.5", "case.prm")
        self.assertEqual(self.rows("results", "statistics.csv"), once[:2])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    COMMAND = [os.path.abspath(sys.argv[1]), sys.argv[2]]
    unittest.main(argv=sys.argv[:1])
