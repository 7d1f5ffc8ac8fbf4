// SPDX-License-Identifier: GPL-2.0-or-later
// VTK PolyData with one line per crack: points of all cracks in a row, the k-th
// line being the points offsets[k-1] to offsets[k] - 1.

#include <base/finite_text.h>

#include <output/crack_path_vtp.h>
#include <output/vtp_files.h>

#include <sstream>

namespace MixedCracks
{
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
  crack_path_vtp(const std::vector<Crack> &cracks)
  {
    std::ostringstream points, arcs, connectivity, offsets, numbers, lengths;
    std::size_t        n = 0;
    for (std::size_t c = 0; c < cracks.size(); ++c)
    {
      for (const dealii::Point<2> &point : cracks[c].points)
      {
        points << csv_number(point[0]) << ' ' << csv_number(point[1]) << " 0\n";
        connectivity << n++ << ' ';
      }
      for (const double arc : arc_lengths(cracks[c]))
        arcs << csv_number(arc) << '\n';
      offsets << n << ' ';
      numbers << c << ' ';
      lengths << csv_number(cracks[c].length) << ' ';
    }
    const std::string real = "type=\"Float64\" ", whole = "type=\"Int32\" ";
    return "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"PolyData\" version=\"0.1\" "
           "byte_order=\"LittleEndian\">\n<PolyData>\n"
           "<Piece NumberOfPoints=\"" +
           std::to_string(n) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
           std::to_string(cracks.size()) +
           "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>\n" +
           vtp_array(real + "Name=\"arc_length_mm\"", arcs.str()) +
           "</PointData>\n<CellData>\n" +
           vtp_array(whole + "Name=\"crack\"", numbers.str()) +
           vtp_array(real + "Name=\"length_mm\"", lengths.str()) +
           "</CellData>\n<Points>\n" +
           vtp_array(real + "NumberOfComponents=\"3\"", points.str()) +
           "</Points>\n<Lines>\n" +
           vtp_array(whole + "Name=\"connectivity\"", connectivity.str()) +
           vtp_array(whole + "Name=\"offsets\"", offsets.str()) +
           "</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  }

} // namespace MixedCracks
