// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_material_h
#define mixed_cracks_model_material_h

#include <model/crack_density.h>
#include <model/degradation.h>
#include <model/elastic_response.h>
#include <model/energy_split.h>
#include <model/finite_strain.h>
#include <model/material_description.h>
#include <model/point_constants.h>
#include <model/pressure_law.h>

#include <deal.II/base/symmetric_tensor.h>

#include <memory>

namespace MixedCracks
{
  /// The material at one point: pure functions of the displacement gradient
  /// (no unit), pressure and phase field. At small strains only the symmetric
  /// part of the gradient counts, and a strain does in its place; at finite
  /// strain FiniteStrain answers. In the displacement formulation the pressure
  /// is eliminated with the constraint: pressure() returns it, and eliminated()
  /// the stress.
  /// @p at: the constants of that point; without it, those that are the same
  /// everywhere.
  template <int dim>
  class Material
  {
  public:
    using Gradient = dealii::Tensor<2, dim>;

    explicit Material(const MaterialDescription &description);

    /// Mixed formulation. @p g: degradation of the lagged phase field.
    /// Without @p with_tangent, the derivatives are not valid, and it is done
    /// in half the time. Sets @p response in place: at small strains copying it
    /// would take as long as computing it.
    void mixed(const Gradient       &gradient,
               double                pressure,
               double                g,
               const PointConstants &at,
               bool                  with_tangent,
               ElasticResponse<dim> &response) const;

    ElasticResponse<dim>
    mixed(const Gradient &gradient, const double pressure, const double g) const
    {
      ElasticResponse<dim> response;
      mixed(gradient, pressure, g, uniform_constants(), true, response);
      return response;
    }

    /// Displacement formulation: only stress and its derivative by the strain
    /// or gradient are set.
    void eliminated(const Gradient       &gradient,
                    double                g,
                    const PointConstants &at,
                    bool                  with_tangent,
                    ElasticResponse<dim> &response) const;

    ElasticResponse<dim>
    eliminated(const Gradient &gradient, const double g) const
    {
      ElasticResponse<dim> response;
      eliminated(gradient, g, uniform_constants(), true, response);
      return response;
    }

    /// The p for which the constraint holds at this strain; MPa.
    double pressure(const Gradient       &gradient,
                    double                g,
                    const PointConstants &at) const;

    double
    pressure(const Gradient &gradient, const double g) const
    {
      return pressure(gradient, g, uniform_constants());
    }

    /// D = sigma+ : eps = 2 psi+, what drives the crack, undegraded; MPa.
    double driving_force(const Gradient       &gradient,
                         double                pressure,
                         double                g,
                         const PointConstants &at) const;

    double
    driving_force(const Gradient &gradient,
                  const double    pressure,
                  const double    g) const
    {
      return driving_force(gradient, pressure, g, uniform_constants());
    }

    /// Stored elastic energy density, degraded: MPa. Small strains: half
    /// of stress : strain.
    double elastic_energy(const Gradient       &gradient,
                          double                pressure,
                          double                g,
                          const PointConstants &at) const;

    double
    elastic_energy(const Gradient &gradient,
                   const double    pressure,
                   const double    g) const
    {
      return elastic_energy(gradient, pressure, g, uniform_constants());
    }

    /// What @p pressure, which the constraint gave for the degradation
    /// @p g_before, becomes when the constraint is that of @p g_after and the
    /// displacement stays: MPa. It keeps its sign. @p gradient counts in plane
    /// stress at finite strain only.
    double pressure_after(double                pressure,
                          double                g_before,
                          double                g_after,
                          const PointConstants &at,
                          const Gradient       &gradient = Gradient()) const;

    /// gamma(phi, grad phi) = a(phi)/l + b l |grad phi|^2, 1/mm.
    /// @p squared_gradient: |grad phi|^2, 1/mm^2.
    double crack_surface_density(double phase_field,
                                 double squared_gradient) const;

    /// What the phase-field equation integrates against a test function:
    /// g'(phi)/2 D + G_c/l a'(phi), MPa. @p driving_force: D, of
    /// driving_force(); MPa.
    double phase_field_force(double                phase_field,
                             double                driving_force,
                             const PointConstants &at) const;

    /// Its derivative by phi: g''(phi)/2 D + G_c/l a''(phi), MPa.
    double phase_field_stiffness(double                phase_field,
                                 double                driving_force,
                                 const PointConstants &at) const;

    /// What it integrates against gradients is this times grad phi: the factor
    /// 2 b G_c l, N.
    double gradient_stiffness(const PointConstants &at) const;

    /// Whether phase_field_stiffness() is the same for every phi, so that the
    /// phase-field equation is linear but for its bounds.
    bool phase_field_is_linear() const;

    /// Whether intact material is linearly elastic; see
    /// EnergySplit::adds_up().
    bool
    is_linear_when_intact() const
    {
      return !is_finite() && split->adds_up();
    }

    /// Whether the derivatives of mixed() form a symmetric matrix for every
    /// state; those of eliminated() always do.
    bool
    mixed_is_symmetric() const
    {
      return is_finite() || pressure_law->is_symmetric();
    }

    /// A number that two points share exactly when mixed() (or eliminated(),
    /// with pressure 0) gives them the same derivatives for the same g;
    /// negative when it cannot be said, as at finite strain.
    int tangent_regime(const Gradient &gradient, double pressure) const;

    bool
    is_finite() const
    {
      return finite_strain != nullptr;
    }

    /// At finite strain only.
    const FiniteStrain<dim> &
    finite() const
    {
      return *finite_strain;
    }

    const Degradation &
    degradation() const
    {
      return *degradation_function;
    }

    const CrackDensity &
    crack_density() const
    {
      return *density;
    }

    const MaterialDescription &
    description() const
    {
      return composition;
    }

    /// Those that hold everywhere; throws std::bad_optional_access where they
    /// vary.
    const PointConstants &
    uniform_constants() const
    {
      return composition.constants.value();
    }

  private:
    bool is_tension(double pressure_or_trace) const;

    PressureCoefficients pressure_coefficients(double                g,
                                               bool                  tension,
                                               const PointConstants &at) const;

    MaterialDescription           composition;
    std::unique_ptr<Degradation>  degradation_function;
    std::unique_ptr<CrackDensity> density;
    /// the two at small strains, the third at finite strain
    std::unique_ptr<EnergySplit<dim>>  split;
    std::unique_ptr<PressureLaw>       pressure_law;
    std::unique_ptr<FiniteStrain<dim>> finite_strain;
  };
} // namespace MixedCracks

#endif
