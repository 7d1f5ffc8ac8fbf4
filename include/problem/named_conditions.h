// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_named_conditions_h
#define mixed_cracks_problem_named_conditions_h

#include <base/expression.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// A part of space with a name: where an expression in x, y, z is not 0.
  template <int dim>
  struct NamedCondition
  {
    std::string name;
    Expression  condition;

    /// In 2-d z is 0; mm. Throws InputError where the value is not finite.
    bool holds_at(const dealii::Point<dim> &point) const;
  };

  /// Read 'name : condition ; ...'. Throws InputError naming @p parameter for
  /// what is not of that form, and for a name that is there twice, begins like
  /// a number or has one of the signs that lists are made of.
  template <int dim>
  std::vector<NamedCondition<dim>>
  parse_named_conditions(const std::string &text, const std::string &parameter);

  /// Whether @p text begins as names do and numbers do not.
  bool begins_as_name(const std::string &text);

  /// Of @p points, not empty, those at most three that are nearest to where a
  /// condition holds in the box around them or as far again around it; none
  /// when it seems to hold nowhere. Units: mm.
  template <int dim>
  std::vector<dealii::Point<dim>>
  nearest_points(const NamedCondition<dim>             &condition,
                 const std::vector<dealii::Point<dim>> &points);

  /// Where a condition that none of @p points meets may have been meant, for
  /// an error message: the nearest_points(), or else what @p points span; as
  /// "the nearest are (0, 1), (0, 2)".
  template <int dim>
  std::string nearest_in_words(const NamedCondition<dim>             &condition,
                               const std::vector<dealii::Point<dim>> &points);
} // namespace MixedCracks

#endif
