#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What users do wrong with scripts/identify.py: one line each that names the file, the
line, the column and what is allowed."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from common import UNIAXIAL, Case, skip_without_scipy  # noqa: E402

HEAD = "# test: uniaxial\nstretch,nominal_stress_MPa\n"
GOOD = HEAD + "1.5,1\n2,1.5\n2.5,2\n"


class Files(Case):
    def test_tables(self):
        for text, *words in (
                (HEAD + "1.5,1\n2,abc\n", "t.csv:4", "column 'nominal_stress_MPa'",
                 "expected a number", "'abc'"),
                (HEAD + "1.5,1\n1e200,1\n", "t.csv:4", "at most 1e+12"),
                (HEAD + "1.5,1\n2,nan\n", "t.csv:4", "expected a number", "'nan'"),
                (HEAD + "1.5,1\n0,1\n", "t.csv:4", "column 'stretch'",
                 "a number above 0"),
                (HEAD + "1.5,1\n2\n", "t.csv:4", "expected 2 fields", "found 1"),
                (HEAD.replace(",", ";") + "1,5;1\n", "t.csv:3", "decimals"),
                (HEAD, "t.csv", "expected rows"),
                ("", "t.csv", "expected a header"),
                (GOOD.replace("stretch", "lambda"), "t.csv:2", "expected one of",
                 "'stretch'", "found 'lambda'"),
                (GOOD.replace("nominal_stress_MPa", "Pa"), "t.csv:2", "'force_N'",
                 "found 'stretch' and 'Pa'"),
                (GOOD.replace("nominal_stress_MPa", "stretch"), "t.csv:2", "twice"),
                (GOOD.replace("nominal_stress_MPa", "force_N"), "t.csv:2", "--area",
                 "area_mm2"),
                (GOOD.replace("stretch", "displacement_mm"), "t.csv:2",
                 "--gauge-length"),
                (GOOD.replace("uniaxial", "torsion"), "t.csv:1", "expected a kind",
                 "equibiaxial", "torsion"),
                (GOOD.replace("# test: uniaxial\n", ""), "t.csv", "KIND:FILE"),
                ("# area_mm2: -1\n" + GOOD.replace("nominal_stress_MPa", "force_N"),
                 "t.csv:1", "'area_mm2'", "above 0"),
                ("test,stretch,stress_MPa\nplanar,2,1\nshear,2,1\n", "t.csv:3",
                 "column 'test'", "planar")):
            with self.subTest(text=text):
                self.refused(self.write("t.csv", text), "--law", "neo-Hooke",
                             words=words)

    def test_files(self):
        self.refused("nowhere.csv", "--law", "Yeoh", words=("no file 'nowhere.csv'",))
        self.refused("uniaxial:nowhere.csv", "--law", "Yeoh",
                     words=("nowhere.csv cannot be read",))
        self.refused("torsion:" + UNIAXIAL, "--law", "Yeoh", words=("KIND:FILE",))
        with open(self.path("b.csv"), "wb") as stream:
            stream.write(b"\xff\xfe\x00\x81")
        self.refused("uniaxial:" + self.path("b.csv"), "--law", "Yeoh",
                     words=("UTF-8",))

    def test_measures_in_the_file(self):
        text = ("# area_mm2: 4\n# gauge_length_mm: 20\n# test: tensile\n"
                "displacement_mm;force_N\n10;4\n20;7\n30;11\n")
        test = self.numbers(self.write("t.csv", text), "--law",
                            "neo-Hooke")["tests"][0]
        self.assertEqual(test["stretch"], [1.5, 2., 2.5])
        self.assertEqual(test["stress_MPa"], [1., 1.75, 2.75])
        test = self.numbers(self.path("t.csv"), "--law", "neo-Hooke", "--area", "8",
                            "--gauge-length", "t.csv=10")["tests"][0]
        self.assertEqual(test["stretch"], [2., 3., 4.])
        self.assertEqual(test["stress_MPa"], [0.5, 0.875, 1.375])

    def test_kinds_in_a_column(self):
        text = "test,strain,stress_MPa\npure shear,1,1.9\nbiaxial,1,2\nplanar,.5,1.2\n"
        tests = self.numbers(self.write("t.csv", text), "--law", "neo-Hooke")["tests"]
        self.assertEqual([(test["kind"], test["stretch"]) for test in tests],
                         [("planar", [2., 1.5]), ("equibiaxial", [2.])])
        text = "stretch,planar_nominal_stress_MPa\n1.5,1.2\n2,1.9\n"
        tests = self.numbers(self.write("t.csv", text), "--law", "neo-Hooke")["tests"]
        self.assertEqual(tests[0]["kind"], "planar")


class Options(Case):
    def test_command_line(self):
        for words, *expected in (
                ((), "--law NAME"),
                ((UNIAXIAL,), "--law NAME", "Ogden"),
                (("--law", "Yeoh"), "expected tests"),
                ((UNIAXIAL, "--law", "Hooke"), "--law", "neo-Hooke", "'Hooke'"),
                ((UNIAXIAL, "--law", "Yeoh", "--range", "3"), "--range", "LOW:HIGH"),
                ((UNIAXIAL, "--law", "Yeoh", "--range", "3:1"), "LOW below HIGH"),
                ((UNIAXIAL, "--law", "Yeoh", "--range", "20:30"), "treloar_uniaxial",
                 "no point", "1.02:7.6"),
                ((UNIAXIAL, "--law", "Yeoh", "--range", "planar=1:3"), "--range",
                 "'planar'"),
                ((UNIAXIAL, "--law", "Yeoh", "--range", "1:1.2"), "more points than "
                 "the 3 constants", "found 2"),
                ((UNIAXIAL, "--law", "Yeoh", "--weight", "-1"), "--weight", "above 0"),
                ((UNIAXIAL, "--law", "Yeoh", "--weight", "1", "--weight", "2"),
                 "twice"),
                ((UNIAXIAL, "--law", "Yeoh", "--confidence", "95"), "--confidence"),
                ((UNIAXIAL, "--law", "Yeoh", "--use", "0:4"), "--use", "above 0"),
                ((UNIAXIAL, "--law", "Yeoh", "--picture", "a.pdf"), "--picture",
                 ".svg"),
                ((UNIAXIAL, "--law", "Yeoh", "--picture", "/nowhere/a.svg"),
                 "/nowhere/a.svg"),
                ((UNIAXIAL, "--linear-ranges", "80,20"), "ascending"),
                ((UNIAXIAL, "--linear-ranges", "1000"), "2 to 660 %", "1000"),
                (("planar:" + UNIAXIAL, "--linear-ranges", "10"), "uniaxial"),
                ((UNIAXIAL, "--constants", "C10=1"), "--law"),
                (("--law", "Yeoh", "--constants", "C10=1"), "C20, C30"),
                (("--law", "Yeoh", "--constants", "C1=1"), "C10, C20, C30", "'C1=1'"),
                (("--law", "Yeoh", "--constants", "C10=x"), "C10", "'x'"),
                ((UNIAXIAL, "--law", "Gent", "--constants", "mu=1,Jm=30"), "Jm = 30")):
            with self.subTest(words=words):
                self.refused(*words, words=expected)


class Tear(Case):
    SPECIMEN = ("--tear", "--width", "196", "--height", "28", "--thickness", "1.8")

    def setUp(self):
        super().setUp()
        self.whole = self.csv("w.csv", "displacement_mm,force_N", (0, 1, 2, 3),
                              (0, 10, 20, 30))
        self.grown = self.csv("g.csv", "displacement_mm,force_N,crack_length_mm",
                              (0, 1, 2, 4), (0, 5, 9, 8), (47, 47, 47, 50))

    def test_tear(self):
        whole, grown = self.whole, self.grown
        for words, *expected in (
                ((), "with a crack"),
                ((whole,), "uncracked:FILE, LENGTH:FILE or growing:FILE"),
                (("uncracked:" + whole,), "with a crack"),
                (("47:" + whole,), "uncracked:FILE"),
                (("-3:" + whole,), "above 0"),
                (("500:" + whole,), "shorter than --width 196"),
                (("47:" + whole, "47:" + whole), "each crack length"),
                (("growing:" + whole,), "w.csv:1", "crack length", "crack_length_mm"),
                (("growing:" + grown,), "elastic_energy_mJ"),
                (("growing:" + grown, "uncracked:" + whole), "w.csv",
                 "displacements up to 4 mm", "found 3"),
                (("growing:" + grown, "uncracked:" + whole, "--step", "9"), "--step"),
                (("growing:" + grown, "--crack-length", "path"), "directory of a run"),
                (("growing:" + grown, "--crack-length", "no.csv"), "no.csv"),
                (("47:" + whole, "--component", "x"), "w.csv:1", "'force_x_N'"),
                (("uncracked:" + UNIAXIAL,), "treloar_uniaxial.csv:5",
                 "'displacement_mm'"),
                (("47:" + whole, "49:" + grown, "--onset", "3.5"), "w.csv",
                 "displacements up to 3.5 mm"),
                (("47:" + self.directory,), "statistics.csv cannot be read")):
            with self.subTest(words=words):
                self.refused(*self.SPECIMEN, *words, words=expected)
        self.refused("--tear", "--width", "3", "47:" + whole, words=("--height",))
        self.refused("--tear", "--width", "wide", "47:" + whole, words=("--width",))

    def test_rows(self):
        for rows, *expected in (
                ("0,0,1\n1,x,1\n2,3,2\n", "t.csv:3", "column 'force_N'", "'x'"),
                ("-1,0,1\n1,1,1\n2,3,2\n", "t.csv:2", "'displacement_mm'",
                 "at least 0"),
                ("0,0,1\n1,1,1\n", "at least 3 rows"),
                ("0,0,1\n0,1,1\n0,2,2\n", "3 increasing values"),
                ("0,0,1\n1,1,1\n2,2,1\n", "a crack length that grows")):
            with self.subTest(rows=rows):
                path = self.write("t.csv",
                                  "displacement_mm,force_N,crack_length_mm\n" + rows)
                self.refused(*self.SPECIMEN, "growing:" + path, words=expected)


def setUpModule():
    skip_without_scipy()


if __name__ == "__main__":
    unittest.main()
