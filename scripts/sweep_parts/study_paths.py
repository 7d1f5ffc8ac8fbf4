# SPDX-License-Identifier: GPL-2.0-or-later
"""How far the crack paths of two runs lie apart."""
import numpy as np

from report_parts import crack_path
from study_parts.polylines import distances

from . import studies


def polylines(directory):
    remarks = []
    cracks = crack_path.cracks_at_end(directory, remarks)
    if cracks is None:
        raise studies.StudyError("%s: there is no crack_path.csv" % directory)
    lines = [np.array(crack.points) for crack in cracks if len(crack.points) > 1]
    if not lines:
        raise studies.StudyError("%s: crack_path.csv holds no crack" % directory)
    return lines


def written(first, second):
    """Largest and mean distance of the points of each path to the other; mm."""
    a, b = polylines(first), polylines(second)
    text = ""
    for name, lines, others in ((first, a, b), (second, b, a)):
        apart = distances(np.concatenate(lines), others)
        text += "%s: at most %.4g mm, %.4g mm on average from the other\n" \
            % (name, apart.max(), apart.mean())
    return text
