// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/collective.h>
#include <core/compat.h>

#include <deal.II/numerics/vector_tools.h>

#include <discretization/constraints.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  Constraints<dim>::Constraints(
    const Fields<dim>                    &fields,
    std::vector<PrescribedComponent<dim>> prescribed)
    : fields(fields)
    , prescribed(std::move(prescribed))
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
  void
  Constraints<dim>::reinit()
  {
    Compat::reinit(
      elastic_hanging, fields.elastic_dofs.owned, fields.elastic_dofs.relevant);
    DoFTools::make_hanging_node_constraints(fields.elastic, elastic_hanging);
    Compat::reinit(
      elastic_newton, fields.elastic_dofs.owned, fields.elastic_dofs.relevant);
    elastic_newton.merge(elastic_hanging);
    Compat::reinit(phase_field_hanging,
                   fields.phase_field_dofs.owned,
                   fields.phase_field_dofs.relevant);
    DoFTools::make_hanging_node_constraints(fields.phase_field,
                                            phase_field_hanging);

    prescribed_dofs.clear();
    prescribed_dofs.set_size(fields.elastic.n_dofs());
    for (const PrescribedComponent<dim> &entry : prescribed)
    {
      const ComponentMask mask(mask_of(entry));
      DoFTools::make_zero_boundary_constraints(
        fields.elastic, entry.boundary, elastic_newton, mask);
      prescribed_dofs.add_indices(DoFTools::extract_boundary_dofs(
        fields.elastic, mask, std::set<types::boundary_id>{entry.boundary}));
    }
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
        VectorTools::interpolate_boundary_values(fields.mapping,
                                                 fields.elastic,
                                                 entry->boundary,
                                                 *entry->value,
                                                 values,
                                                 mask_of(*entry));
      }
    });
    for (const auto &[dof, value] : values)
      if (fields.elastic_dofs.owned.is_element(dof))
        elastic(dof) = value;
    elastic.compress(VectorOperation::insert);
    elastic_hanging.distribute(elastic);
  }



  template <int dim>
  void
  Constraints<dim>::keep_prescribed(LinearAlgebra::Vector &residual) const
  {
    std::vector<double> values;
    for (const types::global_dof_index dof : prescribed_dofs)
      values.push_back(residual(dof));
    residual       = 0.;
    std::size_t at = 0;
    for (const types::global_dof_index dof : prescribed_dofs)
      residual(dof) = values[at++];
    residual.compress(VectorOperation::insert);
  }



  template <int dim>
  void
  Constraints<dim>::drop_prescribed(LinearAlgebra::Vector &residual) const
  {
    for (const types::global_dof_index dof : prescribed_dofs)
      residual(dof) = 0.;
    residual.compress(VectorOperation::insert);
  }



  template class Constraints<2>;
  template class Constraints<3>;
} // namespace MixedCracks
