# SPDX-License-Identifier: GPL-2.0-or-later
"""What the tests of studies share: a directory with a strip (strip_program.py)."""
import csv
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, os.pardir, os.pardir)
SWEEP = os.path.join(ROOT, "scripts", "sweep.py")
PROGRAM = os.path.join(HERE, "strip_program.py")
HEIGHT = "Geometry/Punctured strip/Notch height"


class Case(unittest.TestCase):
    def setUp(self):
        # a blank in the name, as users have it
        self.directory = os.path.join(tempfile.mkdtemp(), "my studies")
        os.mkdir(self.directory)
        self.addCleanup(self.remove)
        self.write("strip.prm", "# a strip\n")

    def remove(self):
        # complete cases are read-only
        for folder, _, _ in os.walk(self.directory):
            os.chmod(folder, 0o755)
        shutil.rmtree(os.path.dirname(self.directory))

    def path(self, *names):
        return os.path.join(self.directory, *names)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as stream:
            stream.write(text)
        return self.path(name)

    def text(self, *names):
        with open(self.path(*names), encoding="utf-8") as stream:
            return stream.read()

    def table(self, *names):
        with open(self.path(*names), newline="", encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def called(self, *arguments, status=0):
        """sweep.py with these arguments; what it says on stdout and on stderr."""
        process = subprocess.run(
            [sys.executable, "-B", SWEEP, *arguments], cwd=self.directory,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
            # the program is started by this Python, not by a slow shim on the PATH
            env=dict(os.environ, STRIP_STARTS=self.directory, PATH=os.pathsep.join(
                [os.path.dirname(sys.executable), os.environ.get("PATH", "")])))
        if "no Python with matplotlib" in process.stderr:
            self.skipTest("no Python with matplotlib on this machine")
        for word in ("Traceback", "Warning"):
            self.assertNotIn(word, process.stderr)
        self.assertEqual(process.returncode, status, process.stdout + process.stderr)
        return process.stdout, process.stderr

    def study(self, command, file, *arguments, status=0):
        """A command that runs cases."""
        return self.called(command, file, "--program", PROGRAM, "--launcher", "",
                           *arguments, status=status)

    def refused(self, *arguments):
        """What is said on stderr of wrong input: one line."""
        errors = self.study(*arguments, status=2)[1]
        self.assertEqual(errors.count("\n"), 1, errors)
        return errors

    def starts(self):
        """Notch heights of all runs that were started, in their order."""
        try:
            return [float(line) for line in self.text("starts.txt").split()]
        except OSError:
            return []
