// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_lane_tangents_h
#define mixed_cracks_assembly_lane_tangents_h

#include <assembly/isotropic_cell.h>

#include <deal.II/base/aligned_vector.h>

#include <algorithm>
#include <map>
#include <vector>

namespace MixedCracks
{
  /// How a tangent is kept: the numbers that it needs at a point.
  enum class TangentKind
  {
    isotropic, ///< C = a 1 + b I (x) I: a, b, s, t, c
    symmetric, ///< any C at small strain: its triangle, 6 or 21, s, t, c
    finite     ///< dP/d(grad u): its triangle, 10 or 45, dP/dp, 4 or 9, c
  };

  /// The tangents at the quadrature points of cells, side by side for cells
  /// that are integrated together, in the lanes of @p Lanes. s, t and c:
  /// stress_by_pressure, constraint_by_trace and constraint_by_pressure of
  /// ElasticResponse. At small strain a batch of cells is of one kind, that of
  /// the cell that needs most; at finite strain all are finite.
  template <int dim, typename Lanes>
  class LaneTangents
  {
  public:
    /// batch and lane
    using Place = std::pair<unsigned int, unsigned int>;

    static constexpr unsigned int n_strains = dim * (dim + 1) / 2;
    static constexpr unsigned int n_entries = dim * dim;

    static constexpr unsigned int
    n_numbers(const TangentKind kind)
    {
      if (kind == TangentKind::isotropic)
        return 5;
      if (kind == TangentKind::symmetric)
        return n_strains * (n_strains + 1) / 2 + 3;
      return n_entries * (n_entries + 1) / 2 + n_entries + 1;
    }

    /// @p places: those of the owned cells.
    void reinit(unsigned int              n_batches,
                unsigned int              n_points_per_cell,
                const std::vector<Place> &places);

    /// Of owned cell number @p cell; for all of them from 0 on, then
    /// compress().
    void set(unsigned int                             cell,
             const std::vector<ElasticResponse<dim>> &responses);

    void compress();

    /// The numbers of one cell; false if they are of another kind.
    bool read_isotropic(unsigned int cell, IsotropicCell &result) const;

    TangentKind
    kind(const unsigned int batch) const
    {
      return first_symmetric[batch] == nowhere ? usual : TangentKind::symmetric;
    }

    /// Of the first point of a batch; those of the next follow.
    const Lanes *
    numbers(const unsigned int batch) const
    {
      return first_symmetric[batch] == nowhere
               ? &of_usual[std::size_t(batch) * n_points * n_numbers(usual)]
               : &of_symmetric[first_symmetric[batch]];
    }

    std::size_t
    memory_consumption() const
    {
      return of_usual.memory_consumption() + of_symmetric.memory_consumption() +
             first_symmetric.size() * sizeof(std::size_t);
    }

  private:
    static constexpr std::size_t nowhere = -1;

    void begin(TangentKind kind);

    unsigned int                 n_batches = 0, n_points = 0;
    std::vector<Place>           places;
    TangentKind                  usual = TangentKind::isotropic;
    dealii::AlignedVector<Lanes> of_usual, of_symmetric;
    std::vector<std::size_t>     first_symmetric; // of a batch
    /// cells that are not as usual, until compress()
    std::map<unsigned int, std::vector<double>> pending;
  };



  // All here: it is compiled for each number of lanes, with the instructions
  // that belong to them.

  namespace Internal
  {
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
  LaneTangents<dim, Lanes>::reinit(const unsigned int        n_batches_now,
                                   const unsigned int        n_points_per_cell,
                                   const std::vector<Place> &places_now)
  {
    n_batches = n_batches_now;
    n_points  = n_points_per_cell;
    places    = places_now;
    of_usual.clear();
    of_symmetric.clear();
    first_symmetric.assign(n_batches, nowhere);
  }



  // what no cell fills is multiplied too: let it be 0
  template <int dim, typename Lanes>
  void
  LaneTangents<dim, Lanes>::begin(const TangentKind kind)
  {
    usual = kind;
    std::fill(first_symmetric.begin(), first_symmetric.end(), nowhere);
    of_symmetric.clear();
    of_usual.resize(std::size_t(n_batches) * n_points * n_numbers(kind),
                    Lanes(0.));
  }



  template <int dim, typename Lanes>
  void
  LaneTangents<dim, Lanes>::set(
    const unsigned int                       cell,
    const std::vector<ElasticResponse<dim>> &responses)
  {
    const bool is_finite = responses.front().finite.has_value();
    if (cell == 0)
      begin(is_finite ? TangentKind::finite : TangentKind::isotropic);
    const unsigned int lane = places[cell].second;
    Lanes             *to =
      &of_usual[std::size_t(places[cell].first) * n_points * n_numbers(usual)];
    if (is_finite)
    {
      std::vector<double> values;
      for (const ElasticResponse<dim> &response : responses)
        Internal::append_finite(response, values);
      for (const double value : values)
        (to++)[0][lane] = value;
      return;
    }
    bool is_isotropic = true;
    for (const ElasticResponse<dim> &response : responses)
    {
      const auto constants = isotropic_tangent(response.stress_by_strain);
      is_isotropic &= constants.has_value();
      for (const double value : {constants ? constants->identity : 0.,
                                 constants ? constants->volume : 0.,
                                 response.stress_by_pressure,
                                 response.constraint_by_trace,
                                 response.constraint_by_pressure})
        (to++)[0][lane] = value;
    }
    if (!is_isotropic)
      for (const ElasticResponse<dim> &response : responses)
        Internal::append_symmetric(response, pending[cell]);
  }



  // Where a point is not isotropic, set() has left a = 0.
  template <int dim, typename Lanes>
  bool
  LaneTangents<dim, Lanes>::read_isotropic(const unsigned int cell,
                                           IsotropicCell     &result) const
  {
    constexpr unsigned int n = n_numbers(TangentKind::isotropic);
    if (usual != TangentKind::isotropic)
      return false;
    const auto [batch, lane] = places[cell];
    const Lanes *from        = &of_usual[std::size_t(batch) * n_points * n];
    result.resize(n_points);
    for (unsigned int q = 0; q < n_points; ++q, from += n)
    {
      result.identity[q]               = from[0][lane];
      result.volume[q]                 = from[1][lane];
      result.stress_by_pressure[q]     = from[2][lane];
      result.constraint_by_trace[q]    = from[3][lane];
      result.constraint_by_pressure[q] = from[4][lane];
      if (result.identity[q] == 0.)
        return false;
    }
    return true;
  }



  // The other cells of a batch with one that is not isotropic: C_(ij) from a
  // and b, where i and j < dim are normal strains.
  template <int dim, typename Lanes>
  void
  LaneTangents<dim, Lanes>::compress()
  {
    constexpr unsigned int n_isotropic = n_numbers(TangentKind::isotropic);
    const std::size_t      size = n_points * n_numbers(TangentKind::symmetric);
    std::size_t            n_special = 0;
    for (const auto &entry : pending)
    {
      std::size_t &first = first_symmetric[places[entry.first].first];
      if (first == nowhere)
        first = size * n_special++;
    }
    of_symmetric.resize(size * n_special, Lanes(0.));
    for (unsigned int cell = 0; cell < places.size() && n_special > 0; ++cell)
    {
      const auto [batch, lane] = places[cell];
      if (first_symmetric[batch] == nowhere)
        continue;
      Lanes *to = &of_symmetric[first_symmetric[batch]];
      if (const auto found = pending.find(cell); found != pending.end())
      {
        for (const double value : found->second)
          (to++)[0][lane] = value;
        continue;
      }
      const Lanes *from =
        &of_usual[std::size_t(batch) * n_points * n_isotropic];
      for (unsigned int q = 0; q < n_points; ++q, from += n_isotropic)
      {
        for (unsigned int i = 0; i < n_strains; ++i)
          for (unsigned int j = i; j < n_strains; ++j)
            (to++)[0][lane] =
              (i == j ? (i < dim ? 1. : 0.5) * from[0][lane] : 0.) +
              (j < dim ? from[1][lane] : 0.);
        for (unsigned int k = 2; k < n_isotropic; ++k)
          (to++)[0][lane] = from[k][lane];
      }
    }
    pending.clear();
  }
} // namespace MixedCracks

#endif
