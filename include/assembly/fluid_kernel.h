// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_fluid_kernel_h
#define mixed_cracks_assembly_fluid_kernel_h

#include <assembly/cell_geometry.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace MixedCracks
{
  /// The load, (M10), of a given fluid pressure p_f in the cracks on one cell:
  /// potential energy, residuals and Jacobian of
  ///
  ///   E_f(u, phi) = - integral of p_f u . grad(phi^2),
  ///
  /// minus the pressure times the volume between the crack faces, so that a
  /// positive pressure opens. By the divergence theorem it is the integral of
  /// phi^2 (p_f div u + grad p_f . u) [Mikelic, Wheeler, Wick 2015] less
  /// phi^2 p_f u . n on the outer boundary: in this form the fluid acts on
  /// crack faces alone, supports and free boundaries do not feel it, and no
  /// derivative of p_f is needed. E_f is linear in u. Works on local vectors
  /// only, per unit thickness.
  template <int dim>
  class FluidKernel
  {
  public:
    /// @p elastic: displacement first, see Fields.
    FluidKernel(const dealii::FiniteElement<dim> &elastic,
                const dealii::FiniteElement<dim> &phase_field,
                const dealii::Quadrature<dim>    &quadrature);

    /// @p geometry must stay until the next call.
    void reinit(const CellGeometry<dim> &geometry);

    /// @p first: the pressure at the first quadrature point, those at the
    /// others follow; MPa. Kept by address until the next call.
    void set_pressure(const double *first);

    /// From the dofs of this cell.
    void set_phase_field(const dealii::Vector<double> &local);

    /// From the elastic dofs of this cell.
    void set_displacement(const dealii::Vector<double> &local);

    /// E_f of the cell, N (mJ per mm thickness).
    double energy() const;

    /// Forces on the nodes: minus the derivative of energy() by the elastic
    /// dofs, 0 for those of the pressure; N/mm. Does not need the
    /// displacement.
    void nodal_forces(dealii::Vector<double> &result) const;

    /// Derivative of energy() by the dofs of the phase field, N.
    void phase_field_residual(dealii::Vector<double> &result) const;

    /// Derivative of phase_field_residual() by the same; symmetric.
    void phase_field_jacobian(dealii::FullMatrix<double> &result) const;

  private:
    struct PointState
    {
      double                 phase_field;
      dealii::Tensor<1, dim> gradient;     ///< of the phase field, 1/mm
      dealii::Tensor<1, dim> displacement; ///< mm
    };

    ScalarShapes<dim>        displacement_shapes;
    ScalarShapes<dim>        phase_field_shapes;
    const CellGeometry<dim> *geometry = nullptr;
    const double            *pressure = nullptr;
    std::vector<PointState>  points;
    // local index of component d of node a: displacement_dofs[a][d]
    std::vector<std::array<unsigned int, dim>> displacement_dofs;
  };
} // namespace MixedCracks

#endif
