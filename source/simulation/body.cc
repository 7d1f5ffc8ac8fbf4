// SPDX-License-Identifier: GPL-2.0-or-later
// What a case consists of before any load: mesh, fields, constraints, material.
// h is measured on the first mesh and kept in the checkpoint: l and kappa may
// depend on it, and a body that is refined later is the same material.

#include <deal.II/grid/grid_tools.h>

#include <simulation/body.h>
#include <simulation/case_checks.h>
#include <simulation/simulation_setup.h>

#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    unsigned int
    n_elastic_components(const Parameters<dim> &parameters)
    {
      return dim + (parameters.model.mixed() ? 1 : 0);
    }
  } // namespace



  template <int dim>
  Body<dim>::Body(const Parameters<dim> &parameters,
                  const MPI_Comm         communicator)
    : parameters(parameters)
    , triangulation(communicator)
    , fields(triangulation,
             {parameters.model.mixed(), parameters.model.degree()})
    , constraints(
        fields,
        prescribed_components(parameters, n_elastic_components(parameters)),
        {},
        periodicity(parameters))
  {
    constraints.take_points_from([this]() {
      return prescribed_points(this->parameters,
                               n_elastic_components(this->parameters),
                               triangulation,
                               not_built.has_value());
    });
  }



  template <int dim>
  void
  Body<dim>::make()
  {
    make_mesh(parameters, triangulation);
    cell_size = finest_cell_size(triangulation, communicator());
    set_up();
  }



  template <int dim>
  void
  Body<dim>::make_to_check()
  {
    not_built = make_mesh_to_check(parameters, fields.layout, triangulation);
    cell_size = not_built ? not_built->finest_size
                          : finest_cell_size(triangulation, communicator());
    set_up();
  }



  template <int dim>
  void
  Body<dim>::restore(const Checkpoint<dim> &checkpoint,
                     const double           first_cell_size)
  {
    parameters.geometry.chosen().create(triangulation);
    make_periodic(parameters, triangulation);
    checkpoint.load_mesh(triangulation);
    cell_size = first_cell_size;
    set_up();
  }



  template <int dim>
  void
  Body<dim>::set_up()
  {
    material = std::make_unique<const Material<dim>>(
      describe_material(parameters.model, parameters.material, dim, cell_size));
    require_solver_for_stiffness(parameters, material->description());
    fields.distribute();
    constraints.reinit();
    require_held_body(triangulation, constraints);
    material_field = std::make_unique<const MaterialField<dim>>(
      make_material_field(parameters.material, triangulation));
    material_range = MixedCracks::material_range(*material_field, fields);
  }



  template <int dim>
  MeshEstimate
  Body<dim>::counts() const
  {
    if (not_built)
      return *not_built;
    MeshEstimate counts;
    counts.n_cells       = triangulation.n_global_active_cells();
    counts.n_elastic     = fields.elastic.n_dofs();
    counts.n_phase_field = fields.phase_field.n_dofs();
    counts.finest_level  = triangulation.n_global_levels() - 1;
    counts.finest_size   = finest_cell_size(triangulation, communicator());
    return counts;
  }



  // h 2^-(levels that adaptation may still add): the cells that a crack will
  // run through, not those of the first mesh.
  template <int dim>
  double
  Body<dim>::cell_size_at_cracks() const
  {
    const MeshEstimate mesh    = counts();
    const int          present = mesh.finest_level;
    const int          finest  = parameters.mesh.adaptation == "none"
                                   ? present
                                   : parameters.mesh.finest_adaptive_level();
    return mesh.finest_size * std::pow(0.5, std::max(0, finest - present));
  }



  template <int dim>
  double
  Body<dim>::volume() const
  {
    return GridTools::volume(triangulation, fields.mapping);
  }



  template class Body<2>;
  template class Body<3>;
} // namespace MixedCracks
