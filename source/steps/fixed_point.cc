// SPDX-License-Identifier: GPL-2.0-or-later
// Acceleration of the alternate minimisation, x = phi~ and g(x) the phi that
// one iteration gives for it; f(x) = g(x) - x is the difference. The plain
// iteration x + f(x) converges like the largest eigenvalue of dg/dx: 0.95 and
// worse near the onset of a crack. Three phases, by the angle between f now and
// before,
//
//   cosine = f . f_before / (|f| |f_before|):
//
//   growing    |f| >= |f_before|, cosine > 0.9: an unstable state is left.
//              A long step x + c f, c a quarter of the largest factor.
//   smooth     |cosine| > 0.5, or |f| < 0.7 |f_before|: Anderson's method of
//              type II (Walker and Ni, SIAM J. Numer. Anal. 49 (2011)), below,
//              where it goes farther than over-relaxation or f shrinks well.
//              Where its step leads against f, the phase is growing after all.
//              Where f turns back, cosine < -0.5, and has been smooth for as
//              long as is remembered, it is taken however far it goes: x +
//              omega f may go to and fro for ever, from an eigenvalue of 1 -
//              2/omega on, -1/3 for omega = 1.5.
//   unrelated  a front that moves by a cell per iteration, whose differences
//              have nothing to do with each other: x + omega f, omega the
//              over-relaxation.

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <steps/fixed_point.h>

#include <cmath>

namespace MixedCracks
{
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // cosines of the angle between g(x) - x of two iterates
    constexpr double same_direction = 0.9;
    constexpr double related        = 0.5;
    // a difference that shrinks by this is smooth convergence whatever the
    // angle
    constexpr double clear_reduction = 0.7;
    // the long step that leaves an unstable state, of the largest acceleration
    constexpr double growth_part = 0.25;
    // relative to the largest entry of the small least-squares problem
    constexpr double regularization = 1e-10;
  } // namespace



  void
  FixedPointAcceleration::restart()
  {
    has_last = false;
    changes_of_x.clear();
    changes_of_difference.clear();
    last_factor = 0.;
    is_growing  = false;
  }



  FixedPointAcceleration::Phase
  FixedPointAcceleration::phase_of(const Vector &difference) const
  {
    if (!has_last)
      return Phase::unrelated;
    const double now = difference.l2_norm(), before = last_difference.l2_norm();
    if (now == 0. || before == 0.)
      return Phase::unrelated;
    const double cosine = (difference * last_difference) / (now * before);
    if (now >= before && cosine > same_direction)
      return Phase::growing;
    return std::abs(cosine) > related || now < clear_reduction * before
             ? Phase::smooth
             : Phase::unrelated;
  }



  bool
  FixedPointAcceleration::turns_back(const Vector &difference) const
  {
    return difference * last_difference <
           -related * difference.l2_norm() * last_difference.l2_norm();
  }



  // With the changes dX = (x_k - x_(k-1)), dF = (f_k - f_(k-1)) of the last
  // iterates as columns,
  //
  //   gamma = argmin |f - dF gamma|:  (dF^T dF + delta I) gamma = dF^T f,
  //   step  = f - (dX + dF) gamma:
  //
  // the combination of the iterates whose difference, were f linear, would be
  // the least, and from there one plain step. delta, 1e-10 of the largest
  // diagonal entry, keeps nearly parallel columns from being told apart by
  // rounding.
  Vector
  FixedPointAcceleration::anderson_step(const Vector &difference) const
  {
    const unsigned int         n = changes_of_x.size();
    dealii::FullMatrix<double> gram(n, n);
    dealii::Vector<double>     projection(n), weights(n);
    for (unsigned int i = 0; i < n; ++i)
    {
      for (unsigned int j = 0; j <= i; ++j)
        gram(i, j) = gram(j, i) =
          changes_of_difference[i] * changes_of_difference[j];
      projection(i) = changes_of_difference[i] * difference;
    }
    double largest = 0.;
    for (unsigned int i = 0; i < n; ++i)
      largest = std::max(largest, gram(i, i));
    for (unsigned int i = 0; i < n; ++i)
      gram(i, i) += regularization * largest;
    gram.gauss_jordan();
    gram.vmult(weights, projection);
    Vector step(difference);
    for (unsigned int i = 0; i < n; ++i)
    {
      step.add(-weights(i), changes_of_x[i]);
      step.add(-weights(i), changes_of_difference[i]);
    }
    return step;
  }



  void
  FixedPointAcceleration::remember(const Phase   phase,
                                   const Vector &x,
                                   const Vector &difference)
  {
    if (phase == Phase::smooth && options.depth > 0)
    {
      Vector change_of_x(x), change_of_difference(difference);
      change_of_x.add(-1., last_x);
      change_of_difference.add(-1., last_difference);
      changes_of_x.push_front(change_of_x);
      changes_of_difference.push_front(change_of_difference);
      if (changes_of_x.size() > options.depth)
      {
        changes_of_x.pop_back();
        changes_of_difference.pop_back();
      }
    }
    else
    {
      changes_of_x.clear();
      changes_of_difference.clear();
    }
    has_last        = true;
    last_x          = x;
    last_difference = difference;
  }



  Vector
  FixedPointAcceleration::next(const Vector &x, const Vector &image)
  {
    Vector difference(image);
    difference.add(-1., x);
    Phase      phase = phase_of(difference);
    const bool is_converging =
      has_last &&
      difference.l2_norm() < clear_reduction * last_difference.l2_norm();
    const bool has_turned = has_last && turns_back(difference);
    remember(phase, x, difference);
    const bool goes_to_and_fro =
      has_turned && changes_of_x.size() == options.depth;

    // |step| <= longest |f|: an extrapolation is believed only so far
    const double length = difference.l2_norm();
    const double longest =
      std::max(options.largest_acceleration, options.over_relaxation);
    Vector step(difference);
    step *= options.over_relaxation;
    if (!changes_of_x.empty())
    {
      const Vector by_anderson = anderson_step(difference);
      const double wanted      = by_anderson.l2_norm();
      if (by_anderson * difference <= 0.)
      {
        // Backwards lies a state that plain iterations run away from: it
        // solves the equations, but is not stable.
        phase = Phase::growing;
        remember(phase, x, difference);
      }
      else if (is_converging || goes_to_and_fro ||
               wanted > options.over_relaxation * length)
      {
        step = by_anderson;
        if (wanted > longest * length)
          step *= longest * length / wanted;
      }
    }
    is_growing = phase == Phase::growing &&
                 options.largest_acceleration > options.over_relaxation;
    if (is_growing)
    {
      step = difference;
      step *= std::max(options.over_relaxation, growth_part * longest);
    }
    last_factor = length > 0. ? step.l2_norm() / length : 0.;
    step.add(1., x);
    return step;
  }
} // namespace MixedCracks
