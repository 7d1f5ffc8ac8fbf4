// SPDX-License-Identifier: GPL-2.0-or-later
// With C = a 1 + b I (x) I the stiffness of displacements N_a e_d is
//
//   sum_q w_q ( b d_d N_a d_e N_b
//               + a/2 ( d_e N_a d_d N_b + delta_de grad N_a . grad N_b ) ),
//
// four N_a at a time in registers.

#include <assembly/isotropic_cell.h>

#include <base/lanes.h>

namespace MixedCracks
{
  using namespace dealii;

  void
  IsotropicCell::resize(const unsigned int n_points)
  {
    for (std::vector<double> *values : {&identity,
                                        &volume,
                                        &stress_by_pressure,
                                        &constraint_by_trace,
                                        &constraint_by_pressure})
      values->resize(n_points);
  }



  template <int dim>
  bool
  IsotropicCell::read(const std::vector<ElasticResponse<dim>> &responses)
  {
    resize(responses.size());
    for (unsigned int q = 0; q < responses.size(); ++q)
    {
      if (responses[q].finite)
        return false;
      const auto tangent = isotropic_tangent(responses[q].stress_by_strain);
      if (!tangent)
        return false;
      identity[q]               = tangent->identity;
      volume[q]                 = tangent->volume;
      stress_by_pressure[q]     = responses[q].stress_by_pressure;
      constraint_by_trace[q]    = responses[q].constraint_by_trace;
      constraint_by_pressure[q] = responses[q].constraint_by_pressure;
    }
    return true;
  }



  template <int dim>
  IsotropicStiffness<dim>::IsotropicStiffness(const FE_Q<dim>       &element,
                                              const Quadrature<dim> &quadrature)
    : n(element.n_dofs_per_cell())
    , n_padded((n + n_lanes - 1) / n_lanes * n_lanes)
    , entries(dim * dim * n * n_padded)
  {
    for (const Point<dim> &point : quadrature.get_points())
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int a = 0; a < n_padded; ++a)
          reference_gradients.push_back(a < n ? element.shape_grad(a, point)[d]
                                              : 0.);
    gradients.resize(reference_gradients.size());
  }



  namespace
  {
    struct Points
    {
      std::size_t   n;
      const double *reference_gradients;
      const double *inverse_jacobians;
      const double *weights;
      const double *identity;
      const double *volume;
    };

    // the reference gradients times the inverse Jacobians
    template <int dim, unsigned int n_shapes>
    inline __attribute__((always_inline)) void
    transform(const Points &points, double *gradients)
    {
      constexpr unsigned int size      = (n_shapes + n_lanes - 1) / n_lanes;
      const double          *reference = points.reference_gradients;
      const double          *jacobian  = points.inverse_jacobians;
      for (std::size_t q = 0; q < points.n; ++q, jacobian += dim * dim)
      {
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int k = 0; k < size; ++k, gradients += n_lanes)
          {
            Doubles sum = {};
            for (unsigned int i = 0; i < dim; ++i)
              sum += load<Doubles>(reference + n_lanes * (size * i + k)) *
                     jacobian[dim * i + d];
            store(sum, gradients);
          }
        reference += dim * size * n_lanes;
      }
    }



    template <int dim, unsigned int n_shapes>
    inline __attribute__((always_inline)) void
    stiffness(const Points &points, double *gradients, double *entries)
    {
      constexpr unsigned int size = (n_shapes + n_lanes - 1) / n_lanes;
      transform<dim, n_shapes>(points, gradients);
      for (unsigned int b = 0; b < n_shapes; ++b)
      {
        Doubles       sums[dim][dim][size] = {};
        const double *of_point             = gradients;
        for (std::size_t q = 0; q < points.n; ++q)
        {
          const double half   = 0.5 * points.weights[q] * points.identity[q];
          const double volume = points.weights[q] * points.volume[q];
          double       of_b[dim];
          for (unsigned int d = 0; d < dim; ++d)
            of_b[d] = of_point[n_lanes * size * d + b];
          for (unsigned int k = 0; k < size; ++k)
          {
            Doubles gradient[dim], shared = {};
            for (unsigned int d = 0; d < dim; ++d)
            {
              gradient[d] = load<Doubles>(of_point + n_lanes * (size * d + k));
              shared += gradient[d] * (half * of_b[d]);
            }
            for (unsigned int e = 0; e < dim; ++e)
              for (unsigned int d = 0; d < dim; ++d)
              {
                sums[e][d][k] += gradient[d] * (volume * of_b[e]) +
                                 gradient[e] * (half * of_b[d]);
                if (d == e)
                  sums[e][d][k] += shared;
              }
          }
          of_point += n_lanes * size * dim;
        }
        for (unsigned int e = 0; e < dim; ++e)
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int k = 0; k < size; ++k, entries += n_lanes)
              store(sums[e][d][k], entries);
      }
    }



    // the same for processors that have it
    template <int dim, unsigned int n_shapes>
    MIXED_CRACKS_FOR_AVX2 void
    stiffness_avx2(const Points &points, double *gradients, double *entries)
    {
      stiffness<dim, n_shapes>(points, gradients, entries);
    }



    template <int dim, unsigned int n_shapes>
    void
    assemble_in_lanes(const Points &points, double *gradients, double *entries)
    {
      if (has_avx2())
        stiffness_avx2<dim, n_shapes>(points, gradients, entries);
      else
        stiffness<dim, n_shapes>(points, gradients, entries);
    }
  } // namespace



  template <int dim>
  void
  IsotropicStiffness<dim>::assemble(const CellGeometry<dim> &geometry,
                                    const IsotropicCell     &cell)
  {
    constexpr unsigned int n_linear    = Utilities::pow(2, dim);
    constexpr unsigned int n_quadratic = Utilities::pow(3, dim);
    AssertThrow(n == n_linear || n == n_quadratic, ExcNotImplemented());
    const Points points{geometry.weights.size(),
                        reference_gradients.data(),
                        &geometry.inverse_jacobians.front()[0][0],
                        geometry.weights.data(),
                        cell.identity.data(),
                        cell.volume.data()};
    if (n == n_linear)
      assemble_in_lanes<dim, n_linear>(
        points, gradients.data(), entries.data());
    else
      assemble_in_lanes<dim, n_quadratic>(
        points, gradients.data(), entries.data());
  }



  template bool IsotropicCell::read(const std::vector<ElasticResponse<2>> &);
  template bool IsotropicCell::read(const std::vector<ElasticResponse<3>> &);
  template class IsotropicStiffness<2>;
  template class IsotropicStiffness<3>;
} // namespace MixedCracks
