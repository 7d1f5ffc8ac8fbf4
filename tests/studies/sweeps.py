# SPDX-License-Identifier: GPL-2.0-or-later
"""What the tests of studies share: a sweep in a directory of its own, and commands of
scripts/sweep.py on it."""
import csv
import json
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SWEEP = ROOT / "scripts" / "sweep.py"
FAKE = ROOT / "tests" / "sweep" / "fake_program.py"
WAIT = 400.  # s, when the machine is busy
SKIPPED = 77  # the exit status of a test that cannot be made here


class Sweep:
    """text: of the sweep file; base: of the parameter file, made in the folder."""

    def __init__(self, folder, text, base="Model/Law = a\n", program=FAKE,
                 launcher=""):
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.file, self.output = self.folder / "a.sweep", self.folder / "out"
        self.program, self.launcher = program, launcher
        if program == FAKE:
            self.program = fake_program(self.folder)
        self.base = self.folder / "base.prm"
        self.base.write_text(base)
        self.file.write_text(text)

    def words(self, command, *options):
        words = [sys.executable, "-B", str(SWEEP), command, str(self.file),
                 *map(str, options), "--output", str(self.output),
                 "--program", str(self.program)]
        if command in ("run", "submit", "task") and self.launcher is not None:
            words += ["--launcher", self.launcher]
        return words

    def call(self, command, *options, status=0):
        """What it says on both streams; its exit status has to be that one, or any
        for None."""
        return self.said(self.words(command, *options), command, status)

    def call_with(self, command, *extra, status=0):
        """The same with words after --."""
        return self.said(self.words(command) + list(extra), command, status)

    @staticmethod
    def said(words, command, status):
        process = subprocess.run(words, text=True,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, check=False)
        assert status in (None, process.returncode), (command, process.returncode,
                                                      process.stdout)
        assert "Traceback" not in process.stdout, process.stdout
        return process.stdout

    def submit(self, *options):
        """(id of the array, what was said)."""
        text = self.call("submit", *options)
        return text.rpartition(": job ")[0].rpartition("cases: job ")[2].split(",")[0] \
            .split(";")[0], text

    def record(self, name):
        """case.json of a name; empty without one."""
        try:
            return json.loads((self.output / name / "case.json").read_text())
        except OSError:
            return {}

    def states(self):
        """{name: state}, as plan has them."""
        lines = [line.split() for line in self.call("plan").splitlines()]
        return {words[0]: words[2] for words in lines
                if len(words) > 2 and words[2] in ("new", "running", "stopped", "failed",
                                                   "stale", "complete")}

    def table(self):
        with open(self.output / "sweep.csv", encoding="utf-8", newline="") as stream:
            return {row["name"]: row for row in csv.DictReader(stream)}

    def events(self):
        """[(time, id, process, word, step)] of the program that is none."""
        try:
            lines = (self.output / "cases" / "events.txt").read_text().splitlines()
        except OSError:
            return []
        found = [line.split() for line in lines]
        return [(float(words[0]), words[1], int(words[2]), words[3], int(words[4]))
                for words in found if len(words) == 5]

    def events_of(self, name):
        """[(word, step)] of a case, in order."""
        case_id = self.record(name)["id"]
        return [event[3:] for event in self.events() if event[1] == case_id]

    def wait_for(self, condition, what):
        deadline = time.monotonic() + WAIT
        while not condition():
            assert time.monotonic() < deadline, "waited in vain: %s\n%s" % (
                what, self.call("status", status=None))
            time.sleep(0.2)

    def wait_for_step(self, step, number=1):
        """Of so many cases."""
        self.wait_for(lambda: len({event[1] for event in self.events() if event[3]
                                   == "step" and event[4] >= step}) >= number,
                      "step %d" % step)

    @property
    def gate(self):
        """A file that programs may be told to wait for."""
        return self.folder / "gate"


def fake_program(folder):
    """The program that is none, started without a search for an interpreter, which
    takes longer than all it does."""
    path = folder / "mixed-cracks"
    path.write_text("#!%s -B\nimport runpy\nrunpy.run_path(%r, run_name='__main__')\n"
                    % (sys.executable, str(FAKE)))
    path.chmod(0o755)
    return path


def overlaps(events):
    """[(id, process, process)] of cases that two processes have advanced at a time:
    what one has written between two words of another."""
    found, last = [], {}
    spans = {}
    for moment, case, process, word, _ in events:
        if word != "refused":
            first, _ = spans.get((case, process), (moment, moment))
            spans[case, process] = first, moment
    for (case, process), (first, end) in sorted(spans.items(), key=lambda item: item[1]):
        if case in last and first < last[case][1]:
            found.append((case, last[case][0], process))
        if case not in last or end > last[case][1]:
            last[case] = process, end
    return found
