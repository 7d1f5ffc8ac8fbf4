# SPDX-License-Identifier: GPL-2.0-or-later
"""Small runs for tests of what lies in output directories: a square of a mesh file
with an initial crack, whose boundaries have commas in their names."""
import csv
import fcntl
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from program import as_options, command, environment, output_of  # noqa: E402

N_CELLS = 20  # per side of 1 mm

CASE = """\
subsection Geometry
  set Name = mesh file
  subsection Mesh file
    set File name = square.msh
    set Boundary names = 1 = bottom ; 2 = right ; 3 = top ; 4 = left, "lower"
  end
end
subsection Model
  set Length scale       = 2*h
  set Residual stiffness = 0.001
end
subsection Material
  set Lame lambda   = 10
  set Shear modulus = 2.4
  set Critical energy release rate = 17
end
subsection Initial cracks
  set Cracks = 0, 0.5 : 0.4, 0.5
end
subsection Boundary conditions
  set Displacement = bottom : all : 0 ; top : x : 0 ; top : y : 0.1*t
end
subsection Load stepping
  set End time      = 1
  set First step    = 0.5
  set Largest step  = 0.5
  set Onset step    = 0.1
  set Smallest step = 0.05
  set Force boundary = top
end
subsection Output
  set Checkpoint every = 1
  set Fields every     = 1
  set Crack opening    = 0.1,0.5 : 0.3,0.5 : 3
  set Traction profiles = top ; left, "lower"
end
"""


def mesh():
    """A square of N_CELLS x N_CELLS cells, for Gmsh."""
    n = N_CELLS + 1

    def node(i, j):
        return 1 + i + n * j

    nodes = ["%d %.12g %.12g 0" % (node(i, j), i / N_CELLS, j / N_CELLS)
             for j in range(n) for i in range(n)]
    sides = [("1", [(node(i, 0), node(i + 1, 0)) for i in range(N_CELLS)]),
             ("2", [(node(N_CELLS, j), node(N_CELLS, j + 1)) for j in range(N_CELLS)]),
             ("3", [(node(i, N_CELLS), node(i + 1, N_CELLS)) for i in range(N_CELLS)]),
             ("4", [(node(0, j), node(0, j + 1)) for j in range(N_CELLS)])]
    elements = ["1 2 %s %s %d %d" % (side, side, a, b)
                for side, pairs in sides for a, b in pairs]
    elements += ["3 2 7 7 %d %d %d %d" % (node(i, j), node(i + 1, j),
                                          node(i + 1, j + 1), node(i, j + 1))
                 for j in range(N_CELLS) for i in range(N_CELLS)]
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n%s\n$EndNodes\n" \
        "$Elements\n%d\n%s\n$EndElements\n" % (
            len(nodes), "\n".join(nodes), len(elements), "\n".join(
                "%d %s" % pair for pair in enumerate(elements, 1)))


def prepare(folder):
    """Write the case into a folder, where runs begin."""
    for name, text in (("case.prm", CASE), ("square.msh", mesh())):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
            stream.write(text)


def run(program, folder, *options, case="case.prm", ranks=1, settings=(), status=0):
    """What the program says; its exit status has to be that one."""
    return output_of(
        [*command(program[0], program[1:], ranks), *as_options(settings), *options,
         str(case)], status, cwd=folder,
        env=environment(OMPI_MCA_odls_base_sigkill_timeout="0"))


def content(folder):
    """{path: bytes, or None for a folder} of all below a folder."""
    found = {}
    for parent, folders, files in os.walk(folder):
        for name in folders:
            found[os.path.relpath(os.path.join(parent, name), folder)] = None
        for name in files:
            with open(os.path.join(parent, name), "rb") as stream:
                found[os.path.relpath(os.path.join(parent, name), folder)] = \
                    stream.read()
    return found


def write(folder, name, text="of the user\n"):
    path = os.path.join(folder, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def text_of(*path):
    with open(os.path.join(*path), encoding="utf-8") as stream:
        return stream.read()


def table_of(*path):
    """The rows of a CSV file; all are as long as the header."""
    lines = [line for line in text_of(*path).splitlines()
             if not line.startswith("#")]
    rows = list(csv.reader(lines))
    assert all(len(row) == len(rows[0]) for row in rows), rows
    return [dict(zip(rows[0], row)) for row in rows[1:]]


def strict_json(*path):
    """A JSON file; what JSON does not know is an error."""
    def refuse(word):
        raise AssertionError("%s in %s" % (word, path))
    return json.loads(text_of(*path), parse_constant=refuse)


def steps_with_fields(*directory):
    return {int(number) for number in
            re.findall(r"fields_(\d+)\.pvtu", text_of(*directory, "fields.pvd"))}


def killed_after_rows(words, directory, name, n_rows, **keywords):
    """Start a run on one rank, and kill it when a table in its directory has so many
    rows."""
    process = subprocess.Popen(
        words, env=environment(), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL, start_new_session=True, **keywords)
    deadline = time.time() + 200
    table = pathlib.Path(directory, name)
    while process.poll() is None and time.time() < deadline:
        if table.exists() and text_of(table).count("\n") > n_rows:
            break
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    # the rank is gone when its lock is, which may be a moment later
    while time.time() < deadline + 20:
        try:
            with open(pathlib.Path(directory, ".lock"), "rb") as lock:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return
        except BlockingIOError:
            time.sleep(0.05)
        except FileNotFoundError:
            return
