// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_cell_table_h
#define mixed_cracks_assembly_cell_table_h

#include <assembly/cell_geometry.h>

#include <deal.II/lac/affine_constraints.h>

#include <discretization/fields.h>

#include <Epetra_Export.h>

#include <memory>
#include <vector>

namespace MixedCracks
{
  /// The degrees of freedom of one handler on the owned cells, as positions
  /// in a vector with ghosts: what asking cell and vector for global indices
  /// would find out again and again. Reads such vectors, and sums up
  /// contributions of cells to vectors without ghosts.
  template <int dim>
  class CellDofs
  {
  public:
    using Constraints = dealii::AffineConstraints<double>;

    CellDofs(const dealii::DoFHandler<dim> &handler, const DofSets &sets);

    /// Values of the dofs of owned cell number @p cell.
    void read(unsigned int                 cell,
              const LinearAlgebra::Vector &ghosted,
              dealii::Vector<double>      &local) const;

    void
    global_indices(unsigned int                                  cell,
                   std::vector<dealii::types::global_dof_index> &indices) const;

    /// Begin the sum over the cells; @p result will be set to zero.
    void begin_sum(LinearAlgebra::Vector &result);

    void add(unsigned int                  cell,
             const dealii::Vector<double> &local,
             const Constraints            &constraints,
             LinearAlgebra::Vector        &result);

    /// Add up what the ranks contributed to shared dofs. Collective.
    void end_sum(LinearAlgebra::Vector &result);

  private:
    bool is_constrained(unsigned int       cell,
                        const Constraints &constraints) const;

    const unsigned int                           dofs_per_cell;
    std::vector<unsigned int>                    positions; // cell by cell
    std::vector<dealii::types::global_dof_index> global;    // by position
    LinearAlgebra::Vector                        sums;      // with ghosts
    std::unique_ptr<Epetra_Export>               exporter;

    // of cells with constrained dofs, in global numbers; work space
    std::vector<dealii::types::global_dof_index> indices;
  };

  /// Everything about the owned cells that stays the same on one mesh, in the
  /// order of the loop over the cells.
  template <int dim>
  class CellTable
  {
  public:
    explicit CellTable(const Fields<dim> &fields);

    unsigned int
    n_cells() const
    {
      return geometries.size();
    }

    const CellGeometry<dim> &
    geometry(const unsigned int cell) const
    {
      return geometries[cell];
    }

    /// Number of the cell among the active ones, and its material.
    unsigned int
    active_index(const unsigned int cell) const
    {
      return active_indices[cell];
    }

    dealii::types::material_id
    material(const unsigned int cell) const
    {
      return materials[cell];
    }

    CellDofs<dim> elastic;
    CellDofs<dim> phase_field;

  private:
    std::vector<CellGeometry<dim>>          geometries;
    std::vector<unsigned int>               active_indices;
    std::vector<dealii::types::material_id> materials;
  };
} // namespace MixedCracks

#endif
