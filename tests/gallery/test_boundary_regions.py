#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Cases of parameters/gallery/ that name boundaries and points by their position,
and the faces of slits, against the values in their first lines; a run through a
region is resumed.

    test_boundary_regions.py EXECUTABLE LAUNCHER RANKS
"""
import pathlib
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
import program  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
GALLERY = ROOT / "parameters" / "gallery"


class Gallery:
    def __init__(self, executable, launcher, ranks, directory):
        self.runner = program.runner(executable, launcher, int(ranks))
        self.directory = pathlib.Path(directory)
        self.n_runs = 0

    def last_row(self, name, *settings, case=None):
        self.n_runs += 1
        output = self.directory / str(self.n_runs)
        case = case or GALLERY / (name + ".prm")
        self.runner.output_of([case, "--output", output, *program.as_options(
            ("Output/Field format=none", *settings))])
        return program.rows(output)[-1]


def near(found, expected, tolerance):
    assert abs(float(found) - expected) <= tolerance, (found, expected)


def test_region(gallery):
    row = gallery.last_row("boundary_regions")
    near(row["force_y_N"], -2., 1e-9)
    near(row["force_x_N"], 0., 1e-9)
    # the later entry wins: half of the part is not pressed
    later = ("Geometry/Boundary regions=pressed : x > 1 && x < 3 && y > 0.999 ; "
             "free : x < 2 && y > 0.5")
    near(gallery.last_row("boundary_regions", later)["force_y_N"], -1., 1e-9)
    # a region that is all of a side is that side
    side = gallery.last_row("boundary_regions", "Geometry/Boundary regions=",
                            "Boundary conditions/Traction=top : y : -t")
    near(side["force_y_N"], -4., 1e-9)
    region = gallery.last_row(
        "boundary_regions", "Geometry/Boundary regions=lid : y > 0.999 ; foot : y < 1e-3",
        "Boundary conditions/Traction=lid : y : -t",
        "Boundary conditions/Displacement=foot : all : 0")
    for column in ("force_y_N", "elastic_energy_mJ", "external_work_mJ"):
        near(region[column], float(side[column]), 1e-12)


def test_lower_face(gallery):
    near(gallery.last_row("slit_lower_face")["force_y_N"], -1., 1e-9)
    # the upper one, whose outward normal is -y, takes as much
    upper = gallery.last_row("slit_lower_face",
                             "Boundary conditions/Displacement=slit upper : all : 0")
    near(upper["force_y_N"], 1., 1e-9)
    # both names together are the old one
    both = gallery.last_row(
        "slit_lower_face", "Boundary conditions/Displacement=slit lower : all : 0 ; "
        "slit upper : all : 0")
    old = gallery.last_row("slit_lower_face",
                           "Boundary conditions/Displacement=slit : all : 0")
    near(old["elastic_energy_mJ"], float(both["elastic_energy_mJ"]), 1e-12)
    assert float(old["elastic_energy_mJ"]) < float(upper["elastic_energy_mJ"])


def test_pressure(gallery):
    closed = gallery.last_row("slit_pressure")
    pulled = gallery.last_row("slit_pressure",
                              "Boundary conditions/Traction=top : y : t")
    near(closed["force_y_N"], 0., 1e-9)
    near(pulled["force_y_N"], 1., 1e-9)
    for column, expected in (("corner_y_mm", 9.1e-4), ("far_y_mm", 9.1e-4),
                             ("far_x_mm", -3.9e-4), ("mouth_y_mm", 4.55e-4),
                             ("corner_x_mm", 0.)):
        near(float(pulled[column]) - float(closed[column]), expected, 1e-10)
    # loads on faces with two names are added
    none = gallery.last_row(
        "slit_pressure", "Boundary conditions/Traction=slit : y : -t ; "
        "slit upper : y : 2*t")
    near(none["elastic_energy_mJ"], float(closed["elastic_energy_mJ"]), 1e-12)


def test_point_sets(gallery):
    by_name = gallery.last_row("point_sets")
    by_place = gallery.last_row(
        "point_sets", "Boundary conditions/Displacement at points=0, 0 : y : 0 ; "
        "10, 0 : y : 0 ; 5, 1 : x : 0 ; 5, 1 : y : -0.01*t")
    for column in ("force_y_N", "elastic_energy_mJ", "displacement_mm"):
        near(by_name[column], float(by_place[column]), 1e-12)
    near(abs(float(by_name["force_y_N"])), 0.0388, 0.05 * 0.0388)


def test_names_of_a_file(gallery):
    """Groups of a Gmsh file by their names there, and by those of the .prm."""
    mesh = gallery.directory / "square.msh"
    mesh.write_text(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"foot\"\n"
        "1 2 \"lid\"\n$EndPhysicalNames\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n"
        "4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n$Elements\n6\n1 1 2 1 1 1 2\n"
        "2 1 2 1 1 2 3\n3 1 2 2 2 4 5\n4 1 2 2 2 5 6\n5 3 2 7 7 1 2 5 4\n"
        "6 3 2 7 7 2 3 6 5\n$EndElements\n", encoding="utf-8")
    settings = ["Geometry/Name=mesh file", f"Geometry/Mesh file/File name={mesh}",
                "Geometry/Boundary regions=", "Mesh/Global refinements=2"]
    named = gallery.last_row("boundary_regions", *settings,
                             "Boundary conditions/Displacement=foot : all : 0",
                             "Boundary conditions/Traction=lid : y : -t")
    near(named["force_y_N"], -2., 1e-9)
    given = gallery.last_row("boundary_regions", *settings,
                             "Geometry/Mesh file/Boundary names=1 = a ; 2 = b",
                             "Boundary conditions/Displacement=a : all : 0",
                             "Boundary conditions/Traction=b : y : -t")
    near(named["elastic_energy_mJ"], float(given["elastic_energy_mJ"]), 1e-12)
    # without any name in the file, by position
    region = gallery.last_row("boundary_regions", *settings[:2], settings[3],
                              "Geometry/Boundary regions=a : y < 0.1 ; b : y > 0.9",
                              "Boundary conditions/Displacement=a : all : 0",
                              "Boundary conditions/Traction=b : y : -t")
    near(region["elastic_energy_mJ"], float(given["elastic_energy_mJ"]), 1e-12)


def test_resume(gallery):
    settings = ["Load stepping/First step=0.25", "Load stepping/Largest step=0.25",
                "Geometry/Point sets=corner : x > 3.9 && y < 0.1",
                "Boundary conditions/Displacement=bottom : y : 0",
                "Boundary conditions/Displacement at points=corner : x : 0"]
    whole = gallery.last_row("boundary_regions", *settings)
    output = gallery.directory / "resumed"
    case = [GALLERY / "boundary_regions.prm", "--output", output]
    fields = "Output/Field format=none"
    gallery.runner.output_of([*case, *program.as_options(
        (fields, *settings, "Load stepping/End time=0.5"))])
    gallery.runner.output_of(
        [*case, "--resume", *program.as_options((fields, *settings))])
    rows = program.rows(output)
    assert len(rows) == 5, rows
    for column in ("force_y_N", "elastic_energy_mJ"):
        near(rows[-1][column], float(whole[column]), 1e-9)


def main(executable, launcher, ranks):
    with tempfile.TemporaryDirectory() as directory:
        gallery = Gallery(executable, launcher, ranks, directory)
        for test in (test_region, test_lower_face, test_pressure, test_point_sets,
                     test_names_of_a_file, test_resume):
            test(gallery)
            print(test.__name__, "passed")


if __name__ == "__main__":
    main(*sys.argv[1:])
