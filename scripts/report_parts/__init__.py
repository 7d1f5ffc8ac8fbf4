# SPDX-License-Identifier: GPL-2.0-or-later
"""The parts of scripts/report.py: results, vtu, crack_path,
moments, curves, pictures, words, page; interpreter finds a Python for them.
Other scripts share with it csv_table, errors, options and safe."""
