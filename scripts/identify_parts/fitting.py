# SPDX-License-Identifier: GPL-2.0-or-later
"""Least squares of a law to tests, with confidence intervals.

Minimized is sum over tests of weight * sum over points of r^2, with r = P(lambda) -
P_measured (MPa), or r / |P_measured| when relative. The covariance of the constants
is s^2 (J^T J)^-1 with the Jacobian J of the weighted residuals and s^2 = sum of
squares / (points - constants); intervals are those of Student's t.
"""
import numpy as np

from report_parts.errors import InputError

from .laws import largest_invariant

N_REFINED = 24  # of the starts, the best by a linear fit
SMALLEST_SINGULAR = 1e-8  # of the scaled Jacobian: below, constants are not told apart


class Fit:
    """constants; half_widths of their intervals (nan where not known, None where
    the tests do not tell them apart); tests; residual figures per test."""

    def __init__(self, law, constants, tests, relative):
        self.law, self.constants, self.tests = law, np.asarray(constants), tests
        self.relative = relative
        self.half_widths, self.confidence = None, None
        self.bulk = None
        self.figures = [figures(test.stress, self.stress(test)) for test in tests]

    def stress(self, test):
        return self.law.nominal_stress(self.constants, test.kind, test.stretch)


def figures(measured, computed):
    """n, rms and largest residual (MPa), its index, R2 (None for equal stresses)."""
    residual = computed - measured
    spread = np.sum((measured - measured.mean())**2)
    return {"n": len(measured), "rms": float(np.sqrt(np.mean(residual**2))),
            "largest": float(np.abs(residual).max()),
            "at": int(np.abs(residual).argmax()),
            "r2": float(1. - np.sum(residual**2) / spread) if spread > 0. else None}


def student(confidence, freedom):
    """Half width of the interval of that confidence, in standard deviations."""
    from scipy import special
    return special.stdtrit(freedom, 0.5 + 0.5 * confidence)


class Problem:
    """The residuals of a law and their derivatives."""

    def __init__(self, law, tests, relative):
        self.law, self.tests = law, tests
        self.measured = np.concatenate([test.stress for test in tests])
        weights = np.concatenate([np.full(len(test.stress), np.sqrt(test.weight))
                                  for test in tests])
        if relative:
            known = self.measured != 0.
            weights[known] /= np.abs(self.measured[known])
            weights[~known] = 0.  # a stress of 0 has no relative error
        self.weights = weights
        self.n_points = int(np.count_nonzero(weights))
        self.largest = max(largest_invariant(test.kind, test.stretch)
                           for test in tests)

    def stresses(self, constants):
        return np.concatenate([self.law.nominal_stress(constants, test.kind,
                                                       test.stretch)
                               for test in self.tests])

    def residuals(self, constants):
        return self.weights * (self.stresses(constants) - self.measured)

    def jacobian(self, constants):
        """By complex steps, exact to rounding."""
        return np.array([self.residuals(constants + 1e-30j * unit).imag / 1e-30
                         for unit in np.eye(len(constants))]).T

    def linear_start(self, other):
        """(cost, constants): the linear constants that fit best beside others."""
        law = self.law
        constants = np.zeros(len(law.names))
        constants[law.other] = other
        matrix = np.array([self.weights * self.stresses(constants + unit)
                           for unit in np.eye(len(constants))[law.linear]]).T
        scale = np.linalg.norm(matrix, axis=0)
        scale[scale == 0.] = 1.
        found = np.linalg.lstsq(matrix / scale, self.weights * self.measured,
                                rcond=1e-12)[0]
        constants[law.linear] = found / scale
        return float(np.sum(self.residuals(constants)**2)), constants

    def refined(self, start):
        """(cost, constants) of a local minimum."""
        from scipy import optimize  # here: it takes as long as all the rest
        lower, upper = self.law.bounds(self.largest)
        found = optimize.least_squares(
            self.residuals, np.clip(start, lower, upper), jac=self.jacobian,
            bounds=(lower, upper), x_scale="jac", ftol=1e-13, xtol=1e-13, gtol=1e-13,
            max_nfev=500)
        return 2. * found.cost, found.x


def solved(problem):
    """The constants of the best of the minima found."""
    starts = sorted((problem.linear_start(other) for other
                     in problem.law.starts(problem.largest)), key=lambda start: start[0])
    if not problem.law.other:
        return problem.refined(starts[0][1])[1]
    minima = [problem.refined(start) for _, start in starts[:N_REFINED]]
    return problem.law.ordered(min(minima, key=lambda minimum: minimum[0])[1])


def half_widths(problem, constants, confidence):
    """Of the intervals; None where the tests do not tell the constants apart."""
    jacobian = problem.jacobian(constants)
    scale = np.linalg.norm(jacobian, axis=0)
    if np.any(scale == 0.):
        return None
    _, singular, rows = np.linalg.svd(jacobian / scale, full_matrices=False)
    if singular[-1] < SMALLEST_SINGULAR * singular[0]:
        return None
    freedom = problem.n_points - len(constants)
    variance = np.sum(problem.residuals(constants)**2) / freedom
    deviations = np.sqrt(variance * np.sum((rows / singular[:, None])**2, axis=0))
    return student(confidence, freedom) * deviations / scale


def fitted(law, tests, relative, confidence):
    """The Fit of a law to tests that are not volumetric."""
    problem = Problem(law, tests, relative)
    if problem.n_points <= len(law.names):
        raise InputError("--law %s: expected more points than the %d constants (%s), "
                         "found %d" % (law.name, len(law.names), ", ".join(law.names),
                                       problem.n_points))
    fit = Fit(law, solved(problem), tests, relative)
    fit.half_widths = half_widths(problem, fit.constants, confidence)
    fit.confidence = confidence
    return fit


def given(law, constants, tests, relative):
    """The Fit that constants of the user's are."""
    law.check(constants, max([largest_invariant(test.kind, test.stretch)
                              for test in tests] or [0.]))
    return Fit(law, constants, tests, relative)


class Bulk:
    """modulus K (MPa), its half_width, the slope of the line (MPa) and the J at
    which the line is 0; figures of the residuals."""

    def __init__(self, tests, confidence, seating, shear_modulus):
        volume = np.concatenate([test.stretch for test in tests]) - 1.
        stress = np.concatenate([test.stress for test in tests])
        weights = np.concatenate([np.full(len(test.stress), np.sqrt(test.weight))
                                  for test in tests])
        columns = [volume, np.ones_like(volume)] if seating else [volume]
        matrix = np.array(columns).T * weights[:, None]
        freedom = len(stress) - len(columns)
        if freedom < 1 or np.ptp(volume) == 0. and (seating or volume[0] == 0.):
            raise InputError("%s: expected at least %d points of different volume, "
                             "found %d" % (tests[0].path, len(columns) + 1,
                                           len(set(volume))))
        found = np.linalg.lstsq(matrix, weights * stress, rcond=None)[0]
        self.slope, shift = float(found[0]), float(found[1]) if seating else 0.
        if self.slope <= 0.:
            raise InputError("%s: expected a pressure that rises when the volume falls "
                             "(stresses are negative in compression), found a slope "
                             "of %g MPa" % (tests[0].path, self.slope))
        self.zero = 1. - shift / self.slope
        self.modulus = self.slope - 4. / 3. * shear_modulus
        computed = self.slope * volume + shift
        self.figures = figures(stress, computed)
        variance = np.sum((weights * (computed - stress))**2) / freedom
        inverse = np.linalg.inv(matrix.T @ matrix)
        self.half_width = float(student(confidence, freedom)
                                * np.sqrt(variance * inverse[0, 0]))
        self.tests = tests


