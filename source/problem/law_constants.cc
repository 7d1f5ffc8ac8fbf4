// SPDX-License-Identifier: GPL-2.0-or-later
// What makes constants of a law a material (MPa):
//
//   mu(constants) > 0, and what the law itself says of them,
//   lambda' = lambda - lambda_W > 0   (M13) divides by it; K in the isochoric
//                                     forms
//   Gent: J_m > I_1 - 3 in uniaxial tension at the stretch of use s, I_1 = s^2
//   +
//         2/s,
//   Ogden: mu_i and alpha_i together, (mu_1, alpha_1) at least.

#include <base/names.h>
#include <base/ranges.h>
#include <base/text.h>

#include <problem/geometries/checks.h>
#include <problem/law_constants.h>

#include <cmath>

namespace MixedCracks
{
  const std::vector<std::string> &
  elastic_constant_names()
  {
    static const std::vector<std::string> names = {"Lame lambda",
                                                   "Shear modulus",
                                                   "Young's modulus",
                                                   "Poisson ratio",
                                                   "Bulk modulus"};
    return names;
  }



  namespace
  {
    using Names = std::vector<std::string>;

    // those that say what a change of volume costs, mu being known
    const Names volumetric_names = {"Lame lambda",
                                    "Bulk modulus",
                                    "Poisson ratio"};

    Names
    those_in(const Names &given, const Names &names)
    {
      Names result;
      for (const std::string &name : names)
        if (contains(given, name))
          result.push_back(name);
      return result;
    }

    std::string
    or_nothing(const Names &names)
    {
      return names.empty() ? "nothing" : join_names(names);
    }

    // the other one of mu2 and alpha2
    std::string
    partner_of(const std::string &name)
    {
      const std::string number(1, name.back());
      return (starts_with(name, "mu") ? "alpha" : "mu") + number;
    }
  } // namespace



  LawConstants::LawConstants(const StrainParameters &strains)
    : strains(strains)
  {
    if (!strains.is_finite())
      return;
    law       = make_law(strains);
    own_names = law->constant_names();
  }



  bool
  LawConstants::is_own(const std::string &name) const
  {
    return contains(own_names, name);
  }



  bool
  LawConstants::is_used_by(const Names &given) const
  {
    return law &&
           (strains.law != "neo-Hooke" || !those_in(given, own_names).empty());
  }



  unsigned int
  LawConstants::n_elastic(const Names &given) const
  {
    return is_used_by(given) ? 1 : 2;
  }



  bool
  LawConstants::is_optional(const std::string &name) const
  {
    return strains.law == "Ogden" && name.back() != '1';
  }



  std::string
  LawConstants::entry_of(const std::string &name,
                         const std::string &where) const
  {
    return where == "Material/" ? "Material/Hyperelastic constants: " + name
                                : where + name;
  }



  void
  LawConstants::check_names(const Names &given, const std::string &where) const
  {
    const std::string entry = where == "Material/"
                                ? "Material/Hyperelastic constants"
                                : where + "constants";
    const std::string with  = " with Model/Hyperelastic law = " + strains.law;
    const Names       own   = those_in(given, own_names);
    Names             missing;
    for (const std::string &name : own_names)
      if (!contains(given, name) &&
          (!is_optional(name) || contains(given, partner_of(name))))
        missing.push_back(name);
    require(missing.empty(),
            entry + ": found " + or_nothing(own) + with + ", where " +
              join_names(missing) + " is missing. Allowed are values for " +
              join_names(own_names) +
              (strains.law == "Ogden" ? ", of which the second and third "
                                        "pair may be left out."
                                      : "."));
    const Names elastic = those_in(given, elastic_constant_names());
    require(those_in(elastic, {"Shear modulus", "Young's modulus"}).empty() &&
              elastic.size() == 1,
            (where == "Material/" ? "Material: " : where) + "found " +
              or_nothing(elastic) +
              " beside the "
              "constants " +
              join_names(own) + with +
              ", which say what the "
              "shear modulus is. Allowed is exactly one of " +
              join_names(volumetric_names) + ".");
  }



  HyperelasticConstants
  LawConstants::in_order(const std::map<std::string, double> &values) const
  {
    HyperelasticConstants result{};
    for (std::size_t i = 0; i < own_names.size(); ++i)
    {
      const auto found = values.find(own_names[i]);
      // a term of Ogden's sum with mu = 0, whose exponent divides
      const bool is_exponent = starts_with(own_names[i], "alpha");
      result[i] = found != values.end() ? found->second : is_exponent ? 1. : 0.;
    }
    return result;
  }



  std::string
  LawConstants::in_words(const HyperelasticConstants &constants) const
  {
    std::string text;
    for (std::size_t i = 0; i < own_names.size(); ++i)
      text += (text.empty() ? "" : ", ") + own_names[i] + " = " +
              number_text(constants[i]);
    return text;
  }



  double
  LawConstants::shear_modulus(const HyperelasticConstants &constants,
                              const std::string           &where) const
  {
    const std::string problem = law->problem(constants);
    require(problem.empty(),
            entry_of(in_words(constants), where) + ": " + problem + ".");
    const double mu = law->mu(constants);
    require(std::isfinite(mu) && mu > 0.,
            entry_of(in_words(constants), where) +
              ": the shear modulus at F = I is " + number_text(mu) +
              " MPa. Allowed are constants for which it is greater than 0.");
    return mu;
  }



  void
  LawConstants::check(const HyperelasticConstants &constants,
                      const ElasticConstants      &elastic,
                      const std::string           &where) const
  {
    const double of_law = law->lambda(constants);
    require(elastic.lambda > of_law,
            entry_of(in_words(constants), where) + ": the law itself adds " +
              number_text(of_law) + " MPa to lambda, of the " +
              number_text(elastic.lambda) +
              " MPa that are given. Allowed is a larger Bulk modulus, Lame "
              "lambda or Poisson ratio.");
    if (strains.law != "Gent")
      return;
    const double s     = strains.largest_stretch;
    const double used  = s * s + 2. / s - 3.;
    const double limit = constants.at(1);
    require(limit > used,
            "Model/Largest stretch: found " + number_text(s) +
              ", where I_1 - "
              "3 = " +
              number_text(used) + ", with " + entry_of("Jm", where) + " = " +
              number_text(limit) +
              ", which Gent's law cannot reach. Allowed is a stretch s with "
              "s^2 + 2/s - 3 below Jm.");
  }
} // namespace MixedCracks
