# SPDX-License-Identifier: GPL-2.0-or-later
"""A picture of one field of one run, on the deformed body where asked for."""
import os
import pathlib

import matplotlib
import numpy as np
from matplotlib.ticker import MaxNLocator

from report_parts import curves, pictures, vtu

from . import studies
from .study_cracks import small_png

AXES = "xyz"
OTHER_COLORS = "viridis"
UNITS = {"displacement": "mm", "pressure": "MPa", "stress": "MPa",
         "strain_energy_density": "MPa"}
BAR = 0.42  # inches, below the picture


def moment_of(directory, time):
    """(time, file) of the written moment nearest to `time`; None: the last."""
    collection = vtu.read_collection(directory)
    if not collection:
        raise studies.StudyError("'%s' holds no fields as VTU" % directory)
    return collection[-1] if time is None else min(
        collection, key=lambda entry: abs(entry[0] - time))


def values_of(fields, name, path):
    """Of a field, of one component of the displacement, or of its size."""
    if name in fields.data and fields.data[name].ndim == 1:
        return fields.data[name]
    if name == "displacement" and name in fields.data:
        return np.linalg.norm(fields.data[name], axis=1)
    base, _, axis = name.rpartition("_")
    if base == "displacement" and axis in AXES and base in fields.data:
        return fields.data[base][:, AXES.index(axis)]
    raise studies.StudyError(
        "--field: '%s' is not in %s; there are displacement, displacement_x, ..., "
        "and those of doc/output.md" % (name, os.path.basename(path)))


def points_and_faces(fields, deformed):
    """As they are; deformed: without the broken cells."""
    if deformed is None:
        return fields.points, fields.faces
    if "displacement" not in fields.data:
        raise studies.StudyError("--deformed: there is no displacement")
    scale = pictures.deformation_scale(fields) if deformed == "auto" else deformed
    points = pictures.deformed_points(fields, scale or 0.)
    return points, pictures.unbroken_faces(fields, points, scale or 0.)


def told_apart(fields):
    """Coordinates that differ on the two faces of an open slit of the mesh,
    whose points are in one place: there the displacement is appended."""
    displacement = fields.data.get("displacement")
    if displacement is None or not np.abs(displacement).max() > 0.:
        return fields.points
    place = vtu.merged_points(fields.points)
    low = np.full((place.max() + 1, displacement.shape[1]), np.inf)
    high = -low
    np.minimum.at(low, place, displacement)
    np.maximum.at(high, place, displacement)
    largest = np.abs(displacement).max()
    is_open = (high - low).max(axis=1) > 1e-4 * largest
    extent = np.ptp(fields.points, axis=0).max()
    return np.hstack([fields.points, np.where(
        is_open[place][:, None], displacement * (extent / largest), 0.)])


def label_of(name, limits):
    """(limits, words for the colour bar); small lengths in micrometres."""
    unit = next((unit for start, unit in UNITS.items() if name.startswith(start)), "")
    if unit == "mm" and max(map(abs, limits)) < 0.02:
        limits, unit = tuple(1000. * limit for limit in limits), "µm"
    return limits, name.replace("_", " ") + (" (%s)" % unit if unit else "")


def add_bar(figure, limits, label):
    """A colour bar in a strip that is added below."""
    width, height = figure.get_size_inches()
    figure.set_size_inches(width, height + BAR)
    body = figure.axes[0]
    body.set_position([0., BAR / (height + BAR), 1., height / (height + BAR)])
    bar = figure.add_axes([0.05, 0.6 * BAR / (height + BAR), 0.45,
                           0.2 * BAR / (height + BAR)])
    pictures.color_bar(figure, bar, OTHER_COLORS, limits, MaxNLocator(3))
    bar.tick_params(labelsize=6.5, length=2, color=curves.GREY)
    figure.text(0.53, 0.6 * BAR / (height + BAR), label, fontsize=7,
                color=curves.INK)


def limits_of(values):
    low, high = float(values.min()), float(values.max())
    return (low, high) if high > low else (low - 0.5, high + 0.5)


def draw(fields, path, options):
    values = values_of(fields, options.field, path)
    points, faces = points_and_faces(fields, options.deformed)
    shown = [points] if options.deformed is None else [points, fields.points]
    window = pictures.common_window(shown)
    if options.window:
        window = np.array(options.window[:2]), np.array(options.window[2:])
    figure, axes = pictures.canvas(window, options.pixels / 1.5)
    is_phase_field = options.field == "phase_field"
    limits = (0., 1.) if is_phase_field else limits_of(values)
    pictures.paint(axes, fields, points, faces, np.clip(values, *limits),
                   pictures.COLORS if is_phase_field else OTHER_COLORS, limits)
    if pictures.is_flat(fields):
        if options.mesh:
            pairs, _ = pictures.edges_of(points, faces)
            pictures.lines(axes, points, pairs, 0.3, "#ffffff88")
        if options.deformed is not None:
            pictures.draw_outline(axes, fields, 0.6, curves.GREY)
        pictures.lines(axes, points,
                       pictures.outline_of(told_apart(fields), faces), 0.8)
    if not is_phase_field:
        add_bar(figure, *label_of(options.field, limits))
    return figure


def write(directory, path, options):
    """options: field, time, deformed (None, 'auto' or a factor), window
    (x0, y0, x1, y1 or None), mesh, pixels of the longer side of the body."""
    _, source = moment_of(directory, options.time)
    names = ["displacement", "phase_field", options.field]
    try:
        fields = vtu.read_fields(source, tuple(dict.fromkeys(names)))
    except vtu.FieldError as error:
        raise studies.StudyError(str(error))
    with matplotlib.rc_context({"font.family": "DejaVu Sans"}):
        data = pictures.png_of(draw(fields, source, options))
    pathlib.Path(path).write_bytes(small_png(data))
