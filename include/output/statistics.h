// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_statistics_h
#define mixed_cracks_output_statistics_h

#include <mpi.h>

#include <array>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// One row of statistics.csv: an accepted step.
  struct StatisticsRow
  {
    unsigned int          step         = 0;
    double                time         = 0.;        ///< s
    double                displacement = 0.;        ///< mm
    std::array<double, 3> force{{0., 0., 0.}};      ///< N, with thickness
    double                elastic_energy      = 0.; ///< mJ
    double                crack_energy        = 0.; ///< mJ
    double                external_work       = 0.; ///< mJ
    double                min_phase_field     = 1.;
    double                phase_field_change  = 0.;
    unsigned int          newton_iterations   = 0;
    unsigned int          linear_iterations   = 0;
    unsigned long         active_set_size     = 0;
    unsigned long         cells               = 0;
    unsigned long         dofs                = 0;
    double                wall_time           = 0.; ///< s
    unsigned int          coupling_iterations = 0;
    double                coupling_change     = 0.;
    unsigned int          factorizations      = 0;
    unsigned int          rejected_steps      = 0;
    unsigned int          refinements         = 0;
    /// mm^3; NaN where it was not asked for
    double crack_volume = std::numeric_limits<double>::quiet_NaN();
    /// mm; components in turn; empty where not asked for
    std::vector<double> point_displacements;
    /// integral of the crack density: in 2-d a length in mm (whatever the
    /// thickness), in 3-d an area in mm^2
    double crack_surface = 0.;

    /// Length of the force vector, N.
    double force_size() const;

    /// External work since @p start less the growth of stored and crack
    /// energy, mJ: what a crack that runs sets free, what a lagged phase field
    /// holds back, and what a pressure law without an energy hides.
    double energy_imbalance(const StatisticsRow &start) const;
  };

  /// What the crack surface is called in statistics.csv and summary.json.
  std::string crack_surface_name(int dim);

  /// statistics.csv: one row per accepted step, flushed as it is written, and
  /// kept for the summary. Rank 0 writes.
  class StatisticsTable
  {
  public:
    explicit StatisticsTable(MPI_Comm communicator);

    /// Open @p file_name anew, with a column for the crack volume where it is
    /// asked for, and then those of displacements at points. Throws FileError.
    /// Collective.
    void open(const std::string              &file_name,
              int                             dim,
              bool                            with_crack_volume = false,
              const std::vector<std::string> &point_columns     = {});

    /// Rows kept by a resumed run, written anew. Collective.
    void restore(const std::vector<StatisticsRow> &earlier);

    /// Throws FileError when the disk is full. Collective.
    void add(const StatisticsRow &row);

    const std::vector<StatisticsRow> &
    rows() const
    {
      return table;
    }

  private:
    const MPI_Comm             communicator;
    int                        dim               = 2;
    bool                       with_crack_volume = false;
    std::size_t                n_point_columns   = 0;
    std::string                name;
    std::ofstream              file;
    std::vector<StatisticsRow> table;
  };
} // namespace MixedCracks

#endif
