#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs that are started without mpirun at the same time do not disturb each other.

usage: test_many_at_once.py EXECUTABLE [ROUNDS [AT A TIME]]

Prints how many there were and how many failed or said what they do not say alone.
"""
import pathlib
import subprocess
import sys
import tempfile

import common


def main():
    rounds, at_a_time = (int(word) for word in (sys.argv[2:] + [2, 20][len(sys.argv[2:]):]))
    common.set_environment()
    failed, noisy, words = 0, 0, set()
    with tempfile.TemporaryDirectory() as temporary:
        for number in range(rounds):
            processes = []
            for each in range(at_a_time):
                directory = pathlib.Path(temporary) / ("%d.%d" % (number, each))
                # every second one writes files with MPI, the others come and go
                command = [sys.argv[1], "--version"] if each % 2 else [
                    sys.argv[1], str(common.CASE), "--output", str(directory)]
                if not each % 2:
                    command += common.as_options(common.COARSE + [
                        "Load stepping/End time=0.4", "Output/Checkpoint every=1",
                        "Output/Field format=VTU"])
                processes.append(subprocess.Popen(
                    command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                    text=True))
            for process in processes:
                errors = process.communicate(timeout=600)[1]
                failed += process.returncode != 0
                noisy += bool(errors.strip())
                words |= set(errors.splitlines()[:1])
    print("%d runs, %d failed, %d wrote to the error stream"
          % (rounds * at_a_time, failed, noisy))
    for word in sorted(words)[:3]:
        print(word)
    return 1 if failed or noisy else 0


if __name__ == "__main__":
    sys.exit(main())
