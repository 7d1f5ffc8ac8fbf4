// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_elastic_kernel_h
#define mixed_cracks_assembly_elastic_kernel_h

#include <assembly/cell_geometry.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <model/material.h>

#include <array>
#include <vector>

namespace MixedCracks
{
  /// What the elastic response depends on at one quadrature point.
  template <int dim>
  struct ElasticPoint
  {
    dealii::Tensor<2, dim> gradient;    ///< of u
    double                 pressure;    ///< MPa
    double                 degradation; ///< g
    /// see Material::tangent_regime(), or tangent_of_finite_strain
    int tangent_regime;
  };

  /// The regime of a point whose tangent is another one in every state.
  constexpr int tangent_of_finite_strain = -2;

  /// What ElasticKernel::set_state() evaluates: nothing but the points, which
  /// do for energy(), the stresses as well, which do for all but jacobian(),
  /// or everything.
  enum class ElasticEvaluation
  {
    points,
    stresses,
    tangents
  };

  /// Energy, residual and Jacobian of the elastic fields on one cell,
  ///
  ///   (g sigma+ + sigma-, eps(w)) = 0,   (constraint of p, q) = 0,
  ///
  /// the first two lines of (M5) for a given degradation g; at finite strain
  /// (M13) with the first Piola-Kirchhoff stress, integrated over the reference
  /// configuration. Works on local vectors only, per unit thickness. The .cc
  /// has the blocks.
  template <int dim>
  class ElasticKernel
  {
  public:
    ElasticKernel(const dealii::FiniteElement<dim> &element,
                  const dealii::Quadrature<dim>    &quadrature,
                  const Material<dim>              &material,
                  bool                              mixed);

    /// @p geometry and @p constants must stay until the next call.
    void reinit(const CellGeometry<dim> &geometry,
                const CellConstants     &constants);

    /// For set_points() and what belongs to points: without a cell.
    void
    reinit_points(const CellConstants &constants_at_points)
    {
      constants = constants_at_points;
    }

    /// With constants that are the same everywhere.
    void
    reinit(const CellGeometry<dim> &geometry)
    {
      reinit(geometry, CellConstants(material.uniform_constants()));
    }

    /// Evaluate strain, pressure and response at the quadrature points.
    /// @p local: values of the dofs of this cell; @p lagged_phase_field: one
    /// value per quadrature point.
    void set_state(const dealii::Vector<double> &local,
                   const std::vector<double>    &lagged_phase_field,
                   ElasticEvaluation wanted = ElasticEvaluation::tangents);

    /// All of it from points() of an earlier set_state().
    void set_points(const ElasticPoint<dim> *first);

    /// One for each quadrature point.
    const std::vector<ElasticPoint<dim>> &
    points() const
    {
      return states;
    }

    /// Stresses and their derivatives there.
    const std::vector<ElasticResponse<dim>> &
    point_responses() const
    {
      Assert(evaluated == ElasticEvaluation::tangents,
             dealii::ExcMessage("The tangents have not been evaluated."));
      return responses;
    }

    /// As often as wanted after set_state(). Units: N/mm for the rows of the
    /// displacement, mm^2 for those of the pressure (in 2-d).
    void residual(dealii::Vector<double> &result) const;

    /// Derivative of residual() by the local values.
    void jacobian(dealii::FullMatrix<double> &result) const;

    bool
    jacobian_is_symmetric() const
    {
      return !mixed || material.is_finite() || material.mixed_is_symmetric();
    }

    /// Degraded elastic energy of the cell, N (mJ per mm thickness).
    double energy() const;

    /// The same with another phase field than set_state() had, given at the
    /// quadrature points: of the same displacements, with the pressure that
    /// the pressure law gives them then.
    double energy(const std::vector<double> &phase_field) const;

    /// Sizes of the terms that cancel in the residual, squared and summed
    /// over the dofs of the displacement and of the pressure: what a small
    /// residual has to be compared with.
    std::pair<double, double> squared_scale() const;

    /// D = sigma+ : eps = 2 psi+ at a quadrature point, undegraded; MPa.
    /// @p at: the constants there.
    double driving_force(const ElasticPoint<dim> &point,
                         const PointConstants    &at) const;

    /// Averages over the cell for the output, undegraded strain included.
    struct CellAverages
    {
      /// MPa, degraded; at finite strain that of Cauchy
      dealii::SymmetricTensor<2, dim> stress;
      double                          energy_density; ///< MPa, degraded
      /// 1 at small strain
      double largest_stretch; ///< of the three principal ones
      double volume_ratio;    ///< J
    };
    /// Stresses are those of set_state(), the energy that of @p phase_field.
    CellAverages averages(const std::vector<double> &phase_field) const;

    // At finite strain, for Newton's method.

    /// Of the quadrature points the smallest det F, that of the plane in 2-d;
    /// 1 at small strain. Not above 0: the cell is turned inside out.
    double smallest_determinant() const;

    /// What residual() is the derivative of by the displacements, N: the
    /// stored energy, infinite where it is turned inside out; in the mixed
    /// formulation of the given pressure, and residual() is its derivative by
    /// the pressure too.
    double potential() const;

    /// What cancels in potential() where little strain is left, N: its rounding
    /// errors are some machine epsilons of that.
    double potential_terms() const;

    /// Minus the second derivative of potential() by the pressures, mm^2/MPa:
    /// their mass matrix with the compliance of each point as weight. As many
    /// rows and columns as there are pressure_indices().
    void pressure_mass(dealii::FullMatrix<double> &result) const;

    /// Which of the degrees of freedom of a cell are pressures.
    const std::vector<unsigned int> &
    pressure_indices() const
    {
      return pressure_dofs;
    }

  private:
    void evaluate_responses(ElasticEvaluation wanted);

    int tangent_regime(const ElasticPoint<dim> &point) const;

    double degradation(double phase_field) const;

    double degradation_for_energy(const ElasticPoint<dim> &point,
                                  double                   phase_field) const;

    void displacement_block(unsigned int                q,
                            dealii::FullMatrix<double> &result) const;

    void pressure_blocks(unsigned int                q,
                         dealii::FullMatrix<double> &result) const;

    void finite_displacement_block(unsigned int                q,
                                   dealii::FullMatrix<double> &result) const;

    void finite_pressure_blocks(unsigned int                q,
                                dealii::FullMatrix<double> &result) const;

    void add_block_of_pressure(unsigned int                q,
                               dealii::FullMatrix<double> &result) const;

    double size_of_strain(const dealii::Tensor<2, dim> &gradient) const;

    void add_finite(unsigned int q, CellAverages &sum) const;

    const Material<dim>     &material;
    const bool               mixed;
    ScalarShapes<dim>        displacement_shapes;
    ScalarShapes<dim>        pressure_shapes;
    const CellGeometry<dim> *geometry = nullptr;
    CellConstants            constants;
    // local index of component d of node a: displacement_dofs[a][d]
    std::vector<std::array<unsigned int, dim>> displacement_dofs;
    std::vector<unsigned int>                  pressure_dofs;
    std::vector<ElasticPoint<dim>>             states;
    std::vector<ElasticResponse<dim>>          responses;
    double            largest_displacement = 0.; // of a component at a node, mm
    ElasticEvaluation evaluated            = ElasticEvaluation::points;
  };
} // namespace MixedCracks

#endif
