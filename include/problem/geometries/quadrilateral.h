// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_quadrilateral_h
#define mixed_cracks_problem_geometries_quadrilateral_h

#include <problem/geometries/plane_figure.h>

#include <array>

namespace MixedCracks
{
  /// A convex quadrilateral by its corners, counterclockwise from the lower
  /// left one, with the mesh that a bilinear map makes of a grid. Boundaries:
  /// bottom from the first corner to the second, then right, top, left.
  class Quadrilateral : public PlaneFigure
  {
  public:
    std::string subsection() const override;

    void add_parameters(dealii::ParameterHandler &prm) override;

    void check() const override;

    dealii::BoundingBox<2> extent() const override;

    void create(dealii::Triangulation<2> &plane) const override;

    double n_cells() const override;

    std::unique_ptr<PlaneFigure> coarser(double factor) const override;

  private:
    using Corners = std::array<dealii::Point<2>, 4>;

    /// mm; throws InputError when they cannot be read.
    Corners corners() const;

    /// Along bottom and top, along left and right.
    std::vector<unsigned int> cell_numbers() const;

    std::string corners_text = "0,0 ; 1,0 ; 1,1 ; 0,1";
    std::string cells        = "10, 10";
  };
} // namespace MixedCracks

#endif
