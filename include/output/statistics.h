// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_statistics_h
#define mixed_cracks_output_statistics_h

#include <output/statistics_row.h>

#include <mpi.h>

#include <fstream>
#include <string>
#include <vector>

namespace MixedCracks
{
  struct Quantity;

  /// statistics.csv: one row per accepted step, flushed as it is written, and
  /// kept for the summary. Rank 0 writes.
  class StatisticsTable
  {
  public:
    explicit StatisticsTable(const MPI_Comm communicator)
      : communicator(communicator)
    {}

    /// Open @p file_name anew, with a column for each quantity, those that the
    /// entries @p asked of the .prm ask for included, and then those of
    /// displacements and of reactions at points. Throws FileError. Collective.
    void open(const std::string              &file_name,
              int                             dim,
              const std::vector<std::string> &asked            = {},
              const std::vector<std::string> &point_columns    = {},
              const std::vector<std::string> &reaction_columns = {});

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
    std::string line(const StatisticsRow &row) const;

    const MPI_Comm                communicator;
    std::vector<const Quantity *> columns;
    std::size_t                   n_point_columns    = 0;
    std::size_t                   n_reaction_columns = 0;
    std::string                   name;
    std::ofstream                 file;
    std::vector<StatisticsRow>    table;
  };
} // namespace MixedCracks

#endif
