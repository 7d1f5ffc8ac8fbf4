// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_opening_file_h
#define mixed_cracks_output_crack_opening_file_h

#include <output/crack_opening_parameters.h>
#include <output/restored_table.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// DIR/crack_opening.csv: a row per accepted step and position on the lines
  /// of Output/Crack opening; without lines there is no file. Rank 0 writes;
  /// throws FileError on all of them. Collective.
  template <int dim>
  class CrackOpeningFile : public RestoredTable
  {
  public:
    CrackOpeningFile(const std::string                   &directory,
                     const std::vector<OpeningLine<dim>> &lines,
                     MPI_Comm                             communicator);



    /// @p openings: mm, one line after the other.
    void add(unsigned int               step,
             double                     time, // s
             const std::vector<double> &openings);

  private:
    const std::vector<OpeningLine<dim>> lines;
  };
} // namespace MixedCracks

#endif
