// SPDX-License-Identifier: GPL-2.0-or-later
// A Chebyshev polynomial as smoother: with B = D^-1 A, D the diagonal, and the
// eigenvalues of B to be smoothed between a and b,
//
//   e_k = T_k((theta - B)/delta) / T_k(theta/delta)  e_0,
//   theta = (b + a)/2,   delta = (b - a)/2,
//
// T_k the Chebyshev polynomials: the least possible max |p(lambda)| over [a, b]
// of all polynomials of that degree with p(0) = 1. By their three-term
// recurrence, with sigma = theta/delta, rho_0 = 1/sigma and the residual r =
// D^-1 (f - A x):
//
//   s_0 = r/theta,                          x += s_0
//   rho_(k+1) = 1/(2 sigma - rho_k)
//   s_(k+1) = rho_(k+1) rho_k s_k + (2 rho_(k+1)/delta) r,    x += s_(k+1)
//
// (Adams et al., J. Comput. Phys. 188 (2003)). Products with A only: no
// factorisation, the same on any number of ranks. b = 1.1 lambda_max by ten
// power iterations, a = lambda_max/6; degree 2 reduces all between to
// 1/T_2(theta/delta) = 0.37 of it at most, and the coarse level has the rest.

#include <Epetra_Vector.h>
#include <solvers/chebyshev.h>

#include <cmath>

namespace MixedCracks
{
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    constexpr unsigned int degree             = 2;
    constexpr unsigned int n_power_iterations = 10;
    // few iterations find an eigenvalue that is a little too small
    constexpr double safety_of_the_largest = 1.1;
    // of the largest eigenvalue to the least one that is smoothed; what is
    // below is left to the coarse level
    constexpr double smoothed_range = 6.;
  } // namespace



  ChebyshevSmoother::ChebyshevSmoother(
    const LinearAlgebra::SparseMatrix &matrix,
    const std::vector<bool>           &chosen)
    : matrix(matrix)
    , chosen(chosen)
    , inverse_diagonal(matrix.locally_owned_range_indices(),
                       matrix.get_mpi_communicator())
    , residual(inverse_diagonal)
    , step(inverse_diagonal)
    , image(inverse_diagonal)
  {
    reinit();
    largest = largest_eigenvalue();
  }



  void
  ChebyshevSmoother::reinit()
  {
    Epetra_Vector diagonal(matrix.trilinos_matrix().RowMap());
    matrix.trilinos_matrix().ExtractDiagonalCopy(diagonal);
    for (std::size_t i = 0; i < chosen.size(); ++i)
      inverse_diagonal.begin()[i] = chosen[i] ? 1. / diagonal[i] : 0.;
  }



  // v <- D^-1 A v/|v|: |v| tends to the largest eigenvalue. sin(1 + i) is a
  // start that is orthogonal to no eigenvector by symmetry.
  double
  ChebyshevSmoother::largest_eigenvalue() const
  {
    // power iteration, from a start without symmetry
    for (std::size_t i = 0; i < chosen.size(); ++i)
      step.begin()[i] = chosen[i] ? std::sin(1. + i) : 0.;
    double eigenvalue = 1.;
    for (unsigned int k = 0; k < n_power_iterations; ++k)
    {
      step /= step.l2_norm();
      matrix.vmult(residual, step);
      residual.scale(inverse_diagonal);
      eigenvalue = residual.l2_norm();
      step       = residual;
    }
    return eigenvalue;
  }



  void
  ChebyshevSmoother::smooth(Vector       &solution,
                            const Vector &right_hand_side) const
  {
    const double upper  = safety_of_the_largest * largest,
                 lower  = largest / smoothed_range;
    const double middle = 0.5 * (upper + lower), half = 0.5 * (upper - lower);
    const double ratio = middle / half;
    matrix.vmult(residual, solution);
    residual.sadd(-1., 1., right_hand_side);
    residual.scale(inverse_diagonal);
    step = residual;
    step *= 1. / middle;
    solution.add(1., step);
    double rho = 1. / ratio;
    for (unsigned int k = 1; k < degree; ++k)
    {
      // the residual is kept scaled by the diagonal
      matrix.vmult(image, step);
      image.scale(inverse_diagonal);
      residual.add(-1., image);
      const double next = 1. / (2. * ratio - rho);
      step.sadd(next * rho, 2. * next / half, residual);
      solution.add(1., step);
      rho = next;
    }
  }
} // namespace MixedCracks
