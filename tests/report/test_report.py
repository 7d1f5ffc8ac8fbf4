#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""scripts/report.py on made-up runs: whole, killed, empty, damaged."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from html.parser import HTMLParser

import synthetic_run

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                    os.pardir, os.pardir))
REPORT = os.path.join(ROOT, "scripts", "report.py")
sys.path.insert(0, os.path.join(ROOT, "scripts"))

from report_parts import quantities  # noqa: E402
VOID = ("meta", "img", "br", "link")


class Balance(HTMLParser):
    """Every element that is opened is closed, in order."""

    def __init__(self):
        super().__init__()
        self.open = []

    def handle_starttag(self, tag, attributes):
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            raise AssertionError("</%s> closes nothing" % tag)


def run_report(*arguments, interpreter=(sys.executable,), **environment):
    return subprocess.run(list(interpreter) + [REPORT] + list(arguments),
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True,
                          env=dict(os.environ, **environment))


class Quantities(unittest.TestCase):
    """The words for what the program measures are made of the names."""

    def test_words_of_a_name(self):
        self.assertEqual(quantities.label("displacement_at_peak_mm"),
                         "Displacement at peak (mm)")
        self.assertEqual(quantities.words("newton_iterations"), "Newton iterations")
        self.assertEqual(quantities.words_and_unit("crack_area_mm2"),
                         ("crack area", "mm²"))
        self.assertEqual(quantities.words_and_unit("s"), ("s", ""))

    def test_every_documented_column_has_its_unit_split_off(self):
        with open(os.path.join(ROOT, "doc", "output.md"), encoding="utf-8") as stream:
            table = stream.read().partition("## statistics.csv")[2].partition("\n## ")[0]
        columns = re.findall(r"^\| `([a-z_A-Z0-9]+)`", table, re.MULTILINE)
        self.assertGreater(len(columns), 20)
        for column in columns:
            text, _ = quantities.words_and_unit(column)
            self.assertNotRegex(text, r"_| (mm|mm2|mm3|N|mJ|s|MPa)$", column)


class Report(unittest.TestCase):
    def setUp(self):
        # a blank in the name, as users have it
        self.directory = os.path.join(tempfile.mkdtemp(), "torn strip")
        os.mkdir(self.directory)
        self.addCleanup(shutil.rmtree, os.path.dirname(self.directory))

    def path(self, name):
        return os.path.join(self.directory, name)

    def page(self):
        process = run_report(self.directory)
        self.assertEqual(process.returncode, 0, process.stderr)
        self.assertNotIn("Traceback", process.stderr)
        self.assertNotIn("Warning", process.stderr)
        with open(self.path("report.html"), encoding="utf-8") as stream:
            text = stream.read()
        balance = Balance()
        balance.feed(text)
        self.assertEqual(balance.open, [])
        for outside in re.findall(r'(?:src|href)="([^"]*)"', text):
            self.assertTrue(outside.startswith(("data:", "#")), outside[:60])
        self.assertNotIn("<script", text)
        identifiers = re.findall(r'\bid="([^"]*)"', text)
        self.assertEqual(len(identifiers), len(set(identifiers)))
        return text

    def test_whole_run(self):
        synthetic_run.write_run(self.directory)
        text = self.page()
        self.assertIn("<h1>Torn strip</h1>", text)
        self.assertIn("Punctured strip of 20 × 28", text)
        self.assertIn("a hole of radius 4", text)
        self.assertIn("peak: 160 N at 20 mm", text)
        self.assertIn("separated: 10 N left (6 %)", text)
        for moment in ("Before the crack grows", "At the peak", "After separation"):
            self.assertIn("<b>%s</b>" % moment, text)
        self.assertEqual(text.count("<svg"), 3)
        # three of the phase field, the path, the mesh, two deformed
        self.assertEqual(text.count("data:image/png"), 7)
        self.assertIn("imbalance", text)
        self.assertIn("Finished, separated", text)

    def test_fields_without_compression(self):
        synthetic_run.write_run(self.directory)
        shutil.rmtree(self.path("fields"))
        synthetic_run.write_fields(self.directory, compressed=False)
        self.assertEqual(self.page().count("data:image/png"), 7)

    def test_crack_path(self):
        synthetic_run.write_run(self.directory)
        synthetic_run.write_summary(self.directory, outcome="past the hole",
                                    outcome_start="the notch")
        text = self.page()
        self.assertIn("<dt>Crack</dt><dd>Past the hole"
                      "<small>starts at: the notch</small>", text)
        self.assertIn("</i>0</td><td>notch</td><td>right</td><td>2</td>"
                      "<td>12.5</td></tr>", text)
        # no kink angle is not a number
        self.assertIn("</i>1</td><td>interior</td><td>top</td><td>0.25</td>"
                      "<td>–</td></tr>", text)
        self.assertNotIn("inside the body", text)
        self.assertNotIn("crack_path.csv", text)

    def test_fallen_force_without_separation(self):
        synthetic_run.write_run(self.directory)
        for separated in (False, None):  # the crack stands, or nobody knows
            synthetic_run.write_summary(self.directory, separated=separated,
                                        force_fell=True, outcome="arrested")
            text = self.page()
            self.assertIn("force fell: 10 N left (6 %)", text)
            self.assertIn("<b>After the fall of the force</b>", text)
            self.assertIn("Finished, the force fell", text)
            self.assertNotIn("separated: 10 N", text)
            self.assertNotIn("After separation", text)
            self.assertNotIn("Finished, separated", text)

    def test_no_outcome(self):
        synthetic_run.write_run(self.directory)
        synthetic_run.write_summary(self.directory, outcome=None)
        self.assertNotIn("<dt>Crack</dt>", self.page())

    def test_no_crack_path(self):
        synthetic_run.write_run(self.directory)
        os.remove(self.path("crack_path.csv"))
        text = self.page()
        self.assertIn("there is no crack_path.csv", text)
        self.assertEqual(text.count("data:image/png"), 6)

    def test_three_dimensions(self):
        synthetic_run.write_run(self.directory)
        os.remove(self.path("crack_path.csv"))
        with open(self.path("parameters.prm"), encoding="utf-8") as stream:
            parameters = stream.read().replace(
                "subsection Geometry", "subsection Geometry\n  set Dimension = 3")
        synthetic_run.write(self.path("parameters.prm"), parameters
                            + "subsection Material\n  set Thickness = 1\nend\n")
        synthetic_run.write_summary(self.directory, outcome="not traced",
                                    outcome_start="not traced")
        text = self.page()
        self.assertIn("there is no crack_sheet.csv", text)
        self.assertIn("<dt>Crack</dt><dd>Not traced", text)
        self.assertIn("formulation, 3-d, ", text)
        self.assertNotIn("formulation, plane stress", text)
        self.assertNotIn("thick.", text)
        # the last step counts, and what is no number is a dash
        synthetic_run.write(self.path("crack_sheet.csv"), synthetic_run.SHEETS)
        self.assertIn("<td>0</td><td>slit</td><td>slit to back to tip</td><td>0.75</td>"
                      "<td>1.5</td><td>0.00, 1.00, 0.00</td><td>0.5</td><td>–</td>"
                      "<td>4</td>", self.page())
        self.assertIn("The cracks at 0.2\u00a0mm, when they have changed last.", self.page())

    def test_crack_path_without_fields(self):
        synthetic_run.write_statistics(self.directory)
        synthetic_run.write_crack_path(self.directory)
        self.assertIn("<td>notch</td><td>right</td>", self.page())

    def test_half_written_crack_path(self):
        synthetic_run.write_run(self.directory)
        synthetic_run.write_crack_path(self.directory, closed=False)
        self.assertIn("The cracks shown are those of step 11.", self.page())
        with open(self.path("crack_path.csv")) as stream:
            whole = stream.read()
        # cut in the last step: the one before it is the last whole one
        synthetic_run.write(self.path("crack_path.csv"), whole[:-5])
        text = self.page()
        self.assertIn("The cracks shown are those of step 10.", text)
        self.assertIn("<td>notch</td><td>inside the body</td>", text)
        self.assertNotIn("<td>notch</td><td>right</td>", text)
        for length in (0, 30, len(synthetic_run.PATH_COLUMNS) + 1):
            synthetic_run.write(self.path("crack_path.csv"), whole[:length])
            text = self.page()
            self.assertIn("<li>crack_path.csv", text)
            self.assertIn("holds no crack", text)

    def test_damaged_crack_path(self):
        synthetic_run.write_run(self.directory)
        with open(self.path("crack_path.csv")) as stream:
            lines = stream.read().splitlines()
        lines[3] = "x" + lines[3]
        lines[4] = lines[4].rpartition(",")[0]
        synthetic_run.write(self.path("crack_path.csv"), "\n".join(lines) + "\n")
        self.assertIn("2 lines of crack_path.csv could not be read", self.page())

    def test_same_input_same_page(self):
        synthetic_run.write_run(self.directory)
        first, second = self.page(), self.page()
        without_date = r"Page made on .*? from"
        self.assertEqual(re.sub(without_date, "", first),
                         re.sub(without_date, "", second))

    def test_killed_run(self):
        synthetic_run.write_run(self.directory)
        os.remove(self.path("summary.json"))
        with open(self.path("statistics.csv")) as stream:
            text = stream.read()
        synthetic_run.write(self.path("statistics.csv"), text[:text.rindex(",")])
        with open(self.path("fields.pvd")) as stream:
            text = stream.read()
        synthetic_run.write(self.path("fields.pvd"), text[:text.rindex("<DataSet") + 9])
        text = self.page()
        self.assertIn("last line of statistics.csv is incomplete", text)
        self.assertIn("no summary.json", text)
        self.assertIn("Unfinished", text)
        self.assertNotIn("After separation", text)
        self.assertIn("At the peak", text)

    def test_no_fields(self):
        synthetic_run.write_statistics(self.directory)
        text = self.page()
        self.assertIn("No fields have been written", text)
        self.assertIn("peak: 160 N", text)

    def test_fields_in_xdmf(self):
        synthetic_run.write_statistics(self.directory)
        synthetic_run.write(self.path("fields.xdmf"), "<Xdmf/>")
        text = self.page()
        self.assertIn("Output/Field format = VTU", text)
        self.assertNotIn("No fields have been written", text)

    def test_fields_switched_off(self):
        synthetic_run.write_statistics(self.directory)
        synthetic_run.write_crack_path(self.directory)
        synthetic_run.write(self.path("parameters.prm"),
                            "subsection Output\n  set Field format = none\nend\n")
        text = self.page()
        self.assertIn("This run writes no fields", text)
        self.assertNotIn("No fields have been written", text)
        self.assertIn("<td>notch</td><td>right</td>", text)
        self.assertNotIn("data:image/png", text)

    def test_damaged_fields(self):
        synthetic_run.write_run(self.directory)
        path = self.path(os.path.join("fields", "step_1.1.vtu"))
        with open(path) as stream:
            text = stream.read()
        synthetic_run.write(path, text[:len(text) // 2])
        text = self.page()
        self.assertIn("A picture is missing", text)
        self.assertIn("After separation", text)

    def test_empty_directory(self):
        text = self.page()
        self.assertIn("no statistics.csv", text)
        self.assertIn("no summary.json", text)

    def test_header_only_and_nan(self):
        synthetic_run.write(self.path("statistics.csv"), synthetic_run.COLUMNS + "\n")
        self.assertIn("holds no step yet", self.page())
        synthetic_run.write(
            self.path("statistics.csv"),
            synthetic_run.COLUMNS + "\n" + ",".join(["nan"] * 17) + "\n")
        self.page()

    def test_failed_run(self):
        synthetic_run.write_run(self.directory, coupling="time-lagged")
        synthetic_run.write_summary(self.directory, exit_status=3, separated=False, force_fell=False,
                                    exit_reason="smallest step <1e-4> reached")
        text = self.page()
        self.assertIn("The run did not finish: smallest step &lt;1e-4&gt; reached", text)
        self.assertIn("The coupling is time-lagged", text)
        self.assertNotIn("After separation", text)

    def test_load_that_was_not_carried_is_no_peak(self):
        synthetic_run.write_statistics(self.directory)
        path = os.path.join(self.directory, "statistics.csv")
        with open(path, encoding="utf-8") as stream:
            lines = stream.read().splitlines()
        last = lines[-2].split(",")
        last[4] = "200"
        synthetic_run.write(path, "\n".join(lines[:-1] + [",".join(last)]) + "\n")
        synthetic_run.write_summary(self.directory, exit_reason="no equilibrium: the "
                                    "body is apart", separated=True, force_fell=False)
        self.assertIn("peak: 160 N at 20 mm", self.page())

    def test_warnings_of_the_summary(self):
        synthetic_run.write_statistics(self.directory)
        synthetic_run.write_summary(self.directory, warnings=["h is large"],
                                    seconds_per_phase={"assembly": 1.5})
        text = self.page()
        self.assertIn("<li>h is large</li>", text)
        self.assertIn("<td>Time for assembly</td>", text)

    def test_damaged_summary(self):
        synthetic_run.write_statistics(self.directory)
        synthetic_run.write(self.path("summary.json"), "{\"cells\": ")
        self.assertIn("summary.json cannot be read", self.page())

    def test_no_such_directory(self):
        process = run_report(self.path("nowhere"))
        self.assertEqual(process.returncode, 1)
        self.assertIn("there is no directory", process.stderr)

    def test_interpreter_without_modules(self):
        # -S hides the installed packages; report.py has to look further
        blind = (sys.executable, "-S")
        process = run_report(self.directory, interpreter=blind)
        self.assertEqual(process.returncode, 0, process.stderr)
        process = run_report(self.directory, interpreter=blind,
                             MIXED_CRACKS_REPORT_ATTEMPTED="1")
        self.assertEqual(process.returncode, 1)
        self.assertIn("python3-matplotlib", process.stderr)


def setUpModule():
    with tempfile.TemporaryDirectory() as directory:
        process = run_report(directory)
    if "no Python with matplotlib" in process.stderr:
        raise unittest.SkipTest("no Python with matplotlib on this machine")


if __name__ == "__main__":
    unittest.main()
