// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_plane_geometry_h
#define mixed_cracks_problem_geometries_plane_geometry_h

#include <problem/geometries/plane_figure.h>

#include <utility>

namespace MixedCracks
{
  /// A figure in the plane; in 3-d this times [0, thickness], with the
  /// boundaries back (z = 0) and front.
  template <int dim>
  class PlaneGeometry : public Geometry<dim>
  {
  public:
    explicit PlaneGeometry(std::unique_ptr<PlaneFigure> figure)
      : figure(std::move(figure))
    {}

    /// @p other with a coarse mesh of cells that are @p factor times as long.
    PlaneGeometry(const PlaneGeometry &other, double factor);

    void add_parameters(dealii::ParameterHandler &prm) override;

    void check() const override;

    NamedBoundaries boundary_ids() const override;

    std::optional<dealii::BoundingBox<dim>> extent() const override;

    void create(dealii::Triangulation<dim> &triangulation) const override;

    std::optional<double>
    n_coarse_cells() const override
    {
      return figure->n_cells() * (dim == 3 ? thickness_cells : 1.);
    }

    std::unique_ptr<Geometry<dim>>
    coarser(const double factor) const override
    {
      return std::make_unique<PlaneGeometry>(*this, factor);
    }

    std::map<std::string, FlatPiece<dim>> named_places() const override;

    std::vector<FlatPiece<dim>> slits() const override;

  private:
    /// In z, mm.
    double
    depth() const
    {
      return figure->own_thickness().value_or(this->thickness());
    }

    std::unique_ptr<PlaneFigure> figure;
    unsigned int                 thickness_cells = 1;
  };
} // namespace MixedCracks

#endif
