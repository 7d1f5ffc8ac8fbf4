// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_cell_geometry_h
#define mixed_cracks_assembly_cell_geometry_h

#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace MixedCracks
{
  /// What the kernels need to know about the shape of one cell, at its
  /// quadrature points. Computed once per mesh: a load step visits every cell
  /// many times.
  template <int dim>
  struct CellGeometry
  {
    std::vector<double> weights; ///< quadrature weight times |J|, mm^dim
    /// d(reference coordinate i)/d(x_j), 1/mm
    std::vector<dealii::Tensor<2, dim>> inverse_jacobians;

    double volume() const;
  };

  /// Makes the geometry of one cell after the other.
  template <int dim>
  class GeometryEvaluator
  {
  public:
    GeometryEvaluator(const dealii::Mapping<dim>    &mapping,
                      const dealii::Quadrature<dim> &quadrature);

    CellGeometry<dim>
    operator()(const typename dealii::Triangulation<dim>::cell_iterator &cell);

  private:
    dealii::FE_Nothing<dim> no_shapes;
    dealii::FEValues<dim>   fe_values;
  };

  /// Values and gradients of scalar shape functions at the quadrature points
  /// of one cell.
  template <int dim>
  class ScalarShapes
  {
  public:
    ScalarShapes(const dealii::FiniteElement<dim> &element,
                 const dealii::Quadrature<dim>    &quadrature);

    /// Transform the gradients to this cell.
    void reinit(const CellGeometry<dim> &geometry);

    unsigned int
    size() const
    {
      return n_shapes;
    }

    double
    value(const unsigned int shape, const unsigned int q) const
    {
      return values[q * n_shapes + shape];
    }

    /// 1/mm
    const dealii::Tensor<1, dim> &
    gradient(const unsigned int shape, const unsigned int q) const
    {
      return gradients[q * n_shapes + shape];
    }

  private:
    unsigned int                        n_shapes;
    std::vector<double>                 values;
    std::vector<dealii::Tensor<1, dim>> reference_gradients;
    std::vector<dealii::Tensor<1, dim>> gradients;
  };
} // namespace MixedCracks

#endif
