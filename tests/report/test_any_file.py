#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The page of a run, whatever its files hold: a page with all parts that can be
made, or one line, never a trace of the inside. Files are damaged at random.

    test_any_file.py [number of damaged runs [first seed]]
"""
import os
import random
import shutil
import sys
import tempfile
import unittest
import warnings

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "scripts"))
from report_parts import interpreter  # noqa: E402

if __name__ == "__main__":
    interpreter.use_one_with_matplotlib()

import matplotlib  # noqa: E402
matplotlib.use("Agg")
import synthetic_run  # noqa: E402
from report_parts import page, pictures, safe  # noqa: E402
from sweep_parts import table  # noqa: E402
from test_report import Balance, run_report  # noqa: E402

N_RUNS, FIRST_SEED = 30, 1
FILES = ("statistics.csv", "summary.json", "crack_path.csv", "parameters.prm",
         "log.txt", "fields.pvd", "fields/step_1.pvtu", "fields/step_1.0.vtu")
ODD = ("nan", "inf", "-inf", "-nan", "", "1e308", "-1e308", "1e400", "1e-320", "abc",
       "9" * 400, "0x10", '"', "\x00", "1e5_0", " ", "-1", "1.5", "null", "\ud7ff")
JSON = ("[]", "{}", "null", '"x"', "true", "NaN", "Infinity", "-1e999", "9" * 5000,
        '"\\ud800"', "[" * 3000, '{"a": [1]}', "[null, 1, {}]", '""', "-7")


def one_token(text, chance, separators):
    """Another thing in the place of one number or word."""
    begin = chance.randrange(len(text) or 1)
    while begin > 0 and text[begin - 1] not in separators:
        begin -= 1
    end = begin
    while end < len(text) and text[end] not in separators:
        end += 1
    return begin, end


def damaged(text, chance, name):
    kind = chance.randrange(9)
    at = chance.randrange(len(text) + 1)
    if kind == 0:
        return text[:at]
    if kind == 1:
        return ""
    if kind == 2:
        return "".join(chr(chance.randrange(256)) for _ in range(600))
    if kind == 3:  # a piece is gone, or twice there
        other = min(len(text), at + chance.randrange(1, 80))
        return text[:at] + chance.choice(["", 2 * text[at:other]]) + text[other:]
    if kind == 4:
        letters = list(text)
        for _ in range(chance.randrange(1, 12)):
            if letters:
                letters[chance.randrange(len(letters))] = chr(chance.randrange(128))
        return "".join(letters)
    if kind == 5 and name.endswith(".csv"):  # a column less
        column = chance.randrange(8)
        return "\n".join(",".join(f for i, f in enumerate(line.split(","))
                                  if i != column) for line in text.split("\n"))
    for _ in range(chance.choice([1, 1, 3, 20])):
        begin, end = one_token(text, chance, ',: \n{}[]="')
        text = text[:begin] + chance.choice(
            JSON if name.endswith(".json") else ODD) + text[end:]
    return text


class Page(unittest.TestCase):
    def setUp(self):
        self.base = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.base)
        self.whole = os.path.join(self.base, "whole")
        os.mkdir(self.whole)
        synthetic_run.write_run(self.whole)
        synthetic_run.write(os.path.join(self.whole, "log.txt"), "warning: one\n")
        # pictures take most of the time and are the same for all
        pixels = pictures.canvas.__defaults__
        self.addCleanup(setattr, pictures.canvas, "__defaults__", pixels)
        pictures.canvas.__defaults__ = (60,)

    def examine(self, directory):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            text = page.written(directory)
            safe.write_whole(os.path.join(directory, "sweep.csv"), table.csv_text(
                table.RESULTS, [table.results_of(directory).values()]))
        text.encode("utf-8")
        balance = Balance()
        balance.feed(text)
        self.assertEqual(balance.open, [])
        self.assertTrue(text.rstrip().endswith("</html>"))
        # nothing was left to the last resort
        self.assertFalse("could not be made" in text, text[text.find("could not"):][:300])
        # parameters are shown as they were written, whatever that is
        figures = text.split("<summary>All parameters")[0]
        for word in (">nan<", ">inf<", ">-inf<", "Traceback"):
            self.assertFalse(word in figures, word)
        with open(os.path.join(directory, "sweep.csv")) as stream:
            for word in ("nan", "inf"):
                self.assertNotIn(word, stream.read().split(",")[1:])

    def test_damaged_files(self):
        for seed in range(FIRST_SEED, FIRST_SEED + N_RUNS):
            chance = random.Random(seed)
            directory = os.path.join(self.base, "run")
            shutil.copytree(self.whole, directory)
            names = chance.sample(FILES, chance.choice([1, 1, 2, 4]))
            for name in names:
                path = os.path.join(directory, name)
                with open(path, encoding="latin-1") as stream:
                    text = stream.read()
                if chance.random() < 0.05:
                    os.remove(path)
                    if chance.random() < 0.5:
                        os.mkdir(path)
                    continue
                with open(path, "w", encoding=chance.choice(["latin-1", "utf-8"]),
                          errors="replace") as stream:
                    stream.write(damaged(text, chance, name))
            with self.subTest(seed=seed, files=names):
                self.examine(directory)
            shutil.rmtree(directory)

    def test_damaged_table_of_sheets(self):
        """Of a body in 3-d, without fields."""
        shutil.rmtree(os.path.join(self.whole, "fields"))
        for name in ("crack_path.csv", "fields.pvd"):
            os.remove(os.path.join(self.whole, name))
        with open(os.path.join(self.whole, "parameters.prm"), "a") as stream:
            stream.write("subsection Geometry\n  set Dimension = 3\nend\n")
        for seed in range(FIRST_SEED, FIRST_SEED + N_RUNS // 2):
            synthetic_run.write(
                os.path.join(self.whole, "crack_sheet.csv"),
                damaged(synthetic_run.SHEETS, random.Random(seed), "crack_sheet.csv"))
            with self.subTest(seed=seed):
                self.examine(self.whole)

    def test_binary_in_every_file(self):
        for name in FILES:
            with open(os.path.join(self.whole, name), "wb") as stream:
                stream.write(bytes(range(256)) * 8)
        self.examine(self.whole)

    def test_every_value_of_the_summary_is_odd(self):
        for odd in JSON:
            synthetic_run.write(os.path.join(self.whole, "summary.json"), "{%s}" % (
                ", ".join('"%s": %s' % (key, odd) for key in
                          list(table.RESULTS) + ["warnings", "seconds_per_phase",
                                                 "exit_reason", "outcome_start"])))
            with self.subTest(odd=odd[:20]):
                self.examine(self.whole)

    def test_every_number_of_the_statistics_is_odd(self):
        header = synthetic_run.COLUMNS
        for odd in ODD[:-1]:
            line = ",".join([odd] * len(header.split(",")))
            synthetic_run.write(os.path.join(self.whole, "statistics.csv"),
                                "\n".join([header] + 3 * [line]) + "\n")
            with self.subTest(odd=odd[:20]):
                self.examine(self.whole)


class Script(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.directory)
        self.target = os.path.join(self.directory, "report.html")

    def test_page_of_another_is_left_alone(self):
        synthetic_run.write(self.target, "<title>Mine</title>")
        process = run_report(self.directory)
        self.assertEqual(process.returncode, 1)
        self.assertEqual(process.stderr.count("\n"), 1, process.stderr)
        self.assertIn("--output", process.stderr)
        with open(self.target) as stream:
            self.assertEqual(stream.read(), "<title>Mine</title>")

    def test_page_is_recorded_where_the_run_keeps_a_list(self):
        path = os.path.join(self.directory, "run_files.txt")
        first = "# written by a run of mixed-cracks; --overwrite removes these\n"
        synthetic_run.write(path, first)
        for _ in range(2):
            self.assertEqual(run_report(self.directory).returncode, 0)
        with open(path) as stream:
            self.assertEqual(stream.read(), first + "report.html\n")
        synthetic_run.write(path, "a list of mine\n")
        self.assertEqual(run_report(self.directory).returncode, 0)
        with open(path) as stream:
            self.assertEqual(stream.read(), "a list of mine\n")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        N_RUNS = int(sys.argv.pop(1))
    if len(sys.argv) > 1:
        FIRST_SEED = int(sys.argv.pop(1))
    unittest.main()
