#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Stands in for mixed-cracks: writes what a run writes, in no time.

Entries, by --set or as lines 'Entry = value' of the base file:
  Model/Fail=N         leave with exit status N (9: as if it had crashed)
  Model/Wait=1         wait for SIGUSR1 or SIGTERM
  Model/Launcher=1     make 1 of a failure's exit status, as mpirun does
  Model/Steps=N        N steps with a checkpoint after each; 0, the default, is all
                       at once
  Model/Seconds=T      of each step
  Model/Gate=F         before step 4, wait until there is a file F beside the
                       base
  Model/Killed=1       is killed when everything has been written
  Model/Stuck=N        no step after the N-th comes to its end: exit status 5
  Mesh/File name=F     a file that is read, relative to the base
  Output/...           do not count in the id
  Load stepping/...    count in --case-id=full only
Every start, step and end is noted in events.txt beside the output directory: time,
name of the directory, process, word, step.
"""
import fcntl
import hashlib
import json
import os
import signal
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                os.pardir, "report"))

DEFAULTS = {"Load stepping/First step": "1",
            "Model/Steps": "0", "Model/Seconds": "0", "Model/Stuck": "-1"}
ASKED = []
GATED = 4


def fail(status, message):
    print("mixed-cracks: error: " + message, file=sys.stderr)
    sys.exit(status)


def read_words(words):
    """(settings, options, output, base)."""
    settings, options, output, base = {}, set(), None, None
    while words:
        word = words.pop(0)
        if word == "--set":
            entry, _, value = words.pop(0).partition("=")
            if entry in settings:
                fail(2, "%s is set twice" % entry)
            settings[entry] = value
        elif word == "--output":
            output = words.pop(0)
        elif word.startswith("--"):
            options.add(word)
        else:
            base = word
    return settings, options, output, base


def effective(base, settings):
    found = {}
    with open(base, encoding="utf-8") as stream:
        for line in stream:
            entry, equals, value = line.partition("#")[0].partition("=")
            if equals:
                found[entry.strip()] = value.strip()
    found.update(settings)
    if "bad" in found.values():
        fail(2, "an entry is 'bad'; allowed is a number")
    return found


def canonical(value):
    try:
        return "%.17g" % float(value)
    except ValueError:
        return " ".join(value.split())


def case_id(base, parameters, scope):
    out = ("Output/",) + (() if scope == "full" else ("Load stepping/",))
    counted = {}
    for entry, value in parameters.items():
        if entry == "Mesh/File name":
            path = os.path.join(os.path.dirname(base), value)
            if not os.path.exists(path):
                fail(2, "Mesh/File name: there is no file '%s'" % path)
            with open(path, "rb") as stream:
                counted[entry] = hashlib.sha256(stream.read()).hexdigest()
        elif not entry.startswith(out) \
                and canonical(value) != DEFAULTS.get(entry):
            counted[entry] = canonical(value)
    text = json.dumps(counted, sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()[:32]


class Run:
    def __init__(self, output, parameters, base):
        self.gate = os.path.join(os.path.dirname(base),
                                 parameters.get("Model/Gate", ""))
        self.output, self.parameters = output, parameters
        self.seal = os.path.join(output, "checkpoint", "generation-0", "seal.txt")
        os.makedirs(os.path.dirname(self.seal), exist_ok=True)

    def note(self, word, step=0):
        path = os.path.join(os.path.dirname(self.output), "events.txt")
        with open(path, "a", encoding="utf-8") as stream:
            stream.write("%.6f %s %d %s %d\n" % (
                time.time(), os.path.basename(self.output), os.getpid(), word, step))

    def checkpoint(self, step):
        with open(self.seal + ".new", "w", encoding="utf-8") as stream:
            stream.write("%d\n" % step)
        os.replace(self.seal + ".new", self.seal)

    def checkpointed(self):
        try:
            with open(self.seal, encoding="utf-8") as stream:
                return int(stream.read())
        except OSError:
            return 0

    def write_rows(self, step):
        rows = ["step,displacement_mm,force_y_N"]
        rows += ["%d,%d,%d" % (k, 2 * k, 3 * k) for k in range(step + 1)]
        with open(os.path.join(self.output, "statistics.csv"), "w") as stream:
            stream.write("\n".join(rows) + "\n")

    def steps(self, first):
        seconds = float(self.parameters.get("Model/Seconds", 0.))
        stuck = int(self.parameters.get("Model/Stuck", -1))
        for step in range(first + 1, int(self.parameters["Model/Steps"]) + 1):
            end = time.monotonic() + seconds
            while time.monotonic() < end and not ASKED:
                time.sleep(min(0.02, seconds))
            while not ASKED and step == GATED and not os.path.exists(
                    self.gate):
                time.sleep(0.05)
            if ASKED or step > stuck >= 0:
                self.stop(step - 1)
            self.note("step", step)
            self.write_rows(step)
            self.checkpoint(step)

    def stop(self, step):
        """As asked: with a checkpoint, or before there was anything to go on from."""
        self.note("stopped", step)
        if step == 0:
            sys.exit(6)
        made_up().write_summary(self.output, exit_status=5,
                                    exit_reason="asked to stop")
        sys.exit(5)

    def wait(self):
        with open(os.path.join(self.output, "waits.txt"), "w") as stream:
            stream.write("%d\n" % os.getpid())
        end = time.monotonic() + 600.
        while not ASKED and time.monotonic() < end:
            time.sleep(0.02)
        made_up().write_statistics(self.output)
        self.checkpoint(1)
        self.stop(1)

    def finish(self):
        parameters = self.parameters
        status = int(parameters.get("Model/Fail", "0"))
        if int(parameters.get("Model/Steps", 0)) == 0:
            made_up().write_statistics(self.output)
        if status == 9:  # as if it had crashed: no summary
            print("mixed-cracks: error: no memory is left")
            sys.exit(status)
        changes = {} if status else {"outcome": "past the hole",
                                     "outcome_start": "notch"}
        made_up().write_summary(
            self.output, exit_status=status, thickness_mm=2.,
            displacement_at_peak_mm=20., end_displacement_mm=22., rejected_steps=4,
            **changes)
        print("a line of the log")
        self.note("end")
        if "Model/Killed" in parameters:
            os.kill(os.getpid(), signal.SIGKILL)
        if status:
            print("mixed-cracks: error: the smallest step is reached",
                  file=sys.stderr)
        sys.exit(1 if "Model/Launcher" in parameters else status)


def made_up():
    """What writes a run of no program; late, for it takes longer than the rest."""
    import synthetic_run
    return synthetic_run


def locked(run):
    """The lock that a run has on its directory, as long as it is referred to."""
    stream = open(os.path.join(run.output, ".lock"), "a+", encoding="utf-8")
    try:
        fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        run.note("refused")
        fail(4, "'%s' is in use" % run.output)
    return stream


def main():
    settings, options, output, base = read_words(sys.argv[1:])
    if "--version" in options:
        print("mixed-cracks 0 (revision %s)" % os.environ.get("FAKE_REVISION", "fake"))
        return
    parameters = effective(base, settings)
    for option in options:
        if option.startswith("--case-id"):
            print(case_id(base, parameters, option.partition("=")[2]))
            return
    for number in (signal.SIGUSR1, signal.SIGTERM):
        signal.signal(number, lambda *_: ASKED.append(1))
    run = Run(output, parameters, base)
    held = locked(run)
    run.note("start")
    with open(os.path.join(output, "settings.txt"), "w") as stream:
        stream.writelines("%s=%s\n" % pair for pair in sorted(settings.items()))
    if "Model/Wait" in parameters:
        run.wait()
    if int(parameters.get("Model/Steps", 0)):
        run.steps(run.checkpointed() if "--resume" in options else 0)
    run.finish()
    held.close()


if __name__ == "__main__":
    main()
