// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_steps_fixed_point_h
#define mixed_cracks_steps_fixed_point_h

#include <base/linear_algebra.h>

#include <deque>

namespace MixedCracks
{
  struct FixedPointOptions
  {
    /// A step goes this factor times g(x) - x; 1: plain iteration.
    double over_relaxation = 1.;
    /// No step is longer than this factor times |g(x) - x|; off when not
    /// larger than over_relaxation.
    double largest_acceleration = 1.;
    /// Earlier iterates of Anderson's method; 0: off.
    unsigned int depth = 0;
  };

  /// Acceleration of x = g(x) where g is smooth in some phases and a moving
  /// front in others: Anderson's method (type II, [Walker and Ni, SIAM J.
  /// Numer. Anal. 49 (2011)]) where successive steps have something to do
  /// with each other, long steps where they grow in one direction, which is
  /// the way out of an unstable state, and plain over-relaxation elsewhere.
  class FixedPointAcceleration
  {
  public:
    using Vector = LinearAlgebra::Vector;

    explicit FixedPointAcceleration(const FixedPointOptions &options)
      : options(options)
    {}

    /// Forget all iterates.
    void restart();

    /// The next iterate after @p x, given @p image, g(x). Vectors without
    /// ghosts. Collective.
    Vector next(const Vector &x, const Vector &image);

    /// Whether the last iterates left a state that plain iterations run away
    /// from: there is no stable one nearby. Never when long steps are off.
    bool
    runs_away() const
    {
      return is_growing;
    }

    /// Length of the last step over |g(x) - x|; 0 before the first.
    double
    factor() const
    {
      return last_factor;
    }

  private:
    enum class Phase
    {
      growing,  ///< away from here, in one direction
      smooth,   ///< a step foretells the next
      unrelated ///< a moving front, or the start
    };

    Phase phase_of(const Vector &difference) const;

    /// Whether it leads against that of the step before.
    bool turns_back(const Vector &difference) const;

    void remember(Phase phase, const Vector &x, const Vector &difference);

    Vector anderson_step(const Vector &difference) const;

    const FixedPointOptions options;
    // the last iterate and g(x) - x there; then their changes, latest first
    bool               has_last = false;
    Vector             last_x, last_difference;
    std::deque<Vector> changes_of_x, changes_of_difference;
    double             last_factor = 0.;
    bool               is_growing  = false;
  };
} // namespace MixedCracks

#endif
