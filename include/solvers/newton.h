// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_newton_h
#define mixed_cracks_solvers_newton_h

#include <base/linear_algebra.h>

#include <solvers/linear_solver.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace MixedCracks
{
  /// Size of a residual relative to the terms that cancel in it; the same on
  /// every rank.
  struct ResidualSize
  {
    double displacement = 0.;
    double pressure     = 0.;
    /// what they are relative to, for states in which these terms differ much
    double displacement_scale = 1.;
    double pressure_scale     = 1.;

    /// NaN where one of them is.
    double
    largest() const
    {
      return displacement > pressure || std::isnan(displacement) ? displacement
                                                                 : pressure;
    }

    /// The same relative to the terms that cancelled in @p other.
    ResidualSize
    relative_to(const ResidualSize &other) const
    {
      const auto ratio = [](const double scale, const double of_other) {
        return of_other > 0. ? scale / of_other : 1.;
      };
      return {displacement *
                ratio(displacement_scale, other.displacement_scale),
              pressure * ratio(pressure_scale, other.pressure_scale),
              other.displacement_scale,
              other.pressure_scale};
    }
  };

  struct NewtonOptions
  {
    double tolerance = 1e-8; ///< of ResidualSize::largest()
    /// also enough: this times the residual at the start
    double       relative_tolerance = 0.;
    unsigned int max_iterations     = 25;
    /// after so many iterations any reduction is enough; 0: off
    unsigned int enough_iterations = 0;
    /// ... if what is left is no larger than this
    double       enough_residual = std::numeric_limits<double>::infinity();
    unsigned int max_bisections  = 6; ///< of the line search
    /// the same where it descends on a potential or is kept off a barrier
    unsigned int max_guarded_bisections = 20;
    /// an old matrix is given up when it reduces the residual by less
    double required_reduction = 0.3;
    /// at finite strain an old matrix is tried where F has changed by less than
    /// this since then, relative to F
    double largest_deformation_change = 0.02;
    /// iterative solvers reduce the residual by this at first ...
    double loose_linear_tolerance = 1e-3;
    /// ... and never by less than this
    double tight_linear_tolerance = 1e-8;
  };

  struct NewtonOutcome
  {
    bool         converged         = false;
    unsigned int iterations        = 0;
    unsigned int linear_iterations = 0;
    ResidualSize first;
    ResidualSize last;
    std::string  reason; ///< why it stopped short, in words
  };

  /// What Newton's method sees of a problem: callbacks, all collective.
  struct NewtonProblem
  {
    /// Evaluate the residual at the present iterate and keep it.
    std::function<ResidualSize()> residual;
    /// Make the matrix that of the present iterate. @p force: also when the
    /// one at hand is near enough to be tried first.
    std::function<LinearOutcome(bool force)> update_matrix;
    /// Solve for the correction of the kept residual, up to
    /// @p relative_tolerance.
    std::function<LinearOutcome(double relative_tolerance)> solve;
    /// Move the iterate by @p factor times the correction.
    std::function<void(double factor)> move;
    /// Whether to leave without a solution; may be empty. The same on every
    /// rank.
    std::function<bool()> is_to_stop;

    // With the first of these the line search is another one.

    /// Whether the present iterate is one at all, as one that is turned inside
    /// out is not; the residual of others is not asked for. May be empty.
    std::function<bool()> is_admissible;
    /// What the residual is the gradient of, by the unknowns that are not
    /// multipliers, at the iterate whose residual was asked for last or at
    /// which the correction was computed; may be empty, or no number.
    std::function<double()> potential;
    /// Size of the terms that cancel in the potential() asked for last: what
    /// differs by some machine epsilons of it is the same. May be empty.
    std::function<double()> potential_terms;
    /// The derivative of the potential along the correction, where it was asked
    /// for last.
    std::function<double()> slope;
    /// Whether the solution is a minimum of the potential: the residual alone
    /// is no reason to take a step that leads up.
    bool is_minimum = false;
  };

  /// Semismooth Newton with bisection line search. Between the kinks of the
  /// split the elastic problem is linear, so one iteration is the rule; an
  /// old matrix is used as long as it contracts. The tolerance of the linear
  /// solves follows from how far the last linear model was off (Eisenstat and
  /// Walker, SIAM J. Sci. Comput. 17 (1996), choice 1), and is never below
  /// what the target asks for. Where iterates may be inadmissible, the line
  /// search of line_search.h: an iteration that finds no step is repeated with
  /// a new matrix, and is the end if that is one already; the iterate is then
  /// where it was.
  NewtonOutcome solve_newton(const NewtonProblem &problem,
                             const NewtonOptions &options);
} // namespace MixedCracks

#endif
