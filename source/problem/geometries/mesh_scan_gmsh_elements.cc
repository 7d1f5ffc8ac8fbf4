// SPDX-License-Identifier: GPL-2.0-or-later
// $Elements of Gmsh. Elements of the dimension of the mesh are cells, their
// physical group is the material id (0 without one); those of one dimension
// less mark boundaries by theirs; points, and in 3-d lines, are skipped.
// Elements of second order count by their corners; those of higher order end
// the reading.

#include <base/text.h>

#include <problem/geometries/mesh_scan_formats.h>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      // Not of what has more than two nodes at an edge, and what is no cell of
      // these dimensions
      const ElementShape &
      known_shape(const long int type, const std::string &line)
      {
        const ElementShape *shape = shape_of_gmsh(type);
        if (shape == nullptr)
          throw MeshProblem("has elements of Gmsh's type " +
                            std::to_string(type) + " (in the line " +
                            in_quotes(line) +
                            "); elements of first and second order are read "
                            "(Mesh.ElementOrder = 1)");
        return *shape;
      }



      // One pass over a section of elements
      struct Reader
      {
        const GmshEntities &entities;
        const GmshNames    &names;
        const CellKind     &kind;
        MeshContents       &contents;
        bool                has_faces = false;

        std::string
        name_of(const long int dim, const long int number) const
        {
          const auto name = names.find({dim, number});
          return name == names.end() ? "" : name->second;
        }



        // @p groups: the physical ones it is in
        void
        add(const std::vector<long int> &entry,
            const std::size_t            first_node,
            const ElementShape          &shape,
            const std::vector<long int> &groups,
            const std::string           &line)
        {
          Element element{entry[0], shape, 0, {}};
          if (shape.dim == kind.dim && groups.size() > 1)
            throw two_materials(groups, line);
          if (shape.dim == kind.dim && !groups.empty())
            element.material = groups[0];
          if (shape.dim == kind.dim - 1)
          {
            has_faces = true;
            for (const long int group : groups)
              element.groups.push_back(
                contents.group(group, name_of(shape.dim, group)));
          }
          add_element(element,
                      entry.begin() + static_cast<std::ptrdiff_t>(first_node),
                      line,
                      kind,
                      contents);
        }



        MeshProblem
        two_materials(const std::vector<long int> &groups,
                      const std::string           &line) const
        {
          return MeshProblem(
            std::string("has ") + (kind.dim == 2 ? "a surface" : "a volume") +
            " in two physical groups, " +
            in_words({groups[0], name_of(kind.dim, groups[0])}) + " and " +
            in_words({groups[1], name_of(kind.dim, groups[1])}) +
            ", but a cell has one material (element " + in_quotes(line) + ")");
        }



        // Version 2: after the number of elements, a line for each: number,
        // type, number of tags, tags, nodes; the first tag is the physical
        // group or 0
        void
        read_2(const Lines &section)
        {
          if (numbers_of(section.front())[0] != double(section.size() - 1))
            throw MeshProblem("says it has " + section.front() +
                              " elements but lists " +
                              std::to_string(section.size() - 1));
          for (std::size_t i = 1; i < section.size(); ++i)
          {
            const std::vector<long int> entry = integers_of(section[i]);
            if (entry.size() < 4)
              throw broken_line("element", section[i]);
            const ElementShape &shape = known_shape(entry[1], section[i]);
            if (static_cast<long int>(entry.size()) !=
                3 + entry[2] + shape.n_nodes)
              throw broken_line("element", section[i]);
            std::vector<long int> groups;
            if (entry[2] > 0 && entry[3] > 0)
              groups.push_back(entry[3]);
            add(entry,
                3 + static_cast<std::size_t>(entry[2]),
                shape,
                groups,
                section[i]);
          }
        }



        // Version 4: a head, then blocks: dimension and tag of an entity (4.0:
        // the other way around), type, number of elements; and a line for
        // each element: number, nodes
        void
        read_4(const Lines &section, const bool is_4_1)
        {
          std::size_t i = 1;
          while (i < section.size())
          {
            const std::vector<long int> block = integers_of(section[i]);
            if (block.size() != 4 ||
                block[3] > static_cast<long int>(section.size() - i - 1))
              throw broken_line("block of elements", section[i]);
            const ElementShape &shape = known_shape(block[2], section[i]);
            const auto          entity =
              entities.find({block[is_4_1 ? 0 : 1], block[is_4_1 ? 1 : 0]});
            const std::vector<long int> groups = entity == entities.end()
                                                   ? std::vector<long int>()
                                                   : entity->second;
            const std::size_t           n = static_cast<std::size_t>(block[3]);
            for (std::size_t e = 1; e <= n; ++e)
            {
              const std::string          &line  = section[i + e];
              const std::vector<long int> entry = integers_of(line);
              if (entry.size() != 1 + shape.n_nodes)
                throw broken_line("element", line);
              add(entry, 1, shape, groups, line);
            }
            i += n + 1;
          }
        }
      };
    } // namespace



    void
    scan_gmsh_elements(const Lines        &section,
                       const double        version,
                       const GmshEntities &entities,
                       const GmshNames    &names,
                       const CellKind     &kind,
                       MeshContents       &contents)
    {
      Reader reader{entities, names, kind, contents};
      version >= 4. ? reader.read_4(section, version > 4.05)
                    : reader.read_2(section);
      if (contents.cells.empty())
        throw no_cells(reader.has_faces, kind);
    }
  } // namespace MeshScanning
} // namespace MixedCracks
