// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_energy_split_h
#define mixed_cracks_model_energy_split_h

#include <base/registry.h>

#include <deal.II/base/symmetric_tensor.h>

namespace MixedCracks
{
  /// The two parts of the shear stress 2 mu eps at one point, in MPa. Their
  /// sum is 2 mu eps for every strain, unless EnergySplit::adds_up() denies
  /// it.
  template <int dim>
  struct StressParts
  {
    dealii::SymmetricTensor<2, dim> positive;
    dealii::SymmetricTensor<2, dim> negative;
  };

  /// The same with their derivatives by eps.
  template <int dim>
  struct SplitStress : StressParts<dim>
  {
    dealii::SymmetricTensor<4, dim> positive_tangent;
    dealii::SymmetricTensor<4, dim> negative_tangent;
  };

  /// Splits the stress into a part that drives the crack and is degraded by
  /// it, and a part that is not, sigma = g sigma+ + sigma- (M3), (M4). Split
  /// here is the part 2 mu eps; the pressure p I is split by its sign when
  /// splits_pressure() says so. Every split is homogeneous of degree one.
  template <int dim>
  class EnergySplit
  {
  public:
    virtual ~EnergySplit() = default;

    /// @p strain: dimensionless; @p mu: shear modulus, MPa.
    virtual SplitStress<dim>
    evaluate(const dealii::SymmetricTensor<2, dim> &strain,
             double                                 mu) const = 0;

    /// The stresses of evaluate() alone, where nobody asks for tangents.
    virtual StressParts<dim>
    parts(const dealii::SymmetricTensor<2, dim> &strain, double mu) const = 0;

    /// A small integer that is the same for two strains of this split exactly
    /// when both have the same tangents, so that a matrix need not be built
    /// again; -1 when the tangents change with every strain.
    virtual int
    tangent_regime(const dealii::SymmetricTensor<2, dim> &strain) const = 0;

    /// Whether the parts add up to 2 mu eps, so that intact material is
    /// linearly elastic. Only the pair of [Mang21] as printed does not.
    virtual bool
    adds_up() const
    {
      return true;
    }

    /// Whether only p > 0 is degraded (true) or every p (false).
    virtual bool splits_pressure() const = 0;
  };

  /// Splits by name; the argument is n, the dimension of the deviator
  /// eps - (tr eps/n) I, 2 or 3; in 3-d it is 3 whatever is given.
  template <int dim>
  const Registry<EnergySplit<dim>, int> &all_energy_splits();
} // namespace MixedCracks

#endif
