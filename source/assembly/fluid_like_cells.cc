// SPDX-License-Identifier: GPL-2.0-or-later
// Amor's split degrades 2 mu dev : dev. Of the volumetric part, which it leaves
// where a cell is compressed, lambda tr tr is the pressure's in the mixed
// formulation, and
//
//   A = 2 g mu dev eps : dev eps' + (2 mu/dim) tr eps tr eps',   g -> kappa,
//
// is what the displacements keep: mu for what changes the volume, kappa mu for
// what does not. Neither linear displacements, which can hardly move without
// changing it, nor polynomials in A scaled by its diagonal reduce the latter:
// in slit_cube_adaptive.prm what the two leave has eigenvalues of A~^-1 A down
// to 2e-4. Cells that are opened lose both parts, and nothing is wrong there.
//
// So the displacements of all such cells are solved for together, with the
// block A_cc of all contributions to their rows, those of neighbours too:
//
//   u_c <- u_c + A_cc^-1 ( f - B^T p - A u )_c.
//
// Patches of a cell, or of 64, do not do: the flow in a compressed crack is
// along it, and iterations grow with its length over theirs, and with 1/kappa
// (doc/records/solvers.md).

#include <assembly/acoustic_tensor.h>
#include <assembly/fluid_like_cells.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    constexpr double least_share = 0.02;



    template <int dim>
    bool
    is_fluid_like(const Tensor<4, dim> &tangent)
    {
      double least = std::numeric_limits<double>::max(), largest = 0.;
      for (const Tensor<1, dim> &n : axes_and_diagonals<dim>())
      {
        const auto values =
          eigenvalues(symmetrize(acoustic_tensor(tangent, n)));
        largest = std::max(largest, values.front());
        least   = std::min(least, values.back());
      }
      return least < least_share * largest;
    }
  } // namespace



  // The eigenvalues are a/2 and a + b.
  bool
  is_fluid_like(const double identity, const double volume)
  {
    return least_share * (identity + volume) > 0.5 * identity;
  }



  template <int dim>
  bool
  is_fluid_like(const ElasticResponse<dim> &response)
  {
    if (response.finite)
      return is_fluid_like(response.finite->stress_by_gradient);
    if (const auto isotropic = isotropic_tangent(response.stress_by_strain))
      return is_fluid_like(isotropic->identity, isotropic->volume);
    return is_fluid_like(Tensor<4, dim>(response.stress_by_strain));
  }



  template <int dim>
  FluidLikeCells<dim>::FluidLikeCells(const Fields<dim>      &fields,
                                      const Constraints<dim> &constraints)
    : fields(fields)
    , constraints(constraints)
    , stiffness(FE_Q<dim>(fields.layout.displacement_degree), fields.quadrature)
  {}



  template <int dim>
  void
  FluidLikeCells<dim>::read_terms(const std::vector<Index> &indices)
  {
    const FiniteElement<dim>        &element = fields.elastic.get_fe();
    const AffineConstraints<double> &all = constraints.elastic_corrections();
    terms.resize(indices.size());
    for (unsigned int i = 0; i < indices.size(); ++i)
      if (element.system_to_component_index(i).first >= dim)
        terms[i].clear();
      else if (const auto *entries = all.get_constraint_entries(indices[i]))
        terms[i].assign(entries->begin(), entries->end());
      else
        terms[i].assign(1, {indices[i], 1.});
  }



  // Those of each rank follow each other, in the order of the unknowns.
  template <int dim>
  void
  FluidLikeCells<dim>::number_rows(const std::vector<bool> &chosen)
  {
    const MPI_Comm  communicator = fields.communicator();
    const IndexSet &owned        = fields.elastic_dofs.owned;
    row_numbers.reinit(owned, fields.elastic_dofs.relevant, communicator);
    std::vector<Index> indices(fields.elastic.get_fe().n_dofs_per_cell());
    unsigned int       cell_number = 0;
    for (const auto &cell : fields.elastic.active_cell_iterators())
      if (cell->is_locally_owned() && chosen[cell_number++])
      {
        cell->get_dof_indices(indices);
        read_terms(indices);
        for (const Terms &of_dof : terms)
          for (const auto &term : of_dof)
            row_numbers(term.first) = 1.;
      }
    row_numbers.compress(VectorOperation::add);
    positions.clear();
    for (unsigned int i = 0; i < row_numbers.locally_owned_size(); ++i)
      if (row_numbers.local_element(i) > 0.)
        positions.push_back(i);
    const Index  n_here = positions.size();
    Index        first = 0, n_rows = 0;
    unsigned int rank = 0;
    for (const Index n : Utilities::MPI::all_gather(communicator, n_here))
    {
      if (rank++ < Utilities::MPI::this_mpi_process(communicator))
        first += n;
      n_rows += n;
    }
    for (unsigned int k = 0; k < positions.size(); ++k)
      row_numbers.local_element(positions[k]) = first + k + 1.;
    row_numbers.update_ghost_values();
    owned_rows = IndexSet(n_rows);
    owned_rows.add_range(first, first + n_here);
    block_exists = n_rows > 0 && n_rows <= most_unknowns;
  }



  template <int dim>
  void
  FluidLikeCells<dim>::visit_cells(
    const std::function<void(unsigned int)> &body)
  {
    std::vector<Index> indices(fields.elastic.get_fe().n_dofs_per_cell());
    unsigned int       number = 0;
    for (const auto &cell : fields.elastic.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(indices);
        read_terms(indices);
        // rows in place of unknowns, and what has none left out
        bool any = false;
        for (Terms &of_dof : terms)
        {
          for (auto &term : of_dof)
            term.first = row_of(term.first);
          of_dof.erase(std::remove_if(of_dof.begin(),
                                      of_dof.end(),
                                      [](const auto &term) {
                                        return term.first ==
                                               numbers::invalid_dof_index;
                                      }),
                       of_dof.end());
          any = any || !of_dof.empty();
        }
        if (any)
          body(number);
        ++number;
      }
  }



  template <int dim>
  void
  FluidLikeCells<dim>::find_stiffness(const unsigned int            cell,
                                      Assembler<dim>               &assembler,
                                      const MatrixFreeElastic<dim> *products)
  {
    const bool is_known =
      products != nullptr && products->read_tangents(cell, isotropic);
    if (!is_known && !isotropic.read(assembler.tangents(cell)))
      return assembler.cell_jacobian(cell, local);
    stiffness.assemble(assembler.geometry(cell), isotropic);
    const FiniteElement<dim> &element = fields.elastic.get_fe();
    for (unsigned int i = 0; i < local.m(); ++i)
    {
      const auto [d, a] = element.system_to_component_index(i);
      for (unsigned int j = 0; j < local.n() && d < dim; ++j)
        if (const auto [e, b] = element.system_to_component_index(j); e < dim)
          local(i, j) = stiffness.entry(a, d, b, e);
    }
  }



  template <int dim>
  void
  FluidLikeCells<dim>::assemble(const std::vector<bool>      &chosen,
                                Assembler<dim>               &assembler,
                                const MatrixFreeElastic<dim> *products)
  {
    matrix.clear();
    block_exists = false;
    const int any =
      std::find(chosen.begin(), chosen.end(), true) != chosen.end();
    if (Utilities::MPI::max(any, fields.communicator()) == 0)
      return;
    number_rows(chosen);
    if (!block_exists)
      return;
    std::vector<Index> columns;
    const auto         rows_of_cell = [&]() {
      columns.clear();
      for (const Terms &of_dof : terms)
        for (const auto &term : of_dof)
          columns.push_back(term.first);
      std::sort(columns.begin(), columns.end());
      columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
    };
    IndexSet written = owned_rows;
    visit_cells([&](const unsigned int) {
      rows_of_cell();
      written.add_indices(columns.begin(), columns.end());
    });
    LinearAlgebra::SparsityPattern pattern(
      owned_rows, owned_rows, written, fields.communicator());
    visit_cells([&](const unsigned int) {
      rows_of_cell();
      for (const Index row : columns)
        pattern.add_entries(row, columns.begin(), columns.end(), true);
    });
    pattern.compress();
    matrix.reinit(pattern);

    local.reinit(terms.size(), terms.size());
    std::vector<double> values;
    visit_cells([&](const unsigned int cell) {
      find_stiffness(cell, assembler, products);
      for (unsigned int i = 0; i < terms.size(); ++i)
        for (const auto &[row, weight] : terms[i])
        {
          columns.clear();
          values.clear();
          for (unsigned int j = 0; j < terms.size(); ++j)
            for (const auto &[column, factor] : terms[j])
            {
              columns.push_back(column);
              values.push_back(weight * factor * local(i, j));
            }
          matrix.add(row, columns, values);
        }
    });
    matrix.compress(VectorOperation::add);
  }



  template class FluidLikeCells<2>;
  template class FluidLikeCells<3>;
  template bool is_fluid_like(const ElasticResponse<2> &);
  template bool is_fluid_like(const ElasticResponse<3> &);
} // namespace MixedCracks
