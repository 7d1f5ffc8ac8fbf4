// SPDX-License-Identifier: GPL-2.0-or-later
// Direct solvers of Trilinos behind one interface: SymbolicFactorization for
// the pattern, NumericFactorization for values, Solve. No use is made of
// symmetry.

#include <Amesos.h>
#include <Teuchos_ParameterList.hpp>
#include <solvers/amesos.h>

namespace MixedCracks
{
  namespace
  {
    // Amesos returns 0 or an error of its own; the return value is the same
    // on all ranks of the solvers used here
    LinearOutcome
    outcome_of(const int          error,
               const std::string &phase,
               const std::string &name)
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
  AmesosSolver::available_packages()
  {
    std::vector<std::string> result;
    Amesos                   factory;
    // distributed ones first; LAPACK is dense and not worth a name here
    for (const std::string package : {"Mumps", "Superludist", "Umfpack", "Klu"})
      if (factory.Query("Amesos_" + package))
        result.push_back(package);
    return result;
  }



  AmesosSolver::AmesosSolver(const std::string                 &package,
                             const LinearAlgebra::SparseMatrix &matrix,
                             LinearOutcome                     &outcome)
    : name("Amesos " + package)
  {
    problem.SetOperator(
      const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
    solver.reset(Amesos().Create("Amesos_" + package, problem));
    Teuchos::ParameterList parameters;
    // room for pivoting beyond the estimate of the analysis, in percent
    parameters.sublist("mumps").set("ICNTL(14)", 60);
    solver->SetParameters(parameters);
    outcome = outcome_of(solver->SymbolicFactorization(), "analysis", name);
  }



  LinearOutcome
  AmesosSolver::factorize()
  {
    return outcome_of(solver->NumericFactorization(), "factorisation", name);
  }



  LinearOutcome
  AmesosSolver::solve(LinearAlgebra::Vector       &solution,
                      const LinearAlgebra::Vector &right_hand_side)
  {
    problem.SetLHS(&solution.trilinos_vector());
    problem.SetRHS(
      const_cast<Epetra_MultiVector *>(&right_hand_side.trilinos_vector()));
    LinearOutcome result = outcome_of(solver->Solve(), "solution", name);
    result.iterations    = 1;
    return result;
  }
} // namespace MixedCracks
