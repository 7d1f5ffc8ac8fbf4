// SPDX-License-Identifier: GPL-2.0-or-later
// Symmetry about a plane x_d = c, the boundary B of half a body: u_d = 0 on it,
// no shear stress. It holds for this component if
//
//   |x_d - y_d| <= 1e-8 L   for all corners and middles x, y of faces of B,
//
// L the extent of B, which is known from the coarse mesh on every rank. The
// normal in the message is that of the face that deviates most.

#include <base/errors.h>

#include <deal.II/base/bounding_box.h>

#include <discretization/nearest_vertex.h>
#include <discretization/symmetry_plane.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    template <int dim, typename Face>
    Tensor<1, dim>
    normal_of_face(const Face &face)
    {
      const Tensor<1, dim> along = face->vertex(1) - face->vertex(0);
      Tensor<1, dim>       normal;
      if constexpr (dim == 2)
        normal = cross_product_2d(along);
      else
        normal = cross_product_3d(along, face->vertex(2) - face->vertex(0));
      return normal / normal.norm();
    }



    // the largest component of a unit normal is farther from 1 than any other's
    template <int dim, typename Faces>
    std::string
    most_oblique_normal(const Faces &faces)
    {
      Point<dim> worst;
      double     smallest = 2.;
      for (const auto &face : faces)
      {
        const Tensor<1, dim> normal  = normal_of_face<dim>(face);
        double               largest = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          largest = std::max(largest, std::abs(normal[d]));
        if (largest < smallest - 1e-12)
        {
          smallest = largest;
          worst    = Point<dim>(normal);
        }
      }
      return in_words(worst);
    }
  } // namespace



  template <int dim>
  unsigned int
  component_normal_to(const Triangulation<dim> &triangulation,
                      const BoundaryIds        &ids,
                      const std::string        &name)
  {
    using Face = typename Triangulation<dim>::face_iterator;
    std::vector<Face>       faces;
    std::vector<Point<dim>> points;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const Face &face : cell->face_iterators())
        if (face->at_boundary() && ids.contains(face->boundary_id()))
        {
          faces.push_back(face);
          points.push_back(face->center(true));
          for (const unsigned int v : face->vertex_indices())
            points.push_back(face->vertex(v));
        }
    const std::string begin =
      "Boundary conditions/Displacement: found '" + name +
      " : symmetry', allowed are boundaries in one plane parallel to the axes; "
      "'" +
      name + "' ";
    if (faces.empty())
      throw InputError(begin + "has no faces.");
    const BoundingBox<dim> box(points);
    double                 extent = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      extent = std::max(extent, box.side_length(d));
    for (unsigned int d = 0; d < dim; ++d)
      if (box.side_length(d) <= 1e-8 * extent)
        return d;
    throw InputError(begin +
                     "has faces in several planes, or a normal such as " +
                     most_oblique_normal<dim>(faces) + ".");
  }



  template unsigned int component_normal_to(const Triangulation<2> &,
                                            const BoundaryIds &,
                                            const std::string &);
  template unsigned int component_normal_to(const Triangulation<3> &,
                                            const BoundaryIds &,
                                            const std::string &);
} // namespace MixedCracks
