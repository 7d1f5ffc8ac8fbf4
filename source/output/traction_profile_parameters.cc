// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>
#include <base/text.h>

#include <deal.II/base/patterns.h>

#include <output/traction_profile_parameters.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const std::string profiles_entry = "Output/Traction profiles";
  }



  void
  TractionProfileParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter(
      "Traction profiles",
      text,
      "Boundaries whose tractions t = sigma n, n the outward normal, "
      "traction_profiles.csv shall hold: 'boundary ; ...', as in 'top ; hole', "
      "at the quadrature points of their faces, with the part of the area that "
      "each stands for; the sum of t times area comes near the force of "
      "Output/Watched boundaries. At finite strain t = P n, per undeformed "
      "area, at places of the undeformed body. Empty: no such file. Unit: MPa, "
      "mm^2.",
      Patterns::Anything());
    prm.add_parameter("Traction profiles every",
                      every,
                      "The steps whose tractions are written: 0 and every n-th "
                      "accepted one. Unit: steps.",
                      Patterns::Integer(1));
    prm.leave_subsection();
  }



  std::vector<std::pair<std::string, BoundaryIds>>
  TractionProfileParameters::boundaries(const NamedBoundaries &ids) const
  {
    std::vector<std::pair<std::string, BoundaryIds>> result;
    for (const std::string &given : split_list(text, ';'))
    {
      const std::string  name  = single_spaced(given);
      const BoundaryIds &of_it = boundary_of(name, ids, profiles_entry);
      for (const auto &earlier : result)
        if (earlier.first == name)
          throw InputError(profiles_entry + ": found " + in_quotes(name) +
                           " twice, allowed are different boundaries.");
      result.emplace_back(name, of_it);
    }
    return result;
  }
} // namespace MixedCracks
