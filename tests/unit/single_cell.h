// SPDX-License-Identifier: GPL-2.0-or-later
// What the tests of the cell kernels share: one crooked cell, difference
// quotients of a local residual or energy.
#ifndef mixed_cracks_tests_unit_single_cell_h
#define mixed_cracks_tests_unit_single_cell_h

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace MixedCracks
{
  namespace Testing
  {
    using LocalVector = dealii::Vector<double>;

    /// A cell of the size of 0.5 mm without right angles.
    template <int dim>
    void
    make_crooked_cell(dealii::Triangulation<dim> &triangulation)
    {
      dealii::GridGenerator::hyper_cube(triangulation, 0., 0.5);
      std::mt19937                           generator(42);
      std::uniform_real_distribution<double> random(-0.08, 0.08);
      const auto                             cell = triangulation.begin();
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int d = 0; d < dim; ++d)
          cell->vertex(v)[d] += random(generator);
    }

    /// Numbers between -1 and 1, always the same ones.
    inline LocalVector
    random_values(const unsigned int n, const unsigned int seed = 7)
    {
      std::mt19937                           generator(seed);
      std::uniform_real_distribution<double> random(-1., 1.);
      LocalVector                            values(n);
      for (double &value : values)
        value = random(generator);
      return values;
    }

    /// d(residual)/d(local) by central differences with the steps @p steps.
    template <typename Residual>
    dealii::FullMatrix<double>
    difference_matrix(const Residual    &residual,
                      const LocalVector &local,
                      const LocalVector &steps)
    {
      const unsigned int         n = local.size();
      dealii::FullMatrix<double> result(n, n);
      for (unsigned int j = 0; j < n; ++j)
      {
        LocalVector plus = local, minus = local;
        plus(j) += steps(j);
        minus(j) -= steps(j);
        const LocalVector after = residual(plus), before = residual(minus);
        for (unsigned int i = 0; i < n; ++i)
          result(i, j) = (after(i) - before(i)) / (2. * steps(j));
      }
      return result;
    }

    /// d(energy)/d(local) by central differences.
    template <typename Energy>
    LocalVector
    difference_gradient(const Energy      &energy,
                        const LocalVector &local,
                        const LocalVector &steps)
    {
      LocalVector result(local.size());
      for (unsigned int j = 0; j < local.size(); ++j)
      {
        LocalVector plus = local, minus = local;
        plus(j) += steps(j);
        minus(j) -= steps(j);
        result(j) = (energy(plus) - energy(minus)) / (2. * steps(j));
      }
      return result;
    }

    /// Every entry within @p tolerance of the largest one of its block;
    /// @p block: a number for each row, whose units differ.
    inline void
    expect_equal_by_blocks(const dealii::FullMatrix<double> &found,
                           const dealii::FullMatrix<double> &expected,
                           const std::vector<unsigned int>  &block,
                           const double                      tolerance)
    {
      const unsigned int n             = block.size();
      double             largest[2][2] = {{0., 0.}, {0., 0.}};
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          largest[block[i]][block[j]] =
            std::max(largest[block[i]][block[j]], std::abs(expected(i, j)));
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          EXPECT_NEAR(found(i, j),
                      expected(i, j),
                      tolerance * largest[block[i]][block[j]])
            << "row " << i << ", column " << j;
    }
  } // namespace Testing
} // namespace MixedCracks

#endif
