// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_slit_square_h
#define mixed_cracks_problem_geometries_slit_square_h

#include <problem/geometry.h>

namespace MixedCracks
{
  /// The square [0, Size]^2 with a sharp horizontal slit from the left edge:
  /// the single-edge-notched specimen of [Miehe10] by default. In 3-d the cube
  /// [0, Size]^3 with that slit through all of its depth. Boundaries: left,
  /// right, bottom, top, slit (both faces of it), and in 3-d back (z = 0) and
  /// front.
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

    std::optional<double> n_coarse_cells() const override;

    std::unique_ptr<Geometry<dim>> coarser(double factor) const override;

    std::map<std::string, FlatPiece<dim>> named_places() const override;

    std::vector<FlatPiece<dim>> slits() const override;

  private:
    /// The mesh of the square, with boundary ids.
    void create_square(dealii::Triangulation<2> &square) const;

    double size        = 1.;
    double slit_height = 0.5;
    double slit_length = 0.5;
    double cell_size   = dim == 2 ? 0.05 : 0.25;
  };
} // namespace MixedCracks

#endif
