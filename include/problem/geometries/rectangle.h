// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_rectangle_h
#define mixed_cracks_problem_geometries_rectangle_h

#include <problem/geometry.h>

namespace MixedCracks
{
  /// A box between two corners; "rectangle" in 2-d, "box" in 3-d. Boundaries:
  /// left, right, bottom, top, and in 3-d back (least z) and front.
  template <int dim>
  class Rectangle : public Geometry<dim>
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm) override;

    void check() const override;

    NamedBoundaries boundary_ids() const override;

    std::optional<dealii::BoundingBox<dim>> extent() const override;

    void create(dealii::Triangulation<dim> &triangulation) const override;

    std::optional<double> n_coarse_cells() const override;

    std::unique_ptr<Geometry<dim>> coarser(double factor) const override;

  private:
    dealii::Point<dim> lower_corner;
    dealii::Point<dim> upper_corner = unit_corner();
    double             cell_size    = dim == 2 ? 0.1 : 0.25;
    std::string        cells; // in each direction; empty: by cell size

    std::vector<unsigned int> n_cells() const;

    static dealii::Point<dim> unit_corner();
  };
} // namespace MixedCracks

#endif
