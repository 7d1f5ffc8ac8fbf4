#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Write RESULT_DIR/report.html, one self-contained page about a run.

    scripts/report.py results/punctured_strip

Needs matplotlib and numpy (Debian: python3-matplotlib). Works while the run is
going on and after one that failed; needs no display.
"""
import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from report_parts import interpreter  # noqa: E402


def main():
    parser = argparse.ArgumentParser(
        description="Write RESULT_DIR/report.html, one page about a run.")
    parser.add_argument("directory", metavar="RESULT_DIR",
                        help="output directory of a run of mixed-cracks")
    parser.add_argument("--output", metavar="FILE",
                        help="write the page to FILE instead")
    arguments = parser.parse_args()
    if not os.path.isdir(arguments.directory):
        sys.exit("report.py: there is no directory '%s'." % arguments.directory)
    import matplotlib
    matplotlib.use("Agg")
    from report_parts import page
    target = arguments.output or os.path.join(arguments.directory, "report.html")
    text = page.written(arguments.directory)
    try:
        # the old page stays until the new one is whole
        with open(target + ".new", "w", encoding="utf-8") as stream:
            stream.write(text)
        os.replace(target + ".new", target)
    except OSError as error:
        sys.exit("report.py: %s" % error)
    print(target)


if __name__ == "__main__":
    interpreter.use_one_with_matplotlib()
    main()
