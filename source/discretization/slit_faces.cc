// SPDX-License-Identifier: GPL-2.0-or-later
// Slits: two boundary faces of the coarse mesh at one place, with doubled
// nodes. All pairs would be n^2 comparisons; sorted by a linear function of the
// centre, f(x) = sum_d (0.6180 + 0.2718 d) x_d, only those are compared whose f
// differs by at most twice the tolerance, as |grad f| < 1.6.
//
//      cell A            f(x_A) and f(x_B) differ by rounding; then the
//    ----o----o----      corners are compared, in any order, and the normal
//    ----o----o----      is that of the first cell, outward
//      cell B

#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <base/ranges.h>

#include <discretization/slit_faces.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // of the diameter of a face: vertices that are nearer are at one place
    constexpr double same_place = 1e-6;

    template <int dim>
    struct BoundaryFace
    {
      typename SlitFace<dim>::Side side;
      FlatPiece<dim>               place;
      Point<dim>                   center;
      Tensor<1, dim>               normal;
      double                       diameter;
      double                       order; // to find neighbours by
    };



    template <int dim>
    Tensor<1, dim>
    normal_of(const FlatPiece<dim> &place, const Tensor<1, dim> &outward)
    {
      Tensor<1, dim> normal;
      if constexpr (dim == 2)
        normal = cross_product_2d(place.corners[1] - place.corners[0]);
      else
        normal = cross_product_3d(place.corners[3] - place.corners[0],
                                  place.corners[2] - place.corners[1]);
      normal /= normal.norm();
      return normal * outward > 0. ? normal : -normal;
    }



    template <int dim>
    std::vector<BoundaryFace<dim>>
    boundary_faces(const Triangulation<dim> &triangulation)
    {
      std::vector<BoundaryFace<dim>> result;
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const unsigned int f : cell->face_indices())
        {
          const auto face = cell->face(f);
          if (!face->at_boundary())
            continue;
          BoundaryFace<dim> entry;
          entry.side = {cell->id().get_coarse_cell_id(), f};
          for (const unsigned int v : face->vertex_indices())
            entry.place.corners[v] = face->vertex(v);
          entry.center = face->center();
          entry.normal =
            normal_of(entry.place, face->center() - cell->center());
          entry.diameter = face->diameter();
          // along a direction that no mesh is aligned with
          entry.order = 0.;
          for (unsigned int d = 0; d < dim; ++d)
            entry.order += entry.center[d] * (0.6180 + 0.2718 * d);
          result.push_back(entry);
        }
      std::sort(result.begin(), result.end(), [](const auto &a, const auto &b) {
        return a.order < b.order;
      });
      return result;
    }



    template <int dim>
    bool
    are_at_one_place(const BoundaryFace<dim> &a, const BoundaryFace<dim> &b)
    {
      const double tolerance = same_place * a.diameter;
      if (a.center.distance(b.center) > tolerance)
        return false;
      return all_of(a.place.corners, [&](const auto &x) {
        return any_of(b.place.corners, [&](const auto &y) {
          return x.distance(y) <= tolerance;
        });
      });
    }
  } // namespace



  template <int dim>
  std::vector<SlitFace<dim>>
  slit_faces(const Triangulation<dim> &triangulation)
  {
    const auto                 faces = boundary_faces(triangulation);
    std::vector<SlitFace<dim>> result;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t k = i + 1;
           k < faces.size() && faces[k].order - faces[i].order <=
                                 2. * same_place * faces[i].diameter;
           ++k)
        if (are_at_one_place(faces[i], faces[k]))
          result.push_back({{{faces[i].side, faces[k].side}},
                            faces[i].place,
                            faces[i].normal});
    return result;
  }



  template std::vector<SlitFace<2>> slit_faces(const Triangulation<2> &);
  template std::vector<SlitFace<3>> slit_faces(const Triangulation<3> &);
} // namespace MixedCracks
