// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_lane_tangents_templates_h
#define mixed_cracks_assembly_lane_tangents_templates_h

#include <assembly/lane_tangents.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  // All here: it is compiled for each number of lanes, with the instructions
  // that belong to them.

  namespace Internal
  {
    // shape functions sum up to 1 but for rounding, and so do phase fields
    constexpr double rounding = 16. * std::numeric_limits<double>::epsilon();



    // C_(ij) of the pairs i <= j of strains, then s, t, c
    template <int dim>
    void
    append_symmetric(const ElasticResponse<dim> &response,
                     std::vector<double>        &values)
    {
      for (unsigned int i = 0; i < dim * (dim + 1) / 2; ++i)
        for (unsigned int j = i; j < dim * (dim + 1) / 2; ++j)
          values.push_back(tangent_entry(response.stress_by_strain, i, j));
      values.insert(values.end(),
                    {response.stress_by_pressure,
                     response.constraint_by_trace,
                     response.constraint_by_pressure});
    }



    // A_(iJ, kL) of the pairs of components in the order iJ = dim i + J, then
    // K_iJ, c
    template <int dim>
    void
    append_finite(const ElasticResponse<dim> &response,
                  std::vector<double>        &values)
    {
      const auto &finite = *response.finite;
      for (unsigned int i = 0; i < dim * dim; ++i)
        for (unsigned int j = i; j < dim * dim; ++j)
          values.push_back(
            finite.stress_by_gradient[i / dim][i % dim][j / dim][j % dim]);
      for (unsigned int i = 0; i < dim * dim; ++i)
        values.push_back(finite.coupling[i / dim][i % dim]);
      values.push_back(response.constraint_by_pressure);
    }
  } // namespace Internal



  template <int dim, typename Lanes>
  void
  LaneTangents<dim, Lanes>::reinit(const unsigned int        n_batches,
                                   const unsigned int        n_points_per_cell,
                                   const std::vector<Place> &places_now)
  {
    n_points = n_points_per_cell;
    places   = places_now;
    batches.clear();
    batches.resize(n_batches);
    for (const Place &place : places)
      ++batches[place.first].n_cells;
  }



  // what no cell fills is multiplied too: let it be 0
  template <int dim, typename Lanes>
  void
  LaneTangents<dim, Lanes>::begin(Batch &batch, const TangentKind kind)
  {
    batch.kind   = kind;
    batch.stride = n_numbers(kind);
    batch.numbers.clear();
    batch.numbers.resize(n_points * batch.stride, Lanes(0.));
  }



  template <int dim, typename Lanes>
  void
  LaneTangents<dim, Lanes>::set(
    const unsigned int                       cell,
    const std::vector<ElasticResponse<dim>> &responses)
  {
    if (cell == 0)
    {
      anisotropic.clear();
      for (Batch &batch : batches)
        batch.n_set = 0;
    }
    const bool         is_finite = responses.front().finite.has_value();
    Batch             &batch     = batches[places[cell].first];
    const unsigned int lane      = places[cell].second;
    if (batch.n_set == 0)
      begin(batch, is_finite ? TangentKind::finite : TangentKind::isotropic);
    Lanes              *to = batch.numbers.begin();
    std::vector<double> values;
    bool                is_isotropic = true;
    for (const ElasticResponse<dim> &response : responses)
    {
      if (is_finite)
        Internal::append_finite(response, values);
      else
      {
        const auto constants = isotropic_tangent(response.stress_by_strain);
        is_isotropic         = is_isotropic && constants;
        values.insert(values.end(),
                      {constants ? constants->identity : 0.,
                       constants ? constants->volume : 0.,
                       response.stress_by_pressure,
                       response.constraint_by_trace,
                       response.constraint_by_pressure});
      }
    }
    for (const double value : values)
      (to++)[0][lane] = value;
    if (!is_isotropic)
      for (const ElasticResponse<dim> &response : responses)
        Internal::append_symmetric(response, anisotropic[places[cell]]);
    if (++batch.n_set < batch.n_cells)
      return;
    if (batch.kind == TangentKind::isotropic && !anisotropic.empty())
      make_symmetric(batch);
    if (batch.kind == TangentKind::isotropic)
      make_graded(batch);
    shorten(batch);
  }



  // C_(ij) of the cells that are isotropic from a and b, where i and j < dim
  // are normal strains.
  template <int dim, typename Lanes>
  void
  LaneTangents<dim, Lanes>::make_symmetric(Batch &batch)
  {
    const unsigned int number = &batch - batches.data();
    const auto         first  = anisotropic.lower_bound({number, 0});
    const auto         last   = anisotropic.lower_bound({number + 1, 0});
    if (first == last)
      return;
    const dealii::AlignedVector<Lanes> isotropic = batch.numbers;
    begin(batch, TangentKind::symmetric);
    const Lanes *from = isotropic.begin();
    Lanes       *to   = batch.numbers.begin();
    for (unsigned int q = 0; q < n_points; ++q)
    {
      for (unsigned int i = 0; i < n_strains; ++i)
        for (unsigned int j = i; j < n_strains; ++j)
          *to++ = (i == j ? (i < dim ? 1. : 0.5) * from[0] : Lanes(0.)) +
                  (j < dim ? from[1] : Lanes(0.));
      for (unsigned int k = 2; k < n_numbers(TangentKind::isotropic); ++k)
        *to++ = from[k];
      from += n_numbers(TangentKind::isotropic);
    }
    for (auto entry = first; entry != last; ++entry)
    {
      to = batch.numbers.begin();
      for (const double value : entry->second)
        (to++)[0][entry->first.second] = value;
    }
    anisotropic.erase(first, last);
  }



  // b_1 and so on from the points with the least and the largest a.
  template <int dim, typename Lanes>
  void
  LaneTangents<dim, Lanes>::make_graded(Batch &batch)
  {
    constexpr unsigned int       n       = n_numbers(TangentKind::isotropic);
    const Lanes                 *numbers = batch.numbers.begin();
    dealii::AlignedVector<Lanes> graded;
    graded.resize(n_numbers_of_cell(TangentKind::graded) +
                    n_points * n_numbers(TangentKind::graded),
                  Lanes(0.));
    for (unsigned int lane = 0; lane < Lanes::size(); ++lane)
    {
      const auto value = [&](const unsigned int q, const unsigned int k) {
        return numbers[q * n + k][lane];
      };
      unsigned int low = 0, high = 0;
      for (unsigned int q = 1; q < n_points; ++q)
      {
        low  = value(q, 0) < value(low, 0) ? q : low;
        high = value(q, 0) > value(high, 0) ? q : high;
      }
      const double range  = value(high, 0) - value(low, 0);
      const bool   varies = range > Internal::rounding * value(high, 0);
      for (unsigned int k = 1; k <= 3; ++k)
      {
        const double slope =
          varies ? (value(high, k) - value(low, k)) / range : 0.;
        const double least = value(low, k) - slope * value(low, 0);
        for (unsigned int q = 0; q < n_points; ++q)
          if (std::abs(least + slope * value(q, 0) - value(q, k)) >
              Internal::rounding *
                std::max(std::abs(value(low, k)), std::abs(value(high, k))))
            return;
        graded[2 * (k - 1)][lane]     = least;
        graded[2 * (k - 1) + 1][lane] = slope;
      }
    }
    Lanes *to = graded.begin() + n_numbers_of_cell(TangentKind::graded);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      *to++ = numbers[q * n];
      *to++ = numbers[q * n + 4];
    }
    batch.kind   = TangentKind::graded;
    batch.stride = n_numbers(TangentKind::graded);
    batch.numbers.swap(graded);
  }



  template <int dim, typename Lanes>
  void
  LaneTangents<dim, Lanes>::shorten(Batch &batch)
  {
    const unsigned int of_cell = n_numbers_of_cell(batch.kind);
    const Lanes       *numbers = batch.numbers.begin() + of_cell;
    for (unsigned int i = batch.stride; i < n_points * batch.stride; ++i)
    {
      const Lanes &first = numbers[i % batch.stride];
      for (unsigned int lane = 0; lane < Lanes::size(); ++lane)
        if (std::abs(numbers[i][lane] - first[lane]) >
            Internal::rounding * std::abs(first[lane]))
          return;
    }
    dealii::AlignedVector<Lanes> shorter(of_cell + batch.stride);
    std::copy_n(batch.numbers.begin(), shorter.size(), shorter.begin());
    batch.numbers.swap(shorter);
    batch.stride = 0;
  }



  template <int dim, typename Lanes>
  bool
  LaneTangents<dim, Lanes>::read_isotropic(const unsigned int cell,
                                           IsotropicCell     &result) const
  {
    const auto [batch, lane] = places[cell];
    const auto read          = [&, lane = lane](auto numbers) {
      result.resize(n_points);
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const Lanes *from                = numbers.next();
        result.identity[q]               = from[0][lane];
        result.volume[q]                 = from[1][lane];
        result.stress_by_pressure[q]     = from[2][lane];
        result.constraint_by_trace[q]    = from[3][lane];
        result.constraint_by_pressure[q] = from[4][lane];
      }
    };
    if (kind(batch) == TangentKind::graded)
      read(PointNumbers<dim, Lanes, TangentKind::graded>(*this, batch));
    else if (kind(batch) == TangentKind::isotropic)
      read(PointNumbers<dim, Lanes, TangentKind::isotropic>(*this, batch));
    else
      return false;
    return true;
  }



  template <int dim, typename Lanes>
  std::size_t
  LaneTangents<dim, Lanes>::memory_consumption() const
  {
    std::size_t bytes = places.size() * sizeof(Place);
    for (const Batch &batch : batches)
      bytes += sizeof(Batch) + batch.numbers.memory_consumption();
    return bytes;
  }
} // namespace MixedCracks

#endif
