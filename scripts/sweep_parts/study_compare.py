# SPDX-License-Identifier: GPL-2.0-or-later
"""Peaks of the runs of a sweep compared with reference values, as a Markdown table."""
from . import studies

HEAD = ("| run | displacement at peak (mm) | reference | deviation | "
        "peak force (N/mm) | reference | deviation |\n"
        "|---|---:|---:|---:|---:|---:|---:|\n")
NONE = "–"


def deviation(ours, reference):
    if ours is None or not reference:
        return NONE
    return "%+.1f %%" % (100. * (ours / reference - 1.))


def shown(value):
    return NONE if value is None else "%.4g" % value


def read_peaks(path):
    """{name: (displacement, force per thickness)}."""
    peaks = {}
    for name, displacement, force, unit in studies.read_reference(path, True):
        if unit != "force_N_per_mm":
            raise studies.StudyError("%s: forces are expected in force_N_per_mm" % path)
        if name in peaks:
            raise studies.StudyError("%s: '%s' is given twice" % (path, name))
        peaks[name] = displacement, force
    return peaks


def written(runs, peaks):
    text, remarks = HEAD, []
    for run in runs:
        displacement, force = run.peak or (None, None)
        if force is not None and run.thickness is None:
            remarks.append("%s: the thickness is not known." % run.name)
            force = None
        elif force is not None:
            force /= run.thickness
        if run.summary.get("exit_status") != 0:
            remarks.append("%s has not finished: the peak is that of the steps so far."
                           % run.name)
        reference = peaks.get(run.name, (None, None))
        cells = [run.name, shown(displacement), shown(reference[0]),
                 deviation(displacement, reference[0]), shown(force),
                 shown(reference[1]), deviation(force, reference[1])]
        text += "| %s |\n" % " | ".join(cells)
    missing = [name for name in peaks if name not in [run.name for run in runs]]
    if missing:
        remarks.append("In the reference only: %s." % ", ".join(missing))
    return text + ("\n" + "".join("- %s\n" % remark for remark in remarks)
                   if remarks else "")
