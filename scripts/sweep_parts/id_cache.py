# SPDX-License-Identifier: GPL-2.0-or-later
"""Ids that the program has given before, in OUTPUT/ids.json: to ask for one takes as
long as it takes to load its libraries.

An answer holds as long as the program, the settings, the base file, and all files
that these name are what they were. A name is anything in them that leads to a file,
from the folder of the base file or from the working directory; parameter files that
are included are searched in turn.
"""
import contextlib
import hashlib
import json
import os
import re

from report_parts import safe

FILE = "ids.json"
LARGE = 1 << 24  # bytes; of larger files size and time count
MOST = 20000  # answers that are kept; of more only those that were asked for


class IdCache:
    """Of a directory of a sweep; nothing is kept where there is no directory."""

    def __init__(self, output, program, base):
        self.path = os.path.join(output, FILE)
        self.folders = (os.path.dirname(os.path.abspath(base)), os.getcwd())
        self.program, self.base = program, base
        self.sums, self.files = {}, None
        known = safe.read_json(self.path)
        self.known = known if isinstance(known, dict) else {}
        self.changed, self.used = False, set()

    def key(self, words):
        """Of words for the program."""
        if self.files is None:
            self.files = self.named_in_file(self.base, set())
        files = sorted(self.named_in("\n".join(words), set()) | self.files)
        parts = [self.program.checksum, self.base, *words]
        parts += ["%s %s" % (path, self.sum_of(path)) for path in files]
        return hashlib.sha256("\0".join(parts).encode("utf-8", "replace")).hexdigest()

    def asked(self, words, function):
        """What function() says, or has said. Raises what that raises."""
        key = self.key(words)
        self.used.add(key)
        if not isinstance(self.known.get(key), str):
            self.known[key] = function()
            self.changed = True
        return self.known[key]

    def write(self):
        """Where there is a directory that can be written to."""
        if not self.changed or not os.path.isdir(os.path.dirname(self.path)):
            return
        if len(self.known) > MOST:
            self.known = {key: self.known[key] for key in self.used}
        with contextlib.suppress(OSError):
            safe.write_whole(self.path, json.dumps(self.known))

    def named_in_file(self, path, seen):
        """Paths of the files that a file and those it includes name, and its own."""
        if path in seen:
            return seen
        seen.add(path)
        if os.path.getsize(path) < LARGE and (path == self.base
                                              or path.endswith(".prm")):
            self.named_in(safe.read_text(path) or "", seen)
        return seen

    def named_in(self, text, seen):
        for line in text.splitlines():
            words = set(re.split(r"[\s,;:\"'=#]+", line))
            words.add(line.partition("=")[2].partition("#")[0].strip())
            words.add(line.partition("include")[2].strip().strip("\"'"))
            for path in (os.path.join(folder, word) for word in words if word
                         for folder in self.folders):
                if os.path.isfile(path):
                    self.named_in_file(os.path.normpath(path), seen)
        return seen

    def sum_of(self, path):
        if path not in self.sums:
            known = os.stat(path)
            self.sums[path] = safe.checksum_of(path) if known.st_size <= LARGE \
                else "%d %d" % (known.st_size, known.st_mtime_ns)
        return self.sums[path]
