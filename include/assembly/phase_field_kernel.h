// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_phase_field_kernel_h
#define mixed_cracks_assembly_phase_field_kernel_h

#include <assembly/cell_geometry.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <model/material.h>

#include <vector>

namespace MixedCracks
{
  /// Energy, residual and Jacobian of the phase field on one cell,
  ///
  ///   (g'(phi)/2 D + G_c/l a'(phi), psi)
  ///     + (2 b G_c l grad phi, grad psi) >= 0,
  ///
  /// the third line of (M5) for a given D = 2 psi+. Local vectors only, per
  /// unit thickness. The .cc has the matrix.
  template <int dim>
  class PhaseFieldKernel
  {
  public:
    PhaseFieldKernel(const dealii::FiniteElement<dim> &element,
                     const dealii::Quadrature<dim>    &quadrature,
                     const Material<dim>              &material);

    /// @p geometry and @p constants must stay until the next call.
    void reinit(const CellGeometry<dim> &geometry,
                const CellConstants     &constants);

    /// With constants that are the same everywhere.
    void
    reinit(const CellGeometry<dim> &geometry)
    {
      reinit(geometry, CellConstants(material.uniform_constants()));
    }

    /// Phase field at the quadrature points from the dofs of this cell.
    void interpolate(const dealii::Vector<double> &local,
                     std::vector<double>          &values) const;

    /// @p driving_force: D = sigma+ : eps = 2 psi+ at the first quadrature
    /// point, those at the others follow; MPa.
    void set_state(const dealii::Vector<double> &local,
                   const double                 *driving_force);

    /// r_i, N per node (in 3-d mJ): energy density times area, over phi.
    void residual(dealii::Vector<double> &result) const;

    /// Derivative of residual() by the local values.
    void jacobian(dealii::FullMatrix<double> &result) const;

    /// G_c times the crack surface of the cell, N (mJ per mm thickness).
    double energy() const;

    /// The crack surface of the cell, the integral of the crack density: mm (in
    /// 3-d mm^2).
    double crack_surface() const;

    /// Integrals of the shape functions: the lumped mass matrix, mm^2.
    void lumped_mass(dealii::Vector<double> &result) const;

    /// Integrals of G_c times the shape functions: N mm (in 2-d).
    void lumped_release_rate(dealii::Vector<double> &result) const;

  private:
    struct PointState
    {
      double                 phase_field;
      dealii::Tensor<1, dim> gradient;
      double                 driving_force;
    };

    /// The crack density at a quadrature point, 1/mm.
    double density_at(unsigned int q) const;

    const Material<dim>     &material;
    ScalarShapes<dim>        shapes;
    const CellGeometry<dim> *geometry = nullptr;
    CellConstants            constants;
    std::vector<PointState>  points;
  };
} // namespace MixedCracks

#endif
