// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_finite_strain_h
#define mixed_cracks_model_finite_strain_h

#include <model/deformation.h>
#include <model/elastic_response.h>
#include <model/finite_pressure_law.h>
#include <model/finite_split.h>
#include <model/hyperelastic_law.h>
#include <model/material_description.h>
#include <model/volumetric_form.h>

#include <memory>
#include <optional>
#include <string>

namespace MixedCracks
{
  /// Rubber at one point at finite strain, (M11) to (M15): pure functions of
  /// the displacement gradient (dimensionless), the pressure (MPa), the
  /// degradation g and the constants there. In 2-d the third direction is
  /// that of plane strain or plane stress. Where det F <= 0, or plane stress
  /// has no F_33, results are NaN (or as they say), nothing is thrown.
  template <int dim>
  class FiniteStrain
  {
  public:
    using Gradient = dealii::Tensor<2, dim>;

    /// Throws InputError for unknown names and where finite_strain_problem()
    /// has something to say.
    explicit FiniteStrain(const MaterialDescription &description);

    /// Mixed formulation. Without @p with_tangent, derivatives are not valid.
    ElasticResponse<dim> mixed(const Gradient       &gradient,
                               double                pressure,
                               double                g,
                               const PointConstants &at,
                               bool                  with_tangent) const;

    /// Displacement formulation, p eliminated: only stress and
    /// stress_by_gradient are set, the other members are 0.
    ElasticResponse<dim> eliminated(const Gradient       &gradient,
                                    double                g,
                                    const PointConstants &at,
                                    bool                  with_tangent) const;

    /// The p for which the constraint holds here; MPa.
    double pressure(const Gradient       &gradient,
                    double                g,
                    const PointConstants &at) const;

    /// D = 2 Psi+, what drives the crack, undegraded (M15); MPa.
    double driving_force(const Gradient       &gradient,
                         double                pressure,
                         double                g,
                         const PointConstants &at) const;

    /// a W~ + compliance p^2/2, the stored energy; MPa.
    double elastic_energy(const Gradient       &gradient,
                          double                pressure,
                          double                g,
                          const PointConstants &at) const;

    /// What @p pressure, which the constraint gave for @p g_before, becomes
    /// with @p g_after when the displacement stays; MPa.
    double pressure_after(double                pressure,
                          double                g_before,
                          double                g_after,
                          const PointConstants &at,
                          const Gradient       &gradient) const;

    /// At a fixed degradation: distortion + p * volume_change - compliance
    /// p^2/2, whose derivatives are stress and constraint of mixed().
    struct Potential
    {
      double distortion;    ///< MPa
      double volume_change; ///< dimensionless
      double compliance;    ///< 1/MPa
    };

    /// @p pressure selects F_33 (plane stress) and the sign of a split only.
    Potential potential(const Gradient       &gradient,
                        double                pressure,
                        double                g,
                        const PointConstants &at) const;

    /// The energy whose derivative is the stress of eliminated(), MPa;
    /// infinite where det F <= 0, or no F_33.
    double eliminated_energy(const Gradient       &gradient,
                             double                g,
                             const PointConstants &at) const;

    /// det(I + gamma(g) grad u), in 2-d of the part in the plane: what must
    /// stay positive.
    double determinant(const Gradient &gradient, double g) const;

    /// J, with F_33.
    double volume_ratio(const Gradient       &gradient,
                        double                pressure,
                        double                g,
                        const PointConstants &at) const;

    /// F.
    dealii::Tensor<2, 3> deformation_gradient(const Gradient       &gradient,
                                              double                pressure,
                                              double                g,
                                              const PointConstants &at) const;

    /// sigma = P F^T / J, the true stress; MPa.
    dealii::SymmetricTensor<2, 3> cauchy_stress(const Gradient       &gradient,
                                                double                pressure,
                                                double                g,
                                                const PointConstants &at) const;

  private:
    // the response in space, before F_33 is condensed out
    struct Full
    {
      dealii::Tensor<2, 3> stress;
      dealii::Tensor<4, 3> tangent;
      dealii::Tensor<2, 3> coupling;
      double               constraint;
      double               constraint_by_pressure;
    };

    HyperelasticConstants law_constants(const PointConstants &at) const;

    FiniteModuli moduli(const PointConstants &at) const;

    FinitePressureCoefficients
    coefficients(double sign, double g, const PointConstants &at) const;

    double share_of_law(double g) const;

    double linear_energy(const Gradient       &gradient,
                         double                g,
                         const PointConstants &at) const;

    double stretch_at_pressure(const Gradient       &gradient,
                               double                pressure,
                               double                g,
                               const PointConstants &at) const;

    double stretch_at_constraint(const Gradient       &gradient,
                                 double                g,
                                 const PointConstants &at) const;

    std::optional<Deformation> at_pressure(const Gradient       &gradient,
                                           double                pressure,
                                           double                g,
                                           const PointConstants &at) const;

    std::optional<Deformation> at_constraint(const Gradient       &gradient,
                                             double                g,
                                             const PointConstants &at) const;

    Full in_space(const Deformation                &deformation,
                  double                            pressure,
                  const FinitePressureCoefficients &law,
                  const PointConstants             &at,
                  bool                              with_tangent) const;

    ElasticResponse<dim> in_body(Full &full, bool with_tangent) const;

    bool plane_stress;
    bool resists_closure; ///< broken material does, by the split
    bool is_one_constant; ///< neo-Hooke, which may take at.mu
    std::unique_ptr<VolumetricForm>    form;
    std::unique_ptr<HyperelasticLaw>   law;
    std::unique_ptr<FiniteSplit>       split;
    std::unique_ptr<FinitePressureLaw> pressure_law;
  };

  /// What is wrong with the constants @p at a point for this material, in
  /// words; empty: nothing. Throws InputError for unknown names.
  std::string finite_strain_problem(const MaterialDescription &description,
                                    const PointConstants      &at);
} // namespace MixedCracks

#endif
