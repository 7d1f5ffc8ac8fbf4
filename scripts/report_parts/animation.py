# SPDX-License-Identifier: GPL-2.0-or-later
"""A run as a small video: at every moment whose fields were written the deformed body
with its phase field, and beside it how far the force has come. An animated WebP, made
by PIL, or a series of PNG for whatever makes videos."""
import io
import os

import matplotlib.image
import numpy as np
from matplotlib.figure import Figure

from . import curves, moments, pictures, solids, vtu

SIZE = (9.2, 4.6)  # inches
DPI = 80
LAST_FRAME = 2.  # seconds for which the end is seen
PASSED, AHEAD = curves.BLUE, "#c9d0d6"


class AnimationError(Exception):
    """Why there is no video; the text is for a person."""


def chosen(collection, most):
    """At most that many of the moments, first and last among them."""
    if len(collection) <= most:
        return collection
    at = np.unique(np.linspace(0, len(collection) - 1, most).round().astype(int))
    return [collection[i] for i in at]


def read_all(collection):
    """[(time, fields)] of those that can be read."""
    found = []
    for time, path in collection:
        try:
            fields = vtu.read_fields(path, ("phase_field", "displacement"))
        except vtu.FieldError:
            continue
        if "phase_field" in fields.data:
            found.append((time, fields))
    return found


class Frames:
    """What the frames of a run have in common: window, scale of the deformation, and
    the curve."""

    def __init__(self, results, drawn):
        self.results, self.force = results, moments.Force(results)
        self.is_solid = solids.is_solid(drawn[0][1])
        finite = results.parameter("Model/Strains") == "finite"
        last = drawn[-1][1]
        self.scale = pictures.deformation_scale(last, finite) or 0. \
            if "displacement" in last.data and not self.is_solid else 0.
        if self.is_solid:
            self.region = solids.region_of(last)
        else:
            self.window = pictures.common_window(
                [self.points(fields) for _, fields in drawn] + [drawn[0][1].points])

    def points(self, fields):
        return pictures.deformed_points(fields, self.scale) \
            if self.scale and "displacement" in fields.data else fields.points

    def draw_body(self, axes, fields):
        if self.is_solid:
            picture = io.BytesIO(solids.crack_picture(fields, self.region))
            axes.imshow(matplotlib.image.imread(picture, format="png"))
            axes.axis("off")
            return
        points = self.points(fields)
        pictures.draw_body(axes, fields, points,
                           pictures.unbroken_faces(fields, points, self.scale))
        pictures.show(axes, self.window)

    def draw_curve(self, axes, time):
        x, x_label = curves.displacement_of(self.results)
        steps = self.results.column("time_s")
        if self.force.values is None or steps is None:
            axes.axis("off")
            return
        n = max(1, int(np.searchsorted(steps, time * (1. + 1e-9) + 1e-300, "right")))
        axes.plot(x, self.force.values, "-", color=AHEAD, lw=1.2)
        axes.plot(x[:n], self.force.values[:n], "-", color=PASSED, lw=1.8)
        axes.plot(x[n - 1], self.force.values[n - 1], "o", color=PASSED, ms=6)
        axes.set(xlabel=x_label, ylabel=self.force.label)

    def figure(self, time, fields):
        with matplotlib.rc_context(curves.STYLE):
            figure = Figure(figsize=SIZE, dpi=DPI, facecolor="white")
            body, curve = figure.subplots(1, 2, width_ratios=(1., 1.15))
            self.draw_body(body, fields)
            self.draw_curve(curve, time)
            figure.subplots_adjust(left=0.01, right=0.985, top=0.94, bottom=0.13,
                                   wspace=0.18)
            figure.text(0.015, 0.955, "t = %.4g s" % time
                        + ("" if self.scale in (0., 1.) else
                           ", displacement × %.3g" % self.scale),
                        fontsize=9., color=curves.GREY)
            return figure


def frames_of(results, most):
    """Generates (time, PNG) of at most that many moments. Raises AnimationError."""
    collection = vtu.read_collection(results.directory)
    if not collection:
        raise AnimationError("'%s' holds no fields as VTU to make pictures of"
                             % results.directory)
    drawn = read_all(chosen(collection, most))
    if not drawn:
        raise AnimationError("none of the fields in '%s' can be read"
                             % results.directory)
    frames = Frames(results, drawn)
    for time, fields in drawn:
        # all of one size: no part of the frame is cut off
        yield time, pictures.png_of(frames.figure(time, fields), DPI)


def require_webp():
    try:
        from PIL import features
        known = features.check("webp") and features.check("webp_anim")
    except ImportError:
        known = False
    if not known:
        raise AnimationError("PIL is missing or makes no animated WebP (Debian: "
                             "python3-pil); name a directory for a series of PNG "
                             "instead")


def write_webp(frames, path, per_second):
    from PIL import Image
    images = [Image.open(io.BytesIO(png)).convert("RGB") for _, png in frames]
    wait = round(1000. / per_second)
    images[0].save(path + ".new", format="WEBP", save_all=True, loop=0, quality=70,
                   append_images=images[1:], method=4,
                   duration=[wait] * (len(images) - 1) + [round(1000. * LAST_FRAME)])
    os.replace(path + ".new", path)


def write_series(frames, directory):
    """frame_0000.png, ..."""
    os.makedirs(directory, exist_ok=True)
    for number, (_, png) in enumerate(frames):
        with open(os.path.join(directory, "frame_%04d.png" % number), "wb") as stream:
            stream.write(png)


def write(results, path, per_second=5., most=150):
    """A video when the path ends in .webp, otherwise a directory of PNG."""
    if path.endswith(".webp"):
        require_webp()
        write_webp(list(frames_of(results, most)), path, per_second)
    else:
        write_series(frames_of(results, most), path)
