// SPDX-License-Identifier: GPL-2.0-or-later
#include "body.h"

#include <base/text.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <output/boundary_quantities.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace MixedCracks
{
  namespace Testing
  {
    using namespace dealii;

    // 'Subsection/Entry = value' lines into the ParameterHandler
    template <int dim>
    BodyIn<dim>::ReadParameters::ReadParameters(const std::string &text)
    {
      ParameterHandler prm;
      this->add_parameters(prm);
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
      this->check();
    }



    namespace
    {
      template <int dim>
      typename BodyIn<dim>::MeshMaker
      moved(const typename BodyIn<dim>::Position &shape)
      {
        if (!shape)
          return {};
        return
          [shape](const Geometry<dim> &geometry, Triangulation<dim> &coarse) {
            geometry.create(coarse);
            GridTools::transform(shape, coarse);
          };
      }
    } // namespace



    template <int dim>
    BodyIn<dim>::BodyIn(const std::string &prm, const Position &shape)
      : BodyIn(prm, moved<dim>(shape))
    {}



    template <int dim>
    BodyIn<dim>::BodyIn(const std::string &prm, const MeshMaker &coarse_mesh)
      : parameters(prm)
      , triangulation(MPI_COMM_WORLD)
      , fields(triangulation,
               {parameters.model.mixed(), parameters.model.degree()})
      , constraints(
          fields,
          prescribed_components(parameters,
                                dim + (parameters.model.mixed() ? 1 : 0)))
      , timer(MPI_COMM_WORLD)
    {
      make_mesh_of(coarse_mesh);
      cell_size =
        GridTools::minimal_cell_diameter(triangulation) / std::sqrt(1. * dim);
      material = std::make_unique<Material<dim>>(describe_material(
        parameters.model, parameters.material, dim, cell_size));
      fields.distribute();
      constraints.take_points_from([this]() {
        return prescribed_points(
          parameters, fields.elastic.get_fe().n_components(), triangulation);
      });
      constraints.reinit();
      assembler = std::make_unique<Assembler<dim>>(
        fields,
        *material,
        constants_function(
          parameters.model,
          make_material_field(parameters.material, triangulation)));
      elastic_step = std::make_unique<ElasticStep<dim>>(
        fields,
        constraints,
        *assembler,
        make_loads(
          parameters, fields.elastic.get_fe().n_components(), triangulation),
        timer);
      const LinearOutcome analysis = elastic_step->reinit();
      EXPECT_TRUE(analysis.success) << analysis.reason;
      state.elastic            = fields.ghosted_vector(fields.elastic_dofs);
      state.reaction           = state.elastic;
      state.phase_field        = fields.ghosted_vector(fields.phase_field_dofs);
      state.lagged_phase_field = state.phase_field;
      set_phase_field([](const Point<dim> &) { return 1.; });
    }



    template <int dim>
    void
    BodyIn<dim>::make_mesh_of(const MeshMaker &coarse_mesh)
    {
      if (!coarse_mesh)
      {
        make_mesh(parameters, triangulation);
        return;
      }
      Triangulation<dim> coarse;
      coarse_mesh(parameters.geometry.chosen(), coarse);
      triangulation.copy_triangulation(coarse);
      triangulation.refine_global(parameters.mesh.global_refinements);
    }



    template <int dim>
    void
    BodyIn<dim>::set_phase_field(const Scalar &phase_field)
    {
      LinearAlgebra::Vector values =
        fields.owned_vector(fields.phase_field_dofs);
      VectorTools::interpolate(
        fields.mapping,
        fields.phase_field,
        ScalarFunctionFromFunctionObject<dim>(phase_field),
        values);
      constraints.phase_field_hanging_nodes().distribute(values);
      state.lagged_phase_field = values;
      state.phase_field        = values;
    }



    template <int dim>
    void
    BodyIn<dim>::start(const double time)
    {
      const State before = state;
      state.time         = time;
      if (material->is_finite())
      {
        const NewtonOutcome predicted =
          elastic_step->predict(before, state, parameters.solver.newton);
        EXPECT_TRUE(predicted.converged) << predicted.reason;
        return;
      }
      LinearAlgebra::Vector start = fields.owned_vector(fields.elastic_dofs);
      start                       = state.elastic;
      constraints.apply_prescribed(time, start);
      state.elastic = start;
    }



    template <int dim>
    NewtonOutcome
    BodyIn<dim>::solve(const double time)
    {
      start(time);
      const NewtonOutcome outcome =
        elastic_step->solve(state, parameters.solver.newton);
      EXPECT_TRUE(outcome.converged)
        << outcome.reason << ", residual " << outcome.last.largest();
      return outcome;
    }



    template <int dim>
    std::vector<double>
    BodyIn<dim>::newton_history(const double time, const double tolerance)
    {
      start(time);
      NewtonOptions options              = parameters.solver.newton;
      options.tolerance                  = tolerance;
      options.max_iterations             = 1;
      options.largest_deformation_change = 0.;
      std::vector<double> result;
      while (result.size() < 20 &&
             (result.empty() || result.back() > tolerance))
      {
        const NewtonOutcome outcome = elastic_step->solve(state, options);
        if (result.empty())
          result.push_back(outcome.first.largest());
        result.push_back(outcome.last.largest());
      }
      return result;
    }



    // on the rows of supports, which is where there are reactions
    template <int dim>
    double
    BodyIn<dim>::reaction_times_displacement() const
    {
      LinearAlgebra::Vector displacement =
        fields.owned_vector(fields.elastic_dofs);
      LinearAlgebra::Vector force(displacement);
      displacement = state.elastic;
      force        = state.reaction;
      return force * displacement;
    }



    template <int dim>
    BoundaryIds
    BodyIn<dim>::boundary_ids(const std::string &boundary) const
    {
      return parameters.geometry.chosen().boundary_ids().at(boundary);
    }



    template <int dim>
    Tensor<1, dim>
    BodyIn<dim>::reaction(const std::string &boundary) const
    {
      BoundaryQuantities<dim> quantities(
        fields, constraints, boundary_ids(boundary));
      quantities.reinit();
      return quantities.force(state.reaction);
    }



    template <int dim>
    Tensor<1, dim>
    BodyIn<dim>::integrated_traction(const std::string &boundary) const
    {
      const FEValuesExtractors::Vector displacement(0);
      FEFaceValues<dim>                face_values(fields.mapping,
                                    fields.elastic.get_fe(),
                                    QGauss<dim - 1>(4),
                                    update_values | update_gradients |
                                      update_JxW_values |
                                      update_normal_vectors);
      const unsigned int n_points = face_values.n_quadrature_points;
      std::vector<SymmetricTensor<2, dim>> strains(n_points);
      std::vector<double>                  pressures(n_points);
      Tensor<1, dim>                       sum;
      double                               sign = 1.;
      for (const auto &cell : fields.elastic.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int face : cell->face_indices())
          {
            if (!cell->face(face)->at_boundary() ||
                !boundary_ids(boundary).contains(
                  cell->face(face)->boundary_id()))
              continue;
            face_values.reinit(cell, face);
            face_values[displacement].get_function_symmetric_gradients(
              state.elastic, strains);
            if (fields.layout.mixed)
              face_values[fields.pressure].get_function_values(state.elastic,
                                                               pressures);
            for (unsigned int q = 0; q < n_points; ++q)
            {
              const auto stress =
                fields.layout.mixed
                  ? material->mixed(strains[q], pressures[q], 1.).stress
                  : material->eliminated(strains[q], 1.).stress;
              const Tensor<1, dim> normal = face_values.normal_vector(q);
              double               total  = 0.;
              for (unsigned int d = 0; d < dim; ++d)
                total += normal[d];
              sign = total < 0. ? -1. : 1.;
              sum += sign * (stress * normal) * face_values.JxW(q);
            }
          }
      return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    }



    template <int dim>
    Tensor<1, dim>
    BodyIn<dim>::displacement_at(const Point<dim> &vertex) const
    {
      // the largest on all ranks: those without the vertex know nothing
      const double        nothing = std::numeric_limits<double>::lowest();
      std::vector<double> found(dim, nothing);
      for (const auto &cell : fields.elastic.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
            if (cell->vertex(v).distance(vertex) < 1e-6 * cell->diameter())
              for (unsigned int d = 0; d < dim; ++d)
                found[d] = state.elastic(cell->vertex_dof_index(v, d));
      Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = Utilities::MPI::max(found[d], MPI_COMM_WORLD);
      EXPECT_GT(result[0], nothing) << "no vertex at " << vertex;
      return result;
    }



    template <int dim>
    double
    BodyIn<dim>::error(const Function<dim> &exact,
                       const unsigned int   first,
                       const unsigned int   n) const
    {
      const ComponentSelectFunction<dim> weight(
        {first, first + n}, fields.elastic.get_fe().n_components());
      dealii::Vector<float> cellwise(triangulation.n_active_cells());
      VectorTools::integrate_difference(fields.mapping,
                                        fields.elastic,
                                        state.elastic,
                                        exact,
                                        cellwise,
                                        QGauss<dim>(5),
                                        VectorTools::L2_norm,
                                        &weight);
      return VectorTools::compute_global_error(
        triangulation, cellwise, VectorTools::L2_norm);
    }



    template <int dim>
    std::pair<double, double>
    BodyIn<dim>::pressure_range() const
    {
      double smallest = std::numeric_limits<double>::max();
      double largest  = -smallest;
      for (const auto &cell : fields.elastic.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
          {
            const double p = state.elastic(cell->vertex_dof_index(v, dim));
            smallest       = std::min(smallest, p);
            largest        = std::max(largest, p);
          }
      return {Utilities::MPI::min(smallest, MPI_COMM_WORLD),
              Utilities::MPI::max(largest, MPI_COMM_WORLD)};
    }



    template class BodyIn<2>;
    template class BodyIn<3>;
  } // namespace Testing
} // namespace MixedCracks
