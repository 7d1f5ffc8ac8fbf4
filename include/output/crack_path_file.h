// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_path_file_h
#define mixed_cracks_output_crack_path_file_h

#include <output/crack_outcome.h>
#include <output/crack_path.h>

#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// The paths of cracks as they grow: DIR/crack_path.csv, a row per point;
  /// DIR/crack_path/crack_path_NNNNNN.vtp, a file per step; and
  /// DIR/crack_path.pvd, which lists them. Only for the rank that writes. The
  /// functions return what went wrong, for a person; empty when all is well.
  class CrackPathFile
  {
  public:
    /// @p tolerance, mm: paths that differ by less from those written last
    /// are not written; a tenth of l is sensible. Writes nothing yet.
    CrackPathFile(const std::string &directory, double tolerance);

    /// Begin anew: the header, and an empty list.
    std::string open();

    /// Go on with the files of an earlier run: keep the steps up to
    /// @p last_step, drop later ones and the outcome. Begins anew when there
    /// is no file. The next add() is compared with what was written last.
    std::string restore(unsigned int last_step);

    /// Add the paths of a step, unless they are those written last; opens the
    /// file when that was not done. Without cracks there is nothing to write.
    std::string add(unsigned int              step,
                    double                    time,         // s
                    double                    displacement, // mm
                    const std::vector<Crack> &cracks);

    /// Add the line "# outcome: <path>; start: <start>".
    std::string finish(const Outcome &outcome);

  private:
    using Paths = std::vector<std::vector<dealii::Point<2>>>;

    bool        differs(const std::vector<Crack> &cracks) const;
    std::string append(const std::string &text) const;
    std::string write_vtp(unsigned int              step,
                          const std::vector<Crack> &cracks) const;
    std::string write_pvd() const;
    std::string failure(const std::string &name) const;
    void        take_row(const std::string &row);

    const std::string directory, csv_name, pvd_name;
    const double      tolerance;
    bool              is_open = false;
    Paths             last; ///< written
    /// step and time, s
    std::vector<std::pair<unsigned int, double>> steps;
  };
} // namespace MixedCracks

#endif
