// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_spectral_split_h
#define mixed_cracks_model_spectral_split_h

#include <model/energy_split.h>

#include <array>

namespace MixedCracks
{
  /// Principal strains in descending order with an orthonormal basis of
  /// principal directions.
  template <int dim>
  struct PrincipalStrains
  {
    std::array<double, dim>                 values; ///< dimensionless
    std::array<dealii::Tensor<1, dim>, dim> directions;
  };

  template <int dim>
  PrincipalStrains<dim>
  principal_strains(const dealii::SymmetricTensor<2, dim> &strain);

  /// The spectral split (M4), [Miehe10a], of the part 2 mu eps of the stress:
  /// sigma+ = 2 mu eps+ with eps+ = sum_a <eps_a> n_a n_a, from the energy
  /// mu eps+ : eps+. Its tangent in the principal basis multiplies the entry
  /// ab of a strain rate by (<eps_a> - <eps_b>)/(eps_a - eps_b), which is 1 or
  /// 0 where both strains have the same sign, equal or not: there is nothing
  /// to regularize. At a principal strain of 0 the derivative of <.> is 1/2,
  /// the mean of its one-sided limits. In plane strain the third principal
  /// strain is 0 and belongs to neither part.
  template <int dim>
  class SpectralSplit : public EnergySplit<dim>
  {
  public:
    SplitStress<dim> evaluate(const dealii::SymmetricTensor<2, dim> &strain,
                              double mu) const override;

    StressParts<dim> parts(const dealii::SymmetricTensor<2, dim> &strain,
                           double mu) const override;

    /// Only where all principal strains have one sign does the tangent not
    /// depend on their directions.
    int tangent_regime(
      const dealii::SymmetricTensor<2, dim> &strain) const override;

    bool
    splits_pressure() const override
    {
      return true;
    }
  };
} // namespace MixedCracks

#endif
