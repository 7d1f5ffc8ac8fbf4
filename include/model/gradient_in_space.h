// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_gradient_in_space_h
#define mixed_cracks_model_gradient_in_space_h

#include <deal.II/base/tensor.h>

namespace MixedCracks
{
  /// F (3 x 3) from grad u; @p stretch: F_33 in 2-d. No units.
  template <int dim>
  dealii::Tensor<2, 3>
  gradient_in_space(const dealii::Tensor<2, dim> &gradient,
                    const double                  stretch)
  {
    dealii::Tensor<2, 3> result;
    result[2][2] = stretch;
    for (unsigned int i = 0; i < dim; ++i)
    {
      for (unsigned int j = 0; j < dim; ++j)
        result[i][j] = gradient[i][j];
      result[i][i] += 1.;
    }
    return result;
  }



  /// det(I + grad u): J in 3-d, J_2 of the part in the plane in 2-d.
  template <int dim>
  double
  determinant_of(const dealii::Tensor<2, dim> &gradient)
  {
    dealii::Tensor<2, dim> deformation = gradient;
    for (unsigned int d = 0; d < dim; ++d)
      deformation[d][d] += 1.;
    return dealii::determinant(deformation);
  }
} // namespace MixedCracks

#endif
