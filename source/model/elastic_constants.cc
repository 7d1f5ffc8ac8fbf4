// SPDX-License-Identifier: GPL-2.0-or-later
// Lame's constants lambda and mu (MPa) from any two constants of isotropic
// linear elasticity, sigma = 2 mu eps + lambda tr(eps) I in three dimensions:
//
//   K  = lambda + 2 mu/3                       bulk modulus
//   E  = mu (3 lambda + 2 mu)/(lambda + mu)    Young's modulus
//   nu = lambda/(2 (lambda + mu))              Poisson ratio
//
// Each pair below solves two of these for lambda and mu:
//
//   lambda, E    mu = (E - 3 lambda + R)/4,  R = sqrt(E^2 + 9 lambda^2
//                                                     + 2 E lambda)
//   lambda, nu   mu = lambda (1/(2 nu) - 1)
//   lambda, K    mu = 3/2 (K - lambda)
//   mu, E        lambda = mu (E - 2 mu)/(3 mu - E)
//   mu, nu       lambda = 2 mu nu/(1 - 2 nu)
//   mu, K        lambda = K - 2 mu/3
//   E, nu        mu = E/(2 (1 + nu)), then lambda as above
//   E, K         mu = 3 K E/(9 K - E),  lambda = 3 K (3 K - E)/(9 K - E)
//   nu, K        mu = 3 K (1/2 - nu)/(1 + nu),  lambda = 3 K nu/(1 + nu)
//
// Admissible are mu > 0 and lambda > 0, that is 0 < nu < 1/2: the pressure law
// divides by lambda, and its limit, incompressible, is reached for finite
// numbers only as far as double precision goes.

#include <base/errors.h>

#include <model/elastic_constants.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>

namespace MixedCracks
{
  namespace
  {
    using Given = GivenElasticConstants;
    using Value = std::optional<double> Given::*;

    struct Entry
    {
      Value       value;
      const char *name;
    };

    constexpr std::array<Entry, 5> entries = {
      {{&Given::lame_lambda, "Material/Lame lambda"},
       {&Given::shear_modulus, "Material/Shear modulus"},
       {&Given::youngs_modulus, "Material/Young's modulus"},
       {&Given::poisson_ratio, "Material/Poisson ratio"},
       {&Given::bulk_modulus, "Material/Bulk modulus"}}};

    // Beyond this lambda/mu the result is made of rounding errors, as when
    // Young's modulus is three times the shear modulus.
    constexpr double largest_ratio = 1e12;

    struct Pair
    {
      Value first;
      Value second;
      ElasticConstants (*solve)(double, double);
    };

    ElasticConstants
    from_lambda_and_youngs_modulus(const double lambda, const double E)
    {
      // With d = 3 lambda - E: R - d cancels where d > 0, for nearly
      // incompressible material; (R - d)/4 = (R^2 - d^2)/(4 (R + d)) and R^2 -
      // d^2 = 8 E lambda.
      // Of mu = (E - 3 lambda + root) / 4, the form without cancellation
      const double root =
        std::sqrt(E * E + 9 * lambda * lambda + 2 * E * lambda);
      const double difference = 3 * lambda - E;
      return {lambda,
              difference > 0 ? 2 * lambda * E / (root + difference)
                             : (root - difference) / 4};
    }

    ElasticConstants
    from_youngs_modulus_and_poisson_ratio(const double E, const double nu)
    {
      const double mu = E / (2 * (1 + nu));
      return {2 * mu * nu / (1 - 2 * nu), mu};
    }

    ElasticConstants
    from_youngs_modulus_and_bulk_modulus(const double E, const double K)
    {
      const double factor = 3 * K / (9 * K - E);
      return {factor * (3 * K - E), factor * E};
    }

    ElasticConstants
    from_poisson_ratio_and_bulk_modulus(const double nu, const double K)
    {
      const double factor = 3 * K / (1 + nu);
      return {factor * nu, factor * (0.5 - nu)};
    }

    constexpr std::array<Pair, 10> pairs = {
      {{&Given::lame_lambda,
        &Given::shear_modulus,
        [](double lambda, double mu) {
          return ElasticConstants{lambda, mu};
        }},
       {&Given::lame_lambda,
        &Given::youngs_modulus,
        from_lambda_and_youngs_modulus},
       {&Given::lame_lambda,
        &Given::poisson_ratio,
        [](double lambda, double nu) {
          return ElasticConstants{lambda, lambda * (0.5 / nu - 1)};
        }},
       {&Given::lame_lambda,
        &Given::bulk_modulus,
        [](double lambda, double K) {
          return ElasticConstants{lambda, 1.5 * (K - lambda)};
        }},
       {&Given::shear_modulus,
        &Given::youngs_modulus,
        [](double mu, double E) {
          return ElasticConstants{mu * (E - 2 * mu) / (3 * mu - E), mu};
        }},
       {&Given::shear_modulus,
        &Given::poisson_ratio,
        [](double mu, double nu) {
          return ElasticConstants{2 * mu * nu / (1 - 2 * nu), mu};
        }},
       {&Given::shear_modulus,
        &Given::bulk_modulus,
        [](double mu, double K) {
          return ElasticConstants{K - 2 * mu / 3, mu};
        }},
       {&Given::youngs_modulus,
        &Given::poisson_ratio,
        from_youngs_modulus_and_poisson_ratio},
       {&Given::youngs_modulus,
        &Given::bulk_modulus,
        from_youngs_modulus_and_bulk_modulus},
       {&Given::poisson_ratio,
        &Given::bulk_modulus,
        from_poisson_ratio_and_bulk_modulus}}};

    std::string
    text(const double number)
    {
      std::ostringstream stream;
      stream.precision(10);
      stream << number;
      return stream.str();
    }

    // "Material/Lame lambda = 2593.4, Material/Bulk modulus = 2595"
    std::string
    list_of(const Given &given)
    {
      std::string list;
      for (const Entry &entry : entries)
        if (given.*entry.value)
          list += (list.empty() ? "" : ", ") + std::string(entry.name) + " = " +
                  text(*(given.*entry.value));
      return list;
    }

    void
    check_count(const Given &given)
    {
      unsigned int n_given = 0;
      for (const Entry &entry : entries)
        n_given += (given.*entry.value).has_value();
      if (n_given == 2)
        return; // quickly: where they vary, this is asked at every point
      std::string allowed;
      for (const Entry &entry : entries)
        allowed += (allowed.empty() ? "" : ", ") + std::string(entry.name);
      throw InputError(
        "Material: " + (n_given == 0 ? "none" : std::to_string(n_given)) +
        " of the elastic constants given" +
        (n_given == 0 ? std::string() : " (" + list_of(given) + ")") +
        "; exactly two are needed, out of " + allowed + ".");
    }

    void
    check_values(const Given &given)
    {
      for (const Entry &entry : entries)
      {
        if (!(given.*entry.value))
          continue;
        const double value    = *(given.*entry.value);
        const bool   is_ratio = entry.value == &Given::poisson_ratio;
        if (!std::isfinite(value) || value <= 0. || (is_ratio && value >= 0.5))
          throw InputError(std::string(entry.name) + " = " + text(value) +
                           "; it must be " +
                           (is_ratio ? "larger than 0 and smaller than 0.5."
                                     : "positive and finite (MPa)."));
      }
    }

    void
    check_result(const ElasticConstants &result, const Given &given)
    {
      const bool admissible = std::isfinite(result.lambda) &&
                              std::isfinite(result.mu) && result.mu > 0. &&
                              result.lambda > 0. &&
                              result.lambda <= largest_ratio * result.mu;
      if (!admissible)
        throw InputError(list_of(given) +
                         ": the pair means lambda = " + text(result.lambda) +
                         " MPa and mu = " + text(result.mu) +
                         " MPa; both must be positive and finite, which is a "
                         "Poisson ratio between 0 and 0.5.");
    }
  } // namespace



  double
  ElasticConstants::youngs_modulus() const
  {
    return mu * (3 * lambda + 2 * mu) / (lambda + mu);
  }



  double
  ElasticConstants::poisson_ratio() const
  {
    return 0.5 * lambda / (lambda + mu);
  }



  double
  ElasticConstants::bulk_modulus() const
  {
    return lambda + 2 * mu / 3;
  }



  ElasticConstants
  elastic_constants(const GivenElasticConstants &given)
  {
    check_count(given);
    check_values(given);
    ElasticConstants result{0., 0.};
    for (const Pair &pair : pairs)
      if (given.*pair.first && given.*pair.second)
        result = pair.solve(*(given.*pair.first), *(given.*pair.second));
    check_result(result, given);
    return result;
  }



  // (M6), plane stress: the strain across the plane adjusts such that sigma_zz
  // = 0,
  //
  //   eps_zz = - lambda/(lambda + 2 mu) (eps_xx + eps_yy),
  //
  // which leaves the two-dimensional law sigma = 2 mu eps + lambda* tr(eps) I
  // in the plane with  lambda* = lambda (1 - lambda/(lambda + 2 mu)) = 2 lambda
  // mu/(lambda + 2 mu),  about 2 mu where the material is nearly
  // incompressible: nothing locks.
  ElasticConstants
  plane_stress(const ElasticConstants &constants)
  {
    return {2 * constants.lambda * constants.mu /
              (constants.lambda + 2 * constants.mu),
            constants.mu};
  }
} // namespace MixedCracks
