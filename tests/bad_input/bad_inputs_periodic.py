# SPDX-License-Identifier: GPL-2.0-or-later
"""Bad periodic sides and mean strains, for run_bad_inputs.py."""
from bad_inputs import FINITE, later, several

SIDES, STRAIN = "Geometry/Periodic sides", "Boundary conditions/Mean strain"
CONDITIONS = "Boundary conditions/"
CELL = [("Geometry/Name", "rectangle"), ("Geometry/Rectangle/Cells", "4, 4"),
        (CONDITIONS + "Displacement", ""), ("Load stepping/Force boundary", "")]


def periodic(sides, strain, *says, more=()):
    """Of a square cell."""
    pairs = dict(CELL + [(SIDES, sides), (STRAIN, strain), *more])
    return several("periodic: %s; %s%s" % (sides, strain, "".join(
        "; %s = %s" % pair for pair in more)), list(pairs.items()), *says)


def of_regions(sides, regions, *says):
    return periodic(sides, "xx : t", SIDES, *says,
                    more=[("Geometry/Boundary regions", regions)])


def with_entry(name, text, found, allowed):
    """What cannot be on a periodic side."""
    return periodic("left : right", "xx : t", name, found, allowed, more=[(name, text)])


CASES = [
    periodic("left right", "xx : t", SIDES, "'left right'", "boundary : boundary"),
    periodic("left : rigth", "xx : t", SIDES, "'rigth'", "did you mean 'right'"),
    periodic("left : left", "xx : t", SIDES, "'left'", "one partner"),
    periodic("left : right ; right : top", "xx : t", SIDES, "'right'", "one partner"),
    later(periodic("left : top", "xx : t", SIDES, "'left : top'", "different sizes")),
    later(of_regions("left : part", "part : x > 0.999 && y > 0.5", "'left : part'",
               "different sizes")),
    later(of_regions("part : other", "part : x < 0.01 || y < 0.01 ; other : x > 0.99",
               "'part' is not flat")),
    later(of_regions("low : high", "low : y < 0.01 && x < 0.5 ; high : y < 0.01 && x > 0.5",
               "'low : high'", "look away from each other")),
    later(of_regions("left : part", "part : x > 0.999 && abs(y - 0.5) > 0.2",
               "the face at \\(0, 0.375\\) of 'left' has no partner")),
    periodic("", "xx : t", STRAIN, "'xx : t'", "without", SIDES,
             more=[(CONDITIONS + "Displacement", "bottom : all : 0")]),
    periodic("left : right", "xx", STRAIN, "'xx'", "component : expression"),
    periodic("left : right", "yx : t", STRAIN, "'yx'", "xx, xy, yy", "small strain"),
    periodic("left : right", "xx : t ; xx : 1", STRAIN, "'xx : 1'", "second"),
    periodic("left : right", "xx : x*t", STRAIN, "'x'", "t"),
    later(periodic("left : right", "xx : 1/t", STRAIN, FINITE, "t = 0")),
    later(periodic("left : right", "yy : t", STRAIN, "'yy'", "no difference")),
    with_entry("Load stepping/Force boundary", "top", "'top'", "left, right"),
    with_entry(CONDITIONS + "Displacement", "left : y : 0", "'left'",
               "one of Geometry/Periodic sides"),
    with_entry(CONDITIONS + "Traction", "right : x : t", "'right'",
               "one of Geometry/Periodic sides"),
    with_entry(CONDITIONS + "Pressure", "right : t", "'right'",
               "one of Geometry/Periodic sides"),
    later(periodic("left : right", "xx : 0.1 + t", CONDITIONS + "Displacement", "image",
             "Mean strain", "allowed is",
             more=[(CONDITIONS + "Displacement", "bottom : all : 0")])),
]
