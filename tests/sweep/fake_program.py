#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Stands in for mixed-cracks: writes what a run writes, in no time.

Model/Fail=N leaves with exit status N; Model/Wait=1 waits for SIGUSR1,
Model/Launcher=1 makes 1 of a failure's exit status as mpirun does. Every start is
noted in started.txt beside the output directory.
"""
import os
import signal
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                os.pardir, "report"))
import synthetic_run  # noqa: E402


def stopped(output):
    synthetic_run.write_statistics(output)
    synthetic_run.write_summary(output, exit_status=5)
    sys.exit(5)


def main():
    words, settings, output, base = sys.argv[1:], {}, None, None
    while words:
        word = words.pop(0)
        if word == "--set":
            entry, _, value = words.pop(0).partition("=")
            if entry in settings:
                sys.exit("error: %s is set twice" % entry)
            settings[entry] = value
        elif word == "--output":
            output = words.pop(0)
        elif word.startswith("--"):
            settings[word] = ""
        else:
            base = word
    with open(base):
        pass
    os.makedirs(output, exist_ok=True)
    with open(os.path.join(os.path.dirname(output), "started.txt"), "a") as stream:
        stream.write(os.path.basename(output) + "\n")
    with open(os.path.join(output, "settings.txt"), "w") as stream:
        stream.writelines("%s=%s\n" % pair for pair in sorted(settings.items()))
    if "Model/Wait" in settings:
        signal.signal(signal.SIGUSR1, lambda *_: stopped(output))
        with open(os.path.join(output, "waits.txt"), "w") as stream:
            stream.write("%d\n" % os.getpid())
        time.sleep(600)
    synthetic_run.write_statistics(output)
    status = int(settings.get("Model/Fail", "0"))
    if status == 9:  # as if it had crashed: no summary
        print("mixed-cracks: error: no memory is left")
        sys.exit(status)
    changes = {} if status else {"outcome": "past the hole", "outcome_start": "notch"}
    synthetic_run.write_summary(
        output, exit_status=status, thickness_mm=2., displacement_at_peak_mm=20.,
        end_displacement_mm=22., rejected_steps=4, **changes)
    print("a line of the log")
    if status:
        print("mixed-cracks: error: the smallest step is reached", file=sys.stderr)
    sys.exit(1 if "Model/Launcher" in settings else status)  # as mpirun does


if __name__ == "__main__":
    main()
