#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Fails when doc/parameters.md is not what the executable prints.

usage: check_manual.py EXECUTABLE [--update]
"""

import pathlib
import subprocess
import sys

MANUAL = pathlib.Path(__file__).resolve().parents[2] / "doc" / "parameters.md"


def main():
    printed = subprocess.run(
        [sys.argv[1], "--parameters", "markdown"],
        check=True, stdout=subprocess.PIPE, text=True).stdout
    if "--update" in sys.argv[2:]:
        MANUAL.write_text(printed, encoding="utf-8")
        return 0
    committed = MANUAL.read_text(encoding="utf-8") if MANUAL.exists() else ""
    if committed == printed:
        return 0
    print(f"{MANUAL} is stale; make it anew with\n"
          f"  {sys.argv[0]} {sys.argv[1]} --update")
    return 1


if __name__ == "__main__":
    sys.exit(main())
