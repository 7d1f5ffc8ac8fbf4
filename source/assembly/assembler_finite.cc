// SPDX-License-Identifier: GPL-2.0-or-later
// Loops over the cells that finite strain asks for:
//
//   tangent_times         y = C^T sum over cells K of  J^K e^K,   e = C e_free
//   smallest_determinant  min over all quadrature points of det(I + grad u)
//   stored_energy         sum_q w_q ( g W + p^2/(2 lambda_d) ); N
//
// J^K the Jacobian of ElasticKernel, C the interpolation of hanging nodes. The
// product has the columns of prescribed dofs, which the matrix has not: what
// their increment does to the rest of the body, the predictor asks.

#include <assembly/assembler.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  void
  Assembler<dim>::visit_states(
    const Vector           &elastic,
    const Vector           &lagged_phase_field,
    const ElasticEvaluation wanted,
    const std::function<void(unsigned int, const ElasticKernel<dim> &)> &body)
  {
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      load_elastic(cell, elastic, lagged_phase_field, wanted);
      body(cell, elastic_kernel);
    }
  }



  template <int dim>
  void
  Assembler<dim>::tangent_times(const Vector      &direction,
                                const Constraints &hanging_nodes,
                                Vector            &result)
  {
    cells->elastic.begin_sum(result);
    const unsigned int     n = local_elastic.size();
    FullMatrix<double>     jacobian(n, n);
    dealii::Vector<double> image(n);
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      elastic_kernel.reinit(cells->geometry(cell), (*constants)[cell]);
      elastic_kernel.set_points(tangent.present(cell));
      elastic_kernel.jacobian(jacobian);
      cells->elastic.read(cell, direction, local_elastic);
      jacobian.vmult(image, local_elastic);
      cells->elastic.add(cell, image, hanging_nodes, result);
    }
    cells->elastic.end_sum(result);
  }



  template <int dim>
  double
  Assembler<dim>::smallest_determinant(const Vector &elastic,
                                       const Vector &lagged_phase_field)
  {
    if (!is_finite())
      return 1.;
    double smallest = std::numeric_limits<double>::infinity();
    visit_states(elastic,
                 lagged_phase_field,
                 ElasticEvaluation::points,
                 [&](unsigned int, const ElasticKernel<dim> &kernel) {
                   smallest = std::min(smallest, kernel.smallest_determinant());
                 });
    return Utilities::MPI::min(smallest, fields.communicator());
  }



  template <int dim>
  void
  Assembler<dim>::mark_inside_out(const Vector      &elastic,
                                  const Vector      &lagged_phase_field,
                                  const Constraints &hanging_nodes,
                                  Vector            &marks)
  {
    dealii::Vector<double> ones(local_phase_field.size());
    ones = 1.;
    cells->phase_field.begin_sum(marks);
    visit_states(
      elastic,
      lagged_phase_field,
      ElasticEvaluation::points,
      [&](const unsigned int cell, const ElasticKernel<dim> &kernel) {
        if (!(kernel.smallest_determinant() > 0.))
          cells->phase_field.add(cell, ones, hanging_nodes, marks);
      });
    cells->phase_field.end_sum(marks);
  }



  template <int dim>
  double
  Assembler<dim>::stored_energy(const Vector &elastic,
                                const Vector &lagged_phase_field)
  {
    double sum = 0.;
    visit_states(elastic,
                 lagged_phase_field,
                 ElasticEvaluation::points,
                 [&](unsigned int, const ElasticKernel<dim> &kernel) {
                   sum += kernel.energy();
                 });
    return Utilities::MPI::sum(sum, fields.communicator());
  }



#define INSTANTIATE(dim)                                                    \
  template void Assembler<dim>::visit_states(                               \
    const Vector &,                                                         \
    const Vector &,                                                         \
    ElasticEvaluation,                                                      \
    const std::function<void(unsigned int, const ElasticKernel<dim> &)> &); \
  template void Assembler<dim>::tangent_times(                              \
    const Vector &, const Constraints &, Vector &);                         \
  template double Assembler<dim>::smallest_determinant(const Vector &,      \
                                                       const Vector &);     \
  template void   Assembler<dim>::mark_inside_out(                          \
    const Vector &, const Vector &, const Constraints &, Vector &);       \
  template double Assembler<dim>::stored_energy(const Vector &, const Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
