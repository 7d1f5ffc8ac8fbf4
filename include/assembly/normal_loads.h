// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_normal_loads_h
#define mixed_cracks_assembly_normal_loads_h

#include <deal.II/base/function.h>

#include <deal.II/lac/affine_constraints.h>

#include <discretization/fields.h>

#include <map>
#include <memory>

namespace MixedCracks
{
  /// Functions of one component by boundary id; MPa.
  template <int dim>
  using BoundaryFunctions = std::map<dealii::types::boundary_id,
                                     std::shared_ptr<dealii::Function<dim>>>;

  /// Nodal forces (N/mm, per mm thickness in 2-d) of the tractions
  /// @p factor times function times the outward normal of the undeformed body,
  /// added to @p forces, whose ranks have summed up then. Times of the
  /// functions are set before. Throws InputError on all ranks for a value that
  /// is not finite. Collective.
  template <int dim>
  void add_normal_forces(const Fields<dim>                       &fields,
                         const BoundaryFunctions<dim>            &functions,
                         double                                   factor,
                         const dealii::AffineConstraints<double> &constraints,
                         LinearAlgebra::Vector                   &forces);

  /// A pressure that stays normal to the deformed boundary and acts on its
  /// deformed area. In 2-d the deformed thickness is the undeformed one (plane
  /// strain). All members that evaluate are collective and throw as above.
  template <int dim>
  class FollowerPressure
  {
  public:
    using Constraints = dealii::AffineConstraints<double>;
    using Vector      = LinearAlgebra::Vector;

    /// @p pressures: positive where they press on the body.
    FollowerPressure(const Fields<dim>     &fields,
                     BoundaryFunctions<dim> pressures);

    bool
    any() const
    {
      return !pressures.empty();
    }

    /// The pressure is from now on (1 - part) p(from) + part p(to); times in s.
    void set_level(double from, double to, double part);

    /// From the present level the @p fraction of what is left to p(to).
    void advance_level(double fraction);

    /// Nodal forces at the displacements of @p elastic, which has ghosts and is
    /// kept for the two below; added to @p forces.
    void add_forces(const Vector      &elastic,
                    const Constraints &constraints,
                    Vector            &forces);

    /// Add minus the derivative of these forces, the part of the Jacobian of
    /// internal minus external forces; not symmetric in general.
    void add_tangent(const Constraints           &constraints,
                     LinearAlgebra::SparseMatrix &matrix) const;

    /// Add minus their derivative along @p direction, which has ghosts.
    void add_tangent_times(const Vector      &direction,
                           const Constraints &constraints,
                           Vector            &result) const;

  private:
    const Fields<dim>           &fields;
    const BoundaryFunctions<dim> pressures;
    double                       from = 0., to = 0., part = 1.;
    Vector                       state; // of the last add_forces()
  };
} // namespace MixedCracks

#endif
