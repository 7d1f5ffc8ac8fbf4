// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_fields_h
#define mixed_cracks_discretization_fields_h

#include <base/linear_algebra.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/quadrature.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/component_mask.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values_extractors.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/tria.h>

namespace MixedCracks
{
  /// Which unknowns there are.
  struct FieldLayout
  {
    bool         mixed;               ///< with a pressure unknown
    unsigned int displacement_degree; ///< 2 in the mixed formulation
  };

  /// Owned and relevant degrees of freedom of one handler on this rank.
  struct DofSets
  {
    dealii::IndexSet owned;
    dealii::IndexSet relevant;
  };

  /// The finite element fields on one mesh: the elastic ones (displacement
  /// Q2, pressure Q1 [Mang21, 3.3]) in one numbering, the phase field (Q1) in
  /// another. With a lagged phase field the Jacobian is block triangular in
  /// these two, so each has its own matrix and nothing couples them.
  template <int dim>
  class Fields
  {
  public:
    Fields(const dealii::Triangulation<dim> &triangulation,
           const FieldLayout                &layout);

    /// Number the degrees of freedom; to be called when the mesh changed.
    void distribute();

    dealii::DoFHandler<dim>       elastic;
    dealii::DoFHandler<dim>       phase_field;
    const FieldLayout             layout;
    const dealii::MappingQ<dim>   mapping;
    const dealii::Quadrature<dim> quadrature;

    const dealii::FEValuesExtractors::Vector displacement{0};
    const dealii::FEValuesExtractors::Scalar pressure{dim};

    DofSets elastic_dofs;
    DofSets phase_field_dofs;

    dealii::types::global_dof_index
    n_dofs() const
    {
      return elastic.n_dofs() + phase_field.n_dofs();
    }

    MPI_Comm
    communicator() const
    {
      return elastic.get_communicator();
    }

    /// A vector without ghosts, zero.
    LinearAlgebra::Vector
    owned_vector(const DofSets &dofs) const
    {
      return LinearAlgebra::Vector(dofs.owned, communicator());
    }

    /// A vector with ghosts, zero; filled by assignment of an owned one.
    LinearAlgebra::Vector
    ghosted_vector(const DofSets &dofs) const
    {
      return LinearAlgebra::Vector(dofs.owned, dofs.relevant, communicator());
    }

  private:
    dealii::FESystem<dim> elastic_element;
    dealii::FE_Q<dim>     phase_field_element;
  };
} // namespace MixedCracks

#endif
