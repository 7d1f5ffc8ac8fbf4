// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_assembler_h
#define mixed_cracks_assembly_assembler_h

#include <assembly/elastic_kernel.h>
#include <assembly/phase_field_kernel.h>

#include <deal.II/base/function.h>

#include <deal.II/lac/affine_constraints.h>

#include <discretization/fields.h>

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
    /// number of quadrature points whose split changed its branch since then
    double branch_changes;
  };

  /// Energies per mm of thickness (N).
  struct Energies
  {
    double elastic = 0.;
    double crack   = 0.;
  };

  /// Cell averages for the output, one entry per active cell.
  template <int dim>
  struct CellData
  {
    std::map<std::string, dealii::Vector<float>> values;
  };

  /// The parallel loops over the cells. All vectors that are read have
  /// ghosts, all that are written have none. Collective.
  template <int dim>
  class Assembler
  {
  public:
    using Vector      = LinearAlgebra::Vector;
    using Constraints = dealii::AffineConstraints<double>;

    Assembler(const Fields<dim> &fields, const Material<dim> &material);

    /// To be called when the mesh changed: no matrix is known any more.
    void reinit();

    /// First two lines of (M5).
    ElasticAssessment elastic_residual(const Vector      &elastic,
                                       const Vector      &lagged_phase_field,
                                       const Constraints &constraints,
                                       Vector            &residual);

    /// Their Jacobian; remembers the state it is built for.
    void elastic_matrix(const Vector                &elastic,
                        const Vector                &lagged_phase_field,
                        const Constraints           &constraints,
                        LinearAlgebra::SparseMatrix &matrix);

    /// Nodal forces of a body force (N/mm^3) and of tractions (MPa) by
    /// boundary id, per mm thickness, added to @p forces.
    void external_forces(
      const dealii::Function<dim> *body_force,
      const std::map<dealii::types::boundary_id, const dealii::Function<dim> *>
                        &tractions,
      const Constraints &constraints,
      Vector            &forces) const;

    /// Third line of (M5) and, unless @p matrix is null, its Jacobian.
    void phase_field_system(const Vector                &elastic,
                            const Vector                &lagged_phase_field,
                            const Vector                &phase_field,
                            const Constraints           &constraints,
                            Vector                      &residual,
                            LinearAlgebra::SparseMatrix *matrix);

    void lumped_mass(const Constraints &constraints, Vector &mass);

    Energies energies(const Vector &elastic,
                      const Vector &lagged_phase_field,
                      const Vector &phase_field);

    CellData<dim> cell_data(const Vector &elastic,
                            const Vector &lagged_phase_field);

  private:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    template <typename Body>
    void for_each_cell(const Body &body) const;

    void load_elastic(const Cell   &elastic_cell,
                      const Cell   &phase_field_cell,
                      const Vector &elastic,
                      const Vector &lagged_phase_field);

    /// Distance of the loaded state to that of the last matrix, or, with
    /// @p remember, make it that.
    void compare_tangent(unsigned int       cell,
                         bool               remember,
                         ElasticAssessment &assessment);

    const Fields<dim>    &fields;
    ElasticKernel<dim>    elastic_kernel;
    PhaseFieldKernel<dim> phase_field_kernel;

    // local work space
    dealii::Vector<double>                       local_elastic;
    dealii::Vector<double>                       local_phase_field;
    std::vector<double>                          lagged_values;
    std::vector<dealii::types::global_dof_index> elastic_indices;
    std::vector<dealii::types::global_dof_index> phase_field_indices;

    // the state of the last matrix, per cell and quadrature point
    std::vector<double> matrix_degradation;
    std::vector<int>    matrix_branch;
  };
} // namespace MixedCracks

#endif
