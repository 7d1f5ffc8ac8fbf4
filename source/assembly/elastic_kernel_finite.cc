// SPDX-License-Identifier: GPL-2.0-or-later
// The elastic kernel at finite strain: total Lagrangian, everything integrated
// over the cell as it was before it was deformed. With H = grad u (dim x dim),
// F = I + H, g = g(phi~) and the law of (M13) or (M13b) at each point,
//
//   R_u(w) = ( P(H, p, g), grad w )     P: first Piola-Kirchhoff stress, MPa
//   R_p(q) = ( c(H, p, g), q )          c: s theta - compliance p
//   (FinitePressureLaw)
//
// The blocks of elastic_kernel.cc become
//
//   A_(ad,be)  = sum_q w_q dN_a/dX_J  C_dJeK  dN_b/dX_K,  C = dP/dH: with the
//                geometric part; symmetric, C_dJeK = C_eKdJ
//   B_(k,ad)   = sum_q w_q K_dJ dN_a/dX_J M_k,        K = dP/dp = dc/dH
//   M_(k,m)    = sum_q w_q (-dc/dp) M_k M_m
//
// and the whole is symmetric for every law. In plane stress F_33 is condensed
// out of C, K and dc/dp. It derives at given phi~ from the potential
//
//   mixed         L(u, p) = sum_q w_q ( W + p V - p^2/2 S ),
//   displacement  E(u)    = sum_q w_q  Psi(H, g),    infinite if det F <= 0,
//
// W, V, S of FiniteStrain::potential(): MPa, 1, 1/MPa.

#include <assembly/elastic_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // grad N_b of a unit displacement of a node along e makes the stress
    // T_dJ = sum_K C_dJeK dN_b/dX_K.
    template <int dim>
    Tensor<2, dim>
    stress_caused_by(const Tensor<4, dim> &tangent,
                     const unsigned int    e,
                     const Tensor<1, dim> &gradient)
    {
      Tensor<2, dim> stress;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int j = 0; j < dim; ++j)
          stress[d][j] = tangent[d][j][e] * gradient;
      return stress;
    }
  } // namespace



  // Only a <= b, the rest by symmetry, as at small strain.
  template <int dim>
  void
  ElasticKernel<dim>::finite_displacement_block(
    const unsigned int  q,
    FullMatrix<double> &result) const
  {
    const Tensor<4, dim> tangent =
      geometry->weights[q] * responses[q].finite->stress_by_gradient;
    for (unsigned int b = 0; b < displacement_dofs.size(); ++b)
      for (unsigned int e = 0; e < dim; ++e)
      {
        const Tensor<2, dim> stress =
          stress_caused_by(tangent, e, displacement_shapes.gradient(b, q));
        for (unsigned int a = 0; a <= b; ++a)
        {
          const Tensor<1, dim> force =
            stress * displacement_shapes.gradient(a, q);
          for (unsigned int d = 0; d < dim; ++d)
            result(displacement_dofs[a][d], displacement_dofs[b][e]) +=
              force[d];
        }
      }
  }



  template <int dim>
  void
  ElasticKernel<dim>::finite_pressure_blocks(const unsigned int  q,
                                             FullMatrix<double> &result) const
  {
    const Tensor<2, dim> coupling =
      geometry->weights[q] * responses[q].finite->coupling;
    for (unsigned int a = 0; a < displacement_dofs.size(); ++a)
    {
      const Tensor<1, dim> force =
        coupling * displacement_shapes.gradient(a, q);
      for (unsigned int l = 0; l < pressure_dofs.size(); ++l)
        for (unsigned int d = 0; d < dim; ++d)
        {
          const unsigned int i     = displacement_dofs[a][d];
          const double       entry = force[d] * pressure_shapes.value(l, q);
          result(i, pressure_dofs[l]) += entry;
          result(pressure_dofs[l], i) += entry;
        }
    }
    add_block_of_pressure(q, result);
  }



  // |eps|, at finite strain min(|F^T F - I|/2, 1): of a rotation it is 0, and
  // the stretches of broken cells, which go beyond 100, do not make the
  // constraint in the others small by comparison.
  template <int dim>
  double
  ElasticKernel<dim>::size_of_strain(const Tensor<2, dim> &gradient) const
  {
    if (!material.is_finite())
      return symmetrize(gradient).norm();
    const Tensor<2, dim> green =
      0.5 * (gradient + transpose(gradient) + transpose(gradient) * gradient);
    return std::min(green.norm(), 1.);
  }



  template <int dim>
  double
  ElasticKernel<dim>::smallest_determinant() const
  {
    if (!material.is_finite())
      return 1.;
    double smallest = std::numeric_limits<double>::infinity();
    for (const ElasticPoint<dim> &point : states)
    {
      const double determinant =
        material.finite().determinant(point.gradient, point.degradation);
      // what is no number is no volume either
      if (!(determinant >= smallest))
        smallest = std::isnan(determinant)
                     ? -std::numeric_limits<double>::infinity()
                     : determinant;
    }
    return smallest;
  }



  template <int dim>
  double
  ElasticKernel<dim>::potential() const
  {
    double sum = 0.;
    for (unsigned int q = 0; q < states.size(); ++q)
    {
      const auto &[gradient, p, g, regime] = states[q];
      (void)regime;
      double density = 0.;
      if (mixed)
      {
        const auto parts =
          material.finite().potential(gradient, p, g, constants[q]);
        density = parts.distortion + p * parts.volume_change -
                  0.5 * p * p * parts.compliance;
      }
      else
        density =
          material.finite().eliminated_energy(gradient, g, constants[q]);
      sum += geometry->weights[q] * density;
    }
    return sum;
  }



  // In energies of the order of mu |E|^2 terms of the first order in H cancel,
  // tr H with ln J, and of a rotation those of the second, |H|^2/2 with tr H:
  //
  //   sum_q w_q ( g mu (|H| + |H|^2/2) + |p| |H| )
  template <int dim>
  double
  ElasticKernel<dim>::potential_terms() const
  {
    double sum = 0.;
    for (unsigned int q = 0; q < states.size(); ++q)
    {
      const double size = states[q].gradient.norm();
      sum += geometry->weights[q] *
             (states[q].degradation * constants[q].mu * (1. + 0.5 * size) +
              std::abs(states[q].pressure)) *
             size;
    }
    return sum;
  }



  // M_kl = sum_q w_q (-dc/dp) M_k M_l
  template <int dim>
  void
  ElasticKernel<dim>::pressure_mass(FullMatrix<double> &result) const
  {
    Assert(evaluated == ElasticEvaluation::tangents,
           ExcMessage("The tangents have not been evaluated."));
    result = 0.;
    for (unsigned int q = 0; q < states.size(); ++q)
    {
      const double weight =
        -geometry->weights[q] * responses[q].constraint_by_pressure;
      for (unsigned int k = 0; k < pressure_dofs.size(); ++k)
        for (unsigned int l = 0; l < pressure_dofs.size(); ++l)
          result(k, l) +=
            weight * pressure_shapes.value(k, q) * pressure_shapes.value(l, q);
    }
  }



  // Cauchy stress P F^T / J, which is symmetric; F is block-diagonal in 2-d, so
  // that the plane is enough. The largest principal stretch is the root of the
  // largest eigenvalue of F^T F, all 3 x 3 of it.
  template <int dim>
  void
  ElasticKernel<dim>::add_finite(const unsigned int q, CellAverages &sum) const
  {
    const auto &[gradient, p, g, regime] = states[q];
    (void)regime;
    const double             weight = geometry->weights[q];
    const FiniteStrain<dim> &law    = material.finite();
    const double             J = law.volume_ratio(gradient, p, g, constants[q]);
    Tensor<2, dim>           F = gradient;
    for (unsigned int d = 0; d < dim; ++d)
      F[d][d] += 1.;
    sum.stress += (weight / J) * symmetrize(responses[q].stress * transpose(F));
    const Tensor<2, 3> all =
      law.deformation_gradient(gradient, p, g, constants[q]);
    sum.largest_stretch +=
      weight * std::sqrt(eigenvalues(symmetrize(transpose(all) * all)).front());
    sum.volume_ratio += weight * J;
  }



#define INSTANTIATE(dim)                                                         \
  template void ElasticKernel<dim>::finite_displacement_block(                   \
    unsigned int, FullMatrix<double> &) const;                                   \
  template void ElasticKernel<dim>::finite_pressure_blocks(                      \
    unsigned int, FullMatrix<double> &) const;                                   \
  template double ElasticKernel<dim>::size_of_strain(const Tensor<2, dim> &)     \
    const;                                                                       \
  template double ElasticKernel<dim>::smallest_determinant() const;              \
  template double ElasticKernel<dim>::potential() const;                         \
  template double ElasticKernel<dim>::potential_terms() const;                   \
  template void   ElasticKernel<dim>::pressure_mass(FullMatrix<double> &) const; \
  template void   ElasticKernel<dim>::add_finite(unsigned int, CellAverages &)   \
    const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
