#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Damages the shipped cases at random and looks at what the program makes of
them.

    mutate.py EXECUTABLE MPIRUN [--number 500] [--seed N] [--ranks 1,2]
              [--cases PART,PART] [--only INDEX] [--jobs 1] [--keep DIRECTORY]

The cases run coarse and short (CASES). Mutant i of a seed is always the same
(mutations.py has the operators). A run may take any course, but

* the exit status is 0, 2, 3, 4, 5 or 6, with one message where it is 2 or 4 and at
  most one where it is 3,
* nothing of the inside is seen: no trace, no uncaught exception, no signal,
* it ends: asked to stop after TIME_LIMIT it does so,
* summary.json is JSON, and every number in a CSV is finite.

A mutant that asks for more memory or time than it gets (a mesh of 1e9 cells) is
counted as "too large". Prints every offence; exit status 1 when there is one.
"""
import argparse
import collections
import concurrent.futures
import contextlib
import csv
import math
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile

from cases import ROOT
from compare import number, strict_json
from mutations import damaged_option, mutate
from processes import MESSAGE, descendants, environment, name_of

for _folder in ("bad_input", "parameters"):
    sys.path.insert(0, str(ROOT / "tests" / _folder))
from run_bad_inputs import INSIDE  # noqa: E402
from run_two_steps import SHORT, first_step  # noqa: E402

TIME_LIMIT = 20  # s
STATUSES = {0, 2, 3, 4, 5, 6}
# name: what makes it coarse besides SHORT
CASES = {
    "parameters/epdm/punctured_strip.prm": [
        "Geometry/Punctured strip/Cell size=3", "Mesh/Refined surroundings=",
        "Mesh/Adaptive levels=1", "Model/Length scale=2"],
    "parameters/benchmarks/cooks_membrane.prm": [],
    "parameters/benchmarks/l_shaped_panel.prm": [],
    "parameters/benchmarks/multiple_cracks_heterogeneous.prm": [],
    "parameters/benchmarks/notched_tension.prm": [],
    "parameters/benchmarks/sneddon_2d.prm": [
        "Mesh/Refined boxes=", "Model/Length scale=2*h"],
    "parameters/benchmarks/three_point_bending.prm": [],
    "parameters/three_dimensions/slit_cube.prm": [],
    "parameters/three_dimensions/block_with_inclusion.prm": [],
    "tests/regression/fluid_growing_crack.prm": [],
    "tests/regression/slit_square_adaptive.prm": [],
    "tests/regression/strip_3d.prm": [],
}


class Mutant:
    """A damaged case; the same for the same seed and index. Negative indices
    are the cases themselves, which must be good."""

    def __init__(self, seed, index, cases):
        if index < 0:
            self.index, self.name, self.operators = index, cases[index], []
            self.text = (ROOT / self.name).read_bytes()
            self.options = settings(self.name)
            return
        chance = random.Random("%d:%d" % (seed, index))
        self.index = index
        self.name = chance.choice(sorted(cases))
        text, coarse = (ROOT / self.name).read_text(), settings(self.name)
        self.options, self.operators = list(coarse), []
        if chance.random() < 0.2:
            self.options.insert(chance.randrange(len(coarse) + 1),
                                damaged_option(chance, text))
            self.operators = ["option"]
        if not self.operators or chance.random() < 0.3:
            text, operators = mutate(chance, text)
            self.operators += operators
        self.text = text.encode("utf-8", errors="replace")


def settings(name):
    """What makes a case coarse and short: two steps."""
    path = ROOT / name
    entries = dict(each.split("=", 1) for each in
                   [*SHORT.get(path.name, []), *CASES[name]])
    entries["Load stepping/End time"] = "%.15g" % (2. * first_step(path))
    entries["Output/Wall time limit"] = "8"
    return ["%s=%s" % each for each in entries.items()]


def limit_memory():
    """A mutant must not take the machine down."""
    size = 6 * 2 ** 30
    resource.setrlimit(resource.RLIMIT_AS, (size, size))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def send(process, program, number_of_signal):
    pids = [process.pid] if name_of(process.pid) == program else []
    pids += [pid for pid, _ in descendants(process.pid) if name_of(pid) == program]
    for pid in pids:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, number_of_signal)


def run(command, folder, options):
    """(exit status, stdout, stderr, None or how it did not end by itself)."""
    program = os.path.basename(options.executable)
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        process = subprocess.Popen(
            command, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
            env=environment(OMPI_MCA_odls_base_sigkill_timeout="0"),
            start_new_session=True,
            preexec_fn=None if options.sanitized else limit_memory)
        late = None
        for late, sent in ((None, signal.SIGUSR1), ("stopped", signal.SIGKILL)):
            try:
                process.wait(timeout=options.time_limit)
                break
            except subprocess.TimeoutExpired:
                send(process, program, sent)
        else:
            late = "killed"
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(timeout=10)
            process.kill()  # an mpirun that waits for ranks that are gone
            process.wait()
        texts = []
        for file in (out, err):
            file.seek(0)
            texts.append(file.read().decode(errors="replace"))
    return (process.returncode, *texts, late)


def finite_table(path):
    with open(path, encoding="utf-8", errors="replace") as stream:
        lines = [line for line in csv.reader(stream)
                 if line and not line[0].startswith("#")]
    for line in lines[1:]:
        if len(line) != len(lines[0]):
            yield "%s: %d columns, header %d" % (path.name, len(line), len(lines[0]))
        for name, text in zip(lines[0], line):
            value = number(text)
            if value is not None and not math.isfinite(value):
                yield "%s: %s is %s" % (path.name, name, text)


def files_are_good(results):
    for path in results.glob("*.csv"):
        yield from finite_table(path)
    if (results / "summary.json").exists():
        try:
            strict_json(results / "summary.json")
        except ValueError as error:
            yield "summary.json: %s" % error


def offences(status, out, err, results):
    if status not in STATUSES:
        yield "exit status %s" % status
    n_messages = (out + err).count(MESSAGE)
    if n_messages != (status in (2, 4)) and (status, n_messages) != (3, 1):
        yield "exit status %s with %d messages" % (status, n_messages)
    for text in INSIDE.findall(out + err):
        yield "a user sees '%s'" % text
    if results.exists():
        yield from files_are_good(results)


def too_large(status, err, late):
    """Whether a mutant asked for more than it got."""
    return late == "killed" or (
        status not in STATUSES and
        re.search(r"bad_alloc|[Oo]ut of memory|[Cc]annot allocate", err))


def examine(mutant, options, ground):
    """(mutant, exit status or "too large", offences)."""
    place = pathlib.Path(tempfile.mkdtemp(dir=ground))
    for name in ("meshes", "parameters"):  # as seen from the file, and from here
        shutil.copytree(ROOT / name, place / name)
    path = place / mutant.name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(mutant.text)
    ranks = options.ranks[mutant.index % len(options.ranks)]
    words = [os.path.abspath(options.executable), mutant.name,
             "--output", "mutant-results"]
    for option in mutant.options:
        words += ["--set", option]
    if ranks > 1:
        words = [options.mpirun, "-n", str(ranks), *words]
    status, out, err, late = run(words, place, options)
    if too_large(status, err, late):
        found, status = [], "too large"
    else:
        found = list(offences(status, out, err, place / "mutant-results"))
        # 5 and 6: a slow machine, on which it was asked to stop
        if mutant.index < 0 and status not in (0, 5, 6):
            found.append("the case itself: exit status %d" % status)
    if found:
        found.append("| " + (err or out).strip()[-options.tail:])
        if options.keep:
            shutil.copytree(place, os.path.join(options.keep, "%d-%d" % (
                options.seed, mutant.index)), dirs_exist_ok=True)
    if options.only is not None:
        print(" ".join("'%s'" % word for word in words))
        print(mutant.text.decode(errors="replace"), out, err, sep="\n")
    shutil.rmtree(place)
    return mutant, status, found


def read_options():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("executable")
    parser.add_argument("mpirun")
    parser.add_argument("--number", type=int, default=500)
    parser.add_argument("--seed", type=int,
                        default=random.SystemRandom().randrange(10 ** 6))
    parser.add_argument("--ranks", default="1,2", type=lambda text: [
        int(word) for word in text.split(",")])
    parser.add_argument("--cases", default="", help="parts of names")
    parser.add_argument("--only", type=int, help="this mutant, with all it says")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--keep", help="a directory for what went wrong")
    parser.add_argument("--time-limit", type=float, default=TIME_LIMIT)
    parser.add_argument("--tail", type=int, default=1000,
                        help="characters of an offender's words")
    parser.add_argument("--sanitized", action="store_true",
                        help="no limit of memory, which sanitizers reserve")
    return parser.parse_args()


def main():
    options = read_options()
    print("seed %d" % options.seed, flush=True)
    parts = options.cases.split(",")
    cases = [name for name in CASES if any(part in name for part in parts)]
    indices = range(-len(cases), options.number) if options.only is None else [options.only]
    mutants = [Mutant(options.seed, index, cases) for index in indices]
    endings, n_failed = collections.Counter(), 0
    with tempfile.TemporaryDirectory() as ground, \
            concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for mutant, status, found in pool.map(
                lambda each: examine(each, options, ground), mutants):
            endings[str(status)] += 1
            n_failed += bool(found)
            if found:
                print("OFFENCE of mutant %d of %s (%s):" % (
                    mutant.index, mutant.name, ", ".join(mutant.operators)))
                for text in found:
                    print("      " + text.replace("\n", "\n      | "), flush=True)
    for status, count in sorted(endings.items()):
        print("%5d ended with %s" % (count, status))
    n_cases = sum(each.index < 0 for each in mutants)
    print("%d cases and %d mutants of them, %d with offences"
          % (n_cases, len(mutants) - n_cases, n_failed))
    return 1 if n_failed or not mutants else 0


if __name__ == "__main__":
    sys.exit(main())
