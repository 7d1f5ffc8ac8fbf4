// SPDX-License-Identifier: GPL-2.0-or-later
// Sides that are images of each other. With the boxes around them,
//
//   L = middle of the box of the second - middle of that of the first,
//
// and the faces f, f' of the coarse mesh belong together where each vertex of f
// moved by L is one of f' to within 1e-6 of the size of the face; which it is,
// is the orientation that deal.II asks for. Finer faces follow: p4est keeps the
// two sides within one level of each other.
//
// The vectors of several pairs span a lattice: corners are in several pairs and
// their images a sum of vectors apart,  x' - x = sum_k n_k L_k  with whole n_k.

#include <base/errors.h>

#include <deal.II/base/bounding_box.h>

#include <discretization/lattice.h>
#include <discretization/nearest_vertex.h>
#include <discretization/periodic_sides.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const std::string name_of_entry = "Geometry/Periodic sides";

    // of the size of a face, or a side
    constexpr double match_tolerance = 1e-6;

    template <int dim>
    using CellFace = typename Triangulation<dim>::face_iterator;

    template <int dim>
    CellFace<dim>
    face_of(const Triangulation<dim>                &mesh,
            const typename PeriodicSides<dim>::Face &face)
    {
      const typename Triangulation<dim>::cell_iterator cell(
        &mesh, 0, face.cell);
      return cell->face(face.number);
    }



    template <int dim>
    std::vector<typename PeriodicSides<dim>::Face>
    faces_on(const Triangulation<dim> &mesh, const BoundaryIds &ids)
    {
      std::vector<typename PeriodicSides<dim>::Face> result;
      for (const auto &cell : mesh.cell_iterators_on_level(0))
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              ids.contains(cell->face(f)->boundary_id()))
            result.push_back({cell->index(), f});
      return result;
    }



    std::string
    begin_of_message(const PeriodicPair &pair)
    {
      return name_of_entry + ": found '" + pair.names[0] + " : " +
             pair.names[1] +
             "', allowed are opposite flat sides whose faces differ by one "
             "translation; ";
    }



    // One side: its faces, the box around it, its outward normal.
    template <int dim>
    struct Side
    {
      Side(const Triangulation<dim> &mesh,
           const PeriodicPair       &pair,
           const unsigned int        which)
        : faces(faces_on(mesh, pair.sides[which]))
      {
        if (faces.empty())
          throw InputError(begin_of_message(pair) + "'" + pair.names[which] +
                           "' has no faces.");
        std::vector<Point<dim>> points;
        for (const auto &face : faces)
          for (const unsigned int v : face_of(mesh, face)->vertex_indices())
            points.push_back(face_of(mesh, face)->vertex(v));
        box = BoundingBox<dim>(points);
        for (unsigned int d = 0; d < dim; ++d)
          extent = std::max(extent, box.side_length(d));
        find_normal(mesh);
        for (const Point<dim> &point : points)
          if (std::abs(normal * (point - points.front())) >
              match_tolerance * extent)
            throw InputError(begin_of_message(pair) + "'" + pair.names[which] +
                             "' is not flat: " + in_words(points.front()) +
                             " and " + in_words(point) +
                             " are not in a plane with the normal " +
                             in_words(Point<dim>(normal)) + ".");
      }

      // of the first face, away from its cell
      void
      find_normal(const Triangulation<dim> &mesh)
      {
        const auto           face  = face_of(mesh, faces.front());
        const Tensor<1, dim> along = face->vertex(1) - face->vertex(0);
        if constexpr (dim == 2)
          normal = cross_product_2d(along);
        else
          normal = cross_product_3d(along, face->vertex(2) - face->vertex(0));
        const typename Triangulation<dim>::cell_iterator cell(
          &mesh, 0, faces.front().cell);
        normal /= (normal * (face->center() - cell->center()) < 0. ? -1. : 1.) *
                  normal.norm();
      }

      std::vector<typename PeriodicSides<dim>::Face> faces;
      BoundingBox<dim>                               box;
      double                                         extent = 0.;
      Tensor<1, dim>                                 normal;
    };



    // The vertex of @p second that each of @p first becomes; none: another face
    template <int dim>
    std::optional<std::vector<unsigned int>>
    vertices_of_image(const CellFace<dim>  &first,
                      const CellFace<dim>  &second,
                      const Tensor<1, dim> &period)
    {
      const double              tolerance = match_tolerance * first->diameter();
      std::vector<unsigned int> result;
      for (const unsigned int v : first->vertex_indices())
        for (const unsigned int w : second->vertex_indices())
          if (second->vertex(w).distance(first->vertex(v) + period) <=
              tolerance)
            result.push_back(w);
      if (result.size() != first->n_vertices())
        return {};
      return result;
    }



    // as deal.II has it: bits of face_orientation, face_flip and face_rotation
    std::bitset<3>
    orientation_of(const std::vector<unsigned int> &image)
    {
      static const std::map<std::vector<unsigned int>, unsigned long> bits = {
        {{0, 1}, 1},
        {{1, 0}, 3},
        {{0, 1, 2, 3}, 1},
        {{0, 2, 1, 3}, 0},
        {{1, 0, 3, 2}, 6},
        {{1, 3, 0, 2}, 5},
        {{2, 0, 3, 1}, 7},
        {{2, 3, 0, 1}, 4},
        {{3, 1, 2, 0}, 2},
        {{3, 2, 1, 0}, 3}};
      return bits.at(image);
    }



    // Of the period, and that the sides look away from each other along it.
    template <int dim>
    Tensor<1, dim>
    period_between(const Side<dim>    &first,
                   const Side<dim>    &second,
                   const PeriodicPair &pair)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (std::abs(first.box.side_length(d) - second.box.side_length(d)) >
            match_tolerance * first.extent)
          throw InputError(begin_of_message(pair) +
                           "they have different sizes.");
      const Tensor<1, dim> period = second.box.center() - first.box.center();
      const double         least  = match_tolerance * period.norm();
      if (!(first.normal * period < -least && second.normal * period > least))
        throw InputError(begin_of_message(pair) +
                         "they do not look away from each other: their outward "
                         "normals are " +
                         in_words(Point<dim>(first.normal)) + " and " +
                         in_words(Point<dim>(second.normal)) +
                         ", from the first to the second it is " +
                         in_words(Point<dim>(period)) + ".");
      return period;
    }



    template <int dim>
    typename Triangulation<dim>::cell_iterator
    cell_of(const Triangulation<dim> &mesh, const int index)
    {
      return {&mesh, 0, index};
    }

    template <int dim>
    typename DoFHandler<dim>::cell_iterator
    cell_of(const DoFHandler<dim> &handler, const int index)
    {
      return {&handler.get_triangulation(), 0, index, &handler};
    }



    template <typename Mesh, typename Matches>
    auto
    face_pairs(const Mesh &mesh, const Matches &matches)
    {
      using Cell = typename Mesh::cell_iterator;
      std::vector<GridTools::PeriodicFacePair<Cell>> result;
      for (const auto &match : matches)
      {
        GridTools::PeriodicFacePair<Cell> pair;
        for (unsigned int i = 0; i < 2; ++i)
        {
          pair.cell[i]     = cell_of(mesh, match.faces[i].cell);
          pair.face_idx[i] = match.faces[i].number;
        }
        pair.orientation = match.orientation;
        result.push_back(pair);
      }
      return result;
    }
  } // namespace



  template <int dim>
  PeriodicSides<dim>::PeriodicSides(const Mesh                      &mesh,
                                    const std::vector<PeriodicPair> &pairs)
  {
    for (const PeriodicPair &pair : pairs)
      match(mesh, pair);
    std::vector<Tensor<1, dim>> orthogonal;
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      const Tensor<1, dim> &period = period_of_pair[i];
      const double          small  = match_tolerance * period.norm();
      if (std::any_of(different.begin(), different.end(), [&](const auto &one) {
            return (one - period).norm() <= small;
          }))
        continue;
      const Tensor<1, dim> more = rest_of(period, orthogonal);
      if (more.norm() <= small)
        throw InputError(begin_of_message(pairs[i]) + "their translation " +
                         in_words(Point<dim>(period)) +
                         " follows from those of the pairs before.");
      orthogonal.push_back(more);
      different.push_back(period);
    }
  }



  template <int dim>
  void
  PeriodicSides<dim>::match(const Mesh &mesh, const PeriodicPair &pair)
  {
    const Side<dim>             first(mesh, pair, 0), second(mesh, pair, 1);
    const Tensor<1, dim>        period = period_between(first, second, pair);
    const double                near   = match_tolerance * first.extent;
    std::multimap<double, Face> by_x;
    for (const Face &face : second.faces)
      by_x.emplace(face_of(mesh, face)->center()[0], face);
    for (const Face &face : first.faces)
    {
      const auto   here  = face_of(mesh, face);
      const double x     = here->center()[0] + period[0];
      bool         found = false;
      for (auto at = by_x.lower_bound(x - near);
           at != by_x.end() && at->first <= x + near && !found;
           ++at)
        if (const auto image =
              vertices_of_image<dim>(here, face_of(mesh, at->second), period))
        {
          matched.push_back({{{face, at->second}},
                             orientation_of(*image),
                             period_of_pair.size()});
          by_x.erase(at);
          found = true;
          break;
        }
      if (!found)
        throw InputError(begin_of_message(pair) + "the face at " +
                         in_words(here->center()) + " of '" + pair.names[0] +
                         "' has no partner.");
    }
    if (!by_x.empty())
      throw InputError(begin_of_message(pair) + "the face at " +
                       in_words(face_of(mesh, by_x.begin()->second)->center()) +
                       " of '" + pair.names[1] + "' has no partner.");
    period_of_pair.push_back(period);
  }



  template <int dim>
  std::array<int, dim>
  PeriodicSides<dim>::count_periods(const Tensor<1, dim> &difference) const
  {
    // there are few: images of a corner are one period or none apart
    std::array<int, dim> best{}, tried{};
    double               smallest = difference.norm();
    unsigned int         n_all    = 1;
    for (std::size_t k = 0; k < different.size(); ++k)
      n_all *= 3;
    for (unsigned int i = 0; i < n_all; ++i)
    {
      Tensor<1, dim> rest = difference;
      unsigned int   code = i;
      for (std::size_t k = 0; k < different.size(); ++k, code /= 3)
      {
        tried[k] = static_cast<int>(code % 3) - 1;
        rest -= tried[k] * different[k];
      }
      if (rest.norm() < smallest)
      {
        smallest = rest.norm();
        best     = tried;
      }
    }
    return best;
  }



  template <int dim>
  std::vector<GridTools::PeriodicFacePair<
    typename PeriodicSides<dim>::Mesh::cell_iterator>>
  PeriodicSides<dim>::faces(const Mesh &mesh) const
  {
    return face_pairs(mesh, matched);
  }



  template <int dim>
  std::vector<GridTools::PeriodicFacePair<
    typename PeriodicSides<dim>::Handler::cell_iterator>>
  PeriodicSides<dim>::faces(const Handler &handler) const
  {
    return face_pairs(handler, matched);
  }



  template <int dim>
  double
  PeriodicSides<dim>::cell_volume(const Mesh &mesh) const
  {
    return lattice_cell_volume(mesh, different);
  }



  template class PeriodicSides<2>;
  template class PeriodicSides<3>;
} // namespace MixedCracks
