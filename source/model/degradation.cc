// SPDX-License-Identifier: GPL-2.0-or-later
#include <model/degradation.h>

namespace MixedCracks
{
  namespace
  {
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



    template <typename Law>
    std::unique_ptr<Degradation>
    make(const double kappa)
    {
      return std::make_unique<Law>(kappa);
    }
  } // namespace



  const Registry<Degradation, double> &
  all_degradations()
  {
    static const Registry<Degradation, double> list(
      "degradation",
      {{"quadratic", "(1-kappa) phi^2 + kappa", make<Quadratic>}});
    return list;
  }
} // namespace MixedCracks
