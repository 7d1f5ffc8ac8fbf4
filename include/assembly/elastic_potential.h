// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_elastic_potential_h
#define mixed_cracks_assembly_elastic_potential_h

#include <assembly/assembler.h>

#include <discretization/constraints.h>

namespace MixedCracks
{
  /// The potential of the elastic forces at finite strain as a function of the
  /// displacements alone, at a given lagged phase field: what Newton's method
  /// descends on. In the mixed formulation the pressure is eliminated in its
  /// own discrete space; point by point it would be another function, that of
  /// an element that locks. Collective.
  template <int dim>
  class ElasticPotential
  {
  public:
    using Vector = LinearAlgebra::Vector;

    ElasticPotential(const Fields<dim>      &fields,
                     const Constraints<dim> &constraints,
                     Assembler<dim>         &assembler);

    /// To be called when the mesh changed.
    void reinit();

    /// Of the displacements of @p elastic, whose pressure is but where the
    /// elimination starts; N (mJ per mm thickness). Infinite or no number where
    /// cells are turned inside out.
    double value(const Vector &elastic, const Vector &lagged_phase_field);

    /// What cancelled in the last value(), N: see
    /// ElasticKernel::potential_terms().
    double
    terms() const
    {
      return terms_of_value;
    }

    /// The displacements of the last value() with the pressure that was found;
    /// has ghosts.
    const Vector &
    equilibrium() const
    {
      return state;
    }

    /// The derivative of the last value() along the displacements of
    /// @p direction, which has ghosts and no increment of hanging nodes of its
    /// own; N.
    double slope(const Vector &direction, const Vector &lagged_phase_field);

  private:
    /// At `state`, whatever its pressure.
    double present_value(const Vector &lagged_phase_field);

    double eliminate_pressure(const Vector &lagged_phase_field);

    /// Potential and its derivative by the pressures at `state`; sets `mass`.
    double evaluate(const Vector &lagged_phase_field, Vector &residual);

    /// Of all ranks; the terms are kept.
    double sum_up(double value, double terms);

    /// mass * solution = right_hand_side
    void solve_with_mass(const Vector &right_hand_side, Vector &solution) const;

    const Fields<dim>      &fields;
    const Constraints<dim> &constraints;
    Assembler<dim>         &assembler;

    double                      terms_of_value = 0.;
    Vector                      state; // with ghosts
    LinearAlgebra::SparseMatrix mass;  // of the pressure, mm^2/MPa
  };
} // namespace MixedCracks

#endif
