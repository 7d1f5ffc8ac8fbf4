# SPDX-License-Identifier: GPL-2.0-or-later
"""Calls of scripts/identify.py, and curves from formulas of our own; Python's own
library only."""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPTS = os.path.join(HERE, os.pardir, os.pardir, "scripts")
SCRIPT = os.path.join(SCRIPTS, "identify.py")
sys.path.insert(0, SCRIPTS)
from report_parts import interpreter as search  # noqa: E402

# one that need not look for another: that takes longer than most calls
PYTHON = next((path for path in search.interpreters()
               if search.has_modules(path, ("numpy", "matplotlib", "scipy"))),
              sys.executable)
UNIAXIAL = os.path.join(HERE, "treloar_uniaxial.csv")
EQUIBIAXIAL = os.path.join(HERE, "treloar_equibiaxial.csv")
MODES = ("uniaxial", "planar", "equibiaxial")


def called(*arguments, interpreter=(PYTHON,), **environment):
    return subprocess.run(list(interpreter) + ["-B", SCRIPT] + list(arguments),
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env=dict(os.environ, **environment),
                          universal_newlines=True)


def skip_without_scipy():
    if "no Python with" in called("--help").stderr:
        raise unittest.SkipTest("no Python with SciPy on this machine")


def invariant_stress(w1, w2=lambda i: 0.):
    """Nominal stress of W(I1, I2), as textbooks have it: w1, w2 of I1 - 3."""
    def stress(mode, x):
        if mode == "uniaxial":
            i = x * x + 2. / x - 3.
            return 2. * (x - x**-2) * (w1(i) + w2(i) / x)
        if mode == "planar":
            i = x * x + x**-2 - 2.
            return 2. * (x - x**-3) * (w1(i) + w2(i))
        i = 2. * x * x + x**-4 - 3.
        return 2. * (x - x**-5) * (w1(i) + x * x * w2(i))
    return stress


def ogden_stress(pairs):
    power = {"uniaxial": 0.5, "planar": 1., "equibiaxial": 2.}
    return lambda mode, x: sum(mu * (x**(alpha - 1.) - x**(-power[mode] * alpha - 1.))
                               for mu, alpha in pairs)


def even(low, high, n):
    return [low + (high - low) * i / (n - 1.) for i in range(n)]


class Case(unittest.TestCase):
    def setUp(self):
        # a blank in the name, as users have it
        self.directory = os.path.join(tempfile.mkdtemp(), "my tests")
        os.mkdir(self.directory)
        self.addCleanup(shutil.rmtree, os.path.dirname(self.directory))

    def path(self, *names):
        return os.path.join(self.directory, *names)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as stream:
            stream.write(text)
        return self.path(name)

    def csv(self, name, header, *columns):
        rows = [",".join("%.12g" % value for value in row) for row in zip(*columns)]
        return self.write(name, "\n".join([header] + rows) + "\n")

    def files_of(self, stress, stretches, modes=MODES):
        """Words of the command line for tests of a law."""
        return ["%s:%s" % (mode, self.csv(
            mode + ".csv", "stretch,nominal_stress_MPa", stretches,
            [stress(mode, x) for x in stretches])) for mode in modes]

    def text(self, *arguments):
        process = called(*arguments)
        self.assertEqual(process.returncode, 0, process.stderr)
        return process.stdout

    def numbers(self, *arguments):
        return json.loads(self.text(*arguments, "--json", "-"))

    def assertRelative(self, found, expected, tolerance):
        self.assertLess(abs(found / expected - 1.), tolerance, (found, expected))

    def refused(self, *arguments, words=()):
        """One line, exit status 2, with these words."""
        process = called(*arguments)
        self.assertEqual(process.returncode, 2, process.stdout + process.stderr)
        self.assertNotIn("Traceback", process.stderr)
        self.assertEqual(process.stderr.count("\n"), 1, process.stderr)
        for word in words:
            self.assertIn(word, process.stderr)
