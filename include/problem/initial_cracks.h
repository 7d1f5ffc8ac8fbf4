// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_initial_cracks_h
#define mixed_cracks_problem_initial_cracks_h

#include <deal.II/base/parameter_handler.h>

#include <problem/geometry.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// Subsection "Initial cracks": where the phase field is 0 at the start: on
  /// the slits of the geometry, unless told otherwise, and on top of them.
  template <int dim>
  struct InitialCracks
  {
    std::string text;
    /// whether the phase field is 0 on the slits of the geometry
    bool broken_slits = true;

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError for segments that cannot be read.
    void check() const;

    std::vector<Segment<dim>> segments() const;
  };

  /// Distance of a point from a segment, mm.
  template <int dim>
  double distance(const dealii::Point<dim> &point, const Segment<dim> &segment);
} // namespace MixedCracks

#endif
