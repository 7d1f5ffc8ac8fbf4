// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_lane_tangents_h
#define mixed_cracks_assembly_lane_tangents_h

#include <deal.II/base/aligned_vector.h>

#include <model/elastic_response.h>

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

    /// Of owned cell number @p cell; for all of them, then compress().
    void set(unsigned int                             cell,
             const std::vector<ElasticResponse<dim>> &responses);

    void compress();

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
    bool                         is_filled = false;
    TangentKind                  usual     = TangentKind::isotropic;
    dealii::AlignedVector<Lanes> of_usual, of_symmetric;
    std::vector<std::size_t>     first_symmetric; // of a batch
    /// cells that are not as usual, until compress()
    std::map<unsigned int, std::vector<double>> pending;
  };
} // namespace MixedCracks

#include <assembly/lane_tangents.templates.h>

#endif
