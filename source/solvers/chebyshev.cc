// SPDX-License-Identifier: GPL-2.0-or-later
// A Chebyshev polynomial as smoother: with B = D^-1 A, D the diagonal, and the
// eigenvalues of B to be smoothed between a and b,
//
//   e_k = T_k((theta - B)/delta) / T_k(theta/delta)  e_0,
//   theta = (b + a)/2,   delta = (b - a)/2,
//
// T_k the Chebyshev polynomials: the least possible max |p(lambda)| over [a, b]
// of all polynomials of that degree with p(0) = 1 (Adams et al., J. Comput.
// Phys. 188 (2003)); dealii::PreconditionChebyshev has the recurrence. Products
// with A only: no factorisation, the same on any number of ranks. b = 1.1
// lambda_max by ten power iterations, a = lambda_max/6; degree 2 reduces all
// between to 1/T_2(theta/delta) = 0.37 of it at most, and the coarse level has
// the rest. The searches of deal.II's class are not used: by Lanczos' method it
// starts from D^-1 of a vector, which is nearly all in broken cells where their
// stiffness is 1e-10 of that beside them, and misses the eigenvectors at their
// rim; with b below lambda_max GMRES may not end (doc/records/solvers.md).

#include <solvers/chebyshev.h>

#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

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



  ChebyshevSmoother::ChebyshevSmoother(const SaddlePointProduct &matrix,
                                       const std::vector<bool>  &chosen)
    : chosen(chosen)
    , scaling(std::make_shared<Scaling>())
  {
    product.product = &matrix;
    matrix.reinit(scaling->get_vector());
    product.n_rows = scaling->m();
    reinit();
    Polynomial::AdditionalData options(
      degree, safety_of_the_largest * smoothed_range, 0);
    options.max_eigenvalue = safety_of_the_largest * largest_eigenvalue();
    options.preconditioner = scaling;
    polynomial.initialize(product, options);
  }



  void
  ChebyshevSmoother::reinit()
  {
    Vector &factors = scaling->get_vector();
    product.product->diagonal(factors);
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
      double &entry = factors.local_element(i);
      entry         = chosen[i] ? 1. / entry : 0.;
    }
  }



  // v <- D^-1 A v/|v|: |v| tends to the largest eigenvalue. sin(1 + i) is a
  // start that is orthogonal to no eigenvector by symmetry.
  double
  ChebyshevSmoother::largest_eigenvalue() const
  {
    Vector vector(scaling->get_vector()), image(vector);
    for (std::size_t i = 0; i < chosen.size(); ++i)
      vector.local_element(i) = chosen[i] ? std::sin(1. + i) : 0.;
    double eigenvalue = 1.;
    for (unsigned int k = 0; k < n_power_iterations; ++k)
    {
      vector /= vector.l2_norm();
      product.vmult(image, vector);
      scaling->vmult(vector, image);
      eigenvalue = vector.l2_norm();
    }
    return eigenvalue;
  }



  void
  ChebyshevSmoother::smooth(Vector       &solution,
                            const Vector &right_hand_side) const
  {
    polynomial.step(solution, right_hand_side);
  }
} // namespace MixedCracks
