// SPDX-License-Identifier: GPL-2.0-or-later
// Which matrix goes with which state. The tangent at a point is
//
//   C = g C+ + C-,   C+ and C- decided by the regime of the point,
//
// so that two states with the same g and the same regime, if it is not -1, have
// the same matrix bit by bit. Two questions follow:
//
//   is the old matrix (its factors) good enough to be tried?     the distance:
//       max over the points of |g - g_old| / min(g, g_old), and the number of
//       points in another regime. As long as that is 0, A - A_old is at most
//       about the first times A, and Newton's method with A_old contracts.
//   where does the matrix differ?     the cells that have such a point.
//
// At finite strain the tangent is another one in every state. How far off the
// old one is has no such simple bound; the distance is then
//
//   max over the points of |F - F_old| / |F_old|
//
// besides that of g, and the old factors are but tried.

#include <assembly/elastic_tangent.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  namespace
  {
    // Above this part of changed cells a new matrix is less work than
    // correcting the old one, which evaluates changed cells twice ...
    constexpr double largest_changed_part = 0.25;
    // ... and once in a while rounding is swept out.
    constexpr unsigned int most_corrections = 50;

    // |F - F_old| / |F_old|
    template <int dim>
    double
    change_of_deformation(const ElasticPoint<dim> &now,
                          const ElasticPoint<dim> &then)
    {
      dealii::Tensor<2, dim> F = then.gradient;
      for (unsigned int d = 0; d < dim; ++d)
        F[d][d] += 1.;
      return (now.gradient - then.gradient).norm() / F.norm();
    }
  } // namespace



  template <int dim>
  void
  ElasticTangent<dim>::reinit(const unsigned int n_cells,
                              const unsigned int n_points_per_cell)
  {
    n_points = n_points_per_cell;
    states.resize(std::size_t(n_cells) * n_points);
    matrix_states.clear();
    // no degradation is as far off as this one
    matrix_marks.assign(states.size(),
                        {std::numeric_limits<double>::max(), -1});
    n_corrections = most_corrections;
  }



  template <int dim>
  void
  ElasticTangent<dim>::set_present(const unsigned int                    cell,
                                   const std::vector<ElasticPoint<dim>> &points)
  {
    std::copy(points.begin(),
              points.end(),
              states.begin() + std::size_t(cell) * n_points);
  }



  template <int dim>
  void
  ElasticTangent<dim>::compare(const unsigned int cell,
                               TangentDistance   &distance) const
  {
    const ElasticPoint<dim> *now  = present(cell);
    const Mark              *then = &matrix_marks[std::size_t(cell) * n_points];
    for (unsigned int q = 0; q < n_points; ++q)
    {
      distance.degradation =
        std::max(distance.degradation,
                 std::abs(now[q].degradation - then[q].degradation) /
                   std::max(std::min(now[q].degradation, then[q].degradation),
                            std::numeric_limits<double>::min()));
      if (now[q].tangent_regime == tangent_of_finite_strain)
        distance.deformation =
          matrix_states.empty()
            ? std::numeric_limits<double>::infinity()
            : std::max(distance.deformation,
                       change_of_deformation(now[q], of_matrix(cell)[q]));
      else if (now[q].tangent_regime < 0 ||
               now[q].tangent_regime != then[q].regime)
        distance.regime_changes += 1.;
    }
  }



  template <int dim>
  std::vector<unsigned int>
  ElasticTangent<dim>::changed_cells() const
  {
    std::vector<unsigned int> result;
    for (std::size_t at = 0; at < states.size(); at += n_points)
      if (!std::equal(states.begin() + at,
                      states.begin() + at + n_points,
                      matrix_marks.begin() + at,
                      [](const ElasticPoint<dim> &point, const Mark &mark) {
                        return point.degradation == mark.degradation &&
                               point.tangent_regime == mark.regime &&
                               mark.regime >= 0;
                      }))
        result.push_back(at / n_points);
    return result;
  }



  template <int dim>
  bool
  ElasticTangent<dim>::is_to_be_corrected(const double n_changed,
                                          const double n_cells) const
  {
    return n_corrections < most_corrections &&
           n_changed < largest_changed_part * n_cells;
  }



  template <int dim>
  void
  ElasticTangent<dim>::note_matrix(const bool was_corrected,
                                   const bool keeps_points)
  {
    if (keeps_points)
      matrix_states = states;
    for (std::size_t i = 0; i < states.size(); ++i)
      matrix_marks[i] = {states[i].degradation, states[i].tangent_regime};
    n_corrections = was_corrected ? n_corrections + 1 : 0;
  }



  template class ElasticTangent<2>;
  template class ElasticTangent<3>;
} // namespace MixedCracks
