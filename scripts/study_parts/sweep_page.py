# SPDX-License-Identifier: GPL-2.0-or-later
"""The page of a sweep, OUTPUT/report.html: state and results of each case, all curves
in one figure, all cracks. Whole at any time, also while the sweep goes on, when a
browser loads it anew every half minute."""
import collections
import os
import urllib.parse

from report_parts import curves, page, safe
from sweep_parts import cases, collect, progress, studies, study_cracks, study_curves

REFRESH = "<meta http-equiv=\"refresh\" content=\"%d\">\n"
SECONDS = 30
MOST = 48  # curves, and cracks, in one figure
FOLDER = "pages"
# of the results, in the table; all of them are in sweep.csv
SHOWN = (("outcome", "outcome"), ("start", "start"),
         ("peak_force_N", "peak, N"), ("displacement_at_peak_mm", "at, mm"),
         ("steps", "steps"), ("wall_time_s", "s"))
OTHERS = (("sweep.csv", "table"), ("comparison.md", "comparison"),
          ("bisect.csv", "brackets"), ("uncertainty.md", "uncertainty"),
          ("uncertainty.svg", "uncertainty.svg"), ("comparison", "comparison"))


def shown(value):
    return "%.4g" % value if isinstance(value, float) else \
        "" if value is None else str(value)


def link(text, *names):
    return "<a href=\"%s\">%s</a>" % (
        page.escaped(urllib.parse.quote("/".join(names))), page.escaped(text))


def path_of_page(study, case):
    return os.path.join(study.output, FOLDER, case.name + ".html")


def name_cell(study, case):
    """The name: leads to the page of the case, or to its directory."""
    if os.path.isfile(path_of_page(study, case)):
        return link(case.name, FOLDER, case.name + ".html")
    return link(case.name, os.path.relpath(case.directory, study.output)) \
        if os.path.isdir(case.directory) else page.escaped(case.name)


def state_cell(case, row):
    """State and why; of a run that goes on how far it is."""
    words, state = row["reason"], row["state"]
    if state == "running":
        share = progress.share_done(case.directory)
        words = "" if share is None else "%.0f %% of the load" % (100. * share)
    return "<span class=\"state %s\">%s</span> %s" % (state, state,
                                                      page.escaped(words or ""))


def table_of(study, chosen, rows):
    swept = list(collect.swept_titles(chosen).values())
    head = ["case", "state"] + swept + [title for _, title in SHOWN] \
        + ["case id", "revision"]
    columns = swept + [column for column, _ in SHOWN]
    cells = [[name_cell(study, case), state_cell(case, row)] + [
        page.escaped(value) for value in [shown(row.get(name)) for name in columns]
        + [row["case_id"][:12], shown(row.get("revision"))]]
        for case, row in zip(chosen, rows)]
    return page.element("div", page.table_of(cells, map(page.escaped, head), "sweep"),
                        "wide")


def others_of(study):
    """Links to what other commands have written."""
    found = [link(text, name) for name, text in OTHERS
             if os.path.exists(os.path.join(study.output, name))]
    return page.note(" · ".join(found)) if found else ""


def runs_of(chosen):
    """[StudyRun] of the cases that have rows, at most MOST, and how many are left
    out."""
    there = [case for case in chosen
             if os.path.isfile(case.path("statistics.csv"))]
    return [studies.StudyRun(case.name, case.directory) for case in there[:MOST]], \
        max(0, len(there) - MOST)


def left_out(number):
    return page.note("%d more are left out; --only chooses others." % number) \
        if number else ""


def curve_part(runs, n_more):
    if not any(run.has_curve for run in runs):
        return page.section("Force and displacement",
                            page.note("No case has a force yet."))
    drawing = curves.svg_of(study_curves.draw(runs, "", False, []), "curves")
    return page.section("Force and displacement", drawing + left_out(n_more))


def crack_part(runs, n_more):
    if not any(study_cracks.fields_at_end(run)[0] is not None for run in runs):
        return page.section("Cracks", page.note("No case has fields yet."))
    png = study_cracks.png_of(runs, 5, "")
    return page.section("Cracks", page.figures_of([(png, "", "100%")])
                        + left_out(n_more), "long")


def counts_of(rows):
    counts = collections.Counter(row["state"] for row in rows)
    return ", ".join("%d %s" % (counts[state], state)
                     for state in reversed(cases.STATES) if counts[state])


def is_over(rows):
    return all(row["state"] in ("complete", "failed") for row in rows)


def foot(study):
    return page.footer("%s, revision %s" % (os.path.basename(study.program.path),
                                            study.program.revision),
                       study.output, "%H:%M:%S")


def written(study, chosen):
    """(the page as text, whether nothing more is to come)."""
    rows, remarks = collect.rows_of(chosen), []
    title = os.path.splitext(os.path.basename(study.sweep.path))[0]
    runs, n_more = runs_of(chosen)
    middle = page.guarded(remarks, "The curves", curve_part, runs, n_more) \
        + page.guarded(remarks, "The cracks", crack_part, runs, n_more)
    mixture = collect.mixture_of(rows)
    remarks += [mixture] if mixture else []
    body = "<header><p class=\"kind\">Sweep</p><h1>%s</h1><p>%d cases: %s</p></header>" \
        % (page.escaped(title), len(rows), page.escaped(counts_of(rows)))
    body += page.aside(remarks) + page.section(
        "Cases", table_of(study, chosen, rows) + others_of(study), "long") \
        + middle + foot(study)
    text = page.in_frame(title, body)
    if not is_over(rows):
        text = text.replace("<head>\n", "<head>\n" + REFRESH % SECONDS, 1)
    return text, is_over(rows)


def write_pages(study, chosen):
    """A page for each case with rows that is newer than its page."""
    os.makedirs(os.path.join(study.output, FOLDER), exist_ok=True)
    for case in chosen:
        target = path_of_page(study, case)
        page_time, *times = (
            os.path.getmtime(path) if os.path.isfile(path) else 0.
            for path in (target, case.path("statistics.csv"), case.path("summary.json")))
        if times[0] and page_time <= max(times):
            safe.write_whole(target, page.written(case.directory))
