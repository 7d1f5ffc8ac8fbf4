// SPDX-License-Identifier: GPL-2.0-or-later
// The loops over the cells. Each sums the contributions of one kernel,
//
//   residual  R_i = sum over cells K of  R^K_(loc(i)),
//   matrix    A_ij = sum over cells K of A^K_(loc(i), loc(j)),
//
// with hanging nodes condensed: a local vector is multiplied by the transpose
// of the interpolation of the hanging nodes, C^T R^K, and a matrix by both, C^T
// A^K C (AffineConstraints::distribute_local_to_global).
//
// The matrix of (u, p) is corrected where it can be: with K' the cells whose
// points have changed g or regime since the last one,
//
//   A_new = A_old + sum over K' of (A^K_new - A^K_old),
//
// which costs 2 |K'| evaluations instead of |K|; ElasticTangent decides.

#include <assembly/assembler.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace MixedCracks
{
  using namespace dealii;

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
      fields, material.description().constants, constants_at);
    tangent.reinit(cells->n_cells(), fields.quadrature.size());
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



  // Besides residual and scales: how far the state is from that of the matrix,
  // in the largest change of g and in points of another regime.
  template <int dim>
  ElasticAssessment
  Assembler<dim>::elastic_residual(const Vector      &elastic,
                                   const Vector      &lagged_phase_field,
                                   const Constraints &constraints,
                                   Vector            &residual)
  {
    cells->elastic.begin_sum(residual);
    double                 displacement_scale = 0., pressure_scale = 0.;
    TangentDistance        distance;
    dealii::Vector<double> local(local_elastic.size());
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      load_elastic(
        cell, elastic, lagged_phase_field, ElasticEvaluation::stresses);
      tangent.set_present(cell, elastic_kernel.points());
      tangent.compare(cell, distance);
      elastic_kernel.residual(local);
      const auto [displacement, pressure] = elastic_kernel.squared_scale();
      displacement_scale += displacement;
      pressure_scale += pressure;
      cells->elastic.add(cell, local, constraints, residual);
    }
    cells->elastic.end_sum(residual);

    const MPI_Comm communicator = fields.communicator();
    const auto     sum          = [&](const double value) {
      return Utilities::MPI::sum(value, communicator);
    };
    return {std::sqrt(sum(displacement_scale)),
            std::sqrt(sum(pressure_scale)),
            Utilities::MPI::max(distance.degradation, communicator),
            sum(distance.regime_changes),
            is_finite()
              ? Utilities::MPI::max(distance.deformation, communicator)
              : 0.};
  }



  template <int dim>
  void
  Assembler<dim>::elastic_matrix(const Constraints           &constraints,
                                 LinearAlgebra::SparseMatrix &matrix)
  {
    std::vector<unsigned int> changed = tangent.changed_cells();
    const double              n_changed =
      Utilities::MPI::sum(1. * changed.size(), fields.communicator());
    const double n_active =
      fields.elastic.get_triangulation().n_global_active_cells();
    const bool correct = tangent.is_to_be_corrected(n_changed, n_active);
    if (!correct)
    {
      matrix = 0.;
      changed.resize(cells->n_cells());
      std::iota(changed.begin(), changed.end(), 0);
    }
    FullMatrix<double> local(local_elastic.size(), local_elastic.size());
    FullMatrix<double> old(local);
    for (const unsigned int cell : changed)
    {
      elastic_kernel.reinit(cells->geometry(cell), (*constants)[cell]);
      if (correct)
      {
        elastic_kernel.set_points(tangent.of_matrix(cell));
        elastic_kernel.jacobian(old);
      }
      elastic_kernel.set_points(tangent.present(cell));
      elastic_kernel.jacobian(local);
      if (correct)
        local.add(-1., old);
      cells->elastic.global_indices(cell, elastic_indices);
      constraints.distribute_local_to_global(local, elastic_indices, matrix);
    }
    matrix.compress(VectorOperation::add);
    tangent.note_matrix(correct);
  }



  template <int dim>
  const std::vector<ElasticResponse<dim>> &
  Assembler<dim>::tangents(const unsigned int cell)
  {
    elastic_kernel.reinit_points((*constants)[cell]);
    elastic_kernel.set_points(tangent.of_matrix(cell));
    return elastic_kernel.point_responses();
  }



  template <int dim>
  void
  Assembler<dim>::cell_jacobian(const unsigned int  cell,
                                FullMatrix<double> &result)
  {
    elastic_kernel.reinit(cells->geometry(cell), (*constants)[cell]);
    elastic_kernel.set_points(tangent.of_matrix(cell));
    elastic_kernel.jacobian(result);
  }



  // D_q = sigma+ : eps = 2 psi+, for cell after cell and point after point
  template <int dim>
  DrivingForce
  Assembler<dim>::driving_force() const
  {
    const unsigned int n_points = fields.quadrature.size();
    DrivingForce       result;
    result.reserve(std::size_t(cells->n_cells()) * n_points);
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      const CellConstants at = (*constants)[cell];
      for (unsigned int q = 0; q < n_points; ++q)
        result.push_back(
          elastic_kernel.driving_force(tangent.present(cell)[q], at[q]));
    }
    return result;
  }



  template <int dim>
  void
  Assembler<dim>::phase_field_system(const Vector                &phase_field,
                                     const DrivingForce          &driving_force,
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
    AssertDimension(driving_force.size(),
                    cells->n_cells() * fields.quadrature.size());
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      phase_field_kernel.reinit(cells->geometry(cell), (*constants)[cell]);
      cells->phase_field.read(cell, phase_field, local_phase_field);
      phase_field_kernel.set_state(
        local_phase_field,
        &driving_force[std::size_t(cell) * fields.quadrature.size()]);
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
      phase_field_kernel.reinit(cells->geometry(cell), (*constants)[cell]);
      phase_field_kernel.lumped_mass(local);
      cells->phase_field.add(cell, local, constraints, mass);
    }
    cells->phase_field.end_sum(mass);
  }



  template <int dim>
  void
  Assembler<dim>::lumped_release_rate(const Constraints &constraints,
                                      Vector            &sum)
  {
    cells->phase_field.begin_sum(sum);
    dealii::Vector<double> local(local_phase_field.size());
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      phase_field_kernel.reinit(cells->geometry(cell), (*constants)[cell]);
      phase_field_kernel.lumped_release_rate(local);
      cells->phase_field.add(cell, local, constraints, sum);
    }
    cells->phase_field.end_sum(sum);
  }



  // Per mm of thickness:  integral of 1/2 sigma : eps,  of G_c gamma, and of
  // gamma.
  template <int dim>
  Energies
  Assembler<dim>::energies(const Vector &elastic,
                           const Vector &lagged_phase_field,
                           const Vector &phase_field)
  {
    Energies sum;
    if (is_finite())
      sum.smallest_jacobian = std::numeric_limits<double>::infinity();
    const std::vector<double> nothing(fields.quadrature.size(), 0.);
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      load_elastic(
        cell, elastic, lagged_phase_field, ElasticEvaluation::points);
      cells->phase_field.read(cell, phase_field, local_phase_field);
      phase_field_kernel.interpolate(local_phase_field, phase_field_values);
      sum.elastic += elastic_kernel.energy(phase_field_values);
      sum.smallest_jacobian =
        std::min(sum.smallest_jacobian, elastic_kernel.smallest_determinant());
      phase_field_kernel.reinit(cells->geometry(cell), (*constants)[cell]);
      phase_field_kernel.set_state(local_phase_field, nothing.data());
      sum.crack += phase_field_kernel.energy();
      sum.crack_surface += phase_field_kernel.crack_surface();
    }
    const MPI_Comm communicator = fields.communicator();
    sum.elastic       = Utilities::MPI::sum(sum.elastic, communicator);
    sum.crack         = Utilities::MPI::sum(sum.crack, communicator);
    sum.crack_surface = Utilities::MPI::sum(sum.crack_surface, communicator);
    if (is_finite())
      sum.smallest_jacobian =
        Utilities::MPI::min(sum.smallest_jacobian, communicator);
    return sum;
  }



  template class Assembler<2>;
  template class Assembler<3>;
} // namespace MixedCracks
