// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_constants_table_h
#define mixed_cracks_assembly_constants_table_h

#include <discretization/fields.h>

#include <model/point_constants.h>

#include <optional>
#include <vector>

namespace MixedCracks
{
  /// The constants of the material at the quadrature points of the owned
  /// cells, evaluated once per mesh; a single entry where they do not vary.
  template <int dim>
  class ConstantsTable
  {
  public:
    /// @p constants_at: empty where @p everywhere holds everywhere, which is
    /// not looked at elsewhere. Throws its InputError on all ranks.
    /// Collective.
    ConstantsTable(const Fields<dim>                   &fields,
                   const std::optional<PointConstants> &everywhere,
                   const ConstantsFunction<dim>        &constants_at);

    /// Of owned cell number @p cell, in the order of the loop over the cells.
    CellConstants
    operator[](const unsigned int cell) const
    {
      return varies ? CellConstants(&values[std::size_t(cell) * n_points])
                    : CellConstants(values.front());
    }

  private:
    const bool                  varies;
    const unsigned int          n_points; // per cell
    std::vector<PointConstants> values;   // cell by cell
  };

  /// Call body(point, material id) for the quadrature points of the owned
  /// cells, cell by cell. An InputError of one rank is thrown by all.
  /// Collective.
  template <int dim>
  void for_each_quadrature_point(
    const Fields<dim>                                     &fields,
    const std::function<void(const dealii::Point<dim> &,
                             dealii::types::material_id)> &body);
} // namespace MixedCracks

#endif
