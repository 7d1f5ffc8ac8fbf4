// SPDX-License-Identifier: GPL-2.0-or-later
// phi = phi_D(x, t) at vertices: both bounds of the active set there. On a slit
// it is that of both faces.

#include <base/collective.h>
#include <base/log.h>

#include <discretization/nearest_vertex.h>

#include <simulation/phase_field_points.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const char *const phase_field_entry =
      "Boundary conditions/Phase field at points";

    template <int dim>
    double
    phase_field_at(const PointEntry<dim> &entry, const double time)
    {
      ExpressionFunction<dim> function(1);
      function.set(0, entry.expression);
      function.set_time(time);
      const double value = function.value(entry.point, 0);
      if (!(value >= 0. && value <= 1.))
        throw InputError(std::string(phase_field_entry) + ": the expression '" +
                         entry.expression->text() + "' gives " +
                         format("%.6g at ", value) + in_words(entry.point) +
                         format(", t = %.6g", time) +
                         "; allowed are values within 0 (broken) and 1.");
      return value;
    }
  } // namespace



  template <int dim>
  void
  PhaseFieldPoints<dim>::reinit(const Fields<dim>      &fields,
                                const Constraints<dim> &constraints)
  {
    if (entries.empty())
      return;
    communicator = fields.communicator();
    std::vector<VertexComponent<dim>> places;
    for (const PointEntry<dim> &entry : entries)
      places.push_back({entry.point, 0});
    owned_dofs =
      owned_of(dofs_at_vertices(fields.phase_field,
                                constraints.phase_field_hanging_nodes(),
                                places,
                                phase_field_entry),
               fields.phase_field_dofs.owned);
  }



  template <int dim>
  void
  PhaseFieldPoints<dim>::add(
    const double                               time,
    std::map<types::global_dof_index, double> &values) const
  {
    if (entries.empty())
      return;
    together(communicator, [&]() {
      for (std::size_t i = 0; i < entries.size(); ++i)
      {
        const double value = phase_field_at(entries[i], time);
        for (const auto dof : owned_dofs[i])
          values.insert({dof, value});
      }
    });
  }



  template class PhaseFieldPoints<2>;
  template class PhaseFieldPoints<3>;
} // namespace MixedCracks
