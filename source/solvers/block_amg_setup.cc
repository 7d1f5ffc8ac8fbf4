// SPDX-License-Identifier: GPL-2.0-or-later
// Hierarchy and weights of the block AMG solver. A~^-1 with two levels, from v
// = 0:
//
//   1. v = P M(P^T f)         P from linear to quadratic displacements,
//                             M one cycle of multigrid on P^T A P
//   2. v <- smooth(A, f; v)   Chebyshev polynomial of degree 2 on A, for the
//                             f - B^T p of the p found before
//
// P^T A P is assembled (AssembledAuxiliaries). The smoother takes what is
// between the vertices, modes that the coarse space lacks and whose eigenvalues
// are among the upper ones. Linear displacements need 1 only, with P = 1.

#include <base/memory.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/vector_memory.h>

#include <solvers/block_amg.h>
#include <solvers/matrix_block.h>

#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // owned rows beyond which memory counts more than the third of a set-up
    // that it takes to give it back and have it handed out anew
    constexpr std::size_t most_rows_without_return = 3000000;



    // A coarse level is small, and must not be what limits the iterations:
    // sharper than where multigrid works on all unknowns.
    MultigridOptions
    on_the_coarse_level(const unsigned int n_components)
    {
      MultigridOptions options = MultigridOptions::elastic(n_components);
      options.smoother_degree  = 4;
      options.smoothed_range   = 10.;
      options.weak_coupling    = 0.02;
      return options;
    }



    // (1/n) sum_i d_i or (1/n) sum_i 1/d_i over the chosen rows of all ranks
    double
    mean(const SaddlePointProduct::Vector &diagonal,
         const std::vector<bool>          &chosen,
         const bool                        inverse)
    {
      std::vector<double> sums(2, 0.);
      const double       *entries = diagonal.begin();
      for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i])
        {
          sums[0] += inverse ? 1. / entries[i] : entries[i];
          sums[1] += 1.;
        }
      Utilities::MPI::sum(sums, diagonal.get_mpi_communicator(), sums);
      return sums[0] / sums[1];
    }
  } // namespace



  void
  BlockAmgSolver::drop_hierarchy()
  {
    multigrid.reset();
    interpolation = nullptr;
    smoother.reset();
    exact_block.reset();
    mass_solver.reset();
    assembled.reset();
    if (!options.is_matrix_free)
      return;
    // the next hierarchy would be added to what this one leaves
    GrowingVectorMemory<Vector>::release_unused_memory();
    if (is_displacement.size() > most_rows_without_return)
      return_free_memory();
  }



  void
  BlockAmgSolver::set_up_pressure(const LinearAlgebra::SparseMatrix &mass)
  {
    mass_solver = std::make_unique<MassSolver>(extract_block(
      mass.trilinos_matrix(), system.is_pressure, system.is_pressure));
    Vector diagonal;
    diagonal.reinit(known, true);
    AssembledProduct(mass, {}).diagonal(diagonal);
    // broken cells have large entries: the mean of the inverses is that of
    // the intact ones
    pressure_scale =
      std::sqrt(matrix_diagonal * mean(diagonal, system.is_pressure, true));
  }



  void
  BlockAmgSolver::set_up_two_levels(const AuxiliaryMatrices &auxiliary)
  {
    std::vector<bool> chosen = is_displacement;
    for (std::size_t i = 0; i < chosen.size(); ++i)
      if (system.is_constrained[i])
        chosen[i] = false;
    smoother = std::make_unique<ChebyshevSmoother>(product(), chosen);
    if (auxiliary.block != nullptr)
    {
      exact_block = std::make_unique<ExactBlock>(product(),
                                                 *auxiliary.block,
                                                 *auxiliary.rows_of_block,
                                                 system.symmetry,
                                                 system.n_components);
      if (!exact_block->is_usable())
        exact_block.reset();
    }
    interpolation = auxiliary.interpolation;
    // it stays until the next set-up has dropped the hierarchy
    const std::shared_ptr<const Epetra_CrsMatrix> matrix(
      std::shared_ptr<void>(), &auxiliary.displacement->trilinos_matrix());
    multigrid = std::make_unique<Multigrid>(
      matrix,
      on_the_coarse_level(system.n_components),
      system.rigid_body_modes(*auxiliary.is_coarse));
  }



  void
  BlockAmgSolver::set_up()
  {
    drop_hierarchy();
    if (needs_matrix())
      assembled = std::make_unique<AssembledProduct>(
        *system.matrix,
        has_pressure ? system.is_pressure : std::vector<bool>());
    const AuxiliaryMatrices auxiliary = system.auxiliary();
    if (auxiliary.displacement == nullptr)
      multigrid = std::make_unique<Multigrid>(
        extract_block(
          system.matrix->trilinos_matrix(), is_displacement, is_displacement),
        MultigridOptions::elastic(system.n_components),
        system.rigid_body_modes(is_displacement));
    else
      set_up_two_levels(auxiliary);
    Vector diagonal;
    diagonal.reinit(known, true);
    product().diagonal(diagonal);
    matrix_diagonal = mean(diagonal, is_displacement, false);
    if (has_pressure)
      set_up_pressure(*auxiliary.pressure);
    is_old      = false;
    is_recorded = false;
    ++n_hierarchies;
  }
} // namespace MixedCracks
