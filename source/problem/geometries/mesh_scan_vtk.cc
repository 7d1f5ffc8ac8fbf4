// SPDX-License-Identifier: GPL-2.0-or-later
// Legacy VTK, ASCII, an UNSTRUCTURED_GRID (VTK User's Guide, "VTK file
// formats"):
//
//   # vtk DataFile Version 2.0
//   title
//   ASCII
//   DATASET UNSTRUCTURED_GRID
//   POINTS n type                  x y z of each
//   CELLS n size                   number of nodes and nodes of each cell; from
//                                  version 5 on OFFSETS and CONNECTIVITY
//   CELL_TYPES n                   vtkCellType of each
//   CELL_DATA n, SCALARS or FIELD  material ids, or of elements of one
//   dimension
//                                  less the ids of boundaries
//
// Which of the data are the ids the name says; the first of this list that is
// there: gmsh:physical, material, MaterialID, material_id, CellEntityIds (what
// Gmsh writes: the numbers of curves and surfaces). Nodes and cells are counted
// from 0. Unknown parts are passed over line by line.

#include <base/names.h>
#include <base/text.h>

#include <problem/geometries/mesh_scan_abaqus.h>

#include <algorithm>
#include <sstream>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      const std::vector<std::string> names_of_ids = {"GMSH:PHYSICAL",
                                                     "MATERIAL",
                                                     "MATERIALID",
                                                     "MATERIAL_ID",
                                                     "CELLENTITYIDS"};

      // Lines one after the other
      class Words
      {
      public:
        Words(const Lines &lines, const std::size_t first)
          : lines(lines)
          , next_line(first)
        {}

        // The next line, split
        bool
        next(std::vector<std::string> &words)
        {
          words.clear();
          if (next_line == lines.size())
            return false;
          std::istringstream in(lines[next_line++]);
          std::string        word;
          while (in >> word)
            words.push_back(word);
          return !words.empty();
        }

        // Whether the next line begins so
        bool
        peek_is(const std::string &word) const
        {
          return next_line < lines.size() &&
                 starts_with(upper_case(lines[next_line]), word);
        }

        // Of the section @p part. Numbers of lines that hold anything else are
        // none.
        std::vector<double>
        numbers(const std::size_t n, const std::string &part)
        {
          std::vector<double> all;
          while (all.size() < n)
          {
            if (next_line == lines.size())
              throw MeshProblem("ends in the section " + in_quotes(part));
            const std::string        &line = lines[next_line++];
            const std::vector<double> some = numbers_of(line);
            if (some.empty() || all.size() + some.size() > n)
              throw broken_line("line in the section " + part, line);
            all.insert(all.end(), some.begin(), some.end());
          }
          return all;
        }

      private:
        const Lines &lines;
        std::size_t  next_line;
      };



      bool
      is_index(const double number)
      {
        return number >= 0. && number < 2147483648. &&
               number == static_cast<double>(static_cast<long int>(number));
      }



      class VtkReader
      {
      public:
        VtkReader(const Lines      &lines,
                  const std::size_t first,
                  const CellKind   &kind,
                  MeshContents     &contents)
          : words(lines, first)
          , kind(kind)
          , contents(contents)
        {}

        void
        read()
        {
          std::vector<std::string> line;
          while (words.next(line))
            read_part(line);
          make_cells();
        }

      private:
        // A count at a place of a line
        std::size_t
        count(const std::vector<std::string> &line, const std::size_t place)
        {
          const std::vector<long int> n = place < line.size()
                                            ? integers_of(line[place])
                                            : std::vector<long int>();
          if (n.size() != 1)
            throw broken_line("line", join_names(line, " "));
          return static_cast<std::size_t>(n[0]);
        }



        void
        read_part(const std::vector<std::string> &line)
        {
          const std::string word = upper_case(line[0]);
          if (word == "DATASET" &&
              (line.size() < 2 || upper_case(line[1]) != "UNSTRUCTURED_GRID"))
            throw MeshProblem("is a VTK file with " +
                              in_quotes(join_names(line, " ")) +
                              "; allowed is an UNSTRUCTURED_GRID");
          if (word == "POINTS")
            read_points(count(line, 1));
          else if (word == "CELLS")
            read_cells(count(line, 1), count(line, 2));
          else if (word == "CELL_TYPES")
            types = words.numbers(count(line, 1), word);
          else if (word == "CELL_DATA" || word == "POINT_DATA")
            in_cell_data = word == "CELL_DATA";
          else if (word == "SCALARS")
            read_scalars(line);
          else if (word == "FIELD")
            read_field(count(line, 2));
        }



        void
        read_points(const std::size_t n)
        {
          const std::vector<double> all = words.numbers(3 * n, "POINTS");
          for (std::size_t i = 0; i < n; ++i)
            contents.add_node(static_cast<long int>(i),
                              {all[3 * i], all[3 * i + 1], all[3 * i + 2]});
        }



        // @p second: how many numbers follow, or, of version 5, how long the
        // list of nodes is
        void
        read_cells(const std::size_t n, const std::size_t second)
        {
          std::vector<std::string> line;
          if (words.peek_is("OFFSETS"))
          {
            words.next(line);
            const std::vector<double> offsets = words.numbers(n, "OFFSETS");
            words.next(line);
            const std::vector<double> nodes =
              words.numbers(second, "CONNECTIVITY");
            for (std::size_t i = 0; i + 1 < offsets.size(); ++i)
              add_list(nodes, offsets[i], offsets[i + 1]);
            return;
          }
          const std::vector<double> all = words.numbers(second, "CELLS");
          for (std::size_t i = 0; i < all.size(); i += cells.back().size() + 1)
            add_list(all, double(i) + 1., double(i) + 1. + all[i]);
        }



        void
        add_list(const std::vector<double> &all,
                 const double               begin,
                 const double               end)
        {
          cells.emplace_back();
          if (!is_index(begin) || !is_index(end) || end < begin ||
              end > double(all.size()))
            throw MeshProblem("has a broken section CELLS");
          for (std::size_t i = static_cast<std::size_t>(begin); double(i) < end;
               ++i)
            cells.back().push_back(
              is_index(all[i]) ? static_cast<long int>(all[i]) : -1);
        }



        // SCALARS name type [number of components]; LOOKUP_TABLE name; numbers
        void
        read_scalars(const std::vector<std::string> &line)
        {
          const std::size_t n_components = line.size() > 3 ? count(line, 3) : 1;
          std::vector<std::string> table;
          if (!in_cell_data || line.size() < 2 || n_components != 1 ||
              !words.next(table))
            return;
          keep(line[1], words.numbers(cells.size(), "SCALARS"));
        }



        // Arrays: name, components, tuples, type; numbers
        void
        read_field(const std::size_t n_arrays)
        {
          std::vector<std::string> line;
          for (std::size_t i = 0; i < n_arrays && words.next(line); ++i)
          {
            if (upper_case(line[0]) == "METADATA")
              return;
            const std::size_t n_components = count(line, 1);
            const std::size_t n            = count(line, 2);
            if (!in_cell_data || n_components != 1 || n != cells.size())
              return;
            keep(line[0], words.numbers(n, "FIELD"));
          }
        }



        void
        keep(const std::string &name, const std::vector<double> &numbers)
        {
          ids[upper_case(name)] = numbers;
        }



        void
        make_cells()
        {
          if (cells.empty() || types.size() != cells.size())
            throw MeshProblem("is a VTK file with " +
                              std::to_string(cells.size()) + " CELLS and " +
                              std::to_string(types.size()) + " CELL_TYPES");
          const std::vector<double> *ids_of_cells = nullptr;
          for (const std::string &name : names_of_ids)
            if (ids_of_cells == nullptr && ids.count(name) > 0)
              ids_of_cells = &ids.at(name);
          bool has_faces = false;
          for (std::size_t i = 0; i < cells.size(); ++i)
          {
            const double id = ids_of_cells == nullptr ? 0. : (*ids_of_cells)[i];
            make_cell(i, id, has_faces);
          }
          if (contents.cells.empty())
            throw no_cells(has_faces, kind);
        }



        void
        make_cell(const std::size_t i, const double id, bool &has_faces)
        {
          std::vector<long int> nodes = cells[i];
          long int              type =
            is_index(types[i]) ? static_cast<long int>(types[i]) : 0;
          // pixels and voxels are counted in pairs
          if ((type == 8 && nodes.size() == 4) ||
              (type == 11 && nodes.size() == 8))
          {
            for (std::size_t k = 2; k < nodes.size(); k += 4)
              std::swap(nodes[k], nodes[k + 1]);
            type = type == 8 ? 9 : 12;
          }
          const std::string   where = "cell " + std::to_string(i);
          const ElementShape *shape = shape_of_vtk(type);
          if (shape == nullptr)
            throw unusable_element("cells of VTK's type " +
                                     std::to_string(type) + " (" + where + ")",
                                   kind);
          if (nodes.size() != shape->n_nodes)
            throw broken_line("list of nodes", where);
          Element element{static_cast<long int>(i), *shape, 0, {}};
          if (is_index(id))
            element.material = static_cast<long int>(id);
          if (shape->dim == kind.dim - 1 && is_index(id) && id > 0.)
            element.groups.push_back(contents.group(element.material, ""));
          has_faces = has_faces || shape->dim == kind.dim - 1;
          add_element(element, nodes.begin(), where, kind, contents);
        }



        Words                                      words;
        const CellKind                            &kind;
        MeshContents                              &contents;
        std::vector<std::vector<long int>>         cells;
        std::vector<double>                        types;
        std::map<std::string, std::vector<double>> ids;
        bool                                       in_cell_data = false;
      };
    } // namespace



    void
    scan_vtk(const Lines &lines, const CellKind &kind, MeshContents &contents)
    {
      // an empty title is no line
      for (std::size_t i = 1; i < std::min<std::size_t>(lines.size(), 3); ++i)
        if (upper_case(lines[i]) == "ASCII")
          return VtkReader(lines, i + 1, kind, contents).read();
      throw MeshProblem("is a VTK file without the line ASCII");
    }
  } // namespace MeshScanning
} // namespace MixedCracks
