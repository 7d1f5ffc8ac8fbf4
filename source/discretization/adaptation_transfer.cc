// SPDX-License-Identifier: GPL-2.0-or-later
// Fields on a new mesh by nodal interpolation, x_new = I x_old: exact where
// cells are cut, as the old space is part of the new one; a cell made coarser
// keeps the values of its vertices (and of its other nodes, Q2). Then hanging
// nodes of the new mesh. Q1 interpolation has weights in [0, 1] that add up to
// 1, hence keeps bounds, 0 <= phi <= phi^(n-1) among them.

#include <deal.II/distributed/solution_transfer.h>

#include <discretization/adaptation.h>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    template <int dim>
    using Transfer = parallel::distributed::SolutionTransfer<dim, Vector>;

    std::vector<const Vector *>
    as_constant(const std::vector<Vector *> &vectors)
    {
      return {vectors.begin(), vectors.end()};
    }



    // interpolate to the new mesh and give the vectors their new ghosts
    template <int dim>
    void
    take_over(Transfer<dim>                   &transfer,
              const Fields<dim>               &fields,
              const DofSets                   &dofs,
              const AffineConstraints<double> &hanging_nodes,
              const std::vector<Vector *>     &vectors)
    {
      if (vectors.empty())
        return;
      std::vector<Vector>   owned(vectors.size(), fields.owned_vector(dofs));
      std::vector<Vector *> pointers;
      for (Vector &vector : owned)
        pointers.push_back(&vector);
      transfer.interpolate(pointers);
      for (std::size_t i = 0; i < vectors.size(); ++i)
      {
        hanging_nodes.distribute(owned[i]);
        vectors[i]->reinit(dofs.owned, dofs.relevant, fields.communicator());
        *vectors[i] = owned[i];
      }
    }
  } // namespace



  template <int dim>
  void
  refine_and_transfer(parallel::distributed::Triangulation<dim> &triangulation,
                      Fields<dim>                               &fields,
                      Constraints<dim>                          &constraints,
                      const std::vector<Vector *>               &elastic,
                      const std::vector<Vector *>               &phase_field)
  {
    Transfer<dim> of_elastic(fields.elastic);
    Transfer<dim> of_phase_field(fields.phase_field);
    triangulation.prepare_coarsening_and_refinement();
    if (!elastic.empty())
      of_elastic.prepare_for_coarsening_and_refinement(as_constant(elastic));
    if (!phase_field.empty())
      of_phase_field.prepare_for_coarsening_and_refinement(
        as_constant(phase_field));
    triangulation.execute_coarsening_and_refinement();
    fields.distribute();
    constraints.reinit();
    take_over(of_elastic,
              fields,
              fields.elastic_dofs,
              constraints.elastic_hanging_nodes(),
              elastic);
    take_over(of_phase_field,
              fields,
              fields.phase_field_dofs,
              constraints.phase_field_hanging_nodes(),
              phase_field);
  }



#define INSTANTIATE(dim)                         \
  template void refine_and_transfer(             \
    parallel::distributed::Triangulation<dim> &, \
    Fields<dim> &,                               \
    Constraints<dim> &,                          \
    const std::vector<Vector *> &,               \
    const std::vector<Vector *> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
