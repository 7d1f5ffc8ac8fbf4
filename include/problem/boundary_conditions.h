// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_boundary_conditions_h
#define mixed_cracks_problem_boundary_conditions_h

#include <base/expression.h>

#include <deal.II/base/function.h>
#include <deal.II/base/parameter_handler.h>

#include <discretization/boundary_ids.h>
#include <discretization/periodic_sides.h>

#include <problem/mean_strain.h>
#include <problem/rotation.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// Expressions in x, y, z, t, one per component; a component without one
  /// is 0.
  template <int dim>
  class ExpressionFunction : public dealii::Function<dim>
  {
  public:
    explicit ExpressionFunction(const unsigned int n_components)
      : dealii::Function<dim>(n_components)
      , expressions(n_components)
      , rotations(n_components)
    {}

    /// With @p rotation the expression is an angle (rad), and the value that
    /// component of the displacement.
    void
    set(const unsigned int                   component,
        std::shared_ptr<const Expression>    value,
        std::shared_ptr<const Rotation<dim>> rotation = nullptr)
    {
      expressions[component] = std::move(value);
      rotations[component]   = std::move(rotation);
    }

    double value(const dealii::Point<dim> &point,
                 const unsigned int        component) const override;

  private:
    std::vector<std::shared_ptr<const Expression>>    expressions;
    std::vector<std::shared_ptr<const Rotation<dim>>> rotations;
  };

  /// One entry "boundary : component : expression", or "component :
  /// expression" where there is no boundary.
  template <int dim>
  struct BoundaryEntry
  {
    /// the component that is normal to the boundary, whichever it is
    static constexpr unsigned int symmetry =
      dealii::numbers::invalid_unsigned_int;

    std::string boundary;
    /// dim: the phase field, in tractions the normal
    unsigned int                         component;
    std::shared_ptr<const Expression>    expression;
    std::shared_ptr<const Rotation<dim>> rotation{}; ///< by the expression
  };

  /// One entry "point : component : expression", or with the name of a point
  /// set in the place of the point; of the phase field it has component dim.
  template <int dim>
  struct PointEntry
  {
    dealii::Point<dim>                point; ///< mm
    unsigned int                      component;
    std::shared_ptr<const Expression> expression;
    std::string                       set; ///< empty: the point
  };

  /// Subsection "Boundary conditions".
  template <int dim>
  class BoundaryConditions
  {
  public:
    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError for entries that cannot be read or name a boundary
    /// that is not in @p boundaries; @p hint says more about those.
    /// @p point_sets: the names of those. A body that @p is_periodic need not
    /// be held.
    void check(const NamedBoundaries              &boundaries,
               const std::function<std::string()> &hint        = {},
               const std::vector<std::string>     &point_sets  = {},
               bool                                is_periodic = false) const;

    /// Throws InputError for what cannot be given on the periodic sides
    /// @p pairs.
    void check_periodic(const std::vector<PeriodicPair> &pairs,
                        const NamedBoundaries           &boundaries) const;

    /// Entries of "Displacement", 'all' spread over the components; those on
    /// the phase field have component dim, those of symmetry a name.
    std::vector<BoundaryEntry<dim>> displacements() const;

    /// Entries of "Displacement at points", 'all' spread over the components.
    std::vector<PointEntry<dim>> point_displacements() const;

    /// Entries of "Force at points", N.
    std::vector<PointEntry<dim>> point_forces() const;

    /// Entries of "Phase field at points".
    std::vector<PointEntry<dim>> point_phase_fields() const;

    using LoadsByBoundary =
      std::map<std::string, std::shared_ptr<ExpressionFunction<dim>>>;

    /// Nodal loads by boundary, components 0 to dim - 1; MPa.
    LoadsByBoundary tractions(unsigned int n_components) const;

    /// Of one component each: those along the outward normal; MPa.
    LoadsByBoundary normal_tractions() const;

    /// Likewise, positive where they press on the body; MPa.
    LoadsByBoundary pressures() const;

    /// N/mm^3; null when there is none.
    std::shared_ptr<ExpressionFunction<dim>>
    body_force(unsigned int n_components) const;

    /// "Mean strain", of a body with periodic sides.
    MeanStrain<dim>
    mean_strain(const bool finite_strain) const
    {
      return {mean_strain_text, finite_strain};
    }

    /// mm
    double
    unbreakable_margin() const
    {
      return margin;
    }

  private:
    std::string displacement_text;
    std::string point_displacement_text;
    std::string point_force_text;
    std::string point_phase_field_text;
    std::string traction_text;
    std::string pressure_text;
    std::string body_force_text;
    std::string mean_strain_text;
    double      margin = 0.;
  };
} // namespace MixedCracks

#endif
