// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_boundary_regions_h
#define mixed_cracks_problem_geometries_boundary_regions_h

#include <problem/geometry.h>
#include <problem/named_conditions.h>

#include <utility>

namespace MixedCracks
{
  /// A geometry some of whose boundary has further names, by the position of
  /// the faces of its coarse mesh.
  template <int dim>
  class GeometryWithRegions : public Geometry<dim>
  {
  public:
    /// @p geometry must outlive the object.
    GeometryWithRegions(const Geometry<dim>             &geometry,
                        std::vector<NamedCondition<dim>> regions)
      : geometry(&geometry)
      , regions(std::move(regions))
    {}

    /// Those of the geometry.
    void
    add_parameters(dealii::ParameterHandler &) override
    {}

    /// Of both; a region must not have the name of something else.
    void check() const override;

    NamedBoundaries boundary_ids() const override;

    std::map<dealii::types::boundary_id, std::string>
    names_of_ids() const override;

    std::optional<dealii::BoundingBox<dim>>
    extent() const override
    {
      return geometry->extent();
    }

    /// Throws InputError for a region without a face, on every rank alike.
    void create(dealii::Triangulation<dim> &triangulation) const override;

    std::optional<double>
    n_coarse_cells() const override
    {
      return geometry->n_coarse_cells();
    }

    /// There a face belongs to a region when the condition holds anywhere on
    /// it, as far as is tried: its faces stand for several of this mesh. None
    /// is missed.
    std::unique_ptr<Geometry<dim>> coarser(double factor) const override;

    std::string
    about_mesh() const override
    {
      return geometry->about_mesh();
    }

    std::string
    hint_about_boundaries() const override
    {
      return geometry->hint_about_boundaries();
    }

    std::map<std::string, FlatPiece<dim>>
    named_places() const override
    {
      return geometry->named_places();
    }

    std::vector<FlatPiece<dim>>
    slits() const override
    {
      return geometry->slits();
    }

  private:
    using Id = dealii::types::boundary_id;

    /// All ids that the names of the geometry stand for, in order; what has
    /// none of them counts as one more.
    std::vector<Id> ids_of_geometry() const;

    /// What a face gets that has the id @p old, one of @p known or not.
    static Id new_id(std::size_t region, Id old, const std::vector<Id> &known);

    /// The last region that the face belongs to.
    template <typename Face>
    std::optional<std::size_t> region_of(const Face &face) const;

    void require_faces(const std::vector<dealii::Point<dim>> &centers,
                       const std::vector<bool>               &is_met,
                       const std::vector<bool>               &has_faces) const;

    std::unique_ptr<Geometry<dim>>   owned; ///< that of coarser()
    const Geometry<dim>             *geometry;
    std::vector<NamedCondition<dim>> regions;
    unsigned int                     n_tried = 1; ///< along an edge of a face
  };
} // namespace MixedCracks

#endif
