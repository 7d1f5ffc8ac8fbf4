// SPDX-License-Identifier: GPL-2.0-or-later
#include <assembly/elastic_kernel.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  ElasticKernel<dim>::ElasticKernel(const FiniteElement<dim> &element,
                                    const Mapping<dim>       &mapping,
                                    const Quadrature<dim>    &quadrature,
                                    const Material<dim>      &material,
                                    const bool                mixed)
    : material(material)
    , mixed(mixed)
    , fe_values(mapping,
                element,
                quadrature,
                update_values | update_gradients | update_JxW_values)
    , points(quadrature.size())
  {
    for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
    {
      components.push_back(element.system_to_component_index(i).first);
      (components.back() < dim ? displacement_dofs : pressure_dofs)
        .push_back(i);
    }
    unit_stresses.resize(displacement_dofs.size());
  }



  template <int dim>
  void
  ElasticKernel<dim>::reinit(
    const typename Triangulation<dim>::cell_iterator &cell)
  {
    fe_values.reinit(cell);
  }



  template <int dim>
  SymmetricTensor<2, dim>
  ElasticKernel<dim>::strain_of(const unsigned int dof,
                                const unsigned int q) const
  {
    const Tensor<1, dim>   &gradient  = fe_values.shape_grad(dof, q);
    const unsigned int      component = components[dof];
    SymmetricTensor<2, dim> strain;
    for (unsigned int d = 0; d < dim; ++d)
      strain[component][d] = (d == component ? 1. : 0.5) * gradient[d];
    return strain;
  }



  template <int dim>
  void
  ElasticKernel<dim>::set_state(const Vector<double>      &local,
                                const std::vector<double> &lagged_phase_field)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      PointState    &point = points[q];
      Tensor<2, dim> gradient;
      for (const unsigned int i : displacement_dofs)
        gradient[components[i]] += local(i) * fe_values.shape_grad(i, q);
      point.strain = symmetrize(gradient);
      // interpolating phi = 1 leaves rounding; the intact material must not
      // see it, since an unchanged matrix is not built or factorised again
      const double phi = lagged_phase_field[q];
      point.degradation =
        phi > 1. - 1e-13 ? 1. : material.degradation().value(phi);
      if (mixed)
      {
        point.pressure = 0.;
        for (const unsigned int i : pressure_dofs)
          point.pressure += local(i) * fe_values.shape_value(i, q);
        point.response =
          material.mixed(point.strain, point.pressure, point.degradation);
      }
      else
      {
        point.pressure = material.pressure(point.strain, point.degradation);
        point.response = material.eliminated(point.strain, point.degradation);
      }
      point.branch = point.degradation == 1.
                       ? 0
                       : material.branch(point.strain, point.pressure);
    }
  }



  template <int dim>
  void
  ElasticKernel<dim>::residual(Vector<double> &result) const
  {
    result = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      const double         weight = fe_values.JxW(q);
      const Tensor<2, dim> stress = weight * points[q].response.stress;
      for (const unsigned int i : displacement_dofs)
        result(i) += stress[components[i]] * fe_values.shape_grad(i, q);
      for (const unsigned int i : pressure_dofs)
        result(i) +=
          points[q].response.constraint * fe_values.shape_value(i, q) * weight;
    }
  }



  template <int dim>
  void
  ElasticKernel<dim>::displacement_block(const unsigned int  q,
                                         FullMatrix<double> &result) const
  {
    const double weight = fe_values.JxW(q);
    for (unsigned int a = 0; a < displacement_dofs.size(); ++a)
      unit_stresses[a] = points[q].response.stress_by_strain *
                         (weight * strain_of(displacement_dofs[a], q));
    // the tangent derives from an energy, hence is symmetric
    for (unsigned int b = 0; b < displacement_dofs.size(); ++b)
    {
      const unsigned int   j = displacement_dofs[b];
      const Tensor<2, dim> stress(unit_stresses[b]);
      for (unsigned int a = 0; a <= b; ++a)
      {
        const unsigned int i = displacement_dofs[a];
        result(i, j) += stress[components[i]] * fe_values.shape_grad(i, q);
      }
    }
  }



  template <int dim>
  void
  ElasticKernel<dim>::pressure_blocks(const unsigned int  q,
                                      FullMatrix<double> &result) const
  {
    const double                weight   = fe_values.JxW(q);
    const ElasticResponse<dim> &response = points[q].response;
    for (const unsigned int k : pressure_dofs)
    {
      const double shape = weight * fe_values.shape_value(k, q);
      for (const unsigned int i : displacement_dofs)
      {
        const double divergence =
          fe_values.shape_grad(i, q)[components[i]] * shape;
        result(i, k) += response.stress_by_pressure * divergence;
        result(k, i) += response.constraint_by_trace * divergence;
      }
      for (const unsigned int l : pressure_dofs)
        result(k, l) +=
          response.constraint_by_pressure * shape * fe_values.shape_value(l, q);
    }
  }



  template <int dim>
  void
  ElasticKernel<dim>::jacobian(FullMatrix<double> &result) const
  {
    result = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      displacement_block(q, result);
      if (mixed)
        pressure_blocks(q, result);
    }
    for (unsigned int b = 0; b < displacement_dofs.size(); ++b)
      for (unsigned int a = 0; a < b; ++a)
        result(displacement_dofs[b], displacement_dofs[a]) =
          result(displacement_dofs[a], displacement_dofs[b]);
  }



  template <int dim>
  double
  ElasticKernel<dim>::energy() const
  {
    double sum = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
      sum += fe_values.JxW(q) * material.elastic_energy(points[q].strain,
                                                        points[q].pressure,
                                                        points[q].degradation);
    return sum;
  }



  template <int dim>
  std::pair<double, double>
  ElasticKernel<dim>::squared_scale() const
  {
    std::pair<double, double> result{0., 0.};
    double                    stress = 0., strain = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      stress += points[q].response.stress.norm() * fe_values.JxW(q);
      strain += points[q].strain.norm() * fe_values.JxW(q);
    }
    // a stress times the gradient of a shape function, of the order of 1/h
    double volume = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
      volume += fe_values.JxW(q);
    const double h = std::pow(volume, 1. / dim);
    result.first   = (stress / h) * (stress / h);
    result.second  = strain * strain;
    return result;
  }



  template <int dim>
  double
  ElasticKernel<dim>::driving_force(const unsigned int q) const
  {
    return material.driving_force(
      points[q].strain, points[q].pressure, points[q].degradation);
  }



  template <int dim>
  typename ElasticKernel<dim>::CellAverages
  ElasticKernel<dim>::averages() const
  {
    CellAverages result{{}, 0.};
    double       volume = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      result.stress += fe_values.JxW(q) * points[q].response.stress;
      volume += fe_values.JxW(q);
    }
    result.stress /= volume;
    result.energy_density = energy() / volume;
    return result;
  }



  template class ElasticKernel<2>;
  template class ElasticKernel<3>;
} // namespace MixedCracks
