// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_point_reactions_h
#define mixed_cracks_output_point_reactions_h

#include <discretization/constraints.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// The reactions at the points with prescribed displacement.
  template <int dim>
  class PointReactions
  {
  public:
    explicit PointReactions(const Constraints<dim> &constraints)
      : constraints(constraints)
    {}

    /// "reaction_1_x_N": one for each prescribed component, in the order in
    /// which the .prm names them; points are counted from 1.
    std::vector<std::string> column_names() const;

    /// In that order, as they act on the body; N, in 2-d per mm of thickness.
    /// The same on all ranks. Collective.
    std::vector<double> evaluate(const Fields<dim>           &fields,
                                 const LinearAlgebra::Vector &reaction) const;

  private:
    const Constraints<dim> &constraints;
  };
} // namespace MixedCracks

#endif
