// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_mean_stress_h
#define mixed_cracks_output_mean_stress_h

#include <assembly/assembler.h>

#include <discretization/state.h>

namespace MixedCracks
{
  /// The integral of the stress over the body, at finite strain of the first
  /// Piola-Kirchhoff stress P_ij, i the component and j the normal; N mm, in
  /// 2-d per mm thickness. Of the lagged phase field, with which the forces
  /// balance. Collective.
  template <int dim>
  dealii::Tensor<2, dim> integral_of_stress(const Fields<dim> &fields,
                                            Assembler<dim>    &assembler,
                                            const State       &state);
} // namespace MixedCracks

#endif
