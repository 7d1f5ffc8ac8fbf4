#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Run variants of one parameter file and collect them into a table.

    scripts/sweep.py parameters/epdm/notch_heights.sweep --ranks 1 --jobs 4
    scripts/sweep.py FILE.sweep --list             the commands, one line per run
    scripts/sweep.py FILE.sweep --table-only       the table of what there is
    scripts/sweep.py FILE.sweep -- --set "Mesh/Adaptive levels=1"
    scripts/sweep.py FILE.sweep -- --resume        go on from the checkpoints

A sweep file (scripts/sweep_parts/sweep_file.py has the rules):

    base   = punctured_strip.prm
    common = --set "Geometry/Punctured strip/Notch height=6"
    coarse = --set "Mesh/Adaptive levels=1"
    fine   = --set "Mesh/Adaptive levels=2"

Each run gets a directory OUTPUT/NAME: what mixed-cracks writes, screen.txt, and
sweep_command.txt with the command. A run that ended with exit status 0, with the
same options and the same base file, is not repeated unless --again is given. A
run that fails does not stop the others.

OUTPUT/sweep.csv has a row per run; what is not known is left empty:
  exit_status            of the run
  separated, outcome, start
                         what became of the body, and where the crack started;
                         separated is empty in 3-d, where cracks are not traced
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
are. One sweep at a time has OUTPUT; a second one is refused.

Exit status: 0; 1 when a run failed; 2 for wrong input or usage. Needs Python's
own library only.
"""
import argparse
import fnmatch
import os
import shutil
import signal
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from sweep_parts import lock, runner, sweep_file, table  # noqa: E402


def found_program():
    """The program of this source tree, beside this installation, or on the PATH."""
    here = os.path.dirname(os.path.realpath(__file__))
    for path in (os.path.join(here, os.pardir, "build", "mixed-cracks"),
                 os.path.join(here, os.pardir, os.pardir, os.pardir, "bin",
                              "mixed-cracks")):
        if os.access(path, os.X_OK):
            return os.path.normpath(path)
    return shutil.which("mixed-cracks")


def positive(text):
    if not text.isdigit() or int(text) == 0:
        raise argparse.ArgumentTypeError("expected a number of at least 1, found '%s'"
                                         % text)
    return int(text)


def read_arguments(words):
    parser = argparse.ArgumentParser(
        description="Run variants of one parameter file and collect them into a "
                    "table.", usage="%(prog)s SWEEP_FILE [options] [-- options for "
                                    "every run]")
    parser.add_argument("sweep_file", metavar="SWEEP_FILE")
    parser.add_argument("--ranks", type=positive, default=1, metavar="N",
                        help="MPI ranks of each run (1)")
    parser.add_argument("--jobs", type=positive, default=1, metavar="J",
                        help="runs at a time (1)")
    parser.add_argument("--output", metavar="DIR",
                        help="directory of the results (results/NAME OF THE FILE)")
    parser.add_argument("--only", nargs="+", metavar="NAME",
                        help="these runs only; patterns as 'fine_*' are allowed")
    parser.add_argument("--program", metavar="PATH",
                        help="mixed-cracks (the one in build/, or on the PATH)")
    parser.add_argument("--mpirun", metavar="COMMAND", default="mpirun",
                        help="launcher that takes -n N (mpirun); '' for none")
    parser.add_argument("--list", action="store_true",
                        help="print one line with the command of each run")
    parser.add_argument("--table-only", action="store_true",
                        help="run nothing, write the table of what there is")
    parser.add_argument("--again", action="store_true",
                        help="repeat runs that are complete as well")
    extra = []
    if "--" in words:
        extra = words[words.index("--") + 1:]
        words = words[:words.index("--")]
    arguments = parser.parse_args(words)
    arguments.extra = extra
    if arguments.output is None:
        stem = os.path.splitext(os.path.basename(arguments.sweep_file))[0]
        arguments.output = os.path.join("results", stem)
    return arguments


def require_program(arguments):
    """An absolute path, for the commands are to work anywhere."""
    if arguments.program is None:
        arguments.program = found_program()
        if arguments.program is None:
            raise sweep_file.SweepError(
                "mixed-cracks is neither in build/ nor on the PATH; name it with "
                "--program")
    elif os.sep not in arguments.program:
        arguments.program = shutil.which(arguments.program) or arguments.program
    arguments.program = os.path.abspath(arguments.program)
    if not os.access(arguments.program, os.X_OK):
        raise sweep_file.SweepError("--program: '%s' cannot be run"
                                    % arguments.program)
    launcher = arguments.mpirun.split()
    if launcher and not arguments.list and shutil.which(launcher[0]) is None:
        raise sweep_file.SweepError("--mpirun: there is no '%s'" % launcher[0])


def chosen_names(sweep, patterns):
    for pattern in patterns or ():
        if not fnmatch.filter(sweep.runs, pattern):
            raise sweep_file.SweepError("--only: there is no run '%s' in %s; there are %s"
                                        % (pattern, sweep.path, ", ".join(sweep.runs)))
    return [name for name in sweep.runs if patterns is None or
            any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)]


def run_those_left(runs, arguments):
    """Runs what is not complete; whether all that was wanted was run."""
    left = [run for run in runs if arguments.again or not run.is_complete()]
    if len(left) < len(runs):
        print("%d of %d runs are complete already" % (len(runs) - len(left), len(runs)),
              flush=True)
    workers = runner.Runner(arguments.jobs)
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGUSR1):
        signal.signal(number, workers.stop)
    n_done = 0

    def done(run, seconds):
        nonlocal n_done
        n_done += 1
        status = table.exit_status_of(run.directory,
                                      table.summary_of(run.directory))
        status = run.status if status is None else status
        print("[%d/%d] %s: exit status %d after %.0f s%s"
              % (n_done, len(left), run.name, status, seconds,
                 "" if run.status == 0 else "; " + runner.last_words(run)), flush=True)

    workers.all(left, done)
    if workers.stopped:
        print("stopped; %d runs were not started" % (len(left) - n_done))
    return not workers.stopped


def main():
    arguments = read_arguments(sys.argv[1:])
    try:
        sweep = sweep_file.Sweep(arguments.sweep_file)
        names = chosen_names(sweep, arguments.only)
        if not arguments.table_only:
            require_program(arguments)
        runs = [runner.Run(sweep, name, arguments) for name in names]
    except (sweep_file.SweepError, OSError) as error:
        print("sweep.py: %s" % error, file=sys.stderr)
        return 2
    if arguments.list:
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # as in "--list | head -1"
        for run in runs:
            print(runner.shlex_joined(run.command))
        return 0
    whole = True
    if arguments.table_only:
        for run in runs:
            if run.differs():
                print("%s: was run with other options or another base file"
                      % run.name, file=sys.stderr)
        return write_table(sweep, names, runs, whole, arguments)
    try:
        os.makedirs(arguments.output, exist_ok=True)
        held = lock.Lock(arguments.output)
    except (lock.InUse, OSError) as error:
        print("sweep.py: %s" % error, file=sys.stderr)
        return 2
    if held.warning:
        print("sweep.py: warning: %s" % held.warning, file=sys.stderr)
    try:
        whole = run_those_left(runs, arguments)
        return write_table(sweep, names, runs, whole, arguments)
    finally:
        held.release()


def write_table(sweep, names, runs, whole, arguments):
    """Returns the exit status."""
    # the table is of the whole file, also when only some have been run now
    rows = [table.row_of(name, os.path.join(arguments.output, name))
            for name in sweep.runs]
    try:
        os.makedirs(arguments.output, exist_ok=True)
        table.write_table(os.path.join(arguments.output, "sweep.csv"), rows)
    except OSError as error:
        print("sweep.py: %s" % error, file=sys.stderr)
        return 2
    print(os.path.join(arguments.output, "sweep.csv"))
    failed = [row["name"] for row in rows
              if row["name"] in names and row["exit_status"] not in (0, None)]
    failed += [run.name for run in runs
               if run.status not in (0, None) and run.name not in failed]
    if failed:
        print("failed: " + ", ".join(failed), file=sys.stderr)
    return 1 if failed or not whole else 0


if __name__ == "__main__":
    sys.exit(main())
