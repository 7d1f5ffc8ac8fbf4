# SPDX-License-Identifier: GPL-2.0-or-later
"""A sweep file together with a program and a directory: its cases. What all commands
of scripts/sweep.py begin with.

    study = Study("strips.sweep")            the cases of the file, with their ids
    study.cases["h_6"].state()               ("complete", "")
    study.case("extra", settings, swept)     one that is not in the file
"""
import contextlib
import fnmatch
import hashlib
import json
import os
from concurrent.futures import ThreadPoolExecutor

from report_parts import safe

from . import lock
from .cases import Case
from .errors import SweepError
from .program import Program
from .sweep_file import Sweep, merged, options_of, require_allowed, split_settings

AT_ONCE = 4  # questions to the program
OWNER = "sweep.json"


class Study:
    """sweep; program; output: directory, absolute; cases: {name: Case}, in order of
    the file. extra: words after -- on the command line. Raises SweepError."""

    def __init__(self, path, output=None, program=None, extra=()):
        self.sweep = Sweep(path)
        require_allowed(extra)
        self.extra = list(extra)
        if output is None:
            output = os.path.join("results", os.path.splitext(
                os.path.basename(path))[0])
        self.output = os.path.abspath(output)
        self.program = program if isinstance(program, Program) else Program(program)
        # what goes on from a checkpoint keeps its id
        own, others = split_settings(extra)
        self.telling = [] if "--resume" in others else [entry for entry, _ in own]
        self.require_owner()
        self.left_out = None
        self.cases = self.identified()

    def identified(self):
        wanted = [(name, self.sweep.settings(name, self.extra))
                  for name in self.sweep.runs]
        with ThreadPoolExecutor(AT_ONCE) as pool:
            ids = list(pool.map(lambda pair: self.asked(*pair), wanted))
        own = {name: [entry for entry, _ in self.sweep.runs[name].settings]
               + self.telling for name in self.sweep.runs}
        self.left_out = self.entries_left_out(dict(wanted), dict(
            (name, found) for (name, _), found in zip(wanted, ids)), own)
        return {name: Case(name, found + self.suffix(settings, own[name]),
                           self.sweep.base, settings, self.sweep.runs[name].swept,
                           self.output)
                for (name, settings), found in zip(wanted, ids)}

    def asked(self, name, settings):
        try:
            return self.program.case_id(self.sweep.base, options_of(settings))
        except SweepError as error:
            raise SweepError("%s: %s" % (name, error))

    def entries_left_out(self, settings, ids, own):
        """Entries of the runs' own that do not count in the id of the program, as
        those which may change when a run goes on: where a sweep is about them, cases
        are told apart by them. Asked by giving each entry another of its values."""
        left_out = set()
        for entry in {entry for entries in own.values() for entry in entries}:
            name = next(name for name in own if entry in own[name])
            mine = dict(settings[name])
            others = {canonical(dict(other)[entry]): dict(other)[entry]
                      for other in settings.values() if entry in dict(other)}
            others.pop(canonical(mine[entry]), None)
            if others:
                mine[entry] = next(iter(others.values()))
            else:
                del mine[entry]
            with contextlib.suppress(SweepError):  # then it counts
                if self.asked(name, list(mine.items())) == ids[name]:
                    left_out.add(entry)
        return left_out

    def suffix(self, settings, own):
        """What is added to the id of the program."""
        counted = ["%s=%s" % (entry, canonical(value)) for entry, value
                   in sorted(settings) if entry in own and entry in self.left_out]
        if not counted:
            return ""
        return "-" + hashlib.sha256("\n".join(counted).encode()).hexdigest()[:8]

    def case(self, name, settings, swept=None):
        """One more case, that is not in the file: base and common with these
        settings, [(entry, value)]. Entries of its own that do not count in the id of
        the program tell it apart."""
        full = merged(self.sweep.common + list(settings)
                      + split_settings(self.extra)[0])
        own = [entry for entry, _ in settings] + self.telling
        found = self.asked(name, full)
        for entry in own:
            without = [pair for pair in full if pair[0] != entry]
            with contextlib.suppress(SweepError):
                if self.asked(name, without) == found:
                    self.left_out.add(entry)
        return Case(name, found + self.suffix(full, own), self.sweep.base, full,
                    dict(settings) if swept is None else swept, self.output)

    def chosen(self, patterns=None):
        """[Case] whose names match one of the patterns; all of them for None."""
        for pattern in patterns or ():
            if not fnmatch.filter(self.cases, pattern):
                raise SweepError("--only: there is no run '%s' in %s; there are %s"
                                 % (pattern, self.sweep.path, ", ".join(self.cases)))
        return [case for name, case in self.cases.items() if patterns is None or
                any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)]

    # the directory

    def owner(self):
        """Path of the sweep file whose directory it is, or None."""
        text = safe.read_text(os.path.join(self.output, OWNER))
        try:
            path = json.loads(text or "")["file"]
        except (ValueError, KeyError, TypeError):
            return None
        return path if isinstance(path, str) and os.path.exists(path) else None

    def require_owner(self):
        """One sweep file has a directory, for names and table are its own."""
        owner, mine = self.owner(), os.path.realpath(self.sweep.path)
        if owner and os.path.realpath(owner) != mine:
            raise SweepError("'%s' holds the sweep of '%s'; choose another directory "
                             "with --output" % (self.output, owner))
        for name in self.sweep.runs:
            path = os.path.join(self.output, name)
            if os.path.isdir(path) and not os.path.islink(path):
                raise SweepError("'%s' is no link: it is of another program, or of an "
                                 "earlier version of this one; choose another directory "
                                 "with --output, or move it away" % path)

    def claim(self):
        """Makes the directory, as that of this sweep file; returns its lock, held.
        Raises lock.InUse and OSError."""
        os.makedirs(self.output, exist_ok=True)
        held = lock.Lock(self.output)
        try:
            self.require_owner()  # somebody may have been faster
            self.note_owner()
        except BaseException:
            held.release()
            raise
        return held

    def note_owner(self):
        path = os.path.join(self.output, OWNER)
        new = "%s.%d" % (path, os.getpid())
        with open(new, "w", encoding="utf-8") as stream:
            json.dump({"file": os.path.abspath(self.sweep.path)}, stream)
            stream.write("\n")
        os.replace(new, path)


def canonical(value):
    """One text for 6, 6.0 and 6e0."""
    try:
        return "%.17g" % float(value)
    except ValueError:
        return " ".join(value.split())
