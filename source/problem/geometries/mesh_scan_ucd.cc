// SPDX-License-Identifier: GPL-2.0-or-later
// UCD of AVS, ASCII: a head of five numbers, of nodes, cells and three that
// count data; a line "number x y z" for each node and "number material type
// nodes" for each cell. Cells of one dimension less mark boundaries by their
// material, from 1; data behind the cells are not read.

#include <base/text.h>

#include <problem/geometries/mesh_scan_formats.h>

#include <sstream>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      void
      add_node(const std::string &line, MeshContents &contents)
      {
        const std::vector<double> node = numbers_of(line);
        if (node.size() != 4 || !(node[0] >= 0. && node[0] < 1e9))
          throw broken_line("node", line);
        if (!contents.add_node(static_cast<long int>(node[0]),
                               {node[1], node[2], node[3]}))
          throw MeshProblem("lists a node twice: " + in_quotes(line));
      }



      void
      add_cell(const std::string &line,
               const CellKind    &kind,
               MeshContents      &contents,
               bool              &has_faces)
      {
        std::istringstream in(line);
        long int           number, material;
        std::string        type, rest;
        if (!(in >> number >> material >> type) || material < 0 ||
            material > 2147483647)
          throw broken_line("cell", line);
        const ElementShape *shape = shape_of_ucd(type);
        if (shape == nullptr)
          throw unusable_element("cells of the type " + in_quotes(type), kind);
        std::getline(in, rest);
        const std::vector<long int> numbers = integers_of(rest);
        if (numbers.size() != shape->n_nodes)
          throw broken_line("cell", line);
        Element element{number, *shape, material, {}};
        if (shape->dim == kind.dim - 1 && material > 0)
          element.groups.push_back(contents.group(material, ""));
        has_faces = has_faces || shape->dim == kind.dim - 1;
        add_element(element, numbers.begin(), line, kind, contents);
      }
    } // namespace



    void
    scan_ucd(const Lines &lines, const CellKind &kind, MeshContents &contents)
    {
      const std::vector<double> head = numbers_of(lines.front());
      if (!(head[0] > 0. && head[1] > 0.) ||
          head[0] + head[1] > double(lines.size() - 1))
        throw MeshProblem("says it has " + in_quotes(lines.front()) +
                          " (nodes, cells, ...) but lists " +
                          std::to_string(lines.size() - 1) + " lines");
      const std::size_t n_nodes   = static_cast<std::size_t>(head[0]);
      const std::size_t n_cells   = static_cast<std::size_t>(head[1]);
      bool              has_faces = false;
      for (std::size_t i = 1; i <= n_nodes + n_cells; ++i)
        i <= n_nodes ? add_node(lines[i], contents)
                     : add_cell(lines[i], kind, contents, has_faces);
      if (contents.cells.empty())
        throw no_cells(has_faces, kind);
    }
  } // namespace MeshScanning
} // namespace MixedCracks
