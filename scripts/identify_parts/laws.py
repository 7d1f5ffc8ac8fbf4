# SPDX-License-Identifier: GPL-2.0-or-later
"""Hyperelastic laws (M12) of an incompressible body in principal stretches.

With J = 1 the energy is W(e_1, e_2, e_3), e_i = ln(lambda_i), in MPa. A law gives
    g_i  = dW/de_i        (MPa)
    h_ij = d2W/de_i de_j  (MPa)
and everything else follows: with lambda_3 the free direction, its stress 0, the
Cauchy stress is g_1 - g_3 and the nominal one (g_1 - g_3) / lambda_1.

    law            W
    neo-Hooke      mu/2 (I1-3)
    Mooney-Rivlin  C10 (I1-3) + C01 (I2-3)
    Yeoh           C10 (I1-3) + C20 (I1-3)^2 + C30 (I1-3)^3
    Gent           -mu Jm/2 ln(1 - (I1-3)/Jm)
    Ogden          sum mu_i/alpha_i (l1^alpha_i + l2^alpha_i + l3^alpha_i - 3)

I1 = sum lambda_i^2, I2 = sum lambda_i^-2. The ln J terms of (M12) only change the
pressure, which the free direction gives.
"""
import itertools

import numpy as np

from report_parts.errors import InputError

MODES = ("uniaxial", "planar", "equibiaxial")


def stretches(mode, stretch):
    """The three principal stretches, shape (3, n); the third direction is free."""
    stretch = np.asarray(stretch)
    if mode == "uniaxial":
        return np.array([stretch, stretch**-0.5, stretch**-0.5])
    if mode == "planar":
        return np.array([stretch, np.ones_like(stretch), 1. / stretch])
    return np.array([stretch, stretch, stretch**-2.])


class Law:
    """names: of the constants as the .prm has them. linear: indices of those in
    which the stress is linear."""

    def __init__(self, name, names, linear=None):
        self.name = name
        self.names = names
        self.linear = list(range(len(names))) if linear is None else linear
        self.other = [i for i in range(len(names)) if i not in self.linear]

    def unit(self, i):
        return "" if self.names[i].startswith(("alpha", "Jm")) else "MPa"

    def nominal_stress(self, constants, mode, stretch):
        """MPa, in the direction of the load (or both)."""
        first = self.first(constants, stretches(mode, stretch))
        return (first[0] - first[2]) / stretch

    def bounds(self, _largest_invariant):
        """(lower, upper) of all constants."""
        return [-np.inf] * len(self.names), [np.inf] * len(self.names)

    def starts(self, _largest_invariant):
        """Values of the constants that are not linear, to start from."""
        return [()]

    def ordered(self, constants):
        """The same law, its constants in the order they are written in."""
        return constants

    def exists(self, _constants, invariant):
        """Where the law has a stress, for values of I1 - 3."""
        return np.ones_like(invariant, dtype=bool)

    def check(self, _constants, _largest_invariant):
        """Raises InputError where the law has no stress."""


class InvariantLaw(Law):
    """W(I1, I2) with dW/dI2 constant: derivatives() gives W1, W2, W11 (MPa)."""

    def first(self, constants, lam):
        w1, w2, _ = self.derivatives(constants, np.sum(lam**2, axis=0) - 3.)
        return 2. * w1 * lam**2 - 2. * w2 * lam**-2.

    def second(self, constants, lam):
        w1, w2, w11 = self.derivatives(constants, np.sum(lam**2, axis=0) - 3.)
        h = 4. * w11 * lam[:, None]**2 * lam[None, :]**2
        for i in range(3):
            h[i, i] += 4. * w1 * lam[i]**2 + 4. * w2 * lam[i]**-2.
        return h

    def shear_modulus(self, constants):
        w1, w2, _ = self.derivatives(constants, 0.)
        return 2. * (w1 + w2)


class NeoHooke(InvariantLaw):
    def derivatives(self, constants, invariant):
        return 0.5 * constants[0] + 0. * invariant, 0., 0. * invariant


class MooneyRivlin(InvariantLaw):
    def derivatives(self, constants, invariant):
        return constants[0] + 0. * invariant, constants[1], 0. * invariant


class Yeoh(InvariantLaw):
    def derivatives(self, constants, invariant):
        c10, c20, c30 = constants
        return (c10 + 2. * c20 * invariant + 3. * c30 * invariant**2, 0.,
                2. * c20 + 6. * c30 * invariant)


class Gent(InvariantLaw):
    def derivatives(self, constants, invariant):
        mu, limit = constants
        left = limit - invariant
        return 0.5 * mu * limit / left, 0., 0.5 * mu * limit / left**2

    def bounds(self, largest_invariant):
        return [-np.inf, largest_invariant * (1. + 1e-9)], [np.inf, np.inf]

    def starts(self, largest_invariant):
        return [(largest_invariant * factor,)
                for factor in (1.02, 1.1, 1.3, 2., 4., 10., 100.)]

    def exists(self, constants, invariant):
        return invariant < constants[1] * (1. - 1e-9)

    def check(self, constants, largest_invariant):
        if constants[1] <= largest_invariant:
            raise InputError("Jm = %g: the law ends at I1 - 3 = Jm, expected more than "
                             "the %g of the stretches asked for"
                             % (constants[1], largest_invariant))


class Ogden(Law):
    """mu1, alpha1, mu2, alpha2, ..."""

    EXPONENTS = (-6., -4., -2., -1., 0.5, 1., 1.5, 2., 3., 4., 6., 8., 12.)

    def first(self, constants, lam):
        return sum(mu * lam**alpha
                   for mu, alpha in zip(constants[::2], constants[1::2]))

    def second(self, constants, lam):
        h = np.zeros((3,) + lam.shape, dtype=lam.dtype)
        for i in range(3):
            h[i, i] = sum(mu * alpha * lam[i]**alpha
                          for mu, alpha in zip(constants[::2], constants[1::2]))
        return h

    def shear_modulus(self, constants):
        return 0.5 * np.dot(constants[::2], constants[1::2])

    def bounds(self, _largest_invariant):
        n_terms = len(self.linear)
        return [-np.inf, -40.] * n_terms, [np.inf, 40.] * n_terms

    def starts(self, _largest_invariant):
        return list(itertools.combinations(self.EXPONENTS, len(self.linear)))

    def ordered(self, constants):
        pairs = sorted(zip(constants[::2], constants[1::2]),
                       key=lambda pair: -pair[1])
        return np.array(pairs).ravel()

    def check(self, constants, _largest_invariant):
        for name, alpha in zip(self.names[1::2], constants[1::2]):
            if alpha == 0.:
                raise InputError("%s = 0: expected a number other than 0" % name)


# of each name: class, constants, and which of them are linear where not all are; of
# Ogden's law those of three terms
LAWS = {"neo-Hooke": (NeoHooke, ["mu"]), "Mooney-Rivlin": (MooneyRivlin, ["C10", "C01"]),
        "Yeoh": (Yeoh, ["C10", "C20", "C30"]), "Gent": (Gent, ["mu", "Jm"], [0]),
        "Ogden": (Ogden, ["mu1", "alpha1", "mu2", "alpha2", "mu3", "alpha3"], [0, 2, 4])}


def law_of(name, n_terms):
    """The law of that name, whatever its capitals; n_terms is Ogden's."""
    for known, (kind, names, *linear) in LAWS.items():
        if known.lower() == name.lower() and known != "Ogden":
            return kind(known, names, *linear)
        if known.lower() == name.lower():
            return kind(known, names[:2 * n_terms], linear[0][:n_terms])
    raise InputError("--law: expected one of %s, found '%s'" % (", ".join(LAWS), name))


def invariant(mode, stretch):
    """I1 - 3."""
    return np.sum(stretches(mode, stretch)**2, axis=0) - 3.


def largest_invariant(mode, stretch):
    return float(invariant(mode, stretch).max())


def existing(law, constants, mode, stretch):
    """Those of the stretches at which the law has a stress."""
    return stretch[law.exists(constants, invariant(mode, stretch))]
