// SPDX-License-Identifier: GPL-2.0-or-later
// A unit square or cube pulled apart, intact or broken along a plane, with
// the matrix of its displacements and pressures: what linear solvers are
// tested on and measured with.
#ifndef mixed_cracks_tests_unit_elastic_system_h
#define mixed_cracks_tests_unit_elastic_system_h

#include <assembly/auxiliary_matrices.h>
#include <assembly/matrix_free_elastic.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <discretization/constraints.h>
#include <discretization/rigid_body_modes.h>
#include <discretization/sparse_matrix.h>

#include <solvers/linear_solver.h>

namespace MixedCracks
{
  namespace Testing
  {
    /// How far the plane y = 1/2 (2-d) or z = 1/2 (3-d) is broken.
    enum class Damage
    {
      none,
      half,   ///< where x < 1/2
      through ///< everywhere
    };

    struct ElasticSystemOptions
    {
      bool         mixed           = true;
      unsigned int degree          = 2;
      unsigned int refinements     = 3; ///< of one cell
      unsigned int adaptive_levels = 0; ///< at the plane
      double       lambda          = 100.;
      double       mu              = 1.;
      double       kappa           = 1e-6;
      Damage       damage          = Damage::half;
      std::string  density         = "AT2";
      std::string  split           = "volumetric-deviatoric";
      std::string  law             = "relaxed bulk";
      Strains      strains         = Strains::small;
      bool         with_matrix     = true;
      bool         matrix_free     = false; ///< as a product
      double       stretch         = 1.;    ///< of the state, an even strain
      /// of the pressure, hence the regime of the split
      std::function<double(double x)> pressure = [](double) { return 1.; };
    };

    template <int dim>
    class ElasticSystem
    {
    public:
      using Vector = LinearAlgebra::Vector;

      explicit ElasticSystem(const ElasticSystemOptions &options)
        : options(options)
        , triangulation(MPI_COMM_WORLD)
        , fields(triangulation, {options.mixed, options.degree})
        , constraints(fields, clamps())
        , material(
            MaterialDescription{PointConstants{options.lambda, options.mu, 1.},
                                0.1,
                                options.kappa,
                                1.,
                                dim,
                                options.density,
                                options.split,
                                options.law,
                                "quadratic",
                                options.strains})
        , auxiliaries(fields, constraints)
        , matrix_free(fields, constraints)
      {
        make_mesh();
        fields.distribute();
        constraints.reinit();
        assembler = std::make_unique<Assembler<dim>>(fields, material);
        assembler->reinit();
        make_operator();
        assemble();
      }

      /// Pattern of the matrix, or what products need to know of the mesh.
      void
      make_operator()
      {
        if (options.with_matrix)
          make_sparse_matrix(fields.elastic,
                             fields.elastic_dofs,
                             constraints.elastic_corrections(),
                             matrix);
        if (options.matrix_free)
          matrix_free.reinit();
      }

      /// For the state of the last residual.
      void
      update_operator()
      {
        if (options.with_matrix)
          assembler->elastic_matrix(constraints.elastic_corrections(), matrix);
        if (options.matrix_free)
          matrix_free.update(*assembler);
      }

      /// The matrix where everything is stretched or compressed, for a phase
      /// field that is
      /// @p broken_value in the broken part. The right hand side is what the
      /// top alone moved up leaves.
      void
      assemble(const double broken_value = 0.)
      {
        assemble(states(broken_value));
      }

      struct States
      {
        Vector top_moved, of_matrix, phase_field;
      };

      States
      states(const double broken_value = 0.) const
      {
        return {lifted(), stretched(), phase_field(broken_value)};
      }

      void
      assemble(const States &states)
      {
        const Vector &phi     = states.phase_field;
        const auto   &hanging = constraints.elastic_hanging_nodes();
        right_hand_side       = fields.owned_vector(fields.elastic_dofs);
        assembler->elastic_residual(
          states.top_moved, phi, hanging, right_hand_side);
        // of the state that the tangents are asked for last
        Vector residual(right_hand_side);
        assembler->elastic_residual(states.of_matrix, phi, hanging, residual);
        update_operator();
        constraints.drop_prescribed(right_hand_side);
        right_hand_side *= -1.;
      }

      LinearSystem
      system()
      {
        LinearSystem result;
        result.matrix       = &matrix;
        result.product      = &matrix_free;
        result.symmetry     = assembler->elastic_matrix_is_symmetric()
                                ? MatrixSymmetry::symmetric
                                : MatrixSymmetry::none;
        result.n_components = dim;
        const auto &owned   = fields.elastic_dofs.owned;
        result.is_pressure.assign(owned.n_elements(), false);
        if (options.mixed)
          for (const auto dof : dealii::DoFTools::extract_dofs(
                 fields.elastic,
                 fields.elastic.get_fe().component_mask(fields.pressure)))
            result.is_pressure[owned.index_within_set(dof)] = true;
        for (const auto dof : owned)
          result.is_constrained.push_back(
            constraints.elastic_corrections().is_constrained(dof));
        result.rigid_body_modes = [this](const std::vector<bool> &chosen) {
          return rigid_body_modes(fields, chosen);
        };
        result.auxiliary = [this]() {
          assemble_auxiliaries();
          AuxiliaryMatrices result;
          if (auxiliaries.has_displacement())
          {
            result.displacement  = &auxiliaries.displacement();
            result.interpolation = &auxiliaries.coarse().interpolation();
            result.is_coarse     = &auxiliaries.coarse().at_vertices();
          }
          if (options.mixed)
            result.pressure = &auxiliaries.pressure();
          if (auxiliaries.fluid_like().has_block())
          {
            result.block         = &auxiliaries.fluid_like().block();
            result.rows_of_block = &auxiliaries.fluid_like().rows();
          }
          return result;
        };
        return result;
      }

      /// For the state of the last assemble(). Their patterns are made when
      /// they are first asked for: they belong to the solvers that ask.
      void
      assemble_auxiliaries()
      {
        make_auxiliaries();
        auxiliaries.assemble(*assembler,
                             options.matrix_free ? &matrix_free : nullptr);
      }

      void
      make_auxiliaries()
      {
        if (!auxiliaries_are_there)
          auxiliaries.reinit();
        auxiliaries_are_there = true;
      }

      /// Distance to the broken part of the plane, mm.
      double
      distance(const dealii::Point<dim> &p) const
      {
        const double height = std::abs(p[dim - 1] - 0.5);
        const double beyond =
          options.damage == Damage::half ? std::max(0., p[0] - 0.5) : 0.;
        return std::sqrt(height * height + beyond * beyond);
      }

      /// The top moved up by 1 mm, with ghosts.
      Vector
      lifted() const
      {
        Vector owned = fields.owned_vector(fields.elastic_dofs);
        constraints.apply_prescribed(1., owned);
        Vector result = fields.ghosted_vector(fields.elastic_dofs);
        result        = owned;
        return result;
      }

      ElasticSystemOptions                              options;
      dealii::parallel::distributed::Triangulation<dim> triangulation;
      Fields<dim>                                       fields;
      Constraints<dim>                                  constraints;
      const Material<dim>                               material;
      std::unique_ptr<Assembler<dim>>                   assembler;
      AssembledAuxiliaries<dim>                         auxiliaries;
      MatrixFreeElastic<dim>                            matrix_free;
      LinearAlgebra::SparseMatrix                       matrix;
      Vector                                            right_hand_side;

    private:
      // bottom and top
      std::vector<PrescribedComponent<dim>>
      clamps() const
      {
        std::vector<PrescribedComponent<dim>> result;
        const unsigned int n_components = dim + (options.mixed ? 1 : 0);
        for (const unsigned int boundary : {2 * dim - 2, 2 * dim - 1})
          for (unsigned int d = 0; d < dim; ++d)
          {
            const bool moves = boundary == 2 * dim - 1 && d == dim - 1;
            result.push_back(
              {boundary,
               d,
               std::make_shared<dealii::Functions::ConstantFunction<dim>>(
                 moves ? 1. : 0., n_components)});
          }
        return result;
      }

      void
      make_mesh()
      {
        dealii::GridGenerator::hyper_cube(triangulation, 0., 1., true);
        triangulation.refine_global(options.refinements);
        for (unsigned int level = 0; level < options.adaptive_levels; ++level)
        {
          for (const auto &cell : triangulation.active_cell_iterators())
            if (cell->is_locally_owned() &&
                distance(cell->center()) < 1.1 * cell->diameter())
              cell->set_refine_flag();
          triangulation.execute_coarsening_and_refinement();
        }
        cell_size =
          std::pow(0.5, options.refinements + options.adaptive_levels);
      }

      // evenly, with the chosen pressure
      Vector
      stretched() const
      {
        std::vector<std::function<double(const dealii::Point<dim> &)>> values(
          dim, [](const dealii::Point<dim> &) { return 0.; });
        values[dim - 1] = [this](const dealii::Point<dim> &p) {
          return options.stretch * p[dim - 1];
        };
        if (options.mixed)
          values.push_back([this](const dealii::Point<dim> &p) {
            return options.pressure(p[0]);
          });
        Vector owned = fields.owned_vector(fields.elastic_dofs);
        dealii::VectorTools::interpolate(
          fields.mapping,
          fields.elastic,
          dealii::FunctionFromFunctionObjects<dim>(values),
          owned);
        constraints.elastic_hanging_nodes().distribute(owned);
        Vector result = fields.ghosted_vector(fields.elastic_dofs);
        result        = owned;
        return result;
      }

      // two rows of cells at @p broken_value, then the profile of AT2 with a
      // length of two cells
      Vector
      phase_field(const double broken_value) const
      {
        Vector owned = fields.owned_vector(fields.phase_field_dofs);
        owned        = 1.;
        if (options.damage != Damage::none)
          dealii::VectorTools::interpolate(
            fields.mapping,
            fields.phase_field,
            dealii::ScalarFunctionFromFunctionObject<dim>(
              [&](const dealii::Point<dim> &p) {
                const double d = distance(p) / cell_size;
                return d < 1.01
                         ? broken_value
                         : 1. - (1. - broken_value) * std::exp(-(d - 1.) / 2.);
              }),
            owned);
        constraints.phase_field_hanging_nodes().distribute(owned);
        Vector result = fields.ghosted_vector(fields.phase_field_dofs);
        result        = owned;
        return result;
      }

      double cell_size             = 0.; // of the finest cells
      bool   auxiliaries_are_there = false;
    };
  } // namespace Testing
} // namespace MixedCracks

#endif
