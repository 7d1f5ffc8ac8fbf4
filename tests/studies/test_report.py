#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py report and the progress of a study; report.py --animate."""
import html.parser
import io
import os
import re
import subprocess
import sys
import unittest

import common

sys.path.insert(0, os.path.join(common.ROOT, "scripts"))
sys.path.insert(0, os.path.join(common.HERE, os.pardir, "report"))
import synthetic_run  # noqa: E402
from sweep_parts import progress  # noqa: E402

REPORT = os.path.join(common.ROOT, "scripts", "report.py")
FILE = """base = strip.prm
grid = "%s" : 7 9
name = h_{Notch height}
broken = --set "Model/Fails from=11" --set "Model/Fails to=13"
""" % common.HEIGHT


class Links(html.parser.HTMLParser):
    """hrefs of a page, and whether every tag is closed."""
    VOID = ("meta", "img", "br", "path", "use", "rect")

    def __init__(self, text):
        super().__init__()
        self.found, self.open = [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.found += [value for name, value in attributes if name == "href"
                       and tag == "a"]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag not in self.VOID:
            assert self.open and self.open[-1] == tag, (tag, self.open)
            self.open.pop()


class Page(common.Case):
    def page(self, *arguments):
        self.called("report", "a.sweep", "--program", common.PROGRAM, "--output", "s",
                    *arguments)
        text = self.text("s", "report.html")
        links = Links(text)
        self.assertEqual(links.open, [])
        for name in links.found:
            self.assertTrue(os.path.exists(self.path("s", name)), name)
        return text, links.found

    def test_before_during_and_after(self):
        self.write("a.sweep", FILE)
        text, links = self.page()
        self.assertIn("3 cases: 3 new", text)
        self.assertIn("http-equiv=\"refresh\"", text)
        self.assertEqual(links, [])
        self.study("run", "a.sweep", "--only", "h_7", "--output", "s")
        text, links = self.page()
        self.assertIn("3 cases: 1 complete, 2 new", text)
        self.assertIn("http-equiv=\"refresh\"", text)
        for word in ("<td>below hole</td>", "<td>80</td>", "state complete", ">h_7<",
                     "Force (N)", "data:image/png"):
            self.assertIn(word, text)
        self.study("run", "a.sweep", "--output", "s", status=1)
        text, links = self.page("--pages")
        self.assertIn("3 cases: 2 complete, 1 failed", text)
        self.assertNotIn("http-equiv=\"refresh\"", text)
        self.assertIn("the smallest step is reached", text)
        self.assertIn("pages/h_9.html", links)
        self.assertIn("sweep.csv", links)
        self.assertIn("mixed-cracks", self.text("s", "pages", "h_9.html"))
        # nothing is written into complete cases
        for name in ("h_7", "h_9"):
            self.assertNotIn("report.html", os.listdir(self.path("s", name)))

    def test_again_and_again_ends_with_the_sweep(self):
        self.write("a.sweep", FILE)
        self.study("run", "a.sweep", "--output", "s", status=1)
        output, _ = self.called("report", "a.sweep", "--program", common.PROGRAM,
                                "--output", "s", "--every", "1")
        self.assertEqual(output.count("report.html"), 1)
        self.assertIn("--every", self.refused_every("0"))

    def refused_every(self, text):
        return self.called("report", "a.sweep", "--program", common.PROGRAM, "--every",
                           text, status=2)[1]


class TimeLeft(unittest.TestCase):
    def test_formulas(self):
        left = progress.time_left
        # nothing is known
        self.assertIsNone(left([], [(3., None)], 2, 1))
        self.assertIsNone(left([], [], 2, 1))
        # three of ten seconds on average, two at a time
        self.assertEqual(left([8., 12.], [], 3, 2), 15.)
        # a run at a quarter of its load after 5 s, and two that wait
        self.assertEqual(left([], [(5., 0.25)], 2, 1), 15. + 2 * 20.)
        # others tell that runs end before their load does
        self.assertEqual(left([12.], [(5., 0.25)], 0, 1), 7.)
        # no sooner than the slowest that runs
        self.assertEqual(left([10.], [(10., 0.5), (2., None)], 0, 2), 8.)
        self.assertEqual(left([10., 10.], [], 0, 4), 0.)

    def test_words(self):
        for seconds, words in ((0.2, "1 s"), (89.4, "89 s"), (90., "2 min"),
                               (3600., "60 min"), (12000., "3 h 20 min")):
            self.assertEqual(progress.in_words(seconds), words)

    def test_lines(self):
        class OneCase:
            name, directory = "a", "nowhere"

        stream = io.StringIO()
        told = progress.Progress(2, 1, stream)
        first, second = OneCase(), OneCase()
        told.begin(first)
        self.assertIn("0 of 2 done; a; time left not known yet", told.line())
        told.done(first, 0, "", 60.)
        told.begin(second)
        self.assertRegex(told.line(), "1 of 2 done; a; about (60|59) s left")
        told.done(second, 3, "no", 1.)
        told.end()
        self.assertEqual(stream.getvalue(), "[1/2] a: exit status 0 after 60 s; about "
                         "60 s left\n[2/2] a: exit status 3 after 1 s; no\n")


class Animation(common.Case):
    def animate(self, *arguments, status=0):
        process = subprocess.run(
            [sys.executable, "-B", REPORT, self.path("run"), *arguments],
            cwd=self.directory, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            universal_newlines=True)
        if "no Python with matplotlib" in process.stderr:
            self.skipTest("no Python with matplotlib on this machine")
        self.assertNotIn("Traceback", process.stderr)
        self.assertEqual(process.returncode, status, process.stderr)
        return process

    def setUp(self):
        super().setUp()
        os.mkdir(self.path("run"))
        synthetic_run.write_run(self.path("run"))

    def test_series(self):
        self.animate("--animate", "frames")
        names = sorted(os.listdir(self.path("frames")))
        self.assertEqual(names, ["frame_%04d.png" % k for k in range(3)])
        frames, sizes = [], set()
        for name in names:
            with open(self.path("frames", name), "rb") as stream:
                frames.append(stream.read())
            sizes.add(frames[-1][16:24])  # width and height
        self.assertEqual(len(set(frames)), 3)
        self.assertEqual(len(sizes), 1)

    def test_video(self):
        process = self.animate("--animate")
        if "makes no animated WebP" in process.stderr:
            self.skipTest("PIL makes no animated WebP here")
        with open(self.path("run", "animation.webp"), "rb") as stream:
            data = stream.read()
        self.assertEqual((data[:4], data[8:12]), (b"RIFF", b"WEBP"))
        # a chunk for each frame
        self.assertEqual(len(re.findall(b"ANMF", data)), 3)
        self.assertFalse(os.path.exists(self.path("run", "report.html")))
        self.animate("--animate", "other.webp", "--frames-per-second", "20")
        self.assertTrue(os.path.exists(self.path("other.webp")))

    def test_of_a_case_of_a_sweep(self):
        os.makedirs(self.path("s", "cases"))
        os.rename(self.path("run"), self.path("s", "cases", "1a"))
        os.symlink(os.path.join("cases", "1a"), self.path("s", "soft"))
        self.write(os.path.join("s", "cases", "1a", "case.json"), "{}")
        before = sorted(os.listdir(self.path("s", "soft")))
        for arguments, name in (((), "soft.html"), (("--animate",), "soft.webp")):
            process = subprocess.run([sys.executable, "-B", REPORT,
                                      self.path("s", "soft"), *arguments],
                                     stdout=subprocess.PIPE, universal_newlines=True)
            self.assertEqual(process.returncode, 0)
            self.assertTrue(os.path.exists(self.path("s", "pages", name)))
        self.assertEqual(sorted(os.listdir(self.path("s", "soft"))), before)

    def test_what_is_wrong_is_named(self):
        self.assertIn("--frames-per-second", self.animate(
            "--animate", "--frames-per-second", "0", status=2).stderr)
        self.assertIn("--output names the page", self.animate(
            "--animate", "--output", "x", status=2).stderr)
        os.remove(self.path("run", "fields.pvd"))
        self.assertIn("holds no fields as VTU",
                      self.animate("--animate", status=1).stderr)
        self.assertFalse(os.path.exists(self.path("run", "animation.webp")))


if __name__ == "__main__":
    unittest.main()
