// SPDX-License-Identifier: GPL-2.0-or-later
// Hierarchy and weights of the block AMG solver.
#include <deal.II/base/mpi.h>

#include <Epetra_Vector.h>
#include <solvers/block_amg.h>

#include <cmath>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // of the Jacobi sweep, over the largest eigenvalue: 2 would be unstable,
    // and few iterations find an eigenvalue that is a little too small
    constexpr double       jacobi_damping     = 1.4;
    constexpr unsigned int n_power_iterations = 10;



    // Mean of the entries of a diagonal, or of their inverses, in the chosen
    // rows.
    double
    mean_diagonal(const Epetra_CrsMatrix  &matrix,
                  const std::vector<bool> &chosen,
                  const bool               inverse,
                  const MPI_Comm           communicator)
    {
      Epetra_Vector diagonal(matrix.RowMap());
      matrix.ExtractDiagonalCopy(diagonal);
      std::vector<double> sums(2, 0.);
      for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i])
        {
          sums[0] += inverse ? 1. / diagonal[i] : diagonal[i];
          sums[1] += 1.;
        }
      Utilities::MPI::sum(sums, communicator, sums);
      return sums[0] / sums[1];
    }
  } // namespace



  double
  BlockAmgSolver::largest_eigenvalue(const Vector &inverse_diagonal)
  {
    // power iteration, from a start without symmetry
    Vector direction(inverse_diagonal), image(inverse_diagonal);
    for (std::size_t i = 0; i < is_displacement.size(); ++i)
      direction.begin()[i] =
        is_displacement[i] && !system.is_constrained[i] ? std::sin(1. + i) : 0.;
    double eigenvalue = 1.;
    for (unsigned int k = 0; k < n_power_iterations; ++k)
    {
      direction /= direction.l2_norm();
      system.matrix->vmult(image, direction);
      image.scale(inverse_diagonal);
      eigenvalue = image.l2_norm();
      direction  = image;
    }
    return eigenvalue;
  }



  void
  BlockAmgSolver::set_smoothing()
  {
    smoothing.reinit(row_scale, true);
    Epetra_Vector diagonal(system.matrix->trilinos_matrix().RowMap());
    system.matrix->trilinos_matrix().ExtractDiagonalCopy(diagonal);
    for (std::size_t i = 0; i < is_displacement.size(); ++i)
      smoothing.begin()[i] =
        is_displacement[i] && !system.is_constrained[i] ? 1. / diagonal[i] : 0.;
    if (smoothing_damping == 0.)
      smoothing_damping = jacobi_damping / largest_eigenvalue(smoothing);
    smoothing *= smoothing_damping;
  }



  void
  BlockAmgSolver::drop_hierarchy()
  {
    multigrid.reset();
    mass_solver.reset();
    coupling.reset();
  }



  void
  BlockAmgSolver::set_up_pressure(const LinearAlgebra::SparseMatrix &mass)
  {
    const Epetra_CrsMatrix &all = system.matrix->trilinos_matrix();
    coupling    = extract_block(all, is_displacement, system.is_pressure);
    mass_solver = std::make_unique<MassSolver>(extract_block(
      mass.trilinos_matrix(), system.is_pressure, system.is_pressure));
    // broken cells have large entries: the mean of the inverses is that of
    // the intact ones
    const double scale =
      std::sqrt(matrix_diagonal * mean_diagonal(mass.trilinos_matrix(),
                                                system.is_pressure,
                                                true,
                                                mass.get_mpi_communicator()));
    for (std::size_t i = 0; i < system.is_pressure.size(); ++i)
      if (system.is_pressure[i])
        row_scale.begin()[i] = scale;
  }



  void
  BlockAmgSolver::set_up()
  {
    drop_hierarchy();
    const AuxiliaryMatrices auxiliary = system.auxiliary();
    const Epetra_CrsMatrix &elastic =
      (auxiliary.displacement != nullptr ? auxiliary.displacement
                                         : system.matrix)
        ->trilinos_matrix();
    multigrid = std::make_unique<Multigrid>(
      extract_block(elastic, is_displacement, is_displacement),
      MultigridOptions::elastic(system.n_components),
      system.rigid_body_modes());
    if (auxiliary.displacement != nullptr)
    {
      smoothing_damping = 0.;
      set_smoothing();
    }
    matrix_diagonal = mean_diagonal(system.matrix->trilinos_matrix(),
                                    is_displacement,
                                    false,
                                    system.matrix->get_mpi_communicator());
    row_scale       = 1.;
    if (has_pressure)
      set_up_pressure(*auxiliary.pressure);
    is_old               = false;
    iterations_per_digit = 0.;
    ++n_hierarchies;
  }
} // namespace MixedCracks
