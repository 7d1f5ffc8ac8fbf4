// SPDX-License-Identifier: GPL-2.0-or-later
// Products with blocks in single precision beside those with the dense matrix.
#include "small_systems.h"

#include <solvers/node_blocks.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  // whole nodes on one, two and three ranks
  constexpr unsigned int n_nodes = 12;

  // Not symmetric; each node has entries with the one three before and the next
  // one, some of their components not; the first unknown is constrained.
  Rows
  rows_of_nodes(const unsigned int n_components)
  {
    const unsigned int n = n_components * n_nodes;
    Rows               rows(n, std::vector<double>(n, 0.));
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        const unsigned int I = i / n_components, J = j / n_components;
        const bool         are_neighbours = I == J || I == J + 3 || I + 1 == J;
        if (are_neighbours && (i + 2 * j) % 5 != 0)
          rows[i][j] = std::sin(1. + i + 3. * j) * std::pow(10., I % 4);
      }
    for (unsigned int i = 0; i < n; ++i)
      rows[0][i] = rows[i][0] = 0.;
    rows[0][0] = 1.;
    return rows;
  }

  std::vector<double>
  product(const NodeBlocks &blocks, const std::vector<double> &x)
  {
    const LinearAlgebra::Vector source = distributed(x);
    LinearAlgebra::Vector       result(source);
    blocks.vmult(result.begin(), source.begin());
    return gathered(result);
  }
} // namespace



TEST(NodeBlocks, MultiplyLikeTheMatrixInSinglePrecision)
{
  for (const unsigned int n_components : {2, 3})
  {
    const Rows                  rows = rows_of_nodes(n_components);
    LinearAlgebra::SparseMatrix matrix;
    make_matrix(rows, matrix);
    const NodeBlocks    blocks(matrix.trilinos_matrix(), n_components);
    std::vector<double> x;
    for (unsigned int i = 0; i < rows.size(); ++i)
      x.push_back(std::cos(2. * i));
    const std::vector<double> exact = times(rows, x);
    const std::vector<double> found = product(blocks, x);
    double                    error = 0.;
    for (unsigned int i = 0; i < rows.size(); ++i)
    {
      // 2^-24 of each entry
      double bound = 0.;
      for (unsigned int j = 0; j < rows.size(); ++j)
        bound += 6e-8 * std::abs(rows[i][j] * x[j]);
      EXPECT_NEAR(found[i], exact[i], bound + 1e-12) << i;
      error = std::max(error, std::abs(found[i] - exact[i]));
    }
    EXPECT_GT(error, 1e-9);
  }
}



// GMRES with a fixed preconditioner takes P^-1 (a v + b w) for a P^-1 v + b
// P^-1 w.
TEST(NodeBlocks, AreLinearInDoublePrecision)
{
  const Rows                  rows = rows_of_nodes(3);
  LinearAlgebra::SparseMatrix matrix;
  make_matrix(rows, matrix);
  const NodeBlocks    blocks(matrix.trilinos_matrix(), 3);
  std::vector<double> v, w, sum;
  for (unsigned int i = 0; i < rows.size(); ++i)
  {
    v.push_back(std::cos(2. * i));
    w.push_back(1e4 * std::sin(3. * i));
    sum.push_back(v[i] / 3. + w[i]);
  }
  const std::vector<double> of_v   = product(blocks, v),
                            of_w   = product(blocks, w),
                            of_sum = product(blocks, sum);
  for (unsigned int i = 0; i < rows.size(); ++i)
    // entries up to 1e3 times 1e4, 16 digits
    EXPECT_NEAR(of_sum[i], of_v[i] / 3. + of_w[i], 1e-8) << i;
}
