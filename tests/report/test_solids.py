#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Surfaces, sections and edges of bodies in 3-d against exact measures."""
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "scripts"))
from report_parts import interpreter  # noqa: E402

if __name__ == "__main__":
    interpreter.use_one_with_matplotlib()

import matplotlib  # noqa: E402
import numpy as np  # noqa: E402
matplotlib.use("Agg")
from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: E402

import picture_3d  # noqa: E402
from report_parts import (animation, page, results, solids,  # noqa: E402
                          surfaces, vtu)

CORNERS = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                    (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], float)


def cubes(places):
    """Cells of (corner, size), their points not shared, as deal.II writes."""
    points = np.concatenate([np.array(corner) + size * CORNERS
                             for corner, size in places])
    cells = np.arange(len(points)).reshape(-1, 8)
    return points, cells, vtu.outer_faces(points, vtu.faces_of_hexahedra(cells))


def grid(n):
    """The unit cube of n^3 cells."""
    return cubes([((i / n, j / n, k / n), 1. / n)
                  for i in range(n) for j in range(n) for k in range(n)])


def refined():
    """Two unit cubes side by side, one of them of eight."""
    return cubes([((0., 0., 0.), 1.)]
                 + [((1. + 0.5 * i, 0.5 * j, 0.5 * k), 0.5)
                    for i in range(2) for j in range(2) for k in range(2)])


def area(triangles):
    return 0.5 * np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0],
                                         triangles[:, 2] - triangles[:, 0]),
                                axis=1).sum()


class Surfaces(unittest.TestCase):
    def test_sphere_converges(self):
        errors = []
        for n in (8, 16):
            points, cells, _ = grid(n)
            distance = np.linalg.norm(points - [0.5, 0.5, 0.5], axis=1)
            triangles, values = surfaces.level_set(points, cells, distance, 0.35,
                                                   points[:, 0])
            errors.append(abs(area(triangles) / (4. * np.pi * 0.35**2) - 1.))
            np.testing.assert_allclose(values, triangles[:, :, 0], atol=1e-12)
        self.assertLess(errors[0], 0.05)
        self.assertLess(errors[1], 0.3 * errors[0])

    def test_plane_is_exact(self):
        points, cells, _ = grid(3)
        normal = np.array([1., 2., 2.]) / 3.
        triangles, _ = surfaces.level_set(points, cells, points @ normal,
                                          0.5 * normal.sum())
        np.testing.assert_allclose(triangles @ normal, 0.5 * normal.sum(),
                                   atol=1e-12)
        # z = 1.25 - x/2 - y is above 1 in a triangle of 1/2 * 1/4 and below 0
        # in another one: the rest, times the slope
        self.assertAlmostEqual(area(triangles), (1. - 2. / 16.) * 1.5, places=10)

    def test_section_through_nodes(self):
        points, cells, _ = grid(4)
        for position in (0., 0.3, 0.5, 1.):
            triangles, values = surfaces.plane_section(points, cells, points[:, 1],
                                                       2, position)
            self.assertAlmostEqual(area(triangles), 1., places=8)
            np.testing.assert_allclose(values, triangles[:, :, 1], atol=1e-9)

    def test_outer_faces_beside_refined_cells(self):
        _, _, faces = refined()
        self.assertEqual(len(faces), 5 + 4 + 4 * 4)
        self.assertEqual(len(grid(3)[2]), 6 * 9)

    def test_edges_of_a_box(self):
        for points, cells, faces in (grid(3), refined()):
            normals = surfaces.normals_of(points, cells, faces)
            edges = surfaces.feature_edges(points, faces, normals)
            sizes = np.ptp(points, axis=0)
            total = sum(np.linalg.norm(ends[1] - ends[0]) for ends, _ in edges)
            self.assertAlmostEqual(total, 4. * sizes.sum(), places=9)

    def test_normals_point_outwards(self):
        points, cells, faces = refined()
        normals = surfaces.normals_of(points, cells, faces)
        outward = points[faces].mean(axis=1) - [1., 0.5, 0.5]
        self.assertGreater(np.einsum("ij,ij->i", normals, outward).min(), 0.)

    def test_caps(self):
        points, _, faces = grid(4)
        polygons = surfaces.caps(points, faces, points[:, 1], 0.3)
        total = sum(area(np.array([(p[0], p[i], p[i + 1])
                                   for i in range(1, len(p) - 1)]))
                    for p in polygons)
        self.assertAlmostEqual(total, 1. + 4. * 0.3, places=10)


class Pictures(unittest.TestCase):
    def setUp(self):
        points, cells, faces = grid(4)
        self.fields = vtu.Fields(points, faces, {
            "phase_field": np.clip(4. * np.abs(points[:, 1] - 0.8), 0., 1.),
            "displacement": 0.01 * points}, cells)

    def test_all_are_drawn(self):
        window = solids.common_window([self.fields.points])
        region = solids.region_of(self.fields)
        for picture in (solids.crack_picture(self.fields, region),
                        solids.mesh_picture(self.fields),
                        solids.deformed_picture(self.fields, 5., window),
                        solids.section_picture(self.fields, 0, 0.5, region)[0]):
            self.assertEqual(picture[:4], b"\x89PNG")

    def test_intact_and_broken_bodies(self):
        for value in (0., 1.):
            self.fields.data["phase_field"][:] = value
            window = solids.common_window([self.fields.points])
            solids.crack_picture(self.fields, solids.region_of(self.fields))
            solids.deformed_picture(self.fields, 5., window)
            self.assertEqual(len(solids.section_planes(self.fields)), 3)

    def test_sections_go_where_the_crack_is(self):
        planes = dict(solids.section_planes(self.fields))
        self.assertAlmostEqual(planes[0], 0.5)
        self.assertAlmostEqual(planes[1], 0.75)  # nodes at 3/4 are broken only


class Runs(unittest.TestCase):
    """The directory of a run with one cracked cube, written as ASCII."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.write("fields.pvd", '<DataSet timestep="0" file="cube.vtu"/>\n')

    def write(self, name, text):
        with open(os.path.join(self.folder.name, name), "w") as stream:
            stream.write(text)

    def write_cube(self, points, cells, phase_field):
        def array(kind, name, values, components=1):
            return ('<DataArray type="%s" Name="%s" NumberOfComponents="%d" '
                    'format="ascii">%s</DataArray>' % (
                        kind, name, components, " ".join(map(str, values))))

        n = len(cells)
        self.write("cube.vtu", '<VTKFile type="UnstructuredGrid" byte_order='
                   '"LittleEndian"><UnstructuredGrid><Piece NumberOfPoints="%d" '
                   'NumberOfCells="%d"><Points>' % (len(points), n)
                   + array("Float64", "points", points.ravel(), 3)
                   + "</Points><Cells>"
                   + array("Int32", "connectivity", cells.ravel())
                   + array("Int32", "offsets", 8 * np.arange(1, n + 1))
                   + array("UInt8", "types", n * [12]) + "</Cells><PointData>"
                   + array("Float64", "phase_field", phase_field)
                   + "</PointData></Piece></UnstructuredGrid></VTKFile>")

    def picture(self, *options):
        return subprocess.run(
            [sys.executable, "-B", os.path.join(HERE, "..", "..", "scripts",
                                                "picture_3d.py"),
             self.folder.name, "--output",
             os.path.join(self.folder.name, "out.png")] + list(options),
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)

    def test_page_and_picture(self):
        points, cells, _ = grid(4)
        self.write_cube(points, cells, np.abs(2. * points[:, 1] - 1.))
        text = page.written(self.folder.name)
        self.assertIn("<h2>Sections</h2>", text)
        self.assertIn("y = 0.5", text)
        self.assertEqual(text.count("data:image/png"), 1 + 3 + 1)
        self.assertEqual(self.picture("--sections", "xz").returncode, 0)
        with open(os.path.join(self.folder.name, "out.png"), "rb") as stream:
            self.assertEqual(stream.read(4), b"\x89PNG")
        answer = self.picture("--steps", "3")
        self.assertEqual(answer.returncode, 2)
        self.assertIn("found 3, allowed are -1 to 0", answer.stderr)

    def test_captions_do_not_meet(self):
        slender = ((np.zeros(2), np.array([0.2, 1.])), lambda axes: None,
                   "y = 0.5 mm; right: x, up: z")
        figure = picture_3d.draw([slender] * 3)
        renderer = FigureCanvasAgg(figure).get_renderer()
        extents = [text.get_window_extent(renderer) for text in figure.texts]
        for one, other in zip(extents, extents[1:]):
            self.assertLess(one.x1, other.x0)

    def test_video(self):
        points, cells, _ = grid(4)
        self.write_cube(points, cells, np.abs(2. * points[:, 1] - 1.))
        frames = [png for _, png in animation.frames_of(
            results.Results(self.folder.name), 10)]
        self.write_cube(points, cells, np.ones(len(points)))
        frames += [png for _, png in animation.frames_of(
            results.Results(self.folder.name), 10)]
        self.assertEqual([png[:4] for png in frames], 2 * [b"\x89PNG"])
        # of one size, and the crack is seen
        self.assertEqual(frames[0][16:24], frames[1][16:24])
        self.assertNotEqual(frames[0], frames[1])

    def test_small_cracks_are_enlarged(self):
        points, cells, _ = grid(16)
        self.write_cube(points, cells, np.where(
            np.linalg.norm(points - 0.5, axis=1) < 0.05, 0., 1.))
        self.assertIn("a box of", page.written(self.folder.name))

    def test_no_fields(self):
        answer = self.picture()
        self.assertEqual(answer.returncode, 2)
        self.assertIn("there are no fields", answer.stderr)


if __name__ == "__main__":
    unittest.main()
