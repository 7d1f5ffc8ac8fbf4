// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_event_table_h
#define mixed_cracks_output_event_table_h

#include <cracks/crack_events.h>

#include <output/event_parameters.h>
#include <output/restored_table.h>
#include <output/statistics.h>

#include <mpi.h>

#include <optional>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// DIR/events.csv: a row for each event of Output/Events; there is no file
  /// without. Rank 0 writes; throws FileError on all of them. Collective.
  class EventTable : public RestoredTable
  {
  public:
    EventTable(const std::string     &directory,
               const int              dim,
               const EventParameters &parameters,
               const MPI_Comm         communicator)
      : RestoredTable(directory + "/events.csv", header(dim), communicator)
      , dim(dim)
      , is_on(!parameters.kinds(dim).empty())
      , events(dim, parameters.kinds(dim), parameters.size_step(dim))
    {}

    /// Begin anew.
    void open();

    /// Write anew what an earlier run has come to, whatever its file holds by
    /// now, and go on from there. @p earlier: its rows().
    void restore(const std::string &earlier);

    /// Look at the cracks of an accepted step. Returns lines for the log, on
    /// rank 0.
    std::vector<std::string> add(const StatisticsRow &row,
                                 const TracedCracks  &cracks,
                                 const DamageOrigins &origins);

    /// Whether there was an event in the step that was added last.
    bool
    is_of_event(const unsigned int step) const
    {
      return last_step == step;
    }

  private:
    static std::string header(int dim);

    const int                   dim;
    const bool                  is_on;
    CrackEvents                 events;
    std::optional<unsigned int> last_step; // with an event but the start
  };
} // namespace MixedCracks

#endif
