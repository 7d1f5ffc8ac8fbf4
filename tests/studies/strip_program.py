#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Stands in for mixed-cracks: a strip whose answers are formulas.

    peak force         10 sqrt(mu G_c) N  (1 + 0.02 (First step - 0.6))
    displacement there 20 mm; the force rises straight and is 1 N from 21 mm on
    path               straight, from (0, h) to (20, h + 4 - level)
    outcome            'below hole' up to a notch height of
                       7.3 + 0.2 (level - 3) + 0.05 if the mesh is mirrored in x,
                       'through hole' above

h: notch height; level: adaptive levels. Heights between Model/Fails from and
Model/Fails to, and cells below Model/Fails with cells below, end with exit status 3.
Every start is noted in starts.txt of the directory STRIP_STARTS.
"""
import hashlib
import json
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, os.pardir, "report"))
sys.path.insert(0, os.path.join(HERE, os.pardir, "sweep"))
sys.path.insert(0, os.path.join(HERE, os.pardir, os.pardir, "scripts"))
import synthetic_run  # noqa: E402
from fake_program import read_words  # noqa: E402
from report_parts import parameters  # noqa: E402

DEFAULTS = """subsection Geometry
  set Name = punctured strip
  subsection Punctured strip
    set Notch height  = 12
    set Cell size     = 1.2
    set Mirrored mesh = none
  end
end
subsection Mesh
  set Adaptive levels = 3
end
subsection Model
  set Coupling           = iterated
  set Coupling tolerance = 1e-3
  set Fails from         = 0
  set Fails to           = 0
  set Fails with cells below = 0
end
subsection Material
  set Shear modulus                = 4
  set Critical energy release rate = 16
  set Thickness                    = 2
end
subsection Load stepping
  set End time     = 12
  set First step   = 0.6
  set Largest step = 1.2
end
"""


def effective(base, settings):
    found = parameters.parameters_of(DEFAULTS)
    found.update(parameters.read_parameters(base))
    found.update(settings)
    return {entry: canonical(value) for entry, value in found.items()}


def canonical(value):
    try:
        return "%.12g" % float(value)
    except ValueError:
        return value


def case_id(values, full):
    """Of the problem: without what may change when a run goes on, unless full."""
    counted = {entry: value for entry, value in values.items() if full
               or not entry.startswith(("Load stepping/", "Model/Coupling tolerance"))}
    return hashlib.sha256(json.dumps(counted, sort_keys=True).encode()).hexdigest()[:32]


def prm_of(values):
    """As statements, each in subsections of its own."""
    text = ""
    for entry, value in values.items():
        parts = entry.split("/")
        text += "".join("subsection %s\n" % part for part in parts[:-1])
        text += "set %s = %s\n" % (parts[-1], value) + "end\n" * (len(parts) - 1)
    return text


class Strip:
    def __init__(self, values):
        def number(entry):
            return float(values[entry])
        self.height = number("Geometry/Punctured strip/Notch height")
        self.level = number("Mesh/Adaptive levels")
        self.mirrored = values["Geometry/Punctured strip/Mirrored mesh"] == "x"
        self.fails = number("Model/Fails from") < self.height < number("Model/Fails to") \
            or number("Geometry/Punctured strip/Cell size") \
            < number("Model/Fails with cells below")
        self.peak = 10. * math.sqrt(number("Material/Shear modulus") * number(
            "Material/Critical energy release rate")) * (
                1. + 0.02 * (number("Load stepping/First step") - 0.6))

    @property
    def outcome(self):
        change = 7.3 + 0.2 * (self.level - 3.) + (0.05 if self.mirrored else 0.)
        return "below hole" if self.height <= change else "through hole"

    def write(self, output):
        rows = ["step,time_s,displacement_mm,force_x_N,force_y_N"]
        for step, u in enumerate((0., 10., 20., 21., 22.)):
            force = self.peak * u / 20. if u <= 20. else 1.
            rows.append("%d,%.12g,%.12g,0,%.12g" % (step, 0.3 * u, u, force))
        synthetic_run.write(os.path.join(output, "statistics.csv"),
                            "\n".join(rows) + "\n")
        end = self.height + 4. - self.level
        synthetic_run.write(
            os.path.join(output, "crack_path.csv"),
            "step,crack,x_mm,y_mm\n4,0,0,%.12g\n4,0,20,%.12g\n# outcome: %s\n"
            % (self.height, end, self.outcome))
        synthetic_run.write_summary(
            output, exit_status=3 if self.fails else 0, peak_force_N=self.peak,
            displacement_at_peak_mm=20., thickness_mm=2., separated=not self.fails,
            outcome=self.outcome, outcome_start="notch",
            exit_reason="the smallest step is reached" if self.fails else "separated")


def main():
    settings, options, output, base = read_words(sys.argv[1:])
    if "--version" in options:
        print("mixed-cracks 0 (revision strip)")
        return 0
    if "--parameters" in options:
        print(DEFAULTS)
        return 0
    values = effective(base, settings)
    if values["Geometry/Punctured strip/Mirrored mesh"] == "y":
        print("error: the grid lines are their own mirror image", file=sys.stderr)
        return 2
    for question in ("--case-id", "--case-id=full"):
        if question in options:
            print(case_id(values, question.endswith("full")))
            return 0
    with open(os.path.join(os.environ["STRIP_STARTS"], "starts.txt"), "a",
              encoding="utf-8") as stream:
        stream.write("%s\n" % values["Geometry/Punctured strip/Notch height"])
    strip = Strip(values)
    synthetic_run.write(os.path.join(output, "parameters.prm"), prm_of(values))
    synthetic_run.write_fields(output)
    strip.write(output)
    return 3 if strip.fails else 0


if __name__ == "__main__":
    sys.exit(main())
