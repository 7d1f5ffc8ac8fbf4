// SPDX-License-Identifier: GPL-2.0-or-later
// The Chebyshev smoother against the eigenvector of the largest eigenvalue,
// found by many power iterations: it grows where the bound of the spectrum is
// too low.
#include "elastic_system.h"

#include <base/log.h>

#include <solvers/chebyshev.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  using Vector = SaddlePointProduct::Vector;

  // v with D^-1 A v = lambda_max v among the chosen, |v| = 1
  Vector
  roughest_vector(const SaddlePointProduct &product,
                  const std::vector<bool>  &chosen)
  {
    Vector diagonal, vector, image;
    for (Vector *each : {&diagonal, &vector, &image})
      product.reinit(*each);
    product.diagonal(diagonal);
    for (std::size_t i = 0; i < chosen.size(); ++i)
      vector.local_element(i) = chosen[i] ? std::cos(1. + i * i) : 0.;
    for (unsigned int k = 0; k < 2000; ++k)
    {
      vector /= vector.l2_norm();
      product.vmult(image, vector);
      for (std::size_t i = 0; i < chosen.size(); ++i)
        vector.local_element(i) =
          chosen[i] ? image.local_element(i) / diagonal.local_element(i) : 0.;
    }
    vector /= vector.l2_norm();
    return vector;
  }



  // What is left of it after one application.
  template <int dim>
  double
  reduction(const unsigned int refinements, const double kappa)
  {
    ElasticSystemOptions options;
    options.refinements = refinements;
    options.kappa       = kappa;
    options.matrix_free = true;
    ElasticSystem<dim> system(options);
    const LinearSystem described = system.system();
    std::vector<bool>  chosen    = described.is_pressure;
    for (std::size_t i = 0; i < chosen.size(); ++i)
      chosen[i] = !chosen[i] && !described.is_constrained[i];
    const ChebyshevSmoother smoother(system.matrix_free, chosen);
    Vector vector = roughest_vector(system.matrix_free, chosen);
    Vector zero(vector);
    zero = 0.;
    smoother.smooth(vector, zero);
    return vector.l2_norm();
  }

  // With 0.88 of the largest eigenvalue, what ten power iterations find at
  // least here, half of it is left; with 0.79 it would grow.
  constexpr double bound = 0.6;
} // namespace



TEST(Chebyshev, ReducesWhatHasTheLargestEigenvalueHoweverBroken)
{
  for (const double kappa : {1e-2, 1e-6, 1e-10})
  {
    SCOPED_TRACE(format("kappa = %g", kappa));
    EXPECT_LT(reduction<2>(4, kappa), bound);
    EXPECT_LT(reduction<3>(2, kappa), bound);
  }
}



// As many free unknowns as one cell has, and ranks without any.
TEST(Chebyshev, WorksOnOneCell)
{
  EXPECT_LT(reduction<2>(0, 1e-2), bound);
  EXPECT_LT(reduction<3>(0, 1e-2), bound);
}
