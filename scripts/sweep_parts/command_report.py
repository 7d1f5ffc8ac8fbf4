# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py report: OUTPUT/report.html, a page of the whole sweep: table with states,
all curves, all cracks, links. Whole at any time, also while the sweep goes on."""
import os
import time

from report_parts import safe
from study_parts import drawing
from study_parts.errors import StudyError

HELP = "write OUTPUT/report.html: states, curves and cracks of all cases"
OPENS_ITSELF = True
SHORTEST = 1.  # s, between two pages
OPTIONS = (
    ("--every", "SECONDS", "again and again, until every case is complete or failed",
     {"type": float}),
    ("--pages", None, "a page of each case as well, OUTPUT/pages/NAME.html"))


def run(arguments, _):
    if arguments.every is not None and not arguments.every >= SHORTEST:
        raise StudyError("--every: expected at least %g seconds, found %g"
                         % (SHORTEST, arguments.every))
    drawing.require()
    from study_parts import sweep_page

    from . import study
    while True:
        opened = study.opened(arguments)
        over = write(opened, opened.chosen(arguments.only), arguments.pages, sweep_page)
        if over or arguments.every is None:
            return 0
        try:
            time.sleep(arguments.every)
        except KeyboardInterrupt:
            return 0


def write(opened, cases, with_pages, sweep_page):
    """Whether nothing more is to come."""
    os.makedirs(opened.output, exist_ok=True)
    if with_pages:
        sweep_page.write_pages(opened, cases)
    text, over = sweep_page.written(opened, cases)
    path = os.path.join(opened.output, "report.html")
    safe.write_whole(path, text)
    print(path, flush=True)
    return over
