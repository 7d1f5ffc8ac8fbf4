# SPDX-License-Identifier: GPL-2.0-or-later
"""Sweep files that a study makes for itself. Python's own library only.

A bisection and the variations of a case are sweeps whose runs follow from another one.
They get a directory and a sweep file of their own there, in which names and settings
are written out, so that every command works on it: plan, submit, status, collect,
compare, report."""
import os
import shlex
import sys

from report_parts import parameters, safe
from sweep_parts import sweep_file
from sweep_parts.errors import SweepError
from sweep_parts.study import Study

from . import variations
from .errors import StudyError

HEAD = "# Made by sweep.py %s of %s.\n" \
    "# It is written anew each time; every command of sweep.py works on it.\n\n"


class Source:
    """What a study starts from: a sweep file or a single parameter file.

    base: its path, absolute; runs: {name: [(entry, value)]}, in full, with what stands
    after -- on the command line."""

    def __init__(self, path, patterns, extra):
        self.path = path
        sweep_file.require_allowed(extra)
        if path.endswith(".prm"):
            if not os.path.isfile(path):
                raise StudyError("there is no file '%s'" % path)
            self.base = os.path.abspath(path)
            own = sweep_file.split_settings(extra)[0]
            self.runs = {self.stem: sweep_file.merged(own)}
        else:
            sweep = sweep_file.Sweep(path)
            self.base = sweep.base
            self.runs = {name: sweep.settings(name, extra) for name in sweep.runs}
        self.runs = {name: self.runs[name]
                     for name in sweep_file.matching(self.runs, patterns)}
        if not self.runs:
            raise StudyError("--only: no run of %s is called %s"
                             % (path, " or ".join("'%s'" % p for p in patterns)))

    @property
    def stem(self):
        return os.path.splitext(os.path.basename(self.path))[0]

    def effective(self, name, program):
        """{"Subsection/Entry": value} of a run with the defaults of the program."""
        status, text, _ = program.said("--parameters", "prm")
        if status != 0:
            raise StudyError("'%s --parameters prm' has failed" % program.path)
        found = parameters.parameters_of(text)
        found.update(parameters.read_parameters(self.base))
        found.update(self.runs[name])
        return found

    def varied(self, name, variation):
        """[(entry, value)] of a run with those of a Variation."""
        return sweep_file.merged(self.runs[name] + list(variation.settings))

    def allowed(self, name, program, entries, share=0.1):
        """The variations of a run that the program takes; says why it refuses others,
        as a mesh that is its own mirror image."""
        found = []
        for variation in variations.variations_of(self.effective(name, program), entries,
                                                  share):
            try:
                program.case_id(self.base, sweep_file.options_of(
                    self.varied(name, variation)))
                found.append(variation)
            except SweepError as error:
                print("left out: %s: %s: %s" % (variation.group, variation.name, error),
                      file=sys.stderr)
        return found


def text_of(kind, source, runs):
    """runs: {name: [(entry, value)]}"""
    text = HEAD % (kind, os.path.abspath(source.path))
    text += "base = %s\n" % shlex.quote(source.base)
    for name, settings in runs.items():
        text += "%s = %s\n" % (name, shlex.join(sweep_file.options_of(settings)))
    return text


def study_of(kind, source, runs, output, program):
    """The Study of these runs, in OUTPUT/KIND.sweep, which is written when it has
    changed. Jobs that read it meanwhile see the old one or the new one."""
    path = os.path.join(output, kind + ".sweep")
    text = text_of(kind, source, runs)
    os.makedirs(output, exist_ok=True)
    if safe.read_text(path) != text:
        safe.write_whole(path, text)
    return Study(path, output, program)


def runs_before(kind, output):
    """{name: [(entry, value)]} of what OUTPUT/KIND.sweep holds; empty without."""
    path = os.path.join(output, kind + ".sweep")
    if not os.path.isfile(path):
        return {}
    sweep = sweep_file.Sweep(path)
    return {name: sweep.settings(name) for name in sweep.runs}
