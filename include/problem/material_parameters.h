// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_material_parameters_h
#define mixed_cracks_problem_material_parameters_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/types.h>

#include <model/elastic_constants.h>
#include <model/point_constants.h>

#include <problem/material_map.h>
#include <problem/strain_parameters.h>

#include <map>
#include <string>

namespace MixedCracks
{
  /// The constants at one point.
  struct MaterialValues
  {
    ElasticConstants      elastic;                      ///< three-dimensional
    double                critical_energy_release_rate; ///< G_c, N/mm
    HyperelasticConstants hyperelastic{}; ///< of the law; zero at small strain
  };

  /// Subsection "Material".
  struct MaterialParameters
  {
    /// What is given, by the name of the entry: numbers, or expressions in
    /// x, y, z and map.
    using Texts = std::map<std::string, std::string>;

    // as text, since empty means not given
    std::string lame_lambda;
    std::string shear_modulus;
    std::string youngs_modulus;
    std::string poisson_ratio;
    std::string bulk_modulus;
    std::string hyperelastic_constants;
    std::string critical_energy_release_rate = "1";
    std::string by_material_id;

    MaterialMapParameters map;
    double                thickness = 1.;

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// @p model: what it says of strains decides which constants there are.
    /// It must stay; without this call strains are small.
    void
    take_strains_from(const StrainParameters &model)
    {
      strains_of_model = &model;
    }

    StrainParameters
    strains() const
    {
      return strains_of_model != nullptr ? *strains_of_model
                                         : StrainParameters();
    }

    /// Throws InputError unless exactly one admissible pair is given, at finite
    /// strain what LawConstants asks for, as far as it can be told without a
    /// mesh.
    void check() const;

    /// Whether anything differs from point to point.
    bool varies() const;

    /// Where nothing does: the constants everywhere.
    MaterialValues uniform_values() const;

    /// Those of the entries, where no material id says otherwise.
    Texts texts() const;

    /// All that holds in cells of the material ids that are named: what is
    /// not given for them is as in texts(). As many elastic constants as it
    /// takes, two or with a hyperelastic law one, replace those of texts(),
    /// one of two replaces the one of the same name. Throws InputError.
    std::map<dealii::types::material_id, Texts> texts_by_id() const;

  private:
    const StrainParameters *strains_of_model = nullptr;
  };
} // namespace MixedCracks

#endif
