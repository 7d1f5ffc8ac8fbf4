// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_elastic_kernel_h
#define mixed_cracks_assembly_elastic_kernel_h

#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <model/material.h>

#include <vector>

namespace MixedCracks
{
  /// Energy, residual and Jacobian of the elastic fields on one cell: the
  /// first two lines of (M5) for a given degradation. Works on local vectors
  /// only, per unit thickness.
  template <int dim>
  class ElasticKernel
  {
  public:
    ElasticKernel(const dealii::FiniteElement<dim> &element,
                  const dealii::Mapping<dim>       &mapping,
                  const dealii::Quadrature<dim>    &quadrature,
                  const Material<dim>              &material,
                  bool                              mixed);

    void reinit(const typename dealii::Triangulation<dim>::cell_iterator &cell);

    /// Evaluate strain, pressure and response at the quadrature points.
    /// @p local: values of the dofs of this cell; @p lagged_phase_field: one
    /// value per quadrature point.
    void set_state(const dealii::Vector<double> &local,
                   const std::vector<double>    &lagged_phase_field);

    /// As often as wanted after set_state(). Units: N/mm for the rows of the
    /// displacement, mm^2 for those of the pressure (in 2-d).
    void residual(dealii::Vector<double> &result) const;

    /// Derivative of residual() by the local values.
    void jacobian(dealii::FullMatrix<double> &result) const;

    /// Degraded elastic energy of the cell, N (mJ per mm thickness).
    double energy() const;

    /// Sizes of the terms that cancel in the residual, squared and summed
    /// over the dofs of the displacement and of the pressure: what a small
    /// residual has to be compared with.
    std::pair<double, double> squared_scale() const;

    /// What the Jacobian depends on at quadrature point @p q: degradation and
    /// branch of the split; see Material::branch().
    double
    degradation(const unsigned int q) const
    {
      return points[q].degradation;
    }

    int
    branch(const unsigned int q) const
    {
      return points[q].branch;
    }

    /// sigma+ : eps at quadrature point @p q, (M5) third line; MPa.
    double driving_force(unsigned int q) const;

    /// Averages over the cell for the output, undegraded strain included.
    struct CellAverages
    {
      dealii::SymmetricTensor<2, dim> stress;         ///< MPa, degraded
      double                          energy_density; ///< MPa, degraded
    };
    CellAverages averages() const;

    unsigned int
    n_quadrature_points() const
    {
      return fe_values.n_quadrature_points;
    }

  private:
    struct PointState
    {
      dealii::SymmetricTensor<2, dim> strain;
      double                          pressure;
      double                          degradation;
      int                             branch;
      ElasticResponse<dim>            response;
    };

    dealii::SymmetricTensor<2, dim> strain_of(unsigned int dof,
                                              unsigned int q) const;

    void displacement_block(unsigned int                q,
                            dealii::FullMatrix<double> &result) const;

    void pressure_blocks(unsigned int                q,
                         dealii::FullMatrix<double> &result) const;

    const Material<dim>      &material;
    const bool                mixed;
    dealii::FEValues<dim>     fe_values;
    std::vector<unsigned int> components;        // of each local dof
    std::vector<unsigned int> displacement_dofs; // local indices
    std::vector<unsigned int> pressure_dofs;
    std::vector<PointState>   points;
    // stress caused by each displacement dof, times the weight; work space
    mutable std::vector<dealii::SymmetricTensor<2, dim>> unit_stresses;
  };
} // namespace MixedCracks

#endif
