// SPDX-License-Identifier: GPL-2.0-or-later
// The matrices that stand for parts of the elastic one in the
// preconditioner of BlockAmgSolver.
//
// 1. Displacements: u in Q2 contains the (multi)linear u of the same cells.
// With P the interpolation from the vertices to all nodes, the Galerkin
// restriction
//
//   P^T A P = sum over cells, points of w_q eps(L_a e_d) : C : eps(L_b e_e),
//
// L_a the bilinear (trilinear) shape functions, is assembled as the stiffness
// of linear displacements with the same tangents C and quadrature: the same
// matrix but for rounding, without a triple product. A quarter of the unknowns
// in 2-d, an eighth in 3-d.
//
//             Q2            Q1 of the same cell
//          o---o---o          o-------o
//          |       |          |       |
//          o   o   o    P     |       |        P: mean of the two, four or
//          |       |   <---   |       |        eight vertices around a node
//          o---o---o          o-------o
//
// 2. Pressure: the Schur complement of A in ( A B^T ; B' -M ) is, but for the
// sign,
//
//   S = M + B' A^-1 B^T.
//
// In the inside of the body the response to p is the gradient of a potential:
// with m the stiffness of C against such displacements, A grad(w) is about the
// force of the pressure m Laplace(w), so that A u = B^T p has div u = p/m, and
// B' A^-1 B^T acts as the mass matrix over m:
//
//   S ~ sum_q w_q ( |compliance| + |stress * divergence| / m ) M_k M_l,
//   m = longitudinal_stiffness(C).
//
// Finite strain: C = dP/d(grad u) has no minor symmetries and acts on grad(L_b
// e_e), and with K = dP/dp the coupling is K : grad w. Waves of direction n (in
// the reference configuration) see the acoustic tensor Q_de = C_dJeK n_J n_K
// and the coupling K n, hence
//
//   stress * divergence / m   becomes   mean over n of  K n . Q(n)^-1 K n,
//
// at F = I the same, K = I and Q(n) n = m n.

#include <assembly/acoustic_tensor.h>
#include <assembly/auxiliary_matrices.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  // The mean over all directions n of (n (x) n) : C : (n (x) n). With the mean
  // of n_i n_j n_k n_l = (d_ij d_kl + d_ik d_jl + d_il d_jk)/(dim (dim + 2)), d
  // the Kronecker symbol, and the symmetry C_ijkl = C_jikl it is
  //
  //   sum_ij ( C_iijj + 2 C_ijij ) / (dim (dim + 2)),
  //
  // 2 mu for C = 2 mu 1, and lambda + 2 mu for C = lambda I (x) I + 2 mu 1.
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



  namespace
  {
    // What the displacements add to the compliance of the pressure; 1/MPa.
    // Where the tangent is not elliptic, its size has to do.
    template <int dim>
    double
    compliance_of_displacements(const ElasticResponse<dim> &response)
    {
      double sum = 0.;
      for (const Tensor<1, dim> &n : axes_and_diagonals<dim>())
      {
        const Tensor<2, dim> Q =
          acoustic_tensor(response.finite->stress_by_gradient, n);
        const Tensor<1, dim> force = response.finite->coupling * n;
        const double         compliance =
          determinant(Q) != 0. ? force * (invert(Q) * force) : 0.;
        sum += compliance > 0. ? compliance : force * force / Q.norm();
      }
      return sum / axes_and_diagonals<dim>().size();
    }



    // C : eps(shape e_e), @p gradient that of the shape
    template <int dim>
    Tensor<2, dim>
    stress_of_shape(const SymmetricTensor<4, dim> &tangent,
                    const Tensor<1, dim>          &gradient,
                    const unsigned int             e)
    {
      SymmetricTensor<2, dim> strain;
      for (unsigned int d = 0; d < dim; ++d)
        strain[e][d] = (d == e ? 1. : 0.5) * gradient[d];
      return Tensor<2, dim>(tangent * strain);
    }



    // C : grad(shape e_e)
    template <int dim>
    Tensor<2, dim>
    stress_of_shape(const Tensor<4, dim> &tangent,
                    const Tensor<1, dim> &gradient,
                    const unsigned int    e)
    {
      Tensor<2, dim> stress;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int j = 0; j < dim; ++j)
          stress[d][j] = tangent[d][j][e] * gradient;
      return stress;
    }



    // The stiffness of linear displacements at point q with a tangent that the
    // weight of the point is part of; rows are numbered component by component
    // for each vertex. Of the symmetric matrix the blocks a <= b.
    template <int dim, typename Tangent>
    void
    add_stiffness(const Tangent           &tangent,
                  const ScalarShapes<dim> &shapes,
                  const unsigned int       q,
                  FullMatrix<double>      &local)
    {
      for (unsigned int b = 0; b < shapes.size(); ++b)
        for (unsigned int e = 0; e < dim; ++e)
        {
          const Tensor<2, dim> stress =
            stress_of_shape(tangent, shapes.gradient(b, q), e);
          for (unsigned int a = 0; a <= b; ++a)
          {
            const Tensor<1, dim> force = stress * shapes.gradient(a, q);
            for (unsigned int d = 0; d < dim; ++d)
              local(dim * a + d, dim * b + e) += force[d];
          }
        }
    }
  } // namespace



  template <int dim>
  AssembledAuxiliaries<dim>::AssembledAuxiliaries(
    const Fields<dim>      &fields,
    const Constraints<dim> &constraints)
    : fields(fields)
    , constraints(constraints)
    , shapes(FE_Q<dim>(1), fields.quadrature)
    , linear_stiffness(FE_Q<dim>(1), fields.quadrature)
    , weights(fields.quadrature.size())
    , fluid_like_cells(fields, constraints)
  {
    for (unsigned int q = 0; q < weights.size(); ++q)
      for (unsigned int a = 0; a < shapes.size(); ++a)
        for (unsigned int b = 0; b < shapes.size(); ++b)
          mass_of_points.push_back(shapes.value(a, q) * shapes.value(b, q));
  }



  template <int dim>
  void
  AssembledAuxiliaries<dim>::reinit()
  {
    const auto make_zero = [&](const DofSets                   &dofs,
                               const std::vector<Indices>      &cells,
                               const AffineConstraints<double> &among,
                               LinearAlgebra::SparseMatrix     &matrix,
                               CellSums                        &sums) {
      LinearAlgebra::SparsityPattern pattern(
        dofs.owned, dofs.owned, dofs.relevant, fields.communicator());
      for (const Indices &indices : cells)
        among.add_entries_local_to_global(indices, pattern, false);
      pattern.compress();
      matrix.reinit(pattern);
      sums.reinit(matrix, cells, among);
    };
    if (has_displacement())
    {
      linear_displacements.reinit(fields, constraints);
      make_zero(linear_displacements.dofs(),
                vertex_dofs(),
                linear_displacements.constraints(),
                displacement_matrix,
                displacement_sums);
    }
    if (fields.layout.mixed)
      make_zero(fields.elastic_dofs,
                pressure_dofs(),
                constraints.elastic_corrections(),
                pressure_matrix,
                pressure_sums);
  }



  template <int dim>
  std::vector<CellSums::Indices>
  AssembledAuxiliaries<dim>::vertex_dofs() const
  {
    std::vector<Indices> result;
    for (const auto &cell : fields.elastic.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        result.emplace_back();
        linear_displacements.get_dofs(cell, result.back());
      }
    return result;
  }



  template <int dim>
  std::vector<CellSums::Indices>
  AssembledAuxiliaries<dim>::pressure_dofs() const
  {
    const FiniteElement<dim> &element = fields.elastic.get_fe();
    std::vector<Indices>      result;
    Indices                   all(element.n_dofs_per_cell());
    for (const auto &cell : fields.elastic.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(all);
        result.emplace_back();
        for (unsigned int c = 0; c < shapes.size(); ++c)
          result.back().push_back(
            all[element.component_to_system_index(dim, c)]);
      }
    return result;
  }



  template <int dim>
  void
  AssembledAuxiliaries<dim>::assemble(Assembler<dim>               &assembler,
                                      const MatrixFreeElastic<dim> *products)
  {
    if (has_displacement())
      displacement_sums.set_zero();
    if (fields.layout.mixed)
      pressure_sums.set_zero();
    if (!has_displacement() && !fields.layout.mixed)
      return;
    is_finite = assembler.is_finite();
    std::vector<bool> fluid_like(assembler.n_cells());
    for (unsigned int cell = 0; cell < assembler.n_cells(); ++cell)
    {
      const CellGeometry<dim> &geometry = assembler.geometry(cell);
      if (products != nullptr && products->read_tangents(cell, isotropic))
        fluid_like[cell] = add_isotropic(cell, geometry);
      else
      {
        const auto &responses = assembler.tangents(cell);
        fluid_like[cell]      = isotropic.read(responses)
                                  ? add_isotropic(cell, geometry)
                                  : add_general(cell, geometry, responses);
      }
    }
    if (has_displacement())
      displacement_sums.finish();
    if (!fields.layout.mixed)
      return;
    pressure_sums.finish();
    fluid_like_cells.assemble(fluid_like, assembler, products);
  }



  template <int dim>
  bool
  AssembledAuxiliaries<dim>::add_isotropic(const unsigned int       cell,
                                           const CellGeometry<dim> &geometry)
  {
    if (has_displacement())
    {
      const unsigned int n = linear_stiffness.n_shapes();
      FullMatrix<double> local(dim * n, dim * n);
      linear_stiffness.assemble(geometry, isotropic);
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int b = 0; b < n; ++b)
            for (unsigned int e = 0; e < dim; ++e)
              local(dim * a + d, dim * b + e) =
                linear_stiffness.entry(a, d, b, e);
      displacement_sums.add(cell, local);
    }
    bool is_fluid = false;
    for (unsigned int q = 0; q < isotropic.identity.size(); ++q)
    {
      const double longitudinal = isotropic.identity[q] + isotropic.volume[q];
      weights[q] =
        geometry.weights[q] * (std::abs(isotropic.constraint_by_pressure[q]) +
                               std::abs(isotropic.stress_by_pressure[q] *
                                        isotropic.constraint_by_trace[q]) /
                                 longitudinal);
      is_fluid =
        is_fluid || is_fluid_like(isotropic.identity[q], isotropic.volume[q]);
    }
    if (fields.layout.mixed)
      add_pressures(cell);
    return is_fluid;
  }



  template <int dim>
  bool
  AssembledAuxiliaries<dim>::add_general(
    const unsigned int                       cell,
    const CellGeometry<dim>                 &geometry,
    const std::vector<ElasticResponse<dim>> &responses)
  {
    if (has_displacement())
    {
      FullMatrix<double> local(dim * shapes.size(), dim * shapes.size());
      shapes.reinit(geometry);
      for (unsigned int q = 0; q < responses.size(); ++q)
        if (is_finite)
          add_stiffness(Tensor<4, dim>(geometry.weights[q] *
                                       responses[q].finite->stress_by_gradient),
                        shapes,
                        q,
                        local);
        else
          add_stiffness(SymmetricTensor<4, dim>(geometry.weights[q] *
                                                responses[q].stress_by_strain),
                        shapes,
                        q,
                        local);
      for (unsigned int i = 0; i < local.m(); ++i)
        for (unsigned int j = dim * (i / dim + 1); j < local.n(); ++j)
          local(j, i) = local(i, j);
      displacement_sums.add(cell, local);
    }
    if (!fields.layout.mixed)
      return false;
    for (unsigned int q = 0; q < responses.size(); ++q)
    {
      const ElasticResponse<dim> &response = responses[q];
      weights[q] =
        geometry.weights[q] *
        (std::abs(response.constraint_by_pressure) +
         (is_finite ? compliance_of_displacements(response)
                    : std::abs(response.stress_by_pressure *
                               response.constraint_by_trace) /
                        longitudinal_stiffness(response.stress_by_strain)));
    }
    add_pressures(cell);
    return std::any_of(responses.begin(), responses.end(), is_fluid_like<dim>);
  }



  template <int dim>
  void
  AssembledAuxiliaries<dim>::add_pressures(const unsigned int cell)
  {
    constexpr unsigned int n = GeometryInfo<dim>::vertices_per_cell;
    FullMatrix<double>     local(n, n);
    const double          *of_point = mass_of_points.data();
    for (const double weight : weights)
      for (unsigned int k = 0; k < n * n; ++k)
        (&local(0, 0))[k] += weight * *of_point++;
    pressure_sums.add(cell, local);
  }



  template class AssembledAuxiliaries<2>;
  template class AssembledAuxiliaries<3>;
  template double longitudinal_stiffness(const SymmetricTensor<4, 2> &);
  template double longitudinal_stiffness(const SymmetricTensor<4, 3> &);
} // namespace MixedCracks
