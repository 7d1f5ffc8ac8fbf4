// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_energy_interpolation_h
#define mixed_cracks_model_energy_interpolation_h

#include <model/hyperelastic_law.h>

namespace MixedCracks
{
  /// gamma(g) of the interpolated energy of damaged rubber, 0 to 1: 1 where
  /// the material obeys its law, 0 where it is broken and linear. No unit.
  double nonlinear_share(double degradation);

  /// mu_L of the linear part, MPa.
  double linear_modulus(const HyperelasticLaw       &law,
                        const HyperelasticConstants &constants);
} // namespace MixedCracks

#endif
