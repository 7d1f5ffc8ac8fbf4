// SPDX-License-Identifier: GPL-2.0-or-later
// RunRecord as text, by TextWriter: values in the order of members(), 17
// significant digits, which give every double back to the bit. Text rather than
// bytes, so that order of bytes and sizes of types do not matter and a person
// can look; a few hundred bytes per load step.

#include <output/quantities.h>
#include <output/run_record.h>
#include <output/text_archive.h>

#include <cmath>
#include <functional>

namespace MixedCracks
{
  // Values of a row in the order of the list, but for the crack volume and the
  // displacements at points, which the format has before the size of the
  // cracks.
  template <typename Row, IfIs<Row, StatisticsRow> = 0>
  static auto
  members(Row &row)
  {
    std::vector<decltype(row.values.data())> before, behind;
    bool is_old = true; // as old as the format
    for (std::size_t i = 0; i < row.values.size(); ++i)
    {
      const Quantity &quantity = all_quantities()[i];
      if (quantity.is_kept())
        (is_old && quantity.name != "crack_length" ? before : behind)
          .push_back(&row.values[i]);
      is_old = is_old && quantity.name != "crack_volume";
    }
    return std::make_tuple(before,
                           std::ref(row.point_displacements),
                           behind,
                           std::ref(row.reactions));
  }



  MIXED_CRACKS_MEMBERS(RunTotals,
                       factorizations,
                       solves,
                       rejected_steps,
                       wall_time,
                       phases)

  MIXED_CRACKS_MEMBERS(RunRecord,
                       signature,
                       attempt,
                       end,
                       why_failed,
                       cell_size,
                       time,
                       time_step,
                       next_step,
                       peak_force,
                       external_work,
                       peak_step,
                       steps_to_wait,
                       n_refinements,
                       n_overlapping_steps,
                       deepest_overlap,
                       overlap_in_words,
                       changed_loads,
                       totals,
                       rows,
                       field_files,
                       tables)



  namespace
  {
    void
    require(const bool condition, const std::string &what)
    {
      if (!condition)
        throw FileError(what);
    }



    // What the rest of the program relies on without asking: rows 0, 1, 2, ...
    // without a gap, the row of the peak among them, times and steps that can
    // be continued.
    void
    check(const RunRecord &record)
    {
      require(!record.rows.empty(), "it has no load steps");
      for (std::size_t i = 0; i < record.rows.size(); ++i)
        require(record.rows[i]["step"] == i, "load steps are missing");
      require(std::isfinite(record.time) && record.time >= 0. &&
                std::isfinite(record.time_step) &&
                std::isfinite(record.next_step) && record.next_step > 0. &&
                std::isfinite(record.peak_force) &&
                std::isfinite(record.external_work) &&
                std::isfinite(record.cell_size) && record.cell_size > 0.,
              "its times, steps or forces are none");
      require(record.peak_step < record.rows.size(),
              "its peak is at a step that is missing");
      require(record.end >= RunEnd::none && record.end <= RunEnd::refused,
              "it ends for a reason that is none");
    }
  } // namespace



  void
  write_record(std::ostream &out, const RunRecord &record)
  {
    TextWriter writer(out);
    writer(record);
  }



  RunRecord
  read_record(std::istream &in)
  {
    RunRecord  record;
    TextReader reader(in);
    reader(record);
    check(record);
    return record;
  }
} // namespace MixedCracks
