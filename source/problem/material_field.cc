// SPDX-License-Identifier: GPL-2.0-or-later
// Constants of the material at a place: numbers, or expressions in x, y, z and
// 'map' (a picture or table, see material_map.cc). Two elastic constants of any
// kind become lambda and mu (model/elastic_constants.cc), then G_c.
//
// Sets "By material id" hold for the cells with that id and take what they do
// not name from the entries above. A set without variables is evaluated once,
// and errors in it are found before there is a mesh; others are evaluated at
// every quadrature point, and a bad value names the point.

#include <base/coordinates.h>
#include <base/errors.h>
#include <base/names.h>
#include <base/ranges.h>
#include <base/text.h>

#include <problem/geometries/checks.h>
#include <problem/material_field.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace
  {
    const std::vector<std::string> variable_names = {"x", "y", "z", "map"};

    using Given = GivenElasticConstants;
    const std::map<std::string, std::optional<double> Given::*>
      elastic_members = {{"Lame lambda", &Given::lame_lambda},
                         {"Shear modulus", &Given::shear_modulus},
                         {"Young's modulus", &Given::youngs_modulus},
                         {"Poisson ratio", &Given::poisson_ratio},
                         {"Bulk modulus", &Given::bulk_modulus}};

    bool
    uses_variables(const Expression &expression)
    {
      return any_of(variable_names, [&](const std::string &name) {
        return expression.uses(name);
      });
    }
  } // namespace



  double
  MaterialConstants::Entry::evaluate(const Variables &variables) const
  {
    return expression ? (*expression)({variables.begin(), variables.end()})
                      : number;
  }



  MaterialConstants::MaterialConstants(const MaterialParameters::Texts &texts,
                                       const std::string               &where,
                                       const StrainParameters          &strains)
    : where(where)
    , of_material_id(where == "Material/" ? "" : where)
    , law(strains)
  {
    std::vector<std::string> given;
    bool                     any_varies = false;
    for (const auto &[name, text] : texts)
    {
      const std::string parameter =
        law.is_own(name) ? law.entry_of(name, where) : where + name;
      Entry entry{name, parameter, 0., {}};
      if (const std::optional<double> number = number_in(text))
        entry.number = *number;
      else
      {
        entry.expression.emplace(text, variable_names, entry.parameter);
        any_varies = any_varies || uses_variables(*entry.expression);
      }
      entries.push_back(entry);
      given.push_back(name);
    }
    is_of_law = law.is_used_by(given);
    // values are none of the business of a set that may not be used at all
    const bool has_elasticity = any_of(given, [&](const std::string &name) {
      return elastic_members.count(name) > 0 || law.is_own(name);
    });
    if (is_of_law && has_elasticity)
      law.check_names(given, where);
    if (!any_varies && has_elasticity)
      constant = compute({{0., 0., 0., 0.}});
  }



  bool
  MaterialConstants::uses_map() const
  {
    return any_of(entries, [](const Entry &entry) {
      return entry.expression && entry.expression->uses("map");
    });
  }



  ElasticConstants
  MaterialConstants::elastic_pair(const GivenElasticConstants &given) const
  {
    try
    {
      return elastic_constants(given);
    }
    catch (const InputError &error)
    {
      throw InputError(of_material_id + error.what());
    }
  }



  MaterialValues
  MaterialConstants::compute_of_law(
    Given                                given,
    const std::map<std::string, double> &values,
    const double                         critical_energy_release_rate) const
  {
    const HyperelasticConstants constants = law.in_order(values);
    given.shear_modulus                   = law.shear_modulus(constants, where);
    const ElasticConstants elastic        = elastic_pair(given);
    law.check(constants, elastic, where);
    return {elastic, critical_energy_release_rate, constants};
  }



  MaterialValues
  MaterialConstants::compute(const Variables &variables) const
  {
    Given                         given;
    double                        critical_energy_release_rate = 0.;
    std::map<std::string, double> of_law;
    for (const Entry &entry : entries)
    {
      const double value   = entry.evaluate(variables);
      const auto   elastic = elastic_members.find(entry.name);
      if (elastic != elastic_members.end())
        given.*elastic->second = value;
      else if (law.is_own(entry.name))
        of_law[entry.name] = value;
      else
      {
        critical_energy_release_rate = value;
        require(std::isfinite(value) && value > 0.,
                entry.parameter + ": found '" + number_text(value) +
                  "', expected a number greater than 0 (N/mm).");
      }
    }
    if (is_of_law && of_law.empty())
      law.check_names({}, where);
    if (is_of_law)
      return compute_of_law(given, of_law, critical_energy_release_rate);
    const ElasticConstants pair = elastic_pair(given);
    // neo-Hooke's mu, where there is a law
    return {
      pair, critical_energy_release_rate, law.in_order({{"mu", pair.mu}})};
  }



  MaterialValues
  MaterialConstants::evaluate(const Variables &variables) const
  {
    return constant ? *constant : compute(variables);
  }



  template <int dim>
  MaterialField<dim>::MaterialField(const MaterialParameters       &parameters,
                                    std::shared_ptr<const GridData> map)
    : elsewhere(parameters.texts(), "Material/", parameters.strains())
    , map(std::move(map))
  {
    for (const auto &[id, texts] : parameters.texts_by_id())
      by_id.emplace(id,
                    MaterialConstants(
                      texts,
                      "Material/By material id: " + std::to_string(id) + ": ",
                      parameters.strains()));
  }



  template <int dim>
  const MaterialConstants &
  MaterialField<dim>::constants_of(const dealii::types::material_id id) const
  {
    const auto found = by_id.find(id);
    return found == by_id.end() ? elsewhere : found->second;
  }



  template <int dim>
  MaterialValues
  MaterialField<dim>::operator()(const dealii::Point<dim>        &point,
                                 const dealii::types::material_id id) const
  {
    const MaterialConstants      &constants   = constants_of(id);
    const std::array<double, dim> coordinates = coordinates_of(point);
    try
    {
      GridData::Coordinates position{{0., 0., 0.}};
      std::copy(coordinates.begin(), coordinates.end(), position.begin());
      return constants.evaluate({{position[0],
                                  position[1],
                                  position[2],
                                  map ? map->value(position) : 0.}});
    }
    catch (const InputError &error)
    {
      throw InputError(
        std::string(error.what()) + " Found at " +
        point_text({coordinates.begin(), coordinates.end()}) +
        (by_id.empty() ? "" : ", material id " + std::to_string(id)) + ".");
    }
  }



  template <int dim>
  void
  MaterialField<dim>::check_ids(
    const std::set<dealii::types::material_id> &in_mesh) const
  {
    std::vector<std::string> names;
    for (const auto id : in_mesh)
      names.push_back(std::to_string(id));
    for (const auto &entry : by_id)
      require(in_mesh.count(entry.first) > 0,
              "Material/By material id: the material id " +
                std::to_string(entry.first) +
                " is not in the mesh, which has " + join_names(names) + ".");
  }



  template class MaterialField<2>;
  template class MaterialField<3>;
} // namespace MixedCracks
