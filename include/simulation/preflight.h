// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_preflight_h
#define mixed_cracks_simulation_preflight_h

#include <base/log.h>

#include <discretization/slit_faces.h>

#include <simulation/body.h>
#include <simulation/simulation_plausibility.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// What is known of a case before its first step, said in the log: sizes,
  /// material, solver, memory, and what cannot mean what a user wants.
  template <int dim>
  class Preflight
  {
  public:
    Preflight(const Body<dim> &body, Log &log)
      : body(body)
      , log(log)
    {}

    /// Say it. @p slits: of the coarse mesh. @p earlier: warnings of the pieces
    /// of the run that it goes on from.
    void report(const std::vector<SlitFace<dim>> &slits,
                const std::vector<std::string>   &earlier);

    /// What `--check` has not looked at.
    void report_not_checked() const;

    /// One line: geometry and model.
    std::string case_in_words() const;

    /// Sentences, after report().
    const std::vector<std::string> &
    warnings() const
    {
      return found;
    }

  private:
    void report_sizes() const;
    void report_mesh_of_file() const;
    void report_material_and_costs() const;
    void report_periodic_sides() const;

    void report_slits(const std::vector<SlitFace<dim>> &slits) const;
    void find_warnings();
    void warn_of_model();

    /// What an even bar bears, of rubber at finite strain where it can be told.
    ImpliedStrength strength() const;

    bool is_even_rubber() const;

    std::string kinematics() const;

    const Body<dim>         &body;
    Log                     &log;
    std::vector<std::string> found;
  };
} // namespace MixedCracks

#endif
