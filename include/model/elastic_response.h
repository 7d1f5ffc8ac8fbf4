// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_elastic_response_h
#define mixed_cracks_model_elastic_response_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <optional>

namespace MixedCracks
{
  /// Derivatives at finite strain, F_33 condensed out in plane stress.
  template <int dim>
  struct FiniteTangent
  {
    /// dP_iJ/d(grad u)_kL, MPa, with major symmetry.
    dealii::Tensor<4, dim> stress_by_gradient;
    /// dP/dp = d(constraint)/d(grad u), dimensionless.
    dealii::Tensor<2, dim> coupling;
  };

  /// Stress, constraint and their derivatives at one point for a given
  /// degradation: the integrands of (stress, grad w) and (constraint, q), the
  /// first two lines of (M5). Derivatives are valid only where they have been
  /// asked for.
  template <int dim>
  struct ElasticResponse
  {
    /// sigma = g sigma+ + sigma-, symmetric; at finite strain P, first
    /// Piola-Kirchhoff. MPa.
    dealii::Tensor<2, dim> stress;
    /// divergence tr(eps) - compliance p; at finite strain s theta(J) -
    /// compliance p, see FinitePressureLaw.
    double constraint = 0.;
    /// 1/MPa, negative.
    double constraint_by_pressure = 0.;

    /// Small strains only; MPa.
    dealii::SymmetricTensor<4, dim> stress_by_strain;
    /// Small strains only: d(stress)/dp = this * I.
    double stress_by_pressure = 0.;
    /// Small strains only: d(constraint)/d(tr eps).
    double constraint_by_trace = 0.;

    /// Finite strain only: at small strains nobody fills its 81 numbers.
    std::optional<FiniteTangent<dim>> finite;
  };

  /// C = identity 1 + volume I (x) I, MPa: 2 mu and lambda, degraded or not.
  struct IsotropicTangent
  {
    double identity;
    double volume;
  };

  /// Entry of C as a symmetric matrix, in the numbering of SymmetricTensor.
  template <int dim>
  double tangent_entry(const dealii::SymmetricTensor<4, dim> &tangent,
                       unsigned int                           row,
                       unsigned int                           column);

  /// The two constants, if C is of that form but for rounding.
  template <int dim>
  std::optional<IsotropicTangent>
  isotropic_tangent(const dealii::SymmetricTensor<4, dim> &tangent);
} // namespace MixedCracks

#endif
