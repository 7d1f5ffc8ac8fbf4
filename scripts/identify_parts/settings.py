# SPDX-License-Identifier: GPL-2.0-or-later
"""Options that may differ from test to test: 'VALUE', 'KIND=VALUE', 'FILE=VALUE'."""
import os

from report_parts.csv_table import number_in
from report_parts.errors import InputError


def interval(text, place):
    """(low, high) of '1:2'; an end may be left out."""
    low, colon, high = text.partition(":")
    if not colon:
        raise InputError("%s: expected LOW:HIGH, found '%s'" % (place, text))
    ends = (number_in(low, place) if low.strip() else -float("inf"),
            number_in(high, place) if high.strip() else float("inf"))
    if not ends[0] < ends[1]:
        raise InputError("%s: expected LOW below HIGH, found '%s'" % (place, text))
    return ends


def positive(text, place):
    return number_in(text, place, above=0.)


def numbers(text, place):
    """Positive, ascending: '10,20,80'."""
    values = [positive(word, place) for word in text.split(",")]
    if values != sorted(set(values)):
        raise InputError("%s: expected numbers in ascending order, found '%s'"
                         % (place, text))
    return values


class Setting:
    """One option: what it is for each test."""

    def __init__(self, option, texts, read, kinds):
        self.option, self.kinds = option, kinds
        self.values, self.used = {}, {""}
        for text in texts or ():
            key, equals, value = text.rpartition("=")
            if key in self.values:
                raise InputError("%s: '%s' is given twice, expected once"
                                 % (option, text))
            if equals and not key:
                raise InputError("%s: expected KIND=VALUE, found '%s'" % (option, text))
            self.values[key] = read(value, option)

    def of(self, kind, path, default=None, general=True):
        """The value for a file; that without a kind counts where `general`."""
        for key in (path, os.path.basename(path), kind):
            if key in self.values:
                self.used.add(key)
                return self.values[key]
        return self.values.get("", default) if general else default

    def check_used(self):
        """Once all tests are read: a key that none of them has is a mistake."""
        for key in self.values:
            if key not in self.used:
                raise InputError("%s: expected a kind of test that is given (%s) or "
                                 "its file, found '%s'"
                                 % (self.option, ", ".join(self.kinds), key))
