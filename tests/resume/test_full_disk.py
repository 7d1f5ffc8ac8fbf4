#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A disk that is full ends a run with exit status 4 and one message, on any
number of ranks, and the checkpoint before serves.

usage: test_full_disk.py EXECUTABLE MPIRUN

With a limit on the size of files (ulimit -f), and, where a file system of a
given size may be mounted, on one of those.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

from runs import Runner, environment, errors_in, generations, rows, same_rows

SETTINGS = ["Load stepping/End time=6e-3", "Output/Checkpoint every=1",
            "Output/Fields every=1",
            "Load stepping/Stop when force falls below=0"]
# of what a whole run takes: hardly anything fits, ..., all but the last steps
PARTS = (0.05, 0.4, 0.7, 0.95)
PAGE = 4096  # bytes, in which a tmpfs counts


def full(run, directory, prefix, settings, ranks):
    """Run with something full, and check how it ends; whether it was full."""
    command = [*prefix, *run.command(directory, settings=settings, ranks=ranks)]
    done = subprocess.run(command, stdout=subprocess.PIPE, env=environment(),
                          stderr=subprocess.STDOUT, text=True, timeout=300,
                          check=False)
    text = done.stdout
    assert "Signal" not in text and "terminate called" not in text, text
    assert "internal error" not in text and "Abort" not in text, text
    if done.returncode == 0:
        return False
    assert done.returncode == 4, (done.returncode, text)
    assert len(errors_in(text)) == 1, text
    return True


def goes_on(run, directory, settings, whole):
    """From the checkpoint before, once there is room."""
    if not any((folder / "seal.txt").exists()
               for folder in (directory / "checkpoint").glob("generation-*")):
        return False
    run(directory, "--resume", settings=settings)
    same_rows(rows(directory), rows(whole))
    return True


def size_of_files(run, folder, settings, whole):
    """ulimit -f: bash counts in kB. The largest file is that of the values.
    Without mpirun, which has larger files of its own."""
    largest = max(path.stat().st_size
                  for path in generations(whole)[0].iterdir()) // 1024
    n_full = 0
    for kilobytes in (3, largest // 2, largest - 1, largest + 80):
        directory = folder / ("limit %d" % kilobytes)
        prefix = ["bash", "-c", "ulimit -f %d; exec \"$@\"" % kilobytes, "bash"]
        n_full += full(Runner(run.executable, ()), directory, prefix, settings, 1)
        goes_on(run, directory, settings, whole)
    assert 3 <= n_full < 4 or largest < 6, n_full


def may_mount():
    return subprocess.run(
        ["unshare", "-m", "mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs",
         "/mnt"], stderr=subprocess.DEVNULL, check=False).returncode == 0


def pages_of(directory):
    return sum((path.stat().st_size + PAGE - 1) // PAGE
               for path in directory.rglob("*") if path.is_file())


def size_of_disk(run, folder, settings, whole, ranks):
    """The disk is there for the run alone; what is on it is copied from it."""
    n_full = n_continued = 0
    undisturbed = folder / ("whole %d" % ranks)
    run(undisturbed, settings=settings, ranks=ranks)
    for part in PARTS:
        kilobytes = int(part * pages_of(undisturbed)) * PAGE // 1024
        disk, copy = folder / "disk", folder / ("copy %d %d" % (ranks, kilobytes))
        disk.mkdir(exist_ok=True)
        prefix = ["unshare", "-m", "bash", "-c",
                  "mount -t tmpfs -o size=%dk tmpfs '%s' || exit 99; \"$@\"; "
                  "status=$?; cp -r '%s/run' '%s' 2>/dev/null; exit $status"
                  % (kilobytes, disk, disk, copy), "bash"]
        n_full += full(run, disk / "run", prefix, settings, ranks)
        n_continued += goes_on(run, copy, settings, whole)
        shutil.rmtree(copy, ignore_errors=True)
    print("ranks %d: %d of %d disks were full, %d runs went on"
          % (ranks, n_full, len(PARTS), n_continued), flush=True)
    assert n_full == len(PARTS) and n_continued >= 1, (n_full, n_continued)


def main():
    run = Runner(sys.argv[1], sys.argv[2:])
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        whole = folder / "whole"
        run(whole, settings=SETTINGS)
        size_of_files(run, folder, SETTINGS, whole)
        if not may_mount():
            print("no file system may be mounted: only limits on files tested")
            return
        for ranks, form in ((1, "VTU"), (2, "both"), (3, "VTU")):
            settings = [*SETTINGS, "Output/Field format=" + form]
            size_of_disk(run, folder, settings, whole, ranks)


if __name__ == "__main__":
    main()
