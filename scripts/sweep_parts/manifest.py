# SPDX-License-Identifier: GPL-2.0-or-later
"""What has been submitted, frozen: OUTPUT/submissions/TOKEN/manifest.json with the
cases by name, their ids and settings, and which of them a task of an array has.
Lines that are added to the sweep file later change nothing in it."""
import contextlib
import glob
import json
import os

from report_parts import safe

from .cases import Case
from .errors import SweepError

FOLDER = "submissions"
FILE = "manifest.json"


class Manifest:
    """groups: [[name]] in the order of the tasks; arrays: [{"job_name", "first",
    "count", "job"}], parts of the groups; launcher, ranks, program: of all."""

    def __init__(self, content):
        self.content = content
        self.output, self.groups = content["output"], content["groups"]
        self.cases = {entry["name"]: Case(
            entry["name"], entry["id"], entry["base"],
            [tuple(pair) for pair in entry["settings"]], entry["swept"], self.output)
            for entry in content["cases"]}

    @property
    def folder(self):
        return os.path.join(self.output, FOLDER, self.content["token"])

    @property
    def path(self):
        return os.path.join(self.folder, FILE)

    def write(self):
        os.makedirs(self.folder, exist_ok=True)
        safe.write_whole(self.path, json.dumps(self.content, indent=1) + "\n")

    def group(self, number):
        if not 0 <= number < len(self.groups):
            raise SweepError("--group: %d is not below %d" % (number, len(self.groups)))
        return self.groups[number]

    def names_of(self, job_name, index):
        """The cases of a task of the queue; none when it is of another array."""
        return next((self.groups[array["first"] + index]
                     for array in self.content["arrays"]
                     if array["job_name"] == job_name and 0 <= index < array["count"]), [])


def frozen(study, chosen, groups, arrays, token, launcher, ranks):
    """A Manifest of cases of a Study."""
    return Manifest({
        "format": 1, "token": token, "sweep": os.path.abspath(study.sweep.path),
        "output": study.output, "program": study.program.path,
        "revision": study.program.revision, "checksum": study.program.checksum,
        "launcher": launcher, "ranks": ranks,
        "groups": groups, "arrays": arrays,
        "cases": [{"name": case.name, "id": case.id, "base": case.base,
                   "settings": case.settings, "swept": case.swept} for case in chosen]})


def read(path):
    """Raises SweepError."""
    try:
        return Manifest(safe.read_json(path))
    except (ValueError, KeyError, TypeError):
        raise SweepError("%s is no manifest of a submission" % path)


def all_of(output):
    """[Manifest] of a directory of a sweep, oldest first; damaged ones are left out."""
    found = []
    for path in glob.glob(os.path.join(glob.escape(output), FOLDER, "*", FILE)):
        with contextlib.suppress(SweepError, OSError):
            found.append((os.path.getmtime(path), path, read(path)))
    return [manifest for _, _, manifest in sorted(found, key=lambda item: item[:2])]
