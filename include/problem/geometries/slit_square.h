// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_slit_square_h
#define mixed_cracks_problem_geometries_slit_square_h

#include <problem/geometry.h>

namespace MixedCracks
{
  /// The square [0, Size]^2 with a sharp horizontal slit from the left edge:
  /// the single-edge-notched specimen of [Miehe10] by default. Boundaries:
  /// left, right, bottom, top, and slit (both faces of it).
  template <int dim>
  class SlitSquare : public Geometry<dim>
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm) override;

    void check() const override;

    std::map<std::string, dealii::types::boundary_id>
    boundary_ids() const override;

    std::optional<dealii::BoundingBox<dim>> extent() const override;

    void create(dealii::Triangulation<dim> &triangulation) const override;

    std::map<std::string, dealii::Point<dim>> named_points() const override;

    std::vector<Segment<dim>> slits() const override;

  private:
    double size        = 1.;
    double slit_height = 0.5;
    double slit_length = 0.5;
    double cell_size   = 0.05;
  };
} // namespace MixedCracks

#endif
