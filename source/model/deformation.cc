// SPDX-License-Identifier: GPL-2.0-or-later
// Kinematics of finite strain (M11), always with a 3 x 3 F = I + H (no unit):
//
//   E      = sym H + H^T H / 2                       Green strain, C = I + 2 E
//   J - 1  = tr H + ((tr H)^2 - tr H^2)/2 + det H
//   cof F  = dJ/dF = J F^-T,    (cof F)_iJ = 1/2 e_ikm e_JLM F_kL F_mM
//
//   d2J/dF_iJ dF_kL       = e_ikm e_JLM F_mM          (linear in F, no inverse)
//   d2(ln J)/dF_iJ dF_kL  = - F^-T_iL F^-T_kJ
//
// H = F - I loses nothing near F = I, so that I1 - 3 = 2 tr E, J - 1 and ln J
// have a relative error of rounding at any strain. Energies are differences of
// these: at a strain of 1e-6 they are 1e-12 mu, and a line search compares
// them.
//
// Principal stretches: E = sum_a E_a N_a (x) N_a, lambda_a = |F N_a|,
// n_a = F N_a / lambda_a. Where lambda_a is near 1, ln lambda_a is
// log1p(2 E_a)/2 for the same reason.

#include <model/deformation.h>

#include <cmath>

namespace MixedCracks
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    // the two other indices, in cyclic order
    constexpr unsigned int next[3]     = {1, 2, 0};
    constexpr unsigned int previous[3] = {2, 0, 1};

    Tensor<2, 3>
    cofactor_of(const Tensor<2, 3> &a)
    {
      Tensor<2, 3> result;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          result[i][j] = a[next[i]][next[j]] * a[previous[i]][previous[j]] -
                         a[next[i]][previous[j]] * a[previous[i]][next[j]];
      return result;
    }

    Tensor<2, 3>
    without_identity(const Tensor<2, 3> &gradient)
    {
      Tensor<2, 3> result = gradient;
      for (unsigned int i = 0; i < 3; ++i)
        result[i][i] -= 1.;
      return result;
    }

    // the sum of the principal minors is that of the cofactors' diagonal
    double
    volume_change_of(const Tensor<2, 3> &h)
    {
      const Tensor<2, 3> minors = cofactor_of(h);
      return trace(h) + trace(minors) + h[0] * minors[0];
    }
  } // namespace



  Deformation::Deformation(const Tensor<2, 3> &gradient)
    : gradient(gradient)
    , cofactor(cofactor_of(gradient))
  {
    const Tensor<2, 3> h = without_identity(gradient);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
      {
        double square = 0.;
        for (unsigned int k = 0; k < 3; ++k)
          square += h[k][i] * h[k][j];
        strain[i][j] = 0.5 * (h[i][j] + h[j][i] + square);
      }
    // a volume near 0, as in plane stress where little is left of the material
    // but a pressure, has its digits in the product
    const double volume = gradient[0] * cofactor[0];
    volume_change       = volume < 0.5 ? volume - 1. : volume_change_of(h);
    log_volume   = volume < 0.5 ? std::log(volume) : std::log1p(volume_change);
    log_gradient = cofactor / volume;
  }



  PrincipalStretches::PrincipalStretches(const Deformation &deformation)
  {
    // Jacobi's method: directions are orthonormal for equal stretches as well
    const auto pairs = eigenvectors(
      deformation.strain, dealii::SymmetricTensorEigenvectorMethod::jacobi);
    for (unsigned int a = 0; a < 3; ++a)
    {
      const double twice_strain = 2. * pairs[a].first;
      reference[a]              = pairs[a].second;
      directions[a]             = deformation.gradient * reference[a];
      const double stretch      = directions[a].norm();
      directions[a] /= stretch;
      logarithms[a] = std::abs(twice_strain) < 0.5
                        ? 0.5 * std::log1p(twice_strain)
                        : std::log(stretch);
    }
  }



  void
  add_outer_product(Tensor<4, 3>       &tangent,
                    const double        factor,
                    const Tensor<2, 3> &a,
                    const Tensor<2, 3> &b)
  {
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
      {
        const double scaled = factor * a[i][j];
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = 0; l < 3; ++l)
            tangent[i][j][k][l] += scaled * b[k][l];
      }
  }



  void
  add_second_log_derivative(Tensor<4, 3>      &tangent,
                            const double       factor,
                            const Deformation &deformation)
  {
    const Tensor<2, 3> &inverse = deformation.log_gradient;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = 0; l < 3; ++l)
            tangent[i][j][k][l] -= factor * inverse[i][l] * inverse[k][j];
  }



  // for each i /= k and j /= l one entry of F, with the sign of the
  // permutations
  void
  add_second_volume_derivative(Tensor<4, 3>      &tangent,
                               const double       factor,
                               const Deformation &deformation)
  {
    for (unsigned int m = 0; m < 3; ++m)
      for (unsigned int n = 0; n < 3; ++n)
      {
        const double       entry = factor * deformation.gradient[m][n];
        const unsigned int i = next[m], k = previous[m];
        const unsigned int j = next[n], l = previous[n];
        tangent[i][j][k][l] += entry;
        tangent[k][l][i][j] += entry;
        tangent[i][l][k][j] -= entry;
        tangent[k][j][i][l] -= entry;
      }
  }
} // namespace MixedCracks
