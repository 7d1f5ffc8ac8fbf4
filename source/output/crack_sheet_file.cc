// SPDX-License-Identifier: GPL-2.0-or-later
// Cracks are written when they differ from those written last: in number, when
// a point of a front is farther than the tolerance from all earlier ones, the
// other way round, or when an area differs by more than the tolerance times the
// length of the fronts and ten tolerances. What was written last follows from
// the rows, which are in the checkpoint: a resumed run decides alike.
//
// Order: rows, .vtp, lists, as in crack_path_file.cc.

#include <base/finite_text.h>

#include <cracks/crack_sheet_front.h>

#include <output/crack_sheet_file.h>
#include <output/crack_sheet_vtp.h>
#include <output/small_file.h>
#include <output/vtp_files.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const std::string header_of_sheets =
      "step,time_s,displacement_mm,crack,area_mm2,front_length_mm,start,joins,"
      "x_mm,y_mm,z_mm,normal_x,normal_y,normal_z,mean_tip_speed_mm_per_s,"
      "largest_tip_speed_mm_per_s,mean_opening_angle_deg\n";
    constexpr std::size_t n_sheet_columns = 17;
    constexpr std::size_t n_front_columns = 13;

    const std::string sheet_folder = "crack_sheet";
    const std::string front_folder = "crack_front";



    // of those that are known; NaN without any
    template <typename Value>
    std::pair<double, double>
    mean_and_largest(const std::vector<FrontRow> &rows,
                     const unsigned int           crack,
                     const Value                 &value)
    {
      double       sum = 0., largest = 0.;
      unsigned int n = 0;
      for (const FrontRow &row : rows)
        if (row.crack == crack && std::isfinite(value(row)))
        {
          sum += value(row);
          largest = std::max(largest, value(row));
          ++n;
        }
      const double unknown = std::numeric_limits<double>::quiet_NaN();
      return n > 0 ? std::pair(sum / n, largest) : std::pair(unknown, unknown);
    }



    // behind the columns of the step; with the centroid and the mean normal
    std::string
    row_of_sheet(const CrackSheet            &sheet,
                 const unsigned int           number,
                 const std::vector<FrontRow> &fronts)
    {
      Tensor<1, 3> moment, normal;
      for (const auto &[a, b, c] : sheet.triangles)
      {
        const auto        &v = sheet.vertices;
        const Tensor<1, 3> area =
          0.5 * cross_product_3d(v[b] - v[a], v[c] - v[a]);
        normal += area;
        moment +=
          area.norm() / 3. * (v[a] + Tensor<1, 3>(v[b]) + Tensor<1, 3>(v[c]));
      }
      normal /= std::max(normal.norm(), 1e-300);
      std::string text =
        ',' + std::to_string(number) + ',' + csv_number(sheet.area) + ',' +
        csv_number(sheet.front_length()) + ',' + csv_field(sheet.start) + ',' +
        csv_field(sheet.joins());
      for (unsigned int d = 0; d < 3; ++d)
        text += ',' + csv_number(moment[d] / sheet.area);
      for (unsigned int d = 0; d < 3; ++d)
        text += ',' + csv_number(normal[d]);
      const auto [mean, largest] = mean_and_largest(
        fronts, number, [](const FrontRow &row) { return row.tip_speed; });
      const double angle =
        mean_and_largest(fronts, number, [](const FrontRow &row) {
          return row.opening_angle;
        }).first;
      return text + ',' + csv_number(mean) + ',' + csv_number(largest) + ',' +
             csv_number(angle) + '\n';
    }



    bool
    is_near(const std::vector<CrackFront> &points,
            const std::vector<CrackFront> &lines,
            const double                   tolerance)
    {
      for (const CrackFront &front : points)
        for (const FrontPoint &point : front.points)
          if (std::none_of(
                lines.begin(), lines.end(), [&](const CrackFront &line) {
                  return distance_to(line, point.position) < tolerance;
                }))
            return false;
      return true;
    }



    // lines of a table with so many columns, the header left out
    std::vector<std::vector<std::string>>
    rows_of(const std::string &table, const std::size_t n_columns)
    {
      std::vector<std::vector<std::string>> rows;
      std::istringstream                    in(table);
      std::string                           line;
      std::getline(in, line);
      while (std::getline(in, line))
        if (auto fields = csv_fields(line); fields.size() == n_columns)
          rows.push_back(std::move(fields));
      return rows;
    }
  } // namespace



  void
  CrackSheetFile::open()
  {
    restore("", "");
  }



  void
  CrackSheetFile::restore(const std::string &sheets, const std::string &fronts)
  {
    all_sheets = sheets.empty() ? header_of_sheets : sheets;
    all_fronts = fronts.empty() ? header_of_fronts() : fronts;
    steps.clear();
    last_areas.clear();
    for (const auto &row : rows_of(all_sheets, n_sheet_columns))
    {
      const auto step =
        static_cast<unsigned int>(std::strtoul(row[0].c_str(), nullptr, 10));
      if (steps.empty() || steps.back().first != step)
      {
        steps.emplace_back(step, std::strtod(row[1].c_str(), nullptr));
        last_areas.clear();
      }
      last_areas.push_back(std::strtod(row[4].c_str(), nullptr));
    }
    steps_with_sheets.clear();
    for (const auto &step : steps)
      if (is_whole_vtp(directory + '/' + vtp_name(sheet_folder, step.first)))
        steps_with_sheets.push_back(step);
    restore_front_files();
    replace_small_file(directory + "/crack_sheet.csv", all_sheets);
    replace_small_file(directory + "/crack_front.csv", all_fronts);
    write_lists();
  }



  // the fronts of the last step, too
  void
  CrackSheetFile::restore_front_files()
  {
    std::map<unsigned int, std::vector<FrontRow>> by_step;
    for (const auto &row : rows_of(all_fronts, n_front_columns))
      by_step[static_cast<unsigned int>(
                std::strtoul(row[0].c_str(), nullptr, 10))]
        .push_back(front_row_of(row));
    last_fronts.clear();
    if (!steps.empty())
      last_fronts = fronts_of_rows(by_step[steps.back().first]);
    for (const auto &step : steps)
    {
      const std::string name = vtp_name(front_folder, step.first);
      if (!is_whole_vtp(directory + '/' + name))
        write_vtp_file(directory, name, crack_front_vtp(by_step[step.first]));
    }
  }



  void
  CrackSheetFile::write_lists() const
  {
    for (const auto &[folder, written] :
         {std::pair(sheet_folder, &steps_with_sheets),
          std::pair(front_folder, &steps)})
      replace_small_file(directory + '/' + folder + ".pvd",
                         list_of_vtp(folder, *written));
  }



  bool
  CrackSheetFile::differs(const std::vector<CrackSheet> &sheets) const
  {
    if (sheets.size() != last_areas.size())
      return !sheets.empty();
    for (std::size_t c = 0; c < sheets.size(); ++c)
      if (std::abs(sheets[c].area - last_areas[c]) >
          tolerance * (sheets[c].front_length() + 10. * tolerance))
        return true;
    const std::vector<CrackFront> fronts = MixedCracks::all_fronts(sheets);
    return !is_near(fronts, last_fronts, tolerance) ||
           !is_near(last_fronts, fronts, tolerance);
  }



  void
  CrackSheetFile::add(const unsigned int             step,
                      const double                   time,
                      const double                   displacement,
                      const std::vector<CrackSheet> &sheets,
                      const std::vector<FrontRow>   &fronts)
  {
    const std::string step_columns = std::to_string(step) + ',' +
                                     csv_number(time) + ',' +
                                     csv_number(displacement);
    std::string of_sheets, of_fronts;
    last_areas.clear();
    for (unsigned int c = 0; c < sheets.size(); ++c)
    {
      of_sheets += step_columns + row_of_sheet(sheets[c], c, fronts);
      last_areas.push_back(sheets[c].area);
    }
    for (const FrontRow &row : fronts)
      of_fronts += step_columns + columns_of(row);
    last_fronts = MixedCracks::all_fronts(sheets);
    all_sheets += of_sheets;
    all_fronts += of_fronts;
    steps.emplace_back(step, time);
    steps_with_sheets.emplace_back(step, time);
    append_to_file(directory + "/crack_sheet.csv", of_sheets);
    append_to_file(directory + "/crack_front.csv", of_fronts);
    write_vtp_file(
      directory, vtp_name(sheet_folder, step), crack_sheet_vtp(sheets));
    write_vtp_file(
      directory, vtp_name(front_folder, step), crack_front_vtp(fronts));
    write_lists();
  }



  void
  CrackSheetFile::finish(const Outcome &outcome) const
  {
    std::string joins;
    for (const std::string &names : outcome.joins)
      joins += (joins.empty() ? "; joins: " : ", ") + names;
    append_to_file(directory + "/crack_sheet.csv",
                   "# outcome: " + path_in_words(outcome) +
                     "; start: " + outcome.start + joins + '\n');
  }
} // namespace MixedCracks
