#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What `cmake --install` leaves works by itself, from any directory.

    check_installation.py CMAKE BUILD_DIRECTORY MPIRUN

Installs into a new prefix and, from an empty working directory: every case is there
as it is in the project (where check_all.py and run_two_steps.py try it), those that
read files make two steps, and the scripts on the PATH find their parts and the
program.
"""
import filecmp
import os
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import check_all  # noqa: E402
import run_two_steps  # noqa: E402
from program import Program  # noqa: E402

CMAKE, BUILD, MPIRUN = "", "", ""
SCRIPTS = ("report", "sweep", "study", "picture-3d", "identify")


class Installation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.prefix = os.path.join(cls.directory.name, "here")
        subprocess.run([CMAKE, "--install", BUILD, "--prefix", cls.prefix], check=True,
                       stdout=subprocess.DEVNULL)
        cls.shared = os.path.join(cls.prefix, "share", "mixed-cracks")
        cls.program = os.path.join(cls.prefix, "bin", "mixed-cracks")
        cls.cases = list(check_all.parameter_files(cls.shared))

    @classmethod
    def tearDownClass(cls):
        cls.directory.cleanup()

    def call(self, *words):
        """Output of what the PATH has under that name."""
        path = os.path.join(self.prefix, "bin") + os.pathsep + os.environ["PATH"]
        with tempfile.TemporaryDirectory() as folder:
            return subprocess.run(words, cwd=folder, env=dict(os.environ, PATH=path),
                                  check=True, stdout=subprocess.PIPE,
                                  universal_newlines=True).stdout

    def test_every_case_is_there(self):
        self.assertEqual(
            [os.path.relpath(path, self.shared) for path in self.cases],
            [name for name in (os.path.relpath(path, run_two_steps.ROOT) for path in
                               check_all.parameter_files(run_two_steps.ROOT))
             if name.startswith("parameters")])
        for path in self.cases:
            self.assertTrue(filecmp.cmp(path, os.path.join(
                run_two_steps.ROOT, os.path.relpath(path, self.shared)), shallow=False))

    def test_cases_with_files_make_two_steps(self):
        n_cases = 0
        for path in self.cases:
            with open(path, encoding="utf-8") as stream:
                if not re.search(r"^\s*(set\s+File name|include)|table\(", stream.read(),
                                 re.MULTILINE):
                    continue
            n_cases += 1
            self.assertEqual(list(check_all.offences(Program(self.program), path)), [], path)
            with tempfile.TemporaryDirectory() as folder:
                found = list(run_two_steps.offences(
                    Program(self.program), path, folder))
            self.assertEqual(found, [], path)
        self.assertGreaterEqual(n_cases, 10)

    def test_examples_are_copied_with_what_they_read(self):
        listed = [line.split()[0]
                  for line in self.call("mixed-cracks", "--example").splitlines()]
        self.assertEqual(len(listed), len(self.cases))
        for name, n_files in (("punctured_strip", 1), ("finite_strain/thick_strip", 2),
                              ("thick_cylinder", 2), ("load_table", 2),
                              ("heterogeneous_block", 2),
                              ("multiple_cracks_heterogeneous", 3)):
            with tempfile.TemporaryDirectory() as folder:
                subprocess.run([self.program, "--example", name], cwd=folder,
                               check=True, stdout=subprocess.DEVNULL)
                files = os.listdir(folder)
                self.assertEqual(len(files), n_files, files)
                # the rest of the installation is not needed any more
                copy = os.path.join(folder, "alone")
                os.mkdir(copy)
                for file in files:
                    os.rename(os.path.join(folder, file), os.path.join(copy, file))
                case = os.path.join(copy, os.path.basename(name) + ".prm")
                found = list(check_all.offences(Program(self.program), case))
                self.assertEqual(found, [], name)

    def test_an_example_overwrites_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "thick_cylinder.msh"), "w") as stream:
                stream.write("mine")
            for launcher in ([], [MPIRUN, "-n", "2"]):
                process = subprocess.run(
                    launcher + [self.program, "--example", "thick_cylinder"],
                    cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                    universal_newlines=True)
                self.assertEqual(process.returncode, 4)
                self.assertEqual(process.stderr.count("error:"), 1, process.stderr)
                self.assertIn("thick_cylinder.msh", process.stderr)
                self.assertEqual(os.listdir(folder), ["thick_cylinder.msh"])

    def test_scripts_are_on_the_path(self):
        for name in SCRIPTS:
            self.assertIn("usage", self.call("mixed-cracks-" + name, "--help").lower())
        sweep = os.path.join(self.shared, "parameters", "epdm", "notch_heights.sweep")
        lines = self.call("mixed-cracks-sweep", sweep, "--list").splitlines()
        self.assertGreater(len(lines), 1)
        for line in lines:
            self.assertIn(self.program, line)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    CMAKE, BUILD, MPIRUN = sys.argv[1], os.path.abspath(sys.argv[2]), sys.argv[3]
    unittest.main(argv=sys.argv[:1])
