# SPDX-License-Identifier: GPL-2.0-or-later
"""The parts of scripts/identify.py: rubber_tests (read tests), laws, fitting, stability,
linear_ranges, answer (what is printed); tear_curves and tear (energy release rates);
drawings; settings (options per test)."""
