// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_elastic_response_h
#define mixed_cracks_model_elastic_response_h

#include <deal.II/base/symmetric_tensor.h>

namespace MixedCracks
{
  /// Placeholder of the contract; the model layer has its own.
  template <int dim>
  struct ElasticResponse
  {
    dealii::Tensor<2, dim> stress; ///< sigma or P, MPa
    double                 constraint             = 0.;
    double                 constraint_by_pressure = 0.; ///< 1/MPa, negative
    dealii::SymmetricTensor<4, dim> stress_by_strain;   ///< small strain
    double                          stress_by_pressure  = 0.;
    double                          constraint_by_trace = 0.;
    dealii::Tensor<4, dim>          stress_by_gradient; ///< finite strain
    dealii::Tensor<2, dim>          coupling;
  };
} // namespace MixedCracks

#endif
