// SPDX-License-Identifier: GPL-2.0-or-later
// Boundaries by position. A face of the coarse mesh whose centre c (the mean of
// its vertices) meets a condition belongs to that region, whatever side it was
// part of; of several regions, to the one that is listed last. Finer faces
// inherit.
//
// A face has one id. That of a region tells also what the face was before, so
// that the parts of the body are known by the same names as without regions,
// where the outcome of a crack depends on them (side, hole, notch):
//
//   id = first + r (n + 1) + k,   r region, n ids of the geometry, k which of
//                                 them, n: none
//
// and the name of a region stands for n + 1 ids, most of which no face has. All
// is known before there is a mesh. Every rank has the whole coarse mesh, and
// does all this alike.

#include <base/errors.h>
#include <base/text.h>

#include <problem/geometries/boundary_regions.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using dealii::Point;

  namespace
  {
    const std::string regions_path = "Geometry/Boundary regions";

    // above those of mesh files
    constexpr dealii::types::boundary_id first_region_id = 2000000000;



    // the place at s, t in the unit square of a face that is flat or nearly so
    template <int dim, typename Face>
    Point<dim>
    place_on(const Face &face, const double s, const double t)
    {
      if constexpr (dim == 2)
        return face->vertex(0) + s * (face->vertex(1) - face->vertex(0));
      else
        return Point<dim>((1. - s) * (1. - t) * face->vertex(0) +
                          s * (1. - t) * face->vertex(1) +
                          (1. - s) * t * face->vertex(2) +
                          s * t * face->vertex(3));
    }
  } // namespace



  template <int dim>
  void
  GeometryWithRegions<dim>::check() const
  {
    geometry->check();
    const std::vector<std::string> names = geometry->names();
    for (const NamedCondition<dim> &region : regions)
      if (std::find(names.begin(), names.end(), region.name) != names.end())
        throw InputError(
          regions_path + ": found the name '" + region.name +
          "', which the geometry has already. Allowed are names but for " +
          join_names(names) +
          "; faces of a region leave the boundary that they were part of.");
  }



  template <int dim>
  std::vector<dealii::types::boundary_id>
  GeometryWithRegions<dim>::ids_of_geometry() const
  {
    BoundaryIds all;
    for (const auto &[name, ids] : geometry->boundary_ids())
      all.insert(ids.begin(), ids.end());
    return {all.begin(), all.end()};
  }



  template <int dim>
  dealii::types::boundary_id
  GeometryWithRegions<dim>::new_id(const std::size_t      region,
                                   const Id               old,
                                   const std::vector<Id> &known)
  {
    const auto found = std::lower_bound(known.begin(), known.end(), old);
    const auto k     = found != known.end() && *found == old
                         ? static_cast<std::size_t>(found - known.begin())
                         : known.size();
    return static_cast<Id>(first_region_id + region * (known.size() + 1) + k);
  }



  template <int dim>
  NamedBoundaries
  GeometryWithRegions<dim>::boundary_ids() const
  {
    NamedBoundaries       result = geometry->boundary_ids();
    const std::vector<Id> known  = ids_of_geometry();
    for (std::size_t r = 0; r < regions.size(); ++r)
      for (std::size_t k = 0; k <= known.size(); ++k)
        result[regions[r].name].insert(
          static_cast<Id>(first_region_id + r * (known.size() + 1) + k));
    return result;
  }



  template <int dim>
  std::map<dealii::types::boundary_id, std::string>
  GeometryWithRegions<dim>::names_of_ids() const
  {
    auto                  result = geometry->names_of_ids();
    const auto            before = result;
    const std::vector<Id> known  = ids_of_geometry();
    for (std::size_t r = 0; r < regions.size(); ++r)
    {
      for (const Id id : known)
        result[new_id(r, id, known)] = before.at(id);
      result[new_id(r, dealii::numbers::invalid_boundary_id, known)] =
        regions[r].name;
    }
    return result;
  }



  template <int dim>
  template <typename Face>
  std::optional<std::size_t>
  GeometryWithRegions<dim>::region_of(const Face &face) const
  {
    for (std::size_t r = regions.size(); r-- > 0;)
    {
      if (n_tried == 1)
      {
        if (regions[r].holds_at(face->center()))
          return r;
        continue;
      }
      for (unsigned int i = 0; i < n_tried; ++i)
        for (unsigned int k = 0; k < (dim == 3 ? n_tried : 1); ++k)
          if (regions[r].holds_at(
                place_on<dim>(face, (i + 0.5) / n_tried, (k + 0.5) / n_tried)))
            return r;
    }
    return {};
  }



  template <int dim>
  void
  GeometryWithRegions<dim>::create(
    dealii::Triangulation<dim> &triangulation) const
  {
    geometry->create(triangulation);
    const std::vector<Id>   known = ids_of_geometry();
    std::vector<Point<dim>> centers;
    std::vector<bool>       is_met(regions.size()), has_faces(regions.size());
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const unsigned int f : cell->face_indices())
      {
        const auto face = cell->face(f);
        if (!face->at_boundary())
          continue;
        centers.push_back(face->center());
        for (std::size_t r = 0; r < regions.size(); ++r)
          is_met[r] = is_met[r] || regions[r].holds_at(centers.back());
        const auto region = region_of(face);
        if (!region)
          continue;
        has_faces[*region] = true;
        face->set_boundary_id(new_id(*region, face->boundary_id(), known));
      }
    if (n_tried == 1)
      require_faces(centers, is_met, has_faces);
  }



  template <int dim>
  void
  GeometryWithRegions<dim>::require_faces(
    const std::vector<Point<dim>> &centers,
    const std::vector<bool>       &is_met,
    const std::vector<bool>       &has_faces) const
  {
    for (std::size_t r = 0; r < regions.size(); ++r)
      if (!has_faces[r])
        throw InputError(
          regions_path + ": found '" + regions[r].name + " : " +
          regions[r].condition.text() + "', which " +
          (is_met[r] ? "holds only on faces that belong to a later region. "
                       "Allowed is one with a face of its own."
                     : "holds at the centre of no face of the boundary of the "
                       "coarse mesh. Allowed is what holds at one; " +
                         nearest_in_words(regions[r], centers) + "."));
  }



  template <int dim>
  std::unique_ptr<Geometry<dim>>
  GeometryWithRegions<dim>::coarser(const double factor) const
  {
    auto larger = geometry->coarser(factor);
    if (!larger)
      return nullptr;
    auto result   = std::make_unique<GeometryWithRegions>(*larger, regions);
    result->owned = std::move(larger);
    // the centres of the faces that a face stands for, and as many again on
    // either side
    result->n_tried = 3 * static_cast<unsigned int>(std::ceil(factor));
    return result;
  }



  template class GeometryWithRegions<2>;
  template class GeometryWithRegions<3>;
} // namespace MixedCracks
