# SPDX-License-Identifier: GPL-2.0-or-later
"""A sweep file together with a program and a directory: its cases. What all commands
of scripts/sweep.py begin with.

    study = Study("strips.sweep")            the cases of the file, with their ids
    study.cases["h_6"].state()               ("complete", "")
"""
import hashlib
import itertools
import json
import os
import pathlib
import sys
from concurrent.futures import ThreadPoolExecutor

from report_parts import safe

from . import id_cache, lock
from .cases import Case
from .errors import SweepError
from .program import Program
from .sweep_file import Sweep, matching, options_of, require_allowed, split_settings

AT_ONCE = 4  # questions to the program
OWNER = "sweep.json"


class Study:
    """sweep; program; output: directory, absolute; cases: {name: Case}, in order of
    the file. extra: words after -- on the command line; names: of these cases only,
    for to ask for an id takes a moment. Raises SweepError."""

    def __init__(self, path, output=None, program=None, extra=(), names=None):
        self.sweep = Sweep(path)
        require_allowed(extra)
        self.extra = list(extra)
        self.output = os.path.abspath(
            os.path.join("results", pathlib.Path(path).stem) if output is None else output)
        self.program = program if isinstance(program, Program) else Program(program)
        # what goes on from a checkpoint keeps its id
        own, others = split_settings(extra)
        self.telling = [] if "--resume" in others else [entry for entry, _ in own]
        self.require_owner()
        self.ids = id_cache.IdCache(self.output, self.program, self.sweep.base)
        self.left_out = set()
        self.cases = self.identified(list(self.sweep.runs) if names is None else names)
        self.ids.write()

    def identified(self, names):
        for name in names:
            if name not in self.sweep.runs:
                raise SweepError("there is no run '%s' in %s; there are %s" % (
                    name, self.sweep.path, ", ".join(self.sweep.runs)))
        settings = {name: self.sweep.settings(name, self.extra)
                    for name in self.sweep.runs}
        own = {name: [entry for entry, _ in self.sweep.runs[name].settings]
               + self.telling for name in self.sweep.runs}
        with ThreadPoolExecutor(AT_ONCE) as pool:
            ids = list(pool.map(lambda name: self.asked(name, settings[name]), names))
            telling = list(dict.fromkeys(entry for name in names for entry in own[name]))
            self.left_out = set(itertools.compress(telling, pool.map(
                lambda entry: self.is_left_out(entry, settings, own), telling)))
            suffixes = list(pool.map(
                lambda name: self.suffix(name, settings[name], own[name]), names))
        return {name: Case(name, found + suffix, self.sweep.base, settings[name],
                           self.sweep.runs[name].swept, self.output)
                for name, found, suffix in zip(names, ids, suffixes)}

    def asked(self, name, settings, full=False):
        """The id that the program has for settings; full: all but output counts."""
        words = options_of(sorted(settings))
        try:
            return self.ids.asked(words + ["full"] * full, lambda: self.program.case_id(
                self.sweep.base, words, full))
        except SweepError as error:
            raise SweepError("%s: %s" % (name, error))

    def is_left_out(self, entry, settings, own):
        """Whether an entry of the runs' own does not count in the id of the program,
        as those do not which may change when a run goes on: where a sweep is about
        them, cases are told apart by them. Asked by giving the entry another of its
        values, or none."""
        name = next(name for name in own if entry in own[name])
        mine = dict(settings[name])
        values = {canonical(value): value for other in settings.values()
                  for key, value in other if key == entry}
        own_id = self.asked(name, list(mine.items()))
        values.pop(canonical(mine[entry]))
        del mine[entry]
        if values:
            mine[entry] = next(iter(values.values()))
        try:
            return self.asked(name, list(mine.items())) == own_id
        except SweepError:  # it matters, then
            return False

    def suffix(self, name, settings, own):
        """What is added to the id of the program: entries that it leaves out, unless
        they say what holds without them."""
        counted = ["%s=%s" % (entry, canonical(value)) for entry, value
                   in sorted(settings) if entry in own and entry in self.left_out
                   and self.matters(name, settings, entry)]
        digest = hashlib.sha256("\n".join(counted).encode()).hexdigest()
        return "-" + digest[:8] if counted else ""

    def matters(self, name, settings, entry):
        """Whether an entry changes anything."""
        without = [pair for pair in settings if pair[0] != entry]
        return self.asked(name, settings, True) != self.asked(name, without, True)

    def chosen(self, patterns=None):
        """[Case] whose names match one of the patterns; all of them for None."""
        for pattern in patterns or ():
            if not matching(self.cases, [pattern]):
                raise SweepError("--only: there is no run '%s' in %s; there are %s"
                                 % (pattern, self.sweep.path, ", ".join(self.cases)))
        return [self.cases[name] for name in matching(self.cases, patterns)]

    # the directory

    def owner(self):
        """Path of the sweep file whose directory it is, or None."""
        try:
            path = safe.read_json(os.path.join(self.output, OWNER))["file"]
        except (KeyError, TypeError):
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

    def claim(self, wait=0.):
        """Makes the directory, as that of this sweep file; returns its lock, held,
        and warns where the file system has none.
        wait: s, while somebody else has it. Raises lock.InUse and OSError."""
        os.makedirs(self.output, exist_ok=True)
        held = lock.Lock(self.output, wait=wait)
        try:
            self.require_owner()  # somebody may have been faster
            if not self.owner():
                safe.write_whole(os.path.join(self.output, OWNER), json.dumps(
                    {"file": os.path.abspath(self.sweep.path)}) + "\n")
        except BaseException:
            held.release()
            raise
        if held.warning:
            print("sweep.py: warning: %s" % held.warning, file=sys.stderr)
        return held


def opened(arguments, names=None):
    """The Study that options of a command name."""
    return Study(arguments.file, arguments.output, arguments.program, arguments.extra,
                 names)


def canonical(value):
    """One text for 6, 6.0 and 6e0."""
    try:
        return "%.17g" % float(value)
    except ValueError:
        return " ".join(value.split())
