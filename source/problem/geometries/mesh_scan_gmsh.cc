// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/text.h>
#include <problem/geometries/mesh_scan_formats.h>

#include <algorithm>
#include <map>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      // Nodes of those elements that are cells or mark boundaries, by type
      unsigned int
      gmsh_n_nodes(const int type)
      {
        switch (type)
        {
          case 1:
            return 2;
          case 3:
            return 4;
          case 5:
            return 8;
          default:
            return 1;
        }
      }



      // What is wrong with a Gmsh element type; empty for the cells of the
      // dimension and for what marks boundaries
      std::string
      gmsh_type_problem(const int type, const CellKind &kind)
      {
        const char *solids[] = {
          "tetrahedra", "hexahedra", "prisms", "pyramids"};
        switch (type)
        {
          case 1:
          case 3:
          case 15:
            return "";
          case 2:
            return unusable_element("triangles", kind);
          case 4:
          case 5:
          case 6:
          case 7:
            if (type == kind.gmsh_type)
              return "";
            return kind.dim == 2 ? other_dimension(solids[type - 4], kind)
                                 : unusable_element(solids[type - 4], kind);
          default:
            return unusable_element(
              "elements of Gmsh's type " + std::to_string(type), kind);
        }
      }



      // What is wrong with the numbers of elements by type
      std::string
      gmsh_counts_problem(std::map<int, std::size_t> &n_elements,
                          const CellKind             &kind)
      {
        if (n_elements[kind.gmsh_type] > 0)
          return "";
        const std::string nothing = "no " + kind.name;
        return kind.dim == 3 && n_elements[3] > 0
                 ? other_dimension(nothing, kind)
                 : unusable_element(nothing, kind);
      }



      // The lines between "$name" and "$Endname", or what is wrong with them
      std::string
      gmsh_section(const Lines &lines, const std::string &name, Lines &section)
      {
        const auto begin = std::find(lines.begin(), lines.end(), "$" + name);
        if (begin == lines.end())
          return "has no section $" + name;
        const auto end = std::find(begin, lines.end(), "$End" + name);
        if (end == lines.end())
          return "ends before $End" + name;
        section.assign(begin + 1, end);
        if (section.empty() || numbers_of(section.front()).empty())
          return "has an empty or broken section $" + name;
        return "";
      }



      // Version 2: after the number of elements, a line for each: number, type,
      // number of tags, tags, nodes
      std::string
      gmsh2_elements_problem(const Lines &section, const CellKind &kind)
      {
        if (numbers_of(section.front())[0] != double(section.size() - 1))
          return "says it has " + section.front() + " elements but lists " +
                 std::to_string(section.size() - 1);
        std::map<int, std::size_t> n_elements;
        for (std::size_t i = 1; i < section.size(); ++i)
        {
          const std::vector<long int> entry = integers_of(section[i]);
          if (entry.size() < 4)
            return broken_line("element", section[i]);
          const int         type    = static_cast<int>(entry[1]);
          const std::string problem = gmsh_type_problem(type, kind);
          if (!problem.empty())
            return problem;
          if (static_cast<long int>(entry.size()) !=
              3 + entry[2] + gmsh_n_nodes(type))
            return broken_line("element", section[i]);
          ++n_elements[type];
        }
        return gmsh_counts_problem(n_elements, kind);
      }



      // Version 4: a head, then blocks: two of entity's dimension and tag,
      // type, number of elements; and a line for each element: number, nodes
      std::string
      gmsh4_elements_problem(const Lines &section, const CellKind &kind)
      {
        std::map<int, std::size_t> n_elements;
        std::size_t                i = 1;
        while (i < section.size())
        {
          const std::vector<long int> block = integers_of(section[i]);
          if (block.size() != 4 ||
              block[3] > static_cast<long int>(section.size() - i - 1))
            return broken_line("block of elements", section[i]);
          const int         type    = static_cast<int>(block[2]);
          const std::string problem = gmsh_type_problem(type, kind);
          if (!problem.empty())
            return problem;
          const std::size_t n_in_block = static_cast<std::size_t>(block[3]);
          for (std::size_t e = 1; e <= n_in_block; ++e)
            if (integers_of(section[i + e]).size() != 1 + gmsh_n_nodes(type))
              return broken_line("element", section[i + e]);
          n_elements[type] += n_in_block;
          i += n_in_block + 1;
        }
        return gmsh_counts_problem(n_elements, kind);
      }



      // Both versions begin with a count; no line holds two nodes
      std::string
      gmsh_nodes_problem(const Lines &section, const bool is_version_4)
      {
        const std::vector<double> head = numbers_of(section.front());
        if (is_version_4 ? head.size() < 2 || head[1] > double(section.size())
                         : head[0] != double(section.size() - 1))
          return "says it has " + section.front() +
                 " nodes (the line after "
                 "$Nodes) but lists " +
                 std::to_string(section.size() - 1) + " lines of them";
        for (std::size_t i = 1; i < section.size(); ++i)
        {
          const std::size_t n = numbers_of(section[i]).size();
          if (is_version_4 ? n == 0 : n != 4)
            return broken_line("node", section[i]);
        }
        return "";
      }
    } // namespace



    std::string
    gmsh_problem(const Lines &lines, const CellKind &kind)
    {
      Lines       format, nodes, elements;
      std::string problem = gmsh_section(lines, "MeshFormat", format);
      if (!problem.empty())
        return problem;
      const std::vector<double> head = numbers_of(format.front());
      if (head.size() != 3 || head[0] < 2. || head[0] > 4.1 ||
          (head[0] >= 3. && head[0] < 4.))
        return "has Gmsh's format " + in_quotes(format.front()) +
               "; versions 2, 4.0 and 4.1 are read";
      if (head[1] != 0.)
        return "is a binary Gmsh file; save it as ASCII";

      const bool is_version_4 = head[0] >= 4.;
      problem                 = gmsh_section(lines, "Nodes", nodes);
      if (problem.empty())
        problem = gmsh_section(lines, "Elements", elements);
      if (problem.empty())
        problem = gmsh_nodes_problem(nodes, is_version_4);
      if (!problem.empty())
        return problem;
      return is_version_4 ? gmsh4_elements_problem(elements, kind)
                          : gmsh2_elements_problem(elements, kind);
    }
  } // namespace MeshScanning
} // namespace MixedCracks
