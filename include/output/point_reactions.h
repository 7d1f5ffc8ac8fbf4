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
    /// @p points: those that are prescribed, in the order of the .prm. Of a
    /// set, whose points the mesh tells, one for each component is enough.
    PointReactions(const Constraints<dim>                  &constraints,
                   const std::vector<PrescribedPoint<dim>> &points);

    /// "reaction_1_x_N": one for each prescribed component, in the order in
    /// which the .prm names them; points are counted from 1, a set of points
    /// has its name in place of the number, and the sum over its points.
    const std::vector<std::string> &
    column_names() const
    {
      return columns;
    }

    /// In that order, as they act on the body; N, in 2-d per mm of thickness.
    /// The same on all ranks. Collective.
    std::vector<double> evaluate(const Fields<dim>           &fields,
                                 const LinearAlgebra::Vector &reaction) const;

  private:
    const Constraints<dim>  &constraints;
    std::vector<std::string> columns;
  };
} // namespace MixedCracks

#endif
