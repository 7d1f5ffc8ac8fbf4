// SPDX-License-Identifier: GPL-2.0-or-later
// Entries of the material. Two of five elastic constants are given, in any
// pair:
//
//   lambda, mu = E/(2 (1 + nu)), E, nu, K = lambda + 2 mu/3,
//
// and G_c (N/mm). For a material id one constant replaces the one of the same
// name, two replace the pair: with E and nu given for the body, "E" of an id
// keeps nu.
//
// A map that no expression uses, and an expression without the map it uses, are
// refused: both look like a case that does what was wanted.

#include <base/errors.h>
#include <base/names.h>
#include <base/text.h>

#include <deal.II/base/patterns.h>

#include <problem/geometries/checks.h>
#include <problem/material_field.h>

#include <algorithm>
#include <limits>

namespace MixedCracks
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    const std::string by_id_name     = "Material/By material id";
    const std::string constants_name = "Material/Hyperelastic constants";

    const std::string critical_energy_release_rate_name =
      "Critical energy release rate";

    // Parts between commas that are not inside of parentheses: those separate
    // the arguments of functions.
    std::vector<std::string>
    split_outside_parentheses(const std::string &text)
    {
      std::vector<std::string> parts(1);
      int                      depth = 0;
      for (const char c : text)
      {
        depth += (c == '(') - (c == ')');
        if (c == ',' && depth == 0)
          parts.emplace_back();
        else
          parts.back() += c;
      }
      return parts;
    }

    // "name = value, name = value" of the names @p known
    MaterialParameters::Texts
    parsed_texts(const std::string              &text,
                 const std::vector<std::string> &known,
                 const std::string              &parameter)
    {
      MaterialParameters::Texts texts;
      for (const std::string &assignment : split_outside_parentheses(text))
      {
        const auto equals = assignment.find('=');
        require(equals != std::string::npos,
                parameter + ": " + in_quotes(single_spaced(assignment)) +
                  " is not of the form 'name = value'; names: " +
                  join_names(known) + ".");
        const std::string name = single_spaced(assignment.substr(0, equals));
        require(std::find(known.begin(), known.end(), name) != known.end(),
                parameter + ": " + unknown_name_message(name, known));
        require(
          texts.emplace(name, single_spaced(assignment.substr(equals + 1)))
            .second,
          parameter + ": " + name + " is given twice.");
      }
      return texts;
    }

    unsigned int
    n_elastic(const MaterialParameters::Texts &texts)
    {
      unsigned int n = 0;
      for (const std::string &name : elastic_constant_names())
        n += texts.count(name);
      return n;
    }

    std::vector<std::string>
    names_of(const MaterialParameters::Texts &texts)
    {
      std::vector<std::string> names;
      for (const auto &entry : texts)
        names.push_back(entry.first);
      return names;
    }

    // All constants that there are with this law.
    std::vector<std::string>
    known_names(const LawConstants &law)
    {
      std::vector<std::string> names = elastic_constant_names();
      names.insert(names.end(), law.names().begin(), law.names().end());
      names.push_back(critical_energy_release_rate_name);
      return names;
    }

    // "Mooney-Rivlin: C10, C01. Yeoh: ..."
    std::string
    names_of_all_laws()
    {
      std::string      text;
      StrainParameters strains;
      strains.strains_name = "finite";
      for (const std::string &name : all_hyperelastic_laws().names())
      {
        strains.law = name;
        text += name + ": " + join_names(LawConstants(strains).names()) + ". ";
      }
      return text;
    }

    bool
    is_elastic(const std::string &name)
    {
      const std::vector<std::string> &names = elastic_constant_names();
      return std::find(names.begin(), names.end(), name) != names.end();
    }
  } // namespace



  void
  MaterialParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    const std::string pair =
      " Exactly one pair of elastic constants has to be given, as numbers or "
      "expressions in x, y, z and map; empty: not given. Unit: ";
    prm.enter_subsection("Material");
    prm.add_parameter("Lame lambda",
                      lame_lambda,
                      "First Lame parameter lambda." + pair + "MPa.");
    prm.add_parameter(
      "Shear modulus", shear_modulus, "mu = E/(2(1+nu))." + pair + "MPa.");
    prm.add_parameter("Young's modulus", youngs_modulus, "E." + pair + "MPa.");
    prm.add_parameter(
      "Poisson ratio", poisson_ratio, "nu, between 0 and 0.5." + pair + "1.");
    prm.add_parameter(
      "Bulk modulus", bulk_modulus, "K = lambda + 2 mu/3." + pair + "MPa.");
    prm.add_parameter(
      "Hyperelastic constants",
      hyperelastic_constants,
      "Those of Model/Hyperelastic law (M12), at finite strain only: 'C10 = "
      "1.0129, C20 = -0.01226, C30 = 0.001033', numbers or expressions in x, "
      "y, z and map. " +
        names_of_all_laws() +
        "They say what the shear modulus mu at F = I is; exactly one of Lame "
        "lambda, Bulk modulus and Poisson ratio has to be given with them, "
        "which mean what they say at F = I too. With neo-Hooke the pair of "
        "elastic constants does without. Units: MPa; alpha and Jm: 1.",
      Patterns::Anything());
    prm.add_parameter("Critical energy release rate",
                      critical_energy_release_rate,
                      "G_c, the energy to open a unit of crack surface: a "
                      "positive number or an expression in x, y, z and map, "
                      "as '2.7*(1 + 3*map)'. Unit: N/mm.");
    prm.add_parameter(
      "By material id",
      by_material_id,
      "Other constants for cells with these material ids of the mesh (Gmsh: "
      "physical surfaces or volumes): 'id : name = value, name = value ; ...', "
      "with the names of the entries above, at finite strain those in "
      "Hyperelastic constants too ('4 : C10 = 0.5'), and numbers or "
      "expressions. What is not given for an id is as above; two elastic "
      "constants, or the one beside constants of a law, replace those above, "
      "one of two replaces the one of the same name. Units as above.",
      Patterns::Anything());
    prm.add_parameter("Thickness",
                      thickness,
                      "Of the specimen, out of plane. In 2-d it multiplies "
                      "forces and energies, never stresses. In 3-d it is the "
                      "extent in z of the geometries that are plane figures "
                      "made thick (punctured strip, L-shape, quadrilateral), "
                      "and forces and energies are those of the whole body. "
                      "Unit: mm.",
                      Patterns::Double(std::numeric_limits<double>::min()));
    map.add_parameters(prm);
    prm.leave_subsection();
  }



  MaterialParameters::Texts
  MaterialParameters::texts() const
  {
    const std::string *values[] = {&lame_lambda,
                                   &shear_modulus,
                                   &youngs_modulus,
                                   &poisson_ratio,
                                   &bulk_modulus};
    Texts              result;
    for (std::size_t i = 0; i < elastic_constant_names().size(); ++i)
      if (!values[i]->empty())
        result[elastic_constant_names()[i]] = *values[i];
    result[critical_energy_release_rate_name] = critical_energy_release_rate;
    if (strains().is_finite() && !hyperelastic_constants.empty())
      result.merge(parsed_texts(hyperelastic_constants,
                                LawConstants(strains()).names(),
                                constants_name));
    return result;
  }



  std::map<dealii::types::material_id, MaterialParameters::Texts>
  MaterialParameters::texts_by_id() const
  {
    std::map<dealii::types::material_id, Texts> result;
    const LawConstants                          law(strains());
    const Texts                                 elsewhere = texts();
    for (const std::string &item : split_list(by_material_id, ';'))
    {
      const auto colon = item.find(':');
      require(colon != std::string::npos,
              by_id_name + ": " + in_quotes(item) +
                " is not of the form 'id : name = value, ...'.");
      const dealii::types::material_id id =
        read_id(single_spaced(item.substr(0, colon)), "material", by_id_name);
      Texts all =
        parsed_texts(item.substr(colon + 1), known_names(law), by_id_name);
      Texts with_those_above = all;
      with_those_above.insert(elsewhere.begin(), elsewhere.end());
      const bool replaces_pair =
        n_elastic(all) >= law.n_elastic(names_of(with_those_above));
      for (const auto &[name, text] : elsewhere)
        if (!is_elastic(name) || !replaces_pair)
          all.emplace(name, text); // unless it is there
      require(result.emplace(id, all).second,
              by_id_name + ": the material id " + std::to_string(id) +
                " is given twice.");
    }
    return result;
  }



  bool
  MaterialParameters::varies() const
  {
    return !by_material_id.empty() ||
           MaterialConstants(texts(), "Material/", strains()).varies();
  }



  MaterialValues
  MaterialParameters::uniform_values() const
  {
    return MaterialConstants(texts(), "Material/", strains()).evaluate({});
  }



  void
  MaterialParameters::check() const
  {
    require(strains().is_finite() || hyperelastic_constants.empty(),
            constants_name + ": found " + in_quotes(hyperelastic_constants) +
              " with Model/Strains = small. Allowed: nothing, or Model/Strains "
              "= finite.");
    const LawConstants law(strains());
    const auto         given    = texts();
    bool               uses_map = false;
    MaterialConstants  elsewhere(given, "Material/", strains());
    // with sets for material ids none may be needed for the rest; then a
    // missing one is an error of the first cell that needs it
    if (by_material_id.empty() &&
        n_elastic(given) != law.n_elastic(names_of(given)))
      elsewhere.evaluate({});
    uses_map = elsewhere.uses_map();
    for (const auto &[id, texts] : texts_by_id())
    {
      const std::string where = by_id_name + ": " + std::to_string(id) + ": ";
      require(law.is_used_by(names_of(texts)) || n_elastic(texts) == 2,
              where + std::to_string(n_elastic(texts)) +
                " elastic constants, with those of the entries above; exactly "
                "two are needed, out of " +
                join_names(elastic_constant_names()) + ".");
      const MaterialConstants constants(texts, where, strains());
      uses_map = uses_map || constants.uses_map();
    }
    require(map.given() || !uses_map,
            "Material/Map/File name: found nothing, but an expression of the "
            "material uses 'map'. Allowed: the name of a picture or a table.");
    require(uses_map || !map.given(),
            "Material/Map/File name: found '" + map.file_name +
              "', but no expression of the material uses 'map'. Allowed: "
              "nothing, or expressions as '2.7*(1 + 3*map)'.");
  }
} // namespace MixedCracks
