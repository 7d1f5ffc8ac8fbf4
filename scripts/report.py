#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Write RESULT_DIR/report.html, one self-contained page about a run.

    scripts/report.py results/punctured_strip

Needs matplotlib and numpy (Debian: python3-matplotlib). Works while the run is
going on and after one that failed; needs no display.
"""
import argparse
import os
import shutil
import subprocess
import sys

NEEDED = "import numpy, matplotlib"
ATTEMPTED = "MIXED_CRACKS_REPORT_ATTEMPTED"


def interpreters():
    """Python interpreters of this machine, each once, likeliest first."""
    found = [os.environ.get("MIXED_CRACKS_PYTHON"), shutil.which("python3"),
             "/usr/bin/python3", "/usr/local/bin/python3", "/bin/python3"]
    for folder in os.environ.get("PATH", "").split(os.pathsep):
        found.append(os.path.join(folder, "python3"))
    unique = []
    for path in found:
        if path and path not in unique and os.access(path, os.X_OK):
            unique.append(path)
    return unique


def can_draw(interpreter):
    try:
        return subprocess.call([interpreter, "-c", NEEDED],
                               stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL) == 0
    except OSError:
        return False


def use_an_interpreter_with_matplotlib():
    """Start again with another python3 when this one lacks the modules: the
    first on the PATH may be one that does not see the system's packages."""
    try:
        import matplotlib  # noqa: F401
        import numpy  # noqa: F401
        return
    except Exception:  # a broken installation raises other errors than ImportError
        pass
    candidates = interpreters()
    if ATTEMPTED not in os.environ:
        os.environ[ATTEMPTED] = "1"
        for interpreter in candidates:
            if can_draw(interpreter):
                sys.stdout.flush()
                os.execv(interpreter, [interpreter] + sys.argv)
    sys.exit("report.py: no Python with matplotlib and numpy was found (tried: %s).\n"
             "On Debian: apt-get install python3-matplotlib; or name one in "
             "MIXED_CRACKS_PYTHON." % ", ".join([sys.executable] + candidates))


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
    sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
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
    use_an_interpreter_with_matplotlib()
    main()
