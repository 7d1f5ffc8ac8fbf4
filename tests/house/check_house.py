#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The rules of the house (doc/architecture.md), checked on the sources.

    tests/house/check_house.py [directory of the project]

Room arrows, mirrored headers, file sizes, licence lines, and formatting when
clang-format 14 is there. Prints the table of rooms and every offence; exit
status 1 when there is one.
"""
import collections
import glob
import os
import re
import shutil
import subprocess
import sys

# What a room may include besides itself; main.cc may include everything.
ALLOWED = {
    "simulation": ("steps", "output", "cracks", "problem", "assembly", "solvers",
                   "discretization", "model", "input", "base"),
    "steps": ("assembly", "solvers", "discretization", "model", "base"),
    "output": ("cracks", "assembly", "discretization", "model", "base"),
    "cracks": ("discretization", "base"),
    "problem": ("input", "model", "discretization", "base"),
    "assembly": ("model", "discretization", "base"),
    "solvers": ("base",),
    "discretization": ("base",),
    "model": ("base",),
    "input": ("base",),
    "base": (),
}
MAIN = "main.cc"
LARGEST_FILE = 400
LICENCE = "SPDX-License-Identifier: GPL-2.0-or-later"
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([a-z_]+)/([A-Za-z0-9_/.]+)[>"]')


def allowed(room, target):
    """Whether files of a room may include headers of another one."""
    return room in (target, MAIN) or target in ALLOWED.get(room, ())


def sources(root):
    """[(path from root, room or None, name in the room)], sorted."""
    found = []
    for top in ("include", "source"):
        for folder, _, names in os.walk(os.path.join(root, top)):
            for name in names:
                if not name.endswith((".h", ".cc", ".h.in")):
                    continue
                path = os.path.relpath(os.path.join(folder, name), root)
                parts = path.split(os.sep)
                room = parts[1] if len(parts) > 2 else None
                found.append((path, room, "/".join(parts[2:])))
    return sorted(found)


def includes_of(lines):
    """[(line number, room, name in the room)] of the headers of ours."""
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if match and match.group(1) in ALLOWED:
            yield (number,) + match.group(1, 2)


def check_arrows(path, room, lines):
    if room is not None and room not in ALLOWED:
        yield "%s: there is no room '%s'" % (path, room)
        return
    for number, target, name in includes_of(lines):
        if not allowed(room or MAIN, target):
            yield "%s:%d: %s must not include <%s/%s>" \
                % (path, number, room, target, name)


def cycles(arrows):
    """Of {room: rooms it includes}: the sets of rooms that include each other,
    directly or by way of others."""
    def reached(room):
        found, waiting = set(), [room]
        while waiting:
            new = set(arrows.get(waiting.pop(), ())) - found
            found |= new
            waiting += new
        return found

    reach = {room: reached(room) for room in arrows}
    return sorted({tuple(sorted(other for other in reach
                                if other in reach[room] and room in reach[other]))
                   for room in reach if room in reach[room]})


def count_includes(contents):
    """{room: {room: number of includes}} without those within a room, of
    [(room or None for main.cc, lines)]."""
    counts = {room: collections.Counter() for room in (MAIN,) + tuple(ALLOWED)}
    for room, lines in contents:
        for _, target, _ in includes_of(lines):
            if target != (room or MAIN):
                counts.setdefault(room or MAIN, collections.Counter())[target] += 1
    return counts


def print_rooms(counts):
    print("room            includes of other rooms")
    for room, targets in counts.items():
        print("%-15s %4d  %s" % (room, sum(targets.values()), ", ".join(
            "%s %d" % (target, targets[target])
            for target in ALLOWED if targets[target] > 0)))
    climbing = sum(number for room, targets in counts.items()
                   for target, number in targets.items()
                   if not allowed(room, target))
    print("cycles: %d, includes that climb: %d" % (len(cycles(counts)), climbing))


def header_stems(stem):
    """Of the header a source mirrors: its own name, or for a part of a large
    one (mesh_scan_gmsh.cc) what comes before an underscore (mesh_scan.h)."""
    words = stem.split("_")
    return ["_".join(words[:n]) for n in range(len(words), 0, -1)]


def read_lines(path):
    with open(path, encoding="utf-8", errors="replace") as stream:
        return stream.read().splitlines()


def check_file(root, path, room, name, lines):
    yield from check_arrows(path, room, lines)
    if not lines or LICENCE not in lines[0]:
        yield "%s:1: the first line is not '// %s'" % (path, LICENCE)
    if len(lines) > LARGEST_FILE:
        yield "%s: %d lines; split what is longer than %d" \
            % (path, len(lines), LARGEST_FILE)
    if path.endswith(".cc") and room is not None:
        if not any(os.path.isfile(os.path.join(root, "include", room, stem + ".h"))
                   for stem in header_stems(os.path.splitext(name)[0])):
            yield "%s: its header include/%s/%s.h does not exist" \
                % (path, room, os.path.splitext(name)[0])
    if path.endswith(".h"):
        guard = "mixed_cracks_%s_%s_h" % (
            room, os.path.splitext(name)[0].replace("/", "_"))
        if "#ifndef " + guard not in lines:
            yield "%s: the include guard is not %s" % (path, guard)


def formatter():
    """clang-format 14, or None: other versions format differently."""
    for name in ("clang-format-14", "clang-format"):
        path = shutil.which(name)
        if path is None:
            continue
        version = subprocess.run([path, "--version"], stdout=subprocess.PIPE,
                                 universal_newlines=True).stdout
        if re.search(r"version 14\.", version):
            return path
    return None


def check_format(root):
    """One line per file that clang-format would change."""
    program = formatter()
    if program is None:
        print("clang-format 14 is not installed: formatting is not checked")
        return
    paths = [path for path, _, _ in sources(root) if not path.endswith(".in")]
    paths += [os.path.relpath(path, root) for path in
              glob.glob(os.path.join(root, "tests", "**", "*.cc"), recursive=True)]
    # one process for all files, which takes seconds, names those it would change
    process = subprocess.run([program, "--dry-run", "--Werror"] + paths, cwd=root,
                             stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                             universal_newlines=True)
    changed = set(re.findall(r"^(\S.*?):\d+:\d+: error: ", process.stderr, re.M))
    if process.returncode != 0 and not changed:
        yield "clang-format failed: " + process.stderr.strip()
    for path in sorted(changed):
        yield "%s: not formatted (clang-format -i %s)" % (path, path)


def check_scripts(root):
    """Scripts carry the licence line as well, within their first three lines."""
    for folder in ("scripts", "tests", ".ci"):
        for parent, _, names in os.walk(os.path.join(root, folder)):
            for name in names:
                path = os.path.join(parent, name)
                if not name.endswith((".py", ".sh", ".cc")) and "." in name:
                    continue
                with open(path, encoding="utf-8", errors="replace") as stream:
                    head = [stream.readline() for _ in range(3)]
                if head[0].startswith(("#!", "#", "//")) \
                        and not any(LICENCE in line for line in head):
                    yield "%s: no licence line" % os.path.relpath(path, root)


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    root = os.path.abspath(sys.argv[1] if len(sys.argv) > 1
                           else os.path.join(here, os.pardir, os.pardir))
    offences = []
    files = sources(root)
    if not files:
        offences.append("no sources below %s" % root)
    contents = []
    for path, room, name in files:
        lines = read_lines(os.path.join(root, path))
        contents.append((room, lines))
        offences += check_file(root, path, room, name, lines)
    counts = count_includes(contents)
    for cycle in cycles(counts):
        offences.append("rooms that include each other: " + ", ".join(cycle))
    offences += check_scripts(root)
    offences += check_format(root)
    print_rooms(counts)
    for offence in offences:
        print(offence)
    print("%d files, %d offences" % (len(files), len(offences)))
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
