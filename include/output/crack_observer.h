// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_observer_h
#define mixed_cracks_output_crack_observer_h

#include <core/linear_algebra.h>

#include <discretization/fields.h>

#include <output/crack_path_file.h>
#include <output/damage_origins.h>

#include <map>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// Watches the phase field of a run in the plane for cracks: where they
  /// start, their paths per step, and what becomes of the body. In 3-d it does
  /// nothing, and the outcome is "not traced". Vectors have ghosts. Collective.
  template <int dim>
  class CrackObserver
  {
  public:
    CrackObserver(
      const Fields<dim>                                       &fields,
      const std::map<std::string, dealii::types::boundary_id> &names,
      const std::string                                       &directory);

    /// @p length_scale: l, mm. Throws FileError.
    void open(double length_scale);

    /// Go on with a run, whose files are written anew. @p earlier_rows: its
    /// path_rows(), which rank 0 needs. Throws FileError.
    void resume(double                               length_scale,
                const std::string                   &earlier_rows,
                const std::vector<dealii::Point<2>> &nuclei,
                const LinearAlgebra::Vector         &phase_field);

    /// To be called when the mesh changed.
    void reinit();

    /// The phase field after slits and initial cracks have their profile.
    void start(const LinearAlgebra::Vector &phase_field);

    /// A phase field that is predicted within a step.
    void watch(const LinearAlgebra::Vector &phase_field);

    /// To take back what was watched since.
    const DamageOrigins &
    origins() const
    {
      return damage_origins;
    }

    void take_back(const DamageOrigins &earlier);

    /// crack_path.csv as it is so far; empty on other ranks than 0, and in 3-d.
    std::string
    path_rows() const
    {
      return file ? file->rows() : "";
    }

    /// Write the paths of an accepted step; true when they separate the body.
    /// Throws FileError.
    bool record(unsigned int                 step,
                double                       time,         // s
                double                       displacement, // mm
                const LinearAlgebra::Vector &phase_field);

    /// Whether the paths of this phase field would separate the body; never
    /// in 3-d.
    bool joins_sides(const LinearAlgebra::Vector &phase_field) const;

    /// At the end. Throws FileError.
    Outcome finish(const LinearAlgebra::Vector &phase_field);

  private:
    /// Positions of broken nodes of all ranks not reported since reinit().
    std::vector<dealii::Point<2>>
    newly_broken(const LinearAlgebra::Vector &phase_field);

    /// On rank 0; empty elsewhere.
    std::vector<Crack> trace(const LinearAlgebra::Vector     &phase_field,
                             const std::vector<BoundaryEdge> &edges) const;

    std::vector<DamagedCell>
    damaged_cells(const LinearAlgebra::Vector &phase_field) const;

    std::vector<BoundaryEdge> boundary_edges() const;

    const Fields<dim>                                &fields;
    std::map<dealii::types::boundary_id, std::string> names;
    const std::string                                 directory;
    double                                            length_scale = 0.;
    DamageOrigins                                     damage_origins;
    std::unique_ptr<CrackPathFile>                    file;

    // owned nodes of the phase field, and whether they were reported
    std::vector<dealii::Point<dim>> positions;
    std::vector<bool>               reported;
  };
} // namespace MixedCracks

#endif
