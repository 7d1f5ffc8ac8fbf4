// SPDX-License-Identifier: GPL-2.0-or-later
// Ogden's law (M12), Proc. R. Soc. A 326 (1972), in the principal stretches
// lambda_a of F = sum_a lambda_a n_a (x) N_a (no unit); mu_i in MPa:
//
//   omega(lambda) = sum_i mu_i/alpha_i (lambda^alpha_i - 1),   m = sum_i mu_i
//   W~ = sum_a omega(lambda_a) - m ln J                          "coupled"
//   W~ = sum_a omega(J^(-1/3) lambda_a)                          "isochoric"
//   mu = 1/2 sum_i mu_i alpha_i,    lambda_W = 0, or -2 mu/3 (isochoric)
//
// Beyond the stretch of use L, omega = a + b lambda^2 with the value and slope
// at L: neo-Hooke, with b = omega'(L)/(2 L) > 0 demanded of the constants. A
// stretch that goes to 0 keeps the law as it is: a negative alpha has its
// barrier there.
//
// With T_a = dW~/dlambda_a and K_ab = d2W~/dlambda_a dlambda_b, n_a N_b short
// for n_a (x) N_b,
//
//   P = sum_a T_a n_a N_a
//   A = sum_ab K_ab n_a N_a (x) n_b N_b
//     + sum_(a /= b) (s + d)/2 n_a N_b (x) n_a N_b
//                  + (s - d)/2 n_a N_b (x) n_b N_a,
//   s = (T_a - T_b)/(lambda_a - lambda_b),   d = (T_a + T_b)/(lambda_a +
//                                                             lambda_b)
//
// (Ogden, Non-Linear Elastic Deformations, 1984, ch. 6). Only s is delicate,
// where stretches are equal or nearly so. T is omega' plus terms in 1/lambda,
// whose difference quotients are written out, and that of a power is
//
//   (x^b - y^b)/(x - y) = y^(b-1) expm1(b t)/expm1(t),   t = ln x - ln y,
//
// without cancellation for any t; at t = 0 it is the derivative b y^(b-1).

#include <model/ogden_law.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace MixedCracks
{
  using dealii::Tensor;

  namespace
  {
    using Triple = std::array<double, 3>;

    // omega and its derivatives by lambda, as functions of x = ln lambda
    class StretchEnergy
    {
    public:
      StretchEnergy(const HyperelasticConstants &constants,
                    const HyperelasticForm      &form)
        : constants(constants)
        , largest(form.largest_stretch)
        , log_largest(std::log(form.largest_stretch))
        , quadratic(0.5 * first_power(log_largest) / largest)
      {}

      double
      value(const double x) const
      {
        const double inside = std::min(x, log_largest);
        double       sum    = 0.;
        for (unsigned int i = 0; i < 6; i += 2)
          if (constants[i] != 0.)
            sum += constants[i] / constants[i + 1] *
                   std::expm1(constants[i + 1] * inside);
        return x <= log_largest
                 ? sum
                 : sum + quadratic * (std::exp(2. * x) - largest * largest);
      }

      double
      first(const double x) const
      {
        return x <= log_largest ? first_power(x) : 2. * quadratic * std::exp(x);
      }

      double
      second(const double x) const
      {
        if (x > log_largest)
          return 2. * quadratic;
        double sum = 0.;
        for (unsigned int i = 0; i < 6; i += 2)
          if (constants[i] != 0.)
            sum += constants[i] * (constants[i + 1] - 1.) *
                   std::exp((constants[i + 1] - 2.) * x);
        return sum;
      }

      // (omega'(x) - omega'(y))/(lambda_x - lambda_y); across L it is the mean
      // of the two parts, weighted with their lengths
      double
      quotient(const double x, const double y) const
      {
        const double low = std::min(x, y), high = std::max(x, y);
        if (low >= log_largest)
          return 2. * quadratic;
        if (high <= log_largest)
          return quotient_of_powers(high, low);
        const double above = std::exp(high) - largest;
        const double below = largest - std::exp(low);
        return (2. * quadratic * above +
                quotient_of_powers(log_largest, low) * below) /
               (above + below);
      }

    private:
      double
      first_power(const double x) const
      {
        double sum = 0.;
        for (unsigned int i = 0; i < 6; i += 2)
          if (constants[i] != 0.)
            sum += constants[i] * std::exp((constants[i + 1] - 1.) * x);
        return sum;
      }

      double
      quotient_of_powers(const double x, const double y) const
      {
        const double t = x - y;
        if (t == 0.)
          return second(x);
        double sum = 0.;
        for (unsigned int i = 0; i < 6; i += 2)
          if (constants[i] != 0.)
            sum += constants[i] * std::exp((constants[i + 1] - 2.) * y) *
                   std::expm1((constants[i + 1] - 1.) * t) / std::expm1(t);
        return sum;
      }

      const HyperelasticConstants &constants;
      const double                 largest;
      const double                 log_largest;
      const double                 quadratic; ///< b
    };



    double
    log_coefficient(const HyperelasticConstants &constants)
    {
      return constants[0] + constants[2] + constants[4];
    }

    // T_a, K_ab and s_ab (a /= b; the diagonal is not used)
    struct PrincipalDerivatives
    {
      Triple                first;
      std::array<Triple, 3> second;
      std::array<Triple, 3> quotient;
    };

    PrincipalDerivatives
    coupled_derivatives(const StretchEnergy &omega,
                        const double         m,
                        const Triple        &x)
    {
      PrincipalDerivatives result{};
      for (unsigned int a = 0; a < 3; ++a)
      {
        const double inverse = std::exp(-x[a]);
        result.first[a]      = omega.first(x[a]) - m * inverse;
        result.second[a][a]  = omega.second(x[a]) + m * inverse * inverse;
        for (unsigned int b = 0; b < 3; ++b)
          if (b != a)
            result.quotient[a][b] =
              omega.quotient(x[a], x[b]) + m * inverse * std::exp(-x[b]);
      }
      return result;
    }

    // With tau_a = lambda omega', eta_a = d(tau_a)/d(ln lambda_a) at the
    // isochoric stretches, and e_a = ln lambda_a:
    //   dW/de_a = tau_a - mean(tau)
    //   d2W/de_a de_b = eta_a d_ab - (eta_a + eta_b)/3 + mean(eta)/3
    PrincipalDerivatives
    isochoric_derivatives(const StretchEnergy &omega, const Triple &x)
    {
      const double mean_log = (x[0] + x[1] + x[2]) / 3.;
      Triple       y, tau, eta;
      for (unsigned int a = 0; a < 3; ++a)
      {
        y[a]                 = x[a] - mean_log;
        const double stretch = std::exp(y[a]);
        tau[a]               = stretch * omega.first(y[a]);
        eta[a]               = tau[a] + stretch * stretch * omega.second(y[a]);
      }
      const double         mean_tau = (tau[0] + tau[1] + tau[2]) / 3.;
      const double         mean_eta = (eta[0] + eta[1] + eta[2]) / 3.;
      PrincipalDerivatives result{};
      for (unsigned int a = 0; a < 3; ++a)
      {
        result.first[a] = (tau[a] - mean_tau) * std::exp(-x[a]);
        for (unsigned int b = 0; b < 3; ++b)
        {
          const double inverse = std::exp(-x[a] - x[b]);
          double       second  = (mean_eta - eta[a] - eta[b]) / 3.;
          if (b == a)
            second += eta[a] - (tau[a] - mean_tau);
          else
            result.quotient[a][b] =
              std::exp(-2. * mean_log) * omega.quotient(y[a], y[b]) +
              mean_tau * inverse;
          result.second[a][b] = second * inverse;
        }
      }
      return result;
    }

    // the parts of the tangent that turn the directions
    void
    add_rotation_of_directions(
      Tensor<4, 3>                                     &tangent,
      const PrincipalDerivatives                       &derivatives,
      const Triple                                     &x,
      const std::array<std::array<Tensor<2, 3>, 3>, 3> &dyads)
    {
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          if (b != a)
          {
            const double s = derivatives.quotient[a][b];
            const double d = (derivatives.first[a] + derivatives.first[b]) /
                             (std::exp(x[a]) + std::exp(x[b]));
            add_outer_product(tangent, 0.5 * (s + d), dyads[a][b], dyads[a][b]);
            add_outer_product(tangent, 0.5 * (s - d), dyads[a][b], dyads[b][a]);
          }
    }
  } // namespace



  std::vector<std::string>
  OgdenLaw::constant_names() const
  {
    return {"mu1", "alpha1", "mu2", "alpha2", "mu3", "alpha3"};
  }



  double
  OgdenLaw::mu(const HyperelasticConstants &constants) const
  {
    return 0.5 * (constants[0] * constants[1] + constants[2] * constants[3] +
                  constants[4] * constants[5]);
  }



  double
  OgdenLaw::lambda(const HyperelasticConstants &constants) const
  {
    return form.isochoric ? -2. / 3. * mu(constants) : 0.;
  }



  std::string
  OgdenLaw::problem(const HyperelasticConstants &constants) const
  {
    for (unsigned int i = 0; i < 6; i += 2)
      if (constants[i] != 0. && !(std::abs(constants[i + 1]) > 0.))
        return "alpha" + std::to_string(i / 2 + 1) + " must not be 0";
    if (!(mu(constants) > 0.))
      return "the shear modulus, half the sum of mu_i alpha_i, must be above 0";
    if (!(StretchEnergy(constants, form).first(std::log(form.largest_stretch)) >
          0.))
      return "the sum of mu_i lambda^(alpha_i - 1) must be above 0 at the "
             "largest stretch";
    return "";
  }



  double
  OgdenLaw::energy(const Deformation           &deformation,
                   const HyperelasticConstants &constants) const
  {
    const StretchEnergy omega(constants, form);
    const Triple        x      = PrincipalStretches(deformation).logarithms;
    const double        volume = x[0] + x[1] + x[2];
    const double        mean   = form.isochoric ? volume / 3. : 0.;
    double              sum    = 0.;
    for (const double log : x)
      sum += omega.value(log - mean);
    return form.isochoric ? sum : sum - log_coefficient(constants) * volume;
  }



  double
  OgdenLaw::tensile_energy(const Deformation           &deformation,
                           const HyperelasticConstants &constants) const
  {
    const StretchEnergy omega(constants, form);
    const double mean = form.isochoric ? deformation.log_volume / 3. : 0.;
    double       sum  = 0.;
    for (const double log : PrincipalStretches(deformation).logarithms)
    {
      const double x = std::max(log - mean, 0.);
      sum += omega.value(x) - log_coefficient(constants) * x;
    }
    return sum;
  }



  HyperelasticResponse
  OgdenLaw::response(const Deformation           &deformation,
                     const HyperelasticConstants &constants,
                     const bool                   with_tangent) const
  {
    const StretchEnergy        omega(constants, form);
    const PrincipalStretches   principal(deformation);
    const Triple              &x = principal.logarithms;
    const double               m = log_coefficient(constants);
    const PrincipalDerivatives derivatives =
      form.isochoric ? isochoric_derivatives(omega, x)
                     : coupled_derivatives(omega, m, x);
    std::array<std::array<Tensor<2, 3>, 3>, 3> dyads;
    HyperelasticResponse                       result;
    for (unsigned int a = 0; a < 3; ++a)
    {
      for (unsigned int b = 0; b < 3; ++b)
        dyads[a][b] =
          outer_product(principal.directions[a], principal.reference[b]);
      const double log =
        form.isochoric ? x[a] - (x[0] + x[1] + x[2]) / 3. : x[a];
      result.energy += omega.value(log) - (form.isochoric ? 0. : m * log);
      result.stress += derivatives.first[a] * dyads[a][a];
    }
    if (!with_tangent)
      return result;
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        if (derivatives.second[a][b] != 0.)
          add_outer_product(
            result.tangent, derivatives.second[a][b], dyads[a][a], dyads[b][b]);
    add_rotation_of_directions(result.tangent, derivatives, x, dyads);
    return result;
  }



  // lambda_3 = F_33 and, in the plane, (lambda_1 +- lambda_2)^2 = |F|^2 +- 2
  // det F: no eigenvalue problem in each step of the search for F_33.
  OutOfPlaneDerivatives
  OgdenLaw::out_of_plane(const Deformation           &deformation,
                         const HyperelasticConstants &constants) const
  {
    const StretchEnergy omega(constants, form);
    const Tensor<2, 3> &F = deformation.gradient;
    const double        z = std::log(F[2][2]);
    const double        m = log_coefficient(constants);
    if (!form.isochoric)
      return {omega.first(z) - m / F[2][2],
              omega.second(z) + m / (F[2][2] * F[2][2])};
    const double sum        = std::hypot(F[0][0] + F[1][1], F[1][0] - F[0][1]);
    const double difference = std::hypot(F[0][0] - F[1][1], F[1][0] + F[0][1]);
    const double larger     = std::log(0.5 * (sum + difference));
    const double area       = deformation.log_volume - z;
    const PrincipalDerivatives derivatives =
      isochoric_derivatives(omega, {{larger, area - larger, z}});
    return {derivatives.first[2], derivatives.second[2][2]};
  }
} // namespace MixedCracks
