# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py collect: one table of all cases; exit status 0 only when all are complete."""
import os
import sys

from . import collect

HELP = "write the table OUTPUT/sweep.csv of all cases"
OPTIONS = (
    ("--mixed", None, "with results of several revisions of the program, and results of "
     "other parameters where there are no new ones"),)


def run(arguments, study):
    rows = collect.rows_of(list(study.cases.values()), arguments.mixed)
    mixture = collect.mixture_of(rows)
    if mixture and not arguments.mixed:
        print("sweep.py: refused: %s; --mixed writes the table all the same" % mixture,
              file=sys.stderr)
        return 1
    os.makedirs(study.output, exist_ok=True)
    print(collect.write(study, rows))
    lines = collect.incomplete(rows)
    for line in lines:
        print(line, file=sys.stderr)
    complete = sum(row["state"] == "complete" for row in rows)
    print("%d of %d cases are complete" % (complete, len(rows)))
    return 0 if complete == len(rows) else 1
