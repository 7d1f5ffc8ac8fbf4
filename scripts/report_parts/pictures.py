# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of the phase field, the mesh and the deformed body as PNG."""
import io

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure

from . import vtu

# Intact is nearly white, so that a print needs little ink; broken is dark.
COLORS = LinearSegmentedColormap.from_list(
    "phase field", ["#3b0f2b", "#8c2a3a", "#d9743f", "#f2c98a", "#f3efe6"])
CSS_GRADIENT = "#3b0f2b, #8c2a3a, #d9743f, #f2c98a, #f3efe6"
OUTLINE = "#52606c"
# Of the paths of cracks, in their order; they stand out on white.
PATH_COLORS = ("#b5403a", "#2f6690", "#4f8a5b", "#c08a2d", "#6d4c8f")
# Cells that reach less, or are stretched more, are left out of the deformed
# picture: they are the crack.
BROKEN, TORN = 0.1, 8.


def corner_triangles(faces):
    """Triangles of the faces; a face with a repeated corner gives one."""
    first = faces[:, [0, 1, 2]]
    second = faces[faces[:, 2] != faces[:, 3]][:, [0, 2, 3]]
    return np.concatenate([first, second])


def edges_of(points, faces):
    """(unique edges as point pairs, how many faces share each)."""
    place = vtu.merged_points(points)
    pairs = np.concatenate([faces[:, [i, (i + 1) % 4]] for i in range(4)])
    pairs = pairs[place[pairs[:, 0]] != place[pairs[:, 1]]]
    keys = np.sort(place[pairs], axis=1)
    _, first, count = np.unique(keys, axis=0, return_index=True, return_counts=True)
    return pairs[first], count


def point_finder(points):
    """find(position): number of a point there, or None. Hanging nodes beside a
    curved boundary are not quite in the middle of the long edge."""
    reach = 2e-4 * (float(np.ptp(points, axis=0).max()) or 1.)
    places = {}
    for i, place in enumerate(np.floor(points[:, :2] / reach).astype(int)):
        places.setdefault(tuple(place), i)

    def find(position):
        x, y = np.floor(position[:2] / reach).astype(int)
        for near in ((x + i, y + j) for i in (0, -1, 1) for j in (0, -1, 1)):
            if near in places:
                return places[near]
        return None
    return find


def outline_of(points, faces):
    """Boundary edges. At a hanging node the long edge and its two halves each
    belong to one face only: they are no boundary."""
    pairs, count = edges_of(points, faces)
    pairs = pairs[count == 1]
    place = vtu.merged_points(points)
    ends = place[pairs]
    number = {tuple(sorted(pair)): i for i, pair in enumerate(ends)}
    used = np.unique(pairs)
    find = point_finder(points[used])
    keep = np.ones(len(pairs), bool)
    for i, (a, b) in enumerate(ends):
        middle = find(points[pairs[i]].mean(axis=0))
        if middle is None:
            continue
        hanging = place[used[middle]]
        halves = [number.get(tuple(sorted((end, hanging)))) for end in (a, b)]
        if None not in halves:
            keep[[i] + halves] = False
    return pairs[keep]


def window_of(points, margin=0.02):
    low, high = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
    pad = margin * max(high - low)
    return low - pad, high + pad


def canvas(window, pixels=560):
    """A figure that shows the window with equal scales, the longer of its
    sides `pixels` long, and axes that fill it."""
    low, high = window
    size = high - low
    size = np.maximum(size * pixels / max(size.max(), 1e-300), 40.)
    figure = Figure(figsize=tuple(size / 100.), dpi=100)
    axes = figure.add_axes([0, 0, 1, 1])
    show(axes, window)
    return figure, axes


def show(axes, window):
    """Of axes this window, with equal scales and without a frame."""
    (x0, y0), (x1, y1) = window
    axes.set(xlim=(x0, x1), ylim=(y0, y1), aspect="equal")
    axes.axis("off")


def png_of(figure, dpi=150):
    stream = io.BytesIO()
    with matplotlib.rc_context({"savefig.facecolor": "white"}):
        figure.savefig(stream, format="png", dpi=dpi,
                       metadata={"Software": None}, pil_kwargs={"optimize": True})
    return stream.getvalue()


def is_flat(fields):
    return np.ptp(fields.points[:, 2]) <= 1e-9 * np.ptp(fields.points[:, :2])


def paint(axes, fields, points, faces, values, colors=COLORS, limits=(0., 1.)):
    triangles = corner_triangles(faces)
    if not is_flat(fields):  # far faces first
        triangles = triangles[np.argsort(points[triangles, 2].mean(axis=1),
                                         kind="stable")]
    axes.tripcolor(points[:, 0], points[:, 1], triangles, values,
                   shading="gouraud", cmap=colors, vmin=limits[0],
                   vmax=limits[1])


def lines(axes, points, pairs, width, color=OUTLINE):
    axes.add_collection(LineCollection(points[pairs][:, :, :2], colors=color,
                                       linewidths=width, capstyle="round"))


def draw_outline(axes, fields, width=0.8, color=OUTLINE):
    """Of the undeformed body, where it is flat."""
    if is_flat(fields):
        lines(axes, fields.points, outline_of(fields.points, fields.faces), width,
              color)


def draw_body(axes, fields, points, faces, width=0.8):
    """The phase field, and the outline of a flat body."""
    phase_field = fields.data.get("phase_field", np.ones(len(points)))
    paint(axes, fields, points, faces, np.clip(phase_field, 0., 1.))
    if is_flat(fields):
        lines(axes, points, outline_of(fields.points, faces), width)


def color_bar(figure, axes, colors, limits, ticks):
    """To the right; ticks: numbers, or what chooses them."""
    figure.colorbar(ScalarMappable(Normalize(*limits), colors), cax=axes, ticks=ticks,
                    orientation="horizontal").outline.set_visible(False)


def phase_field_picture(fields):
    """PNG of the phase field on the undeformed body."""
    figure, axes = canvas(window_of(fields.points))
    draw_body(axes, fields, fields.points, fields.faces)
    return png_of(figure)


def path_color(index):
    return PATH_COLORS[index % len(PATH_COLORS)]


def path_picture(fields, cracks):
    """PNG of the outline with the paths of the cracks: a disc where one starts,
    a square where it ends."""
    figure, axes = canvas(window_of(fields.points))
    draw_outline(axes, fields)
    for index, crack in enumerate(cracks):
        x, y = zip(*crack.points)
        color = path_color(index)
        axes.plot(x, y, "-", color=color, lw=2.2, solid_capstyle="round")
        axes.plot(x[0], y[0], "o", color=color, ms=7, clip_on=False)
        axes.plot(x[-1], y[-1], "s", mfc="white", mec=color, mew=1.8, ms=6.5,
                  clip_on=False)
    return png_of(figure)


def mesh_picture(fields):
    """PNG of the mesh; thinner lines where there are many cells."""
    figure, axes = canvas(window_of(fields.points), 780)
    pairs, _ = edges_of(fields.points, fields.faces)
    width = float(np.clip(30. / np.sqrt(len(fields.faces)), 0.12, 0.7))
    lines(axes, fields.points, pairs, width)
    return png_of(figure)


def deformation_scale(fields, always_true=False):
    """1 where the deformation can be seen as it is, otherwise a round factor
    that makes the largest displacement a tenth of the body. Large strains are
    shown as they are, however small or large displacements are."""
    size = float(np.ptp(fields.points, axis=0).max())
    largest = float(np.linalg.norm(fields.data["displacement"], axis=1).max())
    if largest <= 0. or not np.isfinite(largest):
        return None
    if always_true or 0.02 * size <= largest <= 2. * size:
        return 1.
    factor = 0.1 * size / largest
    power = 10. ** np.floor(np.log10(factor))
    return float(power * max(n for n in (1, 2, 5) if n * power <= factor * 1.0001))


def deformed_points(fields, scale):
    displacement = fields.data["displacement"]
    points = fields.points.copy()
    points[:, :displacement.shape[1]] += scale * displacement
    return points


def longest_edges(points, faces):
    corners = points[faces]
    return np.linalg.norm(corners - np.roll(corners, 1, axis=1),
                          axis=2).max(axis=1)


def common_window(all_points):
    """One window for bodies that are to be compared by eye."""
    low, high = zip(*map(window_of, all_points))
    return np.min(low, axis=0), np.max(high, axis=0)


def unbroken_faces(fields, points, scale):
    """Those that are seen of the deformed body; all where none would be."""
    phase_field = fields.data.get("phase_field", np.ones(len(points)))
    stretch = longest_edges(points, fields.faces) \
        / np.maximum(longest_edges(fields.points, fields.faces), 1e-300)
    faces = fields.faces[(phase_field[fields.faces].min(axis=1) >= BROKEN)
                         & (stretch <= TORN * max(scale, 1.))]
    return faces if len(faces) else fields.faces


def deformed_picture(fields, scale, window):
    """PNG of the deformed body without its broken cells."""
    points = deformed_points(fields, scale)
    figure, axes = canvas(window, 780)
    draw_body(axes, fields, points, unbroken_faces(fields, points, scale), 0.7)
    return png_of(figure)
