// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_lane_response_h
#define mixed_cracks_assembly_lane_response_h

#include <assembly/lane_tangents.h>

#include <array>

namespace MixedCracks
{
  // What a displacement gradient and a pressure cause at a quadrature point, in
  // all lanes at a time, with the numbers of LaneTangents:
  //
  //   small strain   sigma = C : eps + s p I,   constraint = t tr eps + c p,
  //   finite strain  P = A : H + K p,           constraint = K : H + c p.

  // (i, j) -> C_(ij) sum over pairs i <= j: y_i += C_(ij) x_j and y_j +=
  // C_(ij) x_i; returns what follows the triangle
  template <std::size_t n, typename Lanes>
  const Lanes *
  multiply_triangle(const Lanes                *triangle,
                    const std::array<Lanes, n> &x,
                    std::array<Lanes, n>       &y)
  {
    for (std::size_t i = 0; i < n; ++i)
      y[i] = 0.;
    for (std::size_t i = 0; i < n; ++i)
    {
      y[i] += *triangle++ * x[i];
      for (std::size_t j = i + 1; j < n; ++j, ++triangle)
      {
        y[i] += *triangle * x[j];
        y[j] += *triangle * x[i];
      }
    }
    return triangle;
  }



  // Stress and constraint of grad u and p, with the numbers of a point.
  template <TangentKind kind, int dim, typename Lanes>
  void
  respond(const Lanes                         *numbers,
          const dealii::Tensor<2, dim, Lanes> &gradient,
          const Lanes                         &pressure,
          dealii::Tensor<2, dim, Lanes>       &stress,
          Lanes                               &constraint)
  {
    if constexpr (kind == TangentKind::finite)
    {
      std::array<Lanes, dim * dim> in, out;
      for (unsigned int i = 0; i < dim * dim; ++i)
        in[i] = gradient[i / dim][i % dim];
      numbers    = multiply_triangle(numbers, in, out);
      constraint = numbers[dim * dim] * pressure;
      for (unsigned int i = 0; i < dim * dim; ++i)
      {
        stress[i / dim][i % dim] = out[i] + numbers[i] * pressure;
        constraint += numbers[i] * in[i];
      }
      return;
    }
    const Lanes volume = trace(gradient);
    if constexpr (kind == TangentKind::symmetric)
    {
      // C : eps has both of a pair of shear strains
      constexpr unsigned int n = dim * (dim + 1) / 2;
      std::array<Lanes, n>   in, out;
      for (unsigned int i = 0; i < n; ++i)
      {
        const auto at =
          dealii::SymmetricTensor<2, dim>::unrolled_to_component_indices(i);
        in[i] = i < dim ? gradient[i][i]
                        : gradient[at[0]][at[1]] + gradient[at[1]][at[0]];
      }
      numbers = multiply_triangle(numbers, in, out);
      for (unsigned int i = 0; i < n; ++i)
      {
        const auto at =
          dealii::SymmetricTensor<2, dim>::unrolled_to_component_indices(i);
        stress[at[0]][at[1]] = stress[at[1]][at[0]] = out[i];
      }
    }
    else
    {
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          stress[i][j] = 0.5 * numbers[0] * (gradient[i][j] + gradient[j][i]);
      for (unsigned int i = 0; i < dim; ++i)
        stress[i][i] += numbers[1] * volume;
      numbers += 2;
    }
    for (unsigned int i = 0; i < dim; ++i)
      stress[i][i] += numbers[0] * pressure;
    constraint = numbers[1] * volume + numbers[2] * pressure;
  }



  // eps(N_a e_d) : C : eps(N_a e_d) of a shape function with this gradient,
  // times the weight of the point; one sum for each d, stride numbers apart.
  template <TangentKind kind, int dim, typename Lanes>
  void
  add_to_diagonal(const Lanes                         *numbers,
                  const Lanes                         &weight,
                  const dealii::Tensor<1, dim, Lanes> &gradient,
                  const unsigned int                   stride,
                  Lanes                               *sums)
  {
    if constexpr (kind == TangentKind::isotropic)
    {
      const Lanes half = 0.5 * weight * numbers[0];
      const Lanes both = half * gradient.norm_square();
      const Lanes own  = half + weight * numbers[1];
      for (unsigned int d = 0; d < dim; ++d)
        sums[d * stride] += both + own * (gradient[d] * gradient[d]);
      return;
    }
    for (unsigned int d = 0; d < dim; ++d)
    {
      dealii::Tensor<2, dim, Lanes> unit, stress;
      Lanes                         constraint;
      unit[d] = gradient;
      respond<kind>(numbers, unit, Lanes(0.), stress, constraint);
      sums[d * stride] += weight * (stress[d] * gradient);
    }
  }
} // namespace MixedCracks

#endif
