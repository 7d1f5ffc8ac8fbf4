// SPDX-License-Identifier: GPL-2.0-or-later
// Expressions of what is applied, tried before anything is solved.
//
// An expression may fail at a place or a time, as sqrt(x - 1) or 1/t. What
// would fail in the first step is found before it: all that is applied is
// evaluated at t = 0, at the points where the assembly will ask for it. Later
// times cannot be tried, as they follow from the course of the run.

#include <assembly/constants_table.h>

#include <base/collective.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <simulation/phase_field_points.h>
#include <simulation/simulation_setup.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    void
    try_at(const Function<dim> &load,
           const Point<dim>    &point,
           const unsigned int   n_components)
    {
      for (unsigned int component = 0; component < n_components; ++component)
        load.value(point, component);
    }



    template <int dim>
    void
    try_in_cells(const Loads<dim>    &loads,
                 const Function<dim> *fluid,
                 const Fields<dim>   &fields)
    {
      if (loads.body_force)
        loads.body_force->set_time(0.);
      if (!loads.body_force && fluid == nullptr)
        return;
      for_each_quadrature_point<dim>(
        fields, [&](const Point<dim> &point, types::material_id) {
          if (loads.body_force)
            try_at(*loads.body_force, point, dim);
          if (fluid != nullptr)
            try_at(*fluid, point, 1);
        });
    }



    template <int dim>
    void
    try_on_boundaries(const Loads<dim> &loads, const Fields<dim> &fields)
    {
      const FE_Nothing<dim> no_shapes;
      FEFaceValues<dim>     face_values(
        fields.mapping,
        no_shapes,
        QGauss<dim - 1>(fields.elastic.get_fe().degree + 1),
        update_quadrature_points);
      const auto try_on = [&](const auto        &functions,
                              const unsigned int n_components,
                              const auto        &cell,
                              const unsigned int face) {
        const auto load = functions.find(cell->face(face)->boundary_id());
        if (load == functions.end())
          return;
        load->second->set_time(0.);
        face_values.reinit(cell, face);
        for (const Point<dim> &point : face_values.get_quadrature_points())
          try_at(*load->second, point, n_components);
      };
      together(fields.communicator(), [&]() {
        for (const auto &cell :
             fields.elastic.get_triangulation().active_cell_iterators())
          if (cell->is_locally_owned())
            for (const unsigned int face : cell->face_indices())
              if (cell->face(face)->at_boundary())
              {
                try_on(loads.tractions, dim, cell, face);
                try_on(loads.normal_tractions, 1, cell, face);
                try_on(loads.pressures, 1, cell, face);
              }
      });
    }
  } // namespace



  template <int dim>
  void
  try_loads_at_start(const Parameters<dim>  &parameters,
                     const Fields<dim>      &fields,
                     const Constraints<dim> &constraints,
                     const bool              stands_for_finer)
  {
    LinearAlgebra::Vector values = fields.owned_vector(fields.elastic_dofs);
    constraints.apply_prescribed(0., values);
    auto phase_field = prescribed_phase_field(parameters, fields, 0.);
    PhaseFieldPoints<dim> phase_field_points(parameters.boundary_conditions);
    phase_field_points.reinit(fields, constraints);
    phase_field_points.add(0., phase_field);
    Loads<dim> loads = make_loads(
      parameters, dim, fields.elastic.get_triangulation(), stands_for_finer);
    loads.at_points.reinit(fields, constraints.elastic_hanging_nodes());
    loads.at_points.add(0., values);
    const auto fluid = parameters.fluid.pressure();
    try_in_cells(loads, fluid.get(), fields);
    try_on_boundaries(loads, fields);
  }



  template void try_loads_at_start(const Parameters<2> &,
                                   const Fields<2> &,
                                   const Constraints<2> &,
                                   bool);
  template void try_loads_at_start(const Parameters<3> &,
                                   const Fields<3> &,
                                   const Constraints<3> &,
                                   bool);
} // namespace MixedCracks
