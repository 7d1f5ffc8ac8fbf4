# SPDX-License-Identifier: GPL-2.0-or-later
"""Contact sheet: the phase field at the end of every run of a sweep."""
import io
import os
import pathlib
import textwrap

import matplotlib
from matplotlib.figure import Figure

from report_parts import crack_path, curves, pictures, vtu

from . import studies

PANEL = 1.9  # inches: the longer side of a body, and the least width for words
LINE = 0.155  # of a caption
DPI = 110
PATH_COLOR = "#1fa7c9"  # stands out from intact and broken


def fields_at_end(run):
    """The last phase field that was written, or a reason why there is none."""
    collection = vtu.read_collection(run.results.directory)
    if not collection:
        xdmf = os.path.join(run.results.directory, "fields.xdmf")
        return None, "no VTU" if os.path.isfile(xdmf) else "no fields"
    try:
        fields = vtu.read_fields(collection[-1][1], ("phase_field",))
    except vtu.FieldError as error:
        return None, str(error)
    return (fields, "") if "phase_field" in fields.data else (None, "no phase field")


def caption_lines(run, width):
    peak = [] if run.peak is None else ["%.4g N at %.3g mm" % run.peak[::-1]]
    return peak + textwrap.wrap(run.outcome, width)[:2]


def draw_body(axes, run):
    fields, reason = fields_at_end(run)
    if fields is None:
        axes.text(0.5, 0.5, textwrap.fill(reason, 22), ha="center", va="center",
                  color=curves.GREY, transform=axes.transAxes, fontsize=8)
        return
    pictures.draw_body(axes, fields, fields.points, fields.faces, 0.7)
    for crack in crack_path.cracks_at_end(run.results.directory, []) or ():
        axes.plot(*zip(*crack.points), "-", color=PATH_COLOR, lw=0.8)
    pictures.show(axes, pictures.window_of(fields.points))


def shape_of(runs):
    """Width and height of a body in inches, from the first that can be read."""
    for run in runs:
        fields, _ = fields_at_end(run)
        if fields is not None:
            low, high = pictures.window_of(fields.points)
            return PANEL * (high - low) / max(high - low)
    raise studies.StudyError("no run has written a phase field that can be read")


def draw(runs, n_columns, title):
    width, height = shape_of(runs)
    n_columns = min(n_columns, len(runs))
    n_rows = -(-len(runs) // n_columns)
    cell = max(width, PANEL) + 0.12, height + 4 * LINE + 0.2
    head, foot = (0.35 if title else 0.08), 0.42
    size = n_columns * cell[0] + 0.1, n_rows * cell[1] + head + foot
    figure = Figure(figsize=size, dpi=DPI, facecolor="white")
    if title:
        figure.text(0.1 / size[0], 1. - 0.22 / size[1], title, fontsize=11.5,
                    color=curves.INK)
    for i, run in enumerate(runs):
        left = 0.1 + (i % n_columns) * cell[0]
        top = size[1] - head - (i // n_columns) * cell[1]
        axes = figure.add_axes([left / size[0], (top - height) / size[1],
                                width / size[0], height / size[1]])
        axes.set_aspect("equal", anchor="W")
        axes.axis("off")
        draw_body(axes, run)
        y = top - height - LINE
        for k, text in enumerate([run.name] + caption_lines(run, 30)):
            figure.text(left / size[0], (y - k * LINE) / size[1], text, fontsize=8,
                        weight="bold" if k == 0 else "normal",
                        color=curves.INK if k == 0 else curves.GREY)
    bar = figure.add_axes([0.62 / size[0], 0.17 / size[1],
                           min(2.2, size[0] / 3.) / size[0], 0.1 / size[1]])
    pictures.color_bar(figure, bar, pictures.COLORS, (0., 1.), [])
    bar.text(-0.03, 0.5, "broken", transform=bar.transAxes, ha="right", va="center",
             fontsize=8, color=curves.GREY)
    bar.text(1.03, 0.5, "intact; phase field on the undeformed body",
             transform=bar.transAxes, va="center", fontsize=8, color=curves.GREY)
    return figure


def small_png(data):
    """With a palette, a third of the size; as it is without PIL."""
    try:
        from PIL import Image
        image = Image.open(io.BytesIO(data)).convert("RGB")
        stream = io.BytesIO()
        image.quantize(128, method=Image.MEDIANCUT, dither=0).save(
            stream, format="png", optimize=True)
    except Exception:  # no PIL, or a version that does it otherwise
        return data
    return min(stream.getvalue(), data, key=len)


def png_of(runs, n_columns, title):
    with matplotlib.rc_context({"font.family": "DejaVu Sans"}):
        return small_png(pictures.png_of(draw(runs, n_columns, title), DPI))


def write(runs, path, n_columns, title):
    pathlib.Path(path).write_bytes(png_of(runs, n_columns, title))
