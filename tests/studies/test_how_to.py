#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What doc/studies.md tells to type works: a newcomer's path from a fresh clone to a
submitted array in at most four commands, and the examples for other queues.

usage: test_how_to.py EXECUTABLE

Installing and building are replaced by what is there. Exit status 77 where Slurm is
not installed.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import slurm
from sweeps import ROOT, SKIPPED, Sweep

PAGE = (ROOT / "doc" / "studies.md").read_text(encoding="utf-8")
MOST = 4  # commands
OPTIONS = "a.sweep --program ./mixed-cracks --output out"
PAIR = "base = base.prm\na = --set Model/Height=6\nb = --set Model/Height=7\n"


def block(after, language="sh"):
    """The first piece of code behind some words of the page."""
    text = PAGE.partition(after)[2]
    assert text, "the page has no '%s'" % after
    return re.search(r"```%s\n(.*?)```" % language, text, re.DOTALL).group(1)


def run(text, folder, **more):
    """What a script says; it has to succeed."""
    process = subprocess.run(["bash", "-e", "-c", text], cwd=folder, text=True,
                             stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, check=False,
                             env=dict(os.environ, **more))
    assert process.returncode == 0, (text, process.stdout)
    return process.stdout


def a_newcomer(folder):
    """From a fresh clone to a submitted array."""
    lines = block("## From nothing").strip().splitlines()
    assert sum(len(line.split(" && ")) for line in lines) <= MOST, lines
    install, build, submit = lines
    assert "cmake --preset release" in build
    clone = "git clone '%s' mixed-cracks && cd mixed-cracks" % ROOT
    # instead of installing and half an hour of compiling
    install = "MIXED_CRACKS_NO_INSTALL=1 " + install
    build = "mkdir -p build && ln -s '%s' build/mixed-cracks" % os.path.abspath(
        sys.argv[1])
    # what is submitted is looked at, and not calculated
    said = run("\n".join([clone, install, build, submit, "scancel --user=$(id -u)"]),
               folder)
    assert "#SBATCH --array=0-9\n" in said and "#SBATCH --ntasks=2\n" in said, said
    assert re.search(r"submitted 10 cases: job \d+; the table: job \d+", said), said


def prepared(folder, name):
    """A sweep whose program is none, in a copy of what the examples expect."""
    sweep = Sweep(folder / name, PAIR)
    (sweep.folder / "scripts").symlink_to(ROOT / "scripts")
    run("scripts/sweep.py plan FILE.sweep --names > names.txt".replace(
        "FILE.sweep", OPTIONS), sweep.folder)
    assert (sweep.folder / "names.txt").read_text() == "a\nb\n"
    return sweep


def for_tests(text):
    """An example with the program that is none, and no mpirun."""
    text = text.replace("FILE.sweep", OPTIONS)
    return re.sub(r"--ranks (\S+?)( --|\"|\s|$)", r"--ranks \1 --launcher ''\2", text)


def array_of(folder, name, variable, **more):
    sweep = prepared(folder, name)
    text = for_tests(block("**%s**" % name))
    for index in ("1", "2"):
        run(text, sweep.folder, **{variable: index}, **more)
    sweep.call("collect")


def parallel(folder):
    """With xargs where there is no GNU parallel: it calls the same."""
    sweep = prepared(folder, "parallel")
    text = for_tests(block("**GNU parallel**"))
    if shutil.which("parallel") is None:
        text = text.replace("parallel -j 4", "xargs -P 4 -I {}")
    run(text, sweep.folder)
    sweep.call("collect")


def snakemake(folder):
    """The command of its rule, where there is no Snakemake."""
    sweep = prepared(folder, "snakemake")
    text = block("**Snakemake**", "python")
    command = re.search(r'shell: "(.*)"', text).group(1)
    for name in ("a", "b"):
        run(for_tests(command.replace("{wildcards.name}", name).replace(
            "{threads}", "2")), sweep.folder)
    sweep.call("collect")


def the_file(folder):
    """The sweep file that the page shows has the cases that it says."""
    sweep = Sweep(folder / "file", block("## The file").replace(
        "punctured_strip.prm", "base.prm"))
    names = [line.split()[0] for line in sweep.call("plan").splitlines()[:-2]]
    heights = ("6", "10", "12", "14", "16", "18")
    assert names == ["coarse"] + ["%s_%s" % (material, height) for material in (
        "neo_hooke", "fit150") for height in heights], names
    (sweep.folder / "cluster.ini").write_text(block("## Resources", "ini"))
    said = sweep.call("submit", "--dry-run")
    assert "\nmodule load openmpi\nmodule load dealii\n" in said, said
    assert "--array=0-12%20\n" in said and "--time=2:00:00\n" in said, said


def main():
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        folder.chmod(0o755)  # munge wants everybody to get in
        the_file(folder)
        array_of(folder, "PBS", "PBS_ARRAY_INDEX", PBS_O_WORKDIR=".", PBS_JOBID="7[1]")
        array_of(folder, "SGE", "SGE_TASK_ID", JOB_ID="7")
        parallel(folder)
        snakemake(folder)
        if slurm.missing():
            print("skipped: the newcomer's path, for there is no Slurm here (%s); "
                  "scripts/install-packages brings it" % ", ".join(slurm.missing()))
            return SKIPPED
        if not (ROOT / ".git").exists():
            print("skipped: the newcomer's path, for this is no clone")
            return SKIPPED
        cluster = slurm.Cluster(folder / "slurm", cpus=2)
        try:
            a_newcomer(folder)
        finally:
            cluster.stop()
    return 0


if __name__ == "__main__":
    sys.exit(main())
