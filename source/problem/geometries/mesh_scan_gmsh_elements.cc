// SPDX-License-Identifier: GPL-2.0-or-later
// $Elements of Gmsh. Elements of the dimension of the mesh are cells, their
// physical group is the material id (0 without one); those of one dimension
// less mark boundaries by theirs; points, and in 3-d lines, are skipped. Any
// other kind ends the reading: triangles and elements of higher order would
// leave a hole.

#include <base/text.h>

#include <problem/geometries/mesh_scan_formats.h>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      // Numbers of Gmsh's manual, "MSH file format"
      enum GmshType : long int
      {
        line_type          = 1,
        triangle_type      = 2,
        quadrilateral_type = 3,
        hexahedron_type    = 5,
        point_type         = 15
      };



      // Nodes of those elements that are cells or mark boundaries, by type
      unsigned int
      n_nodes_of(const long int type)
      {
        switch (type)
        {
          case line_type:
            return 2;
          case quadrilateral_type:
            return 4;
          case hexahedron_type:
            return 8;
          default:
            return 1;
        }
      }



      std::string
      name_of_type(const long int type)
      {
        static const std::map<long int, std::string> names = {
          {triangle_type, "triangles"},
          {4, "tetrahedra"},
          {hexahedron_type, "hexahedra"},
          {6, "prisms"},
          {7, "pyramids"},
          {8, "three-node lines"},
          {9, "six-node triangles"},
          {10, "nine-node quadrilaterals"},
          {11, "ten-node tetrahedra"},
          {12, "27-node hexahedra"},
          {16, "eight-node quadrilaterals"},
          {17, "20-node hexahedra"}};
        const std::string number = "Gmsh's type " + std::to_string(type);
        const auto        known  = names.find(type);
        if (known == names.end())
          return "elements of " + number;
        return known->second + (type > 7 ? " (" + number + ")" : "");
      }



      // What is wrong with a Gmsh element type; empty for the cells of the
      // dimension and for what marks boundaries
      std::string
      type_problem(const long int     type,
                   const std::string &line,
                   const CellKind    &kind)
      {
        if (type == line_type || type == quadrilateral_type ||
            type == point_type || type == kind.gmsh_type)
          return "";
        const std::string found =
          name_of_type(type) + " (in the line " + in_quotes(line) + ")";
        const bool is_solid = type >= 4 && type <= 7;
        return kind.dim == 2 && is_solid ? other_dimension(found, kind)
                                         : unusable_element(found, kind);
      }



      // One pass over a section of elements
      struct Reader
      {
        const GmshEntities &entities;
        const GmshNames    &names;
        const CellKind     &kind;
        MeshContents       &contents;
        std::size_t         n_quadrilaterals = 0;

        std::string
        name_of(const long int dim, const long int number) const
        {
          const auto name = names.find({dim, number});
          return name == names.end() ? "" : name->second;
        }



        // @p groups: the physical ones it is in
        std::string
        add(const std::vector<long int> &entry,
            const std::size_t            first_node,
            const long int               type,
            const std::vector<long int> &groups,
            const std::string           &line)
        {
          const auto nodes = contents.indices_of(
            entry.begin() + static_cast<std::ptrdiff_t>(first_node),
            entry.end());
          if (nodes.size() != n_nodes_of(type))
            return unlisted_node(line);
          n_quadrilaterals += type == quadrilateral_type;
          if (type == kind.gmsh_type)
          {
            if (groups.size() > 1)
              return two_materials(groups, line);
            contents.cells.push_back(
              {entry[0], nodes, groups.empty() ? 0 : groups[0]});
          }
          else if (nodes.size() == kind.n_face_nodes)
            for (const long int group : groups)
              contents.faces.push_back(
                {nodes, contents.group(group, name_of(kind.dim - 1, group))});
          return "";
        }



        std::string
        two_materials(const std::vector<long int> &groups,
                      const std::string           &line) const
        {
          return std::string("has ") +
                 (kind.dim == 2 ? "a surface" : "a volume") +
                 " in two physical groups, " +
                 in_words({groups[0], name_of(kind.dim, groups[0])}) + " and " +
                 in_words({groups[1], name_of(kind.dim, groups[1])}) +
                 ", but a cell has one material (element " + in_quotes(line) +
                 ")";
        }



        // Version 2: after the number of elements, a line for each: number,
        // type, number of tags, tags, nodes; the first tag is the physical
        // group or 0
        std::string
        read_2(const Lines &section)
        {
          if (numbers_of(section.front())[0] != double(section.size() - 1))
            return "says it has " + section.front() + " elements but lists " +
                   std::to_string(section.size() - 1);
          for (std::size_t i = 1; i < section.size(); ++i)
          {
            const std::vector<long int> entry = integers_of(section[i]);
            if (entry.size() < 4)
              return broken_line("element", section[i]);
            const long int type    = entry[1];
            std::string    problem = type_problem(type, section[i], kind);
            if (!problem.empty())
              return problem;
            if (static_cast<long int>(entry.size()) !=
                3 + entry[2] + n_nodes_of(type))
              return broken_line("element", section[i]);
            std::vector<long int> groups;
            if (entry[2] > 0 && entry[3] > 0)
              groups.push_back(entry[3]);
            problem = add(entry,
                          3 + static_cast<std::size_t>(entry[2]),
                          type,
                          groups,
                          section[i]);
            if (!problem.empty())
              return problem;
          }
          return "";
        }



        // Version 4: a head, then blocks: dimension and tag of an entity (4.0:
        // the other way around), type, number of elements; and a line for
        // each element: number, nodes
        std::string
        read_4(const Lines &section, const bool is_4_1)
        {
          std::size_t i = 1;
          while (i < section.size())
          {
            const std::vector<long int> block = integers_of(section[i]);
            if (block.size() != 4 ||
                block[3] > static_cast<long int>(section.size() - i - 1))
              return broken_line("block of elements", section[i]);
            const long int type    = block[2];
            std::string    problem = type_problem(type, section[i], kind);
            if (!problem.empty())
              return problem;
            const auto entity =
              entities.find({block[is_4_1 ? 0 : 1], block[is_4_1 ? 1 : 0]});
            const std::vector<long int> groups = entity == entities.end()
                                                   ? std::vector<long int>()
                                                   : entity->second;
            const std::size_t           n = static_cast<std::size_t>(block[3]);
            for (std::size_t e = 1; e <= n; ++e)
            {
              const std::string          &line  = section[i + e];
              const std::vector<long int> entry = integers_of(line);
              if (entry.size() != 1 + n_nodes_of(type))
                return broken_line("element", line);
              problem = add(entry, 1, type, groups, line);
              if (!problem.empty())
                return problem;
            }
            i += n + 1;
          }
          return "";
        }
      };
    } // namespace



    std::string
    scan_gmsh_elements(const Lines        &section,
                       const double        version,
                       const GmshEntities &entities,
                       const GmshNames    &names,
                       const CellKind     &kind,
                       MeshContents       &contents)
    {
      Reader            reader{entities, names, kind, contents};
      const std::string problem = version >= 4.
                                    ? reader.read_4(section, version > 4.05)
                                    : reader.read_2(section);
      if (!problem.empty() || !contents.cells.empty())
        return problem;
      const std::string nothing = "no " + kind.name;
      return kind.dim == 3 && reader.n_quadrilaterals > 0
               ? other_dimension(nothing, kind)
               : unusable_element(nothing, kind);
    }
  } // namespace MeshScanning
} // namespace MixedCracks
