# SPDX-License-Identifier: GPL-2.0-or-later
"""Bisections of several runs at a time: the values, the cases that carry them, and the
report. Python's own library only; bisection.py has the logic of one."""
from report_parts.safe import finite
from sweep_parts.table import csv_text

from . import bisection, derived
from .errors import StudyError

COLUMNS = ("run", "low", "high", "low_answer", "high_answer", "low_case", "high_case",
           "low_case_id", "high_case_id")


def case_name(run, value):
    return "%s_%.12g" % (run, value)


class Critical:
    """entry: what is varied; low, high, width: its range and how narrow the brackets
    are to be; question: bisection.Question; runs: {name: settings in full}; known:
    {name: {value: answer}}; wanted: {name: values} that have a case."""

    def __init__(self, entry, low, high, width, question, runs):
        self.entry, self.question, self.runs = entry, question, runs
        self.low, self.high, self.width = low, high, width
        self.known = {name: {} for name in runs}
        self.wanted = {name: [] for name in runs}

    def take_up(self, before):
        """Values that an earlier bisection has asked for, of its {case: settings}."""
        for name in self.runs:
            for case, settings in before.items():
                value = finite(dict(settings).get(self.entry))
                if value is not None and case == case_name(name, value) \
                        and self.low <= value <= self.high:
                    self.wanted[name].append(value)

    def next_values(self, at_once):
        """{run: values} to run next, about at_once in all; {} when all is known."""
        share = max(1, at_once // max(len(self.runs), 1))
        found = {}
        for name, known in self.known.items():
            try:
                values = bisection.next_values(known, self.low, self.high, self.width,
                                               share)
            except StudyError as error:
                raise StudyError("%s: %s" % (name, error))
            if values:
                found[name] = values
        return found

    def want(self, values):
        for name, more in values.items():
            self.wanted[name] += [v for v in more if v not in self.wanted[name]]

    def cases(self):
        """{case: settings} of all that is wanted, in order of the values."""
        found = {}
        for name, values in self.wanted.items():
            for value in sorted(values):
                settings = dict(self.runs[name], **{self.entry: "%.12g" % value})
                found[case_name(name, value)] = list(settings.items())
        return found

    def learn(self, study, tried=()):
        """Takes the answers of cases that are complete; those in tried that are not
        have none."""
        for name, values in self.wanted.items():
            for value in values:
                case = study.cases[case_name(name, value)]
                if case.is_complete():
                    self.known[name][value] = self.question.answer(case.summary())
                elif case.name in tried:
                    self.known[name][value] = None

    def brackets(self):
        return {name: bisection.bracket_of(known, self.low, self.high)
                for name, known in self.known.items()}


def report(critical, study):
    """Lines for a person."""
    lines = []
    for name, bracket in critical.brackets().items():
        low, high = (case_name(name, value) for value in bracket[:2])
        lines.append("%s: '%s' up to %g, '%s' from %g on: %s = %g +- %g" % (
            name, bracket.low_answer, bracket.low, bracket.high_answer, bracket.high,
            critical.entry.split("/")[-1], 0.5 * (bracket.low + bracket.high),
            0.5 * (bracket.high - bracket.low)))
        lines.append("  cases %s (%s) and %s (%s); %d runs" % (
            low, study.cases[low].id[:16], high, study.cases[high].id[:16],
            len(critical.known[name])))
        failed = sorted(v for v, answer in critical.known[name].items()
                        if answer is None)
        if failed:
            lines.append("  without an answer: %s" % ", ".join("%g" % v for v in failed))
        others = bisection.other_changes(critical.known[name], bracket)
        if others:
            lines.append("  '%s' again at %s: this is not the only change"
                         % (bracket.low_answer, ", ".join("%g" % v for v in others)))
    return lines


def table(critical, study):
    """The text of a CSV file, a row per run."""
    rows = []
    for name, bracket in critical.brackets().items():
        cases = [study.cases[case_name(name, value)] for value in bracket[:2]]
        rows.append([name, *("%.12g" % value for value in bracket[:2]), *bracket[2:],
                     *(case.name for case in cases), *(case.id for case in cases)])
    return csv_text(COLUMNS, rows)


def solve(critical, source, output, program, runs, at_once):
    """Runs what is needed until every bracket is narrow enough; the Study of all cases.
    runs: a here.Runs. What an earlier call has run is not run again."""
    critical.take_up(derived.runs_before("bisect", output))
    tried, study = set(), None
    while True:
        if any(critical.wanted.values()):
            study = derived.study_of("bisect", source, critical.cases(), output, program)
            critical.learn(study, tried)
        values = critical.next_values(at_once)
        if not values:
            return study
        critical.want(values)
        study = derived.study_of("bisect", source, critical.cases(), output, program)
        names = [case_name(name, value) for name, more in values.items()
                 for value in more]
        print(", ".join(names), flush=True)
        runs.bring(study, names)
        tried.update(names)
