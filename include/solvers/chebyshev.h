// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_chebyshev_h
#define mixed_cracks_solvers_chebyshev_h

#include <base/compat.h>
#include <base/saddle_point_product.h>

#include <deal.II/lac/diagonal_matrix.h>
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
    using Vector = SaddlePointProduct::Vector;

    /// @p chosen: one entry per owned row, which unknowns are smoothed.
    /// @p product must outlive this. Collective.
    ChebyshevSmoother(const SaddlePointProduct &product,
                      const std::vector<bool>  &chosen);

    /// Take new values of the matrix, with the old bounds of the spectrum.
    void reinit();

    /// Improve the chosen unknowns of @p solution. Collective.
    void smooth(Vector &solution, const Vector &right_hand_side) const;

  private:
    using Scaling   = dealii::DiagonalMatrix<Vector>;
    using RangeWork = SaddlePointProduct::RangeWork;

    // what deal.II wants of a matrix. The second is for the polynomial: it
    // combines the vectors of the recurrence while the product is in the cache.
    struct Product : public Compat::Observed
    {
      const SaddlePointProduct *product = nullptr;

      void
      vmult(Vector &result, const Vector &vector) const
      {
        product->vmult(result, vector);
      }

      void
      vmult(Vector          &result,
            const Vector    &vector,
            const RangeWork &before,
            const RangeWork &after) const
      {
        product->vmult(result, vector, before, after);
      }

      // would be asked for the diagonal, had the polynomial none
      dealii::types::global_dof_index n_rows = 0;

      dealii::types::global_dof_index
      m() const
      {
        return n_rows;
      }

      double
      el(unsigned int, unsigned int) const
      {
        throw dealii::ExcNotImplemented();
      }
    };

    using Polynomial = dealii::PreconditionChebyshev<Product, Vector, Scaling>;

    double largest_eigenvalue() const;

    Product                 product;
    const std::vector<bool> chosen;
    /// one by the diagonal, 0 where nothing is smoothed
    std::shared_ptr<Scaling> scaling;
    Polynomial               polynomial;
  };
} // namespace MixedCracks

#endif
