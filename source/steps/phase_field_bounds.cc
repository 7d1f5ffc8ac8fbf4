// SPDX-License-Identifier: GPL-2.0-or-later
// Phase fields node by node: how far two are apart, and steps that keep within
// 0 <= phi <= upper, the obstacle of irreversibility.

#include <deal.II/base/mpi.h>

#include <steps/phase_field_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  double
  largest_difference(const Vector &a, const Vector &b, const bool modulus)
  {
    double     largest = 0.;
    const auto owned   = a.locally_owned_elements();
    for (const auto i : owned)
    {
      double difference = a(i) - b(i);
      if (std::isnan(difference))
        difference = std::numeric_limits<double>::infinity();
      largest = std::max(largest, modulus ? std::abs(difference) : difference);
    }
    return Utilities::MPI::max(largest, a.get_mpi_communicator());
  }



  void
  move_within_bounds(const Vector &base,
                     const Vector &target,
                     const double  factor,
                     const Vector &upper,
                     Vector       &result)
  {
    const IndexSet owned = base.locally_owned_elements();
    Vector         values(owned, base.get_mpi_communicator());
    for (const auto i : owned)
      values(i) = std::clamp(base(i) + factor * (target(i) - base(i)),
                             0.,
                             std::max(0., static_cast<double>(upper(i))));
    values.compress(VectorOperation::insert);
    result = values;
  }



  void
  lower_where(const Vector &marks, const Vector &value, Vector &result)
  {
    Vector values(marks);
    for (const auto i : marks.locally_owned_elements())
      values(i) = marks(i) > 0. ? std::min<double>(value(i), result(i))
                                : static_cast<double>(result(i));
    values.compress(VectorOperation::insert);
    result = values;
  }
} // namespace MixedCracks
