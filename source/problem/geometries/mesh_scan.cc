// SPDX-License-Identifier: GPL-2.0-or-later
// Which format a mesh file has is told by its first line, not by its name:
// '.inp' is used by Abaqus and by UCD. '$' begins a Gmsh file, '*' an Abaqus
// file, five numbers a UCD file. The parsers that follow it take lines without
// blanks around and without empty lines, and return what is wrong as the end of
// a sentence.
//
// Numbers are read strictly: a line with anything else is no line of numbers.

#include <base/text.h>

#include <problem/geometries/mesh_scan.h>
#include <problem/geometries/mesh_scan_formats.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      // @p next reads one number at a place and moves it
      template <typename Number, typename Next>
      std::vector<Number>
      all_of(const std::string &line, const Next &next)
      {
        std::vector<Number> numbers;
        const char         *place = line.c_str();
        while (true)
        {
          while (std::isspace(static_cast<unsigned char>(*place)))
            ++place;
          if (*place == '\0')
            break;
          char        *behind = nullptr;
          const Number number = next(place, &behind);
          if (behind == place ||
              !(*behind == '\0' ||
                std::isspace(static_cast<unsigned char>(*behind))))
            return {};
          numbers.push_back(number);
          place = behind;
        }
        // a zero byte would end the text early
        return place == line.c_str() + line.size() ? numbers
                                                   : std::vector<Number>();
      }
    } // namespace



    std::vector<double>
    numbers_of(const std::string &line)
    {
      const std::vector<double> numbers =
        all_of<double>(line, [](const char *from, char **to) {
          return std::strtod(from, to);
        });
      for (const double number : numbers)
        if (!std::isfinite(number))
          return {};
      return numbers;
    }



    std::vector<long int>
    integers_of(const std::string &line)
    {
      constexpr long int          largest = std::numeric_limits<int>::max();
      const std::vector<long int> integers =
        all_of<long int>(line, [](const char *from, char **to) {
          return std::strtol(from, to, 10);
        });
      for (const long int integer : integers)
        if (integer < 0 || integer > largest)
          return {};
      return integers;
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
        return {2, "quadrilaterals", 4, 2, 3, "quad", '4'};
      return {3, "hexahedra", 8, 4, 5, "hex", '6'};
    }



    std::string
    unusable_element(const std::string &found, const CellKind &kind)
    {
      return "has " + found +
             (kind.dim == 2
                ? "; only meshes of four-node quadrilaterals are read (in Gmsh: "
                  "recombine, Mesh.SubdivisionAlgorithm = 1, first order, "
                  "two-dimensional)"
                : "; only meshes of eight-node hexahedra are read (in Gmsh: "
                  "transfinite volumes or extruded layers, recombined, or "
                  "Mesh.SubdivisionAlgorithm = 2; first order)");
    }



    std::string
    other_dimension(const std::string &found, const CellKind &kind)
    {
      return "has " + found + ", but Geometry/Dimension is " +
             std::to_string(kind.dim) + ": the mesh is one of " +
             (kind.dim == 2 ? "three-dimensional cells"
                            : "quadrilaterals, for 2-d");
    }



    std::string
    unlisted_node(const std::string &line)
    {
      return "has cells with nodes that it does not list: " + in_quotes(line);
    }



    std::string
    in_words(const MeshContents::Group &group)
    {
      const std::string name = "'" + group.name + "'";
      if (group.number == MeshContents::Group::none)
        return name;
      return std::to_string(group.number) +
             (group.name.empty() ? "" : " (" + name + ")");
    }
  } // namespace MeshScanning



  namespace
  {
    bool
    is_binary(const std::string &text)
    {
      return std::any_of(text.begin(), text.end(), [](const char c) {
        const unsigned char byte = static_cast<unsigned char>(c);
        return byte < 32 && !std::isspace(byte);
      });
    }



    // without a byte order mark; line ends of one carriage return are those
    // of old editors
    std::string
    plain(std::string text)
    {
      if (starts_with(text, "\xEF\xBB\xBF"))
        text.erase(0, 3);
      std::replace(text.begin(), text.end(), '\r', '\n');
      return text;
    }
  } // namespace



  MeshScan
  scan_mesh(const std::string &whole_text, const int dim)
  {
    using namespace MeshScanning;
    const CellKind    kind = cell_kind(dim);
    const std::string text = plain(whole_text);
    MeshScan          scan;
    if (starts_with(text, "\xFF\xFE") || starts_with(text, "\xFE\xFF"))
    {
      scan.problem = "is UTF-16 text; save it as ASCII or UTF-8";
      return scan;
    }
    Lines lines = split_list(text, '\n');
    if (lines.empty())
      scan.problem = "is empty";
    else if (starts_with(lines.front(), "$") && !is_binary(text.substr(0, 40)))
      scan.problem = scan_gmsh(lines, kind, scan.contents);
    else if (is_binary(text))
      scan.problem = "is binary, not text";
    else if (starts_with(lines.front(), "*"))
      scan.problem = scan_abaqus(lines, kind, scan.contents);
    else
    {
      lines.erase(
        std::remove_if(lines.begin(),
                       lines.end(),
                       [](const std::string &line) { return line[0] == '#'; }),
        lines.end());
      scan.problem =
        !lines.empty() && numbers_of(lines.front()).size() == 5
          ? scan_ucd(lines, kind, scan.contents)
          : "is neither a Gmsh (.msh), an Abaqus (.inp) nor a UCD file";
    }
    return scan;
  }
} // namespace MixedCracks
