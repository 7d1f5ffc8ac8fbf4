# SPDX-License-Identifier: GPL-2.0-or-later
"""The parts of scripts/report.py: results, vtu, moments, curves, pictures, page."""
