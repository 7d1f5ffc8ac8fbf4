#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Periodic cells in which nothing breaks: against the law, laminates, supports that
impose the same, and bodies of several cells.

    test_elastic_cells.py EXECUTABLE LAUNCHER RANKS
"""
import sys
import tempfile

from runs import PERIODIC_2D, SOLID, Runs, alike, near, stresses

LAMBDA, MU = 3., 2.
STRAIN = "Boundary conditions/Mean strain="
MIXED = ("Model/Formulation=mixed", "Model/Displacement degree=2")
QUADRATIC = ("Model/Displacement degree=2",)
FINITE = ("Model/Strains=finite", "Model/Kinematics=plane strain")


def closes(row):
    near(row["energy_imbalance_mJ"], 0., 1e-9 * row["external_work_mJ"])


def test_even_body(runs):
    """sigma = lambda tr E I + 2 mu E."""
    xx, yy, xy = 0.01, -0.004, 0.003
    trace = LAMBDA * (xx + yy)
    expected = {"xx": trace + 2 * MU * xx, "yy": trace + 2 * MU * yy, "xy": 2 * MU * xy}
    strain = STRAIN + "xx : 0.01*t ; yy : -0.004*t ; xy : 0.003*t^2"
    for model in ((), QUADRATIC, MIXED):
        row = runs.last(PERIODIC_2D, strain, *model)
        alike(stresses(row), expected, 1e-9)
        # what acts through the right side, of unit area
        near(row["force_x_N"], expected["xx"], 1e-9)
        near(row["force_y_N"], expected["xy"], 1e-9)
    plane_stress = runs.last(PERIODIC_2D, strain, "Model/Kinematics=plane stress")
    reduced = 2 * LAMBDA * MU / (LAMBDA + 2 * MU) * (xx + yy)
    alike(stresses(plane_stress), {"xx": reduced + 2 * MU * xx, "yy": reduced + 2 * MU * yy,
                                   "xy": 2 * MU * xy}, 1e-9)
    zz = -0.002
    solid = runs.last(*SOLID, strain + " ; zz : -0.002*t ; yz : 0.005*t")
    trace = LAMBDA * (xx + yy + zz)
    alike(stresses(solid, "xyz"),
          {"xx": trace + 2 * MU * xx, "yy": trace + 2 * MU * yy, "zz": trace + 2 * MU * zz,
           "xy": 2 * MU * xy, "xz": 0., "yz": 2 * MU * 0.005}, 1e-9)


def test_finite_strain(runs):
    """The same as with the displacements of all sides prescribed."""
    for model in (FINITE, FINITE + MIXED, ("Model/Strains=finite",
                                           "Model/Kinematics=plane stress")):
        free = runs.last(PERIODIC_2D, STRAIN + "xx : 0.3*t ; xy : 0.2*t ; yx : -0.1*t", *model)
        held = runs.last(*model, "Boundary conditions/Displacement=" + " ; ".join(
            "%s : x : (0.3*x + 0.2*y)*t ; %s : y : -0.1*x*t" % (side, side)
            for side in ("right", "left", "bottom", "top")))
        near(free["elastic_energy_mJ"], held["elastic_energy_mJ"], 1e-9)
        found = stresses(free)
        near(found["xx"], held["force_x_N"], 1e-9)
        near(found["yx"], held["force_y_N"], 1e-9)
        near(free["min_jacobian"], 1.3 + 0.02, 1e-8)


def test_work_at_finite_strain(runs):
    """The trapezoidal rule is all that the balance lacks: of second order."""
    cell = (PERIODIC_2D, STRAIN + "xx : 0.3*t ; xy : 0.2*t", "Geometry/Rectangle/Cells=8, 8",
            *inclusion("xy"))
    for model in (FINITE, FINITE + MIXED):
        imbalances = []
        for step in ("0.2", "0.05"):
            row = runs.last(*cell, *model, *("Load stepping/%s step=%s" % (which, step)
                                             for which in ("First", "Largest", "Onset")))
            imbalances.append(row["energy_imbalance_mJ"] / row["external_work_mJ"])
        near(imbalances[0] / imbalances[1], 16., 0.5)
        near(imbalances[1], 0., 1e-4)


def test_laminate(runs):
    """Layers across x, half of them three times as stiff: in series and in parallel."""
    layers = ("Material/Lame lambda=3*(1 + 2*(x > 0.5))",
              "Material/Shear modulus=2*(1 + 2*(x > 0.5))", PERIODIC_2D)

    def mean(function):
        return 0.5 * (function(3., 2.) + function(9., 6.))

    series = 1. / mean(lambda l, m: 1. / (l + 2. * m))
    coupling = mean(lambda l, m: l / (l + 2. * m))
    row = runs.last(*layers, STRAIN + "xx : 0.01*t")
    alike(stresses(row), {"xx": 0.01 * series, "xy": 0., "yy": 0.01 * series * coupling},
          1e-9)
    closes(row)
    parallel = mean(lambda l, m: l + 2. * m - l * l / (l + 2. * m)) + coupling**2 * series
    alike(stresses(runs.last(*layers, STRAIN + "yy : 0.01*t")),
          {"xx": 0.01 * series * coupling, "xy": 0., "yy": 0.01 * parallel}, 1e-9)
    shear = 1. / mean(lambda l, m: 1. / m)
    alike(stresses(runs.last(*layers, STRAIN + "xy : 0.01*t")),
          {"xx": 0., "xy": 0.02 * shear, "yy": 0.}, 1e-9)
    # free across the layers: a strip with periodic ends is pulled along them
    strip = runs.last(*layers, "Geometry/Periodic sides=bottom : top", STRAIN + "yy : 0.01*t")
    assert strip["mean_stress_yy_MPa"] < 0.01 * parallel
    near(strip["mean_stress_xx_MPa"], 0., 1e-12)


def inclusion(variables):
    place = " + ".join("(%s-floor(%s)-0.45)^2" % (x, x) for x in variables)
    return ("Material/Lame lambda=3*(1 + 9*(%s < 0.06))" % place,
            "Material/Shear modulus=2*(1 + 9*(%s < 0.06))" % place)


def places(points, dim):
    return "Output/Displacement at points=" + " ; ".join(
        "%s : %s" % (name, ", ".join("%.3f" % x for x in point[:dim]))
        for name, point in points.items())


def test_repeated_cell(runs):
    """One cell and a body of several: the same stress, fields that repeat."""
    one_place, image = (0.625, 0.25, 0.25), (1.625, 1.25, 0.25)
    for model, strain in (((), "xx : 0.01*t ; xy : 0.004*t"),
                          (MIXED, "xx : 0.01*t ; xy : 0.004*t"),
                          (FINITE, "xx : 0.2*t ; xy : 0.1*t ; yx : -0.05*t"),
                          (FINITE + MIXED, "xx : 0.2*t ; yy : -0.1*t")):
        cell = ("Geometry/Rectangle/Cells=8, 8", PERIODIC_2D, STRAIN + strain,
                *inclusion("xy"), *model)
        row = runs.last(*cell, places({"origin": (0, 0), "one": one_place}, 2))
        four = runs.last(*cell, "Geometry/Rectangle/Upper corner=2, 2",
                         "Geometry/Rectangle/Cells=16, 16",
                         places({"origin": (1, 1), "one": one_place, "image": image}, 2))
        alike(stresses(row), stresses(four), 1e-9)
        near(four["elastic_energy_mJ"], 4 * row["elastic_energy_mJ"], 1e-8)
        if FINITE[0] not in model:
            closes(row)
        for x in "xy":
            moved = row["one_%s_mm" % x] - row["origin_%s_mm" % x]
            near(four["image_%s_mm" % x] - four["origin_%s_mm" % x], moved, 1e-8)
    solid = (*SOLID, STRAIN + "xx : 0.01*t ; yz : 0.004*t", *inclusion("xyz"),
             "Geometry/Box/Cells=4, 4, 4")
    row = runs.last(*solid)
    two = runs.last(*solid, "Geometry/Box/Upper corner=2, 1, 1", "Geometry/Box/Cells=8, 4, 4")
    alike(stresses(row, "xyz"), stresses(two, "xyz"), 1e-9)
    near(two["elastic_energy_mJ"], 2 * row["elastic_energy_mJ"], 1e-8)
    multigrid = runs.last(*solid, "Linear solver/Name=block AMG")
    alike(stresses(row, "xyz"), stresses(multigrid, "xyz"), 1e-7)


def test_any_start_of_the_cell(runs):
    """Where a pattern is cut into cells makes no difference."""
    cell = ("Geometry/Rectangle/Cells=8, 8", PERIODIC_2D, STRAIN + "xx : 0.01*t ; xy : 0.004*t",
            *inclusion("xy"))
    moved = runs.last(*cell, "Geometry/Rectangle/Lower corner=0.25, 0.5",
                      "Geometry/Rectangle/Upper corner=1.25, 1.5")
    alike(stresses(runs.last(*cell)), stresses(moved), 1e-9)
    # refined where an inclusion crosses the sides: finer faces meet coarser ones
    finer = ("Mesh/Refined boxes=0.25,0.5 : 0.45,0.7 : 1",)
    row = runs.last(*cell, *finer, "Geometry/Rectangle/Lower corner=0.25, 0.5",
                    "Geometry/Rectangle/Upper corner=1.25, 1.5")
    same = runs.last(*cell, "Mesh/Refined boxes=0.25,0.5 : 0.45,0.7 : 1")
    alike(stresses(row), stresses(same), 1e-9)


def test_oblique_cell(runs):
    """Layers across y in a parallelogram: in series, with the shear of both periods."""
    layers = ("Material/Lame lambda=3*(1 + 2*(y > 0.5))",
              "Material/Shear modulus=2*(1 + 2*(y > 0.5))", PERIODIC_2D)
    oblique = ("Geometry/Name=quadrilateral", "Geometry/Quadrilateral/Cells=4, 4",
               "Geometry/Quadrilateral/Corners=0, 0 ; 1, 0 ; 1.5, 1 ; 0.5, 1")
    strain = STRAIN + "xx : 0.002*t ; yy : 0.01*t ; xy : 0.004*t"
    alike(stresses(runs.last(*layers, strain)), stresses(runs.last(*layers, strain, *oblique)),
          1e-9)
    near(runs.last(*layers, STRAIN + "xy : 0.01*t", *oblique)["mean_stress_xy_MPa"],
         0.02 * 2. / (1 / 2. + 1 / 6.), 1e-10)


def mesh_with_holes(nx, ny):
    """Gmsh 2.2: 3 x 3 squares without the middle one, nx x ny times."""
    cells = [(x, y) for x in range(3 * nx) for y in range(3 * ny)
             if (x % 3, y % 3) != (1, 1)]
    width = 3 * nx + 1
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes",
             str(width * (3 * ny + 1))]
    lines += ["%d %.17g %.17g 0" % (x + width * y + 1, x / 3, y / 3)
              for y in range(3 * ny + 1) for x in range(width)]
    lines += ["$EndNodes", "$Elements", str(len(cells))]
    for number, (x, y) in enumerate(cells):
        first = x + width * y + 1
        lines.append("%d 3 2 1 1 %d %d %d %d" % (number + 1, first, first + 1,
                                                 first + 1 + width, first + width))
    return "\n".join(lines) + "\n$EndElements\n"


def test_cell_with_a_hole(runs):
    """From a file, the sides by position: its volume is that of the whole cell."""
    rows = []
    for nx, ny in ((1, 1), (2, 2)):
        mesh = runs.directory / ("%d_%d.msh" % (nx, ny))
        mesh.write_text(mesh_with_holes(nx, ny), encoding="utf-8")
        rows.append(runs.last(
            "Geometry/Name=mesh file", "Geometry/Mesh file/File name=%s" % mesh,
            "Geometry/Boundary regions=west : x < 1e-6 ; east : x > %g ; south : y < 1e-6 ; "
            "north : y > %g" % (nx - 1e-3, ny - 1e-3), "Mesh/Global refinements=1",
            "Geometry/Periodic sides=west : east ; south : north",
            STRAIN + "xx : 0.01*t ; xy : 0.004*t", "Load stepping/Force boundary=east"))
    row, four = rows
    alike(stresses(row), stresses(four), 1e-9)
    near(row["force_x_N"], row["mean_stress_xx_MPa"], 1e-10)
    near(four["force_y_N"], 2 * four["mean_stress_xy_MPa"], 1e-10)
    near(row["elastic_energy_mJ"], 0.5 * (0.01 * row["mean_stress_xx_MPa"]
                                          + 0.008 * row["mean_stress_xy_MPa"]), 1e-11)
    assert 0.1 < row["mean_stress_xx_MPa"] / (0.01 * (LAMBDA + 2 * MU)) < 0.9


def test_with_supports(runs):
    """A strip, periodic along x, on a rigid ground: sheared and pressed at the top."""
    row = runs.last("Geometry/Periodic sides=left : right",
                    "Boundary conditions/Displacement=bottom : all : 0 ; top : x : 0.01*t ; "
                    "top : y : -0.02*t", "Load stepping/Force boundary=top")
    near(row["force_x_N"], 0.01 * MU, 1e-12)
    near(row["force_y_N"], -0.02 * (LAMBDA + 2 * MU), 1e-12)
    near(row["mean_stress_xx_MPa"], -0.02 * LAMBDA, 1e-12)
    closes(row)


def test_held_points(runs):
    """At one corner, at its image or where the program holds it: the same, and nothing
    is held there but the body."""
    cell = (PERIODIC_2D, STRAIN + "xx : 0.01*t ; xy : 0.004*t", *inclusion("xy"))
    free = runs.last(*cell, places({"middle": (0.5, 0.25), "corner": (1, 1)}, 2))
    for corner in ("0, 0", "1, 1"):
        row = runs.last(*cell, places({"middle": (0.5, 0.25), "corner": (1, 1)}, 2),
                        "Boundary conditions/Displacement at points=%s : all : 0" % corner)
        alike(stresses(free), stresses(row), 1e-9)
        for x in "xy":
            near(row["reaction_1_%s_N" % x], 0., 1e-10)
            near(row["middle_%s_mm" % x] - row["corner_%s_mm" % x],
                 free["middle_%s_mm" % x] - free["corner_%s_mm" % x], 1e-10)
    near(row["corner_x_mm"], 0., 1e-12)


def main():
    with tempfile.TemporaryDirectory() as directory:
        runs = Runs(*sys.argv[1:4], directory)
        for test in (test_even_body, test_finite_strain, test_work_at_finite_strain,
                     test_laminate, test_repeated_cell,
                     test_any_start_of_the_cell, test_oblique_cell, test_cell_with_a_hole,
                     test_with_supports, test_held_points):
            test(runs)
            print(test.__name__, "ok", flush=True)
        print("%d runs" % runs.n_runs)


if __name__ == "__main__":
    main()
