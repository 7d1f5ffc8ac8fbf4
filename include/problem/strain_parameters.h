// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_strain_parameters_h
#define mixed_cracks_problem_strain_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <model/hyperelastic_law.h>
#include <model/strains.h>

#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// The entries of subsection "Model" that say whether strains are small, and
  /// how rubber answers to large ones. By default they are small, and the
  /// others mean nothing.
  struct StrainParameters
  {
    std::string strains_name    = "small";
    std::string law             = "neo-Hooke";
    std::string volumetric_form = "coupled";
    double      largest_stretch = 5.; ///< of use

    /// Into the subsection that is entered.
    void add_parameters(dealii::ParameterHandler &prm);

    bool
    is_finite() const
    {
      return strains_name == "finite";
    }

    Strains
    strains() const
    {
      return is_finite() ? Strains::finite : Strains::small;
    }

    /// Throws InputError for an energy split or a pressure law that is not
    /// there for these strains, or not with this law.
    void check(const std::string &energy_split,
               const std::string &pressure_law) const;
  };

  /// The law of these entries, whatever the strains.
  std::unique_ptr<HyperelasticLaw> make_law(const StrainParameters &strains);

  /// A name that an entry allows, and for which strains.
  struct StrainChoice
  {
    std::string name;
    std::string description;
    bool        with_small  = true;
    bool        with_finite = true;
  };

  /// Energy splits for either kind of strains.
  const std::vector<StrainChoice> &energy_split_choices();

  /// Pressure laws for either kind of strains.
  const std::vector<StrainChoice> &pressure_law_choices();

  /// "a|b", as dealii::Patterns::Selection wants them.
  std::string selection(const std::vector<StrainChoice> &choices);

  /// "'name': description. 'name': ...", and which are for one kind of strains
  /// only.
  std::string documentation(const std::vector<StrainChoice> &choices);
} // namespace MixedCracks

#endif
