# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables that others have measured: CSV with one header line, columns by name.
Commas, semicolons or tabs part the fields, a point the decimals. Lines with # are
comments; '# name: value' is a setting, as in '# test: uniaxial'."""
import csv
import math
import re

import numpy as np

from .errors import InputError, listed

LARGEST = 1e12  # what is larger is no measure of a test in mm, N or MPa
SETTING = re.compile(r"#\s*([A-Za-z_0-9]+)\s*:\s*(.*?)\s*$")


class Table:
    """path; names; rows [(line number, [text])]; settings {name: (line, text)}."""

    def __init__(self, path, may_be_cut=False):
        self.path, self.may_be_cut = path, may_be_cut
        self.settings = {}
        self.rows = []
        self.names, self.header_line = [], 0
        for number, line in enumerate(self.lines(), 1):
            if line.lstrip().startswith("#"):
                self.note(number, line)
            elif line.strip():
                self.take(number, line)
        if not self.names:
            raise InputError("%s: expected a header line and rows of numbers, found "
                             "no line" % path)

    def lines(self):
        try:
            with open(self.path, encoding="utf-8-sig", newline=None) as stream:
                text = stream.read()
        except OSError as error:
            raise InputError("%s cannot be read: %s" % (self.path, error.strerror))
        except UnicodeDecodeError:
            raise InputError("%s cannot be read: expected text in UTF-8, found other "
                             "bytes" % self.path)
        if self.may_be_cut and not text.endswith("\n"):
            text = text[:text.rfind("\n") + 1]  # a run that was killed
        return text.splitlines()

    def note(self, number, line):
        found = SETTING.match(line.strip())
        if found:
            self.settings[found.group(1).lower()] = number, found.group(2)

    def take(self, number, line):
        if not self.names:
            self.separator = next((mark for mark in ";\t" if mark in line), ",")
        fields = [field.strip() for field in
                  next(csv.reader([line], delimiter=self.separator), [])]
        if not self.names:
            self.names, self.header_line = fields, number
            twice = [name for name in fields if name and fields.count(name) > 1]
            if twice:
                raise InputError("%s:%d: the column '%s' is there twice, expected once"
                                 % (self.path, number, twice[0]))
        elif len(fields) != len(self.names):
            raise InputError("%s:%d: expected %d fields, as in the header, found %d"
                             % (self.path, number, len(self.names), len(fields)))
        else:
            self.rows.append((number, fields))

    def chosen(self, allowed, what):
        """The first of the allowed names that is a column."""
        for name in allowed:
            if name in self.names:
                return name
        raise InputError("%s:%d: no column for the %s: expected one of %s, found %s"
                         % (self.path, self.header_line, what, listed(allowed),
                            listed(self.names)))

    def records(self):
        """[(line number, {name: text})]"""
        return [(number, dict(zip(self.names, fields))) for number, fields in self.rows]

    def texts(self, name):
        i = self.names.index(name)
        return [(number, fields[i]) for number, fields in self.rows]

    def column(self, name, least=None, above=None):
        """The numbers of a column, at least `least` or more than `above`."""
        return np.array([self.number(line, name, text, least, above)
                         for line, text in self.texts(name)])

    def number(self, line, name, text, least=None, above=None):
        return number_in(text, "%s:%d: column '%s'" % (self.path, line, name), least,
                         above)

    def setting(self, name):
        """A positive number of a comment '# name: value', or None."""
        if name not in self.settings:
            return None
        line, text = self.settings[name]
        return number_in(text, "%s:%d: '%s'" % (self.path, line, name), above=0.)


def number_in(text, place, least=None, above=None):
    """A number of measurable size; place is the begin of the message otherwise."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    allowed = "a number" + (" of at most %g" % LARGEST if abs(value) > LARGEST else "") \
        + ("" if least is None else " of at least %g" % least) \
        + ("" if above is None else " above %g" % above)
    if not abs(value) <= LARGEST or (least is not None and value < least) \
            or (above is not None and value <= above):
        raise InputError("%s: expected %s, found '%s'%s" % (
            place, allowed, text, " (decimals come after a point)"
            if re.fullmatch(r"\s*[+-]?\d+,\d+\s*", text) else ""))
    return value
