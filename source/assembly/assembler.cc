// SPDX-License-Identifier: GPL-2.0-or-later
#include <assembly/assembler.h>

#include <deal.II/base/mpi.h>

#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  Assembler<dim>::Assembler(const Fields<dim>   &fields,
                            const Material<dim> &material)
    : fields(fields)
    , elastic_kernel(fields.elastic.get_fe(),
                     fields.mapping,
                     fields.quadrature,
                     material,
                     fields.layout.mixed)
    , phase_field_kernel(fields.phase_field.get_fe(),
                         fields.mapping,
                         fields.quadrature,
                         material)
    , local_elastic(fields.elastic.get_fe().n_dofs_per_cell())
    , local_phase_field(fields.phase_field.get_fe().n_dofs_per_cell())
    , elastic_indices(local_elastic.size())
    , phase_field_indices(local_phase_field.size())
  {
    reinit();
  }



  template <int dim>
  void
  Assembler<dim>::reinit()
  {
    const std::size_t n_points =
      static_cast<std::size_t>(
        fields.elastic.get_triangulation().n_active_cells()) *
      fields.quadrature.size();
    // no degradation is as far off as this one
    matrix_degradation.assign(n_points, std::numeric_limits<double>::max());
    matrix_branch.assign(n_points, -1);
  }



  template <int dim>
  template <typename Body>
  void
  Assembler<dim>::for_each_cell(const Body &body) const
  {
    for (const Cell &cell : fields.elastic.active_cell_iterators())
      if (cell->is_locally_owned())
        body(cell,
             Cell(&fields.elastic.get_triangulation(),
                  cell->level(),
                  cell->index(),
                  &fields.phase_field));
  }



  template <int dim>
  void
  Assembler<dim>::load_elastic(const Cell   &elastic_cell,
                               const Cell   &phase_field_cell,
                               const Vector &elastic,
                               const Vector &lagged_phase_field)
  {
    elastic_kernel.reinit(elastic_cell);
    elastic_cell->get_dof_values(elastic, local_elastic);
    phase_field_cell->get_dof_values(lagged_phase_field, local_phase_field);
    phase_field_kernel.interpolate(local_phase_field, lagged_values);
    elastic_kernel.set_state(local_elastic, lagged_values);
  }



  template <int dim>
  void
  Assembler<dim>::compare_tangent(const unsigned int cell,
                                  const bool         remember,
                                  ElasticAssessment &assessment)
  {
    for (unsigned int q = 0; q < elastic_kernel.n_quadrature_points(); ++q)
    {
      const std::size_t at =
        static_cast<std::size_t>(cell) * fields.quadrature.size() + q;
      const double degradation = elastic_kernel.degradation(q);
      const int    branch      = elastic_kernel.branch(q);
      assessment.degradation_change =
        std::max(assessment.degradation_change,
                 std::abs(degradation - matrix_degradation[at]) /
                   std::min(degradation, matrix_degradation[at]));
      if (branch < 0 || branch != matrix_branch[at])
        assessment.branch_changes += 1.;
      if (remember)
      {
        matrix_degradation[at] = degradation;
        matrix_branch[at]      = branch;
      }
    }
  }



  template <int dim>
  ElasticAssessment
  Assembler<dim>::elastic_residual(const Vector      &elastic,
                                   const Vector      &lagged_phase_field,
                                   const Constraints &constraints,
                                   Vector            &residual)
  {
    residual = 0.;
    ElasticAssessment      assessment{0., 0., 0., 0.};
    dealii::Vector<double> local(local_elastic.size());
    for_each_cell([&](const Cell &cell, const Cell &phase_field_cell) {
      load_elastic(cell, phase_field_cell, elastic, lagged_phase_field);
      elastic_kernel.residual(local);
      const auto [displacement, pressure] = elastic_kernel.squared_scale();
      assessment.displacement_scale += displacement;
      assessment.pressure_scale += pressure;
      compare_tangent(cell->active_cell_index(), false, assessment);
      cell->get_dof_indices(elastic_indices);
      constraints.distribute_local_to_global(local, elastic_indices, residual);
    });
    residual.compress(VectorOperation::add);

    const MPI_Comm communicator = fields.communicator();
    const auto     sum          = [&](const double value) {
      return Utilities::MPI::sum(value, communicator);
    };
    return {std::sqrt(sum(assessment.displacement_scale)),
            std::sqrt(sum(assessment.pressure_scale)),
            Utilities::MPI::max(assessment.degradation_change, communicator),
            sum(assessment.branch_changes)};
  }



  template <int dim>
  void
  Assembler<dim>::elastic_matrix(const Vector      &elastic,
                                 const Vector      &lagged_phase_field,
                                 const Constraints &constraints,
                                 LinearAlgebra::SparseMatrix &matrix)
  {
    matrix = 0.;
    ElasticAssessment  unused{0., 0., 0., 0.};
    FullMatrix<double> local(local_elastic.size(), local_elastic.size());
    for_each_cell([&](const Cell &cell, const Cell &phase_field_cell) {
      load_elastic(cell, phase_field_cell, elastic, lagged_phase_field);
      elastic_kernel.jacobian(local);
      compare_tangent(cell->active_cell_index(), true, unused);
      cell->get_dof_indices(elastic_indices);
      constraints.distribute_local_to_global(local, elastic_indices, matrix);
    });
    matrix.compress(VectorOperation::add);
  }



  template <int dim>
  void
  Assembler<dim>::phase_field_system(const Vector      &elastic,
                                     const Vector      &lagged_phase_field,
                                     const Vector      &phase_field,
                                     const Constraints &constraints,
                                     Vector            &residual,
                                     LinearAlgebra::SparseMatrix *matrix)
  {
    residual = 0.;
    if (matrix != nullptr)
      *matrix = 0.;
    const unsigned int     n = local_phase_field.size();
    dealii::Vector<double> local(n);
    FullMatrix<double>     local_matrix(n, n);
    std::vector<double>    driving_force(fields.quadrature.size());
    for_each_cell([&](const Cell &cell, const Cell &phase_field_cell) {
      load_elastic(cell, phase_field_cell, elastic, lagged_phase_field);
      for (unsigned int q = 0; q < driving_force.size(); ++q)
        driving_force[q] = elastic_kernel.driving_force(q);
      phase_field_kernel.reinit(phase_field_cell);
      phase_field_cell->get_dof_values(phase_field, local_phase_field);
      phase_field_kernel.set_state(local_phase_field, driving_force);
      phase_field_kernel.residual(local);
      phase_field_cell->get_dof_indices(phase_field_indices);
      constraints.distribute_local_to_global(
        local, phase_field_indices, residual);
      if (matrix != nullptr)
      {
        phase_field_kernel.jacobian(local_matrix);
        constraints.distribute_local_to_global(
          local_matrix, phase_field_indices, *matrix);
      }
    });
    residual.compress(VectorOperation::add);
    if (matrix != nullptr)
      matrix->compress(VectorOperation::add);
  }



  template <int dim>
  void
  Assembler<dim>::lumped_mass(const Constraints &constraints, Vector &mass)
  {
    mass = 0.;
    dealii::Vector<double> local(local_phase_field.size());
    for_each_cell([&](const Cell &, const Cell &phase_field_cell) {
      phase_field_kernel.reinit(phase_field_cell);
      phase_field_kernel.lumped_mass(local);
      phase_field_cell->get_dof_indices(phase_field_indices);
      constraints.distribute_local_to_global(local, phase_field_indices, mass);
    });
    mass.compress(VectorOperation::add);
  }



  template <int dim>
  Energies
  Assembler<dim>::energies(const Vector &elastic,
                           const Vector &lagged_phase_field,
                           const Vector &phase_field)
  {
    Energies                  sum;
    const std::vector<double> nothing(fields.quadrature.size(), 0.);
    for_each_cell([&](const Cell &cell, const Cell &phase_field_cell) {
      load_elastic(cell, phase_field_cell, elastic, lagged_phase_field);
      sum.elastic += elastic_kernel.energy();
      phase_field_kernel.reinit(phase_field_cell);
      phase_field_cell->get_dof_values(phase_field, local_phase_field);
      phase_field_kernel.set_state(local_phase_field, nothing);
      sum.crack += phase_field_kernel.energy();
    });
    sum.elastic = Utilities::MPI::sum(sum.elastic, fields.communicator());
    sum.crack   = Utilities::MPI::sum(sum.crack, fields.communicator());
    return sum;
  }



  template <int dim>
  CellData<dim>
  Assembler<dim>::cell_data(const Vector &elastic,
                            const Vector &lagged_phase_field)
  {
    const unsigned int n_cells =
      fields.elastic.get_triangulation().n_active_cells();
    const std::string axes = "xyz";
    CellData<dim>     data;
    const auto        set = [&](const std::string &name,
                         const unsigned int cell,
                         const double       value) {
      dealii::Vector<float> &values = data.values[name];
      if (values.size() == 0)
        values.reinit(n_cells);
      values(cell) = static_cast<float>(value);
    };
    for_each_cell([&](const Cell &cell, const Cell &phase_field_cell) {
      load_elastic(cell, phase_field_cell, elastic, lagged_phase_field);
      const auto         averages = elastic_kernel.averages();
      const unsigned int index    = cell->active_cell_index();
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          set(std::string("stress_") + axes[i] + axes[j],
              index,
              averages.stress[i][j]);
      set("strain_energy_density", index, averages.energy_density);
      set("material", index, cell->material_id());
    });
    return data;
  }



  template class Assembler<2>;
  template class Assembler<3>;
} // namespace MixedCracks
