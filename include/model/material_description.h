// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_material_description_h
#define mixed_cracks_model_material_description_h

#include <model/point_constants.h>
#include <model/strains.h>

#include <optional>
#include <string>

namespace MixedCracks
{
  /// Everything a Material is composed of, by name and by number.
  struct MaterialDescription
  {
    /// those that hold everywhere; none where they vary from point to point
    std::optional<PointConstants> constants;

    double      length_scale;       ///< l, mm
    double      residual_stiffness; ///< kappa, dimensionless
    double      relaxation;         ///< c of (1-g)/(g c mu), see (M8), (M13)
    int         deviator_dimension; ///< n of dev_n: 2 or 3; small strains only
    std::string crack_density;
    std::string energy_split; ///< of all_energy_splits(), all_finite_splits()
    std::string pressure_law; ///< of all_pressure_laws(), all_finite_...()
    std::string degradation = "quadratic";

    Strains     strains          = Strains::small;
    std::string hyperelastic_law = "neo-Hooke"; ///< all_hyperelastic_laws()
    std::string volumetric_form  = "coupled";   ///< all_volumetric_forms()
    bool        plane_stress     = false;       ///< read at finite strain only
    /// stretch of use; beyond it the law goes on as neo-Hooke
    double largest_stretch = 5.;
  };
} // namespace MixedCracks

#endif
