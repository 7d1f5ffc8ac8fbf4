// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_iteration_control_h
#define mixed_cracks_solvers_iteration_control_h

#include <base/stop_request.h>

#include <deal.II/lac/solver_control.h>

#include <solvers/convergence_record.h>

namespace MixedCracks
{
  /// Of an iterative solution. Gives up when the run is to stop, and when the
  /// solution is behind what another one had reached after 1/growth of its
  /// iterations, some at the beginning not counted.
  class IterationControl : public dealii::SolverControl
  {
  public:
    /// @p other: nullptr: none.
    IterationControl(const StopCheck         &stop,
                     const unsigned int       max_iterations,
                     const double             tolerance,
                     const ConvergenceRecord *other,
                     const double             growth)
      : SolverControl(max_iterations, tolerance, false, false)
      , stop(stop)
      , other(other)
      , growth(growth)
    {}

    State
    check(const unsigned int step, const double residual) override
    {
      SolverControl::check(step, residual);
      if (step > 0 && residual > 0.)
        record.add(std::log10(initial_value() / residual));
      if (lcheck != iterate)
        return lcheck;
      if (other != nullptr && step > always_tolerated &&
          record.digits() <
            other->digits_after((step - always_tolerated) / growth))
        lcheck = failure;
      if (is_to_stop(stop, "iteration of block AMG"))
      {
        is_interrupted = true;
        lcheck         = failure;
      }
      return lcheck;
    }

    bool              is_interrupted = false;
    ConvergenceRecord record;

  private:
    /// a few iterations say nothing about a preconditioner
    static constexpr unsigned int always_tolerated = 4;

    const StopCheck               &stop;
    const ConvergenceRecord *const other;
    const double                   growth;
  };
} // namespace MixedCracks

#endif
