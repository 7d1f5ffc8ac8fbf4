// SPDX-License-Identifier: GPL-2.0-or-later
#include <output/crack_path_file.h>
#include <output/crack_path_parts.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const std::string header =
      "step,time_s,displacement_mm,crack,length_mm,kink_angle_deg,start,end,"
      "tip_x_mm,tip_y_mm,point,x_mm,y_mm,arc_length_mm\n";



    // empty for NaN
    std::string
    text(const double value)
    {
      if (std::isnan(value))
        return "";
      char buffer[40];
      std::snprintf(buffer, sizeof(buffer), "%.10g", value);
      return buffer;
    }



    std::string
    vtp_name(const unsigned int step)
    {
      char buffer[60];
      std::snprintf(
        buffer, sizeof(buffer), "crack_path/crack_path_%06u.vtp", step);
      return buffer;
    }



    // the arc length at the points of a crack
    std::vector<double>
    arc_lengths(const Crack &crack)
    {
      std::vector<double> lengths(crack.points.size(), 0.);
      for (std::size_t i = 1; i < lengths.size(); ++i)
        lengths[i] =
          lengths[i - 1] + crack.points[i].distance(crack.points[i - 1]);
      return lengths;
    }



    std::string
    rows(const std::string &step_columns, const std::vector<Crack> &cracks)
    {
      std::ostringstream out;
      for (std::size_t c = 0; c < cracks.size(); ++c)
      {
        const Crack              &crack   = cracks[c];
        const std::vector<double> lengths = arc_lengths(crack);
        for (std::size_t i = 0; i < crack.points.size(); ++i)
          out << step_columns << ',' << c << ',' << text(crack.length) << ','
              << text(crack.kink_angle) << ',' << crack.start_name() << ','
              << crack.end.name << ',' << text(crack.points.back()[0]) << ','
              << text(crack.points.back()[1]) << ',' << i << ','
              << text(crack.points[i][0]) << ',' << text(crack.points[i][1])
              << ',' << text(lengths[i]) << '\n';
      }
      return out.str();
    }



    std::vector<std::string>
    columns_of(const std::string &row)
    {
      std::vector<std::string> columns;
      std::istringstream       in(row);
      for (std::string column; std::getline(in, column, ',');)
        columns.push_back(column);
      return columns;
    }



    // write all of a file; false when that fails
    bool
    write_file(const std::string &name, const std::string &content)
    {
      std::ofstream file(name);
      file << content << std::flush;
      return static_cast<bool>(file);
    }
  } // namespace



  CrackPathFile::CrackPathFile(const std::string &directory,
                               const double       tolerance)
    : directory(directory)
    , csv_name(directory + "/crack_path.csv")
    , pvd_name(directory + "/crack_path.pvd")
    , tolerance(tolerance)
  {}



  std::string
  CrackPathFile::failure(const std::string &name) const
  {
    return "Output/Directory: '" + name +
           "' cannot be written; is the disk full?";
  }



  std::string
  CrackPathFile::open()
  {
    is_open = true;
    last.clear();
    steps.clear();
    if (!write_file(csv_name, header))
      return failure(csv_name);
    return write_pvd();
  }



  // what a row of an earlier run says of the last paths
  void
  CrackPathFile::take_row(const std::string &row)
  {
    const std::vector<std::string> columns = columns_of(row);
    const unsigned int step = std::strtoul(columns[0].c_str(), nullptr, 10);
    if (steps.empty() || steps.back().first != step)
    {
      steps.emplace_back(step, std::strtod(columns[1].c_str(), nullptr));
      last.clear();
    }
    const std::size_t crack = std::strtoul(columns[3].c_str(), nullptr, 10);
    last.resize(std::max(last.size(), crack + 1));
    last[crack].emplace_back(std::strtod(columns[11].c_str(), nullptr),
                             std::strtod(columns[12].c_str(), nullptr));
  }



  std::string
  CrackPathFile::restore(const unsigned int last_step)
  {
    std::ifstream file(csv_name);
    std::string   line;
    if (!file || !std::getline(file, line))
      return open();
    is_open = true;
    last.clear();
    steps.clear();
    std::string kept = header;
    while (std::getline(file, line))
      // a line that was cut off, like the outcome, is dropped
      if (columns_of(line).size() == 14 && line.front() != '#' &&
          std::strtoul(line.c_str(), nullptr, 10) <= last_step)
      {
        kept += line + '\n';
        take_row(line);
      }
    file.close();
    if (!write_file(csv_name, kept))
      return failure(csv_name);
    return write_pvd();
  }



  bool
  CrackPathFile::differs(const std::vector<Crack> &cracks) const
  {
    if (cracks.size() != last.size())
      return true;
    for (std::size_t c = 0; c < cracks.size(); ++c)
    {
      const auto &points = cracks[c].points;
      if (points.front().distance(last[c].front()) > tolerance ||
          points.back().distance(last[c].back()) > tolerance)
        return true;
      for (const Point<2> &point : points)
        if (distance_to(last[c], point) > tolerance)
          return true;
      for (const Point<2> &point : last[c])
        if (distance_to(points, point) > tolerance)
          return true;
    }
    return false;
  }



  std::string
  CrackPathFile::append(const std::string &content) const
  {
    std::ofstream file(csv_name, std::ios::app);
    file << content << std::flush;
    return file ? "" : failure(csv_name);
  }



  std::string
  CrackPathFile::add(const unsigned int        step,
                     const double              time,
                     const double              displacement,
                     const std::vector<Crack> &cracks)
  {
    if (!is_open)
    {
      const std::string message = open();
      if (!message.empty())
        return message;
    }
    if (cracks.empty() || !differs(cracks))
      return "";
    last.clear();
    for (const Crack &crack : cracks)
      last.push_back(crack.points);
    steps.emplace_back(step, time);
    std::string message = append(
      rows(std::to_string(step) + ',' + text(time) + ',' + text(displacement),
           cracks));
    if (message.empty())
      message = write_vtp(step, cracks);
    return message.empty() ? write_pvd() : message;
  }



  std::string
  CrackPathFile::finish(const Outcome &outcome)
  {
    if (!is_open)
    {
      const std::string message = open();
      if (!message.empty())
        return message;
    }
    return append("# outcome: " + outcome.path + "; start: " + outcome.start +
                  '\n');
  }



  std::string
  CrackPathFile::write_vtp(const unsigned int        step,
                           const std::vector<Crack> &cracks) const
  {
    std::ostringstream points, arcs, connectivity, offsets, numbers, lengths;
    std::size_t        n = 0;
    for (std::size_t c = 0; c < cracks.size(); ++c)
    {
      for (const Point<2> &point : cracks[c].points)
      {
        points << text(point[0]) << ' ' << text(point[1]) << " 0\n";
        connectivity << n++ << ' ';
      }
      for (const double arc : arc_lengths(cracks[c]))
        arcs << text(arc) << '\n';
      offsets << n << ' ';
      numbers << c << ' ';
      lengths << text(cracks[c].length) << ' ';
    }
    const auto array = [](const std::string &attributes,
                          const std::string &content) {
      return "<DataArray " + attributes + " format=\"ascii\">\n" + content +
             "\n</DataArray>\n";
    };
    const std::string real = "type=\"Float64\" ", whole = "type=\"Int32\" ";
    const std::string content =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"" +
      std::to_string(n) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
      std::to_string(cracks.size()) +
      "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>\n" +
      array(real + "Name=\"arc_length_mm\"", arcs.str()) +
      "</PointData>\n<CellData>\n" +
      array(whole + "Name=\"crack\"", numbers.str()) +
      array(real + "Name=\"length_mm\"", lengths.str()) +
      "</CellData>\n<Points>\n" +
      array(real + "NumberOfComponents=\"3\"", points.str()) +
      "</Points>\n<Lines>\n" +
      array(whole + "Name=\"connectivity\"", connectivity.str()) +
      array(whole + "Name=\"offsets\"", offsets.str()) +
      "</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
    std::error_code ignored; // writing fails then
    std::filesystem::create_directories(directory + "/crack_path", ignored);
    const std::string name = directory + '/' + vtp_name(step);
    return write_file(name, content) ? "" : failure(name);
  }



  std::string
  CrackPathFile::write_pvd() const
  {
    std::string content = "<?xml version=\"1.0\"?>\n"
                          "<VTKFile type=\"Collection\" version=\"0.1\" "
                          "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const auto &[step, time] : steps)
      content += "<DataSet timestep=\"" + text(time) +
                 "\" group=\"\" part=\"0\" file=\"" + vtp_name(step) + "\"/>\n";
    content += "</Collection>\n</VTKFile>\n";
    return write_file(pvd_name, content) ? "" : failure(pvd_name);
  }
} // namespace MixedCracks
