// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_fluid_like_cells_h
#define mixed_cracks_assembly_fluid_like_cells_h

#include <assembly/assembler.h>
#include <assembly/matrix_free_elastic.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <discretization/constraints.h>

#include <functional>
#include <vector>

namespace MixedCracks
{
  /// The cells that resist compression and hardly shear, as Amor's split leaves
  /// broken cells that are compressed, and the block of the elastic matrix that
  /// belongs to their displacements, in numbers of its own. Collective.
  template <int dim>
  class FluidLikeCells
  {
  public:
    FluidLikeCells(const Fields<dim>      &fields,
                   const Constraints<dim> &constraints);

    /// Assemble the block in the state of the last
    /// Assembler::elastic_matrix(). @p chosen: one entry per owned cell, in the
    /// order of CellTable, whether it is one of them. @p products, if any,
    /// know the tangents.
    void assemble(const std::vector<bool>      &chosen,
                  Assembler<dim>               &assembler,
                  const MatrixFreeElastic<dim> *products);

    /// Whether there is a block: not without such cells, nor with so many that
    /// its factors might not fit into memory.
    bool
    has_block() const
    {
      return block_exists;
    }

    const LinearAlgebra::SparseMatrix &
    block() const
    {
      return matrix;
    }

    /// Of its owned rows in order the positions among the owned unknowns.
    const std::vector<unsigned int> &
    rows() const
    {
      return positions;
    }

    /// Unknowns of the largest block.
    static constexpr dealii::types::global_dof_index most_unknowns = 150000;

  private:
    using Index = dealii::types::global_dof_index;
    /// an unknown of a cell by those that it depends on, with their weights
    using Terms = std::vector<std::pair<Index, double>>;

    void read_terms(const std::vector<Index> &indices);

    void number_rows(const std::vector<bool> &chosen);

    /// Call @p body with the numbers of the owned cells that have rows of the
    /// block, see terms.
    void visit_cells(const std::function<void(unsigned int)> &body);

    /// What one cell adds to the displacements' block of the elastic matrix.
    void find_stiffness(unsigned int                  cell,
                        Assembler<dim>               &assembler,
                        const MatrixFreeElastic<dim> *products);

    /// Row of the block; dealii::numbers::invalid_dof_index if it has none.
    Index
    row_of(const Index dof) const
    {
      const double number = row_numbers(dof);
      return number > 0. ? static_cast<Index>(number) - 1
                         : dealii::numbers::invalid_dof_index;
    }

    const Fields<dim>      &fields;
    const Constraints<dim> &constraints;
    bool                    block_exists = false;
    /// row of the block plus 1, exact in double precision; 0: none
    dealii::LinearAlgebra::distributed::Vector<double> row_numbers;
    std::vector<unsigned int>                          positions;
    dealii::IndexSet                                   owned_rows;
    LinearAlgebra::SparseMatrix                        matrix;
    std::vector<Terms>                                 terms; // of a cell

    IsotropicCell              isotropic;
    IsotropicStiffness<dim>    stiffness;
    dealii::FullMatrix<double> local; // of a cell
  };

  /// Whether some wave of shear meets less than a fiftieth of the stiffness
  /// that the stiffest wave meets: of the acoustic tensors Q(n) the ratio of
  /// the least to the largest eigenvalue over directions n.
  template <int dim>
  bool is_fluid_like(const ElasticResponse<dim> &response);

  /// The same for C = a 1 + b I (x) I with a = @p identity, b = @p volume.
  bool is_fluid_like(double identity, double volume);
} // namespace MixedCracks

#endif
