# SPDX-License-Identifier: GPL-2.0-or-later
"""Short runs for the tests on checkpoints: a slit square that is torn apart in
some ten load steps."""

import pathlib
import re
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program
from program import environment, rows, summary  # noqa: E402, F401

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASE = ROOT / "tests" / "regression" / "slit_square_at2.prm"
QUICK = ["Geometry/Slit square/Slit height=0.5",
         "Geometry/Slit square/Cell size=0.125", "Output/Field format=none"]
# what depends on the machine, or on how often factors were at hand
NOT_COMPARED = {"wall_time_s", "factorizations", "newton_iterations",
                "energy_imbalance_mJ", "linear_iterations", "coupling_change",
                "rejected_steps"}
NOT_OF_THE_RESULT = {"ranks", "seconds_per_phase", "peak_memory_MB",
                     "memory_MB_per_phase", "wall_time_s",
                     "factorizations", "newton_iterations", "rejected_steps"}


class Runner:
    """Runs EXECUTABLE under LAUNCHER ("mpirun"), or without one: ()."""

    def __init__(self, executable, launcher):
        self.executable, self.launcher = executable, launcher

    def command(self, directory, *options, settings=(), ranks=1):
        return [*program.command(self.executable, self.launcher, ranks), str(CASE),
                "--output", str(directory), *options,
                *program.as_options((*QUICK, *settings))]

    def __call__(self, directory, *options, settings=(), ranks=1, status=0):
        return program.output_of(
            self.command(directory, *options, settings=settings, ranks=ranks), status)


def result(directory):
    """What summary.json says of the calculation, not of its cost."""
    return {key: value for key, value in summary(directory).items()
            if key not in NOT_OF_THE_RESULT}


def same_rows(found, expected, tolerance=1e-5):
    """Equal but for @p tolerance, relative to the largest value of a column; of
    a force to the largest of its components, as one of them may be nought."""
    assert len(found) == len(expected), (len(found), len(expected))
    forces = [name for name in expected[0] if name.startswith("force_")]
    for name in set(expected[0]) - NOT_COMPARED:
        largest = max(abs(float(row[column])) for row in expected
                      for column in (forces if name in forces else [name]))
        for one, other in zip(found, expected):
            a, b = float(one[name]), float(other[name])
            assert abs(a - b) <= tolerance * largest, (name, a, b)


def errors_in(text):
    # mpirun may give a terminal, with a line of progress before it
    return re.findall(r"mixed-cracks: (?:internal )?error: .*$", text, re.M)


def generations(directory):
    """Folders of the checkpoints, the newest first."""
    def number(folder):
        words = (folder / "seal.txt").read_text().split()
        return int(words[words.index("number") + 1])
    return sorted((directory / "checkpoint").glob("generation-*"), key=number,
                  reverse=True)
