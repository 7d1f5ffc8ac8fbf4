# SPDX-License-Identifier: GPL-2.0-or-later
"""What goes wrong with a sweep through nobody's fault but the input's."""
from report_parts.errors import InputError


class SweepError(InputError):
    """What is wrong with a sweep file or its use; the text is for a person. Ends a
    script with exit status 2."""
