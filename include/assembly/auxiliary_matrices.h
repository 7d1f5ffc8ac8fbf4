// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_auxiliary_matrices_h
#define mixed_cracks_assembly_auxiliary_matrices_h

#include <assembly/assembler.h>
#include <assembly/cell_sums.h>
#include <assembly/fluid_like_cells.h>
#include <assembly/isotropic_cell.h>
#include <assembly/matrix_free_elastic.h>

#include <discretization/linear_displacements.h>

namespace MixedCracks
{
  /// What multigrid is built on. For quadratic displacements: the elastic
  /// operator of linear ones on the same cells, which is theirs restricted to
  /// a subspace; smoothed aggregation suits it, which it does not suit the
  /// quadratic one. For the pressure: its mass matrix weighted with the local
  /// compliance, near to the Schur complement, in the numbering of the elastic
  /// fields. Collective.
  template <int dim>
  class AssembledAuxiliaries
  {
  public:
    AssembledAuxiliaries(const Fields<dim>      &fields,
                         const Constraints<dim> &constraints);

    /// To be called when the mesh changed.
    void reinit();

    /// For the state of the last Assembler::elastic_matrix(), or of the last
    /// MatrixFreeElastic::update() of @p products, if there are such.
    void assemble(Assembler<dim>               &assembler,
                  const MatrixFreeElastic<dim> *products = nullptr);

    /// Whether there is one: linear displacements need none.
    bool
    has_displacement() const
    {
      return fields.layout.displacement_degree > 1;
    }

    const LinearAlgebra::SparseMatrix &
    displacement() const
    {
      return displacement_matrix;
    }

    /// Which unknowns that matrix has, and what they mean for the others.
    const LinearDisplacements<dim> &
    coarse() const
    {
      return linear_displacements;
    }

    const LinearAlgebra::SparseMatrix &
    pressure() const
    {
      return pressure_matrix;
    }

    const FluidLikeCells<dim> &
    fluid_like() const
    {
      return fluid_like_cells;
    }

  private:
    using Indices = CellSums::Indices;

    /// The unknowns of each owned cell, in the order of CellTable.
    std::vector<Indices> vertex_dofs() const;
    std::vector<Indices> pressure_dofs() const;

    /// A cell with the tangents of isotropic; whether it is fluid-like.
    bool add_isotropic(unsigned int cell, const CellGeometry<dim> &geometry);

    bool add_general(unsigned int                             cell,
                     const CellGeometry<dim>                 &geometry,
                     const std::vector<ElasticResponse<dim>> &responses);

    /// With weights.
    void add_pressures(unsigned int cell);

    const Fields<dim>       &fields;
    const Constraints<dim>  &constraints;
    ScalarShapes<dim>        shapes; // linear
    IsotropicStiffness<dim>  linear_stiffness;
    IsotropicCell            isotropic;
    std::vector<double>      mass_of_points; // M_k M_l of each point
    std::vector<double>      weights; // of the pressure at the points of a cell
    LinearDisplacements<dim> linear_displacements;
    bool                     is_finite = false; // finite strain

    LinearAlgebra::SparseMatrix displacement_matrix;
    LinearAlgebra::SparseMatrix pressure_matrix;
    CellSums                    displacement_sums, pressure_sums;
    FluidLikeCells<dim>         fluid_like_cells;
  };

  /// Stiffness against deformation with a gradient of a potential as
  /// displacement, averaged over directions n: the mean of n(x)n : C : n(x)n,
  /// 2 mu for the tangent 2 mu I; MPa. Its inverse is what the deviatoric
  /// part adds to the compliance of the pressure in the Schur complement.
  template <int dim>
  double longitudinal_stiffness(const dealii::SymmetricTensor<4, dim> &tangent);
} // namespace MixedCracks

#endif
