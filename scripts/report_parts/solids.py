# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of bodies in 3-d as PNG: the surface of the crack within the edges of
the body, plane sections, mesh and deformed body. Parallel projection, far faces
first; x to the right, y upwards, z towards the viewer."""
import itertools

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_rgb

from . import pictures, surfaces, vtu

LEVEL = 0.5  # of the phase field: the surface that is drawn
CRACK = "#8c2a3a"
CUT = "#3b0f2b"  # where the crack comes out of the body
NOTE = "Surface φ = %g around the crack, within the edges of the undeformed body; " \
    "darker where it comes out of the body. y points upwards, x to the right, z " \
    "towards the viewer; seen from the right and from above." % LEVEL
HIDDEN = "#c3cad0"
# The viewer looks from the right and from above.
TURN, TILT = np.radians(-35.), np.radians(24.)
LIGHT = surfaces.unit(np.array([-0.35, 0.8, 0.6]))


def view():
    """Rows: to the right and upwards in the picture, towards the viewer."""
    c, s = np.cos(TURN), np.sin(TURN)
    about_y = np.array([[c, 0., s], [0., 1., 0.], [-s, 0., c]])
    c, s = np.cos(TILT), np.sin(TILT)
    return np.array([[1., 0., 0.], [0., c, -s], [0., s, c]]) @ about_y


def seen(points):
    """Coordinates in the picture; the third one grows towards the viewer."""
    return points @ view().T


def shaded(color, normals):
    """Colors of faces with these normals; both sides are lit alike where
    `color` is one color, otherwise one color for each face."""
    bright = 0.62 + 0.38 * np.abs(normals @ LIGHT)
    return np.clip(np.atleast_2d(color) * bright[:, None], 0., 1.)


def is_solid(fields):
    return len(fields.cells) > 0


def common_window(all_points):
    """One window for bodies that are to be compared by eye."""
    return pictures.common_window([seen(points) for points in all_points])


def add_polygons(axes, polygons, colors, edges="face", width=0.3):
    """Far ones first."""
    order = np.argsort([polygon[:, 2].mean() for polygon in polygons], kind="stable")
    axes.add_collection(PolyCollection(
        [polygons[i][:, :2] for i in order], facecolors=np.asarray(colors)[order],
        edgecolors=edges, linewidths=width, antialiaseds=True))


def add_edges(axes, edges, towards, hidden):
    """Edges of the body: those that the viewer sees, or the others."""
    chosen = [np.array(ends) @ view().T for ends, normals in edges
              if hidden != (normals @ towards > 1e-6).any()]
    if chosen:
        axes.add_collection(LineCollection(
            [line[:, :2] for line in chosen], colors=HIDDEN if hidden
            else pictures.OUTLINE, linewidths=0.8, capstyle="round"))


def edges_of_body(fields):
    normals = surfaces.normals_of(fields.points, fields.cells, fields.faces)
    return surfaces.feature_edges(fields.points, fields.faces, normals)


def triangle_normals(triangles):
    return surfaces.unit(np.cross(triangles[:, 1] - triangles[:, 0],
                                  triangles[:, 2] - triangles[:, 0]))


def region_of(fields):
    """Corners (low, high) of what is worth drawing: the body, or the crack and
    its surroundings where it is much smaller in every direction."""
    low, high = fields.points.min(axis=0), fields.points.max(axis=0)
    broken = fields.points[fields.data["phase_field"] < LEVEL]
    if len(broken):
        middle = 0.5 * (broken.max(axis=0) + broken.min(axis=0))
        reach = max(0.8 * np.ptp(broken, axis=0).max(), 0.02 * (high - low).min())
        if reach < 0.125 * (high - low).min():
            return middle - reach, middle + reach
    return low, high


def corners_of(region):
    return np.array(list(itertools.product(*zip(*region))))


def is_enlarged(fields, region):
    return bool((region[1] - region[0] < 0.5 * np.ptp(fields.points, axis=0)).all())


def edges_of_region(region):
    """Those of a box, as edges_of_body()."""
    corners = corners_of(region)
    faces = np.array([(0, 2, 6, 4), (1, 3, 7, 5), (0, 1, 5, 4), (2, 3, 7, 6),
                      (0, 1, 3, 2), (4, 5, 7, 6)])
    normals = np.kron(np.eye(3), [[-1.], [1.]])
    return surfaces.feature_edges(corners, faces, normals)


def draw_crack(axes, fields, region):
    """The surface phi = 0.5 within the edges of the body, or of the region if
    that is a small one; dark where the crack comes out of the body."""
    phase_field = np.clip(fields.data["phase_field"], 0., 1.)
    towards = view()[2]
    edges = edges_of_region(region) if is_enlarged(fields, region) else \
        edges_of_body(fields)
    add_edges(axes, edges, towards, hidden=True)
    triangles, _ = surfaces.level_set(fields.points, fields.cells, phase_field,
                                      LEVEL)
    if len(triangles):
        add_polygons(axes, [seen(triangle) for triangle in triangles],
                     shaded(to_rgb(CRACK), triangle_normals(triangles)))
    normals = surfaces.normals_of(fields.points, fields.cells, fields.faces)
    caps = surfaces.caps(fields.points, fields.faces[normals @ towards > 0.],
                         phase_field, LEVEL)
    if caps:
        add_polygons(axes, [seen(polygon) for polygon in caps],
                     np.tile(to_rgb(CUT), (len(caps), 1)))
    add_edges(axes, edges, towards, hidden=False)


def crack_picture(fields, region):
    """PNG of the surface of the crack."""
    figure, axes = pictures.canvas(common_window([corners_of(region)]))
    draw_crack(axes, fields, region)
    return pictures.png_of(figure)


def section_planes(fields):
    """[(axis, position)]: the planes in the middle of the body, or, where the
    crack is far from one, through the middle of the crack."""
    points = fields.points
    broken = points[fields.data["phase_field"] < LEVEL]
    planes = []
    for axis in range(3):
        position = 0.5 * (points[:, axis].min() + points[:, axis].max())
        if len(broken) and not (broken[:, axis].min() <= position
                                <= broken[:, axis].max()):
            position = 0.5 * (broken[:, axis].min() + broken[:, axis].max())
        planes.append((axis, position))
    return planes


def section_axes(axis):
    """The coordinates drawn to the right and upwards in a section."""
    return {0: (2, 1), 1: (0, 2), 2: (0, 1)}[axis]


def draw_section(axes, fields, axis, position):
    """The phase field in a plane."""
    phase_field = np.clip(fields.data["phase_field"], 0., 1.)
    triangles, values = surfaces.plane_section(fields.points, fields.cells,
                                               phase_field, axis, position)
    corners = triangles.reshape(-1, 3)[:, list(section_axes(axis))]
    if len(corners):
        axes.tripcolor(corners[:, 0], corners[:, 1],
                       np.arange(len(corners)).reshape(-1, 3), values.ravel(),
                       shading="gouraud", cmap=pictures.COLORS, vmin=0., vmax=1.)


def section_window(region, axis):
    return pictures.window_of(corners_of(region)[:, list(section_axes(axis))])


def section_picture(fields, axis, position, region):
    """(PNG of the phase field in a plane, its window)."""
    window = section_window(region, axis)
    figure, axes = pictures.canvas(window)
    draw_section(axes, fields, axis, position)
    return pictures.png_of(figure), window


def surface_picture(points, faces, normals, values, window):
    """PNG of the faces that are turned to the viewer, with their edges, coloured
    by the phase field (one value for each face)."""
    visible = normals @ view()[2] > 0.
    figure, axes = pictures.canvas(window, 780)
    if visible.any():
        colors = shaded(pictures.COLORS(values[visible])[:, :3], normals[visible])
        width = float(np.clip(22. / np.sqrt(visible.sum()), 0.1, 0.6))
        add_polygons(axes, [seen(face) for face in points[faces[visible]]], colors,
                     pictures.OUTLINE, width)
    return pictures.png_of(figure)


def mesh_picture(fields):
    """PNG of the mesh on the faces of the body, with the phase field."""
    phase_field = np.clip(fields.data["phase_field"], 0., 1.)
    normals = surfaces.normals_of(fields.points, fields.cells, fields.faces)
    return surface_picture(fields.points, fields.faces, normals,
                           phase_field[fields.faces].mean(axis=1),
                           common_window([fields.points]))


def deformed_picture(fields, scale, window):
    """PNG of the deformed body without its broken cells."""
    points = pictures.deformed_points(fields, scale)
    phase_field = np.clip(fields.data["phase_field"], 0., 1.)
    whole = fields.cells[phase_field[fields.cells].min(axis=1) >= pictures.BROKEN]
    if not len(whole):
        whole = fields.cells
    faces = vtu.outer_faces(fields.points, vtu.faces_of_hexahedra(whole))
    normals = surfaces.normals_of(points, whole, faces)
    return surface_picture(points, faces, normals,
                           phase_field[faces].mean(axis=1), window)
