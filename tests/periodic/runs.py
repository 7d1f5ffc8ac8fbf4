# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of periodic cells for the tests of this folder."""
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

# two-dimensional; a step of half and one of the whole load
BASE = """\
subsection Geometry
  set Name = rectangle
  subsection Rectangle
    set Upper corner = 1, 1
    set Cells        = 4, 4
  end
  subsection Box
    set Upper corner = 1, 1, 1
    set Cells        = 2, 2, 2
  end
end
subsection Model
  set Formulation         = displacement
  set Displacement degree = 1
  set Kinematics          = plane strain
  set Crack density       = AT1
  set Energy split        = none
  set Length scale        = 0.2
end
subsection Material
  set Lame lambda   = 3
  set Shear modulus = 2
  set Critical energy release rate = 1e6
end
subsection Load stepping
  set End time      = 1
  set First step    = 0.5
  set Largest step  = 0.5
  set Onset step    = 0.5
  set Smallest step = 0.001
end
subsection Linear solver
  set Newton tolerance = 1e-11
end
subsection Output
  set Directory    = unused
  set Field format = none
end
"""

PERIODIC_2D = "Geometry/Periodic sides=left : right ; bottom : top"
PERIODIC_3D = PERIODIC_2D + " ; back : front"
SOLID = ("Geometry/Dimension=3", "Geometry/Name=box", PERIODIC_3D)
# steps that no adaptation of their size changes
FIXED_STEPS = tuple("Load stepping/" + entry for entry in (
    "First step=0.1", "Largest step=0.1", "Onset step=0.1"))


class Runs:
    def __init__(self, executable, launcher, ranks, directory):
        self.runner = program.runner(executable, launcher, int(ranks))
        self.directory = pathlib.Path(directory)
        self.n_runs = 0
        self.case = self.directory / "case.prm"
        self.case.write_text(BASE, encoding="utf-8")

    def rows(self, *settings, more=(), status=0, case=None, name=None):
        """Of statistics.csv; numbers as they are."""
        self.n_runs += 1
        output = self.directory / (name or str(self.n_runs))
        self.runner.output_of([case or self.case, "--output", output, *more,
                               *program.as_options(settings)], status)
        return [{key: float(value) if value else None for key, value in row.items()}
                for row in program.rows(output)]

    def last(self, *settings, **keywords):
        return self.rows(*settings, **keywords)[-1]


def near(found, expected, tolerance):
    assert abs(found - expected) <= tolerance, (found, expected, found - expected)


def stresses(row, letters="xy"):
    """The columns of the mean stress that are there."""
    return {i + j: row["mean_stress_%s%s_MPa" % (i, j)] for i in letters for j in letters
            if "mean_stress_%s%s_MPa" % (i, j) in row}


def alike(one, other, tolerance):
    assert one.keys() == other.keys() and one, (one, other)
    size = max(map(abs, one.values()))
    for key, value in one.items():
        near(other[key], value, tolerance * size)
