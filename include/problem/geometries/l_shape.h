// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_l_shape_h
#define mixed_cracks_problem_geometries_l_shape_h

#include <problem/geometry.h>

namespace MixedCracks
{
  /// The square [0, Size]^2 without its lower right quadrant. Boundaries:
  /// left, top, bottom (the foot of the left leg), right (the end of the
  /// upper leg); at the reentrant corner "reentrant horizontal" (under the
  /// upper leg) and "reentrant vertical" (right of the left leg). In 3-d this
  /// times [0, thickness], with the boundaries back (z = 0) and front.
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

    std::optional<double> n_coarse_cells() const override;

    std::unique_ptr<Geometry<dim>> coarser(double factor) const override;

  private:
    /// The mesh in the plane, with boundary ids.
    void create_plane(dealii::Triangulation<2> &plane) const;

    double       size            = 500.;
    double       cell_size       = 25.;
    unsigned int thickness_cells = 1;
  };
} // namespace MixedCracks

#endif
