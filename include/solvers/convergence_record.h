// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_convergence_record_h
#define mixed_cracks_solvers_convergence_record_h

#include <algorithm>
#include <cmath>
#include <vector>

namespace MixedCracks
{
  /// How far a solution has come after each of its iterations, in digits: the
  /// residual was 10^-digits of the first one, or less. To judge later
  /// solutions by.
  class ConvergenceRecord
  {
  public:
    /// After one more iteration. The residual of conjugate gradients may grow
    /// in between; what it has been counts.
    void
    add(const double digits)
    {
      reached.push_back(std::max(digits, this->digits()));
    }

    /// After the last iteration.
    double
    digits() const
    {
      return reached.empty() ? 0. : reached.back();
    }

    /// After that many iterations, beyond the last one at the mean rate.
    /// Infinite without a record.
    double
    digits_after(const unsigned int n_iterations) const
    {
      if (reached.empty())
        return HUGE_VAL;
      if (n_iterations > reached.size())
        return digits() * n_iterations / reached.size();
      return n_iterations == 0 ? 0. : reached[n_iterations - 1];
    }

  private:
    std::vector<double> reached;
  };
} // namespace MixedCracks

#endif
