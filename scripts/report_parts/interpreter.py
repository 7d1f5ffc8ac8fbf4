# SPDX-License-Identifier: GPL-2.0-or-later
"""Find a Python that has matplotlib and numpy; Python's own library only."""
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


def use_one_with_matplotlib():
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
    sys.exit("%s: no Python with matplotlib and numpy was found (tried: %s).\n"
             "On Debian: apt-get install python3-matplotlib; or name one in "
             "MIXED_CRACKS_PYTHON." % (os.path.basename(sys.argv[0]),
                                       ", ".join([sys.executable] + candidates)))
