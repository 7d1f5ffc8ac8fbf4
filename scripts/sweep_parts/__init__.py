# SPDX-License-Identifier: GPL-2.0-or-later
"""The parts of scripts/sweep.py (sweep_file, runner, table) and scripts/study.py."""
