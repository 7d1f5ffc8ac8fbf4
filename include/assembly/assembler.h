// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_assembler_h
#define mixed_cracks_assembly_assembler_h

#include <assembly/cell_table.h>
#include <assembly/constants_table.h>
#include <assembly/elastic_kernel.h>
#include <assembly/elastic_tangent.h>
#include <assembly/phase_field_kernel.h>

#include <deal.II/base/function.h>

#include <deal.II/lac/affine_constraints.h>

#include <discretization/boundary_ids.h>
#include <discretization/fields.h>

#include <functional>
#include <map>

namespace MixedCracks
{
  /// What an elastic residual is to be measured with, and how far the state
  /// is from the one the matrix was built for.
  struct ElasticAssessment
  {
    double displacement_scale; ///< N/mm, compare the residual of u with it
    double pressure_scale;     ///< mm^2, that of p
    /// largest relative change of the degradation since the last matrix
    double degradation_change;
    /// number of quadrature points whose split changed its regime since then
    double regime_changes;
    /// at finite strain the largest change of F since then, relative to F
    double deformation_change;
  };

  /// Energies per mm of thickness (N), in 3-d in mJ.
  struct Energies
  {
    double elastic       = 0.;
    double crack         = 0.;
    double crack_surface = 0.; ///< integral of the crack density; mm, 3-d mm^2
    /// of all quadrature points the smallest det F, of the plane in 2-d; 1 at
    /// small strain
    double smallest_jacobian = 1.;
  };

  /// D = sigma+ : eps = 2 psi+, of Material::driving_force(), at the quadrature
  /// points of the owned cells, cell by cell; MPa.
  using DrivingForce = std::vector<double>;

  /// Cell averages for the output, one entry per active cell.
  template <int dim>
  struct CellData
  {
    std::map<std::string, dealii::Vector<float>> values;

    /// @p n_cells: number of active cells.
    void
    set(const std::string &name,
        const unsigned int n_cells,
        const unsigned int cell,
        const double       value)
    {
      dealii::Vector<float> &all = values[name];
      if (all.size() == 0)
        all.reinit(n_cells);
      all(cell) = static_cast<float>(value);
    }
  };

  /// The traction at a quadrature point of a face of the boundary.
  template <int dim>
  struct TractionPoint
  {
    dealii::Point<dim>     position; ///< before deformation, mm
    dealii::Tensor<1, dim> normal;   ///< outward, before deformation
    dealii::Tensor<1, dim> traction; ///< per undeformed area, MPa
    double                 area;     ///< mm^2, in 2-d per mm of thickness: mm
  };

  /// The parallel loops over the cells. All vectors that are read have
  /// ghosts, all that are written have none. Collective.
  template <int dim>
  class Assembler
  {
  public:
    using Vector      = LinearAlgebra::Vector;
    using Constraints = dealii::AffineConstraints<double>;

    /// @p constants_at: the constants of the material where they vary; empty:
    /// those of its description.
    Assembler(const Fields<dim>     &fields,
              const Material<dim>   &material,
              ConstantsFunction<dim> constants_at = {});

    /// Before the first use, and when the mesh changed. Throws the InputError
    /// of constants_at on all ranks.
    void reinit();

    /// (g sigma+ + sigma-, eps(w)) and the constraint of p, the first two lines
    /// of (M5), with g = g(phi~). elastic_matrix() and driving_force() are
    /// those of the state of the last call.
    ElasticAssessment elastic_residual(const Vector      &elastic,
                                       const Vector      &lagged_phase_field,
                                       const Constraints &constraints,
                                       Vector            &residual);

    /// Their Jacobian. @p matrix holds the one of the last call, if there was
    /// one since reinit(): where few cells changed, only these are added.
    void elastic_matrix(const Constraints           &constraints,
                        LinearAlgebra::SparseMatrix &matrix);

    /// For products without a matrix: tangents() are those of the last
    /// elastic_residual(), and distances those from the present state.
    void
    note_matrix()
    {
      tangent.note_matrix(/*was_corrected=*/false, /*keeps_points=*/false);
    }

    bool
    is_finite() const
    {
      return material.is_finite();
    }

    bool
    elastic_matrix_is_symmetric() const
    {
      return elastic_kernel.jacobian_is_symmetric();
    }

    /// Of owned cell number @p cell the responses at the quadrature points, in
    /// the state of the last elastic_matrix(); until the next call.
    const std::vector<ElasticResponse<dim>> &tangents(unsigned int cell);

    unsigned int
    n_cells() const
    {
      return cells->n_cells();
    }

    const CellGeometry<dim> &
    geometry(const unsigned int cell) const
    {
      return cells->geometry(cell);
    }

    /// What one owned cell adds to the matrix, in that state.
    void cell_jacobian(unsigned int cell, dealii::FullMatrix<double> &result);

    /// Call @p body with number and state of every owned cell.
    void visit_states(
      const Vector     &elastic,
      const Vector     &lagged_phase_field,
      ElasticEvaluation wanted,
      const std::function<void(unsigned int, const ElasticKernel<dim> &)>
        &body);

    /// For what does not depend on the cell.
    const ElasticKernel<dim> &
    kernel() const
    {
      return elastic_kernel;
    }

    /// Positions of the dofs of the cells that are visited.
    CellDofs<dim> &
    elastic_dofs()
    {
      return cells->elastic;
    }

    /// Of the state of the last elastic_residual() the Jacobian times
    /// @p direction, whose hanging nodes fit: in all rows and with all columns,
    /// those of prescribed dofs among them.
    void tangent_times(const Vector      &direction,
                       const Constraints &hanging_nodes,
                       Vector            &result);

    /// Of all quadrature points the smallest det F, of the plane in 2-d; 1 at
    /// small strain. Not above 0: cells are turned inside out.
    double smallest_determinant(const Vector &elastic,
                                const Vector &lagged_phase_field);

    /// Above 0 in @p marks, a phase field without ghosts, at the nodes of cells
    /// that are turned inside out; 0 elsewhere.
    void mark_inside_out(const Vector      &elastic,
                         const Vector      &lagged_phase_field,
                         const Constraints &hanging_nodes,
                         Vector            &marks);

    /// Of (u, p) with the degradation of @p lagged_phase_field, by the law; N
    /// (mJ per mm thickness).
    double stored_energy(const Vector &elastic,
                         const Vector &lagged_phase_field);

    /// Nodal forces of a body force (N/mm^3) and of tractions (MPa) by
    /// boundary id, per mm thickness, added to @p forces.
    void external_forces(
      const dealii::Function<dim> *body_force,
      const std::map<dealii::types::boundary_id, const dealii::Function<dim> *>
                        &tractions,
      const Constraints &constraints,
      Vector            &forces) const;

    /// Of the state of the last elastic_residual(), whose strains and
    /// pressures need not be evaluated again for it.
    DrivingForce driving_force() const;

    /// (g'/2 D + G_c/l a', psi) + (2 b G_c l grad phi, grad psi), the third
    /// line of (M5), and, unless @p matrix is null, its Jacobian.
    void phase_field_system(const Vector                &phase_field,
                            const DrivingForce          &driving_force,
                            const Constraints           &constraints,
                            Vector                      &residual,
                            LinearAlgebra::SparseMatrix *matrix);

    void lumped_mass(const Constraints &constraints, Vector &mass);

    /// The lumped mass weighted with G_c.
    void lumped_release_rate(const Constraints &constraints, Vector &sum);

    bool
    constants_vary() const
    {
      return static_cast<bool>(constants_at);
    }

    /// Those of @p elastic and @p phase_field. @p lagged_phase_field: the one
    /// that the pressures of @p elastic were solved with.
    Energies energies(const Vector &elastic,
                      const Vector &lagged_phase_field,
                      const Vector &phase_field);

    /// Stresses that are in equilibrium, of @p lagged_phase_field, and the
    /// energy density of @p phase_field, whose integral is in energies().
    CellData<dim> cell_data(const Vector &elastic,
                            const Vector &lagged_phase_field,
                            const Vector &phase_field);

    /// Of the stresses that are in equilibrium with @p lagged_phase_field, on
    /// the faces of this rank. Throws the InputError of constants_at on all
    /// ranks.
    std::vector<TractionPoint<dim>>
    tractions(const BoundaryIds &boundary,
              const Vector      &elastic,
              const Vector      &lagged_phase_field) const;

  private:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    void load_elastic(unsigned int      cell,
                      const Vector     &elastic,
                      const Vector     &lagged_phase_field,
                      ElasticEvaluation wanted);

    /// Add averages of the state of one cell.
    void add_averages(const typename ElasticKernel<dim>::CellAverages &averages,
                      unsigned int                                     index,
                      CellData<dim> &data) const;

    /// Add averages of the constants of one cell.
    void add_constants(unsigned int   cell,
                       unsigned int   index,
                       CellData<dim> &data) const;

    const Fields<dim>           &fields;
    const Material<dim>         &material;
    const ConstantsFunction<dim> constants_at;

    std::unique_ptr<CellTable<dim>>      cells;
    std::unique_ptr<ConstantsTable<dim>> constants;
    ElasticKernel<dim>                   elastic_kernel;
    PhaseFieldKernel<dim>                phase_field_kernel;

    // local work space
    dealii::Vector<double>                       local_elastic;
    dealii::Vector<double>                       local_phase_field;
    std::vector<double>                          lagged_values;
    std::vector<double>                          phase_field_values;
    std::vector<dealii::types::global_dof_index> elastic_indices;
    std::vector<dealii::types::global_dof_index> phase_field_indices;

    // states of the last residual and of the last matrix
    ElasticTangent<dim> tangent;
  };
} // namespace MixedCracks

#endif
