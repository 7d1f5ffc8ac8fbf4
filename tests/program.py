# SPDX-License-Identifier: GPL-2.0-or-later
"""Starting the program from a test, and reading what it leaves. Tests of many kinds
share it; those in a folder find it by its path:

    sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
"""
import csv
import json
import os
import pathlib
import subprocess


def environment(**more):
    """What mpirun needs on any machine, root and few cores included."""
    return dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMP_NUM_THREADS="1",
                OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                OMPI_MCA_rmaps_base_oversubscribe="1",
                OMPI_MCA_hwloc_base_binding_policy="none",
                OMPI_MCA_btl_vader_single_copy_mechanism="none", **more)


def command(executable, launcher=(), ranks=1):
    """The words before the options. One rank needs no launcher, which would take
    as long again as the start of the program."""
    if launcher and int(ranks) > 1:
        return [*launcher, "-n", str(ranks), executable]
    return [executable]


def as_options(settings):
    """--set for each entry; of several the last one holds, as an entry may be set
    once only."""
    words = []
    for setting in dict(setting.split("=", 1) for setting in settings).items():
        words += ["--set", "=".join(setting)]
    return words


def output_of(words, status=0, timeout=1200, **keywords):
    """What it says on both streams; its exit status has to be that one."""
    keywords.setdefault("env", environment())
    result = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, timeout=timeout,
                            check=False, **keywords)
    assert result.returncode == status, (words, result.returncode, result.stdout)
    return result.stdout


def rows(directory):
    path = pathlib.Path(directory) / "statistics.csv"
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def summary(directory):
    path = pathlib.Path(directory) / "summary.json"
    return json.loads(path.read_text(encoding="utf-8"))
