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
  /// faces of the slit). In 3-d this times [0, thickness], with the boundaries
  /// back (z = 0) and front.
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

    std::optional<double> n_coarse_cells() const override;

    std::unique_ptr<Geometry<dim>> coarser(double factor) const override;

    std::map<std::string, FlatPiece<dim>> named_places() const override;

    std::vector<FlatPiece<dim>> slits() const override;

  private:
    void check_hole() const;

    void check_notch() const;

    /// The mesh in the plane, with boundary ids.
    void create_plane(dealii::Triangulation<2> &plane) const;

    void set_boundary_ids(dealii::Triangulation<2> &plane) const;

    void set_manifolds(dealii::Triangulation<dim> &triangulation) const;

    StripMeasures measures;
    unsigned int  thickness_cells = 1;
  };
} // namespace MixedCracks

#endif
