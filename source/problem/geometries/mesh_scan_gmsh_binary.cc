// SPDX-License-Identifier: GPL-2.0-or-later
// Gmsh's binary .msh, versions 2.x and 4.1 (Gmsh manual, "MSH file format"):
// heads and ends of sections are lines, what is between them in
//
//   $MeshFormat        after its line the int 1, in the order of its bytes
//   $Entities          4.1
//   $Nodes             and $ParametricNodes of version 2
//   $Elements
//
// is bytes; int has 4, size_t and double have 8. They become the lines of an
// ASCII file, digit for digit ("%.17g"), so that one reader knows what they
// mean and what can be wrong with them. Counts are believed only as far as
// there are bytes. Other sections are passed over.
//
// Why not Gmsh's library (GridIn::read_msh, gmsh::open): see
// doc/your_own_mesh.md.

#include <base/text.h>

#include <problem/geometries/mesh_bytes.h>
#include <problem/geometries/mesh_scan_formats.h>

#include <cstdint>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      // What stands behind the line "$MeshFormat": the head of the file
      std::vector<double>
      format_of(const std::string &bytes)
      {
        const std::size_t begin = starts_with(bytes, "\xEF\xBB\xBF") ? 3 : 0;
        if (bytes.compare(begin, 11, "$MeshFormat") != 0)
          return {};
        const std::size_t first = bytes.find('\n', begin);
        if (first == std::string::npos)
          return {};
        const std::size_t end = bytes.find('\n', first + 1);
        if (end == std::string::npos || end - first > 80)
          return {};
        return numbers_of(bytes.substr(first + 1, end - first - 1));
      }



      using Int  = std::int32_t;
      using Size = std::uint64_t;

      // From and to
      struct Translation
      {
        ByteReader &bytes;
        Lines      &lines;

        // as many of them on one line
        template <typename Number>
        void
        copy(NumberLine &line, const Size n)
        {
          for (Size i = 0; i < n && !bytes.is_broken; ++i)
            line << bytes.get<Number>();
        }



        // 4.1: counts of the four dimensions; of each entity tag, box, physical
        // groups and, but of points, the entities around it
        void
        entities()
        {
          Size       counts[4];
          NumberLine head;
          for (Size &count : counts)
          {
            count = bytes.get_count(36);
            head << count;
          }
          lines.push_back(head.text);
          for (int dim = 0; dim < 4; ++dim)
            for (Size n = 0; n < counts[dim] && !bytes.is_broken; ++n)
            {
              NumberLine line;
              copy<Int>(line, 1);
              copy<double>(line, dim == 0 ? 3 : 6);
              const Size n_groups = bytes.get_count(sizeof(Int));
              line << n_groups;
              copy<Int>(line, n_groups);
              if (dim > 0)
              {
                const Size n_around = bytes.get_count(sizeof(Int));
                line << n_around;
                copy<Int>(line, n_around);
              }
              lines.push_back(line.text);
            }
        }



        // 4.1: head; blocks of dimension, tag, whether parametric, count;
        // numbers of all nodes; places, with one more number for each dimension
        // of the block where they are parametric
        void
        nodes_4()
        {
          const Size n_blocks = head_4();
          for (Size b = 0; b < n_blocks && !bytes.is_broken; ++b)
          {
            NumberLine block;
            const Int  dim = bytes.get<Int>(), tag = bytes.get<Int>();
            const Int  parametric = bytes.get<Int>();
            const Size n          = bytes.get_count(sizeof(Size) + 24);
            block << dim << tag << parametric << n;
            lines.push_back(block.text);
            const Size more = parametric != 0 && dim > 0 && dim < 4
                                ? static_cast<Size>(dim)
                                : 0;
            each_line<Size>(n, 1);
            each_line<double>(n, 3 + more);
          }
        }



        Size
        head_4()
        {
          NumberLine head;
          const Size n_blocks = bytes.get_count(16);
          head << n_blocks;
          copy<Size>(head, 3);
          lines.push_back(head.text);
          return n_blocks;
        }



        template <typename Number>
        void
        each_line(const Size n, const Size n_numbers)
        {
          for (Size i = 0; i < n && !bytes.is_broken; ++i)
          {
            NumberLine line;
            copy<Number>(line, n_numbers);
            lines.push_back(line.text);
          }
        }



        // 4.1: head; blocks of dimension, tag, type, count; for each element
        // number and nodes
        void
        elements_4()
        {
          const Size n_blocks = head_4();
          for (Size b = 0; b < n_blocks && !bytes.is_broken; ++b)
          {
            NumberLine block;
            copy<Int>(block, 2);
            const Int  type    = bytes.get<Int>();
            const Size n_nodes = nodes_of(type);
            const Size n       = bytes.get_count(sizeof(Size) * (1 + n_nodes));
            block << type << n;
            lines.push_back(block.text);
            if (n_nodes == 0)
              bytes.skip_to("$EndElements"); // the type will be refused
            else
              each_line<Size>(n, 1 + n_nodes);
          }
        }



        static Size
        nodes_of(const Int type)
        {
          const ElementShape *shape = shape_of_gmsh(type);
          return shape == nullptr ? 0 : shape->n_nodes;
        }



        // 2: a line with the count; for each number and place; of parametric
        // ones also dimension and tag of the entity, and a number for each
        // dimension of a curve or surface
        void
        nodes_2(const bool parametric)
        {
          const Size n = line_with_count(sizeof(Int) + 24);
          for (Size i = 0; i < n && !bytes.is_broken; ++i)
          {
            NumberLine line;
            copy<Int>(line, 1);
            copy<double>(line, 3);
            if (parametric)
            {
              const Int dim = bytes.get<Int>();
              line << dim;
              copy<Int>(line, 1);
              copy<double>(line, dim == 1 || dim == 2 ? Size(dim) : 0);
            }
            lines.push_back(line.text);
          }
        }



        Size
        line_with_count(const Size size)
        {
          const std::string           line   = bytes.line();
          const std::vector<long int> counts = integers_of(line);
          lines.push_back(line);
          if (counts.size() != 1)
          {
            bytes.is_broken = true;
            return 0;
          }
          return bytes.count(static_cast<Size>(counts[0]), size);
        }



        // 2: a line with the count; blocks of type, count, number of tags; for
        // each element number, tags, nodes
        void
        elements_2()
        {
          const Size n_all = line_with_count(sizeof(Int));
          Size       n     = 0;
          while (n < n_all && !bytes.is_broken)
          {
            const Int  type    = bytes.get<Int>();
            const Int  n_here  = bytes.get<Int>();
            const Int  n_tags  = bytes.get<Int>();
            const Size n_nodes = nodes_of(type);
            if (n_here < 1 || n_tags < 0 || n_tags > 1000)
              bytes.is_broken = true;
            for (Int i = 0; i < n_here && !bytes.is_broken; ++i, ++n)
            {
              NumberLine line;
              copy<Int>(line, 1);
              line << type << n_tags;
              copy<Int>(line, static_cast<Size>(n_tags) + n_nodes);
              lines.push_back(line.text);
              if (n_nodes == 0) // the type will be refused
              {
                bytes.skip_to("$EndElements");
                n = n_all;
                break;
              }
            }
          }
        }
      };



      void
      require_readable(const std::vector<double> &format, ByteReader &bytes)
      {
        const std::string ascii = "; save it as ASCII (Mesh.Binary = 0)";
        if (format[0] >= 3. && format[0] < 4.05)
          throw MeshProblem(
            "is a binary Gmsh file of another version than 2 and 4.1, the "
            "ones that are read of binary files");
        if (format[2] != 8.)
          throw MeshProblem(
            "is a binary Gmsh file with numbers of other than 8 bytes" + ascii);
        if (bytes.get<Int>() != 1)
          throw MeshProblem(
            "is a binary Gmsh file of a machine with another order of "
            "bytes, or one with changed line ends" +
            ascii);
        bytes.line();
      }
    } // namespace



    bool
    is_binary_gmsh(const std::string &bytes)
    {
      const std::vector<double> format = format_of(bytes);
      return format.size() == 3 && format[0] >= 2. && format[0] <= 4.1 &&
             format[1] == 1.;
    }



    Lines
    gmsh_as_lines(const std::string &all)
    {
      const std::vector<double> format = format_of(all);
      const bool                is_4   = format[0] >= 4.;
      ByteReader                bytes(all);
      bytes.line();
      const std::string version = bytes.line();
      require_readable(format, bytes);
      Lines       lines = {"$MeshFormat", version};
      Translation translation{bytes, lines};
      while (bytes.n_left() > 0)
      {
        const std::string line = bytes.line();
        if (!line.empty())
          lines.push_back(line);
        if (line == "$Entities")
          translation.entities();
        else if (line == "$Nodes" || line == "$ParametricNodes")
          is_4 ? translation.nodes_4()
               : translation.nodes_2(line == "$ParametricNodes");
        else if (line == "$Elements")
          is_4 ? translation.elements_4() : translation.elements_2();
        else if (starts_with(line, "$") && !starts_with(line, "$End") &&
                 line != "$PhysicalNames")
          bytes.skip_to("$End" + line.substr(1));
        if (bytes.is_broken)
          throw MeshProblem(
            "is a binary Gmsh file that is cut off or broken in the "
            "section " +
            in_quotes(line));
      }
      return lines;
    }
  } // namespace MeshScanning
} // namespace MixedCracks
