// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_summary_h
#define mixed_cracks_output_summary_h

#include <cracks/crack_outcome.h>

#include <output/run_totals.h>
#include <output/statistics.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// summary.json: what a run came to.
  struct Summary
  {
    std::string  version, revision, deal_ii_version;
    std::string  case_in_words;
    std::string  coupling, pressure_law, formulation, kinematics, linear_solver;
    unsigned int ranks        = 1;
    double       length_scale = 0., cell_size = 0.; ///< mm
    double       residual_stiffness = 0.;
    double       thickness          = 1.; ///< mm
    /// what the cracks say; nothing where they are not traced
    std::optional<bool> separated;
    /// below Load stepping/Stop when force falls below, at the end
    bool force_fell = false;
    /// RunEnd::no_equilibrium: the load of the last row was not carried
    bool                     without_equilibrium = false;
    std::vector<std::string> asked; ///< entries that ask for more quantities
    int                      dimension = 2;
    Outcome                  cracks;
    std::string              exit_reason;
    int                      exit_status = 0;
    RunTotals                cost; ///< of all pieces
    /// MB of all ranks together in each phase of this piece, and at most
    std::map<std::string, double> memory;
    double                        peak_memory = 0.;
    std::vector<std::string>      warnings;
  };

  /// Write it with the peak that @p rows show, and with the events of a table
  /// in CSV, where there are some. Called on one rank. Throws FileError.
  void write_summary(const std::string                &file_name,
                     const Summary                    &summary,
                     const std::vector<StatisticsRow> &rows,
                     const std::string                &events = "");

  /// Index of the row with the largest force; @p without_equilibrium: of those
  /// but the last, whose force is a load that was not carried.
  std::size_t peak_row(const std::vector<StatisticsRow> &rows,
                       bool                              without_equilibrium);
} // namespace MixedCracks

#endif
