// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_compat_h
#define mixed_cracks_base_compat_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/subscriptor.h>

#include <deal.II/lac/affine_constraints.h>

namespace MixedCracks
{
  /// The only file that asks for the version of deal.II (9.4 to 9.7).
  namespace Compat
  {
    /// Base of what library objects keep a pointer to.
#if DEAL_II_VERSION_GTE(9, 7, 0)
    using Observed = dealii::EnableObserverPointer;
#else
    using Observed = dealii::Subscriptor;
#endif

    /// Start anew with constraints on @p relevant of the dofs of a handler.
    inline void
    reinit(dealii::AffineConstraints<double>       &constraints,
           [[maybe_unused]] const dealii::IndexSet &owned,
           const dealii::IndexSet                  &relevant)
    {
#if DEAL_II_VERSION_GTE(9, 6, 0)
      constraints.reinit(owned, relevant);
#else
      constraints.reinit(relevant);
#endif
    }
  } // namespace Compat
} // namespace MixedCracks

#endif
