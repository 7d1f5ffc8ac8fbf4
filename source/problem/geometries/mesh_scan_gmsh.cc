// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/text.h>
#include <problem/geometries/mesh_scan_formats.h>

#include <algorithm>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      // What is wrong with a Gmsh element type; empty for quadrilaterals and
      // for the lines and points that mark boundaries
      std::string
      gmsh_type_problem(const int type)
      {
        switch (type)
        {
          case 1:
          case 3:
          case 15:
            return "";
          case 2:
            return unusable_element("triangles");
          case 4:
          case 5:
          case 6:
          case 7:
            return unusable_element("three-dimensional cells");
          default:
            return unusable_element("elements of Gmsh's type " +
                                    std::to_string(type));
        }
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
      gmsh2_elements_problem(const Lines &section, int &n_quadrilaterals)
      {
        if (numbers_of(section.front())[0] != double(section.size() - 1))
          return "says it has " + section.front() + " elements but lists " +
                 std::to_string(section.size() - 1);
        for (std::size_t i = 1; i < section.size(); ++i)
        {
          const std::vector<long int> entry = integers_of(section[i]);
          if (entry.size() < 4)
            return broken_line("element", section[i]);
          const int         type    = static_cast<int>(entry[1]);
          const std::string problem = gmsh_type_problem(type);
          if (!problem.empty())
            return problem;
          const long int n_nodes = type == 3 ? 4 : (type == 1 ? 2 : 1);
          if (static_cast<long int>(entry.size()) != 3 + entry[2] + n_nodes)
            return broken_line("element", section[i]);
          n_quadrilaterals += type == 3;
        }
        return "";
      }



      // Version 4: a head, then blocks: two of entity's dimension and tag,
      // type, number of elements; and a line for each element: number, nodes
      std::string
      gmsh4_elements_problem(const Lines &section, int &n_quadrilaterals)
      {
        std::size_t i = 1;
        while (i < section.size())
        {
          const std::vector<long int> block = integers_of(section[i]);
          if (block.size() != 4 ||
              block[3] > static_cast<long int>(section.size() - i - 1))
            return broken_line("block of elements", section[i]);
          const int         type    = static_cast<int>(block[2]);
          const std::string problem = gmsh_type_problem(type);
          if (!problem.empty())
            return problem;
          const std::size_t n_nodes    = type == 3 ? 4 : (type == 1 ? 2 : 1);
          const std::size_t n_elements = static_cast<std::size_t>(block[3]);
          for (std::size_t e = 1; e <= n_elements; ++e)
            if (integers_of(section[i + e]).size() != 1 + n_nodes)
              return broken_line("element", section[i + e]);
          n_quadrilaterals += type == 3 ? static_cast<int>(n_elements) : 0;
          i += n_elements + 1;
        }
        return "";
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
    gmsh_problem(const Lines &lines)
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
      int n_quadrilaterals = 0;
      problem              = is_version_4
                               ? gmsh4_elements_problem(elements, n_quadrilaterals)
                               : gmsh2_elements_problem(elements, n_quadrilaterals);
      if (problem.empty() && n_quadrilaterals == 0)
        problem = unusable_element("no quadrilaterals");
      return problem;
    }
  } // namespace MeshScanning
} // namespace MixedCracks
