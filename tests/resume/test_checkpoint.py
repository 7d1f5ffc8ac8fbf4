#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A checkpoint that is not what was written is refused, or the one before it
serves; and it never ends in anything but one message and exit status 4.

usage: test_checkpoint.py EXECUTABLE MPIRUN
"""

import os
import pathlib
import re
import shutil
import sys
import tempfile

from runs import Runner, errors_in, generations, rows, summary

SHORT = ["Load stepping/End time=4e-3", "Output/Checkpoint every=1"]


def checksum(data):
    """FNV-1a, 64 bits."""
    value = 14695981039346656037
    for byte in data:
        value = ((value ^ byte) * 1099511628211) % 2 ** 64
    return value


def seal_again(folder):
    """Let record and seal say that the files are as they should be."""
    record = folder / "record.txt"
    text = record.read_text()
    for path in folder.iterdir():
        if path.name in ("record.txt", "seal.txt"):
            continue
        data = path.read_bytes()
        text, n = re.subn(r'"%s" \d+ \d+ ' % re.escape(path.name),
                          '"%s" %d %d ' % (path.name, len(data), checksum(data)),
                          text)
        assert n == 1, (path.name, text[:500])
    record.write_text(text)
    data = record.read_bytes()
    seal = folder / "seal.txt"
    seal.write_text(re.sub(r"record \d+ \d+",
                           "record %d %d" % (len(data), checksum(data)),
                           seal.read_text()))


def cut(folder):
    path = folder / "mesh_fixed.data"
    path.write_bytes(path.read_bytes()[:-200])


def cut_mesh(folder):
    path = folder / "mesh"
    path.write_bytes(path.read_bytes()[:-60])


def lengthen(folder):
    with open(folder / "mesh_fixed.data", "ab") as file:
        file.write(bytes(200))


def other_values(folder):
    path = folder / "mesh_fixed.data"
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 0x40
    path.write_bytes(data)


def no_rows(folder):
    path = folder / "record.txt"
    text, n = re.subn(r"\n\d+\n0 0 .*?\n(?=\d+\n)", "\n0\n",
                      path.read_text(), flags=re.S)
    assert n == 1, path.read_text()
    path.write_text(text)


def without(name):
    def remove(folder):
        (folder / name).unlink()
    remove.__name__ = "without " + name
    return remove


def nonsense(folder):
    path = folder / "record.txt"
    path.write_text(path.read_text()[:400] + "# ?")


def other_format(number):
    def change(folder):
        seal = folder / "seal.txt"
        text = seal.read_text()
        changed, n = re.subn(r"(?<=, format )\d+$", str(number), text, flags=re.M)
        assert n == 1, text
        seal.write_text(changed)
    change.__name__ = "format %d" % number
    return change


def first_format(folder):
    (folder / "seal.txt").write_text("3\nmesh 12\nmesh.info 34\n")


def refused(run, whole, spoil, sealed, says, ranks):
    directory = whole.with_name("spoilt")
    shutil.copytree(whole, directory)
    for folder in generations(directory):
        spoil(folder)
        if sealed:
            seal_again(folder)
    before = (directory / "summary.json").read_text()
    out = run(directory, "--resume", settings=SHORT, status=4, ranks=ranks)
    assert len(errors_in(out)) == 1 and says in out, (spoil.__name__, out)
    assert "Signal" not in out and "terminate called" not in out, out
    assert (directory / "summary.json").read_text() == before
    shutil.rmtree(directory)


def each_generation_has_its_reason(run, whole):
    directory = whole.with_name("both")
    shutil.copytree(whole, directory)
    newest, older = generations(directory)
    without("mesh.info")(newest)
    (older / "seal.txt").write_text("nonsense")
    out = run(directory, "--resume", settings=SHORT, status=4)
    assert len(errors_in(out)) == 1, out
    for words in ("%s: 'mesh.info' is missing" % newest.name,
                  "%s: 'seal.txt' is not what" % older.name):
        assert words in out, (words, out)


def one_that_was_not_finished(run, whole):
    """As a kill leaves it: this is no damage."""
    directory = whole.with_name("unfinished")
    shutil.copytree(whole, directory)
    newest, older = generations(directory)
    without("seal.txt")(newest)
    out = run(directory, "--resume", settings=SHORT)
    assert "%s of the checkpoint was not finished" % newest.name in out, out
    assert "goes on from %s" % older.name in out, out
    assert summary(directory)["warnings"] == summary(whole)["warnings"]


def one_that_mpi_cannot_write(run, whole):
    """MPI-IO without what it opens files with: as where /dev/shm is no place to
    write to, for which the program sets another value."""
    directory = whole.with_name("refused")
    os.environ["OMPI_MCA_sharedfp"] = "^sm,lockedfile,individual"
    for ranks in (1, 2):
        out = run(directory, "--overwrite", settings=SHORT, ranks=ranks, status=4)
        assert len(errors_in(out)) == 1 and "MPI cannot open" in out, out
        assert "Stacktrace" not in out, out
        assert rows(directory), out
    del os.environ["OMPI_MCA_sharedfp"]


def main():
    run = Runner(sys.argv[1], sys.argv[2:])
    with tempfile.TemporaryDirectory() as temporary:
        whole = pathlib.Path(temporary) / "whole"
        out = run(whole, settings=SHORT)
        size = re.search(r"^checkpoint: about ([0-9.]+) MB on this mesh and "
                         r"([0-9.]+) kB for each load step", out, re.M)
        said = float(size[1]) + 1e-3 * float(size[2]) * len(rows(whole))
        newest, older = generations(whole)
        found = 1e-6 * sum(path.stat().st_size for path in newest.iterdir())
        print("a checkpoint of %.4f MB, said to be %.4f" % (found, said))
        assert 0.85 * found < said < 1.15 * found, (found, said)

        sealed = [(cut, "mesh_fixed.data"), (cut_mesh, "the mesh of the checkpoint"),
                  (lengthen, "mesh_fixed.data"), (other_values, "values"),
                  (no_rows, "no load steps"), (nonsense, "no whole checkpoint")]
        unsealed = [(cut, "mesh_fixed.data"), (nonsense, "no whole checkpoint"),
                    (without("mesh"), "'mesh' is missing"),
                    (without("mesh.info"), "'mesh.info' is missing"),
                    (without("mesh_fixed.data"), "'mesh_fixed.data' is missing"),
                    (without("record.txt"), "'record.txt' is missing"),
                    (other_format(3), "checkpoint format 3, this program reads "),
                    (first_format, "checkpoint format 1, this program reads ")]
        for cases, is_sealed in ((sealed, True), (unsealed, False)):
            for number, (spoil, says) in enumerate(cases):
                print(spoil.__name__, is_sealed, flush=True)
                refused(run, whole, spoil, is_sealed, says, 1 + number % 2)

        each_generation_has_its_reason(run, whole)
        one_that_was_not_finished(run, whole)
        one_that_mpi_cannot_write(run, whole)
        # the one before serves where it is whole, and the run says so
        cut(newest)
        out = run(whole, "--resume", settings=SHORT, ranks=2)
        assert "resumed at step %d" % (len(rows(whole)) - 2) in out, out
        says = re.compile("%s of the checkpoint is damaged .*mesh_fixed.data.*"
                          "goes on from %s" % (newest.name, older.name))
        assert says.search(out), out
        assert says.search((whole / "log.txt").read_text())
        assert [text for text in summary(whole)["warnings"] if says.search(text)]
        # the damaged one has been replaced
        assert "checkpoint is damaged" not in run(whole, "--resume", settings=SHORT)


if __name__ == "__main__":
    main()
