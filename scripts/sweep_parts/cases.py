# SPDX-License-Identifier: GPL-2.0-or-later
"""A case of a sweep: its directory cases/ID, named by what it is, and case.json in
it, which says how it came about.

case.json: id, names, base, settings, and `pieces`: a record for each start of the
program there, with host, process, job, program (path, revision, checksum), ranks,
settings, from which step it went on, and, once it has ended, exit_status, the last
step, and the reason if it did not come to its end.

States: new, running, stopped (goes on from its checkpoint, or starts again), failed,
complete, and stale: the name stands for a case of other parameters.
"""
import contextlib
import json
import os
import stat

from report_parts import safe

from . import lock, table
from .sweep_file import options_of

STATES = ("new", "running", "stopped", "failed", "stale", "complete")
RECORD = "case.json"
SCREEN = "screen.txt"
CASES = "cases"


class Case:
    """One name of a sweep; names of the same id share a directory.

    name; id; base: path of the parameter file; settings: [(entry, value)] in full;
    swept: {title: value}; output: the directory of the sweep, absolute."""

    def __init__(self, name, case_id, base, settings, swept, output):
        self.name, self.id, self.base = name, case_id, base
        self.settings, self.swept, self.output = settings, swept, output

    @property
    def options(self):
        return options_of(self.settings)

    @property
    def directory(self):
        return os.path.join(self.output, CASES, self.id)

    @property
    def link(self):
        return os.path.join(self.output, self.name)

    def path(self, *names):
        return os.path.join(self.directory, *names)

    # what is recorded

    def record(self):
        """case.json as a dictionary; empty when there is none."""
        return record_of(self.directory)

    def write_record(self, record):
        new = self.path(".%s.%d" % (RECORD, os.getpid()))
        with open(new, "w", encoding="utf-8") as stream:
            json.dump(record, stream, indent=1)
            stream.write("\n")
            stream.flush()
            os.fsync(stream.fileno())
        os.replace(new, self.path(RECORD))

    def summary(self):
        return table.summary_of(self.directory)

    def last_step(self):
        """Number of the last accepted step that is in the table; -1 without any."""
        return table.last_step(self.directory)

    def has_checkpoint(self):
        return any(os.path.isfile(self.path("checkpoint", name, "seal.txt"))
                   for name in ("generation-0", "generation-1"))

    # its state

    def lock(self, wait=0.):
        """Held by whoever advances the case. Raises lock.InUse."""
        folder = os.path.dirname(self.directory)
        os.makedirs(folder, exist_ok=True)
        return lock.Lock(folder, self.id + ".lock", wait)

    def holder(self):
        """Who advances it, in words; None when nobody does."""
        try:
            lock.require_free(os.path.dirname(self.directory), self.id + ".lock")
            lock.require_free(self.directory)
        except lock.InUse as error:
            return error.holder
        return None

    def state(self):
        """(one of STATES, why, in words)."""
        holder = self.holder()
        if holder:
            return "running", holder
        record = self.record()
        if record.get("pieces"):
            return state_of(record, self.has_checkpoint())
        old = self.linked()
        if old and old != self.id and record_of(
                os.path.join(self.output, CASES, old)).get("pieces"):
            return "stale", "what is there is of other parameters, in %s/%s" % (CASES,
                                                                               old)
        return "new", ""

    def is_complete(self):
        return self.state()[0] == "complete"

    def move_aside(self):
        """Makes room to calculate it again; what was there is kept as ID.1, ID.2."""
        if not os.path.isdir(self.directory):
            return
        with contextlib.closing(self.lock()):
            number = 1
            while os.path.exists("%s.%d" % (self.directory, number)):
                number += 1
            os.rename(self.directory, "%s.%d" % (self.directory, number))

    # its name

    def linked(self):
        """The id that the name leads to, or None."""
        try:
            folder, case_id = os.path.split(os.readlink(self.link))
        except OSError:
            return None
        return case_id if folder == CASES else None

    def make_link(self):
        """NAME -> cases/ID; whatever else has the name stays."""
        if self.linked() == self.id:
            return
        if os.path.lexists(self.link) and not os.path.islink(self.link):
            return
        new = os.path.join(self.output, ".%s.%d" % (self.name, os.getpid()))
        # in a file system without links the table has the id of each name
        with contextlib.suppress(OSError):
            os.symlink(os.path.join(CASES, self.id), new)
            os.replace(new, self.link)


def record_of(directory):
    record = safe.read_json(os.path.join(directory, RECORD))
    return record if isinstance(record, dict) \
        and isinstance(record.get("pieces", []), list) else {}


def state_of(record, has_checkpoint):
    """(state, why) of a case.json of which nobody advances the case."""
    if record.get("complete"):
        return "complete", ""
    piece = record["pieces"][-1]
    onward = "goes on from its checkpoint" if has_checkpoint else "starts again"
    if "exit_status" not in piece:
        return "stopped", "was killed; " + onward
    reason = str(piece.get("reason", ""))
    if piece["exit_status"] in (5, 6) and not piece.get("given_up"):
        return "stopped", reason or onward
    return "failed", reason or "exit status %s" % piece["exit_status"]


def each_path(directory):
    yield directory
    for parent, folders, files in os.walk(directory):
        for name in folders + files:
            path = os.path.join(parent, name)
            if not os.path.islink(path):
                yield path


def make_read_only(directory):
    if not os.stat(directory).st_mode & 0o222:
        return
    # the directory itself last: it says that all of it has been done
    for path in reversed(list(each_path(directory))):
        mode = os.stat(path).st_mode
        if mode & 0o222:
            os.chmod(path, stat.S_IMODE(mode) & ~0o222)


def make_writable(directory):
    """For its owner; parents first, for a folder has to be entered."""
    for path in each_path(directory):
        os.chmod(path, stat.S_IMODE(os.stat(path).st_mode) | stat.S_IWUSR)
