// SPDX-License-Identifier: GPL-2.0-or-later
// The reaction at a point is the residual r = internal - external forces of its
// node (State::reaction), as on a boundary (output/boundary_quantities.cc):
//
//   R_d = sum over the vertices i at the point of r_(i,d),
//
// more than one on a slit. All supports together balance the loads to the
// accuracy of the solver.

#include <deal.II/base/mpi.h>

#include <output/point_reactions.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  std::vector<std::string>
  PointReactions<dim>::column_names() const
  {
    std::vector<std::string> names;
    std::vector<Point<dim>>  points;
    for (const auto &entry : constraints.prescribed_points())
    {
      const auto found  = std::find(points.begin(), points.end(), entry.point);
      const auto number = found - points.begin() + 1;
      if (found == points.end())
        points.push_back(entry.point);
      names.push_back("reaction_" + std::to_string(number) + '_' +
                      "xyz"[entry.component] + "_N");
    }
    return names;
  }



  template <int dim>
  std::vector<double>
  PointReactions<dim>::evaluate(const Fields<dim>           &fields,
                                const LinearAlgebra::Vector &reaction) const
  {
    std::vector<double> sums;
    for (const VertexDofs &dofs : constraints.dofs_of_points())
    {
      sums.push_back(0.);
      for (const auto dof : dofs)
        if (fields.elastic_dofs.owned.is_element(dof))
          sums.back() += reaction(dof);
    }
    if (!sums.empty())
      Utilities::MPI::sum(sums, fields.communicator(), sums);
    return sums;
  }



  template class PointReactions<2>;
  template class PointReactions<3>;
} // namespace MixedCracks
