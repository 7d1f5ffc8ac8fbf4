// SPDX-License-Identifier: GPL-2.0-or-later
// Rows are what is remembered of events, in a run that goes on as in one that
// is resumed: both know the numbers as they stand in the table, and go on
// alike.

#include <base/collective.h>
#include <base/finite_text.h>
#include <base/log.h>

#include <deal.II/base/mpi.h>

#include <output/event_table.h>

#include <cstdlib>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    // of the row; those of the event follow, and of these the place
    constexpr std::size_t n_fields_of_step = 4, n_before_place = 4;



    std::string
    row_of(const StatisticsRow &row, const CrackEvent &event, const int dim)
    {
      std::string text = std::to_string(row.step());
      for (const double number :
           {row["time"], row["displacement"], row.force_size()})
        text += ',' + csv_number(number);
      text += ',' + event.kind + ',' + csv_number(event.crack_size) + ',' +
              csv_number(event.growth) + ',' + csv_field(event.boundary);
      for (int d = 0; d < dim; ++d)
        text += ',' + (event.place ? csv_number((*event.place)[d]) : "");
      return text + '\n';
    }



    CrackEvent
    event_of(const std::string &line, const int dim)
    {
      std::vector<std::string> fields = csv_fields(line);
      fields.resize(n_fields_of_step + n_before_place + dim);
      const std::string *const of_event = fields.data() + n_fields_of_step;
      const auto               number   = [&of_event](const std::size_t field) {
        return std::strtod(of_event[field].c_str(), nullptr);
      };
      CrackEvent event;
      event.kind       = of_event[0];
      event.crack_size = number(1);
      event.growth     = number(2);
      event.boundary   = of_event[3];
      if (!of_event[n_before_place].empty())
      {
        event.place.emplace();
        for (int d = 0; d < dim; ++d)
          (*event.place)[d] = number(n_before_place + d);
      }
      return event;
    }



    std::string
    place_in_words(const CrackEvent &event, const int dim)
    {
      if (!event.place)
        return "";
      std::string text;
      for (int d = 0; d < dim; ++d)
        text += (d == 0 ? " at (" : ", ") + format("%.6g", (*event.place)[d]);
      return text + ") mm";
    }



    std::string
    in_words(const CrackEvent &event, const int dim)
    {
      const std::string place = place_in_words(event, dim);
      if (event.kind == "onset")
        return "damage begins" + place;
      if (event.kind == "boundary")
        return "a crack meets " + event.boundary + place;
      if (event.kind == "separation")
        return "cracks have separated the body";
      const char *const unit = dim == 2 ? "mm" : "mm^2";
      return format("the cracks have grown by %.6g %s to %.6g %s",
                    event.growth,
                    unit,
                    event.crack_size,
                    unit);
    }
  } // namespace



  std::string
  EventTable::header(const int dim)
  {
    return std::string("step,time_s,displacement_mm,force_N,event,") +
           (dim == 2 ? "crack_length_mm,growth_mm,boundary,x_mm,y_mm\n"
                     : "crack_area_mm2,growth_mm2,boundary,x_mm,y_mm,z_mm\n");
  }



  void
  EventTable::open()
  {
    restore("");
  }



  // Rows of steps behind the checkpoint, which will be computed again, must not
  // stay. A run that watches no events any more keeps those it had.
  void
  EventTable::restore(const std::string &earlier)
  {
    std::istringstream lines(earlier);
    std::string        line;
    std::getline(lines, line); // the header
    while (std::getline(lines, line))
      events.remember(event_of(line, dim));
    if (is_on || !earlier.empty())
      RestoredTable::restore(earlier);
  }



  std::vector<std::string>
  EventTable::add(const StatisticsRow &row,
                  const TracedCracks  &cracks,
                  const DamageOrigins &origins)
  {
    std::vector<std::string> lines;
    if (!is_on)
      return lines;
    std::string text;
    // where the cracks are
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      for (const CrackEvent &event : events.look(cracks, origins))
      {
        const std::string one = row_of(row, event, dim);
        events.remember(event_of(one, dim));
        text += one;
        if (event.kind != "start")
          lines.push_back("  event: " + in_words(event, dim));
      }
    RestoredTable::add(text);
    if (dealii::Utilities::MPI::max(static_cast<int>(lines.size()),
                                    communicator) > 0)
      last_step = row.step();
    return lines;
  }
} // namespace MixedCracks
