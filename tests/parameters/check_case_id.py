#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The id of a case: the same for the same problem, another one for another.

    check_case_id.py EXECUTABLE MPIRUN [--update]

case_id_defaults.json beside this file has all defaults that ids rest on, and the ids
of the good file of tests/bad_input. A default that has changed, or an id, needs
another schema: a higher number in case_id_schema() of source/input/case_id.cc, then
--update, which refuses without it. New entries only need --update.
"""
import json
import os
import pathlib
import re
import resource
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parent / "bad_input")]
from bad_inputs import BASE  # noqa: E402
from program import Program, runner  # noqa: E402

DEFAULTS = HERE / "case_id_defaults.json"
PROGRAM = []
SQUARE = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
4
1 0 0 0
2 1 0 0
3 1 %s 0
4 0 %s 0
$EndNodes
$Elements
3
1 1 2 1 1 1 2
2 1 2 2 2 3 4
3 3 2 1 1 1 2 3 4
$EndElements
"""


def answer(*words, folder=None, ranks=1, anew=False):
    starts = Program(*PROGRAM, ranks) if anew else runner(*PROGRAM, ranks)
    status, output, errors = starts.run(words, folder)
    assert (status, errors) == (0, ""), (words, status, output, errors)
    return output


def present():
    """What case_id_defaults.json holds, as the program has it now."""
    entries = json.loads(answer("--parameters", "json", anew=True))
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "case.prm").write_text(BASE, encoding="utf-8")
        ids = {scope: answer("--case-id=" + scope, "case.prm", folder=folder).strip()
               for scope in ("problem", "full")}
    return {"ids": ids,
            "defaults": {entry["full_name"]: entry["default_value"]
                         for entry in entries if entry["subsections"][0] != "Output"}}


def changed_defaults(before, now):
    return [name for name, value in before["defaults"].items()
            if now["defaults"].get(name) != value]


def update():
    now = present()
    if DEFAULTS.exists():
        before = json.loads(DEFAULTS.read_text(encoding="utf-8"))
        changed = changed_defaults(before, now)
        if changed and before["ids"] == now["ids"]:
            sys.exit("raise case_id_schema(): other defaults for " + ", ".join(changed))
    DEFAULTS.write_text(json.dumps(now, indent=1) + "\n", encoding="utf-8")


class CaseId(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("case.prm", BASE)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def id(self, *settings, case="case.prm", scope="problem", **how):
        words = [word for setting in settings for word in ("--set", setting)]
        text = answer("--case-id=" + scope, *words, case, folder=self.folder, **how)
        self.assertRegex(text, r"\A[0-9a-f]{16}\n\Z")
        return text.strip()

    def test_defaults_and_schema(self):
        before = json.loads(DEFAULTS.read_text(encoding="utf-8"))
        now = present()
        self.assertEqual(changed_defaults(before, now), [], __doc__)
        self.assertEqual(before, now, __doc__)

    def test_spelling_does_not_matter(self):
        respelled = BASE.replace("= 17", "=   17.0  # N/mm").replace(
            "= 2*h", "= 2.0 * h").replace("= 10", "= 1.e1").replace(
                "set Cell size = 3", "set Cell size = +3.00\n    set Width = 20")
        parts = re.findall(r"^subsection.*?^end\n", respelled, re.M | re.S)
        self.assertEqual(len(parts), 6)
        self.write("other.prm", "# the same\n\n" + "".join(reversed(parts)))
        self.assertEqual(self.id(), self.id(case="other.prm"))
        self.assertEqual(self.id("Initial cracks/Broken slits=false"),
                         self.id("Initial cracks/Broken slits=" + self.no()))
        self.assertEqual(self.id("Geometry/Punctured strip/Hole center=10,18"),
                         self.id("Geometry/Punctured strip/Hole center=10.0 , 1.8e1"))

    def no(self):
        """Another word for false, where the program takes it."""
        status, _, _ = runner(*PROGRAM, 1).run(
            ["--case-id", "--set", "Initial cracks/Broken slits=no", "case.prm"],
            self.folder)
        return "no" if status == 0 else "false"

    def test_defaults_do_not_matter_derived_ones_are_resolved(self):
        self.assertEqual(self.id(), self.id(
            "Model/Residual stiffness=1e-3", "Model/Displacement degree=2",
            "Model/Deviator dimension=2", "Load stepping/Force boundary=",
            "Geometry/Slit square/Cell size=0.125"))
        self.assertNotEqual(self.id(), self.id("Load stepping/Force boundary=bottom"))
        self.assertEqual(self.id("Load stepping/Onset step=0", scope="full"),
                         self.id("Load stepping/Onset step=0.05", scope="full"))

    def test_another_problem_has_another_id(self):
        ids = {self.id()}
        for setting in ("Geometry/Punctured strip/Notch height=14",
                        "Material/Shear modulus=2.41", "Model/Length scale=2.5*h",
                        "Initial cracks/Broken slits=false", "Geometry/Name=rectangle"):
            ids.add(self.id(setting))
        self.assertEqual(len(ids), 6)

    def test_what_may_change_on_resume(self):
        for setting, counts in (("Load stepping/End time=0.9", True),
                                ("Model/Coupling tolerance=2e-4", True),
                                ("Linear solver/Newton tolerance=1e-7", True),
                                ("Output/Directory=elsewhere", False),
                                ("Output/Displacement at points=tip : 0, 1", False),
                                ("Output/Wall time limit=3600", False)):
            with self.subTest(setting):
                self.assertEqual(self.id(), self.id(setting))
                self.assertEqual(self.id(scope="full") != self.id(setting, scope="full"),
                                 counts)

    def test_included_files_count_by_their_entries(self):
        head, tail = BASE.split("subsection Material")
        self.write("parts/one.prm", "# a comment\nsubsection Material" + tail)
        self.write("other.prm", head + "include parts/one.prm\n")
        self.assertEqual(self.id(), self.id(case="other.prm"))
        self.write("parts/one.prm", "subsection Material" + tail.replace("17", "18"))
        self.assertNotEqual(self.id(), self.id(case="other.prm"))

    def test_meshes_and_maps_count_by_what_they_hold(self):
        square = SQUARE % (1, 1)
        for name, text in (("a.msh", square), ("folder/b.msh", square),
                           ("c.msh", SQUARE % ("1.5", "1.5")),
                           ("a.csv", "0,0,1\n1,1,2\n"),
                           ("folder/a.csv", "0,0,1\n1,1,2\n"),
                           ("b.csv", "0,0,1\n1,1,3\n")):
            self.write(name, text)
        mesh = ["Geometry/Name=mesh file",
                "Geometry/Mesh file/Boundary names=1 = bottom ; 2 = top"]
        for entry, names, more in (
                ("Geometry/Mesh file/File name", ("a.msh", "folder/b.msh", "c.msh"),
                 mesh),
                ("Material/Map/File name", ("a.csv", "folder/a.csv", "b.csv"),
                 ["Material/Critical energy release rate=17*map"])):
            with self.subTest(entry):
                first, same, other = (self.id(*more, entry + "=" + name)
                                      for name in names)
                self.assertEqual(first, same)
                self.assertNotEqual(first, other)
        # one that is not used is not read
        self.assertEqual(self.id(), self.id("Geometry/Mesh file/File name=none.msh"))

    def test_wrong_input(self):
        for words, status, says in (
                (["--set", "Material/Shear modulus=-1"], 2, "Material/Shear modulus"),
                (["--set", "Material/Sheer modulus=1"], 2, "Shear modulus"),
                (["--set", "Material/Map/File name=none.csv", "--set",
                  "Material/Critical energy release rate=17*map"], 4, "none.csv"),
                (["--set", "Geometry/Name=mesh file", "--set",
                  "Geometry/Mesh file/File name=none.msh", "--set",
                  "Geometry/Mesh file/Boundary names=1 = bottom ; 2 = top"], 4,
                 "none.msh")):
            with self.subTest(says):
                found, output, errors = runner(*PROGRAM, 1).run(
                    ["--case-id", *words, "case.prm"], self.folder)
                self.assertEqual((found, output), (status, ""), errors)
                self.assertEqual(errors.count("mixed-cracks: error: "), 1)
                self.assertIn(says, errors)

    def test_at_once_without_a_mesh_and_files(self):
        def seconds():
            usage = resource.getrusage(resource.RUSAGE_CHILDREN)
            return usage.ru_utime + usage.ru_stime
        begin = seconds()
        large = self.id("Mesh/Global refinements=12", anew=True)
        self.assertLess(seconds() - begin, 3.)  # a mesh would take the memory
        self.assertEqual(os.listdir(self.folder), ["case.prm"])
        self.assertNotEqual(large, self.id())

    def test_on_two_ranks_one_line(self):
        self.assertEqual(self.id(), self.id(ranks=2))

    def test_space(self):
        flat = ["Geometry/Dimension=3", "Material/Thickness=2"]
        self.assertNotEqual(self.id(*flat), self.id(flat[1]))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    PROGRAM = sys.argv[1:3]
    if sys.argv[3:] == ["--update"]:
        update()
    else:
        unittest.main(argv=sys.argv[:1] + sys.argv[3:])
