// SPDX-License-Identifier: GPL-2.0-or-later
// Paths are written when they differ from those written last by more than l/10
// in the distance of Hausdorff,
//
//   d(a, b) = max( max over points p of a of dist(p, b), the same of b to a ),
//
// crack by crack in the order of tracing, or when an end has moved by so much.
// The ends are compared apart, since a line with start and end exchanged has
// distance 0 from itself. Cracks that are numbered otherwise count as
// different: a step too many is written, never one too few.
//
// Written in the order rows, .vtp, list. All of it follows from the rows, which
// are in the checkpoint; a .vtp is written again only where it is missing or
// does not end as it should. Rows are appended; where table and list are
// written anew, the old ones stay until the new ones are whole.

#include <base/finite_text.h>

#include <cracks/crack_path_parts.h>

#include <output/crack_path_file.h>
#include <output/crack_path_vtp.h>
#include <output/small_file.h>
#include <output/vtp_files.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const std::string header_line =
      "step,time_s,displacement_mm,crack,length_mm,kink_angle_deg,start,end,"
      "tip_x_mm,tip_y_mm,point,x_mm,y_mm,arc_length_mm\n";
    constexpr std::size_t n_columns = 14;
    const std::string     folder    = "crack_path";



    std::string
    rows_of_step(const std::string        &step_columns,
                 const std::vector<Crack> &cracks)
    {
      std::ostringstream out;
      for (std::size_t c = 0; c < cracks.size(); ++c)
      {
        const Crack              &crack   = cracks[c];
        const std::vector<double> lengths = arc_lengths(crack);
        for (std::size_t i = 0; i < crack.points.size(); ++i)
          out << step_columns << ',' << c << ',' << csv_number(crack.length)
              << ',' << csv_number(crack.kink_angle) << ','
              << csv_field(crack.start_name()) << ','
              << csv_field(crack.end.name) << ','
              << csv_number(crack.points.back()[0]) << ','
              << csv_number(crack.points.back()[1]) << ',' << i << ','
              << csv_number(crack.points[i][0]) << ','
              << csv_number(crack.points[i][1]) << ',' << csv_number(lengths[i])
              << '\n';
      }
      return out.str();
    }



    unsigned int
    step_of(const std::vector<std::string> &columns)
    {
      return std::strtoul(columns[0].c_str(), nullptr, 10);
    }

  } // namespace



  void
  CrackPathFile::write_table_and_list() const
  {
    replace_small_file(csv_name, all_rows);
    write_pvd();
  }



  void
  CrackPathFile::open()
  {
    is_open = true;
    last.clear();
    steps.clear();
    all_rows = header_line;
    write_table_and_list();
  }



  // what a row says of the paths of a step
  void
  CrackPathFile::take_row(const std::vector<std::string> &columns)
  {
    const auto number = [&columns](const unsigned int column) {
      return std::strtod(columns[column].c_str(), nullptr);
    };
    const unsigned int step = step_of(columns);
    if (steps.empty() || steps.back().first != step)
    {
      steps.emplace_back(step, number(1));
      last.clear();
    }
    const auto crack = static_cast<std::size_t>(number(3));
    last.resize(std::max(last.size(), crack + 1));
    last[crack].points.emplace_back(number(11), number(12));
    last[crack].length = number(4);
  }



  void
  CrackPathFile::restore(const std::string &earlier)
  {
    is_open = true;
    last.clear();
    steps.clear();
    all_rows = header_line;
    std::istringstream in(earlier);
    std::string        line;
    std::getline(in, line);
    while (std::getline(in, line))
    {
      const std::vector<std::string> columns = csv_fields(line);
      if (columns.size() != n_columns)
        continue;
      const unsigned int step = step_of(columns);
      if (!steps.empty() && steps.back().first != step)
        restore_vtp();
      take_row(columns);
      all_rows += line + '\n';
    }
    restore_vtp();
    write_table_and_list();
  }



  // of the step taken last
  void
  CrackPathFile::restore_vtp() const
  {
    if (!steps.empty() &&
        !is_whole_vtp(directory + '/' + vtp_name(folder, steps.back().first)))
      write_vtp(steps.back().first, last);
  }



  bool
  CrackPathFile::differs(const std::vector<Crack> &cracks) const
  {
    if (cracks.size() != last.size())
      return true;
    for (std::size_t c = 0; c < cracks.size(); ++c)
    {
      const auto &points = cracks[c].points;
      if (points.front().distance(last[c].points.front()) > tolerance ||
          points.back().distance(last[c].points.back()) > tolerance)
        return true;
      for (const Point<2> &point : points)
        if (distance_to(last[c].points, point) > tolerance)
          return true;
      for (const Point<2> &point : last[c].points)
        if (distance_to(points, point) > tolerance)
          return true;
    }
    return false;
  }



  void
  CrackPathFile::add(const unsigned int        step,
                     const double              time,
                     const double              displacement,
                     const std::vector<Crack> &cracks)
  {
    if (!is_open)
      open();
    if (cracks.empty() || !differs(cracks))
      return;
    last = cracks;
    steps.emplace_back(step, time);
    const std::string added =
      rows_of_step(std::to_string(step) + ',' + csv_number(time) + ',' +
                     csv_number(displacement),
                   cracks);
    all_rows += added;
    append_to_file(csv_name, added);
    write_vtp(step, cracks);
    write_pvd();
  }



  void
  CrackPathFile::finish(const Outcome &outcome)
  {
    if (!is_open)
      open();
    append_to_file(csv_name,
                   "# outcome: " + path_in_words(outcome) +
                     "; start: " + outcome.start + '\n');
  }



  void
  CrackPathFile::write_vtp(const unsigned int        step,
                           const std::vector<Crack> &cracks) const
  {
    write_vtp_file(directory, vtp_name(folder, step), crack_path_vtp(cracks));
  }



  void
  CrackPathFile::write_pvd() const
  {
    replace_small_file(pvd_name, list_of_vtp(folder, steps));
  }
} // namespace MixedCracks
