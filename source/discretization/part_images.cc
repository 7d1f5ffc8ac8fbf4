// SPDX-License-Identifier: GPL-2.0-or-later
#include <discretization/part_images.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  std::vector<PartImage<dim>>
  part_images(const Triangulation<dim> &triangulation,
              const PeriodicSides<dim> &sides,
              const BodyParts<dim>     &parts)
  {
    std::vector<PartImage<dim>> images;
    for (const auto &match : sides.matches())
    {
      const auto &[first, second] = match.faces;
      const typename Triangulation<dim>::cell_iterator cell(
        &triangulation, 0, first.cell);
      const auto face = cell->face(first.number);
      for (const unsigned int v : face->vertex_indices())
        images.push_back(
          {{{parts.of_cell(first.cell), parts.of_cell(second.cell)}},
           {{face->vertex(v), face->vertex(v) + sides.periods()[match.pair]}}});
    }
    return images;
  }



  template <int dim>
  std::vector<std::array<unsigned int, 2>>
  parts_joined_by(const std::vector<PartImage<dim>> &images)
  {
    std::vector<std::array<unsigned int, 2>> result;
    for (const PartImage<dim> &image : images)
      result.push_back(image.parts);
    return result;
  }



#define INSTANTIATE(dim)                                                       \
  template std::vector<PartImage<dim>> part_images(const Triangulation<dim> &, \
                                                   const PeriodicSides<dim> &, \
                                                   const BodyParts<dim> &);    \
  template std::vector<std::array<unsigned int, 2>> parts_joined_by(           \
    const std::vector<PartImage<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
