// SPDX-License-Identifier: GPL-2.0-or-later
#include "body.h"

#include <core/text.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <gtest/gtest.h>

#include <output/quantities.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>

namespace MixedCracks
{
  namespace Testing
  {
    using namespace dealii;

    // 'Subsection/Entry = value' lines into the ParameterHandler
    Body::ReadParameters::ReadParameters(const std::string &text)
    {
      ParameterHandler prm;
      add_parameters(prm);
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);)
      {
        const auto equals = line.find('=');
        if (equals == std::string::npos)
          continue;
        std::vector<std::string> path = split_list(line.substr(0, equals), '/');
        const std::string        entry = path.back();
        path.pop_back();
        for (const std::string &subsection : path)
          prm.enter_subsection(subsection);
        prm.set(entry, single_spaced(line.substr(equals + 1)));
        for (std::size_t i = 0; i < path.size(); ++i)
          prm.leave_subsection();
      }
      check();
    }



    Body::Body(const std::string &prm, const Position &shape)
      : parameters(prm)
      , triangulation(MPI_COMM_WORLD)
      , fields(triangulation,
               {parameters.model.mixed(), parameters.model.degree()})
      , constraints(
          fields,
          prescribed_components(parameters, parameters.model.mixed() ? 3 : 2))
      , timer(MPI_COMM_WORLD,
              std::cout,
              TimerOutput::never,
              TimerOutput::wall_times)
    {
      make_mesh_of(shape);
      cell_size =
        GridTools::minimal_cell_diameter(triangulation) / std::sqrt(2.);
      material = std::make_unique<Material<2>>(
        describe_material(parameters.model, parameters.material, 2, cell_size));
      fields.distribute();
      constraints.reinit();
      assembler = std::make_unique<Assembler<2>>(
        fields,
        *material,
        constants_function(
          parameters.model,
          make_material_field(parameters.material, triangulation)));
      elastic_step = std::make_unique<ElasticStep<2>>(
        fields,
        constraints,
        *assembler,
        make_loads(parameters, fields.elastic.get_fe().n_components()),
        timer);
      const LinearOutcome analysis = elastic_step->reinit();
      EXPECT_TRUE(analysis.success) << analysis.reason;
      state.elastic            = fields.ghosted_vector(fields.elastic_dofs);
      state.reaction           = state.elastic;
      state.phase_field        = fields.ghosted_vector(fields.phase_field_dofs);
      state.lagged_phase_field = state.phase_field;
      set_phase_field([](const Point<2> &) { return 1.; });
    }



    void
    Body::make_mesh_of(const Position &shape)
    {
      if (!shape)
      {
        make_mesh(parameters, triangulation);
        return;
      }
      Triangulation<2> coarse;
      parameters.geometry.chosen().create(coarse);
      GridTools::transform(shape, coarse);
      triangulation.copy_triangulation(coarse);
      triangulation.refine_global(parameters.mesh.global_refinements);
    }



    void
    Body::set_phase_field(const Scalar &phase_field)
    {
      LinearAlgebra::Vector values =
        fields.owned_vector(fields.phase_field_dofs);
      VectorTools::interpolate(fields.mapping,
                               fields.phase_field,
                               ScalarFunctionFromFunctionObject<2>(phase_field),
                               values);
      constraints.phase_field_hanging_nodes().distribute(values);
      state.lagged_phase_field = values;
      state.phase_field        = values;
    }



    NewtonOutcome
    Body::solve(const double time)
    {
      state.time                  = time;
      LinearAlgebra::Vector start = fields.owned_vector(fields.elastic_dofs);
      start                       = state.elastic;
      constraints.apply_prescribed(time, start);
      state.elastic = start;
      const NewtonOutcome outcome =
        elastic_step->solve(state, parameters.solver.newton);
      EXPECT_TRUE(outcome.converged) << outcome.reason;
      return outcome;
    }



    types::boundary_id
    Body::boundary_id(const std::string &boundary) const
    {
      return parameters.geometry.chosen().boundary_ids().at(boundary);
    }



    Tensor<1, 2>
    Body::reaction(const std::string &boundary) const
    {
      BoundaryQuantities<2> quantities(
        fields, constraints, boundary_id(boundary));
      quantities.reinit();
      return quantities.force(state.reaction);
    }



    Tensor<1, 2>
    Body::integrated_traction(const std::string &boundary) const
    {
      const FEValuesExtractors::Vector   displacement(0);
      FEFaceValues<2>                    face_values(fields.mapping,
                                  fields.elastic.get_fe(),
                                  QGauss<1>(4),
                                  update_values | update_gradients |
                                    update_JxW_values | update_normal_vectors);
      std::vector<SymmetricTensor<2, 2>> strains(4);
      std::vector<double>                pressures(4);
      Tensor<1, 2>                       sum;
      double                             sign = 1.;
      for (const auto &cell : fields.elastic.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int face : cell->face_indices())
          {
            if (!cell->face(face)->at_boundary() ||
                cell->face(face)->boundary_id() != boundary_id(boundary))
              continue;
            face_values.reinit(cell, face);
            face_values[displacement].get_function_symmetric_gradients(
              state.elastic, strains);
            if (fields.layout.mixed)
              face_values[fields.pressure].get_function_values(state.elastic,
                                                               pressures);
            for (unsigned int q = 0; q < 4; ++q)
            {
              const auto stress =
                fields.layout.mixed
                  ? material->mixed(strains[q], pressures[q], 1.).stress
                  : material->eliminated(strains[q], 1.).stress;
              const Tensor<1, 2> normal = face_values.normal_vector(q);
              sign                      = normal[0] + normal[1] < 0. ? -1. : 1.;
              sum += sign * (stress * normal) * face_values.JxW(q);
            }
          }
      return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    }



    Tensor<1, 2>
    Body::displacement_at(const Point<2> &vertex) const
    {
      // the largest on all ranks: those without the vertex know nothing
      const double nothing = std::numeric_limits<double>::lowest();
      double       found[] = {nothing, nothing};
      for (const auto &cell : fields.elastic.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
            if (cell->vertex(v).distance(vertex) < 1e-6 * cell->diameter())
              for (unsigned int d = 0; d < 2; ++d)
                found[d] = state.elastic(cell->vertex_dof_index(v, d));
      Tensor<1, 2> result;
      for (unsigned int d = 0; d < 2; ++d)
        result[d] = Utilities::MPI::max(found[d], MPI_COMM_WORLD);
      EXPECT_GT(result[0], nothing) << "no vertex at " << vertex;
      return result;
    }



    double
    Body::error(const Function<2> &exact,
                const unsigned int first,
                const unsigned int n) const
    {
      const ComponentSelectFunction<2> weight(
        {first, first + n}, fields.elastic.get_fe().n_components());
      dealii::Vector<float> cellwise(triangulation.n_active_cells());
      VectorTools::integrate_difference(fields.mapping,
                                        fields.elastic,
                                        state.elastic,
                                        exact,
                                        cellwise,
                                        QGauss<2>(5),
                                        VectorTools::L2_norm,
                                        &weight);
      return VectorTools::compute_global_error(
        triangulation, cellwise, VectorTools::L2_norm);
    }



    std::pair<double, double>
    Body::pressure_range() const
    {
      double smallest = std::numeric_limits<double>::max();
      double largest  = -smallest;
      for (const auto &cell : fields.elastic.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
          {
            const double p = state.elastic(cell->vertex_dof_index(v, 2));
            smallest       = std::min(smallest, p);
            largest        = std::max(largest, p);
          }
      return {Utilities::MPI::min(smallest, MPI_COMM_WORLD),
              Utilities::MPI::max(largest, MPI_COMM_WORLD)};
    }
  } // namespace Testing
} // namespace MixedCracks
