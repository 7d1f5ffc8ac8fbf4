// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_sheet_file_h
#define mixed_cracks_output_crack_sheet_file_h

#include <cracks/crack_outcome.h>
#include <cracks/crack_sheet.h>

#include <output/crack_front_rows.h>

#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// The cracks in space as they grow: DIR/crack_sheet.csv, a row per crack;
  /// DIR/crack_front.csv, a row per point of a front; for each step
  /// DIR/crack_sheet/crack_sheet_NNNNNN.vtp, the triangles, and
  /// DIR/crack_front/crack_front_NNNNNN.vtp, the lines; and crack_sheet.pvd and
  /// crack_front.pvd, which list them. Only for the rank that writes. The
  /// functions throw FileError.
  class CrackSheetFile
  {
  public:
    /// @p tolerance, mm: cracks whose fronts have moved by less since they were
    /// written last are not written; a tenth of l is sensible.
    CrackSheetFile(const std::string &directory, const double tolerance)
      : directory(directory)
      , tolerance(tolerance)
    {}

    /// Begin anew: the headers, and empty lists.
    void open();

    /// Write anew what an earlier run has come to, @p sheets and @p fronts
    /// being its rows. Files of lines are written where they are missing;
    /// triangles are not kept, and the list has those files of them that are
    /// there.
    void restore(const std::string &sheets, const std::string &fronts);

    /// The headers and all rows, for a checkpoint.
    const std::string &
    sheet_rows() const
    {
      return all_sheets;
    }

    const std::string &
    front_rows() const
    {
      return all_fronts;
    }

    /// Whether they differ from those written last. Without cracks there is
    /// nothing to write.
    bool differs(const std::vector<CrackSheet> &sheets) const;

    /// Add those of a step. @p fronts: all of their points.
    void add(unsigned int                   step,
             double                         time,         // s
             double                         displacement, // mm
             const std::vector<CrackSheet> &sheets,
             const std::vector<FrontRow>   &fronts);

    /// Add the line "# outcome: <path>; start: <start>; joins: <names>".
    void finish(const Outcome &outcome) const;

  private:
    using Steps = std::vector<std::pair<unsigned int, double>>; // time, s

    void restore_front_files();
    void write_lists() const;

    const std::string       directory;
    const double            tolerance; // mm
    std::string             all_sheets, all_fronts;
    Steps                   steps, steps_with_sheets;
    std::vector<CrackFront> last_fronts; // written
    std::vector<double>     last_areas;  // mm^2
  };
} // namespace MixedCracks

#endif
