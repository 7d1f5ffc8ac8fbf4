// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/text.h>
#include <problem/geometries/mesh_scan_formats.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      std::string
      upper_case(std::string text)
      {
        std::transform(text.begin(), text.end(), text.begin(), [](char c) {
          return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        });
        return text;
      }



      std::string
      without_commas(std::string line)
      {
        std::replace(line.begin(), line.end(), ',', ' ');
        return line;
      }



      // What an Abaqus file lists and refers to. The reader looks up the
      // elements of surfaces and sets by their position, unchecked.
      struct AbaqusContents
      {
        const CellKind        kind;
        bool                  solid = false; // the last *ELEMENT: of 3-d
        std::set<long int>    nodes;
        std::vector<long int> elements;
        std::vector<long int> used_elements; // by surfaces and sets
      };



      // What is wrong with elements of that many nodes
      std::string
      abaqus_nodes_problem(const std::size_t     n_nodes,
                           const AbaqusContents &contents)
      {
        if (n_nodes == contents.kind.n_nodes)
          return "";
        if (contents.kind.dim == 3 && !contents.solid && n_nodes == 4)
          return other_dimension("quadrilaterals", contents.kind);
        return unusable_element(n_nodes == 3 ? "triangles"
                                : contents.solid && n_nodes == 4
                                  ? "tetrahedra"
                                  : "elements of " + std::to_string(n_nodes) +
                                      " nodes",
                                contents.kind);
      }



      std::string
      add_abaqus_node(const std::string &line, AbaqusContents &contents)
      {
        const std::vector<double> node = numbers_of(without_commas(line));
        if (node.size() < 1u + contents.kind.dim || !(std::abs(node[0]) < 1e9))
          return broken_line("node", line);
        contents.nodes.insert(std::lround(node[0]));
        return "";
      }



      std::string
      add_abaqus_element(const std::string &line, AbaqusContents &contents)
      {
        const std::vector<long int> entry = integers_of(without_commas(line));
        if (entry.size() < 2)
          return broken_line("element", line);
        const std::string problem =
          abaqus_nodes_problem(entry.size() - 1, contents);
        if (!problem.empty())
          return problem;
        for (std::size_t i = 1; i < entry.size(); ++i)
          if (contents.nodes.count(entry[i]) == 0)
            return "has cells with nodes that it does not list: " +
                   in_quotes(line);
        contents.elements.push_back(entry[0]);
        return "";
      }



      // An element and one of its sides, S1 to S4 or S6; or a set of elements
      std::string
      add_abaqus_side(const std::string &line, AbaqusContents &contents)
      {
        const std::vector<std::string> parts = split_list(line, ',');
        if (parts.size() != 2 || parts[1].size() != 2 ||
            std::toupper(static_cast<unsigned char>(parts[1][0])) != 'S' ||
            parts[1][1] < '1' || parts[1][1] > contents.kind.last_side)
          return broken_line("side in a *SURFACE", line);
        const std::vector<long int> element = integers_of(parts[0]);
        if (!element.empty())
          contents.used_elements.push_back(element[0]);
        return "";
      }



      std::string
      add_abaqus_set(const std::string &line, AbaqusContents &contents)
      {
        const std::vector<long int> elements =
          integers_of(without_commas(line));
        if (elements.empty())
          return broken_line("*ELSET", line);
        contents.used_elements.insert(
          contents.used_elements.end(), elements.begin(), elements.end());
        return "";
      }



      std::string
      abaqus_reference_problem(const AbaqusContents &contents)
      {
        const long int n_elements =
          static_cast<long int>(contents.elements.size());
        if (contents.nodes.empty() || n_elements == 0)
          return "is an Abaqus file without " +
                 std::string(contents.nodes.empty() ? "*NODE" : "*ELEMENT") +
                 " lines";
        if (contents.used_elements.empty())
          return "";
        for (long int i = 0; i < n_elements; ++i)
          if (contents.elements[i] != i + 1)
            return "has surfaces or sets, but its elements are not numbered "
                   "1, 2, 3, ... (found " +
                   std::to_string(contents.elements[i]) + " in place of " +
                   std::to_string(i + 1) + "); renumber them";
        for (const long int element : contents.used_elements)
          if (element < 1 || element > n_elements)
            return "has a surface or set with element " +
                   std::to_string(element) + ", which it does not list";
        return "";
      }



      std::string
      ucd_cell_problem(const std::string          &line,
                       const CellKind             &kind,
                       std::map<std::string, int> &n_cells)
      {
        std::istringstream in(line);
        long int           number, material;
        std::string        type, rest;
        if (!(in >> number >> material >> type) || material < 0)
          return broken_line("cell", line);
        if (type == "hex" && kind.dim == 2)
          return other_dimension("hexahedra", kind);
        if (type != "line" && type != "quad" && type != "hex")
          return unusable_element("cells of the type " + in_quotes(type), kind);
        std::getline(in, rest);
        if (integers_of(rest).size() != (type == "hex"    ? 8
                                         : type == "quad" ? 4
                                                          : 2))
          return broken_line("cell", line);
        ++n_cells[type];
        return "";
      }
    } // namespace



    std::string
    abaqus_problem(const Lines &lines, const CellKind &kind)
    {
      using Reader = std::string (*)(const std::string &, AbaqusContents &);
      const std::map<std::string, Reader> readers = {
        {"*NODE", add_abaqus_node},
        {"*ELEMENT", add_abaqus_element},
        {"*SURFACE", add_abaqus_side},
        {"*ELSET", add_abaqus_set}};

      AbaqusContents contents{kind, false, {}, {}, {}};
      std::string    keyword;
      for (const std::string &line : lines)
        if (line.compare(0, 2, "**") == 0)
          continue;
        else if (line[0] == '*')
        {
          const std::string whole = upper_case(line);
          keyword                 = split_list(whole, ',').front();
          contents.solid          = whole.find("C3D") != std::string::npos;
          if (keyword == "*ELEMENT" && contents.solid && kind.dim == 2)
            return other_dimension("elements C3D", kind);
        }
        else if (const auto reader = readers.find(keyword);
                 reader != readers.end())
        {
          const std::string problem = reader->second(line, contents);
          if (!problem.empty())
            return problem;
        }
      return abaqus_reference_problem(contents);
    }



    std::string
    ucd_problem(const Lines &lines, const CellKind &kind)
    {
      const std::vector<double> head = numbers_of(lines.front());
      if (!(head[0] > 0. && head[1] > 0.) ||
          head[0] + head[1] > double(lines.size() - 1))
        return "says it has " + in_quotes(lines.front()) +
               " (nodes, cells, ...) but lists " +
               std::to_string(lines.size() - 1) + " lines";
      const std::size_t n_nodes = static_cast<std::size_t>(head[0]);
      const std::size_t n_cells = static_cast<std::size_t>(head[1]);
      for (std::size_t i = 1; i <= n_nodes; ++i)
        if (numbers_of(lines[i]).size() != 4)
          return broken_line("node", lines[i]);
      std::map<std::string, int> n_by_type;
      for (std::size_t i = n_nodes + 1; i <= n_nodes + n_cells; ++i)
      {
        const std::string problem = ucd_cell_problem(lines[i], kind, n_by_type);
        if (!problem.empty())
          return problem;
      }
      if (n_by_type[kind.ucd_type] > 0)
        return "";
      const std::string nothing = "no " + kind.name;
      return n_by_type["quad"] > 0 ? other_dimension(nothing, kind)
                                   : unusable_element(nothing, kind);
    }
  } // namespace MeshScanning
} // namespace MixedCracks
