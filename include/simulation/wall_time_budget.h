// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_wall_time_budget_h
#define mixed_cracks_simulation_wall_time_budget_h

namespace MixedCracks
{
  /// A limit of wall time, and what has to be left of it for an end in order,
  /// measured from what the run has done so far. Times in s, the present ones
  /// since the start of the process.
  class WallTimeBudget
  {
  public:
    /// 0: no limit.
    explicit WallTimeBudget(const double limit)
      : given_limit(limit)
    {}

    /// What a load step, tried or accepted, has taken.
    void note_step(double duration);

    /// What writing a checkpoint has taken.
    void note_checkpoint(double duration);

    /// What a call that cannot be interrupted has taken.
    void note_call(double duration);

    /// To write a checkpoint after the call that goes on. Before the first
    /// checkpoint it counts as much as a step, which is more.
    double reserve() const;

    /// Whether a load step that goes on must be given up at @p now.
    bool is_over(double now) const;

    /// Whether the next load step is not to be begun at @p now.
    bool is_over_for_a_step(double now) const;

    double
    limit() const
    {
      return given_limit;
    }

    double
    longest_step() const
    {
      return step;
    }

  private:
    const double given_limit;
    double       step       = 0.;
    double       checkpoint = -1.; // unknown
    double       call       = 0.;
  };
} // namespace MixedCracks

#endif
