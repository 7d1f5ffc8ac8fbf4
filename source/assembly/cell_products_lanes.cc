// SPDX-License-Identifier: GPL-2.0-or-later
// Integrals over cells with the elastic tangent, by deal.II's MatrixFree. What
// is kept of a tangent is said in lane_tangents.h; at a point
//
//   small strain   sigma = C : eps + s p I,   constraint = t tr eps + c p,
//   finite strain  P = A : H + K p,           constraint = K : H + c p,
//
// with H = grad u, A = dP/dH and K = dP/dp (lane_response.h), are tested with
// eps(N) or grad N, and with M.
//
// The diagonal: with e_i the unit vectors,
//
//   A_(ai,ai) = sum_q w_q  eps(N_a e_i) : C : eps(N_a e_i),
//
// a (|grad N_a|^2 + (d_i N_a)^2)/2 + b (d_i N_a)^2 where C is isotropic, grad
// N_a . A_(i.i.) . grad N_a at finite strain.

// As many lanes as deal.II was compiled for: one, where it is for any x86-64.
// Its templates have more where this file is compiled for a processor that has
// them: MIXED_CRACKS_LANES = 4 doubles with AVX2 (CMakeLists.txt).
#include <deal.II/base/config.h>
#ifndef MIXED_CRACKS_LANES
#  define MIXED_CRACKS_LANES 0
#endif
#if MIXED_CRACKS_LANES > 0
#  undef DEAL_II_VECTORIZATION_WIDTH_IN_BITS
#  define DEAL_II_VECTORIZATION_WIDTH_IN_BITS (64 * MIXED_CRACKS_LANES)
#endif

#include <assembly/cell_products.h>
#include <assembly/lane_response.h>
#include <assembly/lane_tangents_templates.h>

#include <deal.II/fe/fe_q.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>
#if MIXED_CRACKS_LANES > 0
#  include <deal.II/matrix_free/evaluation_template_factory.templates.h>
#  include <deal.II/matrix_free/evaluation_template_factory_hanging_nodes.templates.h>
#  include <deal.II/matrix_free/mapping_info.templates.h>
#  include <deal.II/matrix_free/mapping_info_storage.templates.h>
#  include <deal.II/matrix_free/matrix_free.templates.h>
#  include <deal.II/matrix_free/shape_info.templates.h>
// has the guard of another one
#  undef dealii_matrix_free_evaluation_template_factory_templates_h
#  include <deal.II/matrix_free/evaluation_template_face_factory.templates.h>
#endif

#include <algorithm>
#include <type_traits>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    template <int dim, int lanes>
    class MatrixFreeProducts : public CellProducts<dim>
    {
    public:
      using Lanes = VectorizedArray<double, lanes>;
      using Free  = MatrixFree<dim, double, Lanes>;
      using typename CellProducts<dim>::Vector;
      using typename CellProducts<dim>::RangeWork;

      MatrixFreeProducts(const Mapping<dim>              &mapping,
                         const DoFHandler<dim>           &handler,
                         const AffineConstraints<double> &constraints)
      {
        typename Free::AdditionalData data;
        data.tasks_parallel_scheme = Free::AdditionalData::none;
        data.mapping_update_flags  = update_gradients | update_JxW_values;
        free.reinit(mapping, handler, constraints, QGauss<1>(3), data);
        number_cells(handler);
        reference_gradients(FE_Q<dim>(2));
      }

      void
      set_tangents(const unsigned int                       cell,
                   const std::vector<ElasticResponse<dim>> &responses) override
      {
        tangents.set(cell, responses);
      }

      bool
      read_tangents(const unsigned int cell,
                    IsotropicCell     &result) const override
      {
        return tangents.read_isotropic(cell, result);
      }

      void
      reinit(Vector &vector) const override
      {
        free.initialize_dof_vector(vector);
      }

      void
      multiply(Vector          &result,
               const Vector    &source,
               const RangeWork &before,
               const RangeWork &after) const override
      {
        free.cell_loop(
          &MatrixFreeProducts::integrate, this, result, source, before, after);
      }

      void
      pressure_forces(Vector &result, const Vector &source) const override
      {
        free.cell_loop(&MatrixFreeProducts::integrate_pressure_forces,
                       this,
                       result,
                       source,
                       true);
      }

      void
      diagonal(Vector &result) const override
      {
        const Vector none(result);
        free.cell_loop(
          &MatrixFreeProducts::integrate_diagonal, this, result, none, true);
      }

      unsigned int
      n_lanes() const override
      {
        return lanes;
      }

      std::size_t
      memory_consumption() const override
      {
        return free.memory_consumption() + tangents.memory_consumption();
      }

    private:
      using Displacement = FEEvaluation<dim, 2, 3, dim, double, Lanes>;
      using Pressure     = FEEvaluation<dim, 1, 3, 1, double, Lanes>;
      using Range        = std::pair<unsigned int, unsigned int>;

      static constexpr unsigned int n_points = Utilities::pow(3, dim);
      static constexpr unsigned int n_nodes  = Utilities::pow(3, dim);

      void
      number_cells(const DoFHandler<dim> &handler)
      {
        std::vector<unsigned int> owned(
          handler.get_triangulation().n_active_cells());
        unsigned int n_owned = 0;
        for (const auto &cell : handler.active_cell_iterators())
          if (cell->is_locally_owned())
            owned[cell->active_cell_index()] = n_owned++;
        std::vector<typename LaneTangents<dim, Lanes>::Place> places(n_owned);
        for (unsigned int batch = 0; batch < free.n_cell_batches(); ++batch)
          for (unsigned int lane = 0;
               lane < free.n_active_entries_per_cell_batch(batch);
               ++lane)
            places[owned[free.get_cell_iterator(batch, lane)
                           ->active_cell_index()]] = {batch, lane};
        tangents.reinit(free.n_cell_batches(), n_points, places);
      }

      void
      reference_gradients(const FE_Q<dim> &element)
      {
        const auto lexicographic = element.get_poly_space_numbering_inverse();
        const QGauss<dim> quadrature(3);
        for (unsigned int q = 0; q < n_points; ++q)
          for (unsigned int a = 0; a < n_nodes; ++a)
            gradients.push_back(
              element.shape_grad(lexicographic[a], quadrature.point(q)));
      }

      void integrate(const Free   &free,
                     Vector       &result,
                     const Vector &source,
                     const Range  &range) const;

      void integrate_pressure_forces(const Free   &free,
                                     Vector       &result,
                                     const Vector &source,
                                     const Range  &range) const;

      void integrate_diagonal(const Free   &free,
                              Vector       &result,
                              const Vector &source,
                              const Range  &range) const;

      template <TangentKind kind>
      void
      respond_at_points(unsigned int batch, Displacement &u, Pressure &p) const;

      /// Call body with the kind of a batch as a constant.
      template <typename Body>
      void
      by_kind(const unsigned int batch, const Body &body) const
      {
        using Graded = std::integral_constant<TangentKind, TangentKind::graded>;
        using Isotropic =
          std::integral_constant<TangentKind, TangentKind::isotropic>;
        using Symmetric =
          std::integral_constant<TangentKind, TangentKind::symmetric>;
        using Finite = std::integral_constant<TangentKind, TangentKind::finite>;
        const TangentKind kind = tangents.kind(batch);
        if (kind == TangentKind::graded)
          body(Graded());
        else if (kind == TangentKind::isotropic)
          body(Isotropic());
        else if (kind == TangentKind::symmetric)
          body(Symmetric());
        else
          body(Finite());
      }

      Free                     free;
      LaneTangents<dim, Lanes> tangents;
      /// of the shape functions, point by point, on the reference cell
      std::vector<Tensor<1, dim>> gradients;
    };



    template <int dim, int lanes>
    template <TangentKind kind>
    void
    MatrixFreeProducts<dim, lanes>::respond_at_points(const unsigned int batch,
                                                      Displacement      &u,
                                                      Pressure &p) const
    {
      PointNumbers<dim, Lanes, kind> numbers(tangents, batch);
      for (unsigned int q = 0; q < n_points; ++q)
      {
        Tensor<2, dim, Lanes> stress;
        Lanes                 constraint;
        respond<numbers.kind>(numbers.next(),
                              u.get_gradient(q),
                              p.get_value(q),
                              stress,
                              constraint);
        u.submit_gradient(stress, q);
        p.submit_value(constraint, q);
      }
    }



    template <int dim, int lanes>
    void
    MatrixFreeProducts<dim, lanes>::integrate(const Free   &free,
                                              Vector       &result,
                                              const Vector &source,
                                              const Range  &range) const
    {
      Displacement u(free, 0, 0, 0);
      Pressure     p(free, 0, 0, dim);
      for (unsigned int batch = range.first; batch < range.second; ++batch)
      {
        u.reinit(batch);
        p.reinit(batch);
        u.gather_evaluate(source, EvaluationFlags::gradients);
        p.gather_evaluate(source, EvaluationFlags::values);
        by_kind(batch,
                [&](const auto kind) { respond_at_points<kind>(batch, u, p); });
        u.integrate_scatter(EvaluationFlags::gradients, result);
        p.integrate_scatter(EvaluationFlags::values, result);
      }
    }



    template <int dim, int lanes>
    void
    MatrixFreeProducts<dim, lanes>::integrate_pressure_forces(
      const Free   &free,
      Vector       &result,
      const Vector &source,
      const Range  &range) const
    {
      Displacement u(free, 0, 0, 0);
      Pressure     p(free, 0, 0, dim);
      for (unsigned int batch = range.first; batch < range.second; ++batch)
      {
        u.reinit(batch);
        p.reinit(batch);
        p.gather_evaluate(source, EvaluationFlags::values);
        by_kind(batch, [&](const auto kind) {
          PointNumbers<dim, Lanes, kind> numbers(tangents, batch);
          constexpr unsigned int         n =
            LaneTangents<dim, Lanes>::n_numbers(numbers.kind);
          for (unsigned int q = 0; q < n_points; ++q)
          {
            const Lanes *here = numbers.next();
            if constexpr (kind == TangentKind::finite)
            {
              const Lanes          *coupling = here + n - dim * dim - 1;
              Tensor<2, dim, Lanes> stress;
              for (unsigned int i = 0; i < dim * dim; ++i)
                stress[i / dim][i % dim] = coupling[i] * p.get_value(q);
              u.submit_gradient(stress, q);
            }
            else
              u.submit_divergence(here[n - 3] * p.get_value(q), q);
          }
        });
        u.integrate_scatter(EvaluationFlags::gradients, result);
      }
    }



    template <int dim, int lanes>
    void
    MatrixFreeProducts<dim, lanes>::integrate_diagonal(const Free &free,
                                                       Vector     &result,
                                                       const Vector &,
                                                       const Range &range) const
    {
      Displacement u(free, 0, 0, 0);
      for (unsigned int batch = range.first; batch < range.second; ++batch)
      {
        u.reinit(batch);
        Lanes *sums = u.begin_dof_values();
        std::fill(sums, sums + dim * n_nodes, Lanes(0.));
        by_kind(batch, [&](const auto kind) {
          PointNumbers<dim, Lanes, kind> numbers(tangents, batch);
          for (unsigned int q = 0; q < n_points; ++q)
          {
            const Tensor<2, dim, Lanes> inverse = u.inverse_jacobian(q);
            const Lanes                *here    = numbers.next();
            for (unsigned int a = 0; a < n_nodes; ++a)
            {
              Tensor<1, dim, Lanes> gradient;
              for (unsigned int d = 0; d < dim; ++d)
                for (unsigned int e = 0; e < dim; ++e)
                  gradient[d] += inverse[d][e] * gradients[q * n_nodes + a][e];
              add_to_diagonal<numbers.kind>(
                here, u.JxW(q), gradient, n_nodes, sums + a);
            }
          }
        });
        u.distribute_local_to_global(result);
      }
    }
  } // namespace



  template <int dim, int lanes>
  std::unique_ptr<CellProducts<dim>>
  make_cell_products_with_lanes(const Mapping<dim>              &mapping,
                                const DoFHandler<dim>           &handler,
                                const AffineConstraints<double> &constraints)
  {
    constexpr int n = lanes > 0 ? lanes : VectorizedArray<double>::size();
    return std::make_unique<MatrixFreeProducts<dim, n>>(
      mapping, handler, constraints);
  }



#define INSTANTIATE(dim)                                  \
  template std::unique_ptr<CellProducts<dim>>             \
  make_cell_products_with_lanes<dim, MIXED_CRACKS_LANES>( \
    const Mapping<dim> &,                                 \
    const DoFHandler<dim> &,                              \
    const AffineConstraints<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
