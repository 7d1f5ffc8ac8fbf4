# SPDX-License-Identifier: GPL-2.0-or-later
"""Sweep files: variants of one parameter file, a line each or by a grid.

    # a comment; comments have lines of their own
    base = strip.prm
    common = --set "Mesh/Adaptive levels=1"
    coarse =
    fine   = --set "Mesh/Adaptive levels=2"

    set soft = --set "Material/Shear modulus=1.18"     a material, once
    set hard = --set "Material/Shear modulus=2.40"
    soft_6   = soft --set "Geometry/Punctured strip/Notch height=6"

    grid = material : soft hard
    grid = "Geometry/Punctured strip/Notch height" : 6 10 12:18:2
    zip  = "Mesh/Adaptive levels" : 2 3
    zip  = "Model/Length scale"   : 0.6 0.3
    name = {material}_{Notch height}_{Adaptive levels}

`base` is relative to the sweep file. `common` may come several times and goes to
every run. `set NAME` gives settings a name, which may stand before the --set of a
run, or as a value of a grid whose title has no '/'. A grid is an entry with its
values; several make the product, the first one varying slowest; lines of `zip` go
together and count as one grid. 12:18:2 is 12 14 16 18. `name` makes the names of
the grid's runs, from the last part of an entry, or all of it. Every other key is
the name of a run. Quoting is that of a shell. Of several settings of one entry the
last holds: common, then the run's own, then those of the command line.
"""
import collections
import fnmatch
import os
import re
import shlex

from . import grids
from .errors import SweepError
from .grids import entry_of

NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.+-]*$")
# what has a name of its own in the directory of a sweep
TAKEN = ("cases", "submissions", "sweep.csv", "sweep.json", "ids.json", "pages",
         "report.html", "comparison", "comparison.md", "comparison.csv")

# settings: [(entry, value)] of a run's own; swept: {title: value}, what a table of
# the sweep names, by entry, or by the title of a grid of sets
Variant = collections.namedtuple("Variant", "settings swept")


class Sweep:
    """base: path of the parameter file; runs: {name: Variant}, in order; raises
    SweepError."""

    def __init__(self, path):
        self.path = path
        self.base = None
        self.common = []
        self.runs = {}
        self.sets = {}
        self.grids = grids.Grids()
        self.lines = {}  # where a name has been given first
        for number, line in enumerate(text_of(path).splitlines(), 1):
            if line.strip() and not line.lstrip().startswith("#"):
                self.located(number, self.read_line, line, number)
        if self.base is None:
            raise SweepError("%s: there is no line 'base = FILE.prm'" % path)
        if self.grids:
            self.located(self.grids.line, self.add_grid)
        if not self.runs:
            raise SweepError("%s: there is no run; one is a line "
                             "'name = --set \"Subsection/Entry=value\"', several are "
                             "'grid = \"Subsection/Entry\" : value value'" % path)

    def located(self, number, function, *arguments):
        """Calls it; errors get the number of the line."""
        try:
            function(*arguments)
        except SweepError as error:
            raise SweepError("%s:%d: %s" % (self.path, number, error))

    def read_line(self, line, number):
        key, equals, rest = line.partition("=")
        key = " ".join(key.split())
        if equals and key in ("grid", "zip"):
            self.grids.read(key, words_of(rest), number)
        elif equals and key == "name":
            self.read_pattern(rest, number)
        elif equals and key.startswith("set ") and NAME.match(key[4:]):
            self.only_once(key, number)
            self.sets[key[4:]] = settings_of(words_of(rest))
        elif not equals or not NAME.match(key):
            raise SweepError("expected 'base = FILE', 'common = OPTIONS', 'set NAME = "
                             "OPTIONS', 'grid = ENTRY : VALUES' or 'name = OPTIONS' (a "
                             "name has letters, digits and _ . + -), found '%s'"
                             % line.strip())
        else:
            self.read_run(key, rest, number)

    def read_run(self, key, rest, number):
        if key != "common":
            self.only_once(key, number)
        if key == "base":
            self.read_base(rest)
        elif key == "common":
            self.common += settings_of(words_of(rest), self.common)
        elif key in TAKEN:
            raise SweepError("a run cannot be called '%s': the directory of the sweep "
                             "has that name for something else" % key)
        else:
            settings = self.own_settings(words_of(rest))
            self.runs[key] = Variant(settings, dict(settings))

    def only_once(self, key, number):
        if key in self.lines:
            raise SweepError("'%s' is given a second time; the first is in line %d"
                             % (key, self.lines[key]))
        self.lines[key] = number

    def read_base(self, rest):
        words = words_of(rest)
        if len(words) != 1:
            raise SweepError("base expects one file, found %d words" % len(words))
        self.base = os.path.normpath(os.path.join(
            os.path.dirname(os.path.abspath(self.path)), words[0]))
        if not os.path.isfile(self.base):
            raise SweepError("there is no base file '%s'" % self.base)

    def read_pattern(self, rest, number):
        pattern = rest.strip().strip("\"'")
        if self.grids.pattern is not None:
            raise SweepError("'name' is given a second time")
        if "{" not in pattern:
            raise SweepError("name expects a pattern as h_{Notch height}, found '%s'"
                             % rest.strip())
        self.grids.pattern = pattern
        self.grids.line = self.grids.line or number

    def own_settings(self, words):
        """Of a run: names of sets, then --set."""
        named = []
        while words and words[0] in self.sets:
            named += self.sets[words.pop(0)]
        return list(dict(named + settings_of(words)).items())

    def add_grid(self):
        for point in self.grids.points(self.sets):
            name = self.grids.name_of(point)
            if name in self.runs or name in TAKEN:
                raise SweepError("there are two runs of the name '%s'; a line 'name = "
                                 "...' has to tell the points of the grid apart" % name)
            if not NAME.match(name):
                raise SweepError("'%s' is no name of a run" % name)
            self.runs[name] = Variant(point.settings, point.swept)

    def settings(self, name, extra=()):
        """[(entry, value)] of a run in full; extra: words after -- on the command
        line."""
        own, _ = split_settings(extra)
        return merged(self.common + self.runs[name].settings + own)


def matching(names, patterns):
    """Those that match one of the patterns; all of them without patterns."""
    return [name for name in names if not patterns
            or any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)]


def text_of(path):
    try:
        with open(path, encoding="utf-8") as stream:
            return stream.read()
    except (OSError, UnicodeDecodeError) as error:
        raise SweepError("%s cannot be read: %s" % (path, error))


def words_of(text):
    try:
        return shlex.split(text)
    except ValueError as error:
        raise SweepError("the quotation marks do not match up (%s)"
                         % str(error).lower())


def merged(settings):
    """[(entry, value)] in which the last of several values of an entry holds."""
    return list(dict(settings).items())


def options_of(settings):
    return [word for entry, value in settings
            for word in ("--set", "%s=%s" % (entry, value))]


def setting_of(text):
    """(entry, value) of "Subsection/Entry=value"."""
    entry, equals, value = text.partition("=")
    entry = entry_of(entry)
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


def require_allowed(extra):
    """What may stand after -- on the command line."""
    for word in split_settings(extra)[1]:
        if word not in ("--overwrite", "--resume"):
            raise SweepError("only --set \"Subsection/Entry=value\" and --resume "
                             "may stand after --, found '%s'" % word)


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
