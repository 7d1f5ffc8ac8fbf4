// SPDX-License-Identifier: GPL-2.0-or-later
// Displacement and pressure on one cell, for a given g = g(phi~) at the
// quadrature points: the first two lines of the weak form (M5),
//
//   R_u(w) = ( sigma(eps(u), p, g), eps(w) )                       = external
//   R_p(q) = ( divergence tr eps(u) - compliance p, q )            = 0
//   sigma  = g sigma+ + sigma-,      (a, b) = integral of a : b over the cell,
//
// Material has the integrands, [Mang21] the form. Local dofs, for Q2 and Q1 in
// 2-d (22 of them) and, in brackets, 3-d (89):
//
//             u: 9 [27] nodes x dim        p: 4 [8] nodes
//           +----------------------------+------------------+
//    w      |  A    (eps(w), C : eps(u)) |  B^T             |   N/mm
//           +----------------------------+------------------+
//    q      |  B'                        |  -M              |   mm^2
//           +----------------------------+------------------+
//
//   A_(ad,be)   = sum_q w_q eps(N_a e_d) : C : eps(N_b e_e),  C = g C+ + C-
//   B^T_(ad,k)  = sum_q w_q stress     dN_a/dx_d M_k,   d sigma/dp = stress I
//   B'_(k,ad)   = sum_q w_q divergence dN_a/dx_d M_k
//   M_(k,m)     = sum_q w_q compliance M_k M_m
//
// N_a the shape functions of a component of u, M_k those of p, w_q the
// quadrature weight times |J|. B' = B, and the whole is symmetric, where the
// pressure law has stress = divergence. phi does not appear: it is fixed
// through g, so that the Jacobian of (u, p, phi) is block triangular and this
// is one block of its diagonal. In the displacement formulation A alone is
// there, with the bulk stiffness of the eliminated p in C.
//
// Per mm of thickness: in 3-d the units are N and mm^3 instead.
// Finite strain: elastic_kernel_finite.cc; energies, scales and averages:
// elastic_kernel_energy.cc.

#include <assembly/elastic_kernel.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // the element of the pressure, or any other where there is none
    template <int dim>
    const FiniteElement<dim> &
    pressure_element(const FiniteElement<dim> &element, const bool mixed)
    {
      return element.base_element(mixed ? 1 : 0);
    }
  } // namespace



  template <int dim>
  ElasticKernel<dim>::ElasticKernel(const FiniteElement<dim> &element,
                                    const Quadrature<dim>    &quadrature,
                                    const Material<dim>      &material,
                                    const bool                mixed)
    : material(material)
    , mixed(mixed)
    , displacement_shapes(element.base_element(0), quadrature)
    , pressure_shapes(pressure_element(element, mixed), quadrature)
    , displacement_dofs(displacement_shapes.size())
    , pressure_dofs(mixed ? pressure_shapes.size() : 0)
    , states(quadrature.size())
    , responses(quadrature.size())
  {
    for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
    {
      const auto [component, node] = element.system_to_component_index(i);
      if (component < dim)
        displacement_dofs[node][component] = i;
      else
        pressure_dofs[node] = i;
    }
  }



  template <int dim>
  void
  ElasticKernel<dim>::reinit(const CellGeometry<dim> &new_geometry,
                             const CellConstants     &new_constants)
  {
    geometry  = &new_geometry;
    constants = new_constants;
    displacement_shapes.reinit(new_geometry);
  }



  // Interpolating phi = 1 leaves rounding; the intact material must not see it,
  // since an unchanged matrix is not built or factorised again.
  template <int dim>
  double
  ElasticKernel<dim>::degradation(const double phase_field) const
  {
    return phase_field > 1. - 1e-13 ? 1.
                                    : material.degradation().value(phase_field);
  }



  // Where g = 1 the material is linear at small strain, whatever its regime:
  // they count as one.
  template <int dim>
  int
  ElasticKernel<dim>::tangent_regime(const ElasticPoint<dim> &point) const
  {
    if (material.is_finite())
      return tangent_of_finite_strain;
    return point.degradation == 1.
             ? 0
             : material.tangent_regime(point.gradient, point.pressure);
  }



  // At each quadrature point
  //
  //   grad u = sum_a u_a (x) grad N_a,   p = sum_k p_k M_k,   g = g(phi~),
  //
  // p from the constraint where it is eliminated, and the regime of the
  // tangent.
  template <int dim>
  void
  ElasticKernel<dim>::set_state(const Vector<double>      &local,
                                const std::vector<double> &lagged_phase_field,
                                const ElasticEvaluation    wanted)
  {
    largest_displacement = 0.;
    for (const auto &node : displacement_dofs)
      for (const unsigned int i : node)
        largest_displacement =
          std::max(largest_displacement, std::abs(local(i)));
    for (unsigned int q = 0; q < states.size(); ++q)
    {
      ElasticPoint<dim> &point = states[q];
      point.gradient           = 0.;
      for (unsigned int a = 0; a < displacement_dofs.size(); ++a)
        for (unsigned int d = 0; d < dim; ++d)
          point.gradient[d] +=
            local(displacement_dofs[a][d]) * displacement_shapes.gradient(a, q);
      point.degradation = degradation(lagged_phase_field[q]);
      if (mixed)
      {
        point.pressure = 0.;
        for (unsigned int k = 0; k < pressure_dofs.size(); ++k)
          point.pressure +=
            local(pressure_dofs[k]) * pressure_shapes.value(k, q);
      }
      else
        point.pressure =
          material.pressure(point.gradient, point.degradation, constants[q]);
      point.tangent_regime = tangent_regime(point);
    }
    evaluate_responses(wanted);
  }



  template <int dim>
  void
  ElasticKernel<dim>::set_points(const ElasticPoint<dim> *first)
  {
    std::copy(first, first + states.size(), states.begin());
    evaluate_responses(ElasticEvaluation::tangents);
  }



  template <int dim>
  void
  ElasticKernel<dim>::evaluate_responses(const ElasticEvaluation wanted)
  {
    evaluated = wanted;
    if (wanted == ElasticEvaluation::points)
      return;
    const bool with_tangent = wanted == ElasticEvaluation::tangents;
    for (unsigned int q = 0; q < states.size(); ++q)
    {
      const auto &[gradient, pressure, g, regime] = states[q];
      (void)regime;
      if (mixed)
        material.mixed(
          gradient, pressure, g, constants[q], with_tangent, responses[q]);
      else
        material.eliminated(
          gradient, g, constants[q], with_tangent, responses[q]);
    }
  }



  // R_(ad) = sum_q w_q (sigma grad N_a)_d, as sigma is symmetric: sigma :
  // eps(w) = sigma : grad w, and P : grad w at finite strain;   R_k = sum_q w_q
  // constraint M_k.
  template <int dim>
  void
  ElasticKernel<dim>::residual(Vector<double> &result) const
  {
    Assert(evaluated != ElasticEvaluation::points,
           ExcMessage("The stresses have not been evaluated."));
    result = 0.;
    for (unsigned int q = 0; q < states.size(); ++q)
    {
      const double         weight = geometry->weights[q];
      const Tensor<2, dim> stress = weight * responses[q].stress;
      for (unsigned int a = 0; a < displacement_dofs.size(); ++a)
      {
        const Tensor<1, dim> force =
          stress * displacement_shapes.gradient(a, q);
        for (unsigned int d = 0; d < dim; ++d)
          result(displacement_dofs[a][d]) += force[d];
      }
      for (unsigned int k = 0; k < pressure_dofs.size(); ++k)
        result(pressure_dofs[k]) +=
          responses[q].constraint * pressure_shapes.value(k, q) * weight;
    }
  }



  // Column by column: the stress T_be = w_q C : eps(N_b e_e) that a unit
  // displacement of node b along e causes, then A_(ad,be) += (T_be grad N_a)_d.
  // Only a <= b, the rest by symmetry. eps(N_b e_e) = sym(e_e (x) grad N_b):
  // row e of the symmetric tensor has half of the gradient, the diagonal entry
  // all of it.
  template <int dim>
  void
  ElasticKernel<dim>::displacement_block(const unsigned int  q,
                                         FullMatrix<double> &result) const
  {
    const SymmetricTensor<4, dim> tangent =
      geometry->weights[q] * responses[q].stress_by_strain;
    for (unsigned int b = 0; b < displacement_dofs.size(); ++b)
    {
      // stresses caused by the components of node b
      std::array<Tensor<2, dim>, dim> stresses;
      for (unsigned int e = 0; e < dim; ++e)
      {
        SymmetricTensor<2, dim> strain;
        for (unsigned int d = 0; d < dim; ++d)
          strain[e][d] =
            (d == e ? 1. : 0.5) * displacement_shapes.gradient(b, q)[d];
        stresses[e] = Tensor<2, dim>(tangent * strain);
      }
      // the tangent derives from an energy, hence is symmetric
      for (unsigned int a = 0; a <= b; ++a)
        for (unsigned int e = 0; e < dim; ++e)
        {
          const Tensor<1, dim> force =
            stresses[e] * displacement_shapes.gradient(a, q);
          for (unsigned int d = 0; d < dim; ++d)
            result(displacement_dofs[a][d], displacement_dofs[b][e]) +=
              force[d];
        }
    }
  }



  // B^T, B' and -M together: div(N_a e_d) = dN_a/dx_d.
  template <int dim>
  void
  ElasticKernel<dim>::pressure_blocks(const unsigned int  q,
                                      FullMatrix<double> &result) const
  {
    const ElasticResponse<dim> &response = responses[q];
    for (unsigned int l = 0; l < pressure_dofs.size(); ++l)
    {
      const unsigned int k = pressure_dofs[l];
      const double shape   = geometry->weights[q] * pressure_shapes.value(l, q);
      for (unsigned int a = 0; a < displacement_dofs.size(); ++a)
        for (unsigned int d = 0; d < dim; ++d)
        {
          const unsigned int i = displacement_dofs[a][d];
          const double       divergence =
            displacement_shapes.gradient(a, q)[d] * shape;
          result(i, k) += response.stress_by_pressure * divergence;
          result(k, i) += response.constraint_by_trace * divergence;
        }
    }
    add_block_of_pressure(q, result);
  }



  template <int dim>
  void
  ElasticKernel<dim>::add_block_of_pressure(const unsigned int  q,
                                            FullMatrix<double> &result) const
  {
    for (unsigned int l = 0; l < pressure_dofs.size(); ++l)
    {
      const double shape = geometry->weights[q] * pressure_shapes.value(l, q);
      for (unsigned int m = 0; m < pressure_dofs.size(); ++m)
        result(pressure_dofs[l], pressure_dofs[m]) +=
          responses[q].constraint_by_pressure * shape *
          pressure_shapes.value(m, q);
    }
  }



  template <int dim>
  void
  ElasticKernel<dim>::jacobian(FullMatrix<double> &result) const
  {
    Assert(evaluated == ElasticEvaluation::tangents,
           ExcMessage("The tangents have not been evaluated."));
    result = 0.;
    for (unsigned int q = 0; q < states.size(); ++q)
    {
      if (material.is_finite())
        finite_displacement_block(q, result);
      else
        displacement_block(q, result);
      if (mixed && material.is_finite())
        finite_pressure_blocks(q, result);
      else if (mixed)
        pressure_blocks(q, result);
    }
    for (unsigned int b = 0; b < displacement_dofs.size(); ++b)
      for (unsigned int a = 0; a < b; ++a)
        for (const unsigned int j : displacement_dofs[b])
          for (const unsigned int i : displacement_dofs[a])
            result(j, i) = result(i, j);
  }



  template class ElasticKernel<2>;
  template class ElasticKernel<3>;
} // namespace MixedCracks
