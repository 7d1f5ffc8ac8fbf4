// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/finite_text.h>

#include <cracks/crack_sheet_front.h>

#include <output/crack_front_rows.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace MixedCracks
{
  using dealii::Point;

  namespace
  {
    // before those of FrontRow
    constexpr std::size_t n_columns_of_step = 3;



    double
    speed_at(const Point<3>                &point,
             const std::vector<CrackFront> &earlier,
             const double                   time_step)
    {
      double distance = std::numeric_limits<double>::infinity();
      for (const CrackFront &front : earlier)
        distance = std::min(distance, distance_to(front, point));
      return time_step > 0. &&
                 distance < std::numeric_limits<double>::infinity()
               ? distance / time_step
               : std::numeric_limits<double>::quiet_NaN();
    }
  } // namespace



  std::string
  header_of_fronts()
  {
    return "step,time_s,displacement_mm,crack,front,closed,point,x_mm,y_mm,"
           "z_mm,arc_length_mm,tip_speed_mm_per_s,opening_angle_deg\n";
  }



  std::string
  columns_of(const FrontRow &row)
  {
    std::string text =
      ',' + std::to_string(row.crack) + ',' + std::to_string(row.front) + ',' +
      (row.is_closed ? '1' : '0') + ',' + std::to_string(row.point);
    for (unsigned int d = 0; d < 3; ++d)
      text += ',' + csv_number(row.position[d]);
    for (const double number :
         {row.arc_length, row.tip_speed, row.opening_angle})
      text += ',' + csv_number(number);
    return text + '\n';
  }



  FrontRow
  front_row_of(const std::vector<std::string> &fields)
  {
    const auto number = [&fields](const std::size_t i) {
      const std::string &text = fields[n_columns_of_step + i];
      return text.empty() ? std::numeric_limits<double>::quiet_NaN()
                          : std::strtod(text.c_str(), nullptr);
    };
    FrontRow row;
    row.crack         = static_cast<unsigned int>(number(0));
    row.front         = static_cast<unsigned int>(number(1));
    row.is_closed     = number(2) > 0.5;
    row.point         = static_cast<unsigned int>(number(3));
    row.position      = {number(4), number(5), number(6)};
    row.arc_length    = number(7);
    row.tip_speed     = number(8);
    row.opening_angle = number(9);
    return row;
  }



  std::vector<FrontRow>
  front_rows(const std::vector<CrackSheet> &sheets,
             const std::vector<CrackFront> &earlier,
             const double                   time_step)
  {
    std::vector<FrontRow> rows;
    for (unsigned int c = 0; c < sheets.size(); ++c)
      for (unsigned int f = 0; f < sheets[c].fronts.size(); ++f)
      {
        const CrackFront &front = sheets[c].fronts[f];
        double            arc   = 0.;
        for (unsigned int i = 0; i < front.points.size(); ++i)
        {
          const Point<3> &position = front.points[i].position;
          if (i > 0)
            arc += position.distance(front.points[i - 1].position);
          rows.push_back({c,
                          f,
                          front.is_closed,
                          i,
                          position,
                          arc,
                          speed_at(position, earlier, time_step),
                          std::numeric_limits<double>::quiet_NaN()});
        }
      }
    return rows;
  }



  std::vector<CrackFront>
  all_fronts(const std::vector<CrackSheet> &sheets)
  {
    std::vector<CrackFront> fronts;
    for (const CrackSheet &sheet : sheets)
      fronts.insert(fronts.end(), sheet.fronts.begin(), sheet.fronts.end());
    return fronts;
  }



  std::vector<CrackFront>
  fronts_of_rows(const std::vector<FrontRow> &rows)
  {
    std::vector<CrackFront> fronts;
    for (const FrontRow &row : rows)
    {
      if (row.point == 0)
        fronts.push_back({{}, row.is_closed, 0.});
      if (fronts.empty())
        continue;
      fronts.back().points.push_back({row.position, {}, {}});
      fronts.back().length = row.arc_length;
    }
    return fronts;
  }
} // namespace MixedCracks
