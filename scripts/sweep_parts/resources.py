# SPDX-License-Identifier: GPL-2.0-or-later
"""What a run is given: ranks, time, partition, ... From cluster.ini, for it is no
matter of science, and from options, which count more.

    [cluster]
    ranks     = 4
    time      = 2:00:00
    partition = main
    setup     = module load openmpi

The keys are those of KEYS.
"""
import argparse
import collections
import configparser
import os
import re
import shlex
import shutil

from .errors import SweepError

TIME = re.compile(r"(\d+-)?\d+(:\d+){0,2}$")
MEMORY = re.compile(r"\d+[KMGT]?$")
FILE = "cluster.ini"


def positive(text):
    if not text.isdigit() or int(text) == 0:
        raise argparse.ArgumentTypeError("expected a number of at least 1, found '%s'"
                                         % text)
    return int(text)


def of_pattern(pattern, words):
    def checked(text):
        if not pattern.match(text):
            raise argparse.ArgumentTypeError("expected %s, found '%s'" % (words, text))
        return text
    return checked


Key = collections.namedtuple("Key", "default type metavar help")
KEYS = {
    "ranks": Key(1, positive, "N", "MPI ranks of each run (1)"),
    "time": Key(None, of_pattern(TIME, "a time as 90, 2:00:00 or 1-12:00:00"), "TIME",
                "limit of a job, in minutes or hours:minutes:seconds"),
    "partition": Key(None, str, "NAME", "part of the cluster"),
    "account": Key(None, str, "NAME", "who pays"),
    "memory": Key(None, of_pattern(MEMORY, "a size as 2G or 800M"), "SIZE",
                  "memory of each rank"),
    "launcher": Key(None, str, "COMMAND", "what starts the ranks and takes -n N, as "
                    "'srun --mpi=pmix' or mpirun; '' for none"),
    "at a time": Key(None, positive, "N", "tasks of an array that may run at a time"),
    "cases per job": Key(1, positive, "N", "cases that share a job, side by side (1)"),
    "signal": Key(120, positive, "SECONDS", "how long before its end a job is asked to "
                  "write a checkpoint (120)"),
    "setup": Key("", str, "LINES", "lines of shell before the program starts, as "
                 "'module load openmpi'"),
    "sbatch": Key("", str, "OPTIONS", "more options of sbatch, as '--constraint=avx2'"),
}


def options(*names):
    """The table of report_parts/options.py; of all keys where none is named."""
    return [("--" + name.replace(" ", "-"), key.metavar, key.help, {"type": key.type})
            for name, key in KEYS.items() if name in (names or KEYS)] \
        + [("--cluster", "FILE", "resources (cluster.ini beside the sweep file, or in "
            "this directory)")]


def file_of(arguments):
    """Path of cluster.ini, or None."""
    if arguments.cluster:
        return arguments.cluster
    folders = os.path.dirname(os.path.abspath(arguments.file)), os.getcwd()
    return next(filter(os.path.isfile, (os.path.join(folder, FILE)
                                        for folder in folders)), None)


def read_file(path):
    """{key: value}; raises SweepError."""
    parser = configparser.ConfigParser(interpolation=None)
    try:
        with open(path, encoding="utf-8") as stream:
            parser.read_file(stream)
    except (OSError, UnicodeDecodeError, configparser.Error) as error:
        raise SweepError("%s cannot be read: %s" % (path, str(error).split("\n")[0]))
    if parser.sections() != ["cluster"]:
        raise SweepError("%s: expected the one section [cluster], found %s" % (
            path, ", ".join("[%s]" % name for name in parser.sections()) or "none"))
    found = {}
    for name, text in parser["cluster"].items():
        if name not in KEYS:
            raise SweepError("%s: there is no '%s'; there are %s"
                             % (path, name, ", ".join(KEYS)))
        try:
            # empty is as if it were not there, but for the launcher
            if text or name == "launcher":
                found[name] = KEYS[name].type(text)
        except argparse.ArgumentTypeError as error:
            raise SweepError("%s: %s: %s" % (path, name, error))
    return found


def resources_of(arguments):
    """{key of KEYS: value} of options, file and defaults, in this order."""
    path = file_of(arguments)
    found = read_file(path) if path else {}
    for name, key in KEYS.items():
        given = getattr(arguments, name.replace(" ", "_"), None)
        if given is not None:
            found[name] = given
        found.setdefault(name, key.default)
    return found


def launcher_words(text, needed=True):
    """Of a launcher, mpirun for None, that has to be on this machine where it is
    needed; raises SweepError."""
    words = shlex.split("mpirun" if text is None else text)
    if needed and words and shutil.which(words[0]) is None:
        raise SweepError("--launcher: there is no '%s'" % words[0])
    return words
