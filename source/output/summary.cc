// SPDX-License-Identifier: GPL-2.0-or-later
// summary.json: everything follows from the rows and from Summary, so that a
// resumed run that has nothing left to do comes to the same results. Peak: the
// largest |F| of all rows, the first of equal ones; the last row is left out
// when its load was not carried, as a load that nothing resists is no strength.
//
// JSON has no NaN and no infinity: such numbers are null.

#include <base/errors.h>
#include <base/finite_text.h>

#include <output/disk.h>
#include <output/quantities.h>
#include <output/summary.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    // in the order in which keys are set
    using Json = nlohmann::ordered_json;

    // with ten digits, whole numbers without a point; null where it is not
    // finite, which JSON cannot say
    Json
    number(const double value)
    {
      const std::string text = csv_number(value);
      return text.empty() ? Json() : Json::parse(text);
    }



    // those that the list has for that place
    void
    add_quantities(Json                             &json,
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
          json[quantity.column(summary.dimension)] = number(value);
      }
    }



    void
    add_rows(Json                             &json,
             const Summary                    &summary,
             const std::vector<StatisticsRow> &rows)
    {
      if (rows.empty())
        return;
      const StatisticsRow &peak =
        rows[peak_row(rows, summary.without_equilibrium)];
      const StatisticsRow &last        = rows.back();
      json["steps"]                    = last.step();
      json["peak_force_N"]             = number(peak.force_size());
      json["displacement_at_peak_mm"]  = number(peak["displacement"]);
      json["time_at_peak_s"]           = number(peak["time"]);
      json["step_at_peak"]             = peak.step();
      json["remaining_force_fraction"] = number(
        peak.force_size() > 0. ? last.force_size() / peak.force_size() : 0.);
      json["end_displacement_mm"] = number(last["displacement"]);
      add_quantities(json, Quantity::InSummary::size, summary, rows);
      add_quantities(json, Quantity::InSummary::total, summary, rows);
      add_quantities(json, Quantity::InSummary::result, summary, rows);
    }



    // What a table in CSV has, but for fields that are empty: an object for
    // each row, with the names of the columns.
    Json
    events_in_json(const std::string &table)
    {
      std::istringstream lines(table);
      std::string        line;
      std::getline(lines, line);
      const std::vector<std::string> columns = csv_fields(line);
      Json                           all     = Json::array();
      while (std::getline(lines, line))
      {
        const std::vector<std::string> fields = csv_fields(line);
        Json                           row    = Json::object();
        for (std::size_t i = 0; i < std::min(columns.size(), fields.size());
             ++i)
          if (fields[i].empty())
            continue;
          else if (columns[i] == "event" || columns[i] == "boundary")
            row[columns[i]] = fields[i];
          else
            row[columns[i]] = Json::parse(fields[i]);
        all.push_back(row);
      }
      return all;
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



  void
  write_summary(const std::string                &file_name,
                const Summary                    &summary,
                const std::vector<StatisticsRow> &rows,
                const std::string                &events)
  {
    Json json;
    json["program"]            = "mixed-cracks";
    json["version"]            = summary.version;
    json["revision"]           = summary.revision;
    json["deal_ii_version"]    = summary.deal_ii_version;
    json["case"]               = summary.case_in_words;
    json["formulation"]        = summary.formulation;
    json["kinematics"]         = summary.kinematics;
    json["pressure_law"]       = summary.pressure_law;
    json["coupling"]           = summary.coupling;
    json["linear_solver"]      = summary.linear_solver;
    json["ranks"]              = summary.ranks;
    json["finest_cell_mm"]     = number(summary.cell_size);
    json["length_scale_mm"]    = number(summary.length_scale);
    json["residual_stiffness"] = number(summary.residual_stiffness);
    json["thickness_mm"]       = number(summary.thickness);
    add_rows(json, summary, rows);
    json["separated"]  = summary.separated ? Json(*summary.separated) : Json();
    json["force_fell"] = summary.force_fell;
    json["outcome"]    = path_in_words(summary.cracks);
    json["outcome_start"]     = summary.cracks.start;
    json["exit_reason"]       = summary.exit_reason;
    json["exit_status"]       = summary.exit_status;
    json["rejected_steps"]    = summary.cost.rejected_steps;
    json["factorizations"]    = summary.cost.factorizations;
    json["wall_time_s"]       = number(summary.cost.wall_time);
    json["seconds_per_phase"] = Json::object();
    for (const auto &[name, seconds] : summary.cost.phases)
      json["seconds_per_phase"][name] = number(seconds);
    json["peak_memory_MB"]      = number(summary.peak_memory);
    json["memory_MB_per_phase"] = Json::object();
    for (const auto &[name, megabytes] : summary.memory)
      json["memory_MB_per_phase"][name] = number(megabytes);
    if (!events.empty())
      json["events"] = events_in_json(events);
    json["warnings"] = summary.warnings;

    // a reader never sees half of it
    const std::string problem = write_durably(
      file_name,
      json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
    if (!problem.empty())
      throw FileError(
        "Output/Directory: the summary cannot be written: " + problem + '.');
  }
} // namespace MixedCracks
