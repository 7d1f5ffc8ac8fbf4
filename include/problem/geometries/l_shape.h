// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_l_shape_h
#define mixed_cracks_problem_geometries_l_shape_h

#include <problem/geometry.h>

namespace MixedCracks
{
  /// The square [0, Size]^2 without its lower right quadrant. Boundaries:
  /// left, top, bottom (the foot of the left leg), right (the end of the
  /// upper leg); at the reentrant corner "reentrant horizontal" (under the
  /// upper leg) and "reentrant vertical" (right of the left leg).
  template <int dim>
  class LShape : public Geometry<dim>
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm) override;

    void check() const override;

    std::map<std::string, dealii::types::boundary_id>
    boundary_ids() const override;

    std::optional<dealii::BoundingBox<dim>> extent() const override;

    void create(dealii::Triangulation<dim> &triangulation) const override;

  private:
    double size      = 500.;
    double cell_size = 25.;
  };
} // namespace MixedCracks

#endif
