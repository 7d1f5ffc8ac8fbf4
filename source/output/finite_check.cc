// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/log.h>

#include <deal.II/base/mpi.h>

#include <output/finite_check.h>

#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // Counted, since a norm of numbers that are finite may overflow, and since
    // comparisons with NaN are always false: max(0, NaN) is 0. The sum over the
    // ranks is the same on all of them, and so is what they decide.
    unsigned long
    n_not_finite(const LinearAlgebra::Vector &vector,
                 const IndexSet              &owned,
                 const MPI_Comm               communicator)
    {
      unsigned long n = 0;
      for (const auto dof : owned)
        n += std::isfinite(static_cast<double>(vector(dof))) ? 0 : 1;
      return Utilities::MPI::sum(n, communicator);
    }



    // the first quantity of a row that is not finite, with its value
    std::string
    fault_of(const StatisticsRow &row)
    {
      std::vector<std::pair<const char *, double>> quantities = {
        {"the displacement of the boundary", row["displacement"]},
        {"the reaction force", row.force_size()},
        {"the elastic energy", row["elastic_energy"]},
        {"the crack energy", row["crack_energy"]},
        {"the external work", row["external_work"]},
        {"the size of the cracks", row["crack_length"]},
        {"the smallest phase field", row["min_phase_field"]},
        {"the change of the phase field", row["max_phase_field_change"]},
        {"the change in the coupling", row["coupling_change"]}};
      for (const double displacement : row.point_displacements)
        quantities.emplace_back("the displacement at a point", displacement);
      for (const double reaction : row.reactions)
        quantities.emplace_back("the reaction at a point", reaction);
      for (const auto &[name, value] : quantities)
        if (!std::isfinite(value))
          return format("%s is not finite (%g)", name, value);
      return "";
    }
  } // namespace



  template <int dim>
  std::string
  not_finite(const Fields<dim>   &fields,
             const State         &state,
             const StatisticsRow &row)
  {
    const DofSets &elastic = fields.elastic_dofs;
    const DofSets &phase   = fields.phase_field_dofs;
    const struct
    {
      const char                  *name;
      const LinearAlgebra::Vector &vector;
      const IndexSet              &owned;
    } vectors[] = {
      {fields.layout.mixed ? "displacement and pressure" : "displacement",
       state.elastic,
       elastic.owned},
      {"reactions", state.reaction, elastic.owned},
      {"phase field", state.phase_field, phase.owned},
      {"lagged phase field", state.lagged_phase_field, phase.owned}};
    for (const auto &entry : vectors)
    {
      const unsigned long n =
        n_not_finite(entry.vector, entry.owned, fields.communicator());
      if (n > 0)
        return format("%s: %lu of %llu values are not finite",
                      entry.name,
                      n,
                      static_cast<unsigned long long>(entry.owned.size()));
    }
    // the crack volume, which only some ask for, is empty where it overflows
    return fault_of(row);
  }



  template std::string
  not_finite(const Fields<2> &, const State &, const StatisticsRow &);
  template std::string
  not_finite(const Fields<3> &, const State &, const StatisticsRow &);
} // namespace MixedCracks
