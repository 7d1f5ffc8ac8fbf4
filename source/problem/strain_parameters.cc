// SPDX-License-Identifier: GPL-2.0-or-later
// Which names there are at small and at finite strain: those of the lists of
// model/, each of which is about one of them.
#include <base/names.h>
#include <base/ranges.h>

#include <deal.II/base/patterns.h>

#include <model/energy_split.h>
#include <model/finite_pressure_law.h>
#include <model/finite_split.h>
#include <model/pressure_law.h>
#include <model/volumetric_form.h>

#include <problem/geometries/checks.h>
#include <problem/strain_parameters.h>

namespace MixedCracks
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    // those of small strains first, then what only finite strain has
    template <typename Small, typename Finite>
    std::vector<StrainChoice>
    choices_of(const Small &small, const Finite &finite)
    {
      std::vector<StrainChoice> choices;
      for (const std::string &name : small.names())
        choices.push_back({name,
                           small.description(name),
                           true,
                           contains(finite.names(), name)});
      for (const std::string &name : finite.names())
        if (!contains(small.names(), name))
          choices.push_back({name, finite.description(name), false, true});
      return choices;
    }

    std::vector<std::string>
    names_for(const std::vector<StrainChoice> &choices, const bool finite)
    {
      std::vector<std::string> names;
      for (const StrainChoice &choice : choices)
        if (finite ? choice.with_finite : choice.with_small)
          names.push_back(choice.name);
      return names;
    }

    void
    require_choice(const std::string               &entry,
                   const std::string               &found,
                   const std::vector<StrainChoice> &choices,
                   const StrainParameters          &strains)
    {
      const std::vector<std::string> names =
        names_for(choices, strains.is_finite());
      require(contains(names, found),
              entry + ": found '" + found +
                "' with Model/Strains = " + strains.strains_name +
                ". Allowed there: " + join_names(names) + ".");
    }
  } // namespace



  std::unique_ptr<HyperelasticLaw>
  make_law(const StrainParameters &strains)
  {
    return all_hyperelastic_laws().make(
      strains.law,
      {strains.largest_stretch, strains.volumetric_form != "coupled"});
  }



  const std::vector<StrainChoice> &
  energy_split_choices()
  {
    static const std::vector<StrainChoice> list =
      choices_of(all_energy_splits<2>(), all_finite_splits());
    return list;
  }



  const std::vector<StrainChoice> &
  pressure_law_choices()
  {
    static const std::vector<StrainChoice> list =
      choices_of(all_pressure_laws(), all_finite_pressure_laws());
    return list;
  }



  std::string
  selection(const std::vector<StrainChoice> &choices)
  {
    std::vector<std::string> names;
    for (const StrainChoice &choice : choices)
      names.push_back(choice.name);
    return join_names(names, "|");
  }



  std::string
  documentation(const std::vector<StrainChoice> &choices)
  {
    std::string text;
    for (const StrainChoice &choice : choices)
      text += (text.empty() ? "'" : " '") + choice.name + "'" +
              (!choice.with_small    ? " (finite strain only)"
               : !choice.with_finite ? " (small strain only)"
                                     : "") +
              ": " + choice.description + ".";
    return text;
  }



  void
  StrainParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter(
      "Strains",
      strains_name,
      "'small': linear elasticity, sigma of eps = sym grad u. 'finite': rubber, "
      "the first Piola-Kirchhoff stress of F = I + grad u (M11) to (M15), with "
      "the law of Model/Hyperelastic law; loads are dead loads per undeformed "
      "area or volume, and all integrals are over the undeformed body. A case "
      "at finite strain has to set Model/Energy split too, whose default is "
      "one of small strains. There is no fluid in cracks at finite strain.",
      Patterns::Selection("small|finite"));
    prm.add_parameter(
      "Hyperelastic law",
      law,
      "The energy W of (M12), at finite strain only. " +
        all_hyperelastic_laws().documentation() +
        " Its constants are Material/Hyperelastic constants, for neo-Hooke the "
        "pair of elastic constants or mu.",
      Patterns::Selection(all_hyperelastic_laws().selection()));
    prm.add_parameter("Volumetric form",
                      volumetric_form,
                      "How the energy of a change of volume joins that of the "
                      "law, at finite strain only. " +
                        all_volumetric_forms().documentation(),
                      Patterns::Selection(all_volumetric_forms().selection()));
    prm.add_parameter(
      "Largest stretch",
      largest_stretch,
      "Stretch of use at finite strain: in states beyond it, I_1 above that of "
      "uniaxial tension at this stretch, the law goes on convexly as a neo-"
      "Hooke one. Broken cells are stretched a hundredfold, where a polynomial "
      "law would stiffen them without bound, and Gent's has no value. Unit: 1.",
      Patterns::Double(1.01, 1e6));
  }



  void
  StrainParameters::check(const std::string &energy_split,
                          const std::string &pressure_law) const
  {
    require_choice(
      "Model/Energy split", energy_split, energy_split_choices(), *this);
    require_choice(
      "Model/Pressure law", pressure_law, pressure_law_choices(), *this);
    if (!is_finite() || energy_split != "principal stretches")
      return;
    std::vector<std::string> sums;
    for (const std::string &name : all_hyperelastic_laws().names())
      if (all_hyperelastic_laws().make(name, {})->is_sum_over_stretches())
        sums.push_back(name);
    require(contains(sums, law),
            "Model/Energy split: found 'principal stretches' with "
            "Model/Hyperelastic law = " +
              law +
              ", which is no sum over principal stretches. Allowed: "
              "principal stretches with " +
              join_names(sums) + ", or none, volumetric.");
    require(volumetric_form == "coupled",
            "Model/Energy split: found 'principal stretches' with "
            "Model/Volumetric form = " +
              volumetric_form +
              ". Allowed: principal stretches with coupled, or none, "
              "volumetric.");
  }
} // namespace MixedCracks
