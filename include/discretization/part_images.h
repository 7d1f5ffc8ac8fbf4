// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_part_images_h
#define mixed_cracks_discretization_part_images_h

#include <discretization/body_parts.h>
#include <discretization/periodic_sides.h>

#include <array>
#include <vector>

namespace MixedCracks
{
  /// A vertex of a periodic side and its image, each of a part of the body.
  template <int dim>
  struct PartImage
  {
    std::array<unsigned int, 2>       parts;
    std::array<dealii::Point<dim>, 2> points; ///< mm
  };

  /// Of the coarse mesh. A rigid motion that is equal at the corners of a face
  /// and its image is so all over it.
  template <int dim>
  std::vector<PartImage<dim>>
  part_images(const dealii::Triangulation<dim> &triangulation,
              const PeriodicSides<dim>         &sides,
              const BodyParts<dim>             &parts);

  /// Which parts they join, for BodyParts::groups().
  template <int dim>
  std::vector<std::array<unsigned int, 2>>
  parts_joined_by(const std::vector<PartImage<dim>> &images);
} // namespace MixedCracks

#endif
