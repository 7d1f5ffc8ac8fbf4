# SPDX-License-Identifier: GPL-2.0-or-later
"""Young's modulus as the slope of a line through the origin that fits the tensile
curve up to a strain:
    E = sum P_i e_i / sum e_i^2   (MPa)
over N_POINTS evenly spaced strains from e/N_POINTS to e, the measured curve joined by
straight lines and to the origin; or over the measured points as they are. With more
points sums become integrals; few make E larger where the curve rises steeply at its
end, and smaller where it is steepest at its begin.
"""
import numpy as np

from report_parts.errors import InputError

N_POINTS = 200


def of_points(strain, stress):
    return float(stress @ strain / (strain @ strain))


def even(strain):
    return strain * np.arange(1, N_POINTS + 1) / N_POINTS


def of_law(law, constants, percents):
    """[(percent, E in MPa)] of a law."""
    found = []
    for percent in percents:
        strain = even(0.01 * percent)
        stress = law.nominal_stress(constants, "uniaxial", 1. + strain)
        found.append((percent, of_points(strain, stress)))
    return found


def of_test(test, percents, as_measured):
    """[(percent, E in MPa)] of a tensile test, the points in range."""
    order = np.argsort(test.stretch, kind="stable")
    strain, stress = test.stretch[order] - 1., test.stress[order]
    found = []
    for percent in percents:
        limit = 0.01 * percent * (1. + 1e-12)
        inside = (strain <= limit) & (strain > 0.)
        if strain[-1] < limit * (1. - 1e-9) or not inside.any():
            raise InputError("%s: --linear-ranges: expected strains within those of "
                             "the tensile test, %.4g to %.4g %%, found %g"
                             % (test.path, 100. * strain[0], 100. * strain[-1],
                                percent))
        if as_measured:
            found.append((percent, of_points(strain[inside], stress[inside])))
        else:
            samples = even(0.01 * percent)
            joined = np.interp(samples, np.append(0., strain[strain > 0.]),
                               np.append(0., stress[strain > 0.]))
            found.append((percent, of_points(samples, joined)))
    return found
