// SPDX-License-Identifier: GPL-2.0-or-later
// VTK PolyData. The k-th triangle or line has the points offsets[k-1] to
// offsets[k] - 1 of the list 'connectivity'; that of a closed line ends with
// its first point.

#include <base/finite_text.h>

#include <output/crack_sheet_vtp.h>
#include <output/vtp_files.h>

#include <cmath>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    const std::string of_reals = "type=\"Float64\" ";
    const std::string of_whole = "type=\"Int32\" ";



    template <typename Vector>
    std::string
    three_numbers(const Vector &vector)
    {
      return csv_number(vector[0]) + ' ' + csv_number(vector[1]) + ' ' +
             csv_number(vector[2]) + '\n';
    }



    std::string
    number_or_nan(const double value)
    {
      return (std::isfinite(value) ? csv_number(value) : "nan") + '\n';
    }



    // kind: "Polys" or "Lines"
    std::string
    poly_data(const std::string &kind,
              const std::size_t  n_points,
              const std::size_t  n_pieces,
              const std::string &point_data,
              const std::string &cell_data,
              const std::string &points,
              const std::string &connectivity,
              const std::string &offsets)
    {
      return "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"PolyData\" version=\"0.1\" "
             "byte_order=\"LittleEndian\">\n<PolyData>\n"
             "<Piece NumberOfPoints=\"" +
             std::to_string(n_points) + "\" NumberOf" + kind + "=\"" +
             std::to_string(n_pieces) + "\">\n" + point_data + "<CellData>\n" +
             cell_data + "</CellData>\n<Points>\n" +
             vtp_array(of_reals + "NumberOfComponents=\"3\"", points) +
             "</Points>\n<" + kind + ">\n" +
             vtp_array(of_whole + "Name=\"connectivity\"", connectivity) +
             vtp_array(of_whole + "Name=\"offsets\"", offsets) + "</" + kind +
             ">\n</Piece>\n</PolyData>\n</VTKFile>\n";
    }
  } // namespace



  std::string
  crack_sheet_vtp(const std::vector<CrackSheet> &sheets)
  {
    std::ostringstream points, normals, connectivity, offsets, cracks, areas;
    std::size_t        n_points = 0, n_triangles = 0;
    for (std::size_t c = 0; c < sheets.size(); ++c)
    {
      const CrackSheet &sheet = sheets[c];
      for (std::size_t v = 0; v < sheet.vertices.size(); ++v)
      {
        points << three_numbers(sheet.vertices[v]);
        normals << three_numbers(sheet.normals[v]);
      }
      for (const auto &triangle : sheet.triangles)
      {
        for (const unsigned int v : triangle)
          connectivity << n_points + v << ' ';
        connectivity << '\n';
        offsets << 3 * ++n_triangles << ' ';
        cracks << c << ' ';
        areas << csv_number(sheet.area) << ' ';
      }
      n_points += sheet.vertices.size();
    }
    return poly_data(
      "Polys",
      n_points,
      n_triangles,
      "<PointData Normals=\"normals\">\n" +
        vtp_array(of_reals + "Name=\"normals\" NumberOfComponents=\"3\"",
                  normals.str()) +
        "</PointData>\n",
      vtp_array(of_whole + "Name=\"crack\"", cracks.str()) +
        vtp_array(of_reals + "Name=\"area_mm2\"", areas.str()),
      points.str(),
      connectivity.str(),
      offsets.str());
  }



  std::string
  crack_front_vtp(const std::vector<FrontRow> &rows)
  {
    std::ostringstream points, arcs, speeds, angles, connectivity, offsets,
      cracks, fronts;
    std::size_t n_entries = 0, n_lines = 0, first = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      const FrontRow &row = rows[i];
      points << three_numbers(row.position);
      arcs << csv_number(row.arc_length) << '\n';
      speeds << number_or_nan(row.tip_speed);
      angles << number_or_nan(row.opening_angle);
      if (row.point == 0)
        first = i;
      connectivity << i << ' ';
      ++n_entries;
      if (i + 1 < rows.size() && rows[i + 1].point != 0)
        continue;
      if (row.is_closed)
      {
        connectivity << first << ' ';
        ++n_entries;
      }
      ++n_lines;
      offsets << n_entries << ' ';
      cracks << row.crack << ' ';
      fronts << row.front << ' ';
    }
    return poly_data(
      "Lines",
      rows.size(),
      n_lines,
      "<PointData>\n" +
        vtp_array(of_reals + "Name=\"arc_length_mm\"", arcs.str()) +
        vtp_array(of_reals + "Name=\"tip_speed_mm_per_s\"", speeds.str()) +
        vtp_array(of_reals + "Name=\"opening_angle_deg\"", angles.str()) +
        "</PointData>\n",
      vtp_array(of_whole + "Name=\"crack\"", cracks.str()) +
        vtp_array(of_whole + "Name=\"front\"", fronts.str()),
      points.str(),
      connectivity.str(),
      offsets.str());
  }

} // namespace MixedCracks
