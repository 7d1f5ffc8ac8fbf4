// SPDX-License-Identifier: GPL-2.0-or-later
// The stiffness that is left,
//
//   sigma = g(phi) sigma+ + sigma-,   g(1) = 1,   g(0) = kappa.
//
// g multiplies the part of the stress that opens cracks (EnergySplit says
// which); its derivative is how much elastic energy a falling phi sets free:
// the phase-field equation has the term
//
//   g'(phi) psi+ = 1/2 g'(phi) (sigma+ : eps),
//
// with psi+ = 1/2 sigma+ : eps (MPa) the undegraded energy density. Three
// things are wanted of any g: it grows with phi; g'(0) = 0, so that nothing is
// set free any more where all is broken, and phi = 0 is not left behind; and
// g'(1) > 0, without which nothing would ever begin to break.
//
// kappa, the residual stiffness (no unit), is what a broken cell keeps, so that
// the elastic matrix stays regular; g(1) = 1 whatever kappa is.
//
// Where g is not quadratic, the phase-field equation is not linear between its
// bounds, and PhaseFieldStep solves it by Newton's method, each linear problem
// by the active set. Where it is not convex, g'' 2 psi+ / 2 < 0 adds to the
// negative curvature that CrackDensity::concavity() tells the preconditioner
// about: then the multigrid of FreeBlockPreconditioner may have to give up to
// the diagonal.

#include <model/degradation.h>

namespace MixedCracks
{
  namespace
  {
    // [Bourdin00], and all sources of doc/model.md but the PF-CZM of [Wu17]:
    //
    //   g = (1-kappa) phi^2 + kappa,  g' = 2 (1-kappa) phi,  g'' = 2 (1-kappa).
    class Quadratic : public Degradation
    {
    public:
      explicit Quadratic(const double kappa)
        : kappa(kappa)
      {}

      double
      value(const double phi) const override
      {
        return (1. - kappa) * phi * phi + kappa;
      }

      double
      derivative(const double phi) const override
      {
        return 2. * (1. - kappa) * phi;
      }

      double
      second_derivative(const double) const override
      {
        return 2. * (1. - kappa);
      }

      bool
      is_quadratic() const override
      {
        return true;
      }

    private:
      const double kappa;
    };
  } // namespace



  const Registry<Degradation, double> &
  all_degradations()
  {
    using List = Registry<Degradation, double>;
    static const List list(
      "degradation",
      {{"quadratic", "(1-kappa) phi^2 + kappa", List::make_one<Quadratic>}});
    return list;
  }
} // namespace MixedCracks
