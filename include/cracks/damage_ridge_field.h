// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_damage_ridge_field_h
#define mixed_cracks_cracks_damage_ridge_field_h

#include <base/linear_algebra.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/base/symmetric_tensor.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <discretization/fields.h>

#include <array>
#include <memory>
#include <vector>

namespace MixedCracks
{
  /// Smoothed damage and its derivatives at the nodes of damaged cells. Each
  /// rank has those of its cells and of the cells around them. Collective.
  class RidgeField
  {
  public:
    /// A cell with damage, min phi < 0.9; own ones and those of neighbours.
    struct Cell
    {
      dealii::DoFHandler<3>::active_cell_iterator cell;
      std::array<unsigned int, 8>                 nodes; ///< of deal.II's order
      /// of the map to the unit cell at its center, transposed; 1/mm
      dealii::Tensor<2, 3> to_gradient;
      dealii::Point<3>     center; ///< mm, the mean of the vertices
      double               volume; ///< mm^3
    };

    /// @p length_scale: l, mm. Nothing is smoothed yet.
    RidgeField(const Fields<3>             &fields,
               const LinearAlgebra::Vector &phase_field,
               double                       length_scale);

    /// Smooth, and find the derivatives.
    void differentiate();

    /// Of the smoothed damage at a node, 1/mm; of the vertex order.
    dealii::Tensor<1, 3> gradient(unsigned int node) const;

    /// The second derivatives, 1/mm^2.
    dealii::SymmetricTensor<2, 3> hessian(unsigned int node) const;

    std::vector<Cell> cells;
    /// mm: of the smallest damaged cell of all ranks; 0 without any
    double cell_size = 0.;

  private:
    using Values = dealii::LinearAlgebra::distributed::Vector<double>;

    void add_cell(const dealii::DoFHandler<3>::active_cell_iterator &cell);
    void find_offsets();

    /// The mean over the cells around each node of what @p of_cell says of a
    /// cell, weighted with their volumes; less what @p slope, which may be
    /// @p values themselves, rises from the node to the center of these cells.
    template <typename OfCell>
    void average(const OfCell &of_cell,
                 Values       &values,
                 const Values *slope = nullptr) const;

    dealii::Tensor<1, 3> gradient_in(const Cell   &cell,
                                     const Values &values) const;

    const double                                               length_scale;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> nodes;
    std::vector<double> volumes; ///< of the cells around own nodes
    /// from own nodes to the center of these cells, mm
    std::vector<dealii::Tensor<1, 3>> offsets;
    Values                            damage;
    std::array<Values, 3>             first;
    std::array<Values, 6>             second; ///< xx, yy, zz, xy, xz, yz
  };
} // namespace MixedCracks

#endif
