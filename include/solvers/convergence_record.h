// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_convergence_record_h
#define mixed_cracks_solvers_convergence_record_h

#include <algorithm>
#include <cmath>
#include <vector>

namespace MixedCracks
{
  /// How many iterations a solver has needed for each reduction of its
  /// residual, to judge later solutions by.
  class ConvergenceRecord
  {
  public:
    void
    clear()
    {
      digits.clear();
    }

    bool
    is_empty() const
    {
      return digits.empty();
    }

    /// The residual is 10^-@p reduction times the first one after one more
    /// iteration.
    void
    add(const double reduction)
    {
      digits.push_back(digits.empty() ? reduction
                                      : std::max(reduction, digits.back()));
    }

    /// For that reduction; beyond the last recorded one as many per digit as on
    /// average. Infinite without a record.
    double
    iterations_for(const double reduction) const
    {
      const auto reached =
        std::lower_bound(digits.begin(), digits.end(), reduction);
      if (reached != digits.end())
        return reached - digits.begin() + 1.;
      return digits.empty() || digits.back() <= 0.
               ? HUGE_VAL
               : digits.size() * reduction / digits.back();
    }

  private:
    std::vector<double> digits;
  };
} // namespace MixedCracks

#endif
