// SPDX-License-Identifier: GPL-2.0-or-later
// The material at one point: the integrands of the weak form (M5),
//
//   ( g(phi~) sigma+ + sigma-, eps(w) ) = external forces   for all w
//   ( divergence tr eps - compliance p, q ) = 0             for all q
//   ( g'(phi)/2 D + G_c/l a'(phi), psi )
//      + ( 2 b G_c l grad phi, grad psi ) >= 0     with 0 <= phi <= phi^(n-1)
//
// and their derivatives, without mesh and without vectors. phi~ is the phase
// field in the degradation: that of the last iteration of the alternate
// minimisation (staggered), or of an earlier step. All three come from
//
//   E = integral of  g psi+ + psi-  + G_c (a(phi)/l + b l |grad phi|^2)  dx
//
// where the pressure law is 'degraded bulk'; (M7) and (M8) replace the
// constraint on p, and are not the derivative of one energy in u and phi
// together.
//
// At finite strain FiniteStrain has all of this; here grad u is passed on to
// it. At small strains eps = sym grad u:
//
//   mixed()         stress, constraint and tangents for (eps, p, g)
//   eliminated()    the same with p from the constraint: displacements alone
//   driving_force() D = sigma+ : eps = 2 psi+
//   elastic_energy()  1/2 sigma : eps, degraded
//
// The stress is put together from the split of 2 mu eps (EnergySplit) and the
// pressure (PressureLaw), both in MPa:
//
//   sigma = g sigma+_shear + sigma-_shear + stress * p I,
//   d(sigma)/d(eps) = g C+ + C-,     d(sigma)/dp = stress * I.

#include <model/material.h>

#include <deal.II/base/exceptions.h>

namespace MixedCracks
{
  namespace
  {
    using dealii::SymmetricTensor;

    template <int dim>
    void
    add_pressure(SymmetricTensor<2, dim> &stress, const double pressure)
    {
      for (unsigned int d = 0; d < dim; ++d)
        stress[d][d] += pressure;
    }

    template <int dim>
    void
    add_bulk_stiffness(SymmetricTensor<4, dim> &tangent, const double stiffness)
    {
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          tangent[d][d][e][e] += stiffness;
    }

    // g sigma+ + sigma- of the part 2 mu eps
    template <int dim>
    SymmetricTensor<2, dim>
    shear_stress(const StressParts<dim> &parts, const double g)
    {
      SymmetricTensor<2, dim> stress = parts.positive;
      stress *= g;
      stress += parts.negative;
      return stress;
    }

    // the same, setting its tangent, which takes longer, where it is asked for
    template <int dim>
    SymmetricTensor<2, dim>
    shear_part(ElasticResponse<dim>          &response,
               const EnergySplit<dim>        &split,
               const SymmetricTensor<2, dim> &strain,
               const double                   mu,
               const double                   g,
               const bool                     with_tangent)
    {
      if (!with_tangent)
        return shear_stress(split.parts(strain, mu), g);
      const SplitStress<dim> parts = split.evaluate(strain, mu);
      response.stress_by_strain    = parts.positive_tangent;
      response.stress_by_strain *= g;
      response.stress_by_strain += parts.negative_tangent;
      return shear_stress<dim>(parts, g);
    }
  } // namespace



  template <int dim>
  Material<dim>::Material(const MaterialDescription &description)
    : composition(description)
    , degradation_function(
        all_degradations().make(description.degradation,
                                description.residual_stiffness))
    , density(all_crack_densities().make(description.crack_density))
  {
    if (description.strains == Strains::finite)
      finite_strain = std::make_unique<FiniteStrain<dim>>(description);
    else
    {
      split        = all_energy_splits<dim>().make(description.energy_split,
                                            description.deviator_dimension);
      pressure_law = all_pressure_laws().make(description.pressure_law);
    }
    Assert((!description.constants || (description.constants->lambda > 0. &&
                                       description.constants->mu > 0.)) &&
             description.relaxation > 0. &&
             description.residual_stiffness >= 0. &&
             description.residual_stiffness < 1.,
           dealii::ExcMessage("The constants of a material must be checked "
                              "before it is made."));
  }



  // The unknown p is its own variable: the bulk part of the stress does not
  // appear in the tangent but in the coupling,
  //
  //   d(constraint)/d(tr eps) = divergence,   d(constraint)/dp = -compliance.
  //
  // p > 0, not tr eps > 0, decides between tension and compression: the
  // coefficients are constant but for that jump, at p = 0, where stress * p is
  // continuous.
  template <int dim>
  void
  Material<dim>::mixed(const Gradient       &gradient,
                       const double          pressure,
                       const double          g,
                       const PointConstants &at,
                       const bool            with_tangent,
                       ElasticResponse<dim> &response) const
  {
    if (finite_strain)
    {
      response = finite_strain->mixed(gradient, pressure, g, at, with_tangent);
      return;
    }
    const SymmetricTensor<2, dim> strain = symmetrize(gradient);
    const PressureCoefficients    law =
      pressure_coefficients(g, is_tension(pressure), at);
    auto stress = shear_part(response, *split, strain, at.mu, g, with_tangent);
    add_pressure(stress, law.stress * pressure);
    response.stress             = stress;
    response.stress_by_pressure = law.stress;
    response.constraint =
      law.divergence * trace(strain) - law.compliance * pressure;
    response.constraint_by_trace    = law.divergence;
    response.constraint_by_pressure = -law.compliance;
  }



  // p = divergence/compliance tr eps, hence the bulk stiffness
  //
  //   K = stress * divergence / compliance  (MPa),    sigma += K tr(eps) I,
  //   C += K I (x) I,
  //
  // lambda where the material is intact.
  template <int dim>
  void
  Material<dim>::eliminated(const Gradient       &gradient,
                            const double          g,
                            const PointConstants &at,
                            const bool            with_tangent,
                            ElasticResponse<dim> &response) const
  {
    if (finite_strain)
    {
      response = finite_strain->eliminated(gradient, g, at, with_tangent);
      return;
    }
    const SymmetricTensor<2, dim> strain = symmetrize(gradient);
    // the eliminated pressure has the sign of the trace
    const double volume_change = trace(strain);
    const double bulk_stiffness =
      pressure_coefficients(g, is_tension(volume_change), at)
        .eliminated_stiffness();
    auto stress = shear_part(response, *split, strain, at.mu, g, with_tangent);
    add_pressure(stress, bulk_stiffness * volume_change);
    response.stress = stress;
    if (with_tangent)
      add_bulk_stiffness(response.stress_by_strain, bulk_stiffness);
  }



  template <int dim>
  double
  Material<dim>::pressure(const Gradient       &gradient,
                          const double          g,
                          const PointConstants &at) const
  {
    if (finite_strain)
      return finite_strain->pressure(gradient, g, at);
    const double               volume_change = trace(gradient);
    const PressureCoefficients law =
      pressure_coefficients(g, is_tension(volume_change), at);
    return law.divergence * volume_change / law.compliance;
  }



  // D = sigma+ : eps = 2 psi+ (MPa) with the undegraded pressure,
  //
  //   D = sigma+_shear : eps + driving <p> tr eps,
  //
  // driving = 1, or 1/g where p itself has faded (M8). Without a split of the
  // pressure, p of either sign counts.
  template <int dim>
  double
  Material<dim>::driving_force(const Gradient       &gradient,
                               const double          pressure,
                               const double          g,
                               const PointConstants &at) const
  {
    if (finite_strain)
      return finite_strain->driving_force(gradient, pressure, g, at);
    const SymmetricTensor<2, dim> strain = symmetrize(gradient);
    double force = split->parts(strain, at.mu).positive * strain;
    if (is_tension(pressure))
      force +=
        pressure_coefficients(g, true, at).driving * pressure * trace(strain);
    return force;
  }



  // 1/2 sigma : eps = 1/2 (g sigma+ + sigma-) : eps: the energy, as every law
  // is homogeneous of degree one in (eps, p).
  template <int dim>
  double
  Material<dim>::elastic_energy(const Gradient       &gradient,
                                const double          pressure,
                                const double          g,
                                const PointConstants &at) const
  {
    if (finite_strain)
      return finite_strain->elastic_energy(gradient, pressure, g, at);
    const SymmetricTensor<2, dim> strain = symmetrize(gradient);
    const StressParts<dim>        parts  = split->parts(strain, at.mu);
    const double                  transmitted_pressure =
      pressure_coefficients(g, is_tension(pressure), at).stress * pressure;
    return 0.5 * (g * (parts.positive * strain) + parts.negative * strain +
                  transmitted_pressure * trace(strain));
  }



  // p = K_p tr eps with K_p = divergence/compliance of the degradation of the
  // time; for the same strain and another degradation p changes by the ratio of
  // the K_p. The discrete p solves the constraint in the mean only, so that it
  // is scaled instead of being computed from tr eps.
  template <int dim>
  double
  Material<dim>::pressure_after(const double          pressure,
                                const double          g_before,
                                const double          g_after,
                                const PointConstants &at,
                                const Gradient       &gradient) const
  {
    if (finite_strain)
      return finite_strain->pressure_after(
        pressure, g_before, g_after, at, gradient);
    if (g_before == g_after || pressure == 0.)
      return pressure;
    const bool                 tension = is_tension(pressure);
    const PressureCoefficients before =
      pressure_coefficients(g_before, tension, at);
    const PressureCoefficients after =
      pressure_coefficients(g_after, tension, at);
    const double stiffness_before = before.divergence / before.compliance;
    const double stiffness_after  = after.divergence / after.compliance;
    // without a stiffness there was no pressure, but rounding
    return stiffness_before > 0. ? pressure * stiffness_after / stiffness_before
                                 : 0.;
  }



  // gamma = a(phi)/l + b l |grad phi|^2, (M1); 1/mm
  template <int dim>
  double
  Material<dim>::crack_surface_density(const double phase_field,
                                       const double squared_gradient) const
  {
    const double length = composition.length_scale;
    return density->local(phase_field) / length +
           density->gradient_coefficient() * length * squared_gradient;
  }



  // Derivative of g(phi) psi+ + G_c gamma by phi, with D = 2 psi+:
  //
  //   g'(phi)/2 D + G_c/l a'(phi)     (MPa), third line of (M5)
  template <int dim>
  double
  Material<dim>::phase_field_force(const double          phase_field,
                                   const double          driving_force,
                                   const PointConstants &at) const
  {
    return 0.5 * degradation_function->derivative(phase_field) * driving_force +
           at.critical_energy_release_rate / composition.length_scale *
             density->local_derivative(phase_field);
  }



  // and once more:  g''(phi)/2 D + G_c/l a''(phi)
  template <int dim>
  double
  Material<dim>::phase_field_stiffness(const double          phase_field,
                                       const double          driving_force,
                                       const PointConstants &at) const
  {
    return 0.5 * degradation_function->second_derivative(phase_field) *
             driving_force +
           at.critical_energy_release_rate / composition.length_scale *
             density->local_second_derivative(phase_field);
  }



  // Derivative of G_c gamma by grad phi is 2 b G_c l grad phi (N/mm); the
  // factor has the unit N.
  template <int dim>
  double
  Material<dim>::gradient_stiffness(const PointConstants &at) const
  {
    return 2. * density->gradient_coefficient() *
           at.critical_energy_release_rate * composition.length_scale;
  }



  template <int dim>
  bool
  Material<dim>::phase_field_is_linear() const
  {
    return density->is_quadratic() && degradation_function->is_quadratic();
  }



  // The tangent depends on the regime of the split and, through the
  // coefficients of the pressure law, on the sign of p: twice as many regimes
  // as the split has.
  template <int dim>
  int
  Material<dim>::tangent_regime(const Gradient &gradient,
                                const double    pressure) const
  {
    if (finite_strain)
      return -1;
    const int split_regime = split->tangent_regime(symmetrize(gradient));
    return split_regime < 0 ? -1
                            : 2 * split_regime + (is_tension(pressure) ? 1 : 0);
  }



  template <int dim>
  bool
  Material<dim>::is_tension(const double pressure_or_trace) const
  {
    return pressure_or_trace > 0. || !split->splits_pressure();
  }



  template <int dim>
  PressureCoefficients
  Material<dim>::pressure_coefficients(const double          g,
                                       const bool            tension,
                                       const PointConstants &at) const
  {
    return pressure_law->coefficients(at, composition.relaxation, g, tension);
  }



  template class Material<2>;
  template class Material<3>;
} // namespace MixedCracks
