# SPDX-License-Identifier: GPL-2.0-or-later
"""How sure a critical value is: the bisection of every variation of a run. Python's
own library only."""
import math

from . import variations


def runs_of(source, program, entries):
    """{name: settings} of all runs and their variations; a variation of the entry that
    is varied would be none, and is the user's to leave out."""
    found = {}
    for name in source.runs:
        found[name] = source.runs[name]
        for variation in source.allowed(name, program, entries):
            found["%s_%s" % (name, variations.case_name(variation))] = source.varied(
                name, variation)
    return found


def middle(bracket):
    return 0.5 * (bracket.low + bracket.high)


def families(names):
    """{run: its variations} of names of runs_of(), by the beginnings of the names."""
    found = {}
    for name in names:
        parent = next((run for run in found if name.startswith(run + "_")), None)
        found.setdefault(parent or name, []).append(name)
    return {run: members[1:] for run, members in found.items()}


def group_of(name):
    """The group of the name of a variation; of a parameter without its direction."""
    known = (group.replace("/", "_over_").replace(" ", "_")
             for group in variations.NUMERICS)
    return next((group for group in known if name.startswith(group + "_")),
                name.rpartition("_")[0])


def report(critical):
    """Lines: each run with the differences of its variations and their sum as
    squares."""
    brackets, text = critical.brackets(), ""
    for run, members in families(brackets).items():
        text += "%s: %g\n" % (run, middle(brackets[run]))
        largest = {}
        for name in members:
            change = middle(brackets[name]) - middle(brackets[run])
            text += "  %-24s %+g\n" % (name[len(run) + 1:], change)
            group = group_of(name[len(run) + 1:])
            largest[group] = max(largest.get(group, 0.), abs(change))
        if members:
            text += "  all together: +- %.2g, each bracket +- %.2g\n" % (
                math.sqrt(sum(value**2 for value in largest.values())),
                0.5 * critical.width)
    return text
