#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The house check itself: allowed arrows pass, forbidden ones do not."""
import unittest

from check_house import (ALLOWED, INCLUDE, MAIN, allowed, check_arrows,
                         count_includes, cycles, header_stems)


class Arrows(unittest.TestCase):
    def test_allowed(self):
        for case in (("model", "base"), ("model", "model"),
                     ("problem", "model"), ("problem", "input"),
                     ("assembly", "discretization"), ("steps", "assembly"),
                     ("output", "cracks"), ("simulation", "steps"),
                     ("simulation", "output"), (MAIN, "simulation")):
            self.assertTrue(allowed(*case), case)

    def test_forbidden(self):
        for case in (("base", "input"), ("input", "problem"),
                     ("model", "discretization"), ("model", "problem"),
                     ("solvers", "assembly"), ("solvers", "steps"),
                     ("discretization", "model"), ("output", "steps"),
                     ("cracks", "output"), ("problem", "output"),
                     ("steps", "problem"), ("steps", "simulation")):
            self.assertFalse(allowed(*case), case)

    def test_the_table_has_no_cycle(self):
        self.assertEqual(cycles(ALLOWED), [])
        for room, targets in ALLOWED.items():
            self.assertLessEqual(set(targets), set(ALLOWED), room)

    def test_cycles(self):
        self.assertEqual(cycles({"a": "b", "b": "c", "c": ""}), [])
        self.assertEqual(cycles({"a": "b", "b": "c", "c": "b"}), [("b", "c")])
        self.assertEqual(cycles({"a": "bc", "b": "a", "c": "d", "d": "c"}),
                         [("a", "b"), ("c", "d")])

    def test_offences_name_file_and_line(self):
        lines = ["", "#include <base/text.h>", "#include <output/disk.h>"]
        self.assertEqual(list(check_arrows("include/model/x.h", "model", lines)),
                         ["include/model/x.h:3: model must not include "
                          "<output/disk.h>"])
        self.assertEqual(list(check_arrows("source/main.cc", None, lines)), [])
        self.assertEqual(list(check_arrows("include/core/x.h", "core", lines)),
                         ["include/core/x.h: there is no room 'core'"])

    def test_includes_within_a_room_do_not_count(self):
        counts = count_includes([
            ("model", ["#include <base/text.h>", "#include <model/material.h>"]),
            (None, ["#include <base/text.h>"])])
        self.assertEqual(counts["model"], {"base": 1})
        self.assertEqual(counts[MAIN], {"base": 1})

    def test_parts_of_a_source(self):
        self.assertEqual(header_stems("geometries/mesh_scan_gmsh"),
                         ["geometries/mesh_scan_gmsh", "geometries/mesh_scan",
                          "geometries/mesh"])

    def test_include_lines(self):
        self.assertTrue(INCLUDE.match('#  include "model/material.h"'))
        self.assertTrue(INCLUDE.match("#include <problem/geometries/strip.h>"))
        self.assertFalse(INCLUDE.match("// #include <model/material.h>"))


if __name__ == "__main__":
    unittest.main()
