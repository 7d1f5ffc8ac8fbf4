// SPDX-License-Identifier: GPL-2.0-or-later
// Integrals over cells with the elastic tangent, by deal.II's MatrixFree. Of a
// tangent at a point there is kept
//
//   isotropic   C = a 1 + b I (x) I      a, b         whatever the degradation:
//                                                     intact, or Amor's split
//   general     the upper triangle of C as a symmetric matrix in the numbering
//               of SymmetricTensor       6 in 2-d, 21 in 3-d
//
// and the three numbers of the pressure, s, t and c (matrix_free_elastic.cc).
// The cells of a batch, which are integrated together, are kept as general if
// one of them is.
//
// The diagonal: with e_i the unit vectors,
//
//   A_(ai,ai) = sum_q w_q  eps(N_a e_i) : C : eps(N_a e_i),
//
// a (|grad N_a|^2 + (d_i N_a)^2)/2 + b (d_i N_a)^2 where C is isotropic.

// deal.II of most distributions is compiled for plain x86-64 and has one lane.
// Its templates have more where this file is compiled for a processor that has
// them: MIXED_CRACKS_LANES = 4 doubles with AVX2 (CMakeLists.txt).
#include <deal.II/base/config.h>
#ifndef MIXED_CRACKS_LANES
#  define MIXED_CRACKS_LANES 1
#endif
#if MIXED_CRACKS_LANES > 1
#  undef DEAL_II_VECTORIZATION_WIDTH_IN_BITS
#  define DEAL_II_VECTORIZATION_WIDTH_IN_BITS (64 * MIXED_CRACKS_LANES)
#endif

#include <assembly/cell_products.h>

#include <deal.II/fe/fe_q.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>
#if MIXED_CRACKS_LANES > 1
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
#include <cmath>
#include <map>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // of C as a symmetric matrix
    template <int dim>
    constexpr unsigned int n_strains = dim *(dim + 1) / 2;

    // a, b or the triangle, then s, t, c
    constexpr unsigned int n_isotropic = 5;
    template <int dim>
    constexpr unsigned int
      n_general = n_strains<dim> *(n_strains<dim> + 1) / 2 + 3;



    template <int dim>
    std::array<double, n_general<dim>>
    general_numbers(const ElasticResponse<dim> &response)
    {
      std::array<double, n_general<dim>> result;
      unsigned int                       at = 0;
      for (unsigned int i = 0; i < n_strains<dim>; ++i)
        for (unsigned int j = i; j < n_strains<dim>; ++j)
          result[at++] = tangent_entry(response.stress_by_strain, i, j);
      result[at++] = response.stress_by_pressure;
      result[at++] = response.constraint_by_trace;
      result[at]   = response.constraint_by_pressure;
      return result;
    }



    template <int dim, int lanes>
    class MatrixFreeProducts : public CellProducts<dim>
    {
    public:
      using Lanes  = VectorizedArray<double, lanes>;
      using Free   = MatrixFree<dim, double, Lanes>;
      using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

      MatrixFreeProducts(const Mapping<dim>              &mapping,
                         const DoFHandler<dim>           &handler,
                         const AffineConstraints<double> &constraints)
      {
        typename Free::AdditionalData data;
        data.tasks_parallel_scheme = Free::AdditionalData::none;
        data.mapping_update_flags  = update_gradients | update_JxW_values;
        free.reinit(mapping, handler, constraints, QGauss<1>(3), data);
        free.initialize_dof_vector(source_vector);
        free.initialize_dof_vector(result_vector);
        number_cells(handler);
        reference_gradients(FE_Q<dim>(2));
      }

      void
      set_tangents(const unsigned int                       cell,
                   const std::vector<ElasticResponse<dim>> &responses) override
      {
        const auto [batch, lane] = places[cell];
        bool isotropic           = true;
        for (unsigned int q = 0; q < n_points; ++q)
        {
          const auto constants =
            isotropic_tangent(responses[q].stress_by_strain);
          isotropic &= constants.has_value();
          Lanes *at   = &isotropic_numbers[(std::size_t(batch) * n_points + q) *
                                         n_isotropic];
          at[0][lane] = constants ? constants->identity : 0.;
          at[1][lane] = constants ? constants->volume : 0.;
          at[2][lane] = responses[q].stress_by_pressure;
          at[3][lane] = responses[q].constraint_by_trace;
          at[4][lane] = responses[q].constraint_by_pressure;
        }
        if (isotropic)
          return;
        auto &numbers = pending[cell];
        for (const ElasticResponse<dim> &response : responses)
        {
          const auto point = general_numbers(response);
          numbers.insert(numbers.end(), point.begin(), point.end());
        }
      }

      void compress() override;

      void
      multiply(double *result, const double *source) const override
      {
        read(source);
        free.cell_loop(&MatrixFreeProducts::integrate,
                       this,
                       result_vector,
                       source_vector,
                       true);
        write(result);
      }

      void
      pressure_forces(double *result, const double *source) const override
      {
        read(source);
        free.cell_loop(&MatrixFreeProducts::integrate_pressure_forces,
                       this,
                       result_vector,
                       source_vector,
                       true);
        write(result);
      }

      void
      diagonal(double *result) const override
      {
        source_vector = 0.;
        free.cell_loop(&MatrixFreeProducts::integrate_diagonal,
                       this,
                       result_vector,
                       source_vector,
                       true);
        write(result);
      }

      unsigned int
      n_lanes() const override
      {
        return lanes;
      }

      std::size_t
      memory_consumption() const override
      {
        return free.memory_consumption() +
               2 * source_vector.memory_consumption() +
               isotropic_numbers.memory_consumption() +
               general_numbers_of_batches.memory_consumption() +
               MemoryConsumption::memory_consumption(first_general);
      }

    private:
      using Displacement = FEEvaluation<dim, 2, 3, dim, double, Lanes>;
      using Pressure     = FEEvaluation<dim, 1, 3, 1, double, Lanes>;
      using Range        = std::pair<unsigned int, unsigned int>;

      static constexpr unsigned int n_points = Utilities::pow(3, dim);
      static constexpr unsigned int n_nodes  = Utilities::pow(3, dim);
      static constexpr std::size_t  nowhere  = -1;

      void
      number_cells(const DoFHandler<dim> &handler)
      {
        std::vector<unsigned int> owned(
          handler.get_triangulation().n_active_cells());
        unsigned int n_owned = 0;
        for (const auto &cell : handler.active_cell_iterators())
          if (cell->is_locally_owned())
            owned[cell->active_cell_index()] = n_owned++;
        places.resize(n_owned);
        for (unsigned int batch = 0; batch < free.n_cell_batches(); ++batch)
          for (unsigned int lane = 0;
               lane < free.n_active_entries_per_cell_batch(batch);
               ++lane)
            places[owned[free.get_cell_iterator(batch, lane)
                           ->active_cell_index()]] = {batch, lane};
        // what no cell fills is multiplied too: let it be harmless
        isotropic_numbers.resize(std::size_t(free.n_cell_batches()) * n_points *
                                   n_isotropic,
                                 Lanes(0.));
        first_general.assign(free.n_cell_batches(), nowhere);
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

      void
      read(const double *source) const
      {
        std::copy(source,
                  source + source_vector.locally_owned_size(),
                  source_vector.begin());
      }

      void
      write(double *result) const
      {
        std::copy(result_vector.begin(),
                  result_vector.begin() + result_vector.locally_owned_size(),
                  result);
      }

      // C : eps
      static SymmetricTensor<2, dim, Lanes>
      stress(const Lanes                          *triangle,
             const SymmetricTensor<2, dim, Lanes> &strain)
      {
        // of a pair of shear strains the tensor has one, C : eps both
        std::array<Lanes, n_strains<dim>> weighted, sum;
        for (unsigned int i = 0; i < n_strains<dim>; ++i)
        {
          weighted[i] = (i < dim ? 1. : 2.) * strain.access_raw_entry(i);
          sum[i]      = 0.;
        }
        for (unsigned int i = 0; i < n_strains<dim>; ++i)
        {
          sum[i] += *triangle++ * weighted[i];
          for (unsigned int j = i + 1; j < n_strains<dim>; ++j, ++triangle)
          {
            sum[i] += *triangle * weighted[j];
            sum[j] += *triangle * weighted[i];
          }
        }
        SymmetricTensor<2, dim, Lanes> result;
        for (unsigned int i = 0; i < n_strains<dim>; ++i)
          result.access_raw_entry(i) = sum[i];
        return result;
      }

      static SymmetricTensor<2, dim, Lanes>
      isotropic_stress(const Lanes                          *numbers,
                       const SymmetricTensor<2, dim, Lanes> &strain)
      {
        SymmetricTensor<2, dim, Lanes> result = numbers[0] * strain;
        const Lanes                    volume = numbers[1] * trace(strain);
        for (unsigned int d = 0; d < dim; ++d)
          result[d][d] += volume;
        return result;
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

      const Lanes *
      isotropic(const unsigned int batch) const
      {
        return &isotropic_numbers[std::size_t(batch) * n_points * n_isotropic];
      }

      const Lanes *
      general(const unsigned int batch) const
      {
        return first_general[batch] == nowhere
                 ? nullptr
                 : &general_numbers_of_batches[first_general[batch]];
      }

      Free free;
      /// batch and lane of owned cells
      std::vector<std::pair<unsigned int, unsigned int>> places;
      AlignedVector<Lanes>                               isotropic_numbers;
      AlignedVector<Lanes>                        general_numbers_of_batches;
      std::vector<std::size_t>                    first_general; // of a batch
      std::map<unsigned int, std::vector<double>> pending; // until compress()
      /// of the shape functions, point by point, on the reference cell
      std::vector<Tensor<1, dim>> gradients;
      mutable Vector              source_vector, result_vector;
    };



    template <int dim, int lanes>
    void
    MatrixFreeProducts<dim, lanes>::compress()
    {
      std::fill(first_general.begin(), first_general.end(), nowhere);
      constexpr std::size_t size      = n_points * n_general<dim>;
      std::size_t           n_batches = 0;
      for (const auto &entry : pending)
      {
        std::size_t &first = first_general[places[entry.first].first];
        if (first == nowhere)
          first = size * n_batches++;
      }
      general_numbers_of_batches.clear();
      general_numbers_of_batches.resize(size * n_batches, Lanes(0.));
      for (unsigned int cell = 0; cell < places.size() && n_batches > 0; ++cell)
      {
        const auto [batch, lane] = places[cell];
        if (first_general[batch] == nowhere)
          continue;
        Lanes *to = &general_numbers_of_batches[first_general[batch]];
        if (const auto found = pending.find(cell); found != pending.end())
        {
          for (const double number : found->second)
            (to++)[0][lane] = number;
          continue;
        }
        const Lanes *from = isotropic(batch);
        for (unsigned int q = 0; q < n_points; ++q, from += n_isotropic)
        {
          for (unsigned int i = 0; i < n_strains<dim>; ++i)
            for (unsigned int j = i; j < n_strains<dim>; ++j)
              (to++)[0][lane] =
                (i == j ? (i < dim ? 1. : 0.5) * from[0][lane] : 0.) +
                (j < dim ? from[1][lane] : 0.);
          for (unsigned int k = 2; k < n_isotropic; ++k)
            (to++)[0][lane] = from[k][lane];
        }
      }
      pending.clear();
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
        const Lanes *constants = isotropic(batch), *triangle = general(batch);
        for (unsigned int q = 0; q < n_points; ++q)
        {
          const auto strain   = u.get_symmetric_gradient(q);
          const auto pressure = p.get_value(q);
          auto sigma = triangle == nullptr ? isotropic_stress(constants, strain)
                                           : stress(triangle, strain);
          for (unsigned int d = 0; d < dim; ++d)
            sigma[d][d] += constants[2] * pressure;
          u.submit_symmetric_gradient(sigma, q);
          p.submit_value(constants[3] * trace(strain) + constants[4] * pressure,
                         q);
          constants += n_isotropic;
          if (triangle != nullptr)
            triangle += n_general<dim>;
        }
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
        const Lanes *constants = isotropic(batch);
        for (unsigned int q = 0; q < n_points; ++q, constants += n_isotropic)
          u.submit_divergence(constants[2] * p.get_value(q), q);
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
        const Lanes *constants = isotropic(batch), *triangle = general(batch);
        for (unsigned int q = 0; q < n_points; ++q, constants += n_isotropic)
        {
          const Lanes                 weight  = u.JxW(q);
          const Tensor<2, dim, Lanes> inverse = u.inverse_jacobian(q);
          for (unsigned int a = 0; a < n_nodes; ++a)
          {
            Tensor<1, dim, Lanes> gradient;
            for (unsigned int d = 0; d < dim; ++d)
              for (unsigned int e = 0; e < dim; ++e)
                gradient[d] += inverse[d][e] * gradients[q * n_nodes + a][e];
            if (triangle == nullptr)
            {
              const Lanes half = 0.5 * weight * constants[0];
              const Lanes both = half * gradient.norm_square();
              const Lanes own  = half + weight * constants[1];
              for (unsigned int d = 0; d < dim; ++d)
                sums[d * n_nodes + a] +=
                  both + own * (gradient[d] * gradient[d]);
              continue;
            }
            for (unsigned int d = 0; d < dim; ++d)
            {
              SymmetricTensor<2, dim, Lanes> strain;
              for (unsigned int e = 0; e < dim; ++e)
                strain[d][e] = (d == e ? 1. : 0.5) * gradient[e];
              sums[d * n_nodes + a] +=
                weight * (strain * stress(triangle, strain));
            }
          }
          if (triangle != nullptr)
            triangle += n_general<dim>;
        }
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
    return std::make_unique<MatrixFreeProducts<dim, lanes>>(
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
