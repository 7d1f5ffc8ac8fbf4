// SPDX-License-Identifier: GPL-2.0-or-later
// summary.json: everything follows from the rows and from Summary, so that a
// resumed run that has nothing left to do comes to the same results. Peak: the
// largest |F| of all rows, the first of equal ones; the last row is left out
// when its load was not carried, as a load that nothing resists is no strength.
//
// JSON has no NaN and no infinity: such numbers are null.

#include <base/finite_text.h>

#include <output/disk.h>
#include <output/quantities.h>
#include <output/summary.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    // "key": value lines in the order they are added
    class JsonObject
    {
    public:
      void
      add(const std::string &key, const std::string &value)
      {
        raw(key, json_string(value));
      }

      void
      add(const std::string &key, const double value)
      {
        raw(key, json_number(value));
      }

      void
      raw(const std::string &key, const std::string &value)
      {
        text +=
          (text.empty() ? "  " : ",\n  ") + json_string(key) + ": " + value;
      }

      std::string
      str() const
      {
        return "{\n" + text + "\n}";
      }

    private:
      std::string text;
    };



    // those that the list has for that place
    void
    add_quantities(JsonObject                       &json,
                   const Quantity::InSummary         place,
                   const Summary                    &summary,
                   const std::vector<StatisticsRow> &rows)
    {
      for (const Quantity &quantity : all_quantities())
      {
        if (quantity.summary != place ||
            !quantity.has_column(summary.dimension, summary.asked))
          continue;
        double value = value_of(quantity, rows.back(), rows.front());
        if (place == Quantity::InSummary::total)
        {
          value = 0.;
          for (const StatisticsRow &row : rows)
            value += value_of(quantity, row, rows.front());
        }
        // what is only asked for may be unknown
        if (quantity.entry.empty() || std::isfinite(value))
          json.add(quantity.column(summary.dimension), value);
      }
    }



    void
    add_rows(JsonObject                       &json,
             const Summary                    &summary,
             const std::vector<StatisticsRow> &rows)
    {
      if (rows.empty())
        return;
      const StatisticsRow &peak =
        rows[peak_row(rows, summary.without_equilibrium)];
      const StatisticsRow &last = rows.back();
      json.add("steps", last.step());
      json.add("peak_force_N", peak.force_size());
      json.add("displacement_at_peak_mm", peak["displacement"]);
      json.add("time_at_peak_s", peak["time"]);
      json.add("step_at_peak", peak.step());
      json.add("remaining_force_fraction",
               peak.force_size() > 0. ? last.force_size() / peak.force_size()
                                      : 0.);
      json.add("end_displacement_mm", last["displacement"]);
      add_quantities(json, Quantity::InSummary::size, summary, rows);
      add_quantities(json, Quantity::InSummary::total, summary, rows);
      add_quantities(json, Quantity::InSummary::result, summary, rows);
    }
    // What a table in CSV has, but for fields that are empty: an object for
    // each row, with the names of the columns.
    std::string
    events_in_json(const std::string &table)
    {
      std::istringstream lines(table);
      std::string        line, all;
      std::getline(lines, line);
      const std::vector<std::string> columns = csv_fields(line);
      while (std::getline(lines, line))
      {
        const std::vector<std::string> fields = csv_fields(line);
        std::string                    object;
        for (std::size_t i = 0; i < std::min(columns.size(), fields.size());
             ++i)
          if (!fields[i].empty())
          {
            const bool is_text =
              columns[i] == "event" || columns[i] == "boundary";
            object += (object.empty() ? "" : ", ") + json_string(columns[i]) +
                      ": " + (is_text ? json_string(fields[i]) : fields[i]);
          }
        all += (all.empty() ? "\n    {" : ",\n    {") + object + '}';
      }
      return '[' + all + ']';
    }
  } // namespace



  std::size_t
  peak_row(const std::vector<StatisticsRow> &rows,
           const bool                        without_equilibrium)
  {
    const auto end =
      without_equilibrium && rows.size() > 1 ? rows.end() - 1 : rows.end();
    const auto largest = std::max_element(
      rows.begin(), end, [](const StatisticsRow &a, const StatisticsRow &b) {
        return a.force_size() < b.force_size();
      });
    return static_cast<std::size_t>(std::distance(rows.begin(), largest));
  }



  std::string
  write_summary(const std::string                &file_name,
                const Summary                    &summary,
                const std::vector<StatisticsRow> &rows,
                const std::string                &events)
  {
    JsonObject json;
    json.add("program", std::string("mixed-cracks"));
    json.add("version", summary.version);
    json.add("revision", summary.revision);
    json.add("deal_ii_version", summary.deal_ii_version);
    json.add("case", summary.case_in_words);
    json.add("formulation", summary.formulation);
    json.add("kinematics", summary.kinematics);
    json.add("pressure_law", summary.pressure_law);
    json.add("coupling", summary.coupling);
    json.add("linear_solver", summary.linear_solver);
    json.add("ranks", summary.ranks);
    json.add("finest_cell_mm", summary.cell_size);
    json.add("length_scale_mm", summary.length_scale);
    json.add("residual_stiffness", summary.residual_stiffness);
    json.add("thickness_mm", summary.thickness);
    add_rows(json, summary, rows);
    json.raw("separated",
             !summary.separated   ? "null"
             : *summary.separated ? "true"
                                  : "false");
    json.raw("force_fell", summary.force_fell ? "true" : "false");
    json.add("outcome", path_in_words(summary.cracks));
    json.add("outcome_start", summary.cracks.start);
    json.add("exit_reason", summary.exit_reason);
    json.add("exit_status", summary.exit_status);
    json.add("rejected_steps", summary.rejected_steps);
    json.add("factorizations", summary.factorizations);
    json.add("wall_time_s", summary.wall_time);
    JsonObject phases;
    for (const auto &[name, seconds] : summary.phases)
      phases.add(name, seconds);
    json.raw("seconds_per_phase", summary.phases.empty() ? "{}" : phases.str());
    if (!events.empty())
      json.raw("events", events_in_json(events));
    std::string warnings;
    for (const std::string &warning : summary.warnings)
      warnings += (warnings.empty() ? "" : ", ") + json_string(warning);
    json.raw("warnings", "[" + warnings + "]");

    // a reader never sees half of it
    const std::string problem = write_durably(file_name, json.str() + '\n');
    return problem.empty()
             ? ""
             : "Output/Directory: the summary cannot be written: " + problem +
                 '.';
  }
} // namespace MixedCracks
