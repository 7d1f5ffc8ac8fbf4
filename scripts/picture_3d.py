#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""One PNG of a run in 3-d: the surface of the crack at some moments, and sections.

    scripts/picture_3d.py RESULT_DIR --output crack.png
    scripts/picture_3d.py RESULT_DIR --output crack.png --steps 0 5 10 --sections y

--steps: numbers of the fields that were written, counted from 0, negative ones
from the last one back (default: the first, the one in the middle and the last).
--sections: planes normal to these axes, of the last of them; 'none' for none.

Needs matplotlib and numpy (Debian: python3-matplotlib), and no display.
Exit status: 0; 2 for wrong input or usage.
"""
import argparse
import os
import pathlib
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from report_parts import interpreter, safe  # noqa: E402

HEIGHT = 2.1  # of a panel, inches
DPI = 120
CAPTION = 8  # points


def read_arguments():
    parser = argparse.ArgumentParser(
        description="One PNG of a run in 3-d: the surface of the crack, sections.")
    parser.add_argument("directory", metavar="RESULT_DIR")
    parser.add_argument("--output", required=True, metavar="FILE.png")
    parser.add_argument("--steps", type=int, nargs="+", metavar="N")
    parser.add_argument("--sections", default="xyz", metavar="AXES")
    arguments = parser.parse_args()
    if not arguments.output.endswith(".png"):
        parser.error("--output: expected a name that ends in .png, found '%s'"
                     % arguments.output)
    if arguments.sections == "none":
        arguments.sections = ""
    if set(arguments.sections) - set("xyz"):
        parser.error("--sections: expected some of x, y, z or none, found '%s'"
                     % arguments.sections)
    return arguments


def chosen_fields(directory, steps):
    """[(time, Fields)] of bodies in 3-d; raises FieldError."""
    from report_parts import solids, vtu
    collection = vtu.read_collection(directory)
    if not collection:
        raise vtu.FieldError("there are no fields in '%s'" % directory)
    n = len(collection)
    result = []
    for step in sorted({0, n // 2, n - 1}) if steps is None else steps:
        if not -n <= step < n:
            raise vtu.FieldError("--steps: found %d, allowed are %d to %d"
                                 % (step, -n, n - 1))
        time, path = collection[step]
        fields = vtu.read_fields(path, ("phase_field",))
        if not solids.is_solid(fields) or "phase_field" not in fields.data:
            raise vtu.FieldError("'%s' holds no phase field of a body in 3-d" % path)
        result.append((time, fields))
    return result


def panels(moments, axes_names):
    """[(window, draw(axes), caption)]"""
    from report_parts import solids, words
    last = moments[-1][1]
    region = solids.region_of(last)
    window = solids.common_window([solids.corners_of(region)])
    found = [(window, lambda axes, fields=fields: solids.draw_crack(axes, fields,
                                                                     region),
              "t = " + words.number(time, "s")) for time, fields in moments]
    for axis, position in solids.section_planes(last):
        if "xyz"[axis] in axes_names:
            found.append((solids.section_window(region, axis),
                          lambda axes, axis=axis, position=position:
                          solids.draw_section(axes, last, axis, position),
                          "%s = %s; right: %s, up: %s" % (
                              ("xyz"[axis], words.number(position, "mm")) + tuple(
                                  "xyz"[i] for i in solids.section_axes(axis)))))
    return found


def draw(all_panels):
    from matplotlib.figure import Figure
    from matplotlib.textpath import TextPath
    from report_parts import curves, pictures
    widths = [HEIGHT * (high - low)[0] / (high - low)[1]
              for (low, high), _, _ in all_panels]
    # a section of a slender body is narrower than what is said below it
    places = [max(width, TextPath((0., 0.), caption, size=CAPTION).get_extents().width / 72.)
              for width, (_, _, caption) in zip(widths, all_panels)]
    total, height = sum(places) + 0.15 * len(places), HEIGHT + 0.25
    figure = Figure(figsize=(total, height), dpi=DPI, facecolor="white")
    left = 0.05
    for (window, paint, caption), width, place in zip(all_panels, widths, places):
        axes = figure.add_axes([left / total, 0.25 / height, width / total,
                                HEIGHT / height])
        pictures.show(axes, window)
        paint(axes)
        figure.text(left / total, 0.06 / height, caption, fontsize=CAPTION,
                    color=curves.GREY)
        left += place + 0.15
    return figure


def write(arguments):
    from report_parts import pictures
    from sweep_parts import study_cracks
    moments = chosen_fields(arguments.directory, arguments.steps)
    png = pictures.png_of(draw(panels(moments, arguments.sections)), DPI)
    pathlib.Path(arguments.output).write_bytes(study_cracks.small_png(png))
    print(arguments.output)


def main():
    arguments = read_arguments()
    from report_parts import vtu
    return safe.ended("picture_3d.py", vtu.FieldError, "the run cannot be drawn", write,
                      arguments)


if __name__ == "__main__":
    interpreter.use_one_with_matplotlib()
    sys.exit(main())
