# SPDX-License-Identifier: GPL-2.0-or-later
"""Making sure of what drawing needs, before anything is run."""
import os
import sys

from report_parts import interpreter, safe

from .errors import StudyError

SUFFIXES = (".svg", ".png")


def require(path=None, option="--output"):
    """Starts again with a Python that has matplotlib where this one has none, and
    refuses a name that cannot be written."""
    if path is not None:
        if not path.endswith(SUFFIXES):
            raise StudyError("%s: expected a name that ends in %s, found '%s'"
                             % (option, " or ".join(SUFFIXES), path))
        folder = os.path.dirname(os.path.abspath(path))
        if not os.path.isdir(folder):
            raise StudyError("%s: there is no directory '%s'" % (option, folder))
    interpreter.use_one_with_matplotlib()


def label(axes, per_thickness=False):
    """Of curves of forces, 0 in sight."""
    axes.set_xlim(left=min(0., axes.dataLim.x0))
    axes.set_ylim(bottom=min(0., axes.dataLim.y0))
    axes.set(xlabel="Displacement (mm)", ylabel="Force per thickness (N/mm)"
             if per_thickness else "Force (N)")


def save(figure, path, salt="study", dpi=110):
    """As SVG or PNG; equal figures make equal files."""
    import matplotlib
    from report_parts import curves
    options = {"metadata": {"Date": None}} if path.endswith(".svg") else {
        "dpi": dpi, "metadata": {"Software": None}}
    settings = {"svg.hashsalt": salt, "svg.fonttype": "none"}
    with matplotlib.rc_context(dict(curves.STYLE, **settings)):
        figure.savefig(path, bbox_inches="tight", facecolor="white", **options)


def drawn(path, draw, *arguments):
    """Whether draw(*arguments) has made a figure and it is saved. Files of runs may
    hold what nobody foresaw: then a line, and no figure."""
    try:
        save(draw(*arguments), path)
        return True
    except OSError:
        raise
    except Exception as error:  # the tables are still worth having
        print("%s could not be drawn (%s)" % (path, safe.in_words(error)),
              file=sys.stderr)
        return False
