# SPDX-License-Identifier: GPL-2.0-or-later
"""Where an answer changes between two values of a parameter: pure logic, Python's own
library only. Nothing is remembered but the answers that are known, so that a bisection
can be left and taken up again, here or by jobs of a cluster.

An answer is any value that can be compared, mostly words (the outcome of a run) or
whether a number has passed a bound; None is the answer of a run that has failed."""
import collections
import math
import operator
import re

from .errors import StudyError

# low and high: the values nearest to the change on both sides
Bracket = collections.namedtuple("Bracket", "low high low_answer high_answer")
OPERATORS = {"<=": operator.le, ">=": operator.ge, "<": operator.lt, ">": operator.gt}


def rounded(value):
    """To twelve digits: 0.1 + 0.2 is 0.3, and a name of a case can be made of it."""
    return float("%.12g" % value)


def bracket_of(known, low, high):
    """The Bracket within [low, high] that {value: answer} leaves; None as long as one
    of the ends has no answer. Of several changes it is the lowest. Failed runs (None)
    are passed over. Raises StudyError where both ends answer alike."""
    if known.get(low) is None or known.get(high) is None:
        return None
    if known[low] == known[high]:
        raise StudyError("no change lies between %g and %g: both give '%s'"
                         % (low, high, known[low]))
    values = sorted(value for value, answer in known.items()
                    if low <= value <= high and answer is not None)
    last = max(i for i in range(len(values))
               if all(known[value] == known[low] for value in values[:i + 1]))
    below, above = values[last], values[last + 1]
    return Bracket(below, above, known[below], known[above])


def next_values(known, low, high, tolerance, at_once=1):
    """Values to run next, at most `at_once` of them, or the ends; [] when the bracket
    is no wider than the tolerance. Several divide the bracket into equal parts, as
    many runs at a time as the machine takes. Raises StudyError where a run that is
    needed has failed."""
    if not low < high:
        raise StudyError("expected a range from a smaller to a larger value, found "
                         "%g to %g" % (low, high))
    if not tolerance > 0.:
        raise StudyError("expected a width of the bracket above 0, found %g"
                         % tolerance)
    ends = [value for value in (low, high) if value not in known]
    if ends:
        return ends
    failed = [value for value in (low, high) if known[value] is None]
    if failed:
        raise StudyError("the run at %g has failed: no answer to start from"
                         % failed[0])
    bracket = bracket_of(known, low, high)
    return between(known, bracket, tolerance, at_once) \
        if bracket.high - bracket.low > tolerance * (1. + 1e-9) else []


def between(known, bracket, tolerance, at_once):
    """Values that divide the bracket, without those that are known; where the middle
    has failed, the quarters instead."""
    width = bracket.high - bracket.low
    parts = min(at_once + 1, max(2, math.ceil(width / tolerance)))
    for n in (parts, 2 * parts, 4 * parts):
        wanted = [rounded(bracket.low + width * i / n) for i in range(1, n)]
        wanted = [value for value in wanted if value not in known]
        if wanted:
            middle = 0.5 * (bracket.low + bracket.high)
            return sorted(wanted, key=lambda value: abs(value - middle))[:at_once]
    raise StudyError("all runs between %g and %g have failed" % bracket[:2])


def other_changes(known, bracket):
    """Values above the bracket whose answer is that of below: the change is not the
    only one, and the answer depends on more than the parameter."""
    return sorted(value for value, answer in known.items()
                  if value > bracket.high and answer == bracket.low_answer)


class Question:
    """What `--on` asks of a run: 'outcome', 'outcome,outcome_start', or
    'peak_force_N > 160'. Keys are those of summary.json."""

    def __init__(self, text):
        self.text = text.strip()
        found = re.match(r"(\w+)\s*(<=|>=|<|>)\s*(\S+)$", self.text)
        if found:
            self.keys, self.compare = [found.group(1)], OPERATORS[found.group(2)]
            try:
                self.bound = float(found.group(3))
            except ValueError:
                raise StudyError("--on: expected a number after '%s', found '%s'"
                                 % found.group(2, 3))
            return
        self.compare = None
        self.keys = [key.strip() for key in self.text.split(",")]
        if not all(re.match(r"\w+$", key) for key in self.keys):
            raise StudyError("--on: expected keys of summary.json, as 'outcome' or "
                             "'outcome,outcome_start', or a bound, as "
                             "'peak_force_N > 160', found '%s'" % text)

    def answer(self, summary):
        """To {key: value} of a run that is complete; raises StudyError where it has no
        such key."""
        missing = [key for key in self.keys if summary.get(key) is None]
        if missing:
            raise StudyError("--on: the summary of a run has no '%s'; it has %s"
                             % (missing[0], ", ".join(sorted(summary))))
        if self.compare is None:
            return ", ".join(str(summary[key]) for key in self.keys)
        value = summary[self.keys[0]]
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise StudyError("--on: '%s' is no number but '%s'" % (self.keys[0], value))
        return self.text if self.compare(value, self.bound) else "not " + self.text
