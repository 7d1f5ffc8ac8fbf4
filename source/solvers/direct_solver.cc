// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/errors.h>

#include <solvers/direct_solver.h>

#include <Amesos.h>
#include <Teuchos_ParameterList.hpp>

namespace MixedCracks
{
  namespace
  {
    // Amesos returns 0 or an error of its own; the return value is the same
    // on all ranks of the solvers used here
    LinearOutcome
    outcome(const int error, const std::string &phase, const std::string &name)
    {
      if (error == 0)
        return {};
      return {false,
              0,
              phase + " by " + name + " failed with error " +
                std::to_string(error)};
    }
  } // namespace



  std::vector<std::string>
  DirectSolver::available_packages()
  {
    std::vector<std::string> result;
    Amesos                   factory;
    // distributed ones first; LAPACK is dense and not worth a name here
    for (const std::string package : {"Mumps", "Superludist", "Umfpack", "Klu"})
      if (factory.Query("Amesos_" + package))
        result.push_back(package);
    return result;
  }



  DirectSolver::DirectSolver()
  {
    const std::vector<std::string> packages = available_packages();
    if (packages.empty())
      throw InputError(
        "Linear solver/Name: 'direct' needs a Trilinos with one of the Amesos "
        "packages MUMPS, SuperLU_DIST, UMFPACK or KLU; this one has none.");
    name = packages.front();
  }



  LinearOutcome
  DirectSolver::initialize(const LinearAlgebra::SparseMatrix &matrix)
  {
    solver.reset();
    problem = std::make_unique<Epetra_LinearProblem>();
    problem->SetOperator(
      const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
    Amesos factory;
    solver.reset(factory.Create("Amesos_" + name, *problem));
    Teuchos::ParameterList parameters;
    // room for pivoting beyond the estimate of the analysis, in percent
    parameters.sublist("mumps").set("ICNTL(14)", 60);
    // METIS: the least work for these meshes (doc/performance.md)
    parameters.sublist("mumps").set("ICNTL(7)", 5);
    solver->SetParameters(parameters);
    return outcome(solver->SymbolicFactorization(), "analysis", name);
  }



  LinearOutcome
  DirectSolver::factorize()
  {
    return outcome(solver->NumericFactorization(), "factorisation", name);
  }



  LinearOutcome
  DirectSolver::solve(LinearAlgebra::Vector       &solution,
                      const LinearAlgebra::Vector &right_hand_side) const
  {
    problem->SetLHS(&solution.trilinos_vector());
    problem->SetRHS(
      const_cast<Epetra_MultiVector *>(&right_hand_side.trilinos_vector()));
    LinearOutcome result = outcome(solver->Solve(), "solution", name);
    result.iterations    = 1;
    return result;
  }
} // namespace MixedCracks
