# SPDX-License-Identifier: GPL-2.0-or-later
"""Sweep files: variants of one parameter file, a line each.

    # a comment; comments have lines of their own
    base = strip.prm
    common = --set "Mesh/Adaptive levels=1"
    coarse =
    fine   = --set "Mesh/Adaptive levels=2"

`base` is relative to the sweep file. `common` may come several times and goes
to every run. Every other key is the name of a run. Quoting is that of a shell.
Of several settings of one entry the last holds: common, then the run's own,
then those of the command line.
"""
import hashlib
import os
import re
import shlex

NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.+-]*$")


class SweepError(Exception):
    """What is wrong with a sweep file or its use; the text is for a person."""


class Sweep:
    """base: path of the parameter file; runs: {name: [(entry, value)]}."""

    def __init__(self, path):
        self.path = path
        self.base = None
        self.common = []
        self.runs = {}
        self.lines = {}  # where a name has been given first
        try:
            with open(path, encoding="utf-8") as stream:
                text = stream.read()
        except (OSError, UnicodeDecodeError) as error:
            raise SweepError("%s cannot be read: %s" % (path, error))
        for number, line in enumerate(text.splitlines(), 1):
            if line.strip() and not line.lstrip().startswith("#"):
                try:
                    self.read_line(line, number)
                except SweepError as error:
                    raise SweepError("%s:%d: %s" % (path, number, error))
        if self.base is None:
            raise SweepError("%s: there is no line 'base = FILE.prm'" % path)
        if not self.runs:
            raise SweepError("%s: there is no run; one is a line "
                             "'name = --set \"Subsection/Entry=value\"'" % path)

    def read_line(self, line, number):
        key, equals, rest = line.partition("=")
        key = key.strip()
        if not equals or not NAME.match(key):
            raise SweepError("expected 'base = FILE', 'common = OPTIONS' or "
                             "'name = OPTIONS' (a name has letters, digits and "
                             "_ . + -), found '%s'" % line.strip())
        if key != "common" and key in self.lines:
            raise SweepError("'%s' is given a second time; the first is in line %d"
                             % (key, self.lines[key]))
        self.lines.setdefault(key, number)
        if key == "base":
            self.read_base(rest)
        elif key == "common":
            self.common += settings_of(words_of(rest), self.common)
        else:
            self.runs[key] = settings_of(words_of(rest))

    def read_base(self, rest):
        words = words_of(rest)
        if len(words) != 1:
            raise SweepError("base expects one file, found %d words" % len(words))
        self.base = os.path.normpath(os.path.join(
            os.path.dirname(os.path.abspath(self.path)), words[0]))
        if not os.path.isfile(self.base):
            raise SweepError("there is no base file '%s'" % self.base)

    def options(self, name, extra=()):
        """The options of a run in full, as words."""
        own, others = split_settings(extra)
        for word in others:
            if word not in ("--overwrite", "--resume"):
                raise SweepError("only --set \"Subsection/Entry=value\" and --resume "
                                 "may stand after --, found '%s'" % word)
        merged = {}
        for entry, value in self.common + self.runs[name] + own:
            merged[entry] = value
        options = []
        for entry, value in merged.items():
            options += ["--set", "%s=%s" % (entry, value)]
        return options + others

    def base_checksum(self):
        with open(self.base, "rb") as stream:
            return hashlib.sha256(stream.read()).hexdigest()


def words_of(text):
    try:
        return shlex.split(text)
    except ValueError as error:
        raise SweepError("the quotation marks do not match up (%s)"
                         % str(error).lower())


def setting_of(text):
    """(entry, value) of "Subsection/Entry=value"."""
    entry, equals, value = text.partition("=")
    entry = "/".join(part.strip() for part in entry.split("/"))
    if not equals or not all(entry.split("/")):
        raise SweepError("--set expects \"Subsection/Entry=value\", found '%s'" % text)
    return entry, value.strip()


def split_settings(words):
    """([(entry, value)] of the --set among the words, the other words)."""
    settings, others, words = [], [], list(words)
    while words:
        word = words.pop(0)
        if word == "--set":
            if not words:
                raise SweepError("--set expects \"Subsection/Entry=value\" after it")
            settings.append(setting_of(words.pop(0)))
        elif word.startswith("--set="):
            settings.append(setting_of(word[len("--set="):]))
        else:
            others.append(word)
    return settings, others


def settings_of(words, before=()):
    """The same where nothing but --set is allowed, and no entry twice."""
    settings, others = split_settings(words)
    if others:
        raise SweepError("only --set \"Subsection/Entry=value\" may stand here, "
                         "found '%s'; are quotation marks missing?" % others[0])
    seen = [entry for entry, _ in before]
    for entry, _ in settings:
        if entry in seen:
            raise SweepError("'%s' is set twice" % entry)
        seen.append(entry)
    return settings
