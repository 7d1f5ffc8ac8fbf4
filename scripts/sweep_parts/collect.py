# SPDX-License-Identifier: GPL-2.0-or-later
"""The table of a sweep: a row for each case, with its state, and results only where
they are those of the present parameters."""
import collections
import os

from report_parts import safe

from . import cases, table

# of each case, before the swept values and the results
IDENTITY = ("name", "state", "reason", "case_id", "revision", "job", "exit_status")
TABLE = "sweep.csv"


def titles_of(swept):
    """{title of a grid or entry: title of its column}: the last part where that is
    enough to tell it from the others and from other columns."""
    last = [title.split("/")[-1] for title in swept]
    return {title: short if last.count(short) == 1
            and short not in IDENTITY + table.RESULTS else title
            for title, short in zip(swept, last)}


def swept_titles(chosen):
    """{title: column} of what differs among the cases, in order."""
    found = safe.grouped((pair for case in chosen for pair in case.swept.items()),
                         lambda pair: pair[0])
    return titles_of([title for title, pairs in found.items()
                      if len(set(pairs)) > 1 or len(pairs) < len(chosen)
                      or len(chosen) == 1])


def row_of(case, titles, mixed=False):
    """{column: value}; mixed: whether a stale case has the results that are there."""
    state, reason = case.state()
    row = {"name": case.name, "state": state, "reason": reason, "case_id": case.id}
    row.update((column, case.swept.get(title)) for title, column in titles.items())
    directory, record = case.directory, case.record()
    if state == "stale" and mixed:
        row["case_id"] = case.linked()
        directory = os.path.join(case.output, cases.CASES, row["case_id"])
        record = cases.record_of(directory)
    if record.get("pieces"):
        row.update(table.results_of(directory))
        row.update(of_pieces(record["pieces"]))
    return row


def of_pieces(pieces):
    """What is known of how the results came about."""
    def joined(key):
        values = [str(piece[key]) for piece in pieces if piece.get(key)]
        return " ".join(dict.fromkeys(values)) or None

    return {"exit_status": pieces[-1].get("exit_status"), "revision": joined("revision"),
            "job": joined("job")}


def rows_of(chosen, mixed=False):
    """[{column: value}] of cases, in order."""
    titles = swept_titles(chosen)
    return [row_of(case, titles, mixed) for case in chosen]


def mixture_of(rows):
    """Of results of several revisions, in words, or ''."""
    revisions = {}
    for row in rows:
        for revision in (row.get("revision") or "").split():
            revisions.setdefault(revision, []).append(row["name"])
    if len(revisions) < 2:
        return ""
    return "results of several revisions of the program: " + "; ".join(
        "%s (%s)" % (revision, shortened(names)) for revision, names
        in revisions.items())


def print_counts(chosen, states):
    """How many cases are in which state, and whether revisions are mixed."""
    print("%d cases: %s" % (len(chosen), ", ".join(
        "%d %s" % (number, state)
        for state, number in collections.Counter(states).items())))
    mixture = mixture_of(rows_of(chosen))
    if mixture:
        print(mixture)


def shortened(names, most=5):
    return ", ".join(names[:most]) + (" and %d more" % (len(names) - most)
                                      if len(names) > most else "")


def write(study, chosen_rows):
    """Writes the table of the sweep; returns its path."""
    path = os.path.join(study.output, TABLE)
    columns = IDENTITY + tuple(swept_titles(study.cases.values()).values()) \
        + table.RESULTS
    safe.write_whole(path, table.csv_text(columns, (
        [row.get(column) for column in columns] for row in chosen_rows)))
    return path


def incomplete(rows):
    """One line for each state that is not complete, with names and reasons."""
    lines = []
    for state in cases.STATES[:-1]:
        found = [row for row in rows if row["state"] == state]
        if not found:
            continue
        if state in ("failed", "stale"):
            lines += ["%s: %s: %s" % (state, row["name"], row["reason"])
                      for row in found]
        else:
            lines.append("%s: %s" % (state, shortened([row["name"] for row in found])))
    return lines
