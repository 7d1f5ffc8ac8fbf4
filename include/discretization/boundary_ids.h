// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_boundary_ids_h
#define mixed_cracks_discretization_boundary_ids_h

#include <deal.II/base/types.h>

#include <map>
#include <set>
#include <string>

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
} // namespace MixedCracks

#endif
