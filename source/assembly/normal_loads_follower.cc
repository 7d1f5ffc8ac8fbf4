// SPDX-License-Identifier: GPL-2.0-or-later
// A pressure p on a boundary that follows it, with n dA of the undeformed body,
// n outward, w a test function:
//
//   F(w) = - integral of p cof(F) n . w dA,    cof(F) n dA = a dA = n' dA'.
//
// With unit tangents T_1, T_2 of the undeformed face, T_1 x T_2 = n (in 2-d T,
// n = (T_y, -T_x)), and those of the deformed one g_k = F T_k = T_k + grad u
// T_k,
//
//   2-d   a = (g_y, -g_x),     3-d   a = g_1 x g_2,
//
// so that only derivatives along the face are needed, and only its own nodes
// take part. For an increment du, dg_k = grad du T_k,
//
//   - dF(w) = + integral of p da . w dA,
//   2-d   da = (dg_y, -dg_x),  3-d   da = dg_1 x g_2 + g_1 x dg_2.
//
// The matrix of one face is not symmetric. In the sum over faces of a constant
// p only terms at the rim are left of the unsymmetric part, and none where the
// rim is held or there is none; with a p that varies, or a rim that moves, the
// pressure has no potential (Bonet and Wood, Nonlinear Continuum Mechanics for
// Finite Element Analysis, on pressure forces). The whole matrix is kept:
// solvers are told that it is not symmetric.
//
// In 2-d a dA is a force per mm of deformed thickness, which in plane strain is
// that of the undeformed body.

#include <assembly/loaded_faces.h>
#include <assembly/normal_loads.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Tangents = std::array<Tensor<1, dim>, dim - 1>;

    // unit vectors along a face, their product its normal
    template <int dim>
    Tangents<dim>
    tangents_of_face(const Tensor<1, dim> &normal)
    {
      if constexpr (dim == 2)
        return {{Tensor<1, 2>({-normal[1], normal[0]})}};
      else
      {
        unsigned int least = 0;
        for (unsigned int d = 1; d < dim; ++d)
          if (std::abs(normal[d]) < std::abs(normal[least]))
            least = d;
        Tensor<1, 3> axis;
        axis[least]        = 1.;
        Tensor<1, 3> first = axis - (axis * normal) * normal;
        first /= first.norm();
        return {{first, cross_product_3d(normal, first)}};
      }
    }



    // a of the deformed tangents
    template <int dim>
    Tensor<1, dim>
    area_vector(const Tangents<dim> &g)
    {
      if constexpr (dim == 2)
        return Tensor<1, 2>({g[0][1], -g[0][0]});
      else
        return cross_product_3d(g[0], g[1]);
    }



    // da for increments dg of them
    template <int dim>
    Tensor<1, dim>
    change_of_area(const Tangents<dim> &g, const Tangents<dim> &dg)
    {
      if constexpr (dim == 2)
        return area_vector<2>(dg);
      else
        return cross_product_3d(dg[0], g[1]) + cross_product_3d(g[0], dg[1]);
    }



    // A pressure between those of two times, at the points of a face.
    template <int dim>
    std::vector<double>
    pressures_at_points(const FEFaceValues<dim> &values,
                        Function<dim>           &pressure,
                        const double             from,
                        const double             to,
                        const double             part)
    {
      std::vector<double> result(values.n_quadrature_points, 0.);
      const auto          add = [&](const double time, const double factor) {
        if (factor == 0.)
          return;
        pressure.set_time(time);
        for (unsigned int q = 0; q < result.size(); ++q)
          result[q] += factor * pressure.value(values.quadrature_point(q), 0);
      };
      add(from, 1. - part);
      add(to, part);
      return result;
    }



    // g_k at the points of a face, for the displacements of a vector
    template <int dim>
    std::vector<Tangents<dim>>
    deformed_tangents(const FEFaceValues<dim>     &values,
                      const LinearAlgebra::Vector &elastic,
                      const bool                   only_increments)
    {
      std::vector<Tensor<2, dim>> gradients(values.n_quadrature_points);
      values[FEValuesExtractors::Vector(0)].get_function_gradients(elastic,
                                                                   gradients);
      std::vector<Tangents<dim>> result;
      for (unsigned int q = 0; q < gradients.size(); ++q)
      {
        const Tangents<dim> undeformed =
          tangents_of_face<dim>(values.normal_vector(q));
        Tangents<dim> deformed;
        for (unsigned int k = 0; k < dim - 1; ++k)
        {
          deformed[k] = gradients[q] * undeformed[k];
          if (!only_increments)
            deformed[k] += undeformed[k];
        }
        result.push_back(deformed);
      }
      return result;
    }



    // += integral of pressure da(N_j) . N_i
    template <int dim>
    void
    add_pressure_tangent(const FEFaceValues<dim>          &values,
                         const std::vector<double>        &pressures,
                         const std::vector<Tangents<dim>> &deformed,
                         FullMatrix<double>               &local)
    {
      const unsigned int n = values.dofs_per_cell;
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
      {
        const Tangents<dim> undeformed =
          tangents_of_face<dim>(values.normal_vector(q));
        for (unsigned int j = 0; j < n; ++j)
        {
          const unsigned int d = component_of(values, j);
          if (d >= dim)
            continue;
          Tangents<dim> increment;
          for (unsigned int k = 0; k < dim - 1; ++k)
            increment[k][d] = values.shape_grad(j, q) * undeformed[k];
          const Tensor<1, dim> change =
            pressures[q] * values.JxW(q) *
            change_of_area<dim>(deformed[q], increment);
          for (unsigned int i = 0; i < n; ++i)
            if (const unsigned int c = component_of(values, i); c < dim)
              local(i, j) += change[c] * values.shape_value(i, q);
        }
      }
    }
  } // namespace



  template <int dim>
  FollowerPressure<dim>::FollowerPressure(const Fields<dim>     &fields,
                                          BoundaryFunctions<dim> pressures)
    : fields(fields)
    , pressures(std::move(pressures))
  {}



  template <int dim>
  void
  FollowerPressure<dim>::set_level(const double new_from,
                                   const double new_to,
                                   const double new_part)
  {
    from = new_from;
    to   = new_to;
    part = new_part;
  }



  template <int dim>
  void
  FollowerPressure<dim>::advance_level(const double fraction)
  {
    part += fraction * (1. - part);
  }



  template <int dim>
  void
  FollowerPressure<dim>::add_forces(const Vector      &elastic,
                                    const Constraints &constraints,
                                    Vector            &forces)
  {
    if (!any())
      return;
    state.reinit(fields.elastic_dofs.owned,
                 fields.elastic_dofs.relevant,
                 fields.communicator());
    state = elastic;
    dealii::Vector<double> local(fields.elastic.get_fe().n_dofs_per_cell());
    add_loaded_faces<dim>(
      fields,
      pressures,
      update_gradients,
      constraints,
      local,
      forces,
      [&](const auto &values, Function<dim> &pressure) {
        std::vector<Tensor<1, dim>> areas;
        for (const auto &g : deformed_tangents<dim>(values, state, false))
          areas.push_back(area_vector<dim>(g));
        add_pressure(values,
                     pressures_at_points(values, pressure, from, to, part),
                     areas,
                     -1.,
                     local);
      });
  }



  template <int dim>
  void
  FollowerPressure<dim>::add_tangent(const Constraints           &constraints,
                                     LinearAlgebra::SparseMatrix &matrix) const
  {
    if (!any())
      return;
    const unsigned int n = fields.elastic.get_fe().n_dofs_per_cell();
    FullMatrix<double> local(n, n);
    add_loaded_faces<dim>(
      fields,
      pressures,
      update_gradients,
      constraints,
      local,
      matrix,
      [&](const auto &values, Function<dim> &pressure) {
        add_pressure_tangent(
          values,
          pressures_at_points(values, pressure, from, to, part),
          deformed_tangents<dim>(values, state, false),
          local);
      });
  }



  template <int dim>
  void
  FollowerPressure<dim>::add_tangent_times(const Vector      &direction,
                                           const Constraints &constraints,
                                           Vector            &result) const
  {
    if (!any())
      return;
    dealii::Vector<double> local(fields.elastic.get_fe().n_dofs_per_cell());
    add_loaded_faces<dim>(
      fields,
      pressures,
      update_gradients,
      constraints,
      local,
      result,
      [&](const auto &values, Function<dim> &pressure) {
        const auto g  = deformed_tangents<dim>(values, state, false);
        const auto dg = deformed_tangents<dim>(values, direction, true);
        std::vector<Tensor<1, dim>> changes;
        for (unsigned int q = 0; q < g.size(); ++q)
          changes.push_back(change_of_area<dim>(g[q], dg[q]));
        add_pressure(values,
                     pressures_at_points(values, pressure, from, to, part),
                     changes,
                     1.,
                     local);
      });
  }



#define INSTANTIATE(dim) template class FollowerPressure<dim>;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
