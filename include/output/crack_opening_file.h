// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_opening_file_h
#define mixed_cracks_output_crack_opening_file_h

#include <output/crack_opening_parameters.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// DIR/crack_opening.csv: a row per accepted step and position on the lines
  /// of Output/Crack opening; without lines there is no file. Rank 0 writes;
  /// throws FileError on all of them. Collective.
  template <int dim>
  class CrackOpeningFile
  {
  public:
    CrackOpeningFile(const std::string                   &directory,
                     const std::vector<OpeningLine<dim>> &lines,
                     MPI_Comm                             communicator);

    /// Begin anew.
    void open();

    /// Write anew what an earlier run has come to, whatever its file holds by
    /// now. @p earlier: its rows(), which rank 0 needs.
    void restore(const std::string &earlier);

    /// The header and all rows, for a checkpoint; empty on other ranks than 0
    /// and where there is no file.
    const std::string &
    rows() const
    {
      return all_rows;
    }

    /// @p openings: mm, one line after the other.
    void add(unsigned int               step,
             double                     time, // s
             const std::vector<double> &openings);

  private:
    void write(const std::string &content, bool append) const;

    const std::string                   name;
    const std::vector<OpeningLine<dim>> lines;
    const MPI_Comm                      communicator;
    std::string                         all_rows;
  };
} // namespace MixedCracks

#endif
