// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_quadrilateral_h
#define mixed_cracks_problem_geometries_quadrilateral_h

#include <problem/geometry.h>

#include <array>

namespace MixedCracks
{
  /// A convex quadrilateral by its corners, counterclockwise from the lower
  /// left one, with the mesh that a bilinear map makes of a grid. Boundaries:
  /// bottom from the first corner to the second, then right, top, left. In 3-d
  /// this times [0, thickness], with the boundaries back (z = 0) and front.
  template <int dim>
  class Quadrilateral : public Geometry<dim>
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
    using Corners = std::array<dealii::Point<2>, 4>;

    /// mm; throws InputError when they cannot be read.
    Corners corners() const;

    /// Along bottom and top, along left and right.
    std::vector<unsigned int> n_cells() const;

    /// The mesh in the plane, with boundary ids.
    void create_plane(dealii::Triangulation<2> &plane) const;

    std::string  corners_text    = "0,0 ; 1,0 ; 1,1 ; 0,1";
    std::string  cells           = "10, 10";
    unsigned int thickness_cells = 1;
  };
} // namespace MixedCracks

#endif
