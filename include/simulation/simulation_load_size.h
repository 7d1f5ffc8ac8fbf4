// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_simulation_load_size_h
#define mixed_cracks_simulation_simulation_load_size_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/tria.h>

#include <simulation/parameters.h>

namespace MixedCracks
{
  /// Rough sizes of what is applied at a time.
  struct LoadSize
  {
    double strain   = 0.;   ///< prescribed displacement over the largest extent
    double traction = 0.;   ///< MPa
    double fluid    = 0.;   ///< pressure in cracks, MPa
    double points   = 0.;   ///< forces at points over the least section, MPa
    bool   is_known = true; ///< there is nothing that is not looked at
  };

  /// At the corners and in the middle of @p body; needs no mesh.
  template <int dim>
  LoadSize load_size(const Parameters<dim>          &parameters,
                     const dealii::BoundingBox<dim> &body,
                     double                          time);

  /// The coarse cells, known to every rank.
  template <int dim>
  dealii::BoundingBox<dim>
  coarse_extent(const dealii::Triangulation<dim> &triangulation);

  /// "strains of about 0.1, tractions of 2 MPa"; what is 0 is left out.
  std::string in_words(const LoadSize &load);
} // namespace MixedCracks

#endif
