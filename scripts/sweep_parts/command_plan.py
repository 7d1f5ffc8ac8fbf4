# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py plan: what there is to do."""
import signal

from . import collect

HELP = "list the cases with their ids and states; runs nothing, changes nothing"
OPTIONS = (
    ("--names", None, "the names of what is missing only, one a line, for starters of "
     "other kinds"),)


def run(arguments, study):
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # as in "plan | head"
    chosen = study.chosen(arguments.only)
    states = {case.name: case.state() for case in chosen}
    if arguments.names:
        for case in chosen:
            if states[case.name][0] not in ("complete", "running"):
                print(case.name)
        return 0
    print_table(chosen, states, study)
    collect.print_counts(chosen, (state for state, _ in states.values()))
    print("program: %s, revision %s" % (study.program.path, study.program.revision))
    return 0


def print_table(chosen, states, study):
    width = max(len(case.name) for case in chosen)
    for case in chosen:
        state, reason = states[case.name]
        same = [other.name for other in study.cases.values()
                if other.id == case.id and other.name != case.name]
        words = [reason] if reason else []
        if same:
            words.append("the same case as " + ", ".join(same))
        print("%-*s  %-16s  %-8s  %s" % (width, case.name, shown(case.id), state,
                                         "; ".join(words)))


def shown(case_id):
    """Enough of an id to find it; its suffix, which tells apart what the program
    does not, in full."""
    start, dash, suffix = case_id.partition("-")
    return start[:7] + dash + suffix if dash else start[:16]
