// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_simulation_plausibility_h
#define mixed_cracks_simulation_simulation_plausibility_h

#include <model/crack_density.h>

#include <simulation/rubber_bar.h>
#include <simulation/simulation_load_size.h>
#include <simulation/simulation_material.h>

namespace MixedCracks
{
  /// What an even bar bears, over the material; see model/strength.h.
  struct ImpliedStrength
  {
    std::string crack_density;
    double      factor; ///< sigma_c = factor sqrt(E G_c / l)
    Range       stress; ///< sigma_c, MPa
    Range       strain; ///< epsilon_c; at finite strain the stretch less 1
    /// up to which a law of rubber is itself, infinity for neo-Hooke; nothing
    /// where strength is that of small strains
    std::optional<double> stretch_of_use{};
  };

  /// Extremes of constants that vary need not meet at a point: the ranges are
  /// as wide as they can be.
  ImpliedStrength implied_strength(const std::string   &crack_density,
                                   const std::string   &degradation,
                                   const MaterialRange &material,
                                   double               length_scale);

  /// Of rubber that is the same everywhere: nominal stress of an
  /// incompressible bar. G_c in N/mm; @p length_scale: mm.
  ImpliedStrength implied_strength(const MaterialDescription &rubber,
                                   double critical_energy_release_rate,
                                   double length_scale);

  /// Whether the nominal stress of a bar falls before its stretch of use: a
  /// sentence, or "".
  std::string warning_about_decline(const MaterialDescription &rubber);

  /// In one sentence, for the log.
  std::string in_words(const ImpliedStrength &strength);

  /// What a case is judged by before it is calculated.
  struct CaseScales
  {
    double length_scale = 0.; ///< l, mm
    double cell_size    = 0.; ///< h where cracks are, mm
    /// of the body, mm: the second largest extent, since in 3-d cracks run
    /// through thin plates
    double          width = 0.;
    ImpliedStrength strength{};
    double          onset_step = 0.; ///< s
    LoadSize        first;           ///< after one onset step
    LoadSize        largest;         ///< until the end time
  };

  template <int dim>
  CaseScales case_scales(const Parameters<dim>          &parameters,
                         const dealii::BoundingBox<dim> &body,
                         const ImpliedStrength          &strength,
                         double                          length_scale,
                         double                          cell_size);

  /// Sentences on what cannot mean what a user wants; none is the rule.
  std::vector<std::string> warnings_about(const CaseScales &scales);

  /// For the log, where it is no mistake: "" or that nothing will break.
  std::string remark_about(const CaseScales &scales);

  /// Integral of the crack density over that of a body that is broken
  /// everywhere: 0 to about 1. @p crack_surface: mm, 3-d mm^2; @p body_size:
  /// mm^2, 3-d mm^3.
  double damaged_share(double              crack_surface,
                       double              body_size,
                       double              length_scale,
                       const CrackDensity &density);

  /// From this share on a body is broken as a whole.
  constexpr double largest_damaged_share = 0.5;

  /// A sentence on the first step after which it is, from the shares of steps
  /// 0, 1, ...; "" if there is none. @p length_scale: mm.
  std::string damage_in_words(const std::vector<double> &shares,
                              double                     length_scale);
} // namespace MixedCracks

#endif
