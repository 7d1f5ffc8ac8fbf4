// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_mesh_adaptation_h
#define mixed_cracks_simulation_mesh_adaptation_h

#include <base/stop_request.h>

#include <discretization/adaptation.h>
#include <discretization/state.h>

#include <simulation/body.h>

namespace MixedCracks
{
  /// Finer cells where cracks are predicted, as subsection "Mesh" wants them.
  template <int dim>
  class MeshAdaptation
  {
  public:
    explicit MeshAdaptation(Body<dim> &body)
      : body(body)
    {}

    /// Whether the phase field of a trial damages cells that are to be finer.
    bool needs_finer_mesh(const State &trial) const;

    /// The first mesh, on which the initial phase field is set anew as often
    /// as it changes. @p ask_to_stop may throw.
    void refine_first_mesh(const std::function<void()> &ask_to_stop);

    /// Refine where the @p trial damages coarse cells. The states, of which
    /// the trial is one, are carried over, but for their reactions; those that
    /// hold nothing are left alone.
    void refine(const State &trial, const std::vector<State *> &states);

  private:
    AdaptationRule rule(bool in_load_step) const;

    Body<dim> &body;
  };
} // namespace MixedCracks

#endif
