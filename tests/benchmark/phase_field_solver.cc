// SPDX-License-Identifier: GPL-2.0-or-later
//
//   phase_field_solver [--dim 2|3] [--density AT2|AT1|Wu] [--levels 5]
//                      [--smallest 16]
//
// Iterations and seconds of the phase field's active set, with the diagonal
// and with multigrid, on meshes of the cell size h: a square or cube of 1 mm,
// broken half way with the profile of l = 0.1 mm, is pulled apart in three
// steps about the load at which its crack grows. doc/solvers.md has the tables.
// Uniform meshes, from 1/smallest mm in so many halvings.
#include "measurement.h"

#include <base/log.h>

#include <solvers/active_set.h>

namespace
{
  using namespace MixedCracks;
  using namespace MixedCracks::Testing;
  using Vector = LinearAlgebra::Vector;

  struct Arguments
  {
    int          dim      = 2;
    std::string  density  = "AT2";
    unsigned int levels   = 5;
    unsigned int coarsest = 4; // refinements
  };

  Arguments
  read(const int argc, char **argv)
  {
    Arguments result;
    for (int i = 1; i + 1 < argc; i += 2)
    {
      const std::string option = argv[i], value = argv[i + 1];
      if (option == "--dim")
        result.dim = std::stoi(value);
      else if (option == "--density")
        result.density = value;
      else if (option == "--levels")
        result.levels = std::stoi(value);
      else if (option == "--smallest")
        result.coarsest = std::lround(std::log2(std::stod(value)));
      else
        throw InputError("unknown option " + option);
    }
    return result;
  }



  // The system of the phase field on one mesh, at a load.
  template <int dim>
  class Problem
  {
  public:
    explicit Problem(const ElasticSystemOptions &options)
      : system(options)
      , hanging(system.constraints.phase_field_hanging_nodes())
      , elastic(system.lifted())
    {
      const DofSets &dofs = system.fields.phase_field_dofs;
      make_sparse_matrix(system.fields.phase_field, dofs, hanging, matrix);
      mass  = system.fields.owned_vector(dofs);
      lower = residual = mass;
      system.assembler->lumped_mass(hanging, mass);
      for (const auto dof : dofs.owned)
        constrained.push_back(hanging.is_constrained(dof));
      interpolate_profile();
      solve_elastic();
    }

    // three loads, one after the other
    Measurement
    measure(const double patience)
    {
      const MaterialDescription &material = system.material.description();
      const double density = material.constants->critical_energy_release_rate /
                             material.length_scale;
      ActiveSetOptions options;
      options.tolerance = 1e-8 * density;
      options.patience  = patience;
      ActiveSetSolver      solver(options);
      const BoundedProblem problem{
        matrix,
        lower,
        upper,
        mass,
        constrained,
        -density *
          std::min(
            0., system.material.crack_density().local_second_derivative(0.5))};
      Measurement result;
      Vector      solution(upper);
      for (const double load : {0.8, 0.9, 1.})
      {
        assemble(load, solution);
        result.solve += seconds_of([&]() {
          const ActiveSetOutcome outcome =
            solver.solve(problem, solution, residual);
          result.iterations += outcome.linear_iterations;
          n_sets += outcome.iterations;
          if (!outcome.converged)
            print("failed: " + outcome.reason);
        });
      }
      Vector change(upper);
      change -= solution;
      largest_change = change.linfty_norm();
      return result;
    }

    ElasticSystem<dim> system;
    unsigned int       n_sets         = 0;
    double             largest_change = 0.;

  private:
    void
    interpolate_profile()
    {
      upper                               = mass;
      const MaterialDescription &material = system.material.description();
      dealii::VectorTools::interpolate(
        system.fields.mapping,
        system.fields.phase_field,
        dealii::ScalarFunctionFromFunctionObject<dim>(
          [&](const dealii::Point<dim> &p) {
            return system.material.crack_density().optimal_profile(
              system.distance(p) / material.length_scale);
          }),
        upper);
      hanging.distribute(upper);
    }

    Vector
    with_ghosts(const Vector &owned) const
    {
      Vector result =
        system.fields.ghosted_vector(system.fields.phase_field_dofs);
      result = owned;
      return result;
    }

    // of the profile, for the top moved up by 1 mm
    void
    solve_elastic()
    {
      const auto &elastic_hanging = system.constraints.elastic_hanging_nodes();
      Vector forces = system.fields.owned_vector(system.fields.elastic_dofs);
      const auto assemble = [&]() {
        forces = 0.;
        system.assembler->elastic_residual(
          elastic, with_ghosts(upper), elastic_hanging, forces);
      };
      for (unsigned int newton = 0; newton < 4; ++newton)
      {
        assemble();
        system.assembler->elastic_matrix(
          system.constraints.elastic_corrections(), system.matrix);
        system.constraints.drop_prescribed(forces);
        forces *= -1.;
        const auto solver =
          all_linear_solvers().make(dim == 2 ? "direct" : "block AMG", {});
        Vector correction(forces);
        if (!solver->initialize(system.system()).success ||
            !solver->factorize().success ||
            !solver->solve(correction, forces, 1e-10).success)
          throw InputError("no displacements");
        system.constraints.elastic_corrections().distribute(correction);
        Vector sum = system.fields.owned_vector(system.fields.elastic_dofs);
        sum        = elastic;
        sum += correction;
        elastic = sum;
      }
    }

    void
    assemble(const double load, const Vector &phase_field)
    {
      Vector scaled(elastic);
      scaled *= load;
      Vector forces = system.fields.owned_vector(system.fields.elastic_dofs);
      system.assembler->elastic_residual(
        scaled,
        with_ghosts(upper),
        system.constraints.elastic_hanging_nodes(),
        forces);
      residual = 0.;
      matrix   = 0.;
      system.assembler->phase_field_system(with_ghosts(phase_field),
                                           system.assembler->driving_force(),
                                           hanging,
                                           residual,
                                           &matrix);
    }

    const dealii::AffineConstraints<double> &hanging;
    Vector                                   elastic; // with ghosts
    LinearAlgebra::SparseMatrix              matrix;
    Vector                                   lower, upper, mass, residual;
    std::vector<bool>                        constrained;
  };



  template <int dim>
  void
  run(const Arguments &arguments)
  {
    print("| dim | ranks | density | l/h | nodes | max change | sets | "
          "iterations, diagonal | s | sets | multigrid | s |\n"
          "|---|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
    ElasticSystemOptions options;
    options.mixed   = false;
    options.degree  = 1;
    options.lambda  = 1.;
    options.density = arguments.density;
    for (unsigned int level = 0; level <= arguments.levels; ++level)
    {
      options.refinements = arguments.coarsest + level;
      Problem<dim>       plain(options), quick(options);
      const Measurement  diagonal  = plain.measure(1e9);
      const Measurement  multigrid = quick.measure(0.);
      const unsigned int n_nodes   = plain.system.fields.phase_field.n_dofs();
      print(format(
        "| %d | %u | %s | %.1f | %u | %.3f | %u | %u | %.3f | %u | %u | %.3f |",
        dim,
        dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
        arguments.density.c_str(),
        0.1 * std::pow(2., options.refinements),
        n_nodes,
        plain.largest_change,
        plain.n_sets,
        diagonal.iterations,
        diagonal.solve,
        quick.n_sets,
        multigrid.iterations,
        multigrid.solve));
    }
  }
} // namespace



int
main(int argc, char **argv)
{
  return run_benchmark(argc, argv, [&]() {
    const Arguments arguments = read(argc, argv);
    if (arguments.dim == 2)
      run<2>(arguments);
    else
      run<3>(arguments);
  });
}
