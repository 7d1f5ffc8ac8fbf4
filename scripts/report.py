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


def read_arguments():
    parser = argparse.ArgumentParser(
        description="Write RESULT_DIR/report.html, one page about a run.")
    parser.add_argument("directory", metavar="RESULT_DIR",
                        help="output directory of a run of mixed-cracks")
    parser.add_argument("--output", metavar="FILE",
                        help="write the page to FILE instead")
    parser.add_argument("--animate", nargs="?", const="", metavar="FILE.webp|DIR",
                        help="a video of the run instead of the page, or a series of "
                        "PNG in DIR (RESULT_DIR/animation.webp)")
    parser.add_argument("--frames-per-second", type=float, default=5., metavar="N",
                        help="of the video (5)")
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
    target = output or target_in(directory, "report.html")
    if not output and not is_ours(target):
        sys.exit("report.py: '%s' is no page of this script and is left as it is; "
                 "name another file with --output." % target)
    text = page.written(directory)
    # the old page stays until the new one is whole
    with open(target + ".new", "w", encoding="utf-8", errors="replace") as stream:
        stream.write(text)
    if target == os.path.join(directory, "report.html"):
        note_in_list(directory, "report.html")
    os.replace(target + ".new", target)
    return target


def write_video(directory, output, per_second):
    """Returns its name."""
    from report_parts import animation, results
    target = output or target_in(directory, "animation.webp")
    try:
        animation.write(results.Results(directory), target, per_second)
    except animation.AnimationError as error:
        sys.exit("report.py: %s." % error)
    if target == os.path.join(directory, "animation.webp"):
        note_in_list(directory, "animation.webp")
    return target


def main():
    arguments = read_arguments()
    import matplotlib
    matplotlib.use("Agg")
    try:
        if arguments.animate is None:
            target = write_page(arguments.directory, arguments.output)
        else:
            target = write_video(arguments.directory, arguments.animate,
                                 arguments.frames_per_second)
    except OSError as error:
        sys.exit("report.py: %s" % error)
    except Exception as error:  # whatever the files hold, no trace of the inside
        sys.exit("report.py: the %s of '%s' cannot be made (%s: %s)."
                 % ("page" if arguments.animate is None else "video",
                    arguments.directory, type(error).__name__,
                    " ".join(str(error).split())[:300]))
    print(target)


if __name__ == "__main__":
    interpreter.use_one_with_matplotlib()
    main()
