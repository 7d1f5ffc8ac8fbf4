// SPDX-License-Identifier: GPL-2.0-or-later
// Gmsh's .msh, versions 2.x, 4.0 and 4.1 (Gmsh manual, "MSH file
// format"), as lines of text. Sections "$Name ... $EndName" in any order; used
// are
//
//   $MeshFormat      version, 0 for ASCII
//   $PhysicalNames   (dimension, number) -> name
//   $Entities        version 4: (dimension, tag) -> physical groups
//   $Nodes           and $ParametricNodes of version 2
//   $Elements        in mesh_scan_gmsh_elements.cc
//
// In version 2 an element names its physical group, in version 4 the geometric
// entity it lies on, which has the groups.

#include <base/text.h>

#include <problem/geometries/mesh_scan_formats.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      bool
      has_section(const Lines &lines, const std::string &name)
      {
        return std::find(lines.begin(), lines.end(), "$" + name) != lines.end();
      }



      // The lines between "$name" and "$Endname"
      Lines
      read_section(const Lines &lines, const std::string &name)
      {
        const auto begin = std::find(lines.begin(), lines.end(), "$" + name);
        if (begin == lines.end())
          throw MeshProblem("has no section $" + name);
        const auto end = std::find(begin, lines.end(), "$End" + name);
        if (end == lines.end())
          throw MeshProblem("ends before $End" + name);
        Lines section(begin + 1, end);
        if (section.empty() || numbers_of(section.front()).empty())
          throw MeshProblem("has an empty or broken section $" + name);
        return section;
      }



      // A count; then dimension, number and, in quotes, name
      void
      read_names(const Lines &section, GmshNames &names)
      {
        for (std::size_t i = 1; i < section.size(); ++i)
        {
          const std::string &line  = section[i];
          const std::size_t  begin = line.find('"');
          const std::size_t  end   = line.rfind('"');
          if (begin == std::string::npos || end == begin)
            throw broken_line("name of a physical group", line);
          const std::vector<long int> ids = integers_of(line.substr(0, begin));
          if (ids.size() != 2)
            throw broken_line("name of a physical group", line);
          names[{ids[0], ids[1]}] =
            single_spaced(line.substr(begin + 1, end - begin - 1));
        }
      }



      // Numbers of points, curves, surfaces, volumes; then a line for each:
      // tag, box (4.1: of points one corner), number of physical groups,
      // these with signs for directions, and more
      void
      read_entities(const Lines  &section,
                    const bool    is_4_1,
                    GmshEntities &entities)
      {
        const std::vector<long int> counts = integers_of(section.front());
        std::size_t                 n_all  = 0;
        for (const long int count : counts)
          n_all += static_cast<std::size_t>(count);
        if (counts.size() != 4 || n_all != section.size() - 1)
          throw broken_line("head of $Entities", section.front());
        std::size_t i = 0;
        for (long int dim = 0; dim < 4; ++dim)
          for (long int n = 0; n < counts[static_cast<std::size_t>(dim)]; ++n)
          {
            const std::string        &line   = section[++i];
            const std::vector<double> entry  = numbers_of(line);
            const std::size_t         before = is_4_1 && dim == 0 ? 4 : 7;
            if (entry.size() <= before || !(std::abs(entry[0]) < 1e9) ||
                !(entry[before] >= 0.) ||
                entry[before] > double(entry.size() - before - 1))
              throw broken_line("entity", line);
            std::vector<long int> &groups =
              entities[{dim, std::lround(entry[0])}];
            for (std::size_t g = 0; double(g) < entry[before]; ++g)
              if (std::abs(entry[before + 1 + g]) < 1e9)
                groups.push_back(std::abs(std::lround(entry[before + 1 + g])));
              else
                throw broken_line("entity", line);
          }
      }



      void
      add_node(const double               number,
               const std::vector<double> &numbers,
               const std::size_t          first,
               const std::string         &line,
               MeshContents              &contents)
      {
        if (numbers.size() < first + 3 ||
            !(number >= 0. && number < 2147483648.))
          throw broken_line("node", line);
        if (!contents.add_node(
              std::lround(number),
              {numbers[first], numbers[first + 1], numbers[first + 2]}))
          throw MeshProblem("lists a node twice: " + in_quotes(line));
      }



      // A count; then number and place, with more numbers if @p parametric
      void
      read_nodes_2(const Lines  &section,
                   const bool    parametric,
                   MeshContents &contents)
      {
        for (std::size_t i = 1; i < section.size(); ++i)
        {
          const std::vector<double> node = numbers_of(section[i]);
          if (node.empty() || (!parametric && node.size() != 4))
            throw broken_line("node", section[i]);
          add_node(node[0], node, 1, section[i], contents);
        }
      }



      // A head, then blocks: two of dimension and tag of an entity, whether
      // there are parametric coordinates, number of nodes. 4.0: a line for
      // each with number and place; 4.1: first all numbers, then all places.
      // Parametric coordinates stand behind the place.
      void
      read_nodes_4(const Lines  &section,
                   const bool    is_4_1,
                   MeshContents &contents)
      {
        std::size_t i = 1;
        while (i < section.size())
        {
          const std::vector<long int> block   = integers_of(section[i]);
          const std::size_t           n       = block.size() == 4
                                                  ? static_cast<std::size_t>(block[3])
                                                  : section.size();
          const std::size_t           n_lines = is_4_1 ? 2 * n : n;
          if (n_lines > section.size() - i - 1)
            throw broken_line("block of nodes", section[i]);
          for (std::size_t k = 1; k <= n; ++k)
          {
            const std::string        &place   = section[i + n_lines - n + k];
            const std::vector<double> numbers = numbers_of(place);
            const std::vector<double> tag     = numbers_of(section[i + k]);
            if (tag.empty() || (is_4_1 && tag.size() != 1))
              throw broken_line("node", section[i + k]);
            add_node(tag[0], numbers, is_4_1 ? 0 : 1, place, contents);
          }
          i += n_lines + 1;
        }
      }



      // Both versions begin with a count
      void
      read_nodes(const Lines  &section,
                 const double  version,
                 const bool    parametric,
                 MeshContents &contents)
      {
        const std::vector<double> head         = numbers_of(section.front());
        const bool                is_version_4 = version >= 4.;
        if (is_version_4 ? head.size() < 2 || head[1] > double(section.size())
                         : head[0] != double(section.size() - 1))
          throw MeshProblem("says it has " + section.front() +
                            " nodes (the line after $Nodes) but lists " +
                            std::to_string(section.size() - 1) +
                            " lines of them");
        is_version_4 ? read_nodes_4(section, version > 4.05, contents)
                     : read_nodes_2(section, parametric, contents);
        if (is_version_4 && head[1] != double(contents.nodes.size()))
          throw MeshProblem("says it has " + section.front() +
                            " (blocks, nodes, ...) but lists " +
                            std::to_string(contents.nodes.size()) + " nodes");
      }
    } // namespace



    void
    scan_gmsh(const Lines &lines, const CellKind &kind, MeshContents &contents)
    {
      const std::string format = read_section(lines, "MeshFormat").front();
      const std::vector<double> head = numbers_of(format);
      if (head.size() != 3 || head[0] < 2. || head[0] > 4.1 ||
          (head[0] >= 3. && head[0] < 4.))
        throw MeshProblem("has Gmsh's format " + in_quotes(format) +
                          "; versions 2, 4.0 and 4.1 are read");
      const double version = head[0];

      GmshNames    names;
      GmshEntities entities;
      if (has_section(lines, "PhysicalNames"))
        read_names(read_section(lines, "PhysicalNames"), names);
      if (version >= 4. && has_section(lines, "Entities"))
        read_entities(
          read_section(lines, "Entities"), version > 4.05, entities);
      // what Gmsh writes for Mesh.SaveParametric in version 2
      const bool parametric =
        version < 4. && has_section(lines, "ParametricNodes");
      read_nodes(read_section(lines, parametric ? "ParametricNodes" : "Nodes"),
                 version,
                 parametric,
                 contents);
      scan_gmsh_elements(read_section(lines, "Elements"),
                         version,
                         entities,
                         names,
                         kind,
                         contents);
    }
  } // namespace MeshScanning
} // namespace MixedCracks
