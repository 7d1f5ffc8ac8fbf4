# SPDX-License-Identifier: GPL-2.0-or-later
"""Making sure of what drawing needs, before anything is run."""
import os

from report_parts import interpreter

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
    import matplotlib
    matplotlib.use("Agg")


def save(figure, path, salt="study"):
    """As SVG or PNG; equal figures make equal files."""
    import matplotlib
    from report_parts import curves
    options = {"metadata": {"Date": None}} if path.endswith(".svg") else {
        "dpi": 110, "metadata": {"Software": None}}
    settings = {"svg.hashsalt": salt, "svg.fonttype": "none"}
    with matplotlib.rc_context(dict(curves.STYLE, **settings)):
        figure.savefig(path, bbox_inches="tight", facecolor="white", **options)
