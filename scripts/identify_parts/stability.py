# SPDX-License-Identifier: GPL-2.0-or-later
"""Drucker's postulate over a range of stretches.

For every small change of incompressible strain the increments of Cauchy stress do
positive work on those of logarithmic strain: d(tau) : de > 0. With e_3 = -e_1 - e_2
and tau_3 = 0 that is a 2x2 matrix which has to be positive definite,
    D = [h11 - 2 h13 + h33        h12 - h13 - h23 + h33]
        [       symmetric         h22 - 2 h23 + h33    ]
with h_ij of laws.py. Where the nominal stress falls, a test under force would run away
although the material may be stable.
"""
import numpy as np

from .laws import MODES, existing, stretches

N_SAMPLES = 2000


def smallest_eigenvalue(law, constants, mode, stretch):
    """Of D, in MPa."""
    h = law.second(constants, stretches(mode, stretch))
    a = h[0, 0] - 2. * h[0, 2] + h[2, 2]
    b = h[0, 1] - h[0, 2] - h[1, 2] + h[2, 2]
    c = h[1, 1] - 2. * h[1, 2] + h[2, 2]
    return 0.5 * (a + c) - np.sqrt(0.25 * (a - c)**2 + b**2)


def slope(law, constants, mode, stretch):
    """dP/dlambda in MPa, by a complex step."""
    return law.nominal_stress(constants, mode, stretch + 1e-30j).imag / 1e-30


def negative_parts(function, stretch):
    """[(from, to)] where function(stretch) <= 0; ends by bisection."""
    negative = function(stretch) <= 0.
    ends = [stretch[0]] if negative[0] else []
    ends += [crossing(function, stretch[i], stretch[i + 1])
             for i in np.flatnonzero(negative[1:] != negative[:-1])]
    ends += [stretch[-1]] if negative[-1] else []
    return [(float(low), float(high)) for low, high in zip(ends[::2], ends[1::2])]


def crossing(function, low, high):
    below = function(np.array([low]))[0] <= 0.
    for _ in range(50):
        middle = 0.5 * (low + high)
        if (function(np.array([middle]))[0] <= 0.) == below:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def checked(law, constants, interval):
    """{mode: {"from", "to": stretches at which there is a stress, "unstable",
    "declines": [(from, to)]}}."""
    every = np.geomspace(*interval, N_SAMPLES)
    return {mode: checked_mode(law, constants, mode, every) for mode in MODES}


def checked_mode(law, constants, mode, stretch):
    stretch = existing(law, constants, mode, stretch)
    if len(stretch) == 0:
        return {"from": None, "to": None, "unstable": [], "declines": []}
    parts = [negative_parts(lambda s, f=function: f(law, constants, mode, s), stretch)
             for function in (smallest_eigenvalue, slope)]
    return {"from": float(stretch[0]), "to": float(stretch[-1]),
            "unstable": parts[0], "declines": parts[1]}
