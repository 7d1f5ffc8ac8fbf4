# SPDX-License-Identifier: GPL-2.0-or-later
"""Texts and numbers from files that may hold anything: cut off, damaged, of
another program; and files that nobody finds in such a state. Python's own library
only."""
import csv
import hashlib
import json
import math
import os
import sys

# What is larger is no measure of a body in mm, N, MPa or s, and breaks drawing.
LARGEST = 1e30
# What is smaller is 0: its square is, and quotients of such numbers are nothing.
SMALLEST = 1e-150
DEEPEST = 20  # lists within lists


def read_text(path):
    """The text of a file, or None when there is none."""
    try:
        with open(path, encoding="utf-8", errors="replace", newline="") as stream:
            return stream.read()
    except (OSError, ValueError):
        return None


def read_json(path):
    """What a JSON file holds; None when there is none, or a damaged one."""
    try:
        return json.loads(read_text(path) or "")
    except ValueError:
        return None


def checksum_of(path):
    """SHA-256 of a file, however large."""
    digest = hashlib.sha256()
    with open(path, "rb") as stream:
        for part in iter(lambda: stream.read(1 << 20), b""):
            digest.update(part)
    return digest.hexdigest()


def in_words(error):
    """An error that nobody foresaw, on one line."""
    return "%s: %s" % (type(error).__name__, " ".join(str(error).split())[:300])


def ended(script, known, what, function, *arguments):
    """The exit status of a script that function does the work of: 2 with a line where
    it raises a known kind of error, and where files hold what nobody foresaw."""
    try:
        function(*arguments)
        return 0
    except (known, OSError) as error:
        print("%s: %s" % (script, error), file=sys.stderr)
    except Exception as error:  # no trace of the inside
        print("%s: %s (%s)" % (script, what, in_words(error)), file=sys.stderr)
    return 2


def write_whole(path, text):
    """The old file stays until the new one is whole. What is no character, as in names
    of files, becomes '?'."""
    new = "%s.%d" % (path, os.getpid())
    with open(new, "w", encoding="utf-8", errors="replace") as stream:
        stream.write(text)
    os.replace(new, path)


def finite(text):
    """A number that can be drawn, or None."""
    try:
        value = float(text)
    except (TypeError, ValueError, OverflowError):
        return None
    if abs(value) < SMALLEST:
        return 0.
    return value if abs(value) <= LARGEST else None


def is_number_or_empty(text):
    """Whether a number is written there, finite or not, or nothing."""
    try:
        float(text.strip() or 0)
        return True
    except ValueError:
        return False


def grouped(items, key):
    """{key(item): items}, in the order in which they come."""
    found = {}
    for item in items:
        found.setdefault(key(item), []).append(item)
    return found


def fields_of(line):
    """The fields of one line of a CSV file, or None when it is none. A quotation
    mark that is lost spoils its own line only: names hold no ends of lines."""
    try:
        return next(csv.reader([line]), [])
    except (csv.Error, StopIteration):
        return None


def csv_table(text):
    """(names, rows, number of lines that could not be read, whether the last line
    was cut off) of a CSV file with a header and comments. Every row is as long as
    the header."""
    lines = text.splitlines()
    cut = bool(text) and not text.endswith(("\n", "\r"))
    if cut:
        # even if it looks whole: its last number may have lost digits
        lines.pop()
    lines = [line for line in lines
             if line.strip() and not line.lstrip().startswith("#")]
    if not lines:
        return [], [], 0, cut
    names = [name.strip() for name in fields_of(lines[0]) or []]
    rows = [fields_of(line) for line in lines[1:]]
    good = [row for row in rows if row is not None and len(row) == len(names)]
    return names, good, len(rows) - len(good), cut


def cleaned(value, depth=0):
    """A JSON value without what cannot be shown: numbers that are not finite
    become None, as null is."""
    if isinstance(value, bool) or value is None:
        return value
    if isinstance(value, (int, float)):
        return value if finite(value) is not None and math.isfinite(value) else None
    if isinstance(value, str):
        return value.encode("utf-8", "replace").decode("utf-8")
    if depth == DEEPEST:
        return None
    if isinstance(value, dict):
        return {cleaned(key): cleaned(entry, depth + 1)
                for key, entry in value.items()}
    return [cleaned(entry, depth + 1) for entry in value]


# Of summary.json; all others are single values.
KINDS = {"separated": bool, "seconds_per_phase": dict, "warnings": list,
         "exit_reason": str, "outcome": str, "outcome_start": str, "case": str,
         "coupling": str}


def json_object(text):
    """The keys of a JSON object that have values of their kind; raises ValueError
    when it is none."""
    try:
        value = json.loads(text)
    except RecursionError:
        raise ValueError("too many brackets")
    if not isinstance(value, dict):
        raise ValueError("not an object")
    found = {key: entry for key, entry in cleaned(value).items()
             if isinstance(entry, KINDS.get(key, (bool, int, float, str)))}
    phases = found.get("seconds_per_phase", {})
    for name in [name for name in phases if finite(phases[name]) is None]:
        del phases[name]
    return found
