// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_punctured_strip_h
#define mixed_cracks_problem_geometries_punctured_strip_h

#include <problem/geometries/plane_figure.h>
#include <problem/geometries/strip_mesh.h>

namespace MixedCracks
{
  /// The strip [0, Width] x [0, Height] with a circular hole and a sharp
  /// notch from the left edge, either or both of them absent [Mang21,
  /// Section 4]. Boundaries: left, right, bottom, top, hole, and notch (both
  /// faces of the slit; notch lower, notch upper).
  class PuncturedStrip : public PlaneFigure
  {
  public:
    std::string subsection() const override;

    void add_parameters(dealii::ParameterHandler &prm) override;

    void check() const override;

    dealii::BoundingBox<2> extent() const override;

    void create(dealii::Triangulation<2> &plane) const override;

    double n_cells() const override;

    std::unique_ptr<PlaneFigure> coarser(double factor) const override;

    NamedBoundaries more_boundary_ids() const override;

    std::map<std::string, dealii::Point<2>> named_points() const override;

    std::vector<Segment<2>> slits() const override;

    std::optional<RoundHole> round_hole() const override;

  private:
    void check_hole() const;

    void check_notch() const;

    void set_boundary_ids(dealii::Triangulation<2> &plane) const;

    StripMeasures measures;
  };
} // namespace MixedCracks

#endif
