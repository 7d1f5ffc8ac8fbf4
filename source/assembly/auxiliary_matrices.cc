// SPDX-License-Identifier: GPL-2.0-or-later
#include <assembly/auxiliary_matrices.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_tools.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // of the corner number c of a cell: its position along axis d, 0 or 1
    unsigned int
    bit(const unsigned int c, const unsigned int d)
    {
      return (c >> d) & 1;
    }



    // how much of a quadrature point belongs to the half 0 or 1 of [0, 1]
    double
    share(const double x, const unsigned int half)
    {
      if (std::abs(x - 0.5) < 1e-10)
        return 0.5;
      return (x > 0.5) == (half == 1) ? 1. : 0.;
    }
  } // namespace



  template <int dim>
  double
  longitudinal_stiffness(const SymmetricTensor<4, dim> &tangent)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        sum += tangent[i][i][j][j] + 2. * tangent[i][j][i][j];
    return sum / (dim * (dim + 2));
  }



  template <int dim>
  AssembledAuxiliaries<dim>::AssembledAuxiliaries(
    const Fields<dim> &fields,
    const Constraints &constraints)
    : fields(fields)
    , constraints(constraints)
  {}



  template <int dim>
  void
  AssembledAuxiliaries<dim>::reinit()
  {
    number_local_dofs();
    tabulate_shapes();
    read_cells();
    make_patterns();
  }



  template <int dim>
  void
  AssembledAuxiliaries<dim>::number_local_dofs()
  {
    const FiniteElement<dim> &element = fields.elastic.get_fe();
    pressure_dofs.clear();
    if (fields.layout.mixed)
      for (unsigned int c = 0; c < n_corners; ++c)
        pressure_dofs.push_back(element.component_to_system_index(dim, c));
    part_dofs.assign(has_displacement() ? n_corners : 0, {});
    if (!has_displacement())
      return;
    const std::vector<unsigned int> lexicographic =
      FETools::lexicographic_to_hierarchic_numbering<dim>(2);
    for (unsigned int part = 0; part < n_corners; ++part)
      for (unsigned int c = 0; c < n_corners; ++c)
      {
        // nodes 0, 1, 2 along each axis
        unsigned int node = 0;
        for (int d = dim - 1; d >= 0; --d)
          node = 3 * node + bit(part, d) + bit(c, d);
        for (unsigned int e = 0; e < dim; ++e)
          part_dofs[part].push_back(
            element.component_to_system_index(e, lexicographic[node]));
      }
  }



  template <int dim>
  void
  AssembledAuxiliaries<dim>::tabulate_shapes()
  {
    const QGauss<dim> part_quadrature(2);
    part_gradients.assign(part_quadrature.size(), {});
    for (unsigned int q = 0; q < part_quadrature.size(); ++q)
      for (unsigned int c = 0; c < n_corners; ++c)
        part_gradients[q].push_back(
          GeometryInfo<dim>::d_linear_shape_function_gradient(
            part_quadrature.point(q), c));
    const Quadrature<dim> &quadrature = fields.quadrature;
    pressure_values.assign(quadrature.size(), {});
    shares.assign(n_corners, std::vector<double>(quadrature.size(), 1.));
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      for (unsigned int c = 0; c < n_corners; ++c)
      {
        pressure_values[q].push_back(
          GeometryInfo<dim>::d_linear_shape_function(quadrature.point(q), c));
        for (unsigned int d = 0; d < dim; ++d)
          shares[c][q] *= share(quadrature.point(q)[d], bit(c, d));
      }
  }



  template <int dim>
  void
  AssembledAuxiliaries<dim>::read_cells()
  {
    corners.clear();
    cell_dofs.clear();
    Indices dofs(fields.elastic.get_fe().n_dofs_per_cell());
    for (const auto &cell : fields.elastic.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        corners.emplace_back();
        for (unsigned int c = 0; c < n_corners; ++c)
          corners.back()[c] = cell->vertex(c);
        cell->get_dof_indices(dofs);
        cell_dofs.push_back(dofs);
      }
  }



  namespace
  {
    void
    choose(const std::vector<types::global_dof_index> &all,
           const std::vector<unsigned int>            &which,
           std::vector<types::global_dof_index>       &chosen)
    {
      chosen.clear();
      for (const unsigned int i : which)
        chosen.push_back(all[i]);
    }
  } // namespace



  template <int dim>
  void
  AssembledAuxiliaries<dim>::make_patterns()
  {
    const DofSets &dofs = fields.elastic_dofs;
    Indices        indices;
    if (has_displacement())
    {
      LinearAlgebra::SparsityPattern pattern(
        dofs.owned, dofs.owned, dofs.relevant, fields.communicator());
      for (const Indices &all : cell_dofs)
        for (const auto &part : part_dofs)
        {
          choose(all, part, indices);
          constraints.add_entries_local_to_global(indices, pattern, false);
        }
      pattern.compress();
      displacement_matrix.reinit(pattern);
    }
    if (fields.layout.mixed)
    {
      LinearAlgebra::SparsityPattern pattern(
        dofs.owned, dofs.owned, dofs.relevant, fields.communicator());
      for (const Indices &all : cell_dofs)
      {
        choose(all, pressure_dofs, indices);
        constraints.add_entries_local_to_global(indices, pattern, false);
      }
      pattern.compress();
      pressure_matrix.reinit(pattern);
    }
  }



  template <int dim>
  void
  AssembledAuxiliaries<dim>::assemble(Assembler<dim> &assembler)
  {
    if (has_displacement())
      displacement_matrix = 0.;
    if (fields.layout.mixed)
      pressure_matrix = 0.;
    if (!has_displacement() && !fields.layout.mixed)
      return;
    assembler.visit_tangents(
      [&](const unsigned int                       cell,
          const CellGeometry<dim>                 &geometry,
          const std::vector<ElasticResponse<dim>> &responses) {
        if (has_displacement())
          add_displacements(cell, geometry, responses);
        if (fields.layout.mixed)
          add_pressures(cell, geometry, responses);
      });
    if (has_displacement())
      displacement_matrix.compress(VectorOperation::add);
    if (fields.layout.mixed)
      pressure_matrix.compress(VectorOperation::add);
  }



  template <int dim>
  SymmetricTensor<4, dim>
  AssembledAuxiliaries<dim>::average(
    const unsigned int                       part,
    const CellGeometry<dim>                 &geometry,
    const std::vector<ElasticResponse<dim>> &responses) const
  {
    SymmetricTensor<4, dim> sum;
    double                  weights = 0.;
    for (unsigned int q = 0; q < responses.size(); ++q)
    {
      const double weight = shares[part][q] * geometry.weights[q];
      if (weight == 0.)
        continue;
      sum += weight * responses[q].stress_by_strain;
      weights += weight;
    }
    return sum / weights;
  }



  namespace
  {
    // corners of one part, halfway between those of the cell
    template <int dim, std::size_t n>
    std::array<Point<dim>, n>
    corners_of_part(const std::array<Point<dim>, n> &cell,
                    const unsigned int               part)
    {
      std::array<Point<dim>, n> result;
      for (unsigned int c = 0; c < n; ++c)
      {
        Point<dim> reference;
        for (unsigned int d = 0; d < dim; ++d)
          reference[d] = 0.5 * (bit(part, d) + bit(c, d));
        for (unsigned int v = 0; v < n; ++v)
          result[c] +=
            GeometryInfo<dim>::d_linear_shape_function(reference, v) * cell[v];
      }
      return result;
    }



    // Stiffness of one part at one quadrature point, added to @p matrix. The
    // rows are numbered component by component for each corner.
    template <int dim>
    void
    add_stiffness(const std::vector<Tensor<1, dim>> &gradients,
                  const SymmetricTensor<4, dim>     &weighted_tangent,
                  FullMatrix<double>                &matrix)
    {
      for (unsigned int b = 0; b < gradients.size(); ++b)
        for (unsigned int e = 0; e < dim; ++e)
        {
          SymmetricTensor<2, dim> strain;
          for (unsigned int d = 0; d < dim; ++d)
            strain[e][d] = (d == e ? 1. : 0.5) * gradients[b][d];
          const Tensor<2, dim> stress(weighted_tangent * strain);
          for (unsigned int a = 0; a < gradients.size(); ++a)
          {
            const Tensor<1, dim> force = stress * gradients[a];
            for (unsigned int d = 0; d < dim; ++d)
              matrix(dim * a + d, dim * b + e) += force[d];
          }
        }
    }
  } // namespace



  template <int dim>
  void
  AssembledAuxiliaries<dim>::add_displacements(
    const unsigned int                       cell,
    const CellGeometry<dim>                 &geometry,
    const std::vector<ElasticResponse<dim>> &responses)
  {
    FullMatrix<double>          local(dim * n_corners, dim * n_corners);
    std::vector<Tensor<1, dim>> gradients(n_corners);
    Indices                     indices;
    const double                reference_weight = 1. / part_gradients.size();
    for (unsigned int part = 0; part < n_corners; ++part)
    {
      const SymmetricTensor<4, dim> tangent =
        average(part, geometry, responses);
      const auto points = corners_of_part<dim>(corners[cell], part);
      local             = 0.;
      for (const auto &reference : part_gradients)
      {
        Tensor<2, dim> jacobian;
        for (unsigned int c = 0; c < n_corners; ++c)
          jacobian += outer_product(points[c], reference[c]);
        const Tensor<2, dim> to_real = transpose(invert(jacobian));
        for (unsigned int c = 0; c < n_corners; ++c)
          gradients[c] = to_real * reference[c];
        add_stiffness(
          gradients, reference_weight * determinant(jacobian) * tangent, local);
      }
      choose(cell_dofs[cell], part_dofs[part], indices);
      constraints.distribute_local_to_global(
        local, indices, displacement_matrix);
    }
  }



  template <int dim>
  void
  AssembledAuxiliaries<dim>::add_pressures(
    const unsigned int                       cell,
    const CellGeometry<dim>                 &geometry,
    const std::vector<ElasticResponse<dim>> &responses)
  {
    FullMatrix<double> local(n_corners, n_corners);
    for (unsigned int q = 0; q < responses.size(); ++q)
    {
      const ElasticResponse<dim> &response = responses[q];
      const double                weight =
        geometry.weights[q] *
        (std::abs(response.constraint_by_pressure) +
         std::abs(response.stress_by_pressure * response.constraint_by_trace) /
           longitudinal_stiffness(response.stress_by_strain));
      for (unsigned int a = 0; a < n_corners; ++a)
        for (unsigned int b = 0; b < n_corners; ++b)
          local(a, b) += weight * pressure_values[q][a] * pressure_values[q][b];
    }
    Indices indices;
    choose(cell_dofs[cell], pressure_dofs, indices);
    constraints.distribute_local_to_global(local, indices, pressure_matrix);
  }



  template class AssembledAuxiliaries<2>;
  template class AssembledAuxiliaries<3>;
  template double longitudinal_stiffness(const SymmetricTensor<4, 2> &);
  template double longitudinal_stiffness(const SymmetricTensor<4, 3> &);
} // namespace MixedCracks
