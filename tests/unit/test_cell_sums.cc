// SPDX-License-Identifier: GPL-2.0-or-later
// Sums over cells beside those of AffineConstraints.
#include <assembly/cell_sums.h>
#include <base/compat.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <deal.II/grid/grid_generator.h>

#include <deal.II/numerics/vector_tools.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace dealii;
  using namespace MixedCracks;

  // Cells of two sizes; one side held in its normal direction, another held.
  // Without refinement one cell, so that other ranks have none.
  template <int dim>
  void
  expect_sums_of_constraints(const unsigned int n_components,
                             const unsigned int refinements)
  {
    parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
    GridGenerator::hyper_cube(mesh, 0., 1., /*colorize=*/true);
    mesh.refine_global(refinements);
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned() && cell->center()[0] > 0.5 &&
          cell->center()[1] > 0.5)
        cell->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
    const FESystem<dim> element(FE_Q<dim>(1), n_components);
    DoFHandler<dim>     dofs(mesh);
    dofs.distribute_dofs(element);
    const IndexSet owned = dofs.locally_owned_dofs();
    IndexSet       relevant;
    DoFTools::extract_locally_relevant_dofs(dofs, relevant);
    AffineConstraints<double> constraints;
    Compat::reinit(constraints, owned, relevant);
    DoFTools::make_hanging_node_constraints(dofs, constraints);
    const Functions::ZeroFunction<dim> zero(n_components);
    VectorTools::interpolate_boundary_values(
      dofs,
      0,
      zero,
      constraints,
      element.component_mask(FEValuesExtractors::Scalar(0)));
    VectorTools::interpolate_boundary_values(dofs, 2, zero, constraints);
    constraints.close();

    std::vector<CellSums::Indices> cells;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cells.emplace_back(element.n_dofs_per_cell());
        cell->get_dof_indices(cells.back());
      }
    MixedCracks::LinearAlgebra::SparsityPattern pattern(
      owned, owned, relevant, MPI_COMM_WORLD);
    for (const auto &cell : cells)
      constraints.add_entries_local_to_global(cell, pattern, false);
    pattern.compress();
    MixedCracks::LinearAlgebra::SparseMatrix expected, found;
    expected.reinit(pattern);
    found.reinit(pattern);
    CellSums sums;
    sums.reinit(found, cells, constraints);
    // twice: what the first time leaves must not spoil the second
    for (unsigned int time = 0; time < 2; ++time)
    {
      expected = 0.;
      sums.set_zero();
      FullMatrix<double> local(element.n_dofs_per_cell());
      for (unsigned int cell = 0; cell < cells.size(); ++cell)
      {
        for (unsigned int i = 0; i < local.m(); ++i)
          for (unsigned int j = 0; j < local.n(); ++j)
            local(i, j) =
              std::sin(1. + time + 7. * cells[cell][i] + 0.3 * cells[cell][j]);
        local(1, 1) = 0.; // held in some cells
        constraints.distribute_local_to_global(local, cells[cell], expected);
        sums.add(cell, local);
      }
      expected.compress(VectorOperation::add);
      sums.finish();
      const double size = expected.frobenius_norm();
      EXPECT_GT(size, 1.);
      found.add(-1., expected);
      EXPECT_LT(found.frobenius_norm(), 1e-14 * size);
    }
  }
} // namespace



TEST(CellSums, AreThoseOfTheConstraints)
{
  for (const unsigned int refinements : {0, 2})
  {
    expect_sums_of_constraints<2>(1, refinements);
    expect_sums_of_constraints<2>(2, refinements);
    expect_sums_of_constraints<3>(1, refinements);
    expect_sums_of_constraints<3>(3, refinements);
  }
}
