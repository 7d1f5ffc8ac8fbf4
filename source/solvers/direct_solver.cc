// SPDX-License-Identifier: GPL-2.0-or-later
// A = L D L^T (symmetric, indefinite: the pressure has -C) or L U, once per
// values of the matrix, and the two triangular solves as often as wanted.
// Analysis of the pattern, which needs no values, once per mesh.

#include <base/errors.h>

#include <deal.II/base/exceptions.h>

#include <solvers/amesos.h>
#include <solvers/direct_solver.h>
#include <solvers/mumps.h>
#include <solvers/nested_dissection.h>

namespace MixedCracks
{
  namespace
  {
    const std::string mumps_name    = "MUMPS";
    const std::string amesos_prefix = "Amesos ";
    const std::string automatic     = "automatic";



    // By measurement (doc/records/solvers.md). In 2-d the analysis with AMD is
    // fast, and factors are as small as any; in 3-d factors are what counts.
    std::string
    best_ordering(const unsigned int n_components)
    {
      if (n_components == 2)
        return "AMD";
      return nested_dissection_is_available() ? "METIS" : automatic;
    }
  } // namespace



  std::vector<std::string>
  DirectSolver::available_packages()
  {
    std::vector<std::string> result;
    if (Mumps::is_available())
      result.push_back(mumps_name);
    for (const std::string &package : AmesosSolver::available_packages())
      result.push_back(amesos_prefix + package);
    return result;
  }



  DirectSolver::DirectSolver(const std::string &package,
                             const std::string &ordering)
    : name(package)
    , ordering(ordering)
  {
    const std::vector<std::string> packages = available_packages();
    if (packages.empty())
      throw InputError(
        "Linear solver/Name: 'direct' needs MUMPS, or a Trilinos with one of "
        "the Amesos packages MUMPS, SuperLU_DIST, UMFPACK or KLU; this program "
        "has none.");
    if (name.empty())
      name = packages.front();
  }



  LinearOutcome
  DirectSolver::initialize(const LinearAlgebra::SparseMatrix &matrix,
                           const MatrixSymmetry               symmetry)
  {
    // the old one first: two at a time would need twice the memory
    solver.reset();
    LinearOutcome outcome;
    if (name == mumps_name)
      solver = std::make_unique<Mumps>(matrix, symmetry, outcome, ordering);
    else
      solver = std::make_unique<AmesosSolver>(
        name.substr(amesos_prefix.size()), matrix, outcome);
    return outcome;
  }



  LinearOutcome
  DirectSolver::initialize(const LinearSystem &system)
  {
    if (ordering == automatic)
      ordering = best_ordering(system.n_components);
    return initialize(*system.matrix, system.symmetry);
  }



  LinearOutcome
  DirectSolver::factorize()
  {
    Assert(solver, dealii::ExcNotInitialized());
    ++n_factorizations;
    return solver->factorize();
  }



  LinearOutcome
  DirectSolver::solve(LinearAlgebra::Vector       &solution,
                      const LinearAlgebra::Vector &right_hand_side)
  {
    Assert(solver, dealii::ExcNotInitialized());
    return solver->solve(solution, right_hand_side);
  }



  // The third argument, the tolerance an iterative solver would be asked for,
  // has no meaning: the solution is exact but for rounding.
  LinearOutcome
  DirectSolver::solve(LinearAlgebra::Vector       &solution,
                      const LinearAlgebra::Vector &right_hand_side,
                      const double)
  {
    return solve(solution, right_hand_side);
  }



  std::string
  DirectSolver::description() const
  {
    const std::string found = solver ? solver->ordering() : "";
    if (found.empty())
      return name;
    return name + " (ordering by " + found +
           (ordering == automatic || found == ordering
              ? ")"
              : "; this one has no " + ordering + ")");
  }
} // namespace MixedCracks
