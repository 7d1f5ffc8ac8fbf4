# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of bodies in 3-d as PNG: the surface of the crack within the edges of
the body, plane sections, mesh and deformed body. Parallel projection, far faces
first; x to the right, y upwards, z towards the viewer."""
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


def crack_picture(fields, pixels=560):
    """PNG of the surface phi = 0.5 within the edges of the body; dark where it
    comes out of the body."""
    phase_field = np.clip(fields.data["phase_field"], 0., 1.)
    triangles, _ = surfaces.level_set(fields.points, fields.cells, phase_field,
                                      LEVEL)
    caps = surfaces.caps(fields.points, fields.faces, phase_field, LEVEL)
    figure, axes = pictures.canvas(common_window([fields.points]), pixels)
    edges, towards = edges_of_body(fields), view()[2]
    add_edges(axes, edges, towards, hidden=True)
    polygons = [seen(triangle) for triangle in triangles] \
        + [seen(polygon) for polygon in caps]
    if polygons:
        colors = np.concatenate([
            shaded(to_rgb(CRACK), triangle_normals(triangles)),
            np.tile(to_rgb(CUT), (len(caps), 1))])
        add_polygons(axes, polygons, colors)
    add_edges(axes, edges, towards, hidden=False)
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


def section_picture(fields, axis, position):
    """(PNG of the phase field in a plane, its window)."""
    phase_field = np.clip(fields.data["phase_field"], 0., 1.)
    triangles, values = surfaces.plane_section(fields.points, fields.cells,
                                               phase_field, axis, position)
    across = list(section_axes(axis))
    window = pictures.window_of(fields.points[:, across])
    figure, axes = pictures.canvas(window)
    corners = triangles.reshape(-1, 3)[:, across]
    if len(corners):
        axes.tripcolor(corners[:, 0], corners[:, 1],
                       np.arange(len(corners)).reshape(-1, 3), values.ravel(),
                       shading="gouraud", cmap=pictures.COLORS, vmin=0., vmax=1.)
    return pictures.png_of(figure), window


def surface_picture(points, faces, normals, values, window, pixels=780):
    """PNG of the faces that are turned to the viewer, with their edges, coloured
    by the phase field (one value for each face)."""
    visible = normals @ view()[2] > 0.
    figure, axes = pictures.canvas(window, pixels)
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
