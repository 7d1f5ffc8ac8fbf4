# SPDX-License-Identifier: GPL-2.0-or-later
"""What becomes of the runs of a sweep: comparison with experiments (references,
polylines, curve_difference, comparison), bisection, uncertainty (variations), and the
page of a sweep."""
