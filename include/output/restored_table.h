// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_restored_table_h
#define mixed_cracks_output_restored_table_h

#include <mpi.h>

#include <string>

namespace MixedCracks
{
  /// A CSV file that grows step by step and that a continued run has whole: its
  /// rows are in the checkpoint. Rank 0 writes; throws FileError on all ranks.
  /// Collective.
  class RestoredTable
  {
  public:
    /// @p header: the first line, with its end; empty: there is no file.
    RestoredTable(const std::string &name,
                  const std::string &header,
                  const MPI_Comm     communicator)
      : communicator(communicator)
      , name(name)
      , header(header)
    {}

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

    /// Lines with their ends, if any, which rank 0 needs.
    void add(const std::string &lines);

  protected:
    const MPI_Comm communicator;

  private:
    void write(const std::string &content, bool append) const;

    const std::string name;
    const std::string header;
    std::string       all_rows;
  };
} // namespace MixedCracks

#endif
