#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Distances of paths, differences of curves, bisection and variations, against answers
that are known exactly. Needs numpy; scripts/ only, no program."""
import math
import os
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, os.pardir, os.pardir, "scripts"))
from report_parts import interpreter  # noqa: E402

if __name__ == "__main__":
    interpreter.use_one_with_matplotlib()
import numpy as np  # noqa: E402
from study_parts import (bisection, curve_difference, polylines,  # noqa: E402
                         uncertainty, variations)
from study_parts.errors import StudyError  # noqa: E402


class Polylines(unittest.TestCase):
    def line(self, *points):
        return np.array(points, float)

    def test_parallel_lines(self):
        a, b = self.line((0, 0), (4, 0)), self.line((0, 1), (1, 1), (4, 1))
        found = polylines.apart([a], [b])
        self.assertAlmostEqual(found.mean, 1., 12)
        self.assertAlmostEqual(found.hausdorff, 1., 12)

    def test_one_is_longer(self):
        # from 4 to 10 the distance of the longer one grows from 0 to 6
        a, b = self.line((0, 0), (10, 0)), self.line((0, 0), (4, 0))
        mean, largest = polylines.one_way([a], [b])
        self.assertAlmostEqual(mean, 6. * 3. / 10., 5)
        self.assertEqual(largest, 6.)
        self.assertAlmostEqual(polylines.one_way([b], [a])[0], 0., 12)
        found = polylines.apart([b], [a])
        self.assertAlmostEqual(found.mean, 0.9, 5)
        self.assertEqual(found.hausdorff, 6.)

    def test_wedge(self):
        # distance of (s, 0) from the line through the origin at 30 degrees: s / 2
        a = self.line((0, 0), (1, 0))
        b = self.line((0, 0), (2 * math.cos(math.pi / 6), 1.))
        mean, largest = polylines.one_way([a], [b])
        self.assertAlmostEqual(mean, 0.25, 6)
        self.assertAlmostEqual(largest, 0.5, 12)

    def test_how_a_line_is_divided_does_not_matter(self):
        whole, other = self.line((0, 0), (6, 0)), self.line((0, 0), (6, 3))
        fine = np.column_stack([np.linspace(0., 1., 50)**3 * 6., np.zeros(50)])
        first, second = (polylines.apart([a], [other]) for a in (whole, fine))
        self.assertAlmostEqual(first.mean, second.mean, 5)
        self.assertAlmostEqual(first.hausdorff, second.hausdorff, 12)

    def test_several_pieces(self):
        # two pieces of one line with a gap of 2: its middle is 1 away
        whole = self.line((0, 0), (10, 0))
        pieces = [self.line((0, 0), (4, 0)), self.line((6, 0), (10, 0))]
        self.assertAlmostEqual(polylines.one_way([whole], pieces)[1], 1., 2)
        self.assertAlmostEqual(polylines.one_way([whole], pieces)[0], 0.1, 5)

    def test_share_within(self):
        a, b = self.line((0, 0), (10, 0)), self.line((0, 0), (10, 5))
        # the distance of (s, 0) is s / sqrt(5)
        self.assertAlmostEqual(
            polylines.share_within([a], [b], 4. / math.sqrt(5.)), 0.4, 3)

    def test_a_point_on_top_of_the_one_before(self):
        a = self.line((0, 0), (0, 0), (2, 0))
        self.assertAlmostEqual(polylines.apart([a], [a]).hausdorff, 0., 12)


class Curves(unittest.TestCase):
    def difference(self, curve, reference, **options):
        return curve_difference.difference(
            *(tuple(np.array(part, float) for part in pair)
              for pair in (curve, reference)), **options)

    def test_straight_lines(self):
        # F = 2 u, R = u on [0, 3]: everything is off by one whole
        found = self.difference(([0, 3], [0, 6]), ([0, 1, 3], [0, 1, 3]))
        self.assertAlmostEqual(found.relative_l2, 1., 12)
        self.assertAlmostEqual(found.area, 4.5, 12)
        self.assertAlmostEqual(found.relative_area, 1., 12)
        self.assertEqual(found.covered, 1.)

    def test_crossing(self):
        # F - R = 2 u - 1 on [0, 1]: |.| has area 1/2, the square 1/3; R = 1
        found = self.difference(([0, 1], [0, 2]), ([0, 1], [1, 1]))
        self.assertAlmostEqual(found.area, 0.5, 12)
        self.assertAlmostEqual(found.relative_l2, math.sqrt(1. / 3.), 12)

    def test_a_drop_at_one_displacement(self):
        # 1 up to u = 1, then 0; the reference 1 up to u = 1.5: off by 1 on 0.5
        found = self.difference(([0, 1, 1, 2], [1, 1, 0, 0]),
                                ([0, 1.5, 1.5, 2], [1, 1, 0, 0]))
        self.assertAlmostEqual(found.area, 0.5, 12)
        self.assertAlmostEqual(found.relative_l2, math.sqrt(0.5 / 1.5), 12)

    def test_what_both_have(self):
        short, reference = ([0, 1], [2, 2]), ([0, 4], [2, 2])
        found = self.difference(short, reference)
        self.assertAlmostEqual(found.area, 0., 12)
        self.assertAlmostEqual(found.covered, 0.25, 12)
        # a body that has come apart at u = 1 with nothing left
        found = self.difference(([0, 1, 1], [2, 2, 0]), reference, held=True)
        self.assertAlmostEqual(found.relative_area, 0.75, 12)
        self.assertEqual(found.covered, 1.)
        self.assertIsNone(self.difference(([5, 6], [1, 1]), reference))

    def test_points_between_change_nothing(self):
        x = np.linspace(0., 3., 37)
        a = self.difference((x, np.interp(x, [0, 1, 3], [0, 5, 1])),
                            ([0, 2, 3], [0, 4, 0]))
        b = self.difference(([0, 1, 3], [0, 5, 1]), ([0, 2, 3], [0, 4, 0]))
        for first, second in zip(a, b):
            self.assertAlmostEqual(first, second, 12)

    def test_what_is_no_curve(self):
        for x, word in (([0., 2., 1.], "goes back from 2 to 1"), ([1., 1.], "two points"),
                        ([0.], "two points"), ([0., np.nan], "two points")):
            with self.assertRaisesRegex(StudyError, word):
                curve_difference.increasing(x, np.ones(len(x)), "a")

    def test_share_inside(self):
        x = np.arange(5.)
        curve = np.array([0., 3.]), np.array([0., 3.])
        # at 0, 1, 2, 3; 4 is not reached; at 3 it is above
        self.assertEqual(curve_difference.share_inside(
            curve, x, x - 0.5, np.array([0.5, 1.5, 2.5, 2.9, 9.])), 0.75)
        self.assertIsNone(curve_difference.share_inside(curve, x + 9., x, x))


class Bisection(unittest.TestCase):
    def solved(self, answer, low, high, tolerance, at_once=1):
        """(bracket, rounds, {value: answer}) with runs as the logic asks for."""
        known, rounds = {}, 0
        while True:
            values = bisection.next_values(known, low, high, tolerance, at_once)
            if not values:
                return bisection.bracket_of(known, low, high), rounds, known
            self.assertFalse(set(values) & set(known))
            known.update((value, answer(value)) for value in values)
            rounds += 1
            self.assertLess(rounds, 50)

    def test_the_change_is_found(self):
        for change in (6.01, 7.3, 8., 9.99):
            for at_once in (1, 2, 3, 7):
                bracket, _, known = self.solved(
                    lambda v: "below" if v < change else "into", 6., 10., 0.1, at_once)
                self.assertLessEqual(bracket.high - bracket.low, 0.1)
                self.assertTrue(bracket.low < change <= bracket.high)
                self.assertEqual((bracket.low_answer, bracket.high_answer),
                                 ("below", "into"))

    def test_as_few_runs_as_halving_takes(self):
        # 4 / 0.1 = 40 < 2^6
        _, rounds, known = self.solved(lambda v: v > 7.3, 6., 10., 0.1)
        self.assertEqual((rounds, len(known)), (7, 8))
        # three at a time quarter the bracket: 4^3 = 64
        _, rounds, _ = self.solved(lambda v: v > 7.3, 6., 10., 0.1, 3)
        self.assertEqual(rounds, 4)
        # no more runs than the width needs
        _, rounds, known = self.solved(lambda v: v > 7.3, 6., 7.5, 0.5, 64)
        self.assertEqual((rounds, len(known)), (2, 4))

    def test_taken_up_again(self):
        known = {6.: "a", 10.: "b", 8.: "b"}
        self.assertEqual(bisection.next_values(known, 6., 10., 0.1), [7.])
        self.assertEqual(bisection.next_values({}, 6., 10., 0.1), [6., 10.])
        self.assertEqual(bisection.next_values(known, 6., 10., 2.), [])

    def test_several_changes(self):
        # a third answer in the middle is another one than that of the low end
        bracket, _, known = self.solved(
            lambda v: "a" if v < 1. else "b" if v < 2. else "c", 0., 4., 0.01)
        self.assertTrue(bracket.low < 1. <= bracket.high)
        self.assertEqual(bracket.high_answer, "b")
        self.assertEqual(bisection.other_changes(
            {0.: "a", 1.: "b", 2.: "a", 3.: "b"},
            bisection.bracket_of({0.: "a", 1.: "b", 3.: "b"}, 0., 3.)), [2.])

    def test_failed_runs(self):
        # the middle fails: one of the quarters is asked for
        known = {0.: "a", 4.: "b", 2.: None}
        self.assertIn(bisection.next_values(known, 0., 4., 0.1), ([1.], [3.]))
        bracket, _, _ = self.solved(
            lambda v: None if abs(v - 2.) < 0.05 else "a" if v < 2.3 else "b",
            0., 4., 0.1)
        self.assertTrue(bracket.low < 2.3 <= bracket.high)
        with self.assertRaisesRegex(StudyError, "have failed"):
            self.solved(lambda v: None if 0. < v < 4. else v, 0., 4., 0.1)
        with self.assertRaisesRegex(StudyError, "run at 0 has failed"):
            self.solved(lambda v: None, 0., 4., 0.1)

    def test_nothing_to_find(self):
        with self.assertRaisesRegex(StudyError, "both give 'a'"):
            self.solved(lambda v: "a", 0., 4., 0.1)
        for low, high, tolerance in ((4., 4., 1.), (5., 4., 1.), (0., 1., 0.)):
            with self.assertRaisesRegex(StudyError, "expected"):
                self.solved(lambda v: v, low, high, tolerance)

    def test_questions(self):
        summary = {"outcome": "below hole", "outcome_start": "notch",
                   "peak_force_N": 160.}
        for text, answer in (("outcome", "below hole"),
                             ("outcome, outcome_start", "below hole, notch"),
                             ("peak_force_N > 100", "peak_force_N > 100"),
                             ("peak_force_N<=100", "not peak_force_N<=100")):
            self.assertEqual(bisection.Question(text).answer(summary), answer)
        for text, word in (("no such", "expected keys"), ("peak_force_N > x",
                                                          "expected a number")):
            with self.assertRaisesRegex(StudyError, word):
                bisection.Question(text)
        for text, word in (("color", "no 'color'"), ("outcome > 1", "is no number")):
            with self.assertRaisesRegex(StudyError, word):
                bisection.Question(text).answer(summary)


STRIP = {"Geometry/Name": "punctured strip",
         "Geometry/Punctured strip/Cell size": "1.2",
         "Geometry/Punctured strip/Mirrored mesh": "none",
         "Geometry/Slit square/Mirrored mesh": "none",
         "Mesh/Adaptive levels": "3",
         "Mesh/Refined surroundings": "hole : 0.5 : 2 ; notch tip : 1 : 3",
         "Model/Coupling": "iterated", "Model/Coupling tolerance": "1e-3",
         "Material/Shear modulus": "2.40", "Material/Young modulus": "",
         "Load stepping/First step": "0.6", "Load stepping/Largest step": "1.2",
         "Load stepping/Onset step": "0"}


class Variations(unittest.TestCase):
    def settings(self, parameters, *arguments):
        return {(v.group, v.name): dict(v.settings)
                for v in variations.variations_of(parameters, *arguments)}

    def test_of_a_strip(self):
        found = self.settings(STRIP, ["Material/Shear modulus"], 0.1)
        self.assertEqual(found, {
            ("mesh", "mirrored_in_x"): {"Geometry/Punctured strip/Mirrored mesh": "x"},
            ("mesh", "mirrored_in_y"): {"Geometry/Punctured strip/Mirrored mesh": "y"},
            ("h/l", "two_thirds"): {"Geometry/Punctured strip/Cell size": "0.8"},
            ("h/l", "half"): {
                "Mesh/Adaptive levels": "4",
                "Mesh/Refined surroundings": "hole : 0.5 : 3 ; notch tip : 1 : 4"},
            # what is 0 follows from the others
            ("load steps", "half"): {"Load stepping/First step": "0.3",
                                     "Load stepping/Largest step": "0.6"},
            ("load steps", "double"): {"Load stepping/First step": "1.2",
                                       "Load stepping/Largest step": "2.4"},
            ("coupling", "tenth"): {"Model/Coupling tolerance": "0.0001"},
            ("coupling", "tenfold"): {"Model/Coupling tolerance": "0.01"},
            ("Material/Shear modulus", "plus"): {"Material/Shear modulus": "2.64"},
            ("Material/Shear modulus", "minus"): {"Material/Shear modulus": "2.16"}})

    def test_of_a_mirrored_mesh(self):
        entry = "Geometry/Punctured strip/Mirrored mesh"
        found = self.settings(dict(STRIP, **{entry: "x, y"}))
        self.assertEqual([(key, found[key]) for key in found if key[0] == "mesh"],
                         [(("mesh", "not_mirrored"), {entry: "none"})])

    def test_of_a_mesh_file(self):
        found = self.settings({"Geometry/Name": "mesh file", "Mesh/Adaptive levels": "0",
                               "Mesh/Global refinements": "2", "Model/Coupling": "lagged",
                               "Mesh/Refined surroundings": "a : 1 : 2"})
        self.assertEqual(found, {("h/l", "half"): {"Mesh/Global refinements": "3"}})

    def test_parameters_have_to_be_numbers(self):
        for entry, word in (("Material/Nu", "no entry of the case"),
                            ("Material/Young modulus", "is '' and no number")):
            with self.assertRaisesRegex(StudyError, word):
                variations.variations_of(STRIP, [entry])

    def test_names(self):
        names = [variations.case_name(v) for v in variations.variations_of(
            STRIP, ["Material/Shear modulus"])]
        self.assertEqual(names, ["mesh_mirrored_in_x", "mesh_mirrored_in_y",
                                 "h_over_l_two_thirds", "h_over_l_half",
                                 "load_steps_half", "load_steps_double",
                                 "coupling_tenth", "coupling_tenfold",
                                 "Shear_modulus_plus", "Shear_modulus_minus"])


class Contributions(unittest.TestCase):
    def found(self):
        line = np.array([(0., 0.), (4., 0.)])
        base = uncertainty.Answer(100., 20., [line], "into")

        def variation(group, name, answer):
            return uncertainty.Difference(
                variations.Variation(group, name, []), answer, base)
        return uncertainty.Uncertainty(base, [
            variation("h/l", "half", uncertainty.Answer(97., 20., [line + (0, 1)],
                                                        "into")),
            variation("h/l", "two_thirds", uncertainty.Answer(98., 19., [], "below")),
            variation("load steps", "half", uncertainty.Answer(104., 20., [line],
                                                               "into")),
            variation("coupling", "tenth", None),
            variation("a", "plus", uncertainty.Answer(106., 20., [line], "into")),
            variation("b", "plus", uncertainty.Answer(108., 20., [line], "into"))])

    def test_sums(self):
        found = self.found()
        self.assertEqual(found.contribution("h/l", "peak"), 3.)
        self.assertEqual(found.contribution("coupling", "peak"), None)
        self.assertAlmostEqual(found.total(found.numerics(), "peak"), 5.)
        self.assertAlmostEqual(found.total(found.parameters(), "peak"), 10.)
        self.assertEqual(found.total(found.numerics(), "displacement"), 1.)
        self.assertAlmostEqual(found.total(found.numerics(), "path"), 1., 12)

    def test_table(self):
        text = uncertainty.markdown(self.found())
        for line in ("| as it is | 100 |  | 20 |  |  |  | into |",
                     "| h/l: two thirds | 98 | -2 (-2 %) | 19 | -1 (-5 %) | – | – | "
                     "below **(another)** |",
                     "| **numerics** | 5 (5 %) | 1 (5 %) | 1 |",
                     "| **parameters** | 10 (10 %) | 0 (0 %) | 0 |",
                     "- Without an answer: coupling_tenth."):
            self.assertIn(line, text.splitlines())


if __name__ == "__main__":
    unittest.main()
