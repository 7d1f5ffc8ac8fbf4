// SPDX-License-Identifier: GPL-2.0-or-later
// Periodic sides in algebra. The dofs s of one side depend on those m of the
// other, with the weights c of a finer face on a coarser one,
//
//   x_s = sum_m c_sm x_m + g_s,    g_s = (E(t) L)_d  of a displacement u_d,
//
// g = 0 of the pressure. Corners have several images, hanging nodes depend on
// nodes of a side: with  g = sum_k n_k (E L_k)_d  the numbers n_k of a chain
// add up, whole ones on the sides, parts at hanging nodes next to them. They
// are the inhomogeneities of dof chains that deal.II resolves, one set for each
// k, and do not change with E.
//
// Forces are those of hanging nodes only, so that the rows of both sides hold
// what acts through the side, +f on one and -f on the other: with them
//
//   sum_i f_i . du_i = internal forces times du,   du_s - du_m = dE L included,
//
// is the work of the mean strain, too. The equations of dependent nodes belong
// to the nodes they depend on, r_m += c_sm r_s, r_s = 0 (fold()).

#include <base/compat.h>

#include <deal.II/dofs/dof_tools.h>

#include <discretization/periodic_constraints.h>

#include <cmath>
#include <set>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    constexpr double identity_tolerance = 1e-10;
  }



  template <int dim>
  PeriodicConstraints<dim>::PeriodicConstraints(const Fields<dim> &fields,
                                                Periodicity<dim>   periodicity)
    : fields(fields)
    , periodicity(std::move(periodicity))
  {}



  template <int dim>
  void
  PeriodicConstraints<dim>::reinit(const Constraints &hanging_nodes)
  {
    // the coarse mesh stays as it is
    if (matched.matches().empty())
      matched = PeriodicSides<dim>(fields.elastic.get_triangulation(),
                                   periodicity.pairs);
    Constraints open;
    Compat::reinit(
      open, fields.elastic_dofs.owned, fields.elastic_dofs.relevant);
    open.merge(hanging_nodes);
    DoFTools::make_periodicity_constraints<dim, dim>(
      matched.faces(fields.elastic), open);
    elastic.copy_from(open);
    elastic.close();
    folded.clear();
    for (const auto dof : fields.elastic_dofs.owned)
      if (elastic.is_constrained(dof) && !hanging_nodes.is_constrained(dof))
        folded.push_back(dof);
    const Nodes nodes = nodes_on_sides();
    side_dofs.clear();
    side_dofs.set_size(fields.elastic.n_dofs());
    for (const auto &[dof, node] : nodes)
      if (fields.elastic_dofs.owned.is_element(dof))
        side_dofs.add_index(dof);
    find_jumps(hanging_nodes, open, nodes);
    find_partners(hanging_nodes, nodes);
  }



  template <int dim>
  void
  PeriodicConstraints<dim>::add_to_phase_field(Constraints &hanging_nodes) const
  {
    DoFTools::make_periodicity_constraints<dim, dim>(
      matched.faces(fields.phase_field), hanging_nodes);
  }



  template <int dim>
  typename PeriodicConstraints<dim>::Nodes
  PeriodicConstraints<dim>::nodes_on_sides() const
  {
    BoundaryIds ids;
    for (const PeriodicPair &pair : periodicity.pairs)
      for (const BoundaryIds &side : pair.sides)
        ids.insert(side.begin(), side.end());
    const FiniteElement<dim>            &fe = fields.elastic.get_fe();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    Nodes                                nodes;
    for (const auto &cell : fields.elastic.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
      {
        if (cell->is_artificial() || !cell->at_boundary(f) ||
            !ids.contains(cell->face(f)->boundary_id()))
          continue;
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          const unsigned int component = fe.system_to_component_index(i).first;
          if (component < dim && fe.has_support_on_face(i, f) &&
              nodes.count(dofs[i]) == 0)
            nodes[dofs[i]] = {component,
                              fields.mapping.transform_unit_to_real_cell(
                                cell, fe.unit_support_point(i))};
        }
      }
    return nodes;
  }



  template <int dim>
  void
  PeriodicConstraints<dim>::find_jumps(const Constraints &hanging_nodes,
                                       const Constraints &open,
                                       const Nodes       &nodes)
  {
    const std::size_t        n_periods = matched.basis().size();
    std::vector<Constraints> counted(n_periods);
    for (Constraints &each : counted)
      each.copy_from(open);
    for (const auto &[dof, node] : nodes)
    {
      if (!open.is_constrained(dof) || hanging_nodes.is_constrained(dof))
        continue;
      Tensor<1, dim> difference = Tensor<1, dim>(node.position);
      for (const auto &[other, weight] : *open.get_constraint_entries(dof))
        difference -= weight * Tensor<1, dim>(nodes.at(other).position);
      const auto counts = matched.count_periods(difference);
      for (std::size_t k = 0; k < n_periods; ++k)
        if (counts[k] != 0)
          counted[k].set_inhomogeneity(dof, counts[k]);
    }
    for (Constraints &each : counted)
      each.close();
    jumps.clear();
    const FiniteElement<dim>            &fe = fields.elastic.get_fe();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::set<types::global_dof_index>    done;
    for (const auto &cell : fields.elastic.active_cell_iterators())
    {
      if (cell->is_artificial())
        continue;
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        const unsigned int component = fe.system_to_component_index(i).first;
        if (component >= dim || !elastic.is_constrained(dofs[i]) ||
            !fields.elastic_dofs.owned.is_element(dofs[i]) ||
            !done.insert(dofs[i]).second)
          continue;
        Tensor<1, dim> period;
        for (std::size_t k = 0; k < n_periods; ++k)
          period += counted[k].get_inhomogeneity(dofs[i]) * matched.basis()[k];
        if (period.norm() > 0.)
          jumps.push_back({dofs[i], component, period});
      }
    }
  }



  template <int dim>
  void
  PeriodicConstraints<dim>::find_partners(const Constraints &hanging_nodes,
                                          const Nodes       &nodes)
  {
    all_partners.clear();
    masters.clear();
    for (const auto &[dof, node] : nodes)
    {
      if (!elastic.is_constrained(dof) || hanging_nodes.is_constrained(dof))
        continue;
      const auto &entries = *elastic.get_constraint_entries(dof);
      if (entries.size() != 1 ||
          std::abs(entries[0].second - 1.) > identity_tolerance)
        continue;
      const auto master = nodes.find(entries[0].first);
      if (master == nodes.end())
        continue;
      Tensor<1, dim> period;
      const auto     counts =
        matched.count_periods(node.position - master->second.position);
      for (std::size_t k = 0; k < matched.basis().size(); ++k)
        period += counts[k] * matched.basis()[k];
      all_partners.push_back(
        {dof, master->first, node.component, period, node.position});
      masters[dof] = master->first;
    }
  }



  template <int dim>
  void
  PeriodicConstraints<dim>::fit(const double           time,
                                LinearAlgebra::Vector &state) const
  {
    elastic.distribute(state);
    const Tensor<2, dim> strain = strain_at(time);
    for (const Jump &jump : jumps)
      state(jump.dof) += (strain * jump.period)[jump.component];
    state.compress(VectorOperation::add);
  }



  template <int dim>
  void
  PeriodicConstraints<dim>::fold(LinearAlgebra::Vector &forces) const
  {
    std::vector<double> values;
    for (const auto dof : folded)
      values.push_back(forces(dof));
    for (const auto dof : folded)
      forces(dof) = 0.;
    forces.compress(VectorOperation::insert);
    for (std::size_t i = 0; i < folded.size(); ++i)
      for (const auto &[master, weight] :
           *elastic.get_constraint_entries(folded[i]))
        forces(master) += weight * values[i];
    forces.compress(VectorOperation::add);
  }



  template <int dim>
  types::global_dof_index
  PeriodicConstraints<dim>::master_of(const types::global_dof_index dof) const
  {
    const auto found = masters.find(dof);
    return found == masters.end() ? dof : found->second;
  }



  template class PeriodicConstraints<2>;
  template class PeriodicConstraints<3>;
} // namespace MixedCracks
