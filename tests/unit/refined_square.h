// SPDX-License-Identifier: GPL-2.0-or-later
// The loops over the cells on a mesh with hanging nodes that the ranks share.
#ifndef mixed_cracks_tests_unit_refined_square_h
#define mixed_cracks_tests_unit_refined_square_h

#include "materials.h"

#include <assembly/assembler.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <discretization/constraints.h>
#include <discretization/sparse_matrix.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

namespace MixedCracks
{
  namespace Testing
  {
    /// A square with refined cells in a corner and in the middle, free of
    /// loads.
    struct RefinedCells
    {
      static constexpr int dim = 2;
      using Vector             = LinearAlgebra::Vector;
      using Function = std::function<double(const dealii::Point<dim> &)>;

      RefinedCells(const bool mixed, const MaterialDescription &description)
        : triangulation(MPI_COMM_WORLD)
        , fields(triangulation, {mixed, 2})
        , constraints(fields, {})
        , material(description)
      {
        dealii::GridGenerator::subdivided_hyper_cube(triangulation, 4);
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned() &&
              (cell->center().norm() < 0.3 ||
               cell->center().distance({0.6, 0.6}) < 0.1))
            cell->set_refine_flag();
        triangulation.execute_coarsening_and_refinement();
        fields.distribute();
        constraints.reinit();
        assembler = std::make_unique<Assembler<dim>>(fields, material);
        assembler->reinit();
      }

      /// Displacements and, in the mixed form, the pressure; without ghosts,
      /// hanging nodes fit.
      Vector
      field(const Function &u, const Function &v, const Function &p) const
      {
        std::vector<Function> all = {u, v};
        if (fields.layout.mixed)
          all.push_back(p);
        Vector owned = fields.owned_vector(fields.elastic_dofs);
        dealii::VectorTools::interpolate(
          fields.mapping,
          fields.elastic,
          dealii::FunctionFromFunctionObjects<dim>(all),
          owned);
        constraints.elastic_hanging_nodes().distribute(owned);
        return owned;
      }

      /// Broken around (@p x, 0.5), intact elsewhere; with ghosts.
      Vector
      phase_field(const double x) const
      {
        Vector owned = fields.owned_vector(fields.phase_field_dofs);
        dealii::VectorTools::interpolate(
          fields.mapping,
          fields.phase_field,
          dealii::ScalarFunctionFromFunctionObject<dim>(
            [x](const dealii::Point<dim> &p) {
              return std::min(1., 3. * p.distance({x, 0.5}));
            }),
          owned);
        constraints.phase_field_hanging_nodes().distribute(owned);
        return with_ghosts(owned, fields.phase_field_dofs);
      }

      Vector
      with_ghosts(const Vector &owned, const DofSets &dofs) const
      {
        Vector result = fields.ghosted_vector(dofs);
        result        = owned;
        return result;
      }

      dealii::parallel::distributed::Triangulation<dim> triangulation;
      Fields<dim>                                       fields;
      Constraints<dim>                                  constraints;
      const Material<dim>                               material;
      std::unique_ptr<Assembler<dim>>                   assembler;
    };
  } // namespace Testing
} // namespace MixedCracks

#endif
