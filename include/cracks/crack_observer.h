// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_crack_observer_h
#define mixed_cracks_cracks_crack_observer_h

#include <base/linear_algebra.h>

#include <cracks/crack_outcome.h>
#include <cracks/damage_origins.h>

#include <discretization/fields.h>

#include <map>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// The cracks of a phase field.
  struct TracedCracks
  {
    std::vector<Crack> paths;   ///< on rank 0; empty elsewhere, and in 3-d
    Outcome            outcome; ///< on rank 0; "not traced" in 3-d
    /// whether they separate the body, on all ranks; never in 3-d
    bool separate_body = false;
  };

  /// Watches the phase field of a run in the plane for cracks: where they
  /// start, their paths, and what becomes of the body. In 3-d it does
  /// nothing, and the outcome is "not traced". Vectors have ghosts. Collective.
  template <int dim>
  class CrackObserver
  {
  public:
    CrackObserver(
      const Fields<dim>                                       &fields,
      const std::map<std::string, dealii::types::boundary_id> &names);

    /// To be called when the mesh changed.
    void reinit();

    /// The phase field after slits and initial cracks have their profile.
    /// Before this, no cracks are found. @p length_scale: l, mm.
    void start(double length_scale, const LinearAlgebra::Vector &phase_field);

    /// Go on with a run. @p nuclei: those of its origins().
    void resume(double                               length_scale,
                const std::vector<dealii::Point<2>> &nuclei,
                const LinearAlgebra::Vector         &phase_field);

    /// A phase field that is predicted within a step.
    void watch(const LinearAlgebra::Vector &phase_field);

    /// To take back what was watched since.
    const DamageOrigins &
    origins() const
    {
      return damage_origins;
    }

    void take_back(const DamageOrigins &earlier);

    TracedCracks trace(const LinearAlgebra::Vector &phase_field) const;

  private:
    /// Positions of broken nodes of all ranks not reported since reinit().
    std::vector<dealii::Point<2>>
    newly_broken(const LinearAlgebra::Vector &phase_field);

    std::vector<DamagedCell>
    damaged_cells(const LinearAlgebra::Vector &phase_field) const;

    std::vector<BoundaryEdge> boundary_edges() const;

    const Fields<dim>                                &fields;
    std::map<dealii::types::boundary_id, std::string> names;
    double                                            length_scale = 0.;
    DamageOrigins                                     damage_origins;

    // owned nodes of the phase field, and whether they were reported
    std::vector<dealii::Point<dim>> positions;
    std::vector<bool>               reported;
  };
} // namespace MixedCracks

#endif
