// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_tests_unit_hyperelastic_constants_h
#define mixed_cracks_tests_unit_hyperelastic_constants_h

#include "automatic_differentiation.h"

#include <model/hyperelastic_law.h>

#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace MixedCracks
{
  namespace Testing
  {
    /// Constants of every law, those of the homogeneous numbers; MPa.
    inline const std::map<std::string, HyperelasticConstants> &
    rubber_constants()
    {
      static const std::map<std::string, HyperelasticConstants> constants = {
        {"neo-Hooke", {{1.}}},
        {"Mooney-Rivlin", {{0.4, 0.1}}},
        {"Yeoh", {{0.5, -0.02, 0.002}}},
        {"Gent", {{1., 30.}}},
        {"Ogden", {{0.63, 1.3, 0.0012, 5., -0.01, -2.}}}};
      return constants;
    }

    /// Nominal stresses of these laws, incompressible, in uniaxial, planar and
    /// equibiaxial tension at the stretch 2; MPa.
    inline const std::map<std::string, std::vector<double>> &
    nominal_stresses()
    {
      static const std::map<std::string, std::vector<double>> stresses = {
        {"neo-Hooke", {1.75, 1.875, 1.96875}},
        {"Mooney-Rivlin", {1.575, 1.875, 3.15}},
        {"Gent", {1.875, 2.027027, 2.368421}},
        {"Yeoh", {1.554, 1.651406, 1.776889}},
        {"Ogden", {0.6027216, 0.6856225, 0.8216148}}};
      return stresses;
    }

    /// F = I + H with entries of H up to @p size, det F > 0.1; of the plane:
    /// with F_13 = F_23 = F_31 = F_32 = 0.
    inline std::vector<dealii::Tensor<2, 3>>
    random_deformations(const unsigned int n,
                        const double       size,
                        const bool         of_the_plane = false)
    {
      std::mt19937                           generator(4711);
      std::uniform_real_distribution<double> random(-size, size);
      std::vector<dealii::Tensor<2, 3>>      result;
      while (result.size() < n)
      {
        dealii::Tensor<2, 3> F;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            F[i][j] = (i == j ? 1. : 0.) + random(generator);
        if (of_the_plane)
          F[0][2] = F[1][2] = F[2][0] = F[2][1] = 0.;
        if (determinant(F) > 0.1 && F[2][2] > 0.1)
          result.push_back(F);
      }
      return result;
    }

    /// Entries of F as variables of automatic differentiation and what
    /// follows from them, written down independently of the code.
    struct ActiveDeformation
    {
      explicit ActiveDeformation(const std::vector<Active> &F)
        : I1(0.)
      {
        Active C[3][3], square = 0.;
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
          {
            C[i][j] = 0.;
            for (int k = 0; k < 3; ++k)
              C[i][j] += F[3 * k + i] * F[3 * k + j];
          }
        for (int i = 0; i < 3; ++i)
        {
          I1 += C[i][i];
          for (int j = 0; j < 3; ++j)
            square += C[i][j] * C[j][i];
        }
        I2 = 0.5 * (I1 * I1 - square);
        J  = F[0] * (F[4] * F[8] - F[5] * F[7]) -
            F[1] * (F[3] * F[8] - F[5] * F[6]) +
            F[2] * (F[3] * F[7] - F[4] * F[6]);
      }

      /// Squares of the principal stretches, which must be distinct: a root
      /// of the characteristic polynomial, and three steps of Newton's method
      /// that carry the derivatives.
      std::vector<Active>
      squared_stretches(const dealii::Tensor<2, 3> &F) const
      {
        std::vector<Active> result;
        for (const double value : eigenvalues(symmetrize(transpose(F) * F)))
        {
          Active x = value;
          for (int step = 0; step < 3; ++step)
          {
            const Active polynomial = ((x - I1) * x + I2) * x - J * J;
            const Active slope      = (3. * x - 2. * I1) * x + I2;
            x                       = Active(x - polynomial / slope);
          }
          result.push_back(x);
        }
        return result;
      }

      Active I1, I2, J;
    };

    /// W~ of (M12) within the stretch of use.
    inline Active
    active_energy(const std::string           &law,
                  const HyperelasticConstants &c,
                  const bool                   isochoric,
                  const std::vector<Active>   &variables,
                  const dealii::Tensor<2, 3>  &F)
    {
      const ActiveDeformation d(variables);
      Active                  first = d.I1, second = d.I2, log = std::log(d.J);
      Active                  scale = 1.;
      if (isochoric)
      {
        scale  = std::exp(Active(-2. / 3. * log));
        first  = Active(scale * d.I1);
        second = Active(scale * scale * d.I2);
        log    = 0.;
      }
      const Active x = first - 3.;
      if (law == "neo-Hooke")
        return 0.5 * c[0] * x - c[0] * log;
      if (law == "Mooney-Rivlin")
        return c[0] * x + c[1] * (second - 3.) - 2. * (c[0] + 2. * c[1]) * log;
      if (law == "Yeoh")
        return c[0] * x + c[1] * x * x + c[2] * x * x * x - 2. * c[0] * log;
      if (law == "Gent")
        return -0.5 * c[0] * c[1] * std::log(Active(1. - x / c[1])) -
               c[0] * log;
      if (law != "Ogden")
        throw std::invalid_argument("no formula of " + law);
      Active sum = 0.;
      for (const Active &square : d.squared_stretches(F))
        for (int i = 0; i < 6; i += 2)
          sum += c[i] / c[i + 1] *
                 (std::exp(
                    Active(0.5 * c[i + 1] * std::log(Active(scale * square)))) -
                  1.);
      return sum - (c[0] + c[2] + c[4]) * log;
    }

    inline std::vector<double>
    entries(const dealii::Tensor<2, 3> &F)
    {
      std::vector<double> result;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          result.push_back(F[i][j]);
      return result;
    }

    inline dealii::Tensor<2, 3>
    diagonal(const double a, const double b, const double c)
    {
      dealii::Tensor<2, 3> result;
      result[0][0] = a;
      result[1][1] = b;
      result[2][2] = c;
      return result;
    }

    /// A proper rotation about an axis that is none of the coordinates'.
    inline dealii::Tensor<2, 3>
    rotation(const double angle)
    {
      const double         n[3] = {0.48, 0.6, 0.64};
      const double         s = std::sin(angle), c = std::cos(angle);
      dealii::Tensor<2, 3> result;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          result[i][j] = (1. - c) * n[i] * n[j];
      for (unsigned int i = 0; i < 3; ++i)
      {
        result[i][i] += c;
        result[i][(i + 1) % 3] -= s * n[(i + 2) % 3];
        result[(i + 1) % 3][i] += s * n[(i + 2) % 3];
      }
      return result;
    }
  } // namespace Testing
} // namespace MixedCracks

#endif
