// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_slit_square_h
#define mixed_cracks_problem_geometries_slit_square_h

#include <problem/geometries/mirrored_mesh.h>
#include <problem/geometries/plane_figure.h>

namespace MixedCracks
{
  /// The square [0, Size]^2 with a sharp horizontal slit from the left edge:
  /// the single-edge-notched specimen of [Miehe10b] by default. In 3-d the cube
  /// [0, Size]^3 with that slit through all of its depth. Boundaries: left,
  /// right, bottom, top, slit (both faces of it; slit lower, slit upper), and
  /// in 3-d back (z = 0) and front.
  class SlitSquare : public PlaneFigure
  {
  public:
    /// In 3-d it is a cube, with other words and another default.
    explicit SlitSquare(const unsigned int dim)
      : dim(dim)
      , cell_size(dim == 2 ? 0.05 : 0.25)
    {}

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

    std::optional<double> own_thickness() const override;

    std::vector<double> own_layers() const override;

  private:
    /// The lines of x and of y that the mesh must have.
    std::array<std::vector<double>, 2> fixed_lines() const;

    unsigned int dim;
    double       size        = 1.;
    double       slit_height = 0.5;
    double       slit_length = 0.5;
    double       cell_size;
    MirroredMesh mirrored;
  };
} // namespace MixedCracks

#endif
