// SPDX-License-Identifier: GPL-2.0-or-later
// The crack length of every step (3-d: surface), as a share of what it would be
// if the whole body were broken; see damaged_share().

#include <simulation/damage_warning.h>
#include <simulation/simulation_plausibility.h>

namespace MixedCracks
{
  template <int dim>
  std::string
  damage_warning(const Body<dim>                  &body,
                 const std::vector<StatisticsRow> &rows,
                 const RunEnd                      end)
  {
    const double        body_size = body.volume();
    std::vector<double> shares;
    for (const StatisticsRow &row : rows)
      shares.push_back(damaged_share(row["crack_length"],
                                     body_size,
                                     body.length_scale(),
                                     body.material->crack_density()));
    // loads that nothing carries break all there is, whatever the numbers mean
    if (end == RunEnd::no_equilibrium)
      shares.pop_back();
    return damage_in_words(shares, body.length_scale());
  }



  template std::string
  damage_warning(const Body<2> &, const std::vector<StatisticsRow> &, RunEnd);
  template std::string
  damage_warning(const Body<3> &, const std::vector<StatisticsRow> &, RunEnd);
} // namespace MixedCracks
