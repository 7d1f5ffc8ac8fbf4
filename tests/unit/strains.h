// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_tests_unit_strains_h
#define mixed_cracks_tests_unit_strains_h

#include "automatic_differentiation.h"

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace MixedCracks
{
  namespace Testing
  {
    /// Random strains of size 1e-2 that keep their distance to every kink a
    /// split may have: trace 0, a principal strain 0, two equal ones.
    template <int dim>
    std::vector<dealii::SymmetricTensor<2, dim>>
    random_strains(const unsigned int n_strains)
    {
      std::mt19937                                 generator(4711 + dim);
      std::uniform_real_distribution<double>       random(-0.01, 0.01);
      std::vector<dealii::SymmetricTensor<2, dim>> strains;
      while (strains.size() < n_strains)
      {
        dealii::SymmetricTensor<2, dim> strain;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = i; j < dim; ++j)
            strain[i][j] = random(generator);
        const auto principal = dealii::eigenvalues(strain);
        bool       is_smooth = std::abs(trace(strain)) > 1e-3;
        for (unsigned int i = 0; i < dim; ++i)
        {
          is_smooth &= std::abs(principal[i]) > 5e-4;
          if (i > 0)
            is_smooth &= std::abs(principal[i] - principal[i - 1]) > 5e-4;
        }
        if (is_smooth)
          strains.push_back(strain);
      }
      return strains;
    }

    /// Central difference quotient of a stress by the strain.
    template <int dim>
    dealii::SymmetricTensor<4, dim>
    difference_quotient(const std::function<dealii::SymmetricTensor<2, dim>(
                          const dealii::SymmetricTensor<2, dim> &)> &stress,
                        const dealii::SymmetricTensor<2, dim>       &strain)
    {
      const double                    step = 1e-6;
      dealii::SymmetricTensor<4, dim> tangent;
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int l = k; l < dim; ++l)
        {
          dealii::SymmetricTensor<2, dim> plus = strain, minus = strain;
          plus[k][l] += step;
          minus[k][l] -= step;
          // an entry beside the diagonal moves its mirror image with it
          const double moved    = (k == l ? 2. : 4.) * step;
          const auto   quotient = (stress(plus) - stress(minus)) / moved;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = i; j < dim; ++j)
              tangent[i][j][k][l] = quotient[i][j];
        }
      return tangent;
    }

    /// Central difference quotient of an energy by the strain: a stress.
    template <int dim>
    dealii::SymmetricTensor<2, dim>
    energy_quotient(
      const std::function<double(const dealii::SymmetricTensor<2, dim> &)>
                                            &energy,
      const dealii::SymmetricTensor<2, dim> &strain)
    {
      const double                    step = 1e-6;
      dealii::SymmetricTensor<2, dim> stress;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
        {
          dealii::SymmetricTensor<2, dim> plus = strain, minus = strain;
          plus[i][j] += step;
          minus[i][j] -= step;
          // an entry beside the diagonal moves its mirror image with it
          const double moved = (i == j ? 2. : 4.) * step;
          stress[i][j]       = (energy(plus) - energy(minus)) / moved;
        }
      return stress;
    }

    /// The entries of a displacement gradient with this strain: the
    /// variables of an energy that is differentiated automatically. The
    /// derivatives by them are those by the strain.
    template <int dim>
    std::vector<double>
    as_variables(const dealii::SymmetricTensor<2, dim> &strain)
    {
      std::vector<double> variables;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          variables.push_back(strain[i][j]);
      return variables;
    }

    template <int dim>
    Active
    strain_trace(const std::vector<Active> &gradient)
    {
      Active sum = 0.;
      for (unsigned int i = 0; i < dim; ++i)
        sum += gradient[i * dim + i];
      return sum;
    }

    /// eps : eps with eps the symmetric part of @p gradient.
    template <int dim>
    Active
    strain_square(const std::vector<Active> &gradient)
    {
      Active sum = 0.;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
        {
          const Active entry =
            0.5 * (gradient[i * dim + j] + gradient[j * dim + i]);
          sum += entry * entry;
        }
      return sum;
    }

    /// First derivatives by the displacement gradient as a stress.
    template <int dim>
    dealii::SymmetricTensor<2, dim>
    as_stress(const Derivatives &energy)
    {
      dealii::SymmetricTensor<2, dim> stress;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          stress[i][j] = energy.first[i * dim + j];
      return stress;
    }

    /// Second derivatives by the displacement gradient as a tangent.
    template <int dim>
    dealii::SymmetricTensor<4, dim>
    as_tangent(const Derivatives &energy)
    {
      dealii::SymmetricTensor<4, dim> tangent;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int l = k; l < dim; ++l)
              tangent[i][j][k][l] = energy.second[i * dim + j][k * dim + l];
      return tangent;
    }
  } // namespace Testing
} // namespace MixedCracks

#endif
