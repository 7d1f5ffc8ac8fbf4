// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mirrored_mesh_h
#define mixed_cracks_problem_geometries_mirrored_mesh_h

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// The entry "Mirrored mesh" of a geometry whose coarse mesh has grid lines:
  /// in which axes they are mirrored at the middle of the body.
  struct MirroredMesh
  {
    std::string axes = "none";

    /// The caller has entered the subsection of the geometry.
    void add_parameters(dealii::ParameterHandler &prm);

    /// 0: the lines of constant x are mirrored, 1: those of constant y.
    bool is_mirrored(unsigned int axis) const;

    /// grid_lines() of an axis, mirrored where this is asked for.
    std::vector<double> lines(unsigned int               axis,
                              const std::vector<double> &fixed,
                              double                     cell_size) const;

    /// Throws InputError where mirroring is asked for and changes no line.
    /// @p subsection: "Geometry/.../", @p fixed: the lines of x, of y.
    void check(const std::string                        &subsection,
               const std::array<std::vector<double>, 2> &fixed,
               double                                    cell_size) const;
  };

  /// @p lines, from a to b, at a + b - line, but for those that would come
  /// nearer than 3/4 of @p cell_size to one of the @p fixed lines, which stay
  /// where they are, or to the line before; wide gaps are divided. Units: mm.
  std::vector<double> mirrored_lines(const std::vector<double> &lines,
                                     const std::vector<double> &fixed,
                                     double                     cell_size);
} // namespace MixedCracks

#endif
