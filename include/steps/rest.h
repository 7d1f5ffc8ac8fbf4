// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_steps_rest_h
#define mixed_cracks_steps_rest_h

#include <deque>

namespace MixedCracks
{
  /// Tells whether a quantity that an iteration changes has come to rest,
  /// where the iteration itself cannot tell: a tip that is driven only slightly
  /// above critical moves the phase field by little in each iteration, and for
  /// ever. The same values give the same answer on all ranks.
  class RestWatch
  {
  public:
    /// Forget all values.
    void restart();

    /// The value after an iteration whose step was @p factor times a plain one;
    /// a factor of 0 replaces the last value by a better one.
    void add(double value, double factor);

    /// Whether the values of the last five iterations lie within
    /// @p tolerance times the plain iterations they stand for, as a fraction of
    /// the last value, or of a tenth of the first where that is larger.
    bool is_at_rest(double tolerance) const;

  private:
    struct Entry
    {
      double value;
      double factor;
    };

    std::deque<Entry> last;
    double            first = 0.;
  };
} // namespace MixedCracks

#endif
