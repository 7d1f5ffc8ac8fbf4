# SPDX-License-Identifier: GPL-2.0-or-later
"""What the studies have in common: options, and running cases here or by jobs.
Python's own library only."""
import sys

from sweep_parts import collect, command_run, resources, runner
from sweep_parts.resources import positive

from .errors import StudyError


class Stopped(StudyError):
    """Somebody asked the runs to stop; the same command goes on."""


def add_options(parser):
    resources.add_options(parser, ("ranks", "launcher"))
    parser.add_argument("--jobs", type=positive, default=1, metavar="J",
                        help="runs at a time (1)")


class Runs:
    """Runs the cases of studies here, J at a time."""

    def __init__(self, arguments, program):
        self.arguments = arguments
        arguments.again = False  # as run has it
        given = resources.resources_of(arguments)
        words = "mpirun" if given["launcher"] is None else given["launcher"]
        self.launch = runner.Launch(program, resources.launcher_words(words),
                                    given["ranks"])

    def bring(self, study, names=None):
        """Runs what is missing of a study and writes its table. Raises Stopped."""
        chosen = list(study.cases.values()) if names is None \
            else [study.cases[name] for name in names]
        held = study.claim()
        if held.warning:
            print("sweep.py: warning: %s" % held.warning, file=sys.stderr)
        try:
            _, whole = command_run.run_those_left(chosen, self.launch, self.arguments)
            collect.write(study, collect.rows_of(list(study.cases.values())))
        finally:
            held.release()
        if not whole:
            raise Stopped("stopped; the same command goes on from there")
