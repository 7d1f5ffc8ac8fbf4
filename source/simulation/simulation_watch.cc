// SPDX-License-Identifier: GPL-2.0-or-later
// What is watched in accepted states: slits that close, loads that nothing
// carries any more.
#include <simulation/simulation.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // mean phase field of a cell that carries with its residual stiffness only
    constexpr double broken = 0.1;

    template <int dim>
    std::string
    in_brackets(const Point<dim> &point)
    {
      std::string text;
      for (unsigned int d = 0; d < dim; ++d)
        text += printed(d == 0 ? "(%.6g" : ", %.6g", point[d]);
      return text + ")";
    }
  } // namespace



  template <int dim>
  void
  Simulation<dim>::log_slits()
  {
    slit_overlap.reinit();
    const auto &faces = slit_overlap.slits();
    if (faces.empty() || !parameters.geometry.chosen().slits().empty())
      return;
    log.line(printed("slits: %zu faces of the coarse mesh, from %s to %s, lie "
                     "between doubled nodes; %s",
                     faces.size(),
                     in_brackets(faces.front().place.corners.front()).c_str(),
                     in_brackets(faces.back().place.corners.back()).c_str(),
                     parameters.initial_cracks.broken_slits
                       ? "the phase field is 0 there (Initial cracks/Broken "
                         "slits)"
                       : "gaps and no more, Initial cracks/Broken slits is "
                         "false"));
  }



  template <int dim>
  void
  Simulation<dim>::watch_slits(const State &state)
  {
    const auto place = slit_overlap.deepest(state.elastic);
    if (place.depth == 0.)
      return;
    ++n_overlapping_steps;
    log.line(printed("  warning: the faces of a slit pass through each other, "
                     "by %.3g mm at %s",
                     place.depth,
                     in_brackets(place.position).c_str()));
    if (place.depth <= deepest_overlap)
      return;
    deepest_overlap = place.depth;
    overlap_in_words =
      printed("the faces of a slit pass through each other, by up to %.3g mm "
              "at %s at t = %.6g s: slits have no contact; a crack of "
              "'Initial cracks' in a whole mesh, with an energy split, closes",
              place.depth,
              in_brackets(place.position).c_str(),
              state.time);
  }



  template <int dim>
  std::vector<std::string>
  Simulation<dim>::all_warnings() const
  {
    std::vector<std::string> result = warnings;
    if (n_overlapping_steps > 0)
      result.push_back(overlap_in_words +
                       printed(" (in %u steps)", n_overlapping_steps));
    return result;
  }



  // Of the elastic energy, what is stored in broken cells
  template <int dim>
  double
  Simulation<dim>::broken_part_of_energy(const State &state) const
  {
    const auto data = assembler->cell_data(
      state.elastic, state.lagged_phase_field, state.phase_field);
    const Vector<float> &density = data.values.at("strain_energy_density");
    std::vector<double>  sums(2, 0.); // all, broken
    for (const auto &cell : fields.phase_field.active_cell_iterators())
    {
      if (!cell->is_locally_owned())
        continue;
      const double energy =
        density(cell->active_cell_index()) * cell->measure();
      double mean = 0.;
      for (const unsigned int v : cell->vertex_indices())
        mean +=
          state.phase_field(cell->vertex_dof_index(v, 0)) / cell->n_vertices();
      sums[0] += energy;
      if (mean < broken)
        sums[1] += energy;
    }
    Utilities::MPI::sum(sums, communicator, sums);
    return sums[0] > 0. ? sums[1] / sums[0] : 0.;
  }



  // A body that dead loads have torn apart is in equilibrium by its residual
  // stiffness only: what the loads store is stored in broken material. Where
  // prescribed displacements hold the parts, the loads store little of it.
  template <int dim>
  bool
  Simulation<dim>::loads_are_carried(const State &state) const
  {
    if (!elastic_step->has_dead_loads())
      return true;
    const double by_loads =
      0.5 * parameters.thickness_factor() * elastic_step->work_of_loads(state);
    const double stored = statistics.rows().back().elastic_energy;
    return !(by_loads > 0.5 * stored) || broken_part_of_energy(state) < 0.5;
  }



  template <int dim>
  std::string
  Simulation<dim>::end_in_words() const
  {
    const auto &rows = statistics.rows();
    if (run_end == RunEnd::stopped && stop_poll.is_by_clock())
      return printed("stopped before Output/Wall time limit, %.4g s, was over; "
                     "continue with --resume",
                     parameters.output.wall_time_limit);
    if (run_end != RunEnd::no_equilibrium || rows.size() < 2)
      return in_words(run_end);
    const StatisticsRow &last_whole = rows[rows.size() - 2];
    return in_words(run_end) +
           printed("; load at failure: between %.6g N (t = %.6g s), which was "
                   "carried, and %.6g N (t = %.6g s), which was not",
                   last_whole.force_size(),
                   last_whole.time,
                   rows.back().force_size(),
                   rows.back().time);
  }



#define INSTANTIATE(dim)                                                         \
  template void                     Simulation<dim>::log_slits();                \
  template void                     Simulation<dim>::watch_slits(const State &); \
  template std::vector<std::string> Simulation<dim>::all_warnings() const;       \
  template double Simulation<dim>::broken_part_of_energy(const State &) const;   \
  template bool   Simulation<dim>::loads_are_carried(const State &) const;       \
  template std::string Simulation<dim>::end_in_words() const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
