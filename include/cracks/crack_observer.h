// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_crack_observer_h
#define mixed_cracks_cracks_crack_observer_h

#include <base/linear_algebra.h>

#include <cracks/crack_outcome.h>
#include <cracks/crack_sheet.h>

#include <discretization/fields.h>
#include <discretization/state.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// The cracks of a phase field.
  struct TracedCracks
  {
    std::vector<Crack>      paths;   ///< in the plane, on rank 0
    std::vector<CrackSheet> sheets;  ///< in 3-d, on rank 0
    Outcome                 outcome; ///< on rank 0
    /// whether they separate the body, on all ranks
    bool separate_body = false;
  };

  /// In space: the sheets of the cracks, and whether they leave the body in one
  /// part. Boundaries without a name in @p names are "boundary". Collective.
  TracedCracks
  trace_in_space(const Fields<3> &fields,
                 const std::map<dealii::types::boundary_id, std::string> &names,
                 double       length_scale, // l, mm
                 double       front_lag,    // see CrackObserver::reinit()
                 const State &state);

  /// Looks at states of a run for cracks: where they start, their paths or
  /// sheets, and what becomes of the body. It remembers nothing: what it saw is
  /// part of the state it saw it in. Vectors have ghosts. Collective.
  template <int dim>
  class CrackObserver
  {
  public:
    /// @p names: of boundaries, by their ids.
    CrackObserver(const Fields<dim>                                &fields,
                  std::map<dealii::types::boundary_id, std::string> names)
      : fields(fields)
      , names(std::move(names))
    {}

    /// To be called when the mesh changed. @p length_scale: l, mm. @p
    /// front_lag, in l: how far a front in space lies behind the place where
    /// the phase field is 0.5, which its optimal profile says; unless given the
    /// mean of the densities, as for tips in the plane.
    void reinit(double length_scale, double front_lag = 0.6);

    /// Of a state in which slits and initial cracks have their profile. States
    /// without these origins are not looked at, and have no cracks.
    DamageOrigins first_origins(const LinearAlgebra::Vector &phase_field) const;

    /// To be called with every phase field that is predicted within a step:
    /// add to the origins of @p state what is broken in it and was not before.
    void watch(State &state) const;

    TracedCracks trace(const State &state) const;

  private:
    /// Positions of broken nodes of all ranks that @p origins does not know.
    std::vector<dealii::Point<3>>
    newly_broken(const LinearAlgebra::Vector &phase_field,
                 const DamageOrigins         &origins) const;

    std::vector<DamagedCell>
    damaged_cells(const LinearAlgebra::Vector &phase_field) const;

    /// Of all ranks, on rank 0.
    std::vector<BoundaryEdge> boundary_edges() const;

    const Fields<dim>                                &fields;
    std::map<dealii::types::boundary_id, std::string> names;
    double length_scale = 0., front_lag = 0.6;

    std::vector<dealii::Point<3>> positions; // of owned nodes
    std::vector<BoundaryEdge>     edges;     // of the mesh, on rank 0
  };
} // namespace MixedCracks

#endif
