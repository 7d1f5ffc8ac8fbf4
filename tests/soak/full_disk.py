#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs into a full disk, of several sizes, and what they leave.

    full_disk.py EXECUTABLE MPIRUN [--sizes 10] [--ranks 1,2] [--seed N]
                 [--kinds limit,tmpfs]

limit  no file may become larger than this (RLIMIT_FSIZE, as `ulimit -f`): on
       one rank from the start, on several from the first row on, since Open
       MPI has files of its own to write in the start-up
tmpfs  a small file system of its own, where mounting is allowed (as root, or
       in a name space of the user)

A run has to end with exit status 4 and one message, or to succeed where the
space is enough: never by a signal, and never not at all. With space again it is
resumed, or started anew when no checkpoint had been written, and has to give
the results of a run that had space all along. Prints every offence; exit
status 1 when there is one.
"""
import argparse
import collections
import contextlib
import os
import pathlib
import random
import resource
import subprocess
import sys
import tempfile
import time

import cases
from compare import Difference, compare
from processes import MESSAGE, descendants, environment, name_of

sys.path.insert(0, str(cases.ROOT / "tests" / "bad_input"))
from run_bad_inputs import INSIDE  # noqa: E402

TIME_LIMIT = 300  # s, on a loaded machine
NAMESPACE = "MIXED_CRACKS_OWN_MOUNTS"


def size_of(directory):
    """(bytes of all files in whole pages, bytes of the largest file)."""
    sizes = [os.path.getsize(os.path.join(parent, name))
             for parent, _, names in os.walk(directory) for name in names]
    return sum((size + 4095) // 4096 * 4096 for size in sizes), max(sizes)


def limit_ranks(process, program, directory, size):
    """Limit the files of the ranks once the first row is there."""
    table = directory / "statistics.csv"
    while process.poll() is None:
        if table.exists() and table.read_text().count("\n") > 1:
            for pid, _ in descendants(process.pid):
                if name_of(pid) == program:
                    with contextlib.suppress(ProcessLookupError):
                        resource.prlimit(pid, resource.RLIMIT_FSIZE,
                                         (size, resource.RLIM_INFINITY))
            return
        time.sleep(0.01)


def run(options, ranks, directory, *words, limit=None):
    """(exit status or None when it took too long, stdout, stderr)."""
    program = os.path.abspath(options.executable)
    command = [program, *cases.arguments(cases.STRIP_SHORT, directory, *words)]
    if ranks > 1:
        command = [options.mpirun, "-n", str(ranks), *command]

    def limit_all():
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY))

    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        # the limit holds for files, which these must not be
        pipes = [subprocess.Popen(["cat"], stdin=subprocess.PIPE, stdout=file)
                 for file in (out, err)]
        process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=pipes[0].stdin,
            stderr=pipes[1].stdin, env=environment(), start_new_session=True,
            preexec_fn=limit_all if limit and ranks == 1 else None)
        if limit and ranks > 1:
            limit_ranks(process, os.path.basename(program), directory, limit)
        try:
            status = process.wait(timeout=TIME_LIMIT)
        except subprocess.TimeoutExpired:
            status = None
            for pid, _ in descendants(process.pid):
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, 9)
            process.kill()
            process.wait()
        for pipe in pipes:
            pipe.stdin.close()
            pipe.wait()
        texts = []
        for file in (out, err):
            file.seek(0)
            texts.append(file.read().decode(errors="replace"))
    return (status, *texts)


def examine_full(status, out, err):
    """Offences of a run on a disk that may be too small."""
    if status == 0:
        return
    if status is None:
        yield "still running after %d s" % TIME_LIMIT
    elif status != 4:
        yield "exit status %d, expected 4" % status
    if err.count(MESSAGE) != 1 or MESSAGE in out:
        yield "%d messages, expected 1" % (out + err).count(MESSAGE)
    for text in INSIDE.findall(out + err):
        yield "a user sees '%s'" % text


def examine_again(options, ranks, directory, whole):
    """Offences of what comes when there is space again."""
    sealed = list((directory / "checkpoint").glob("generation-*/seal.txt"))
    word = "--resume" if sealed else "--overwrite"
    status, out, err = run(options, ranks, directory, word)
    if status != 0:
        yield "%s with space: exit status %s: %s" % (word, status, out + err)
        return
    yield from differences(directory, whole, word + " with space")


def differences(directory, whole, what):
    try:
        compare(directory, whole)
    except (Difference, OSError, ValueError, KeyError) as difference:
        yield "%s: %s" % (what, difference)


@contextlib.contextmanager
def small_disk(kind, folder, size):
    """(directory for results, largest file or None, function that makes room)."""
    if kind == "limit":
        with tempfile.TemporaryDirectory(dir=folder) as place:
            yield pathlib.Path(place) / "results", size, lambda: None
        return
    with tempfile.TemporaryDirectory(dir=folder) as place:
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=%d" % size, "tmpfs",
                        place], check=True)
        try:
            yield pathlib.Path(place) / "results", None, lambda: subprocess.run(
                ["mount", "-o", "remount,size=1g", place], check=True)
        finally:
            subprocess.run(["umount", "-l", place], check=True)


def attempt(options, kind, size, ranks, folder, whole):
    """(how it ended, offences)."""
    with small_disk(kind, folder, size) as (directory, limit, make_room):
        status, out, err = run(options, ranks, directory, limit=limit)
        offences = list(examine_full(status, out, err))
        sealed = any((directory / "checkpoint").glob("generation-*/seal.txt"))
        if status == 0:
            offences += differences(directory, whole, "ended well")
        else:
            make_room()
            offences += examine_again(options, ranks, directory, whole)
        if offences:
            offences.append("| " + err.strip()[-1500:])
        return "status %s, %s" % (status, "a checkpoint" if sealed
                                  else "no checkpoint"), offences


def may_mount():
    """Whether this process may; else it starts itself anew where it may."""
    if os.environ.get(NAMESPACE):
        return True
    unshare = ["unshare", "-m"] if os.geteuid() == 0 else ["unshare", "-rm"]
    probe = [*unshare, "mount", "-t", "tmpfs", "tmpfs", tempfile.gettempdir()]
    try:
        if subprocess.run(probe, stderr=subprocess.DEVNULL).returncode != 0:
            return False
    except OSError:
        return False
    os.environ[NAMESPACE] = "1"
    os.execvp(unshare[0], [*unshare, sys.executable, *sys.argv])
    return False


def read_options():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("executable")
    parser.add_argument("mpirun")
    parser.add_argument("--sizes", type=int, default=10)
    parser.add_argument("--ranks", default="1,2", type=lambda text: [
        int(word) for word in text.split(",")])
    parser.add_argument("--seed", type=int,
                        default=random.SystemRandom().randrange(10 ** 6))
    parser.add_argument("--kinds", default="limit,tmpfs",
                        type=lambda text: text.split(","))
    return parser.parse_args()


def main():
    options = read_options()
    if "tmpfs" in options.kinds and not may_mount():
        print("mounting is not allowed here: no tmpfs")
        options.kinds.remove("tmpfs")
    print("seed %d" % options.seed, flush=True)
    chance, endings, n_failed = random.Random(options.seed), collections.Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        whole = pathlib.Path(folder) / "whole"
        status, out, err = run(options, 1, whole)
        if status != 0:
            sys.exit("the run with space failed:\n" + out + err)
        total, largest = size_of(whole)
        for kind in options.kinds:
            full = total if kind == "tmpfs" else largest
            for number in range(options.sizes):
                # the last is large enough
                size = 4096 + int(1.5 * full * (number + chance.random())
                                  / options.sizes)
                for ranks in options.ranks:
                    ending, offences = attempt(options, kind, size, ranks,
                                               folder, whole)
                    n_failed += bool(offences)
                    endings[kind + ": " + ending] += 1
                    print("%s of %d bytes, %d ranks: %s" % (kind, size, ranks,
                                                            ending))
                    for text in offences:
                        print("  OFFENCE: " + text)
                    sys.stdout.flush()
    for what, count in sorted(endings.items()):
        print("%5d %s" % (count, what))
    print("%d runs, %d with offences; all results take %d bytes, the largest "
          "file %d" % (sum(endings.values()), n_failed, total, largest))
    return 1 if n_failed else 0


if __name__ == "__main__":
    sys.exit(main())
