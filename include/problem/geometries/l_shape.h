// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_l_shape_h
#define mixed_cracks_problem_geometries_l_shape_h

#include <problem/geometries/plane_figure.h>

namespace MixedCracks
{
  /// The square [0, Size]^2 without its lower right quadrant. Boundaries:
  /// left, top, bottom (the foot of the left leg), right (the end of the
  /// upper leg); at the reentrant corner "reentrant horizontal" (under the
  /// upper leg) and "reentrant vertical" (right of the left leg).
  class LShape : public PlaneFigure
  {
  public:
    std::string subsection() const override;

    void add_parameters(dealii::ParameterHandler &prm) override;

    void check() const override;

    dealii::BoundingBox<2> extent() const override;

    void create(dealii::Triangulation<2> &plane) const override;

    double n_cells() const override;

    double n_grid_cells() const override;

    std::unique_ptr<PlaneFigure> coarser(double factor) const override;

    NamedBoundaries more_boundary_ids() const override;

  private:
    double size      = 500.;
    double cell_size = 25.;
  };
} // namespace MixedCracks

#endif
