// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_surface_h
#define mixed_cracks_output_crack_surface_h

#include <discretization/fields.h>

#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// Triangles, the corners of one after the other.
  using Triangles = std::vector<dealii::Point<3>>;

  /// The surface around the cracks where the phase field is @p level; those of
  /// all ranks on the first one, none on the others. @p phase_field with
  /// ghosts. Collective.
  Triangles crack_surface(const Fields<3>             &fields,
                          const LinearAlgebra::Vector &phase_field,
                          double                       level = 0.5);

  /// crack_surface() as VTK PolyData, @p file_name in @p directory, and
  /// crack_surface.pvd, the list of all such files: @p times_and_names with
  /// this one. The first rank writes; throws FileError on all. Collective.
  void write_crack_surface(
    const Fields<3>                                   &fields,
    const LinearAlgebra::Vector                       &phase_field,
    const std::string                                 &directory,
    const std::string                                 &file_name,
    const std::vector<std::pair<double, std::string>> &times_and_names);
} // namespace MixedCracks

#endif
