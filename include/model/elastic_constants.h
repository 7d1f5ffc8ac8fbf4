// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_elastic_constants_h
#define mixed_cracks_model_elastic_constants_h

#include <optional>

namespace MixedCracks
{
  /// The elastic constants a user may give; exactly two of them. MPa, but for
  /// the Poisson ratio.
  struct GivenElasticConstants
  {
    std::optional<double> lame_lambda;
    std::optional<double> shear_modulus;
    std::optional<double> youngs_modulus;
    std::optional<double> poisson_ratio;
    std::optional<double> bulk_modulus;
  };

  /// Isotropic linear elasticity in three dimensions; MPa.
  struct ElasticConstants
  {
    double lambda;
    double mu;

    double youngs_modulus() const;
    double poisson_ratio() const;
    double bulk_modulus() const;
  };

  /// Lame's pair from any pair. Throws InputError unless exactly two are
  /// given and the result is admissible (mu > 0, lambda > 0: the pressure law
  /// divides by lambda).
  ElasticConstants elastic_constants(const GivenElasticConstants &given);

  /// Plane stress (M6): lambda* = 2 lambda mu / (lambda + 2 mu), mu unchanged.
  ElasticConstants plane_stress(const ElasticConstants &constants);
} // namespace MixedCracks

#endif
