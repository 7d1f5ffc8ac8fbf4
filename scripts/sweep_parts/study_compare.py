# SPDX-License-Identifier: GPL-2.0-or-later
"""Peaks of the runs of a sweep compared with reference values, as a Markdown table."""
from . import studies

HEAD = ("| run | displacement at peak (mm) | reference | deviation | "
        "peak force (%s) | reference | deviation |\n"
        "|---|---:|---:|---:|---:|---:|---:|\n")
UNITS = {"force_N_per_mm": "N/mm", "force_N": "N"}
NONE = "–"


def deviation(ours, reference):
    if ours is None or not reference:
        return NONE
    return "%+.1f %%" % (100. * (ours / reference - 1.))


def shown(value):
    return NONE if value is None else "%.4g" % value


class Peaks:
    """The references of a file, by name, and how many of their figures are met."""

    def __init__(self, path):
        self.by_name = {}
        for reference in studies.read_reference(path, True):
            if reference.name in self.by_name:
                raise studies.StudyError("%s: '%s' is given twice"
                                         % (path, reference.name))
            self.by_name[reference.name] = reference
        self.unit = next((r.unit for r in self.by_name.values()), studies.FORCES[0])
        self.compared = set()
        self.counts = {}  # {group of runs: [met, of how many]}

    def of(self, run):
        name = studies.reference_of(run.name, self.by_name)
        self.compared.add(name)
        return self.by_name.get(name)

    def cells(self, run, reference, ours, which):
        """Ours, the reference's and the deviation; which: 0 displacement, 1 force."""
        if reference is None:
            return [shown(ours), NONE, NONE]
        mean = (reference.displacement, reference.force)[which]
        cells = [shown(ours), shown(mean), deviation(ours, mean)]
        if reference.scatter is not None:
            low, high = reference.scatter[which]
            cells[1] += " (%.4g to %.4g)" % (low, high)
            if ours is not None:
                within = low <= ours <= high
                count = self.counts.setdefault(run.group, [0, 0])
                count[0] += within
                count[1] += 1
                cells[2] += ", within" if within else ", **outside**"
        return cells

    def remarks(self):
        found = ["%s: %d of %d figures lie within the scatter." % (group, *count)
                 for group, count in self.counts.items()]
        missing = [name for name in self.by_name if name not in self.compared]
        if missing:
            found.append("In the reference only: %s." % ", ".join(missing))
        return found


def written(runs, peaks):
    text, remarks = HEAD % UNITS[peaks.unit], []
    for run in runs:
        displacement, force = run.peak or (None, None)
        if force is not None and peaks.unit == "force_N_per_mm":
            if run.thickness is None:
                remarks.append("%s: the thickness is not known." % run.name)
                force = None
            else:
                force /= run.thickness
        if run.summary.get("exit_status") != 0:
            remarks.append("%s has not finished: the peak is that of the steps so far."
                           % run.name)
        reference = peaks.of(run)
        text += "| %s |\n" % " | ".join([run.name] +
                                        peaks.cells(run, reference, displacement, 0) +
                                        peaks.cells(run, reference, force, 1))
    remarks += peaks.remarks()
    return text + ("\n" + "".join("- %s\n" % remark for remark in remarks)
                   if remarks else "")
