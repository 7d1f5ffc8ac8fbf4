#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Studies: variants of one parameter file, here or on a cluster, and their table.

    scripts/sweep.py plan FILE.sweep               the cases, their ids and states
    scripts/sweep.py run FILE.sweep --jobs 4       what is missing, on this machine
    scripts/sweep.py submit FILE.sweep             the same as an array of jobs
    scripts/sweep.py task FILE.sweep NAME          one case, within any job
    scripts/sweep.py status FILE.sweep             what is queued, running, failed
    scripts/sweep.py collect FILE.sweep            the table
    scripts/sweep.py clean FILE.sweep              what nothing leads to any more
    scripts/sweep.py report FILE.sweep             a page of it all, report.html
    scripts/sweep.py compare FILE.sweep --reference experiments.csv
    scripts/sweep.py bisect FILE.sweep --vary "ENTRY" LOW HIGH --on outcome --to WIDTH
    scripts/sweep.py uncertainty CASE.prm          one change at a time
    scripts/sweep.py FILE.sweep --jobs 4           the same as run
    scripts/sweep.py run FILE.sweep -- --set "Mesh/Adaptive levels=1"

How sweep files are written stands at the head of scripts/sweep_parts/sweep_file.py;
doc/studies.md shows how to work with them.

Each case has a directory OUTPUT/cases/ID, with what mixed-cracks writes, screen.txt,
and case.json, which says how it came about; OUTPUT/NAME is a link to it. The id is
made of the parameters in effect and the files read. A complete case is read-only and
not run again; other parameters are another case.

OUTPUT/sweep.csv has a row per case; what is not known is left empty:
  name, state            new, running, stopped, failed, stale (there are results of
                         other parameters only) or complete
  reason                 why it is not complete
  case_id, revision, job, exit_status
                         what it is, and which program and jobs have made it
  ...                    what the sweep varies
  separated, outcome, start
                         what became of the body, and where the crack started
  force_fell             whether the force ended below its bound
  peak_force_N, displacement_at_peak_mm, end_displacement_mm,
  remaining_force_fraction, steps
                         as in summary.json
  rejected_steps, coupling_iterations, factorizations
                         totals of the run
  refinements, dofs      of the last accepted step
  proportional_steps     accepted load steps (step >= 1) before the first one
                         whose force / displacement has fallen by more than 2 %
                         below that of step 1; all of them when none has
  wall_time_s

SIGINT (Ctrl-C), SIGTERM, SIGHUP and SIGUSR1 stop the runs that are going on, with
checkpoints, and start no more; a second Ctrl-C, two seconds later, ends them as they
are. One sweep at a time has OUTPUT, and one process a case; a second one is refused.

Exit status: 0; 1 when a case failed or is missing, or a tolerance of compare is not
met; 2 for wrong input or usage; 5 when bisect or uncertainty was stopped and the same
command goes on; of task that of the case, see there. Needs Python's own library only.
"""
import argparse
import importlib
import itertools
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from report_parts import options  # noqa: E402
from report_parts.errors import InputError  # noqa: E402
from sweep_parts import lock, study  # noqa: E402

# Each module, command_plan and so on, has HELP, OPTIONS (report_parts/options.py), and
# run(arguments, study), which returns the exit status; with OPENS_ITSELF for study None.
COMMANDS = {name: importlib.import_module("sweep_parts.command_" + name) for name in (
    "plan", "run", "submit", "task", "status", "collect", "clean", "compare", "bisect",
    "uncertainty", "report")}
FOR_ALL = (
    ("--output", "DIR", "directory of the results (results/NAME OF THE FILE)"),
    ("--program", "PATH", "mixed-cracks (the one in build/, or on the PATH)"),
    ("--only", "NAME", "these cases only; patterns as 'fine_*' are allowed",
     {"nargs": "+"}))


def read_arguments(words):
    parser = argparse.ArgumentParser(
        description="Variants of one parameter file, here or on a cluster.",
        epilog="sweep.py FILE is sweep.py run FILE.")
    commands = parser.add_subparsers(metavar="COMMAND", dest="command", required=True)
    for name, module in COMMANDS.items():
        one = commands.add_parser(name, help=module.HELP, description=module.HELP)
        one.add_argument("file", metavar="FILE")
        options.add(one, FOR_ALL)
        options.add(one, module.OPTIONS)
    own = list(itertools.takewhile(lambda word: word != "--", words))
    extra, words = words[len(own) + 1:], own
    if words and words[0] not in COMMANDS and words[0] not in ("-h", "--help"):
        if words[0].isalpha() and not os.path.exists(words[0]):
            parser.error("'%s' is neither a command (%s) nor a file"
                         % (words[0], ", ".join(COMMANDS)))
        words = ["run"] + words
    arguments, rest = parser.parse_known_args(words)
    # argparse takes names directly behind the file only
    if rest and not (hasattr(arguments, "names") and rest[0][:1] != "-"):
        parser.error("there is no '%s'" % rest[0])
    if rest:
        arguments.names += rest
    arguments.extra = extra
    return arguments


def main():
    arguments = read_arguments(sys.argv[1:])
    module = COMMANDS[arguments.command]
    try:
        return module.run(arguments, None if hasattr(module, "OPENS_ITSELF")
                          else study.opened(arguments))
    except (InputError, lock.InUse, OSError) as error:
        print("sweep.py: %s" % error, file=sys.stderr)
        return getattr(error, "exit_status", 2)


if __name__ == "__main__":
    sys.exit(main())
