#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The house check itself: allowed arrows pass, forbidden ones do not."""
import unittest

from check_house import INCLUDE, allowed, header_stems


class Arrows(unittest.TestCase):
    def test_allowed(self):
        for case in (("model", "material.h", "core", "registry.h"),
                     ("model", "material.h", "model", "energy_split.h"),
                     ("problem", "x.h", "model", "material.h"),
                     ("problem", "x.h", "core", "errors.h"),
                     ("assembly", "x.cc", "discretization", "fields.h"),
                     ("core", "simulation.cc", "solvers", "newton.h"),
                     ("core", "step_elastic.cc", "assembly", "assembler.h"),
                     ("core", "parameters.h", "problem", "geometry.h", True),
                     ("core", "log.cc", "core", "errors.h")):
            self.assertTrue(allowed(*case), case)

    def test_forbidden(self):
        for case in (("model", "material.h", "core", "state.h"),
                     ("model", "material.h", "problem", "geometry.h"),
                     ("solvers", "newton.h", "assembly", "assembler.h"),
                     ("solvers", "newton.h", "core", "simulation.h"),
                     ("discretization", "fields.h", "model", "material.h"),
                     ("output", "table.h", "core", "step_elastic.h"),
                     ("problem", "x.h", "output", "table.h"),
                     ("core", "log.cc", "output", "table.h"),
                     ("core", "log.cc", "core", "simulation.h"),
                     ("core", "parameters.h", "assembly", "assembler.h"),
                     ("core", "log.cc", "problem", "geometry.h", True),
                     ("core", "stepping.h", "model", "material.h")):
            self.assertFalse(allowed(*case), case)

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
