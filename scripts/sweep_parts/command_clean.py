# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py clean: frees the space of what is not wanted any more. Without an option
it says what there is."""
import contextlib
import os
import re
import shutil

from . import cases, lock

HELP = "list, or remove, cases to which nothing leads any more, failed ones, checkpoints"
DIRECTORY = re.compile(r"[0-9a-f]{8,128}(-[0-9a-f]{8})?(\.\d+)?$")

OPTIONS = (
    ("--stale", None, "remove cases of other parameters than the present ones"),
    ("--failed", None, "remove cases that have failed, so that they begin anew"),
    ("--checkpoints", None, "remove the checkpoints of complete cases"))


def run(arguments, study):
    with contextlib.closing(study.claim()):
        every = list(study.cases.values())
        present = {case.id for case in every}
        act("stale", [path for path in directories(study.output)
                      if os.path.basename(path) not in present], arguments.stale)
        chosen = {case.id: case for case in study.chosen(arguments.only)}.values()
        act("failed", [case.directory for case in chosen
                       if case.state()[0] == "failed"], arguments.failed)
        act("checkpoint", [case.path("checkpoint") for case in chosen
                           if case.is_complete() and os.path.isdir(
                               case.path("checkpoint"))], arguments.checkpoints)
        remove_loose_links(study.output)
    return 0


def directories(output):
    folder = os.path.join(output, cases.CASES)
    names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
    return [os.path.join(folder, name) for name in names if DIRECTORY.match(name)
            and os.path.isdir(os.path.join(folder, name))]


def act(word, paths, wanted):
    """Removes the directories, or says which there are."""
    size = sum(map(size_of, paths))
    print("%s: %d, %.1f MB%s" % (word, len(paths), size / 1e6,
                                 ", removed" if wanted and paths else ""))
    for path in paths:
        if wanted:
            remove(path)
        else:
            print("  " + path)


def size_of(directory):
    return sum(os.lstat(path).st_size for path in cases.each_path(directory))


def remove(path):
    """Unless somebody is at work there, by the lock of a case and of the program."""
    case = path if os.path.basename(path) != "checkpoint" else os.path.dirname(path)
    try:
        with contextlib.closing(lock.Lock(os.path.dirname(case),
                                          os.path.basename(case) + ".lock")):
            lock.require_free(case)
            cases.make_writable(case)
            shutil.rmtree(path)
            if path != case:
                cases.make_read_only(case)
    except lock.InUse as error:
        print("  left alone: %s" % error)


def remove_loose_links(output):
    for name in os.listdir(output):
        path = os.path.join(output, name)
        if os.path.islink(path) and not os.path.exists(path) \
                and os.path.dirname(os.readlink(path)) == cases.CASES:
            os.remove(path)
