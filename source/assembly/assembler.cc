// SPDX-License-Identifier: GPL-2.0-or-later
#include <assembly/assembler.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // Above this part of changed cells a new matrix is less work than
    // correcting the old one, which evaluates changed cells twice ...
    constexpr double largest_changed_part = 0.25;
    // ... and once in a while rounding is swept out.
    constexpr unsigned int most_corrections = 50;

    template <int dim>
    bool
    same_tangent(const ElasticPoint<dim> &a, const ElasticPoint<dim> &b)
    {
      return a.degradation == b.degradation && a.branch == b.branch &&
             a.branch >= 0;
    }
  } // namespace



  template <int dim>
  Assembler<dim>::Assembler(const Fields<dim>     &fields,
                            const Material<dim>   &material,
                            ConstantsFunction<dim> constants_at)
    : fields(fields)
    , material(material)
    , constants_at(std::move(constants_at))
    , elastic_kernel(fields.elastic.get_fe(),
                     fields.quadrature,
                     material,
                     fields.layout.mixed)
    , phase_field_kernel(fields.phase_field.get_fe(),
                         fields.quadrature,
                         material)
    , local_elastic(fields.elastic.get_fe().n_dofs_per_cell())
    , local_phase_field(fields.phase_field.get_fe().n_dofs_per_cell())
    , elastic_indices(local_elastic.size())
    , phase_field_indices(local_phase_field.size())
  {}



  template <int dim>
  void
  Assembler<dim>::reinit()
  {
    cells     = std::make_unique<CellTable<dim>>(fields);
    constants = std::make_unique<ConstantsTable<dim>>(
      fields, material.uniform_constants(), constants_at);
    present.resize(cells->n_cells() * fields.quadrature.size());
    of_matrix.resize(present.size());
    // no degradation is as far off as this one
    for (ElasticPoint<dim> &point : of_matrix)
      point = {{}, 0., std::numeric_limits<double>::max(), -1};
    n_corrections = most_corrections;
  }



  template <int dim>
  void
  Assembler<dim>::load_elastic(const unsigned int      cell,
                               const Vector           &elastic,
                               const Vector           &lagged_phase_field,
                               const ElasticEvaluation wanted)
  {
    elastic_kernel.reinit(cells->geometry(cell), (*constants)[cell]);
    cells->elastic.read(cell, elastic, local_elastic);
    cells->phase_field.read(cell, lagged_phase_field, local_phase_field);
    phase_field_kernel.interpolate(local_phase_field, lagged_values);
    elastic_kernel.set_state(local_elastic, lagged_values, wanted);
  }



  template <int dim>
  void
  Assembler<dim>::compare_tangent(const unsigned int cell,
                                  ElasticAssessment &assessment) const
  {
    const std::size_t n = fields.quadrature.size();
    for (std::size_t at = cell * n; at < (cell + 1) * n; ++at)
    {
      const ElasticPoint<dim> &now = present[at], &then = of_matrix[at];
      assessment.degradation_change =
        std::max(assessment.degradation_change,
                 std::abs(now.degradation - then.degradation) /
                   std::max(std::min(now.degradation, then.degradation),
                            std::numeric_limits<double>::min()));
      if (now.branch < 0 || now.branch != then.branch)
        assessment.branch_changes += 1.;
    }
  }



  template <int dim>
  ElasticAssessment
  Assembler<dim>::elastic_residual(const Vector      &elastic,
                                   const Vector      &lagged_phase_field,
                                   const Constraints &constraints,
                                   Vector            &residual)
  {
    cells->elastic.begin_sum(residual);
    ElasticAssessment      assessment{0., 0., 0., 0.};
    dealii::Vector<double> local(local_elastic.size());
    const std::size_t      n = fields.quadrature.size();
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      load_elastic(
        cell, elastic, lagged_phase_field, ElasticEvaluation::stresses);
      std::copy(elastic_kernel.points().begin(),
                elastic_kernel.points().end(),
                present.begin() + cell * n);
      elastic_kernel.residual(local);
      const auto [displacement, pressure] = elastic_kernel.squared_scale();
      assessment.displacement_scale += displacement;
      assessment.pressure_scale += pressure;
      compare_tangent(cell, assessment);
      cells->elastic.add(cell, local, constraints, residual);
    }
    cells->elastic.end_sum(residual);

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
  std::vector<unsigned int>
  Assembler<dim>::changed_cells() const
  {
    const std::size_t         n = fields.quadrature.size();
    std::vector<unsigned int> result;
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
      for (std::size_t at = cell * n; at < (cell + 1) * n; ++at)
        if (!same_tangent(present[at], of_matrix[at]))
        {
          result.push_back(cell);
          break;
        }
    return result;
  }



  template <int dim>
  void
  Assembler<dim>::elastic_matrix(const Constraints           &constraints,
                                 LinearAlgebra::SparseMatrix &matrix)
  {
    std::vector<unsigned int> changed = changed_cells();
    const double              n_changed =
      Utilities::MPI::sum(1. * changed.size(), fields.communicator());
    const double n_active =
      fields.elastic.get_triangulation().n_global_active_cells();
    const bool correct = n_corrections < most_corrections &&
                         n_changed < largest_changed_part * n_active;
    n_corrections = correct ? n_corrections + 1 : 0;
    if (!correct)
    {
      matrix = 0.;
      changed.resize(cells->n_cells());
      std::iota(changed.begin(), changed.end(), 0);
    }
    FullMatrix<double> local(local_elastic.size(), local_elastic.size());
    FullMatrix<double> old(local);
    const std::size_t  n = fields.quadrature.size();
    for (const unsigned int cell : changed)
    {
      elastic_kernel.reinit(cells->geometry(cell), (*constants)[cell]);
      if (correct)
      {
        elastic_kernel.set_points(&of_matrix[cell * n]);
        elastic_kernel.jacobian(old);
      }
      elastic_kernel.set_points(&present[cell * n]);
      elastic_kernel.jacobian(local);
      if (correct)
        local.add(-1., old);
      cells->elastic.global_indices(cell, elastic_indices);
      constraints.distribute_local_to_global(local, elastic_indices, matrix);
    }
    matrix.compress(VectorOperation::add);
    of_matrix = present;
  }



  template <int dim>
  void
  Assembler<dim>::phase_field_system(const Vector                &phase_field,
                                     const Constraints           &constraints,
                                     Vector                      &residual,
                                     LinearAlgebra::SparseMatrix *matrix)
  {
    cells->phase_field.begin_sum(residual);
    if (matrix != nullptr)
      *matrix = 0.;
    const unsigned int     n = local_phase_field.size();
    dealii::Vector<double> local(n);
    FullMatrix<double>     local_matrix(n, n);
    std::vector<double>    driving_force(fields.quadrature.size());
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      const CellConstants at = (*constants)[cell];
      for (unsigned int q = 0; q < driving_force.size(); ++q)
        driving_force[q] = elastic_kernel.driving_force(
          present[cell * driving_force.size() + q], at[q]);
      phase_field_kernel.reinit(cells->geometry(cell), at);
      cells->phase_field.read(cell, phase_field, local_phase_field);
      phase_field_kernel.set_state(local_phase_field, driving_force);
      phase_field_kernel.residual(local);
      cells->phase_field.add(cell, local, constraints, residual);
      if (matrix != nullptr)
      {
        phase_field_kernel.jacobian(local_matrix);
        cells->phase_field.global_indices(cell, phase_field_indices);
        constraints.distribute_local_to_global(
          local_matrix, phase_field_indices, *matrix);
      }
    }
    cells->phase_field.end_sum(residual);
    if (matrix != nullptr)
      matrix->compress(VectorOperation::add);
  }



  template <int dim>
  void
  Assembler<dim>::lumped_mass(const Constraints &constraints, Vector &mass)
  {
    cells->phase_field.begin_sum(mass);
    dealii::Vector<double> local(local_phase_field.size());
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      phase_field_kernel.reinit(cells->geometry(cell));
      phase_field_kernel.lumped_mass(local);
      cells->phase_field.add(cell, local, constraints, mass);
    }
    cells->phase_field.end_sum(mass);
  }



  template <int dim>
  Energies
  Assembler<dim>::energies(const Vector &elastic,
                           const Vector &lagged_phase_field,
                           const Vector &phase_field)
  {
    Energies                  sum;
    const std::vector<double> nothing(fields.quadrature.size(), 0.);
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      load_elastic(
        cell, elastic, lagged_phase_field, ElasticEvaluation::points);
      cells->phase_field.read(cell, phase_field, local_phase_field);
      phase_field_kernel.interpolate(local_phase_field, phase_field_values);
      sum.elastic += elastic_kernel.energy(phase_field_values);
      phase_field_kernel.reinit(cells->geometry(cell), (*constants)[cell]);
      phase_field_kernel.set_state(local_phase_field, nothing);
      sum.crack += phase_field_kernel.energy();
      sum.crack_surface += phase_field_kernel.crack_surface();
    }
    const MPI_Comm communicator = fields.communicator();
    sum.elastic       = Utilities::MPI::sum(sum.elastic, communicator);
    sum.crack         = Utilities::MPI::sum(sum.crack, communicator);
    sum.crack_surface = Utilities::MPI::sum(sum.crack_surface, communicator);
    return sum;
  }



  template <int dim>
  CellData<dim>
  Assembler<dim>::cell_data(const Vector &elastic,
                            const Vector &lagged_phase_field,
                            const Vector &phase_field)
  {
    const unsigned int n_cells =
      fields.elastic.get_triangulation().n_active_cells();
    const std::string axes = "xyz";
    CellData<dim>     data;
    const auto        set = [&](const std::string &name,
                         const unsigned int cell,
                         const double       value) {
      data.set(name, n_cells, cell, value);
    };
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      load_elastic(
        cell, elastic, lagged_phase_field, ElasticEvaluation::stresses);
      cells->phase_field.read(cell, phase_field, local_phase_field);
      phase_field_kernel.interpolate(local_phase_field, phase_field_values);
      const auto         averages = elastic_kernel.averages(phase_field_values);
      const unsigned int index    = cells->active_index(cell);
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          set(std::string("stress_") + axes[i] + axes[j],
              index,
              averages.stress[i][j]);
      set("strain_energy_density", index, averages.energy_density);
      set("material", index, cells->material(cell));
      if (constants_vary())
        add_constants(cell, index, data);
    }
    return data;
  }



  template class Assembler<2>;
  template class Assembler<3>;
} // namespace MixedCracks
