// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/grid/grid_tools.h>

#include <simulation/simulation.h>
#include <simulation/simulation_plausibility.h>

namespace MixedCracks
{
  using namespace dealii;

  // From the rows, which a resumed run has as well.
  template <int dim>
  std::string
  Simulation<dim>::damage_warning()
  {
    const double body_size = GridTools::volume(triangulation, fields.mapping);
    std::vector<double> shares;
    for (const StatisticsRow &row : statistics.rows())
      shares.push_back(damaged_share(row.crack_surface,
                                     body_size,
                                     material->description().length_scale,
                                     material->crack_density()));
    // loads that nothing carries break all there is, whatever the numbers mean
    if (run_end == RunEnd::no_equilibrium)
      shares.pop_back();
    return damage_in_words(shares, material->description().length_scale);
  }



  template <int dim>
  void
  Simulation<dim>::check_damage()
  {
    const std::string now = damage_warning();
    if (now.empty() || damage_is_known)
      return;
    damage_is_known = true;
    log.line("warning: " + now);
  }



  template std::string Simulation<2>::damage_warning();
  template std::string Simulation<3>::damage_warning();
  template void        Simulation<2>::check_damage();
  template void        Simulation<3>::check_damage();
} // namespace MixedCracks
