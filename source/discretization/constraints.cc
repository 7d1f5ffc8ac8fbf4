// SPDX-License-Identifier: GPL-2.0-or-later
// Hanging nodes and supports of the elastic fields.
//
// A hanging node takes the value of the neighbour's shape functions there, x_h
// = sum_j c_hj x_j, which keeps the fields continuous; in 2-d with Q1 the mean
// of two vertices, with Q2 weights (3/8, 3/4, -1/8). Supports are not
// constraints of the state but of corrections:
//
//   x = x_D + d,   x_D(t) set once per step (apply_prescribed),  d = 0 there,
//
// so that Newton's matrix has both, the state only hanging nodes, and the
// residual in a row of a support, not set to 0, is the reaction. Periodic sides
// are in constraints_periodic.cc and periodic_constraints.cc.

#include <base/collective.h>
#include <base/compat.h>
#include <base/errors.h>

#include <deal.II/numerics/vector_tools.h>

#include <discretization/constraints.h>
#include <discretization/symmetry_plane.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  Constraints<dim>::Constraints(
    const Fields<dim>                    &fields,
    std::vector<PrescribedComponent<dim>> prescribed,
    std::vector<PrescribedPoint<dim>>     points,
    Periodicity<dim>                      periodicity)
    : fields(fields)
    , prescribed(std::move(prescribed))
    , points(std::move(points))
    , periodic_sides(fields, std::move(periodicity))
  {}



  template <int dim>
  std::vector<bool>
  Constraints<dim>::mask_of(const PrescribedComponent<dim> &entry) const
  {
    std::vector<bool> mask(fields.elastic.get_fe().n_components(), false);
    mask[entry.component] = true;
    return mask;
  }



  template <int dim>
  std::vector<VertexDofs>
  Constraints<dim>::find_points() const
  {
    std::vector<VertexComponent<dim>> places;
    for (const PrescribedPoint<dim> &entry : points)
      places.push_back({entry.point, entry.component, !entry.set.empty()});
    return dofs_at_vertices(fields.elastic,
                            elastic_hanging,
                            places,
                            "Boundary conditions/Displacement at points");
  }



  // The component is that of the coarse mesh, and stays.
  template <int dim>
  void
  Constraints<dim>::resolve_symmetry()
  {
    for (PrescribedComponent<dim> &entry : prescribed)
    {
      if (entry.component != PrescribedComponent<dim>::normal)
        continue;
      const unsigned int component = component_normal_to(
        fields.elastic.get_triangulation(), entry.boundary, entry.name);
      for (const PrescribedComponent<dim> &other : prescribed)
        if (other.boundary == entry.boundary && other.component == component)
          throw InputError("Boundary conditions/Displacement: found '" +
                           entry.name + " : symmetry' and '" + entry.name +
                           " : " + "xyz"[component] +
                           "', which prescribe the same component. Allowed is "
                           "one of them.");
      entry.component = component;
    }
  }



  template <int dim>
  void
  Constraints<dim>::reinit()
  {
    Compat::reinit(
      elastic_hanging, fields.elastic_dofs.owned, fields.elastic_dofs.relevant);
    DoFTools::make_hanging_node_constraints(fields.elastic, elastic_hanging);
    Compat::reinit(
      elastic_newton, fields.elastic_dofs.owned, fields.elastic_dofs.relevant);
    if (periodic_sides.any())
    {
      periodic_sides.reinit(elastic_hanging);
      elastic_newton.merge(periodic_sides.homogeneous());
    }
    else
      elastic_newton.merge(elastic_hanging);
    Compat::reinit(phase_field_hanging,
                   fields.phase_field_dofs.owned,
                   fields.phase_field_dofs.relevant);
    DoFTools::make_hanging_node_constraints(fields.phase_field,
                                            phase_field_hanging);
    if (periodic_sides.any())
      periodic_sides.add_to_phase_field(phase_field_hanging);

    if (source_of_points)
      points = source_of_points();
    resolve_symmetry();
    hold_translations();
    prescribed_dofs.clear();
    prescribed_dofs.set_size(fields.elastic.n_dofs());
    for (const PrescribedComponent<dim> &entry : prescribed)
    {
      const ComponentMask mask(mask_of(entry));
      for (const types::boundary_id id : entry.boundary)
        DoFTools::make_zero_boundary_constraints(
          fields.elastic, id, elastic_newton, mask);
      prescribed_dofs.add_indices(
        DoFTools::extract_boundary_dofs(fields.elastic, mask, entry.boundary));
    }
    point_dofs = find_points();
    for (const VertexDofs &dofs : point_dofs)
      for (const types::global_dof_index dof : dofs)
      {
        if (!elastic_newton.is_constrained(dof))
          elastic_newton.add_line(dof);
        prescribed_dofs.add_index(dof);
      }
    prescribe_images();
    prescribed_dofs = prescribed_dofs & fields.elastic_dofs.owned;

    elastic_hanging.close();
    elastic_newton.close();
    phase_field_hanging.close();
  }



  template <int dim>
  void
  Constraints<dim>::apply_prescribed(const double           time,
                                     LinearAlgebra::Vector &elastic) const
  {
    // where two boundaries meet, the one named first in the .prm decides
    std::map<types::global_dof_index, double> values;
    together(fields.communicator(), [&]() {
      for (auto entry = prescribed.rbegin(); entry != prescribed.rend();
           ++entry)
      {
        entry->value->set_time(time);
        std::map<types::boundary_id, const Function<dim> *> on_ids;
        for (const types::boundary_id id : entry->boundary)
          on_ids[id] = entry->value.get();
        VectorTools::interpolate_boundary_values(
          fields.mapping, fields.elastic, on_ids, values, mask_of(*entry));
      }
      for (std::size_t i = 0; i < points.size(); ++i)
        for (const types::global_dof_index dof : point_dofs[i])
        {
          points[i].value->set_time(time);
          values.insert(
            {dof,
             points[i].value->value(points[i].point, points[i].component)});
        }
      add_values_of_images(time, values);
    });
    for (const auto &[dof, value] : values)
      if (fields.elastic_dofs.owned.is_element(dof))
        elastic(dof) = value;
    elastic.compress(VectorOperation::insert);
    fit(time, elastic);
  }



  template <int dim>
  void
  Constraints<dim>::fit(const double time, LinearAlgebra::Vector &elastic) const
  {
    if (periodic_sides.any())
      periodic_sides.fit(time, elastic);
    else
      elastic_hanging.distribute(elastic);
  }



  // r <- r at supports and periodic sides, 0 elsewhere: the reactions. Of
  // hanging nodes nothing is left, as their part was condensed to their
  // neighbours.
  template <int dim>
  void
  Constraints<dim>::keep_prescribed(LinearAlgebra::Vector &residual) const
  {
    IndexSet kept = prescribed_dofs;
    if (periodic_sides.any())
      kept.add_indices(periodic_sides.dofs_of_sides());
    std::vector<double> values;
    for (const types::global_dof_index dof : kept)
      values.push_back(residual(dof));
    residual       = 0.;
    std::size_t at = 0;
    for (const types::global_dof_index dof : kept)
      residual(dof) = values[at++];
    residual.compress(VectorOperation::insert);
  }



  template <int dim>
  void
  Constraints<dim>::drop_prescribed(LinearAlgebra::Vector &residual) const
  {
    if (periodic_sides.any())
      periodic_sides.fold(residual);
    for (const types::global_dof_index dof : prescribed_dofs)
      residual(dof) = 0.;
    residual.compress(VectorOperation::insert);
  }



#define INSTANTIATE(dim)                                                      \
  template Constraints<dim>::Constraints(                                     \
    const Fields<dim> &,                                                      \
    std::vector<PrescribedComponent<dim>>,                                    \
    std::vector<PrescribedPoint<dim>>,                                        \
    Periodicity<dim>);                                                        \
  template void Constraints<dim>::reinit();                                   \
  template void Constraints<dim>::apply_prescribed(                           \
    double, LinearAlgebra::Vector &) const;                                   \
  template void Constraints<dim>::fit(double, LinearAlgebra::Vector &) const; \
  template void Constraints<dim>::keep_prescribed(LinearAlgebra::Vector &)    \
    const;                                                                    \
  template void Constraints<dim>::drop_prescribed(LinearAlgebra::Vector &)    \
    const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
