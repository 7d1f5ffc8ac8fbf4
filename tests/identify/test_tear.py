#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""scripts/identify.py --tear on pure-shear curves of a neo-Hookean body, whose energy
release rate is known, and on runs in the format of doc/output.md."""
import math
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from common import Case, even, skip_without_scipy  # noqa: E402

# The specimen of [Mang21] and its neo-Hookean mu: G = 17 N/mm at 11.68 mm. A crack
# of length a takes a piece of a - EDGE out of the specimen.
WIDTH, HEIGHT, THICKNESS, MU, EDGE = 196., 28., 1.8, 2.40, 5.
SPECIMEN = ("--tear", "--width", "196", "--height", "28", "--thickness", "1.8")
ONSET = 11.676


def energy(u):
    """W h0, N/mm: the energy release rate."""
    x = 1. + u / HEIGHT
    return 0.5 * MU * HEIGHT * (x - 1. / x)**2


def force(u, crack=EDGE):
    x = 1. + u / HEIGHT
    return THICKNESS * MU * (x - x**-3) * (WIDTH - crack + EDGE)


def displacement_of(rate):
    """u at which W h0 is the rate."""
    half = 0.5 * math.sqrt(2. * rate / (MU * HEIGHT))
    return HEIGHT * (half + math.sqrt(1. + half * half) - 1.)


def toughness(crack):
    """An R curve: 10 N/mm at first, 17 after some mm."""
    return 17. - 7. * math.exp(-(crack - 47.) / 2.)


def tearing(n=300, end=120.):
    """(displacements, forces, crack lengths, stored energies): loaded up to 10 N/mm,
    then along the R curve."""
    lengths = even(47., end, n)
    u = even(0., displacement_of(10.), 40)[:-1] \
        + [displacement_of(toughness(crack)) for crack in lengths]
    lengths = [47.] * 39 + lengths
    forces = [force(*pair) for pair in zip(u, lengths)]
    stored = [THICKNESS * energy(x) * (WIDTH - crack + EDGE)
              for x, crack in zip(u, lengths)]
    return u, forces, lengths, stored


class Tear(Case):
    def curve(self, name, *crack, last=14., n=60):
        u = even(0., last, n)
        return self.csv(name, "displacement_mm,force_N", u,
                        [force(x, *crack) for x in u])

    def growing(self, *columns, stored=True):
        if stored:
            return self.csv("g.csv", "displacement_mm,force_N,crack_length_mm,"
                            "elastic_energy_mJ", *columns)
        return self.csv("g.csv", "displacement_mm,force_N,crack_length_mm",
                        *columns[:3])

    def points(self, *arguments):
        """{method: [point]}"""
        found = {}
        for point in self.numbers(*SPECIMEN, *arguments)["points"]:
            found.setdefault(point["method"], []).append(point)
        return found


class Standing(Tear):
    def test_onset_of_the_specimen(self):
        self.assertLess(abs(displacement_of(17.) - ONSET), 1e-3)

    def test_energy_difference_and_w_h0(self):
        found = self.points("uncracked:" + self.curve("w.csv"),
                            *("%d:%s" % (crack, self.curve("%d.csv" % crack, crack))
                              for crack in (49, 45, 47)),
                            "--onset", str(ONSET), "--paper-formula",
                            "--picture", self.path("tear.svg"))
        self.assertEqual([point["crack_length_mm"]
                          for point in found["energy difference"]], [46., 48.])
        for method in ("energy difference", "W h0"):
            for point in found[method]:
                self.assertRelative(point["G_N_per_mm"], 17., 2e-3)
        # (a - EDGE) / a of 17: 15.2 for a crack of 47 mm
        self.assertRelative(found["paper"][1]["G_N_per_mm"], 17. * 42. / 47., 2e-3)
        with open(self.path("tear.svg"), encoding="utf-8") as stream:
            self.assertIn("Energy release rate", stream.read())

    def test_few_steps_are_enough(self):
        """Steps of 3 mm, and a test that begins at a pre-load."""
        words = ["%d:%s" % (crack, self.curve("%d.csv" % crack, crack, last=12., n=5))
                 for crack in (45, 49)]
        u = even(0.1, 12., 12)
        words.append("uncracked:" + self.csv("w.csv", "displacement_mm,force_y_N", u,
                                             [-force(x) for x in u]))
        found = self.points(*words, "--onset", str(ONSET))
        for method in ("energy difference", "W h0"):
            self.assertRelative(found[method][0]["G_N_per_mm"], 17., 0.01)

    def test_onset_is_the_first_largest_force(self):
        one = self.curve("a.csv", 45)
        u = even(0., 10., 30) + [10.5, 11.]
        other = self.csv("b.csv", "displacement_mm,force_N", u,
                         [force(x, 49) for x in u[:-2]] + [50., 20.])
        answer = self.numbers(*SPECIMEN, "45:" + one, "49:" + other)
        self.assertEqual(answer["onset_displacement_mm"], 10.)
        self.assertRelative(answer["points"][0]["G_N_per_mm"], energy(10.), 0.02)


class Growing(Tear):
    def test_r_curve(self):
        found = self.points("uncracked:" + self.curve("w.csv"),
                            "growing:" + self.growing(*tearing()), "--step", "1")
        for method in ("energy balance", "force ratio", "W h0"):
            self.assertGreater(len(found[method]), 50)
            for point in found[method][1:]:
                self.assertRelative(point["G_N_per_mm"],
                                    toughness(point["crack_length_mm"]), 0.02)

    def test_growing_cracks_count_as_standing_until_they_grow(self):
        words = ("growing:" + self.growing(*tearing()), "45:" + self.curve("c.csv", 45))
        found = self.points(*words)["energy difference"]
        self.assertEqual([point["crack_length_mm"] for point in found], [46.])
        self.assertRelative(found[0]["G_N_per_mm"],
                            energy(found[0]["displacement_mm"]), 0.01)
        self.assertNotIn("energy difference", self.points(*words, "--onset", "11"))

    def test_mean_after_the_rise(self):
        answer = self.numbers(*SPECIMEN, "uncracked:" + self.curve("w.csv"), "growing:"
                              + self.growing(*tearing(), stored=False),
                              "--mean-from", "15")
        self.assertEqual([mean["method"] for mean in answer["means"]],
                         ["force ratio", "W h0"])
        for mean in answer["means"]:
            self.assertRelative(mean["G_N_per_mm"], 17., 1e-3)

    def test_measured_forces_scatter(self):
        noise, (u, forces, lengths, _) = random.Random(1), tearing()
        forces = [value * (1. + noise.gauss(0., 0.003)) for value in forces]
        answer = self.numbers(*SPECIMEN, "uncracked:" + self.curve("w.csv"), "growing:"
                              + self.growing(u, forces, lengths, stored=False),
                              "--mean-from", "15", "--step", "10")
        self.assertRelative(answer["means"][0]["G_N_per_mm"], 17., 0.02)

    def test_crack_length_in_a_file_of_its_own(self):
        u, forces, lengths, _ = tearing()
        # no two pictures at one displacement
        rows = [i for i in range(len(u)) if i == 0 or u[i] > u[i - 1] + 1e-6]
        cracks = self.csv("dic.csv", "displacement_mm,crack_length_mm",
                          [u[i] for i in rows], [lengths[i] for i in rows])
        curve = self.csv("c.csv", "displacement_mm,force_N", [u[i] for i in rows],
                         [forces[i] for i in rows])
        found = self.points("uncracked:" + self.curve("w.csv"), "growing:" + curve,
                            "--crack-length", cracks, "--step", "1")
        for point in found["force ratio"][1:]:
            self.assertRelative(point["G_N_per_mm"],
                                toughness(point["crack_length_mm"]), 0.02)


class Runs(Tear):
    """Directories as mixed-cracks writes them."""

    def run_directory(self, name, rows, path_of_crack=True):
        """rows: (displacement, force, crack length, stored energy)."""
        os.mkdir(self.path(name))
        self.csv(os.path.join(name, "statistics.csv"), "step,time_s,displacement_mm,"
                 "force_x_N,force_y_N,elastic_energy_mJ,crack_length_mm",
                 range(len(rows)), range(len(rows)), *(
                     [row[0] for row in rows], [0.1] * len(rows),
                     [row[1] for row in rows], [row[3] for row in rows],
                     [1.05 * row[2] for row in rows]))
        if path_of_crack:
            # two points for each crack, in two cracks; written where it grows
            table = [(step, number, length) for step, row in enumerate(rows)
                     if step == 0 or row[2] > rows[step - 1][2]
                     for number, length in ((0, row[2] - 10.), (1, 10.))
                     for _ in range(2)]
            self.csv(os.path.join(name, "crack_path.csv"), "step,crack,length_mm",
                     *zip(*table))
        return self.path(name)

    def test_growing_crack(self):
        rows = list(zip(*tearing(200)))
        words = ("uncracked:" + self.curve("w.csv"),
                 "growing:" + self.run_directory("run", rows), "--step", "2")
        found = self.points(*words)
        for method in ("energy balance", "force ratio"):
            for point in found[method][2:]:
                self.assertRelative(point["G_N_per_mm"],
                                    toughness(point["crack_length_mm"]), 0.02)
        # the integral over the band is 5 % longer here
        found = self.points(*words, "--crack-length", "statistics")
        self.assertRelative(found["energy balance"][-1]["G_N_per_mm"], 17. / 1.05, 1e-3)

    def test_path_that_is_not_known_from_the_first_step(self):
        rows = list(zip(*tearing(200)))
        run = self.run_directory("run", rows)
        with open(self.path("run", "crack_path.csv"), encoding="utf-8") as stream:
            lines = stream.read().splitlines(True)
        self.write(os.path.join("run", "crack_path.csv"), "".join(
            lines[:1] + lines[41:]))
        found = self.points("growing:" + run, "--step", "2")
        self.assertRelative(found["energy balance"][-1]["G_N_per_mm"], 17. / 1.05, 1e-3)

    def test_two_boundaries_that_move(self):
        """Either moves by displacement_mm: the work is twice that of the force."""
        u = even(0., 4., 9)
        work = [2. * THICKNESS * WIDTH * energy(x) for x in u]
        path = self.csv("w.csv", "displacement_mm,force_N,external_work_mJ", u,
                        [force(x) for x in u], work)
        self.refused(*SPECIMEN, "47:" + path, words=("external_work_mJ", "more than "
                                                     "one boundary"))

    def test_standing_cracks_and_a_run_that_was_killed(self):
        words = []
        for crack in (46, 48):
            u = even(0., 12., 13)
            rows = [(x, force(x, crack), crack, 0.) for x in u]
            words.append("%d:%s" % (crack, self.run_directory(str(crack), rows, False)))
        with open(self.path("48", "statistics.csv"), "a", encoding="utf-8") as stream:
            stream.write("13,13,12.")
        found = self.points(*words, "--onset", str(ONSET), "--component", "y")
        self.assertRelative(found["energy difference"][0]["G_N_per_mm"], 17., 2e-3)


def setUpModule():
    skip_without_scipy()


if __name__ == "__main__":
    unittest.main()
