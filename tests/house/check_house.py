#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The rules of the house (doc/architecture.md), checked on the sources.

    tests/house/check_house.py [directory of the project]

Room arrows, mirrored headers, file sizes, licence lines, and formatting when
clang-format 14 is there. Prints every offence; exit status 1 when there is one.
"""
import glob
import os
import re
import shutil
import subprocess
import sys

ROOMS = ("core", "model", "problem", "discretization", "assembly", "solvers",
         "output")
# What a room may include besides itself. "base" are the files of core that
# know nothing of the rest.
BASE = ("registry", "errors", "names")
ALLOWED = {
    "model": ("base",),
    "problem": ("model", "core"),
    "discretization": ("core",),
    "assembly": ("model", "discretization", "core"),
    "solvers": ("core",),
    "output": ("model", "discretization", "core"),
    "core": (),
}
# The hall: these files of core see everything.
HALL = ("simulation", "step")
LARGEST_FILE = 400
LICENCE = "SPDX-License-Identifier: GPL-2.0-or-later"
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([a-z_]+)/([A-Za-z0-9_/.]+)[>"]')


def is_hall(name):
    return any(name == word or name.startswith((word + "_", word + "."))
               for word in HALL)


def is_parameters(name):
    return name.startswith("parameters")


def holds_parameters(path):
    """Whether a header declares a parameter structure."""
    try:
        with open(path, encoding="utf-8", errors="replace") as stream:
            return "add_parameters" in stream.read()
    except OSError:
        return False


def allowed(room, name, target, target_name, with_parameters=False):
    """Whether the file `name` of `room` may include `target/target_name`, a
    header that declares parameters or not."""
    stem = os.path.splitext(target_name)[0]
    if room == target:
        # the hall may use the rest of core, not the other way round
        return room != "core" or is_hall(name) or not is_hall(stem) \
            or is_parameters(name)
    if room == "core":
        return is_hall(name) or (is_parameters(name) and with_parameters)
    if target == "core" and is_hall(stem):
        return False
    if target == "core" and stem in BASE and "base" in ALLOWED[room]:
        return True
    return target in ALLOWED[room]


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


def check_arrows(root, path, room, name, lines):
    if room is None:  # main.cc
        return
    if room not in ROOMS:
        yield "%s: there is no room '%s'" % (path, room)
        return
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if not match or match.group(1) not in ROOMS:
            continue
        target = os.path.join(root, "include", *match.group(1, 2))
        if not allowed(room, name, match.group(1), match.group(2),
                       holds_parameters(target)):
            yield "%s:%d: %s must not include <%s/%s>" \
                % (path, number, room, match.group(1), match.group(2))


def header_stems(stem):
    """Of the header a source mirrors: its own name, or for a part of a large
    one (mesh_scan_gmsh.cc) what comes before an underscore (mesh_scan.h)."""
    words = stem.split("_")
    return ["_".join(words[:n]) for n in range(len(words), 0, -1)]


def check_file(root, path, room, name):
    with open(os.path.join(root, path), encoding="utf-8", errors="replace") as stream:
        lines = stream.read().splitlines()
    yield from check_arrows(root, path, room, name, lines)
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
    for path in paths:
        process = subprocess.run([program, "--dry-run", "--Werror", path], cwd=root,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if process.returncode != 0:
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
    for path, room, name in files:
        offences += check_file(root, path, room, name)
    offences += check_scripts(root)
    offences += check_format(root)
    for offence in offences:
        print(offence)
    print("%d files, %d offences" % (len(files), len(offences)))
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
