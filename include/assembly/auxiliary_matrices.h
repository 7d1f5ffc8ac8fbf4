// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_auxiliary_matrices_h
#define mixed_cracks_assembly_auxiliary_matrices_h

#include <assembly/assembler.h>

namespace MixedCracks
{
  /// What multigrid is built on. For quadratic displacements: the elastic
  /// operator of linear elements on cells cut into 2^dim parts, whose nodes
  /// are those of the quadratic ones (iso-Q1). It is spectrally equivalent,
  /// has fewer entries, and smoothed aggregation suits it, which it does not
  /// suit the quadratic one. For the pressure: its mass matrix weighted with
  /// the local compliance, near to the Schur complement. In the numbering of
  /// the elastic fields, with their constraints. Collective.
  template <int dim>
  class AssembledAuxiliaries
  {
  public:
    using Constraints = dealii::AffineConstraints<double>;

    AssembledAuxiliaries(const Fields<dim> &fields,
                         const Constraints &constraints);

    /// To be called when the mesh changed.
    void reinit();

    /// For the state of the last Assembler::elastic_matrix().
    void assemble(Assembler<dim> &assembler);

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

    const LinearAlgebra::SparseMatrix &
    pressure() const
    {
      return pressure_matrix;
    }

  private:
    using Indices = std::vector<dealii::types::global_dof_index>;

    void number_local_dofs();

    void tabulate_shapes();

    void make_patterns();

    void read_cells();

    /// Average of the tangent over one part of a cell, MPa.
    dealii::SymmetricTensor<4, dim>
    average(unsigned int                             part,
            const CellGeometry<dim>                 &geometry,
            const std::vector<ElasticResponse<dim>> &responses) const;

    void add_displacements(unsigned int                             cell,
                           const CellGeometry<dim>                 &geometry,
                           const std::vector<ElasticResponse<dim>> &responses);

    void add_pressures(unsigned int                             cell,
                       const CellGeometry<dim>                 &geometry,
                       const std::vector<ElasticResponse<dim>> &responses);

    static constexpr unsigned int n_corners =
      dealii::GeometryInfo<dim>::vertices_per_cell;

    const Fields<dim> &fields;
    const Constraints &constraints;

    /// of each part, the local dofs of its corners, component by component
    std::vector<std::vector<unsigned int>> part_dofs;
    std::vector<unsigned int>              pressure_dofs;
    /// what of a quadrature point belongs to a part: [part][q]
    std::vector<std::vector<double>> shares;
    /// linear shape functions: [quadrature point of a part][corner], and
    /// [quadrature point of a cell][corner]
    std::vector<std::vector<dealii::Tensor<1, dim>>> part_gradients;
    std::vector<std::vector<double>>                 pressure_values;

    /// of owned cells, in the order of CellTable
    std::vector<std::array<dealii::Point<dim>, n_corners>> corners;
    std::vector<Indices>                                   cell_dofs;

    LinearAlgebra::SparseMatrix displacement_matrix;
    LinearAlgebra::SparseMatrix pressure_matrix;
  };

  /// Stiffness against deformation with a gradient of a potential as
  /// displacement, averaged over directions n: the mean of n(x)n : C : n(x)n,
  /// 2 mu for the tangent 2 mu I; MPa. Its inverse is what the deviatoric
  /// part adds to the compliance of the pressure in the Schur complement.
  template <int dim>
  double longitudinal_stiffness(const dealii::SymmetricTensor<4, dim> &tangent);
} // namespace MixedCracks

#endif
