// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_path_writer_h
#define mixed_cracks_output_crack_path_writer_h

#include <output/crack_path_file.h>

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// Writes the paths of cracks of a run in the plane; in 3-d it does nothing.
  /// Rank 0 writes; throws FileError on all ranks. Collective.
  template <int dim>
  class CrackPathWriter
  {
  public:
    CrackPathWriter(const std::string &directory, const MPI_Comm communicator)
      : directory(directory)
      , communicator(communicator)
    {}

    /// Begin anew. @p length_scale: l, mm; paths that move by less than a
    /// tenth of it are not written again.
    void open(double length_scale);

    /// Write anew what an earlier run has come to. @p earlier: its rows(),
    /// which rank 0 needs.
    void restore(double length_scale, const std::string &earlier);

    /// crack_path.csv as it is so far; empty on other ranks than 0, and in 3-d.
    std::string
    rows() const
    {
      return file ? file->rows() : "";
    }

    /// Those of an accepted step, which rank 0 knows.
    void add(unsigned int              step,
             double                    time,         // s
             double                    displacement, // mm
             const std::vector<Crack> &cracks);

    /// At the end.
    void finish(const Outcome &outcome);

  private:
    void make_file(double length_scale);

    const std::string              directory;
    const MPI_Comm                 communicator;
    std::unique_ptr<CrackPathFile> file; // on rank 0
  };
} // namespace MixedCracks

#endif
