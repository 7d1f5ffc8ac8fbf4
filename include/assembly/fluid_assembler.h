// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_fluid_assembler_h
#define mixed_cracks_assembly_fluid_assembler_h

#include <assembly/cell_table.h>
#include <assembly/fluid_kernel.h>

#include <deal.II/base/function.h>

#include <deal.II/lac/affine_constraints.h>

#include <discretization/fields.h>

#include <memory>
#include <vector>

namespace MixedCracks
{
  /// The load of a given fluid pressure in the cracks (M10), summed over the
  /// cells: FluidKernel says what it is. Vectors that are read have ghosts,
  /// those that are written have none. Collective. Throws InputError, on all
  /// ranks, where the pressure is not finite.
  template <int dim>
  class FluidAssembler
  {
  public:
    using Vector      = LinearAlgebra::Vector;
    using Constraints = dealii::AffineConstraints<double>;

    /// @p pressure: p_f, one component, MPa; its time will be set.
    FluidAssembler(const Fields<dim>                     &fields,
                   std::shared_ptr<dealii::Function<dim>> pressure);

    /// Before the first use, and when the mesh changed.
    void reinit();

    /// Nodal forces at @p time (s) on the displacement for a given phase
    /// field, N/mm, added to @p forces.
    void add_nodal_forces(double             time,
                          const Vector      &phase_field,
                          const Constraints &constraints,
                          Vector            &forces);

    /// What the fluid adds to the residual of the phase field and, unless
    /// @p matrix is null, to its Jacobian.
    void add_phase_field_system(double                       time,
                                const Vector                &elastic,
                                const Vector                &phase_field,
                                const Constraints           &constraints,
                                Vector                      &residual,
                                LinearAlgebra::SparseMatrix *matrix);

    /// E_f = - integral of p_f u . grad(phi^2), N (mJ per mm thickness).
    double
    energy(double time, const Vector &elastic, const Vector &phase_field);

  private:
    /// What the mesh alone decides.
    struct Cells
    {
      explicit Cells(const Fields<dim> &fields);

      CellDofs<dim>                   elastic;
      CellDofs<dim>                   phase_field;
      std::vector<CellGeometry<dim>>  geometries;
      std::vector<dealii::Point<dim>> points; ///< of the quadrature, by cell
    };

    /// Evaluate the pressure at all points, unless it was at this time.
    void set_time(double time);

    /// Give the kernel an owned cell with the phase field.
    void load(unsigned int cell, const Vector &phase_field);

    const Fields<dim>                           &fields;
    const std::shared_ptr<dealii::Function<dim>> pressure;
    FluidKernel<dim>                             kernel;
    std::unique_ptr<Cells>                       cells;
    std::vector<double>                          pressures; // at cells->points
    double                                       time_of_pressures = 0.;

    // local work space
    dealii::Vector<double> local_elastic;
    dealii::Vector<double> local_phase_field;
  };
} // namespace MixedCracks

#endif
