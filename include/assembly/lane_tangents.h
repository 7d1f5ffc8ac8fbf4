// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_lane_tangents_h
#define mixed_cracks_assembly_lane_tangents_h

#include <assembly/isotropic_cell.h>

#include <deal.II/base/aligned_vector.h>

#include <map>
#include <vector>

namespace MixedCracks
{
  /// How a tangent is kept: the numbers that it needs at a point.
  enum class TangentKind
  {
    graded,    ///< C = a 1 + b I (x) I with b, s and t linear in a: a, c, and
               ///< b = b_0 + b_1 a and so on of the cell
    isotropic, ///< C = a 1 + b I (x) I: a, b, s, t, c
    symmetric, ///< any C at small strain: its triangle, 6 or 21, s, t, c
    finite     ///< dP/d(grad u): its triangle, 10 or 45, dP/dp, 4 or 9, c
  };

  /// The tangents at the quadrature points of cells, side by side for cells
  /// that are integrated together, in the lanes of @p Lanes. s, t and c:
  /// stress_by_pressure, constraint_by_trace and constraint_by_pressure of
  /// ElasticResponse. At small strain a batch of cells is of one kind, that of
  /// the cell that needs most; at finite strain all are finite. Cells of one
  /// material and one regime of the split are graded, as their numbers depend
  /// on the degradation only. Where those of all points are the same but for
  /// rounding (intact cells), those of one point are kept.
  template <int dim, typename Lanes>
  class LaneTangents
  {
  public:
    /// batch and lane
    using Place = std::pair<unsigned int, unsigned int>;

    static constexpr unsigned int n_strains = dim * (dim + 1) / 2;
    static constexpr unsigned int n_entries = dim * dim;

    /// b_0, b_1, s_0, s_1, t_0, t_1
    static constexpr unsigned int
    n_numbers_of_cell(const TangentKind kind)
    {
      return kind == TangentKind::graded ? 6 : 0;
    }

    static constexpr unsigned int
    n_numbers(const TangentKind kind)
    {
      if (kind == TangentKind::graded)
        return 2;
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

    /// Of owned cell number @p cell; for all of them from 0 on.
    void set(unsigned int                             cell,
             const std::vector<ElasticResponse<dim>> &responses);

    /// The numbers of one cell; false if its batch is of another kind.
    bool read_isotropic(unsigned int cell, IsotropicCell &result) const;

    TangentKind
    kind(const unsigned int batch) const
    {
      return batches[batch].kind;
    }

    /// Of the cells of a batch, then of its first point.
    const Lanes *
    numbers(const unsigned int batch) const
    {
      return batches[batch].numbers.begin();
    }

    /// From the numbers of one point of a batch to those of the next.
    unsigned int
    stride(const unsigned int batch) const
    {
      return batches[batch].stride;
    }

    std::size_t memory_consumption() const;

  private:
    struct Batch
    {
      TangentKind                  kind   = TangentKind::isotropic;
      unsigned int                 stride = 0;
      dealii::AlignedVector<Lanes> numbers;
      unsigned int                 n_cells = 0, n_set = 0;
    };

    void begin(Batch &batch, TangentKind kind);

    void make_symmetric(Batch &batch);

    /// If its numbers are.
    void make_graded(Batch &batch);

    /// Keep one point where all are the same.
    void shorten(Batch &batch);

    unsigned int       n_points = 0;
    std::vector<Place> places;
    std::vector<Batch> batches;
    /// lanes that are not isotropic, of batches that are not complete
    std::map<Place, std::vector<double>> anisotropic;
  };



  /// The numbers at the points of a batch, one point after the other; those
  /// of graded cells as those of isotropic ones.
  template <int dim, typename Lanes, TangentKind kept>
  class PointNumbers
  {
  public:
    static constexpr TangentKind kind =
      kept == TangentKind::graded ? TangentKind::isotropic : kept;

    PointNumbers(const LaneTangents<dim, Lanes> &tangents,
                 const unsigned int              batch)
      : of_cell(tangents.numbers(batch))
      , at(of_cell + tangents.n_numbers_of_cell(kept))
      , stride(tangents.stride(batch))
    {}

    const Lanes *
    next()
    {
      const Lanes *here = at;
      at += stride;
      if constexpr (kept != TangentKind::graded)
        return here;
      else
      {
        numbers[0] = here[0];
        for (unsigned int k = 0; k < 3; ++k)
          numbers[k + 1] = of_cell[2 * k] + of_cell[2 * k + 1] * here[0];
        numbers[4] = here[1];
        return numbers;
      }
    }

  private:
    const Lanes       *of_cell, *at;
    const unsigned int stride;
    Lanes              numbers[kept == TangentKind::graded ? 5 : 1];
  };
} // namespace MixedCracks

#endif
