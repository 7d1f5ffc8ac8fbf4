// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_periodic_constraints_h
#define mixed_cracks_discretization_periodic_constraints_h

#include <deal.II/lac/affine_constraints.h>

#include <discretization/fields.h>
#include <discretization/periodic_sides.h>

#include <map>
#include <vector>

namespace MixedCracks
{
  /// Periodic sides as constraints of the elastic fields on one mesh. A
  /// dependent dof is a sum of others plus, of a displacement, its part of E L.
  template <int dim>
  class PeriodicConstraints
  {
  public:
    using Constraints = dealii::AffineConstraints<double>;

    PeriodicConstraints(const Fields<dim> &fields,
                        Periodicity<dim>   periodicity);

    /// Whether there are any.
    bool
    any() const
    {
      return !periodicity.pairs.empty();
    }

    /// To be called when the mesh changed, with the hanging nodes, not closed;
    /// where there are any.
    void reinit(const Constraints &hanging_nodes);

    /// Add those of the phase field to its hanging nodes.
    void add_to_phase_field(Constraints &hanging_nodes) const;

    /// With the hanging nodes, homogeneous: of corrections.
    const Constraints &
    homogeneous() const
    {
      return elastic;
    }

    /// Make dependent dofs of a state (without ghosts) fit to the others and to
    /// the mean strain of @p time.
    void fit(double time, LinearAlgebra::Vector &state) const;

    /// Of nodal forces that know of hanging nodes only, move those of dependent
    /// nodes to the nodes that they depend on.
    void fold(LinearAlgebra::Vector &forces) const;

    /// A displacement that is that of another node plus (E period).
    struct Partner
    {
      dealii::types::global_dof_index slave, master;
      unsigned int                    component;
      dealii::Tensor<1, dim>          period;   ///< mm
      dealii::Point<dim>              position; ///< of the slave
    };

    /// Those that this rank knows.
    const std::vector<Partner> &
    partners() const
    {
      return all_partners;
    }

    /// The one that a displacement depends on, or itself.
    dealii::types::global_dof_index
    master_of(dealii::types::global_dof_index dof) const;

    /// Owned displacements on the sides.
    const dealii::IndexSet &
    dofs_of_sides() const
    {
      return side_dofs;
    }

    /// Of the coarse mesh, after reinit().
    const PeriodicSides<dim> &
    sides() const
    {
      return matched;
    }

    dealii::Tensor<2, dim>
    strain_at(const double time) const
    {
      return periodicity.strain_at(time);
    }

  private:
    /// A displacement on a side.
    struct Node
    {
      unsigned int       component;
      dealii::Point<dim> position;
    };
    using Nodes = std::map<dealii::types::global_dof_index, Node>;

    /// How far a dependent displacement is from what it depends on.
    struct Jump
    {
      dealii::types::global_dof_index dof;
      unsigned int                    component;
      dealii::Tensor<1, dim>          period;
    };

    Nodes nodes_on_sides() const;

    void find_jumps(const Constraints &hanging_nodes,
                    const Constraints &open,
                    const Nodes       &nodes);

    void find_partners(const Constraints &hanging_nodes, const Nodes &nodes);

    const Fields<dim>     &fields;
    const Periodicity<dim> periodicity;
    PeriodicSides<dim>     matched;
    Constraints            elastic;
    std::vector<Jump>      jumps; // of owned dofs
    std::vector<Partner>   all_partners;
    std::map<dealii::types::global_dof_index, dealii::types::global_dof_index>
                                                 masters;
    std::vector<dealii::types::global_dof_index> folded; // owned ones
    dealii::IndexSet                             side_dofs;
  };
} // namespace MixedCracks

#endif
