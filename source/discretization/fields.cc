// SPDX-License-Identifier: GPL-2.0-or-later
// The elements: Q2 x Q1 for (u, p), stable in the sense of Babuska and Brezzi
// (Taylor-Hood), so that p does not oscillate where lambda/mu is large, and Q1
// for phi, which keeps its bounds between the nodes. Q1 alone for u in the
// displacement formulation: locks, which is what it is there to show.
//
//        o---o---o        p---+---p        f---+---f     o  u, dim values
//        |       |        |       |        |       |     p  pressure
//        o   o   o        +       +        +       +     f  phase field
//        |       |        |       |        |       |
//        o---o---o        p---+---p        f---+---f
//
// Gauss points: degree of u plus one per direction, exact for the polynomials
// of degree 2 (degree u) + 1 in each direction, which the stiffness of an
// intact rectangle is; rational or kinked integrands are not.

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <discretization/fields.h>

namespace MixedCracks
{
  namespace
  {
    template <int dim>
    dealii::FESystem<dim>
    make_elastic_element(const FieldLayout &layout)
    {
      const dealii::FE_Q<dim> displacement(layout.displacement_degree);
      if (layout.mixed)
        return dealii::FESystem<dim>(
          displacement, dim, dealii::FE_Q<dim>(1), 1);
      return dealii::FESystem<dim>(displacement, dim);
    }



    template <int dim>
    DofSets
    dof_sets(const dealii::DoFHandler<dim> &handler)
    {
      return {handler.locally_owned_dofs(),
              dealii::DoFTools::extract_locally_relevant_dofs(handler)};
    }
  } // namespace



  template <int dim>
  Fields<dim>::Fields(const dealii::Triangulation<dim> &triangulation,
                      const FieldLayout                &layout)
    : elastic(triangulation)
    , phase_field(triangulation)
    , layout(layout)
    , mapping(1)
    , quadrature(dealii::QGauss<dim>(layout.displacement_degree + 1))
    , elastic_element(make_elastic_element<dim>(layout))
    , phase_field_element(1)
  {}



  template <int dim>
  void
  Fields<dim>::distribute()
  {
    elastic.distribute_dofs(elastic_element);
    phase_field.distribute_dofs(phase_field_element);
    elastic_dofs     = dof_sets(elastic);
    phase_field_dofs = dof_sets(phase_field);
  }



  template class Fields<2>;
  template class Fields<3>;
} // namespace MixedCracks
