// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_punctured_strip_h
#define mixed_cracks_problem_geometries_punctured_strip_h

#include <problem/geometries/strip_mesh.h>
#include <problem/geometry.h>

namespace MixedCracks
{
  /// The strip [0, Width] x [0, Height] with a circular hole and a sharp
  /// notch from the left edge, either or both of them absent [Mang21,
  /// Section 4]. Boundaries: left, right, bottom, top, hole, and notch (both
  /// faces of the slit).
  template <int dim>
  class PuncturedStrip : public Geometry<dim>
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
    void check_hole() const;

    void check_notch() const;

    void set_boundary_ids(dealii::Triangulation<dim> &triangulation) const;

    void set_manifolds(dealii::Triangulation<dim> &triangulation) const;

    StripMeasures measures;
  };
} // namespace MixedCracks

#endif
