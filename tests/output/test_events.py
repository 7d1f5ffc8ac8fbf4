#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Output/Events: fields, a row and a line for what cracks come to, the same on every
number of ranks and in a run that is killed and goes on.

usage: test_events.py EXECUTABLE MPIRUN
"""
import os
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "resume"))
import runs  # noqa: E402
from small_runs import (  # noqa: E402
    killed_after_rows, steps_with_fields, table_of, text_of)

STEP = 0.2  # mm
WATCHED = ["Output/Events=all", "Output/Event crack length=%g" % STEP,
           "Output/Field format=VTU", "Output/Fields every=0",
           "Output/Checkpoint every=1"]
NUMBERS = ("time_s", "displacement_mm", "force_N", "crack_length_mm", "growth_mm",
           "x_mm", "y_mm")


class Events(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.whole = cls.folder / "whole"
        cls.calculate = runs.Runner(sys.argv[1], sys.argv[2:3])
        cls.calculate(cls.whole, settings=WATCHED)
        cls.events = table_of(cls.whole, "events.csv")

    def same_events(self, directory):
        found = table_of(directory, "events.csv")
        for name in ("step", "event", "boundary"):
            self.assertEqual([row[name] for row in found],
                             [row[name] for row in self.events])
        for name in NUMBERS:
            for row, expected in zip(found, self.events):
                self.assertEqual(row[name] == "", expected[name] == "", (row, expected))
                if row[name]:
                    self.assertAlmostEqual(float(row[name]), float(expected[name]),
                                           delta=1e-4, msg=name)

    def of_kind(self, kind):
        return [row for row in self.events if row["event"] == kind]

    def test_what_happens(self):
        self.assertEqual([row["event"] for row in self.events][0], "start")
        (onset,) = self.of_kind("onset")
        self.assertGreater(int(onset["step"]), 0)
        # at the tip of the slit
        self.assertAlmostEqual(float(onset["x_mm"]), 0.5, delta=0.2)
        self.assertAlmostEqual(float(onset["y_mm"]), 0.5, delta=0.2)
        (met,) = self.of_kind("boundary")
        self.assertEqual(met["boundary"], "right")
        self.assertAlmostEqual(float(met["x_mm"]), 1., delta=1e-6)
        self.assertEqual(len(self.of_kind("separation")), 1)

    def test_growth_against_the_paths(self):
        """One event for each step in which another multiple is passed."""
        lengths = {}
        for row in table_of(self.whole, "crack_path.csv"):
            lengths.setdefault(int(row["step"]), {})[row["crack"]] = \
                float(row["length_mm"])
        total, passed, expected = 0., 0, []
        for row in runs.rows(self.whole):
            step = int(row["step"])
            total = sum(lengths[step].values()) if step in lengths else total
            multiple = int(total / STEP + 1e-9)
            if multiple > passed:
                expected.append(step)
                passed = multiple
        self.assertEqual([int(row["step"]) for row in self.of_kind("crack length")],
                         expected)
        self.assertGreaterEqual(len(expected), 1)

    def test_fields_and_lines(self):
        steps = {int(row["step"]) for row in self.events}
        with_fields = steps_with_fields(self.whole)
        self.assertLessEqual(steps, with_fields)
        peak = runs.summary(self.whole)["step_at_peak"]
        last = int(runs.rows(self.whole)[-1]["step"])
        # until the peak those of each checkpoint, which might have been it
        self.assertLessEqual({step for step in with_fields if step > peak},
                             steps | {last})
        lines = re.findall(r"^  event: (.*)$", text_of(self.whole, "log.txt"), re.M)
        self.assertEqual(len(lines), len(self.events) - len(self.of_kind("start")))
        self.assertTrue(any("a crack meets right" in line for line in lines), lines)
        self.assertIn("events.csv", text_of(self.whole, "run_files.txt").split())
        told = runs.summary(self.whole)["events"]
        self.assertEqual([(str(entry["step"]), entry["event"]) for entry in told],
                         [(row["step"], row["event"]) for row in self.events])

    def test_two_and_three_ranks(self):
        for ranks in (2, 3):
            directory = self.folder / ("ranks%d" % ranks)
            self.calculate(directory, settings=WATCHED, ranks=ranks)
            self.same_events(directory)
            self.assertEqual(steps_with_fields(directory), steps_with_fields(self.whole))

    def test_killed_in_between(self):
        for n_rows in range(1, len(self.events), 2):
            directory = self.folder / ("killed%d" % n_rows)
            killed_after_rows(self.calculate.command(directory, settings=WATCHED),
                              directory, "events.csv", n_rows)
            if not list(directory.glob("checkpoint/*/seal.txt")):
                self.calculate(directory, "--overwrite", settings=WATCHED)
            elif not (directory / "summary.json").exists():
                # rows of steps that will be computed again
                with open(directory / "events.csv", "a", encoding="utf-8") as table:
                    table.write("99,1,1,1,separation,1,1,,,\n")
                self.calculate(directory, "--resume", settings=WATCHED,
                         ranks=1 + n_rows // 2 % 2)
            self.same_events(directory)
            self.assertLessEqual({int(row["step"]) for row in self.events},
                                 steps_with_fields(directory))

    def test_resumed_at_every_event(self):
        """Stopped by the end time right at, and right behind, the steps of events."""
        times = sorted({float(row["time_s"]) for row in self.events} - {0.})
        directory = self.folder / "pieces"
        for number, time_of_event in enumerate(times):
            self.calculate(directory, "--resume" if number else "--overwrite", settings=[
                *WATCHED, "Load stepping/End time=%.17g" % time_of_event])
        self.calculate(directory, "--resume", settings=WATCHED)
        found = [(row["event"], row["boundary"])
                 for row in table_of(directory, "events.csv")]
        self.assertEqual(found, [(row["event"], row["boundary"]) for row in self.events])

    def test_none_writes_nothing(self):
        directory = self.folder / "none"
        self.calculate(directory, settings=WATCHED[2:])
        self.assertFalse((directory / "events.csv").exists())
        self.assertNotIn("event", text_of(directory, "log.txt").replace(
            "Output/Event", ""))
        self.assertNotIn("events", runs.summary(directory))
        self.assertLess(len(steps_with_fields(directory)),
                        len(steps_with_fields(self.whole)))
        self.assertEqual(runs.rows(directory)[-1]["crack_length_mm"],
                         runs.rows(self.whole)[-1]["crack_length_mm"])

    def test_some_kinds_and_overwrite(self):
        directory = self.folder / "some"
        shutil.copytree(self.whole, directory)
        self.calculate(directory, "--overwrite",
                 settings=[*WATCHED[1:], "Output/Events=separation, onset"])
        self.assertEqual([row["event"] for row in table_of(directory, "events.csv")],
                         ["start", "onset", "separation"])
        self.calculate(directory, "--overwrite", settings=WATCHED[2:])
        self.assertFalse((directory / "events.csv").exists())

    def test_wrong_words(self):
        for setting, says in (("Output/Events=onset, none", "'none' alone"),
                              ("Output/Events=all, onset", "'all' alone"),
                              ("Output/Events=onsets", "Output/Events"),
                              ("Output/Event crack length=0", "above 0")):
            said = self.calculate(self.folder / "wrong", settings=[setting], status=2)
            self.assertIn(says, said)
            self.assertEqual(len(runs.errors_in(said)), 1, said)
        self.assertFalse((self.folder / "wrong").exists())


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.argv[1] = os.path.abspath(sys.argv[1])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
