// SPDX-License-Identifier: GPL-2.0-or-later
// The elastic kernel on a single cell.
#ifndef mixed_cracks_tests_unit_one_cell_h
#define mixed_cracks_tests_unit_one_cell_h

#include "single_cell.h"

#include <assembly/elastic_kernel.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>

namespace MixedCracks
{
  namespace Testing
  {
    /// One kernel on one cell, and local values near a state of constant
    /// displacement gradient and pressure.
    template <int dim>
    class OneCell
    {
    public:
      OneCell(const bool mixed, const Material<dim> &material)
        : mixed(mixed)
        , mapping(1)
        , quadrature(mixed ? 3 : 2)
        , element(make_element(mixed))
        , kernel(element, quadrature, material, mixed)
      {
        make_crooked_cell(triangulation);
        geometry =
          GeometryEvaluator<dim>(mapping, quadrature)(triangulation.begin());
        kernel.reinit(geometry);
        for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
          block.push_back(component(i) < dim ? 0 : 1);
        // damaged, and different at every point
        const LocalVector random = random_values(quadrature.size(), 3);
        for (const double value : random)
          lagged_phase_field.push_back(0.5 + 0.45 * value);
      }

      // disturbed, so that no two points see the same state
      LocalVector
      values_near(const dealii::Tensor<2, dim> &gradient,
                  const double                  pressure) const
      {
        LocalVector values = random_values(element.n_dofs_per_cell());
        const auto  cell   = triangulation.begin();
        for (unsigned int i = 0; i < values.size(); ++i)
          if (block[i] == 0)
          {
            const auto position = mapping.transform_unit_to_real_cell(
              cell,
              element.base_element(0).get_unit_support_points()
                [element.system_to_component_index(i).second]);
            values(i) = 1e-6 * values(i) + (gradient * position)[component(i)];
          }
          else
            values(i) = pressure * (1. + 0.1 * values(i));
        return values;
      }

      LocalVector
      steps(const double displacement, const double pressure) const
      {
        LocalVector result(block.size());
        for (unsigned int i = 0; i < block.size(); ++i)
          result(i) = block[i] == 0 ? displacement : pressure;
        return result;
      }

      LocalVector
      residual(const LocalVector &local)
      {
        LocalVector result(local.size());
        kernel.set_state(
          local, lagged_phase_field, ElasticEvaluation::stresses);
        kernel.residual(result);
        return result;
      }

      double
      energy(const LocalVector &local)
      {
        kernel.set_state(local, lagged_phase_field, ElasticEvaluation::points);
        return kernel.energy();
      }

      /// The Jacobian against differences of the residual by these steps, and
      /// whether it is symmetric where it says so.
      void
      compare_jacobian(const LocalVector &local, const LocalVector &steps)
      {
        const auto expected = difference_matrix(
          [&](const LocalVector &values) { return residual(values); },
          local,
          steps);
        dealii::FullMatrix<double> found(local.size(), local.size());
        kernel.set_state(local, lagged_phase_field);
        kernel.jacobian(found);
        expect_equal_by_blocks(found, expected, block, 1e-6);
        if (!kernel.jacobian_is_symmetric())
          return;
        dealii::FullMatrix<double> transposed(local.size(), local.size());
        transposed.copy_transposed(found);
        expect_equal_by_blocks(found, transposed, block, 1e-13);
      }

      unsigned int
      component(const unsigned int dof) const
      {
        return element.system_to_component_index(dof).first;
      }

      const bool                  mixed;
      dealii::Triangulation<dim>  triangulation;
      const dealii::MappingQ<dim> mapping;
      const dealii::QGauss<dim>   quadrature;
      const dealii::FESystem<dim> element;
      CellGeometry<dim>           geometry;
      ElasticKernel<dim>          kernel;
      std::vector<double>         lagged_phase_field;
      std::vector<unsigned int>   block; // 0 displacement, 1 pressure

    private:
      static dealii::FESystem<dim>
      make_element(const bool mixed)
      {
        const dealii::FE_Q<dim> linear(1), quadratic(2);
        if (mixed)
          return dealii::FESystem<dim>(quadratic, dim, linear, 1);
        return dealii::FESystem<dim>(linear, dim);
      }
    };
  } // namespace Testing
} // namespace MixedCracks

#endif
