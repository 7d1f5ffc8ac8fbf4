// SPDX-License-Identifier: GPL-2.0-or-later
// The mean strain of a periodic cell, u(x + L) - u(x) = E(t) L, is the volume
// average of grad u over a cell without holes:
//
//   small strain    E_ij = E_ji, of which 'xy' gives both; the mean of eps
//   finite strain   H_ij = mean of du_i/dx_j, 'xy' and 'yx' apart; F = I + H
//
// E_ij matters where some L has a component j, at small strain also i.

#include <base/errors.h>
#include <base/names.h>
#include <base/text.h>

#include <problem/mean_strain.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const std::string mean_strain_entry = "Boundary conditions/Mean strain";

    // of a period, below which it does not have a direction
    constexpr double negligible = 1e-10;

    // "xx", ...; at small strain one of each pair
    template <int dim>
    std::vector<std::string>
    component_names(const bool finite_strain)
    {
      std::vector<std::string> names;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = finite_strain ? 0 : i; j < dim; ++j)
          names.push_back({"xyz"[i], "xyz"[j]});
      return names;
    }
  } // namespace



  template <int dim>
  MeanStrain<dim>::MeanStrain(const std::string &text, const bool finite_strain)
    : finite_strain(finite_strain)
  {
    const std::vector<std::string> names = component_names<dim>(finite_strain);
    for (const auto &parts :
         read_items(text, "component : expression", mean_strain_entry))
    {
      if (std::find(names.begin(), names.end(), parts[0]) == names.end())
        throw InputError(
          mean_strain_entry + ": component: found " + in_quotes(parts[0]) +
          ", allowed are " + join_names(names) +
          (finite_strain ? "."
                         : "; at small strain 'xy' stands for 'yx', too."));
      for (const Component &earlier : components)
        if (earlier.name == parts[0])
          throw InputError(mean_strain_entry + ": found " +
                           in_quotes(parts[0] + " : " + parts[1]) +
                           ", a second entry for '" + parts[0] +
                           "'. Allowed is one for each component.");
      components.push_back(
        {parts[0],
         static_cast<unsigned int>(parts[0][0] - 'x'),
         static_cast<unsigned int>(parts[0][1] - 'x'),
         std::make_shared<const Expression>(
           parts[1], std::vector<std::string>{"t"}, mean_strain_entry)});
    }
  }



  template <int dim>
  Tensor<2, dim>
  MeanStrain<dim>::at(const double time) const
  {
    Tensor<2, dim> result;
    for (const Component &component : components)
    {
      const double value               = (*component.expression)({time});
      result[component.i][component.j] = value;
      if (!finite_strain)
        result[component.j][component.i] = value;
    }
    return result;
  }



  template <int dim>
  void
  MeanStrain<dim>::require_effect(
    const std::vector<Tensor<1, dim>> &periods) const
  {
    for (const Component &component : components)
      if (std::none_of(periods.begin(), periods.end(), [&](const auto &period) {
            const double least = negligible * period.norm();
            return std::abs(period[component.j]) > least ||
                   (!finite_strain && std::abs(period[component.i]) > least);
          }))
        throw InputError(
          mean_strain_entry + ": found '" + component.name +
          "', which makes no difference: no pair of Geometry/Periodic sides is "
          "apart in " +
          std::string(1, "xyz"[component.j]) +
          ", so that the body is free there. Allowed are components of "
          "directions in which it is periodic.");
  }



  template class MeanStrain<2>;
  template class MeanStrain<3>;
} // namespace MixedCracks
