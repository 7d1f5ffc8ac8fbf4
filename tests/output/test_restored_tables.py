#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of a run that were cut off, damaged or lost are whole again when it is
resumed, and names with commas and quotation marks stay one field.

usage: test_restored_tables.py EXECUTABLE MPIRUN
"""
import os
import shutil
import sys
import tempfile

import small_runs
from small_runs import content, table_of, text_of

TABLES = ("crack_path.csv", "crack_opening.csv", "traction_profiles.csv",
          "statistics.csv")
START = 'left, "lower"'


def damages():
    """{name: what is done to a file}"""
    def change(path, text):
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)

    return {"lost": os.remove,
            "empty": lambda path: change(path, ""),
            "cut in the middle": lambda path: change(
                path, text_of(path)[:len(text_of(path)) // 2]),
            "of another": lambda path: change(path, "x,y\n1,2\n\x00\n"),
            "with a row too many": lambda path: change(
                path, text_of(path).split("#")[0] + text_of(path).split("#")[0])}


def without_times(rows):
    return [{name: value for name, value in row.items() if name != "wall_time_s"}
            for row in rows]


def check_names(folder):
    rows = table_of(folder, "crack_path.csv")
    assert rows and all(row["start"] == START for row in rows), rows[:1]
    assert START in text_of(folder, "crack_path.csv").splitlines()[-1]
    scripts = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir,
                           os.pardir, "scripts")
    sys.path.insert(0, scripts)
    from report_parts import crack_path
    remarks = []
    cracks = crack_path.cracks_at_end(folder, remarks)
    assert not remarks and [crack.start for crack in cracks] == [START], remarks


def main():
    program = [os.path.abspath(sys.argv[1])] + sys.argv[2:3]
    with tempfile.TemporaryDirectory() as folder:
        small_runs.prepare(folder)
        small_runs.run(program, folder, "--output", "whole")
        whole = os.path.join(folder, "whole")
        check_names(whole)
        for ranks, (name, damage) in enumerate(damages().items()):
            run = os.path.join(folder, "run")
            shutil.copytree(whole, run)
            for table in TABLES + ("crack_path.pvd",):
                damage(os.path.join(run, table))
            # one that is whole is not looked into
            for vtp in content(os.path.join(run, "crack_path")) \
                    if name != "with a row too many" else ():
                damage(os.path.join(run, "crack_path", vtp))
            # goes on, or ends again: the rows until here are what they were
            small_runs.run(program, folder, "--resume", "--output", "run",
                           ranks=1 + ranks % 2,
                           settings=["Load stepping/End time=1.25"])
            for table in TABLES:
                before = without_times(table_of(whole, table))
                after = without_times(table_of(run, table))
                assert after[:len(before)] == before, (name, table, before, after)
            check_names(run)
            for vtp, data in content(os.path.join(whole, "crack_path")).items():
                assert content(os.path.join(run, "crack_path"))[vtp] == data, vtp
            assert set(content(os.path.join(whole, "crack_path"))) <= set(
                word.split("/")[-1] for word in
                text_of(run, "crack_path.pvd").split('"'))
            shutil.rmtree(run)


if __name__ == "__main__":
    main()
