#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What the pages for newcomers tell to type works: their blocks of commands are run
as they stand, in the order of the pages, in a copy of the project that has the built
program.

usage: test_pages.py EXECUTABLE [PAGE ...]

Prints the seconds of each page. A page that draws its mesh with Gmsh is left out, and
the exit status is 77, where there is no Gmsh.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1])]
from pages import ROOT, SKIPPED, blocks, text_of  # noqa: E402
from program import environment  # noqa: E402

# later pages go on from what earlier ones have left
PAGES = ("doc/start.md", "doc/howto/own_mesh.md", "doc/howto/own_sweep.md",
         "doc/howto/restart.md", "doc/howto/compare.md", "doc/howto/own_law.md")
# what the pages say is there in the end
LEFT = ("results/my_strip/report.html", "results/my_strip/fields.pvd", "my_strip.png",
        "results/my_strip_low/summary.json", "plate.png", "results/plate/report.html",
        "results/heights/sweep.csv", "results/heights/report.html", "curves.svg",
        "cracks.png", "results/heights/soft_16/statistics.csv",
        "results/in_pieces/summary.json", "results/heights/comparison/soft_16.svg",
        "fit.svg", "my_rubber.prm")


def copy_of_the_project(folder):
    for name in ("scripts", "parameters", "meshes"):
        shutil.copytree(ROOT / name, folder / name,
                        ignore=shutil.ignore_patterns("__pycache__"))
    (folder / "tests").mkdir()
    shutil.copytree(ROOT / "tests" / "identify", folder / "tests" / "identify")
    (folder / "build").mkdir()
    (folder / "build" / "mixed-cracks").symlink_to(os.path.abspath(sys.argv[1]))
    (folder / "home").mkdir()


def run(commands, folder):
    """Each line has to succeed, as it would where it is typed; what they say."""
    process = subprocess.run(
        ["bash", "-e", "-o", "pipefail", "-c", commands], cwd=folder, text=True,
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        check=False, env=environment(HOME=str(folder / "home")))
    assert process.returncode == 0, (commands, process.returncode, process.stdout)
    return process.stdout


def scripts_exist(commands):
    """Of a set-up that is not run: the scripts that it calls can be called."""
    for name in re.findall(r"scripts/[\w-]+", commands):
        assert os.access(ROOT / name, os.X_OK), name


def said_as_printed(page, said):
    """Lines of a run that a page shows are what the run has said."""
    for shown in re.findall(r"^```text\n(.*?)^```$", text_of(page), re.M | re.S):
        for line in shown.splitlines():
            beginning = re.split(r"\d", line)[0].rstrip()
            assert beginning in said, (page, line)


def walk(page, folder):
    said = ""
    for mark, commands in blocks(page):
        if mark == "set-up":
            scripts_exist(commands)
        else:
            assert mark == "run", (page, mark)
            said += run(commands, folder)
    said_as_printed(page, said)


def main():
    skipped = shutil.which("gmsh") is None
    pages = sys.argv[2:] or PAGES
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        copy_of_the_project(folder)
        for page in pages:
            if skipped and "gmsh" in text_of(page):
                print("%s skipped: there is no Gmsh" % page)
                continue
            begin = time.monotonic()
            walk(page, folder)
            print("%-28s %5.1f s" % (page, time.monotonic() - begin), flush=True)
        if not sys.argv[2:] and not skipped:
            missing = [name for name in LEFT if not (folder / name).exists()]
            assert not missing, missing
        for name in os.environ.get("KEEP", "").split():  # pictures for the pages
            shutil.copy(folder / name, ".")
        subprocess.run(["chmod", "-R", "u+w", str(folder)], check=True)
    return SKIPPED if skipped else 0


if __name__ == "__main__":
    sys.exit(main())
