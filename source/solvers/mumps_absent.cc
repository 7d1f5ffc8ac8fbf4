// SPDX-License-Identifier: GPL-2.0-or-later
// For programs that are built without MUMPS: is_available() is false, so that
// no object is ever made, and callers need no preprocessor.

#include <deal.II/base/exceptions.h>

#include <solvers/mumps.h>

#ifndef MIXED_CRACKS_WITH_MUMPS

namespace MixedCracks
{
  struct Mumps::Implementation
  {};



  bool
  Mumps::is_available()
  {
    return false;
  }



  Mumps::Mumps(const LinearAlgebra::SparseMatrix &,
               const MatrixSymmetry,
               LinearOutcome &,
               const std::string &)
  {
    AssertThrow(false, dealii::ExcNotImplemented());
  }



  Mumps::~Mumps() = default;



  LinearOutcome
  Mumps::factorize()
  {
    return {};
  }



  LinearOutcome
  Mumps::solve(LinearAlgebra::Vector &, const LinearAlgebra::Vector &)
  {
    return {};
  }



  std::string
  Mumps::ordering() const
  {
    return "";
  }



  double
  Mumps::n_entries_of_factors() const
  {
    return 0.;
  }
} // namespace MixedCracks

#endif
