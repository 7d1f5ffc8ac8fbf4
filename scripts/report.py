#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Write RESULT_DIR/report.html, one self-contained page about a run.

    scripts/report.py results/punctured_strip
    scripts/report.py results/punctured_strip --animate           a small video
    scripts/report.py results/punctured_strip --animate frames    a series of PNG

--animate writes no page but RESULT_DIR/animation.webp, which browsers show, or the
FILE.webp that is named; another name is that of a directory for frame_0000.png, ....
There is a picture for every moment whose fields were written: with Output/Events those
at which something happened.

Of a case of a sweep, which is not written to, they are SWEEP_DIR/pages/NAME.html and
NAME.webp.

Needs matplotlib and numpy (Debian: python3-matplotlib). Works while the run is
going on and after one that failed; needs no display.
"""
import argparse
import contextlib
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from report_parts import interpreter, options, safe  # noqa: E402


LIST = "run_files.txt"  # what the run has written; --overwrite removes that
PAGE, VIDEO = "report.html", "animation.webp"


def is_ours(target):
    """Whether there is no page yet, or one that this script has written."""
    text = safe.read_text(target)
    return text is None or " – mixed-cracks</title>" in text[:4000]


def note_in_list(directory, target):
    """Have a file of the usual name removed with the run, where the run keeps a list."""
    path, name = os.path.join(directory, LIST), os.path.basename(target)
    if target not in (os.path.join(directory, usual) for usual in (PAGE, VIDEO)):
        return
    lines = (safe.read_text(path) or "").splitlines()
    if lines and lines[0].startswith("# written by a run of mixed-cracks") \
            and name not in lines:
        # the list may not be ours to change
        with contextlib.suppress(OSError), open(path, "a", encoding="utf-8") as stream:
            stream.write(name + "\n")


def read_arguments():
    parser = argparse.ArgumentParser(
        description="Write RESULT_DIR/report.html, one page about a run.")
    options.add(parser, (
        ("directory", "RESULT_DIR", "output directory of a run of mixed-cracks"),
        ("--output", "FILE", "write the page to FILE instead"),
        ("--animate", "FILE.webp|DIR", "a video of the run instead of the page, or a "
         "series of PNG in DIR (RESULT_DIR/animation.webp)", {"nargs": "?", "const": ""}),
        ("--frames-per-second", "N", "of the video (5)", {"type": float, "default": 5.})))
    arguments = parser.parse_args()
    if not os.path.isdir(arguments.directory):
        sys.exit("report.py: there is no directory '%s'." % arguments.directory)
    if not 0.1 <= arguments.frames_per_second <= 100.:
        parser.error("--frames-per-second: expected a number from 0.1 to 100, found %g"
                     % arguments.frames_per_second)
    if arguments.animate is not None and arguments.output:
        parser.error("--output names the page, which --animate does not write; the "
                     "name of the video stands behind --animate")
    return arguments


def target_in(directory, name):
    """Where a file about a run goes: into its directory. That of a case of a sweep is
    left alone, for it is read-only when it is complete; then pages/NAME.* beside."""
    if not os.path.isfile(os.path.join(directory, "case.json")):
        return os.path.join(directory, name)
    sweep = os.path.dirname(os.path.dirname(os.path.realpath(directory)))
    folder = os.path.join(sweep, "pages")
    os.makedirs(folder, exist_ok=True)
    case = os.path.basename(os.path.normpath(directory))
    return os.path.join(folder, case + os.path.splitext(name)[1])


def write_page(directory, output):
    """Returns its name."""
    from report_parts import page
    target = output or target_in(directory, PAGE)
    if not output and not is_ours(target):
        sys.exit("report.py: '%s' is no page of this script and is left as it is; "
                 "name another file with --output." % target)
    text = page.written(directory)
    # the old page stays until the new one is whole
    with open(target + ".new", "w", encoding="utf-8", errors="replace") as stream:
        stream.write(text)
    note_in_list(directory, target)
    os.replace(target + ".new", target)
    return target


def write_video(directory, output, per_second):
    """Returns its name."""
    from report_parts import animation, results
    target = output or target_in(directory, VIDEO)
    try:
        animation.write(results.Results(directory), target, per_second)
    except animation.AnimationError as error:
        sys.exit("report.py: %s." % error)
    note_in_list(directory, target)
    return target


def main():
    arguments = read_arguments()
    try:
        target = write_page(arguments.directory, arguments.output) \
            if arguments.animate is None else write_video(
                arguments.directory, arguments.animate, arguments.frames_per_second)
    except OSError as error:
        sys.exit("report.py: %s" % error)
    except Exception as error:  # whatever the files hold, no trace of the inside
        sys.exit("report.py: the %s of '%s' cannot be made (%s)."
                 % ("page" if arguments.animate is None else "video",
                    arguments.directory, safe.in_words(error)))
    print(target)


if __name__ == "__main__":
    interpreter.use_one_with_matplotlib()
    main()
