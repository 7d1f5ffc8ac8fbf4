# SPDX-License-Identifier: GPL-2.0-or-later
"""How sure an answer is: peak, displacement at the peak and path of a case beside those
of its variations, and what numerics and parameters contribute.

The contribution of a group (variations.py) is its largest difference from the case;
those of groups that have nothing to do with each other are added as squares."""
import collections
import math

import numpy as np

from report_parts import crack_path

from . import polylines, variations
from .comparison_text import grid
from .errors import StudyError

QUANTITIES = (("peak", "N"), ("displacement", "mm"), ("path", "mm"))


# What a run came to. lines: [array (n, 2)] of the paths of its cracks.
Answer = collections.namedtuple("Answer", "peak displacement lines outcome")


def answer_of(run):
    """The Answer of a StudyRun; None where there is none, or no peak."""
    if run is None or run.peak is None:
        return None
    lines = [np.array(line) for line in
             crack_path.lines_at_end(run.results.directory) or ()]
    return Answer(run.peak[1], run.peak[0], lines, run.outcome)


class Difference:
    """Of a variation from the case: peak (N), displacement (mm), path: Apart or None,
    and whether outcome and start are the same. Without an answer all are None."""

    def __init__(self, variation, answer, base):
        self.variation, self.answer = variation, answer
        self.peak = self.displacement = self.path = self.same_outcome = None
        if answer is None or base is None:
            return
        self.peak = answer.peak - base.peak
        self.displacement = answer.displacement - base.displacement
        self.same_outcome = answer.outcome == base.outcome
        if answer.lines and base.lines:
            self.path = polylines.apart(answer.lines, base.lines)

    def of(self, quantity):
        """Size of the difference in one of QUANTITIES, or None."""
        if quantity == "path":
            return None if self.path is None else self.path.mean
        value = getattr(self, quantity)
        return None if value is None else abs(value)


class Uncertainty:
    """base: Answer of the case; differences: [Difference] in the order of running."""

    def __init__(self, base, differences):
        if base is None or base.peak is None:
            raise StudyError("the case itself has no peak: nothing to compare with")
        self.base, self.differences = base, differences

    def groups(self):
        return list(dict.fromkeys(d.variation.group for d in self.differences))

    def contribution(self, group, quantity):
        """Largest difference within the group, or None."""
        sizes = [d.of(quantity) for d in self.differences
                 if d.variation.group == group]
        return max((size for size in sizes if size is not None), default=None)

    def total(self, groups, quantity):
        """Root of the sum of the squares over groups, or None."""
        known = [value for value in (self.contribution(group, quantity)
                                     for group in groups) if value is not None]
        return math.sqrt(sum(value**2 for value in known)) if known else None

    def numerics(self):
        return [group for group in self.groups() if group in variations.NUMERICS]

    def parameters(self):
        return [group for group in self.groups() if group not in variations.NUMERICS]

    def missing(self):
        return [d.variation for d in self.differences if d.answer is None]


def shown(value, whole=None):
    """A size, and its share of a whole."""
    if value is None:
        return "–"
    text = "%.3g" % value
    return text if not whole else text + " (%.2g %%)" % (100. * value / abs(whole))


def signed(value, whole):
    return "–" if value is None else "%+.3g (%+.2g %%)" % (value, 100. * value / whole)


def rows(found):
    """The row of the case, then one per variation."""
    base = found.base
    yield ("as it is", "%.5g" % base.peak, "", "%.4g" % base.displacement, "", "", "",
           base.outcome)
    for d in found.differences:
        name = "%s: %s" % (d.variation.group, d.variation.name.replace("_", " "))
        if d.answer is None:
            yield (name,) + 6 * ("–",) + ("no answer",)
            continue
        yield (name, "%.5g" % d.answer.peak, signed(d.peak, base.peak),
               "%.4g" % d.answer.displacement,
               signed(d.displacement, base.displacement),
               "–" if d.path is None else "%.3g" % d.path.mean,
               "–" if d.path is None else "%.3g" % d.path.hausdorff,
               d.answer.outcome + ("" if d.same_outcome else " **(another)**"))


def contribution_rows(found):
    whole = {"peak": found.base.peak, "displacement": found.base.displacement}
    lines = [(group, [group]) for group in found.groups()]
    lines.append(("**numerics**", found.numerics()))
    if found.parameters():
        lines.append(("**parameters**", found.parameters()))
    for name, groups in lines:
        yield (name,) + tuple(shown(found.total(groups, q), whole.get(q))
                              for q, _ in QUANTITIES)


def markdown(found):
    """Two tables: the variations, and what each group contributes."""
    text = grid(("change", "peak, N", "", "displacement at peak, mm", "",
                 "path, mean distance, mm", "Hausdorff, mm", "outcome, start"),
                rows(found))
    text += "\n" + grid(["from"] + ["%s, %s" % pair for pair in QUANTITIES],
                        contribution_rows(found))
    if found.missing():
        text += "\n- Without an answer: %s.\n" % ", ".join(
            variations.case_name(variation) for variation in found.missing())
    return text
