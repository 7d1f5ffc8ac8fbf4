// SPDX-License-Identifier: GPL-2.0-or-later
// The sums over the cells of FluidKernel: the external load of a fluid in the
// cracks and what it adds to the system of the phase field (M10). p_f(x, t) is
// evaluated at all quadrature points once for each time, as it is an expression
// that takes longer than the rest of the cell.

#include <assembly/fluid_assembler.h>

#include <base/collective.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  FluidAssembler<dim>::FluidAssembler(const Fields<dim>             &fields,
                                      std::shared_ptr<Function<dim>> pressure)
    : fields(fields)
    , pressure(std::move(pressure))
    , kernel(fields.elastic.get_fe(),
             fields.phase_field.get_fe(),
             fields.quadrature)
    , local_elastic(fields.elastic.get_fe().n_dofs_per_cell())
    , local_phase_field(fields.phase_field.get_fe().n_dofs_per_cell())
  {}



  template <int dim>
  FluidAssembler<dim>::Cells::Cells(const Fields<dim> &fields)
    : elastic(fields.elastic, fields.elastic_dofs)
    , phase_field(fields.phase_field, fields.phase_field_dofs)
  {
    GeometryEvaluator<dim> geometry_of(fields.mapping, fields.quadrature);
    FEValues<dim>          position(fields.mapping,
                           fields.phase_field.get_fe(),
                           fields.quadrature,
                           update_quadrature_points);
    for (const auto &cell : fields.phase_field.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        geometries.push_back(geometry_of(cell));
        position.reinit(cell);
        points.insert(points.end(),
                      position.get_quadrature_points().begin(),
                      position.get_quadrature_points().end());
      }
  }



  template <int dim>
  void
  FluidAssembler<dim>::reinit()
  {
    cells = std::make_unique<Cells>(fields);
    pressures.clear();
  }



  template <int dim>
  void
  FluidAssembler<dim>::set_time(const double time)
  {
    // the same on all ranks, while some may own no cell
    const bool known =
      time == time_of_pressures && pressures.size() == cells->points.size();
    if (Utilities::MPI::min(known ? 1 : 0, fields.communicator()) == 1)
      return;
    pressure->set_time(time);
    together(fields.communicator(), [&]() {
      pressures.clear();
      for (const Point<dim> &point : cells->points)
        pressures.push_back(pressure->value(point));
    });
    time_of_pressures = time;
  }



  template <int dim>
  void
  FluidAssembler<dim>::load(const unsigned int cell, const Vector &phase_field)
  {
    kernel.reinit(cells->geometries[cell]);
    kernel.set_pressure(&pressures[cell * fields.quadrature.size()]);
    cells->phase_field.read(cell, phase_field, local_phase_field);
    kernel.set_phase_field(local_phase_field);
  }



  template <int dim>
  void
  FluidAssembler<dim>::add_nodal_forces(const double       time,
                                        const Vector      &phase_field,
                                        const Constraints &constraints,
                                        Vector            &forces)
  {
    set_time(time);
    Vector sum = fields.owned_vector(fields.elastic_dofs);
    cells->elastic.begin_sum(sum);
    dealii::Vector<double> local(local_elastic.size());
    for (unsigned int cell = 0; cell < cells->geometries.size(); ++cell)
    {
      load(cell, phase_field);
      kernel.nodal_forces(local);
      cells->elastic.add(cell, local, constraints, sum);
    }
    cells->elastic.end_sum(sum);
    forces.add(1., sum);
  }



  template <int dim>
  void
  FluidAssembler<dim>::add_phase_field_system(
    const double                 time,
    const Vector                &elastic,
    const Vector                &phase_field,
    const Constraints           &constraints,
    Vector                      &residual,
    LinearAlgebra::SparseMatrix *matrix)
  {
    set_time(time);
    Vector sum = fields.owned_vector(fields.phase_field_dofs);
    cells->phase_field.begin_sum(sum);
    const unsigned int                   n = local_phase_field.size();
    dealii::Vector<double>               local(n);
    FullMatrix<double>                   local_matrix(n, n);
    std::vector<types::global_dof_index> indices(n);
    for (unsigned int cell = 0; cell < cells->geometries.size(); ++cell)
    {
      load(cell, phase_field);
      cells->elastic.read(cell, elastic, local_elastic);
      kernel.set_displacement(local_elastic);
      kernel.phase_field_residual(local);
      cells->phase_field.add(cell, local, constraints, sum);
      if (matrix != nullptr)
      {
        kernel.phase_field_jacobian(local_matrix);
        cells->phase_field.global_indices(cell, indices);
        constraints.distribute_local_to_global(local_matrix, indices, *matrix);
      }
    }
    cells->phase_field.end_sum(sum);
    residual.add(1., sum);
    if (matrix != nullptr)
      matrix->compress(VectorOperation::add);
  }



  template <int dim>
  double
  FluidAssembler<dim>::energy(const double  time,
                              const Vector &elastic,
                              const Vector &phase_field)
  {
    set_time(time);
    double sum = 0.;
    for (unsigned int cell = 0; cell < cells->geometries.size(); ++cell)
    {
      load(cell, phase_field);
      cells->elastic.read(cell, elastic, local_elastic);
      kernel.set_displacement(local_elastic);
      sum += kernel.energy();
    }
    return Utilities::MPI::sum(sum, fields.communicator());
  }



  template class FluidAssembler<2>;
  template class FluidAssembler<3>;
} // namespace MixedCracks
