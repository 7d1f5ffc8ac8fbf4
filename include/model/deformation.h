// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_deformation_h
#define mixed_cracks_model_deformation_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace MixedCracks
{
  /// What follows from the deformation gradient at one point, always in three
  /// dimensions (M11). Differences from the undeformed state are computed
  /// without cancellation, so that the energies of small strains have all
  /// their digits. Dimensionless.
  struct Deformation
  {
    /// @p gradient: F with det F > 0.
    explicit Deformation(const dealii::Tensor<2, 3> &gradient);

    dealii::Tensor<2, 3>          gradient;      ///< F
    dealii::SymmetricTensor<2, 3> strain;        ///< E = (F^T F - I)/2
    dealii::Tensor<2, 3>          cofactor;      ///< dJ/dF = J F^-T
    double                        volume_change; ///< J - 1
    double                        log_volume;    ///< ln J
    dealii::Tensor<2, 3>          log_gradient;  ///< d(ln J)/dF = F^-T
  };

  /// Principal stretches lambda_a in descending order, F = sum_a lambda_a n_a
  /// (x) N_a with orthonormal n_a and N_a.
  struct PrincipalStretches
  {
    explicit PrincipalStretches(const Deformation &deformation);

    std::array<double, 3>               logarithms; ///< ln lambda_a
    std::array<dealii::Tensor<1, 3>, 3> directions; ///< n_a, deformed
    std::array<dealii::Tensor<1, 3>, 3> reference;  ///< N_a, undeformed
  };

  /// @p tangent += @p factor * a (x) b.
  void add_outer_product(dealii::Tensor<4, 3>       &tangent,
                         double                      factor,
                         const dealii::Tensor<2, 3> &a,
                         const dealii::Tensor<2, 3> &b);

  /// @p tangent += @p factor * d2(ln J)/dF dF.
  void add_second_log_derivative(dealii::Tensor<4, 3> &tangent,
                                 double                factor,
                                 const Deformation    &deformation);

  /// @p tangent += @p factor * d2J/dF dF.
  void add_second_volume_derivative(dealii::Tensor<4, 3> &tangent,
                                    double                factor,
                                    const Deformation    &deformation);
} // namespace MixedCracks

#endif
