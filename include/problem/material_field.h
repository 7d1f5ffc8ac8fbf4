// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_material_field_h
#define mixed_cracks_problem_material_field_h

#include <base/expression.h>

#include <deal.II/base/point.h>

#include <problem/law_constants.h>
#include <problem/material_parameters.h>

#include <array>
#include <optional>
#include <set>

namespace MixedCracks
{
  /// One complete set of constants: numbers and expressions.
  class MaterialConstants
  {
  public:
    /// x, y, z (mm) and the value of the map.
    using Variables = std::array<double, 4>;

    /// @p texts: by entry name; @p where: what messages put before the name,
    /// as "Material/". Throws InputError for what cannot be understood.
    MaterialConstants(const MaterialParameters::Texts &texts,
                      const std::string               &where,
                      const StrainParameters          &strains = {});

    bool
    varies() const
    {
      return !constant;
    }

    bool uses_map() const;

    /// Throws InputError unless they make a material there.
    MaterialValues evaluate(const Variables &variables) const;

  private:
    struct Entry
    {
      std::string               name;
      std::string               parameter; // in messages
      double                    number;
      std::optional<Expression> expression; // where it is not one number

      double evaluate(const Variables &variables) const;
    };

    MaterialValues compute(const Variables &variables) const;

    /// Of a law with constants of its own; @p values: by name.
    MaterialValues compute_of_law(GivenElasticConstants                given,
                                  const std::map<std::string, double> &values,
                                  double critical_energy_release_rate) const;

    /// Lame's pair; messages name the material id.
    ElasticConstants elastic_pair(const GivenElasticConstants &given) const;

    std::string                   where;
    std::string                   of_material_id; // in messages, or empty
    LawConstants                  law;
    bool                          is_of_law; // and not of a pair
    std::vector<Entry>            entries;
    std::optional<MaterialValues> constant;
  };

  /// The constants of the material anywhere in the body.
  template <int dim>
  class MaterialField
  {
  public:
    /// @p map: null where there is none.
    MaterialField(const MaterialParameters       &parameters,
                  std::shared_ptr<const GridData> map);


    bool
    varies() const
    {
      return !by_id.empty() || elsewhere.varies();
    }

    /// Throws InputError, with the position, unless they make a material.
    MaterialValues operator()(const dealii::Point<dim>  &point,
                              dealii::types::material_id id) const;

    /// Throws InputError when an id is given that the mesh does not have.
    void check_ids(const std::set<dealii::types::material_id> &in_mesh) const;

  private:
    const MaterialConstants &constants_of(dealii::types::material_id id) const;

    MaterialConstants                                       elsewhere;
    std::map<dealii::types::material_id, MaterialConstants> by_id;
    std::shared_ptr<const GridData>                         map;
  };
} // namespace MixedCracks

#endif
