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



    std::string
    unusable_element(const std::string &found)
    {
      return "has " + found +
             "; only meshes of four-node quadrilaterals are read (in Gmsh: "
             "recombine, first order, two-dimensional)";
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
  scan_mesh(const std::string &text)
  {
    using namespace MeshScanning;
    Lines lines = split_list(text, '\n');
    if (lines.empty())
      return {MeshScan::unknown, "is empty"};
    if (starts_with(lines.front(), "$") && !is_binary(text.substr(0, 40)))
      return {MeshScan::gmsh, gmsh_problem(lines)};
    if (is_binary(text))
      return {MeshScan::unknown, "is binary, not text"};
    if (starts_with(lines.front(), "*"))
      return {MeshScan::abaqus, abaqus_problem(lines)};

    lines.erase(
      std::remove_if(lines.begin(),
                     lines.end(),
                     [](const std::string &line) { return line[0] == '#'; }),
      lines.end());
    if (!lines.empty() && numbers_of(lines.front()).size() == 5)
      return {MeshScan::ucd, ucd_problem(lines)};
    return {MeshScan::unknown,
            "is neither a Gmsh (.msh), an Abaqus (.inp) nor a UCD file"};
  }
} // namespace MixedCracks
