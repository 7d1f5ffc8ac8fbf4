// SPDX-License-Identifier: GPL-2.0-or-later
// Options of the parts that record, out of parameters of several rooms.
// 'output' knows no .prm of the model.

#include <output/run_directory.h>

#include <simulation/recording.h>

#include <cmath>

namespace MixedCracks
{
  template <int dim>
  RecorderOptions<dim>
  recorder_options(const Parameters<dim> &parameters)
  {
    RecorderOptions<dim> options{parameters.output,
                                 parameters.crack_opening,
                                 parameters.point_displacements,
                                 parameters.events,
                                 parameters.thickness_factor(),
                                 {}};
    options.finite_strain = parameters.model.strain.is_finite();
    options.watched       = parameters.watched_boundaries.boundaries(
      parameters.geometry.chosen().boundary_ids());
    options.tractions = {parameters.traction_profiles.boundaries(
                           parameters.geometry.chosen().boundary_ids()),
                         parameters.traction_profiles.every,
                         parameters.thickness_factor()};
    for (const auto &entry :
         parameters.boundary_conditions.point_displacements())
      options.held_points.push_back(
        {entry.point, entry.component, nullptr, true, entry.set});
    const std::string boundary = parameters.force_boundary();
    if (!boundary.empty())
      options.force_boundary =
        parameters.geometry.chosen().boundary_ids().at(boundary);
    return options;
  }



  template <int dim>
  RunLogOptions
  run_log_options(const Parameters<dim> &parameters)
  {
    RunLogOptions options;
    options.end_time  = parameters.load.end_time;
    options.is_lagged = parameters.coupling.kind != "iterated";
    return options;
  }



  // The least energy: next to nothing of what a crack as long as l costs.
  template <int dim>
  ImbalanceRule
  imbalance_rule(const Body<dim> &body)
  {
    constexpr double       next_to_nothing = 1e-10;
    const Parameters<dim> &parameters      = body.parameters;
    return {parameters.output.energy_imbalance_tolerance,
            parameters.change_where_a_crack_ran(),
            next_to_nothing *
              body.material_range.critical_energy_release_rate.smallest *
              std::pow(body.length_scale(), dim - 1) *
              parameters.thickness_factor()};
  }



  template <int dim>
  std::vector<std::string>
  files_of_run(const Parameters<dim> &parameters)
  {
    std::vector<std::string> names = MixedCracks::files_of_run(
      dim, parameters.output, !parameters.crack_opening.lines().empty());
    if (!parameters.events.kinds(dim).empty())
      names.insert(names.end(), {"events.csv", "events.csv.part"});
    if (!parameters.traction_profiles.text.empty())
      names.insert(names.end(),
                   {"traction_profiles.csv", "traction_profiles.csv.part"});
    return names;
  }



#define INSTANTIATE(dim)                                                       \
  template RecorderOptions<dim>     recorder_options(const Parameters<dim> &); \
  template RunLogOptions            run_log_options(const Parameters<dim> &);  \
  template ImbalanceRule            imbalance_rule(const Body<dim> &);         \
  template std::vector<std::string> files_of_run(const Parameters<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
