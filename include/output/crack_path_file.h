// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_path_file_h
#define mixed_cracks_output_crack_path_file_h

#include <cracks/crack_outcome.h>
#include <cracks/crack_path.h>

#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// The paths of cracks as they grow: DIR/crack_path.csv, a row per point;
  /// DIR/crack_path/crack_path_NNNNNN.vtp, a file per step; and
  /// DIR/crack_path.pvd, which lists them. Only for the rank that writes. The
  /// functions throw FileError.
  class CrackPathFile
  {
  public:
    /// @p tolerance, mm: paths that differ by less from those written last
    /// are not written; a tenth of l is sensible. Writes nothing yet.
    CrackPathFile(const std::string &directory, const double tolerance)
      : directory(directory)
      , csv_name(directory + "/crack_path.csv")
      , pvd_name(directory + "/crack_path.pvd")
      , tolerance(tolerance)
    {}

    /// Begin anew: the header, and an empty list.
    void open();

    /// Write anew what an earlier run has come to, whatever its files hold by
    /// now. @p earlier: its rows(). The next add() is compared with its last
    /// paths.
    void restore(const std::string &earlier);

    /// The header and all rows, without the outcome: for a checkpoint. A step
    /// adds to them only when a crack has moved by the tolerance.
    const std::string &
    rows() const
    {
      return all_rows;
    }

    /// Add the paths of a step, unless they are those written last; opens the
    /// file when that was not done. Without cracks there is nothing to write.
    void add(unsigned int              step,
             double                    time,         // s
             double                    displacement, // mm
             const std::vector<Crack> &cracks);

    /// Add the line "# outcome: <path>; start: <start>".
    void finish(const Outcome &outcome);

  private:
    using Cracks = std::vector<Crack>;

    bool differs(const std::vector<Crack> &cracks) const;
    void write_vtp(unsigned int step, const std::vector<Crack> &cracks) const;
    void write_table_and_list() const;
    void write_pvd() const;
    void take_row(const std::vector<std::string> &columns);
    void restore_vtp() const;

    const std::string directory, csv_name, pvd_name;
    const double      tolerance;
    bool              is_open = false;
    std::string       all_rows;
    Cracks            last; ///< written
    /// step and time, s
    std::vector<std::pair<unsigned int, double>> steps;
  };
} // namespace MixedCracks

#endif
