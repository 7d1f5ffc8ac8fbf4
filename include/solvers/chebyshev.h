// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_chebyshev_h
#define mixed_cracks_solvers_chebyshev_h

#include <base/compat.h>
#include <base/saddle_point_product.h>

#include <deal.II/lac/precondition.h>

#include <memory>
#include <vector>

namespace MixedCracks
{
  /// Smoother for some of the unknowns of a matrix: a Chebyshev polynomial of
  /// degree 2 in the matrix scaled by its diagonal, least on the upper part
  /// of the spectrum, see e.g. Adams et al., J. Comput. Phys. 188 (2003). The
  /// block of these unknowns must be nearly symmetric.
  class ChebyshevSmoother
  {
  public:
    /// @p chosen: one entry per owned row, which unknowns are smoothed.
    /// @p product must outlive this. Collective.
    ChebyshevSmoother(const SaddlePointProduct    &product,
                      const LinearAlgebra::Vector &like,
                      const std::vector<bool>     &chosen);

    /// Take new values of the matrix, with the old bounds of the spectrum.
    void reinit();

    /// Improve the chosen unknowns of @p solution. Collective.
    void smooth(LinearAlgebra::Vector       &solution,
                const LinearAlgebra::Vector &right_hand_side) const;

  private:
    // dealii::DiagonalMatrix wants a vector that is not distributed here
    struct Scaling
    {
      LinearAlgebra::Vector factors;

      void
      vmult(LinearAlgebra::Vector       &result,
            const LinearAlgebra::Vector &vector) const
      {
        result = vector;
        result.scale(factors);
      }
    };

    // what deal.II wants of a matrix
    struct Product : public Compat::Observed
    {
      const SaddlePointProduct *product = nullptr;

      void
      vmult(LinearAlgebra::Vector       &result,
            const LinearAlgebra::Vector &vector) const
      {
        product->vmult(result, vector);
      }
    };

    using Polynomial =
      dealii::PreconditionChebyshev<Product, LinearAlgebra::Vector, Scaling>;

    double largest_eigenvalue() const;

    Product                 product;
    const std::vector<bool> chosen;
    /// one by the diagonal, 0 where nothing is smoothed
    std::shared_ptr<Scaling> scaling;
    Polynomial               polynomial;
  };
} // namespace MixedCracks

#endif
