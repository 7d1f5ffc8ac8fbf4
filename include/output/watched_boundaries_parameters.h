// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_watched_boundaries_parameters_h
#define mixed_cracks_output_watched_boundaries_parameters_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <discretization/boundary_ids.h>

#include <optional>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A boundary whose force and displacement are recorded.
  template <int dim>
  struct WatchedBoundary
  {
    std::string                       name;
    std::optional<dealii::Point<dim>> about; ///< moments; mm
    BoundaryIds                       ids;   ///< see boundaries()

    /// Of statistics.csv: dim of the force, those of the moment (one in 2-d,
    /// three in 3-d), dim of the displacement.
    std::vector<std::string> column_names() const;
  };

  /// Boundaries with columns of their own in statistics.csv, an entry of
  /// subsection "Output".
  template <int dim>
  struct WatchedBoundariesParameters
  {
    static constexpr const char *entry_name = "Output/Watched boundaries";

    std::string text;

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// In the order of the entry, with the numbers that they have in @p ids.
    /// Throws InputError for entries that cannot be read, unknown boundaries,
    /// and two whose columns would have the same name.
    std::vector<WatchedBoundary<dim>>
    boundaries(const NamedBoundaries &ids) const;
  };
} // namespace MixedCracks

#endif
