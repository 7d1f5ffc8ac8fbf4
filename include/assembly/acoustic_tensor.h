// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_acoustic_tensor_h
#define mixed_cracks_assembly_acoustic_tensor_h

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

namespace MixedCracks
{
  /// Q_de = C_dJeK n_J n_K of a tangent, MPa: what waves of direction @p n see.
  template <int dim>
  dealii::Tensor<2, dim>
  acoustic_tensor(const dealii::Tensor<4, dim> &tangent,
                  const dealii::Tensor<1, dim> &n)
  {
    dealii::Tensor<2, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int j = 0; j < dim; ++j)
        for (unsigned int e = 0; e < dim; ++e)
          result[d][e] += n[j] * (tangent[d][j][e] * n);
    return result;
  }



  /// Unit vectors along the axes and the diagonals of the cube, one of each
  /// pair of opposite ones.
  template <int dim>
  const std::vector<dealii::Tensor<1, dim>> &
  axes_and_diagonals()
  {
    static const std::vector<dealii::Tensor<1, dim>> all = []() {
      std::vector<dealii::Tensor<1, dim>> result;
      for (unsigned int i = 0; i < dim; ++i)
      {
        dealii::Tensor<1, dim> axis;
        axis[i] = 1.;
        result.push_back(axis);
      }
      for (unsigned int signs = 0; signs < (1u << (dim - 1)); ++signs)
      {
        dealii::Tensor<1, dim> diagonal;
        for (unsigned int i = 0; i < dim; ++i)
          diagonal[i] = (signs >> i) % 2 == 1 ? -1. : 1.;
        result.push_back(diagonal / diagonal.norm());
      }
      return result;
    }();
    return all;
  }
} // namespace MixedCracks

#endif
