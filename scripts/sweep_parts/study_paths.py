# SPDX-License-Identifier: GPL-2.0-or-later
"""How far the crack paths of two runs lie apart."""
import numpy as np

from report_parts import crack_path
from study_parts.polylines import distances

from . import studies


def polylines(directory):
    lines = crack_path.lines_at_end(directory)
    if not lines:
        raise studies.StudyError("%s: %s" % (
            directory, "there is no crack_path.csv" if lines is None else
            "crack_path.csv holds no crack"))
    return [np.array(line) for line in lines]


def written(first, second):
    """Largest and mean distance of the points of each path to the other; mm."""
    a, b = polylines(first), polylines(second)
    text = ""
    for name, lines, others in ((first, a, b), (second, b, a)):
        apart = distances(np.concatenate(lines), others)
        text += "%s: at most %.4g mm, %.4g mm on average from the other\n" \
            % (name, apart.max(), apart.mean())
    return text
