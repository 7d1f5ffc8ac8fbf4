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


LIST = "run_files.txt"  # what the run has written; --overwrite removes that


def is_ours(target):
    """Whether there is no page yet, or one that this script has written."""
    try:
        with open(target, encoding="utf-8", errors="replace") as stream:
            return " – mixed-cracks</title>" in stream.read(4000)
    except OSError:
        return True


def note_in_list(directory, name):
    """Have a file removed with the run, where the run keeps a list."""
    path = os.path.join(directory, LIST)
    try:
        with open(path, encoding="utf-8", errors="replace") as stream:
            lines = stream.read().splitlines()
        if lines and lines[0].startswith("# written by a run of mixed-cracks") \
                and name not in lines:
            with open(path, "a", encoding="utf-8") as stream:
                stream.write(name + "\n")
    except OSError:
        pass  # no list, or one that is not ours to change


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
    if not arguments.output and not is_ours(target):
        sys.exit("report.py: '%s' is no page of this script and is left as it is; "
                 "name another file with --output." % target)
    try:
        text = page.written(arguments.directory)
        # the old page stays until the new one is whole
        with open(target + ".new", "w", encoding="utf-8",
                  errors="replace") as stream:
            stream.write(text)
        if not arguments.output:
            note_in_list(arguments.directory, "report.html")
        os.replace(target + ".new", target)
    except OSError as error:
        sys.exit("report.py: %s" % error)
    except Exception as error:  # whatever the files hold, no trace of the inside
        sys.exit("report.py: the page of '%s' cannot be made (%s: %s)."
                 % (arguments.directory, type(error).__name__,
                    " ".join(str(error).split())[:300]))
    print(target)


if __name__ == "__main__":
    interpreter.use_one_with_matplotlib()
    main()
