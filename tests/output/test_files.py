#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A run removes what it has made itself, or what the run before it has recorded,
and nothing else; a refused one changes nothing at all.

usage: test_files.py EXECUTABLE MPIRUN
"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import small_runs
from small_runs import content, table_of, text_of, write

PROGRAM = []
INFINITE = "Boundary conditions/Traction=right : x : 1/t"
BAD_MESH = "Geometry/Mesh file/File name=bad.msh"
OF_THE_USER = ("fields/important.dat", "crack_path/mine.txt", "report.html",
               "checkpoint/notes.txt", "notes.txt")


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        small_runs.prepare(self.folder)
        write(self.folder, "bad.msh", small_runs.mesh()[:900])

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def run_case(self, *options, **more):
        return small_runs.run(PROGRAM, self.folder, *options, **more)

    def unchanged(self, *options, **more):
        """What a run says that leaves everything as it was."""
        before = content(self.folder)
        out = self.run_case(*options, **more)
        after = content(self.folder)
        self.assertEqual(sorted(after), sorted(before))
        for name, data in before.items():
            self.assertEqual(after[name], data, name)
        return out

    def limited(self, kilobytes, *options):
        """A run whose files may not be larger, without mpirun: that has larger
        ones of its own. What it says; its exit status has to be 4."""
        result = subprocess.run(
            ["bash", "-c", 'ulimit -f %d; exec "$@"' % kilobytes, "bash",
             PROGRAM[0], "case.prm", *options], cwd=self.folder, timeout=240,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(result.returncode, 4, result.stdout)
        self.assertEqual(result.stdout.count("mixed-cracks: error:"), 1)
        return result.stdout

    def test_run_that_cannot_begin_leaves_the_old_one(self):
        self.run_case("--output", "old")
        before = content(self.folder)
        for kilobytes in (0, 3, 20):  # parameters.prm has 30
            self.limited(kilobytes, "--output", "old", "--overwrite")
            self.assertEqual(content(self.folder), before)
            self.limited(kilobytes, "--output", "new/folder")
            self.assertEqual(content(self.folder), before)

    def test_folder_in_the_place_of_a_file_is_in_the_way(self):
        self.run_case("--output", "old")
        os.rename(self.path("old", "parameters.prm"), self.path("old", "p.prm"))
        write(self.path("old"), "parameters.prm/notes.txt")
        self.assertIn("'parameters.prm'", self.unchanged(
            "--output", "old", "--overwrite", status=4))

    def test_checkpoint_that_no_run_has_written_is_in_the_way(self):
        name = "checkpoint/generation-0/record.txt"
        write(self.path("mine"), name)
        for options in ((), ("--overwrite",)):
            out = self.unchanged("--output", "mine", *options, status=4)
            self.assertIn("'%s'" % name, out)
        # what a run does not write there stays, while it writes and afterwards
        notes = self.path("run", "checkpoint", "generation-0")
        write(notes, "notes.txt")
        for options in ((), ("--overwrite",)):
            self.run_case("--output", "run", *options)
            self.assertEqual(text_of(notes, "notes.txt"), "of the user\n")
            self.assertIn("seal.txt", os.listdir(notes))

    def test_list_has_every_name_once(self):
        self.run_case("--output", "run")
        listed = text_of(self.path("run"), "run_files.txt")
        for _ in range(2):  # it has ended: nothing is calculated
            self.run_case("--output", "run", "--resume")
            self.assertEqual(text_of(self.path("run"), "run_files.txt"), listed)
        self.run_case("--output", "run", "--resume",
                      settings=["Load stepping/End time=1.5"])
        lines = text_of(self.path("run"), "run_files.txt").splitlines()
        self.assertEqual(len(lines), len(set(lines)), lines)

    def test_refused_run_leaves_files_of_the_user(self):
        for name in OF_THE_USER:
            write(self.folder, name)
        for ranks in (1, 2):
            out = self.unchanged("--output", ".", settings=[INFINITE], ranks=ranks,
                                 status=2)
            self.assertIn("Boundary conditions/Traction", out)
        self.unchanged("--output", ".", settings=[BAD_MESH], status=2)
        self.unchanged("--output", "new/folder", settings=[INFINITE], status=2)

    def test_refused_resume_leaves_the_checkpoint(self):
        self.run_case("--output", "first")
        os.mkdir(self.path("second"))
        shutil.copytree(self.path("first", "checkpoint"),
                        self.path("second", "checkpoint"))
        self.unchanged("--resume", "--output", "second", status=2,
                       settings=["Material/Thickness=3"])
        out = self.unchanged("--output", "second", status=4)
        self.assertIn("already holds a run", out)
        # it is as good as before, with the paths of the cracks
        self.run_case("--resume", "--output", "second", ranks=2,
                      settings=["Load stepping/End time=1.5"])
        paths = text_of(self.path("first"), "crack_path.csv").split("#")[0]
        self.assertTrue(text_of(self.path("second"), "crack_path.csv")
                        .startswith(paths))

    def test_refused_overwrite_leaves_the_old_run(self):
        self.run_case("--output", "old")
        for name in OF_THE_USER:
            write(self.path("old"), name)
        for setting in (INFINITE, BAD_MESH, "Initial cracks/Phase field=1/(x-x)"):
            self.unchanged("--overwrite", "--output", "old", settings=[setting],
                           status=2)

    def test_overwriting_removes_what_was_recorded(self):
        self.run_case("--output", "old", ranks=2,
                      settings=["Output/Field format=both"])
        for name in OF_THE_USER + ("fields/fields_00099.0.vtu",):
            write(self.path("old"), name)
        self.run_case("--overwrite", "--output", "old", settings=[
            "Output/Field format=none", "Output/Crack opening=",
            "Load stepping/End time=0.5"])
        left = content(self.path("old"))
        for name in OF_THE_USER + ("fields/fields_00099.0.vtu",):
            self.assertEqual(left[name], b"of the user\n", name)
        self.assertEqual([name for name in sorted(left) if name.startswith("fields")],
                         ["fields", "fields/fields_00099.0.vtu",
                          "fields/important.dat"])
        self.assertNotIn("crack_opening.csv", left)
        self.assertEqual(len(table_of(self.path("old"), "statistics.csv")), 2)

    def test_all_that_a_run_leaves_is_recorded(self):
        for ranks in (1, 2):
            self.run_case("--overwrite", "--output", "run", ranks=ranks,
                          settings=["Output/Field format=both"])
            listed = text_of(self.path("run"), "run_files.txt").splitlines()
            left = [name + ("/" if data is None else "")
                    for name, data in content(self.path("run")).items()
                    if name not in ("run_files.txt", ".lock")
                    and not name.startswith("checkpoint/generation")]
            self.assertEqual(sorted(set(left) - set(listed)), [])

    def test_files_that_nobody_recorded_are_in_the_way(self):
        for name, options in (("crack_path.csv", ()), ("log.txt", ("--overwrite",)),
                              ("run_files.txt", ()),
                              ("fields/fields_00003.0.vtu", ())):
            folder = os.path.join("holds", os.path.basename(name))
            write(self.path(folder), name)
            out = self.unchanged("--output", folder, *options, status=4)
            self.assertIn("'%s'" % name, out)
        # what the run does not write is not
        write(self.path("other"), "crack_opening.csv")
        self.run_case("--output", "other", settings=["Output/Crack opening="])
        self.assertEqual(text_of(self.path("other"), "crack_opening.csv"),
                         "of the user\n")

    def test_run_without_a_list_is_known_by_its_names(self):
        # programs that wrote no list had no such profiles
        self.run_case("--output", "old", settings=["Output/Traction profiles="])
        os.remove(self.path("old", "run_files.txt"))
        for name in OF_THE_USER:
            write(self.path("old"), name)
        self.run_case("--overwrite", "--output", "old", settings=[
            "Output/Field format=none", "Load stepping/End time=0.5"])
        left = content(self.path("old"))
        for name in OF_THE_USER:
            self.assertEqual(left[name], b"of the user\n", name)
        self.assertEqual([name for name in sorted(left) if name.startswith("fields")],
                         ["fields", "fields/important.dat"])

    def test_initial_state_that_cannot_be_calculated_replaces_the_old_run(self):
        self.run_case("--output", "old")
        self.run_case("--overwrite", "--output", "old", status=3, settings=[
            "Model/Largest number of coupling iterations=1"])
        self.assertEqual(table_of(self.path("old"), "statistics.csv"), [])


if __name__ == "__main__":
    PROGRAM = [os.path.abspath(sys.argv[1])] + sys.argv[2:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
