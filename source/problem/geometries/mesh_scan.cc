// SPDX-License-Identifier: GPL-2.0-or-later
// Which format a mesh file has is told by its first line, not by its name:
// '.inp' is used by Abaqus and by UCD. '$' begins a Gmsh file, '*' an Abaqus
// file, '# vtk' a VTK file, five numbers a UCD file. The parsers that follow it
// take lines without blanks around and without empty lines, and return what is
// wrong as the end of a sentence. A binary Gmsh file becomes the lines of an
// ASCII file first.
//
// Numbers are read strictly: a line with anything else is no line of numbers.

#include <base/text.h>

#include <problem/geometries/mesh_cut.h>
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



      // "0,25" among numbers that are separated by blanks
      bool
      has_decimal_comma(const std::string &line)
      {
        const auto is_digit = [&](const std::size_t place) {
          return place < line.size() &&
                 std::isdigit(static_cast<unsigned char>(line[place]));
        };
        bool has_comma = false, has_blank = false;
        for (std::size_t i = 1; i < line.size(); ++i)
        {
          has_comma =
            has_comma || (line[i] == ',' && is_digit(i - 1) && is_digit(i + 1));
          has_blank = has_blank || (line[i] == ' ' && is_digit(i - 1));
        }
        return has_comma && has_blank;
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



    MeshProblem
    broken_line(const std::string &kind, const std::string &line)
    {
      return MeshProblem(
        "has a broken " + kind + ": " + in_quotes(line) +
        (has_decimal_comma(line) ? "; numbers have points, not commas" : ""));
    }



    CellKind
    cell_kind(const int dim)
    {
      if (dim == 2)
        return {2, "quadrilaterals"};
      return {3, "hexahedra"};
    }



    MeshProblem
    unusable_element(const std::string &found, const CellKind &kind)
    {
      return MeshProblem(
        "has " + found +
        (kind.dim == 2
           ? "; only meshes of quadrilaterals are read (in Gmsh: "
             "recombine, Mesh.SubdivisionAlgorithm = 1, "
             "two-dimensional)"
           : "; only meshes of hexahedra are read (in Gmsh: "
             "transfinite volumes or extruded layers, recombined, or "
             "Mesh.SubdivisionAlgorithm = 2)"));
    }



    MeshProblem
    cut_or_remesh(const std::string &found, const CellKind &kind)
    {
      return MeshProblem(
        unusable_element(found, kind).what() +
        std::string("; Geometry/Mesh file/Cut simplices = true cuts ") +
        (kind.dim == 2 ? "each triangle into three quadrilaterals"
                       : "each tetrahedron into four hexahedra"));
    }



    MeshProblem
    no_cells(const bool has_faces, const CellKind &kind)
    {
      const std::string nothing = "no " + kind.name;
      return kind.dim == 3 && has_faces ? other_dimension(nothing, kind)
                                        : unusable_element(nothing, kind);
    }



    MeshProblem
    other_dimension(const std::string &found, const CellKind &kind)
    {
      return MeshProblem("has " + found + ", but Geometry/Dimension is " +
                         std::to_string(kind.dim) + ": the mesh is one of " +
                         (kind.dim == 2 ? "three-dimensional cells"
                                        : "quadrilaterals, for 2-d"));
    }



    MeshProblem
    unlisted_node(const std::string &line)
    {
      return MeshProblem("has cells with nodes that it does not list: " +
                         in_quotes(line));
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


    using namespace MeshScanning;



    // By the first line
    void
    scan_text(const std::string &text,
              const CellKind    &kind,
              MeshContents      &contents)
    {
      if (starts_with(text, "\xFF\xFE") || starts_with(text, "\xFE\xFF"))
        throw MeshProblem("is UTF-16 text; save it as ASCII or UTF-8");
      Lines lines = split_list(text, '\n');
      if (lines.empty())
        throw MeshProblem("is empty");
      if (is_binary(text))
        throw MeshProblem("is binary, not text");
      if (starts_with(lines.front(), "$"))
        return scan_gmsh(lines, kind, contents);
      if (starts_with(lines.front(), "*"))
        return scan_abaqus(lines, kind, contents);
      if (starts_with(lines.front(), "# vtk"))
        return scan_vtk(lines, kind, contents);
      lines.erase(
        std::remove_if(lines.begin(),
                       lines.end(),
                       [](const std::string &line) { return line[0] == '#'; }),
        lines.end());
      if (lines.empty() || numbers_of(lines.front()).size() != 5)
        throw MeshProblem("is neither a Gmsh (.msh), an Abaqus (.inp), a UCD "
                          "nor a VTK file");
      scan_ucd(lines, kind, contents);
    }
  } // namespace



  MeshScan
  scan_mesh(const std::string &bytes, const int dim, const bool cut_simplices)
  {
    const CellKind kind = cell_kind(dim);
    MeshScan       scan;
    if (const std::string other = name_of_other_format(bytes); !other.empty())
      throw MeshProblem("is " + other +
                        "; Gmsh (.msh), Abaqus (.inp), UCD and legacy VTK "
                        "files are read");
    if (is_binary_gmsh(bytes))
      scan_gmsh(gmsh_as_lines(bytes), kind, scan.contents);
    else
      scan_text(plain(bytes), kind, scan.contents);
    const MeshContents::Cell *simplex = first_simplex(scan.contents, dim);
    if (simplex == nullptr)
      return scan;
    if (!cut_simplices)
      throw cut_or_remesh(shape_of_nodes(dim, simplex->nodes.size())->name +
                            " (element " + std::to_string(simplex->number) +
                            ")",
                          kind);
    cut_cells(scan.contents, dim);
    scan.is_cut = true;
    return scan;
  }
} // namespace MixedCracks
