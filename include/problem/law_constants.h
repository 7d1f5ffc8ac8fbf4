// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_law_constants_h
#define mixed_cracks_problem_law_constants_h

#include <model/elastic_constants.h>
#include <model/hyperelastic_law.h>

#include <problem/strain_parameters.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// Lambda, mu, E, nu and K, as their entries of Material are called.
  const std::vector<std::string> &elastic_constant_names();

  /// Which constants make a material of the hyperelastic law of a case, and
  /// whether their values do. Constants are known by the names of entries of
  /// Material and of those in Material/Hyperelastic constants. There are none
  /// at small strain.
  ///
  /// A law has constants of its own, which say what mu is, and one more for the
  /// change of volume: lambda, K or nu. Neo-Hooke's mu may also come from a
  /// pair of elastic constants.
  class LawConstants
  {
  public:
    explicit LawConstants(const StrainParameters &strains);

    /// Of the law, in the order of HyperelasticConstants.
    const std::vector<std::string> &
    names() const
    {
      return own_names;
    }

    bool is_own(const std::string &name) const;

    /// Whether mu comes from constants of the law, where these are given.
    bool is_used_by(const std::vector<std::string> &given) const;

    /// How many out of lambda, mu, E, nu, K it takes with these.
    unsigned int n_elastic(const std::vector<std::string> &given) const;

    /// Throws InputError unless @p given are all that a material takes where
    /// is_used_by() them. @p where: what messages put before the names, as
    /// "Material/".
    void check_names(const std::vector<std::string> &given,
                     const std::string              &where) const;

    /// In the order of names(); terms of a sum that are not given are nothing.
    HyperelasticConstants
    in_order(const std::map<std::string, double> &values) const;

    /// At F = I, MPa. Throws InputError unless it is positive, and for
    /// constants that are no material by themselves.
    double shear_modulus(const HyperelasticConstants &constants,
                         const std::string           &where) const;

    /// Throws InputError where volume costs nothing, or states within the
    /// stretch of use are beyond what the law can reach.
    void check(const HyperelasticConstants &constants,
               const ElasticConstants      &elastic,
               const std::string           &where) const;

    /// What messages call it: "Material/Hyperelastic constants: C10".
    std::string entry_of(const std::string &name,
                         const std::string &where) const;

  private:
    /// Whether a sum goes without it, as without the third term of Ogden.
    bool is_optional(const std::string &name) const;

    std::string in_words(const HyperelasticConstants &constants) const;

    StrainParameters                       strains;
    std::shared_ptr<const HyperelasticLaw> law; ///< null at small strain
    std::vector<std::string>               own_names;
  };
} // namespace MixedCracks

#endif
