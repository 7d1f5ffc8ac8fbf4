// SPDX-License-Identifier: GPL-2.0-or-later
// A body (-1,1)^dim with hanging nodes, on which displacement and phase field
// are imposed.
#ifndef mixed_cracks_tests_unit_imposed_opening_h
#define mixed_cracks_tests_unit_imposed_opening_h

#include "materials.h"

#include <deal.II/base/function.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <discretization/constraints.h>
#include <discretization/fields.h>

#include <functional>

namespace MixedCracks
{
  namespace Testing
  {
    template <int dim>
    class OpenedBody
    {
    public:
      explicit OpenedBody(const bool mixed)
        : triangulation(MPI_COMM_WORLD)
        , fields(triangulation, {mixed, mixed ? 2u : 1u})
        , constraints(fields, {})
      {
        dealii::GridGenerator::subdivided_hyper_cube(triangulation, 4, -1., 1.);
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned() && cell->center()[0] > 0.)
            cell->set_refine_flag();
        triangulation.execute_coarsening_and_refinement();
        fields.distribute();
        constraints.reinit();
        elastic     = fields.ghosted_vector(fields.elastic_dofs);
        phase_field = fields.ghosted_vector(fields.phase_field_dofs);
      }

      void
      set_displacement(
        const std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &)>
          &u)
      {
        std::vector<std::function<double(const dealii::Point<dim> &)>>
          components(fields.elastic.get_fe().n_components(),
                     [](const dealii::Point<dim> &) { return 0.; });
        for (unsigned int d = 0; d < dim; ++d)
          components[d] = [&u, d](const dealii::Point<dim> &x) {
            return u(x)[d];
          };
        const dealii::FunctionFromFunctionObjects<dim> function(components);
        LinearAlgebra::Vector owned = fields.owned_vector(fields.elastic_dofs);
        dealii::VectorTools::interpolate(
          fields.mapping, fields.elastic, function, owned);
        constraints.elastic_hanging_nodes().distribute(owned);
        elastic = owned;
      }

      void
      set_phase_field(
        const std::function<double(const dealii::Point<dim> &)> &phi)
      {
        LinearAlgebra::Vector owned =
          fields.owned_vector(fields.phase_field_dofs);
        dealii::VectorTools::interpolate(
          fields.mapping,
          fields.phase_field,
          dealii::ScalarFunctionFromFunctionObject<dim>(phi),
          owned);
        constraints.phase_field_hanging_nodes().distribute(owned);
        phase_field = owned;
      }

      dealii::parallel::distributed::Triangulation<dim> triangulation;
      Fields<dim>                                       fields;
      Constraints<dim>                                  constraints;
      LinearAlgebra::Vector                             elastic;
      LinearAlgebra::Vector                             phase_field;
    };
  } // namespace Testing
} // namespace MixedCracks

#endif
