# SPDX-License-Identifier: GPL-2.0-or-later
"""The one exception of this folder."""
from sweep_parts.errors import SweepError


class StudyError(SweepError):
    """What is wrong with the input, as one line for a person: exit status 2."""
