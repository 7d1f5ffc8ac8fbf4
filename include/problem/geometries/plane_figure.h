// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_plane_figure_h
#define mixed_cracks_problem_geometries_plane_figure_h

#include <problem/geometry.h>

namespace MixedCracks
{
  /// A figure in the plane: the part of a geometry that differs from one to
  /// the next. PlaneGeometry makes it a Geometry, in 3-d the same for every z.
  /// Its sides are left, right, bottom, top; lengths in mm.
  class PlaneFigure
  {
  public:
    virtual ~PlaneFigure() = default;

    /// "Geometry/…/", the subsection in the .prm.
    virtual std::string subsection() const = 0;

    /// The entries but for "Thickness cells"; the subsection is entered.
    virtual void add_parameters(dealii::ParameterHandler &prm) = 0;

    /// See Geometry::check().
    virtual void check() const = 0;

    virtual dealii::BoundingBox<2> extent() const = 0;

    /// The coarse mesh with boundary ids, in an empty triangulation.
    virtual void create(dealii::Triangulation<2> &plane) const = 0;

    /// How many cells the coarse mesh has, about; of the whole body where there
    /// is an own_thickness().
    virtual double n_cells() const = 0;

    /// The same of the grid that the figure is cut from: this is what is
    /// limited.
    virtual double
    n_grid_cells() const
    {
      return n_cells();
    }

    /// See Geometry::coarser().
    virtual std::unique_ptr<PlaneFigure> coarser(double factor) const = 0;

    /// Boundaries but for the sides; their ids count on from n_box_sides.
    virtual NamedBoundaries
    more_boundary_ids() const
    {
      return {};
    }

    /// See Geometry::named_places().
    virtual std::map<std::string, dealii::Point<2>>
    named_points() const
    {
      return {};
    }

    /// See Geometry::slits().
    virtual std::vector<Segment<2>>
    slits() const
    {
      return {};
    }

    /// A boundary that is a circle, so that refinement puts nodes on it.
    struct RoundHole
    {
      dealii::types::boundary_id boundary;
      dealii::Point<2>           center;
    };

    virtual std::optional<RoundHole>
    round_hole() const
    {
      return {};
    }

    /// How thick the body is in 3-d where the figure itself says it, and the
    /// heights of the layers of cells then; mm. Otherwise Material/Thickness
    /// and the entry "Thickness cells" do.
    virtual std::optional<double>
    own_thickness() const
    {
      return {};
    }

    virtual std::vector<double>
    own_layers() const
    {
      return {};
    }
  };
} // namespace MixedCracks

#endif
