// SPDX-License-Identifier: GPL-2.0-or-later
// With C = a 1 + b I (x) I the stiffness of linear displacements L_a e_d is
//
//   sum_q w_q ( b d_d L_a d_e L_b
//               + a/2 ( d_e L_a d_d L_b + delta_de grad L_a . grad L_b ) ),
//
// four a at a time: 4 vertices in the plane, 8 in space.

#include <assembly/isotropic_cell.h>

#include <base/lanes.h>

#include <deal.II/fe/fe_q.h>

#include <algorithm>

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
  LinearStiffness<dim>::LinearStiffness(const Quadrature<dim> &quadrature)
    : entries(dim * dim * n_shapes * n_shapes)
  {
    const FE_Q<dim> element(1);
    for (const Point<dim> &point : quadrature.get_points())
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int a = 0; a < n_shapes; ++a)
          gradients.push_back(element.shape_grad(a, point)[d]);
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

    template <int dim>
    inline __attribute__((always_inline)) void
    add_stiffness(const Points &points, double *entries)
    {
      constexpr unsigned int n_shapes = 1u << dim, n_parts = n_shapes / n_lanes;
      const double          *reference = points.reference_gradients;
      const double          *jacobian  = points.inverse_jacobians;
      for (std::size_t q = 0; q < points.n; ++q, jacobian += dim * dim)
      {
        Doubles gradient[dim][n_parts] = {};
        for (unsigned int i = 0; i < dim; ++i, reference += n_shapes)
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int k = 0; k < n_parts; ++k)
              gradient[d][k] +=
                load<Doubles>(reference + n_lanes * k) * jacobian[dim * i + d];
        double single[dim][n_shapes];
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int k = 0; k < n_parts; ++k)
            store(gradient[d][k], single[d] + n_lanes * k);
        const double half   = 0.5 * points.weights[q] * points.identity[q];
        const double volume = points.weights[q] * points.volume[q];
        double      *entry  = entries;
        for (unsigned int b = 0; b < n_shapes; ++b)
        {
          Doubles shared[n_parts] = {};
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int k = 0; k < n_parts; ++k)
              shared[k] += gradient[d][k] * (half * single[d][b]);
          for (unsigned int e = 0; e < dim; ++e)
            for (unsigned int d = 0; d < dim; ++d)
              for (unsigned int k = 0; k < n_parts; ++k, entry += n_lanes)
              {
                Doubles sum = load<Doubles>(entry) +
                              gradient[d][k] * (volume * single[e][b]) +
                              gradient[e][k] * (half * single[d][b]);
                if (d == e)
                  sum += shared[k];
                store(sum, entry);
              }
        }
      }
    }



    // the same for processors that have it
    template <int dim>
    MIXED_CRACKS_FOR_AVX2 void
    add_stiffness_avx2(const Points &points, double *entries)
    {
      add_stiffness<dim>(points, entries);
    }
  } // namespace



  template <int dim>
  void
  LinearStiffness<dim>::assemble(const CellGeometry<dim> &geometry,
                                 const IsotropicCell     &cell)
  {
    std::fill(entries.begin(), entries.end(), 0.);
    const Points points{geometry.weights.size(),
                        gradients.data(),
                        geometry.inverse_jacobians.front().begin_raw(),
                        geometry.weights.data(),
                        cell.identity.data(),
                        cell.volume.data()};
    if (has_avx2())
      add_stiffness_avx2<dim>(points, entries.data());
    else
      add_stiffness<dim>(points, entries.data());
  }



  template bool IsotropicCell::read(const std::vector<ElasticResponse<2>> &);
  template bool IsotropicCell::read(const std::vector<ElasticResponse<3>> &);
  template class LinearStiffness<2>;
  template class LinearStiffness<3>;
} // namespace MixedCracks
