#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py bisect by jobs of a real Slurm. Exit status 77 where it is not installed."""
import pathlib
import sys
import tempfile
import unittest

import common
import slurm


class ByJobs(common.Case):
    @classmethod
    def setUpClass(cls):
        # short, for the sockets of Slurm have short names
        cls.folder = tempfile.TemporaryDirectory(prefix="mc")
        cls.cluster = slurm.Cluster(pathlib.Path(cls.folder.name), cpus=4)

    @classmethod
    def tearDownClass(cls):
        cls.cluster.stop()
        cls.folder.cleanup()

    def bisect(self, *more, status=0):
        return self.study("bisect", "a.sweep", "--vary", common.HEIGHT, "6", "10",
                          "--on", "outcome", "--to", "1", "--submit", "--output", "b",
                          *more, status=status)

    def test_rounds_of_jobs(self):
        self.write("a.sweep", "base = strip.prm\na =\n")
        # two rounds by hand: the ends, then the middle
        errors = self.bisect("--no-wait", status=5)[1]
        self.assertIn("submitted", errors)
        self.cluster.wait_until_empty(120.)
        self.assertEqual(sorted(self.starts()), [6., 10.])
        self.bisect("--no-wait", status=5)
        self.cluster.wait_until_empty(120.)
        self.assertEqual(sorted(self.starts()), [6., 8., 10.])
        # the rest in one call, which waits for its jobs
        output, _ = self.bisect()
        self.assertIn("a: 'below hole' up to 7, 'through hole' from 8 on", output)
        self.assertEqual(sorted(self.starts()), [6., 7., 8., 10.])
        row = self.table("b", "bisect.csv")[0]
        self.assertEqual((row["low_case"], row["high_case"]), ("a_7", "a_8"))
        jobs = {row["name"]: row["job"] for row in self.table("b", "sweep.csv")}
        self.assertEqual(len(set(jobs.values())), 4)
        self.assertTrue(all(jobs.values()))


if __name__ == "__main__":
    if slurm.missing():
        print("skipped: not installed: " + ", ".join(slurm.missing()))
        sys.exit(77)
    unittest.main()
