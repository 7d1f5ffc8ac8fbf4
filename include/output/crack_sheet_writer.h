// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_sheet_writer_h
#define mixed_cracks_output_crack_sheet_writer_h

#include <base/linear_algebra.h>

#include <discretization/fields.h>

#include <output/crack_sheet_file.h>

#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// Writes the cracks of a run in space, with the speed of their fronts and
  /// how far they are open there; in the plane it does nothing. Rank 0 writes;
  /// throws FileError on all ranks. Collective.
  template <int dim>
  class CrackSheetWriter
  {
  public:
    CrackSheetWriter(const std::string &directory, const Fields<dim> &fields)
      : directory(directory)
      , fields(fields)
    {}

    /// Begin anew. @p length_scale: l, mm; cracks whose fronts move by less
    /// than a tenth of it are not written again.
    void open(double length_scale);

    /// Write anew what an earlier run has come to, its rows, which rank 0
    /// needs.
    void restore(double             length_scale,
                 const std::string &sheets,
                 const std::string &fronts);

    /// crack_sheet.csv as it is so far; empty on other ranks than 0, and in the
    /// plane.
    std::string
    sheet_rows() const
    {
      return file ? file->sheet_rows() : "";
    }

    /// Likewise crack_front.csv.
    std::string
    front_rows() const
    {
      return file ? file->front_rows() : "";
    }

    /// The fronts from which the next step counts the way of its own.
    void
    remember(const double time, const std::vector<CrackSheet> &sheets)
    {
      earlier_time   = time;
      earlier_fronts = all_fronts(sheets);
    }

    /// Those of an accepted step, which rank 0 knows. @p elastic with ghosts.
    void add(unsigned int                   step,
             double                         time,         // s
             double                         displacement, // mm
             const std::vector<CrackSheet> &sheets,
             const LinearAlgebra::Vector   &elastic);

    /// At the end.
    void finish(const Outcome &outcome);

  private:
    void make_file(double length);

    const std::string               directory;
    const Fields<dim>              &fields;
    double                          length_scale = 0.; // mm
    std::unique_ptr<CrackSheetFile> file;              // on rank 0
    double                          earlier_time = 0.; // s
    std::vector<CrackFront>         earlier_fronts;    // of the last step
  };
} // namespace MixedCracks

#endif
