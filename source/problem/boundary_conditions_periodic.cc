// SPDX-License-Identifier: GPL-2.0-or-later
// What cannot stand together with periodic sides. A face on one has its
// partner, not a condition or a load: what would act there acts on the next
// cell of the pattern, too.

#include <base/errors.h>
#include <base/ranges.h>

#include <problem/boundary_conditions.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  void
  BoundaryConditions<dim>::check_periodic(
    const std::vector<PeriodicPair> &pairs,
    const NamedBoundaries           &boundaries) const
  {
    if (pairs.empty() && !mean_strain_text.empty())
      throw InputError("Boundary conditions/Mean strain: found '" +
                       mean_strain_text +
                       "' without Geometry/Periodic sides. Allowed is nothing "
                       "where there are none.");
    const auto require_free = [&](const std::string &name,
                                  const std::string &entry) {
      const BoundaryIds &ids = boundaries.at(name);
      for (const PeriodicPair &pair : pairs)
        for (const BoundaryIds &side : pair.sides)
          if (any_of(ids, [&side](const auto id) { return side.contains(id); }))
            throw InputError("Boundary conditions/" + entry + ": found '" +
                             name +
                             "', which is one of Geometry/Periodic sides. "
                             "Allowed are other boundaries.");
    };
    for (const auto &entry : displacements())
      require_free(entry.boundary, "Displacement");
    for (const auto &entry : tractions(dim))
      require_free(entry.first, "Traction");
    for (const auto &entry : normal_tractions())
      require_free(entry.first, "Traction");
    for (const auto &entry : pressures())
      require_free(entry.first, "Pressure");
  }



  template void
  BoundaryConditions<2>::check_periodic(const std::vector<PeriodicPair> &,
                                        const NamedBoundaries &) const;
  template void
  BoundaryConditions<3>::check_periodic(const std::vector<PeriodicPair> &,
                                        const NamedBoundaries &) const;
} // namespace MixedCracks
