// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/text.h>
#include <problem/geometries/mesh_scan.h>
#include <problem/geometries/mesh_scan_formats.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <sstream>

namespace MixedCracks
{
  namespace MeshScanning
  {
    std::vector<double>
    numbers_of(const std::string &line)
    {
      std::istringstream  in(line);
      std::vector<double> numbers;
      for (double number; in >> number;)
        numbers.push_back(number);
      return in.eof() ? numbers : std::vector<double>();
    }



    std::vector<long int>
    integers_of(const std::string &line)
    {
      constexpr long int    largest = std::numeric_limits<int>::max();
      std::istringstream    in(line);
      std::vector<long int> integers;
      for (long int integer; in >> integer;)
      {
        if (integer < 0 || integer > largest)
          return {};
        integers.push_back(integer);
      }
      return in.eof() ? integers : std::vector<long int>();
    }



    std::string
    broken_line(const std::string &kind, const std::string &line)
    {
      return "has a broken " + kind + ": " + in_quotes(line);
    }



    CellKind
    cell_kind(const int dim)
    {
      if (dim == 2)
        return {2, "quadrilaterals", 4, 3, "quad", '4'};
      return {3, "hexahedra", 8, 5, "hex", '6'};
    }



    std::string
    unusable_element(const std::string &found, const CellKind &kind)
    {
      return "has " + found +
             (kind.dim == 2
                ? "; only meshes of four-node quadrilaterals are read (in Gmsh: "
                  "recombine, first order, two-dimensional)"
                : "; only meshes of eight-node hexahedra are read (in Gmsh: "
                  "transfinite volumes or extruded layers, recombined, first "
                  "order)");
    }



    std::string
    other_dimension(const std::string &found, const CellKind &kind)
    {
      return "has " + found + ", but Geometry/Dimension is " +
             std::to_string(kind.dim) + ": the mesh is one of " +
             (kind.dim == 2 ? "three-dimensional cells"
                            : "quadrilaterals, for 2-d");
    }
  } // namespace MeshScanning



  namespace
  {
    bool
    starts_with(const std::string &line, const std::string &word)
    {
      return line.compare(0, word.size(), word) == 0;
    }



    bool
    is_binary(const std::string &text)
    {
      return std::any_of(text.begin(), text.end(), [](const char c) {
        const unsigned char byte = static_cast<unsigned char>(c);
        return byte < 32 && !std::isspace(byte);
      });
    }
  } // namespace



  MeshScan
  scan_mesh(const std::string &text, const int dim)
  {
    using namespace MeshScanning;
    const CellKind kind  = cell_kind(dim);
    Lines          lines = split_list(text, '\n');
    if (lines.empty())
      return {MeshScan::unknown, "is empty"};
    if (starts_with(lines.front(), "$") && !is_binary(text.substr(0, 40)))
      return {MeshScan::gmsh, gmsh_problem(lines, kind)};
    if (is_binary(text))
      return {MeshScan::unknown, "is binary, not text"};
    if (starts_with(lines.front(), "*"))
      return {MeshScan::abaqus, abaqus_problem(lines, kind)};

    lines.erase(
      std::remove_if(lines.begin(),
                     lines.end(),
                     [](const std::string &line) { return line[0] == '#'; }),
      lines.end());
    if (!lines.empty() && numbers_of(lines.front()).size() == 5)
      return {MeshScan::ucd, ucd_problem(lines, kind)};
    return {MeshScan::unknown,
            "is neither a Gmsh (.msh), an Abaqus (.inp) nor a UCD file"};
  }
} // namespace MixedCracks
