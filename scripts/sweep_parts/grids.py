# SPDX-License-Identifier: GPL-2.0-or-later
"""The points of the grids of a sweep file: products of lists of values, and lists
that go together."""
import collections
import itertools
import math
import re

from .errors import SweepError

RANGE = re.compile(r"([^:]+):([^:]+):([^:]+)$")
LARGEST = 100000  # points; more are a slip

# settings: [(entry, value)]; swept: {title of the grid: value}
Point = collections.namedtuple("Point", "settings swept")


class Grids:
    """axes: a list for each factor of the product, of (title, values) that go
    together; line: of the first grid; pattern: of the names, or None."""

    def __init__(self):
        self.axes, self.zipped, self.line, self.pattern = [], [], 0, None

    def __bool__(self):
        return bool(self.axes) or self.pattern is not None

    def read(self, kind, words, number):
        """A line of the file, after the '='."""
        title, values = title_and_values(words)
        if title in (other for axis in self.axes for other, _ in axis):
            raise SweepError("'%s' has a second grid" % title)
        self.line = self.line or number
        if kind == "grid":
            self.axes.append([(title, values)])
            return
        if not self.zipped:
            self.axes.append(self.zipped)
        elif len(values) != len(self.zipped[0][1]):
            raise SweepError("'%s' has %d values, '%s' has %d: lists of zip go together"
                             % (title, len(values), self.zipped[0][0],
                                len(self.zipped[0][1])))
        self.zipped.append((title, values))

    def points(self, sets):
        """Of the product; sets: {name: settings} that values may name."""
        if not self.axes:
            raise SweepError("'name = %s' makes the names of a grid, and there is none"
                             % self.pattern)
        factors = [list(zip(*([(title, value) for value in values]
                              for title, values in axis))) for axis in self.axes]
        count = math.prod(map(len, factors))
        if count > LARGEST:
            raise SweepError("the grids have %d points; at most %d are allowed"
                             % (count, LARGEST))
        for chosen in itertools.product(*factors):
            pairs = [pair for group in chosen for pair in group]
            yield Point(settings_of(pairs, sets), dict(pairs))

    def name_of(self, point):
        known = {}
        for title, value in point.swept.items():
            known[title] = value
            known.setdefault(title.split("/")[-1], value)

        def replaced(match):
            if match.group(1) not in known:
                raise SweepError("name: there is no grid '%s'; there are %s" % (
                    match.group(1), ", ".join("'%s'" % title for title in known)))
            return as_name(known[match.group(1)])

        pattern = self.pattern or "_".join(
            ("%s_" % as_name(title.split("/")[-1]) if "/" in title else "")
            + "{%s}" % title for title in point.swept)
        return re.sub(r"\{([^{}]*)\}", replaced, pattern)


def settings_of(pairs, sets):
    """[(entry, value)] of a point; a title without '/' stands for sets."""
    settings = {}
    for title, value in pairs:
        if "/" in title:
            settings[title] = value
        elif value in sets:
            settings.update(sets[value])
        else:
            raise SweepError("grid '%s': there is no line 'set %s = ...'; a grid whose "
                             "title has no '/' has names of sets as its values"
                             % (title, value))
    return list(settings.items())


def title_and_values(words):
    """Of '"Subsection/Entry" : 6 10 12:18:2', as words."""
    words = list(words)
    if words and words[0].endswith(":") and words[0] != ":":
        words[:1] = [words[0][:-1], ":"]
    if len(words) < 3 or words[1] != ":":
        raise SweepError("expected '\"Subsection/Entry\" : value value' (or a range as "
                         "6:18:2), found '%s'" % " ".join(words))
    title = entry_of(words[0])
    if not all(title.split("/")):
        raise SweepError("expected \"Subsection/Entry\" before the ':', found '%s'"
                         % words[0])
    values = [value for word in words[2:] for value in values_of(word)]
    for value, count in collections.Counter(values).items():
        if count > 1:
            raise SweepError("'%s' has the value %s twice" % (title, value))
    return title, values


def entry_of(text):
    """An entry without needless blanks."""
    return "/".join(" ".join(part.split()) for part in text.split("/"))


def values_of(word):
    """Of a range FIRST:LAST:STEP, with its ends; any other word is itself."""
    match = RANGE.match(word)
    try:
        first, last, step = (float(part) for part in match.groups())
    except (AttributeError, ValueError):
        return [word]
    if step == 0. or (last - first) / step < 0. \
            or not (last - first) / step < LARGEST:
        raise SweepError("the range %s leads nowhere; a range is FIRST:LAST:STEP" % word)
    # a last one that is missed by rounding is not
    count = int((last - first) / step + 1e-9) + 1
    return ["%.12g" % (first + step * k) for k in range(count)]


def as_name(value):
    """Of any value or title, what may stand in the name of a run."""
    return re.sub(r"[^A-Za-z0-9_.+-]+", "_", value.strip()) or "_"
