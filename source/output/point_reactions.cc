// SPDX-License-Identifier: GPL-2.0-or-later
// The reaction at a point is the residual r = internal - external forces of its
// node (State::reaction), as on a boundary (output/boundary_quantities.cc):
//
//   R_d = sum over the vertices i at the point of r_(i,d),
//
// more than one on a slit; on a periodic side that of all images, where the
// forces through the side add up to 0. All supports together balance the loads
// to the accuracy of the solver.

#include <deal.II/base/mpi.h>

#include <output/point_reactions.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // the name of the column of each point
    template <int dim>
    std::vector<std::string>
    columns_of(const std::vector<PrescribedPoint<dim>> &prescribed)
    {
      std::vector<std::string> names;
      std::vector<Point<dim>>  points;
      for (const PrescribedPoint<dim> &entry : prescribed)
      {
        std::string which = entry.set;
        std::replace(which.begin(), which.end(), ' ', '_');
        if (entry.set.empty())
        {
          const auto found =
            std::find(points.begin(), points.end(), entry.point);
          const auto number = found - points.begin() + 1;
          if (found == points.end())
            points.push_back(entry.point);
          which = std::to_string(number);
        }
        names.push_back("reaction_" + which + '_' + "xyz"[entry.component] +
                        "_N");
      }
      return names;
    }
  } // namespace



  template <int dim>
  PointReactions<dim>::PointReactions(
    const Constraints<dim>                  &constraints,
    const std::vector<PrescribedPoint<dim>> &points)
    : constraints(constraints)
  {
    for (const std::string &name : columns_of(points))
      if (std::find(columns.begin(), columns.end(), name) == columns.end())
        columns.push_back(name);
  }



  template <int dim>
  std::vector<double>
  PointReactions<dim>::evaluate(const Fields<dim>           &fields,
                                const LinearAlgebra::Vector &reaction) const
  {
    const std::vector<std::string> names =
      columns_of(constraints.prescribed_points());
    std::vector<double> sums(columns.size(), 0.);
    if (sums.empty())
      return sums;
    LinearAlgebra::Vector given = fields.owned_vector(fields.elastic_dofs);
    given                       = reaction;
    constraints.drop_periodic(given);
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      const auto column =
        std::find(columns.begin(), columns.end(), names[i]) - columns.begin();
      // what is held because nothing else holds it has none
      if (columns.begin() + column == columns.end())
        continue;
      for (const auto dof : constraints.dofs_of_points()[i])
        if (const auto at = constraints.periodic().master_of(dof);
            fields.elastic_dofs.owned.is_element(at))
          sums[column] += given(at);
    }
    Utilities::MPI::sum(sums, fields.communicator(), sums);
    return sums;
  }



  template class PointReactions<2>;
  template class PointReactions<3>;
} // namespace MixedCracks
