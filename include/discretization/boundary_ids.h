// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_boundary_ids_h
#define mixed_cracks_discretization_boundary_ids_h

#include <base/errors.h>
#include <base/names.h>

#include <deal.II/base/types.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// The ids of the faces that a name of a boundary stands for. A face has one
  /// id, but may have several names: the lower face of a notch is 'notch' and
  /// 'notch lower'.
  struct BoundaryIds : std::set<dealii::types::boundary_id>
  {
    using Set = std::set<dealii::types::boundary_id>;
    using Set::Set;

    /// One id, which is what most names stand for.
    BoundaryIds(const dealii::types::boundary_id id)
    {
      insert(id);
    }

    bool
    contains(const dealii::types::boundary_id id) const
    {
      return count(id) > 0;
    }
  };

  /// Boundaries by name.
  using NamedBoundaries = std::map<std::string, BoundaryIds>;

  /// The names alone.
  inline std::vector<std::string>
  names_of(const NamedBoundaries &boundaries)
  {
    std::vector<std::string> names;
    for (const auto &boundary : boundaries)
      names.push_back(boundary.first);
    return names;
  }

  /// What @p name stands for. Throws InputError that names @p parameter and
  /// what is allowed, and may end with @p more.
  inline const BoundaryIds &
  boundary_of(const std::string                  &name,
              const NamedBoundaries              &boundaries,
              const std::string                  &parameter,
              const std::function<std::string()> &more = {})
  {
    const auto found = boundaries.find(name);
    if (found == boundaries.end())
    {
      const std::string hint = more ? more() : "";
      throw InputError(parameter + ": boundary: " +
                       unknown_name_message(name, names_of(boundaries)) +
                       (hint.empty() ? "" : " " + hint));
    }
    return found->second;
  }
} // namespace MixedCracks

#endif
