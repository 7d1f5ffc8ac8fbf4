# SPDX-License-Identifier: GPL-2.0-or-later
"""Find a Python that has the modules a script needs; Python's own library only."""
import importlib
import os
import shutil
import subprocess
import sys

DRAWING = ("numpy", "matplotlib")
ATTEMPTED = "MIXED_CRACKS_REPORT_ATTEMPTED"


def interpreters():
    """Python interpreters of this machine, each once, likeliest first."""
    found = [os.environ.get("MIXED_CRACKS_PYTHON"), shutil.which("python3"),
             "/usr/bin/python3", "/usr/local/bin/python3", "/bin/python3"]
    found += [os.path.join(folder, "python3")
              for folder in os.environ.get("PATH", "").split(os.pathsep)]
    return [path for path in dict.fromkeys(found) if path and os.access(path, os.X_OK)]


def has_modules(interpreter, modules):
    try:
        return subprocess.call([interpreter, "-c", "import " + ", ".join(modules)],
                               stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL) == 0
    except OSError:
        return False


def missing_here(modules):
    """Those of the modules that this Python lacks."""
    missing = []
    for name in modules:
        try:
            importlib.import_module(name)
        except Exception:  # a broken installation raises others than ImportError
            missing.append(name)
    return missing


def use_another(modules):
    """Start again with another python3 that has the modules: the first on the PATH
    may be one that does not see the system's packages. Returns where none has."""
    if ATTEMPTED not in os.environ:
        os.environ[ATTEMPTED] = "1"
        for interpreter in interpreters():
            if has_modules(interpreter, modules):
                sys.stdout.flush()
                os.execv(interpreter, [interpreter] + sys.argv)


def use_one_with_matplotlib():
    if missing_here(DRAWING):
        use_another(DRAWING)
        sys.exit("%s: no Python with matplotlib and numpy was found (tried: %s).\n"
                 "On Debian: apt-get install python3-matplotlib; or name one in "
                 "MIXED_CRACKS_PYTHON."
                 % (os.path.basename(sys.argv[0]),
                    ", ".join([sys.executable] + interpreters())))


def use_one_with(modules):
    """The same for other modules, whose Debian packages are named after them; one
    line and exit status 2 where there is none."""
    missing = missing_here(modules)
    if missing:
        use_another(modules)
        sys.stderr.write("%s: no Python with %s was found; on Debian: apt-get install "
                         "%s, or name one in MIXED_CRACKS_PYTHON\n"
                         % (os.path.basename(sys.argv[0]), ", ".join(modules),
                            " ".join("python3-" + name for name in missing)))
        sys.exit(2)
