// SPDX-License-Identifier: GPL-2.0-or-later
// Abaqus and CalculiX, .inp: lines with '*' are keywords with options, the
// lines after them their data. Read are
//
//   *NODE                       number, x, y, z
//   *ELEMENT, TYPE=, ELSET=     number, nodes: cells, and elements of one
//                               dimension less, which can name boundaries
//   *ELSET, *NSET               lists, GENERATE, sets in sets
//   *SURFACE                    sides of elements, or nodes
//   *... SECTION, ELSET=, MATERIAL=   material id: the number at the end of the
//                               name, or that of ELSET=EB1, EB2, ...
//
// Parts are read once for each of their instances, see
// mesh_scan_abaqus_bodies.cc. Other keywords, as of steps and loads, are
// skipped: the .prm says what is applied. Names have no case.

#include <base/ranges.h>
#include <base/text.h>

#include <problem/geometries/mesh_scan_abaqus.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace MixedCracks
{
  namespace MeshScanning
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



    namespace
    {
      // "*ELEMENT, TYPE=CPS4, ELSET=body": the word and its options, both in
      // upper case, with their values as they stand
      AbaqusKeyword
      keyword_of(const std::string &line)
      {
        AbaqusKeyword                  keyword;
        const std::vector<std::string> parts = split_list(line, ',');
        keyword.word = upper_case(single_spaced(parts.front()));
        for (std::size_t i = 1; i < parts.size(); ++i)
        {
          const std::size_t equals = parts[i].find('=');
          std::string       value;
          if (equals != std::string::npos)
            value = single_spaced(parts[i].substr(equals + 1));
          value.erase(std::remove(value.begin(), value.end(), '"'),
                      value.end());
          keyword
            .options[upper_case(single_spaced(parts[i].substr(0, equals)))] =
            value;
        }
        return keyword;
      }



      // The digits at the end: "EB12": 12; @p otherwise where there are none
      long int
      trailing_number(const std::string &text, const long int otherwise)
      {
        const std::size_t last = text.find_last_not_of("0123456789");
        const std::string digits =
          last == std::string::npos ? text : text.substr(last + 1);
        return digits.empty() || digits.size() > 9 ? otherwise
                                                   : std::stol(digits);
      }



      // What an element is by its type and number of nodes; null for what is
      // of no use. In 2-d shells count as cells, as do elements without a type.
      const ElementShape *
      shape_of(const std::string &type,
               const std::size_t  n_nodes,
               const int          dim)
      {
        const auto begins = [&](const char *word) {
          return starts_with(type, word);
        };
        if (begins("C3D") || begins("DC3D") ||
            (type.empty() && dim == 3 && n_nodes == 8))
          return shape_of_nodes(3, n_nodes);
        if (n_nodes == 1 || begins("MASS") || begins("ROTARY"))
          return shape_of_nodes(0, 1);
        const bool is_line = begins("T2D") || begins("T3D") || begins("B2") ||
                             begins("B3") || begins("R2D") || begins("RB") ||
                             begins("SPRING") || begins("DASHPOT") ||
                             begins("CONN") || begins("GAP") || begins("DC1D");
        if (n_nodes == 2 || is_line)
          return shape_of_nodes(1, std::min<std::size_t>(n_nodes, 3));
        return shape_of_nodes(2, n_nodes);
      }



      std::string
      type_in_words(const std::string &type,
                    const std::size_t  n_nodes,
                    const std::string &line)
      {
        std::string what = "elements of " + std::to_string(n_nodes) + " nodes";
        if (!type.empty())
          what += " (type " + type + ")";
        return what + " in the line " + in_quotes(line);
      }
    } // namespace



    void
    AbaqusReader::add_node(const std::string &line)
    {
      if (in_assembly && !in_instance)
        return; // reference points, numbered apart from the mesh
      const std::vector<double> node = numbers_of(without_commas(line));
      if (node.size() < 1u + kind.dim || !(node[0] >= 0. && node[0] < 1e9))
        throw broken_line("node", line);
      if (node.size() > 4)
        throw MeshProblem("has a node with " + std::to_string(node.size()) +
                          " numbers: " + in_quotes(line) +
                          "; a number and x, y, z are read (decimal commas?)");
      const long int   number = std::lround(node[0]);
      dealii::Point<3> position;
      for (unsigned int d = 0; d < 3 && d + 1 < node.size(); ++d)
        position[d] = node[d + 1];
      if (in_instance && !instances.empty())
        position = instances.back().place(position);
      if (!contents.add_node(number + scope.base, position))
        throw MeshProblem("lists a node twice: " + in_quotes(line));
      body_of_node.push_back(scope.base);
      if (const auto set = keyword.options.find("NSET");
          set != keyword.options.end())
        node_sets[upper_case(scope.prefix + set->second)].add(
          scope.prefix + set->second, number + scope.base);
    }



    void
    AbaqusReader::add_element(const std::string &line)
    {
      if (in_assembly && !in_instance)
        return;
      std::vector<long int> entry = integers_of(without_commas(line));
      if (entry.size() < 2)
        throw broken_line("element", line);
      const std::string   type    = upper_case(keyword.value("TYPE"));
      const std::size_t   n_nodes = entry.size() - 1;
      const ElementShape *shape   = shape_of(type, n_nodes, kind.dim);
      if (kind.dim == 2 && starts_with(type, "C3D"))
        throw other_dimension("elements " + type, kind);
      if (shape == nullptr)
        throw unusable_element(type_in_words(type, n_nodes, line), kind);
      // of a line the second of three nodes is that in the middle
      if (shape->dim == 1 && n_nodes == 3)
        std::swap(entry[2], entry[3]);
      for (std::size_t i = 1; i < entry.size(); ++i)
        entry[i] += scope.base;
      const std::string set      = keyword.value("ELSET");
      const bool        is_block = starts_with(upper_case(set), "EB");
      const Element     listed{
        entry[0], *shape, is_block ? trailing_number(set, 0) : 0, {}};
      MeshScanning::add_element(
        listed, entry.begin() + 1, line, kind, contents);
      AbaqusElement element;
      if (shape->dim == kind.dim)
        element.cell = static_cast<long int>(contents.cells.size()) - 1;
      else if (shape->dim == kind.dim - 1)
        element.face = contents.indices_of(
          entry.begin() + 1, entry.begin() + 1 + shape->n_corners);
      if (!elements.emplace(entry[0] + scope.base, element).second)
        throw MeshProblem("lists an element twice: " + in_quotes(line));
      if (!set.empty())
        element_sets[upper_case(scope.prefix + set)].add(scope.prefix + set,
                                                         entry[0] + scope.base);
    }



    // Numbers, or names of other sets; with GENERATE first, last, increment
    void
    AbaqusReader::add_to_set(const std::string                &line,
                             const std::string                &option,
                             std::map<std::string, AbaqusSet> &sets)
    {
      const std::string name = keyword.value(option);
      if (name.empty())
        throw MeshProblem("has a *" + option + " without a name (" + option +
                          "=...)");
      const AbaqusScope at  = keyword.options.count("INSTANCE") > 0
                                ? scope_of(keyword.value("INSTANCE"))
                                : scope;
      AbaqusSet        &set = sets[upper_case(scope.prefix + name)];
      set.name              = scope.prefix + name;
      if (in_assembly && !in_instance && option == "NSET" &&
          keyword.options.count("INSTANCE") == 0)
        return; // of reference points
      if (keyword.options.count("GENERATE") > 0)
      {
        const std::vector<long int> range = integers_of(without_commas(line));
        const long int              step  = range.size() == 3 ? range[2] : 1;
        if (range.size() < 2 || range.size() > 3 || step < 1 ||
            range[1] < range[0] || (range[1] - range[0]) / step > 10000000)
          throw broken_line("range in a *" + option, line);
        for (long int number = range[0]; number <= range[1]; number += step)
          set.members.push_back(number + at.base);
        return;
      }
      for (const std::string &item : split_list(line, ','))
        if (const std::vector<long int> number = integers_of(item);
            number.size() == 1)
          set.members.push_back(number[0] + at.base);
        else if (const AbaqusSet *other = find_set(sets, at, item);
                 number.empty() && other != nullptr && other != &set)
          append(set.members, other->members);
        else
          throw broken_line("*" + option, line);
    }



    // An element or a set of them, and one of its sides: S1, S2, ..., of
    // shells E1, E2, ...; for TYPE=NODE a node or a set of them
    void
    AbaqusReader::add_to_surface(const std::string &line)
    {
      const std::string name = keyword.value("NAME");
      if (name.empty())
        throw MeshProblem("has a *SURFACE without a name (NAME=...)");
      const std::vector<std::string> parts = split_list(line, ',');
      if (parts.empty())
        throw broken_line("line of a *SURFACE", line);
      if (upper_case(keyword.value("TYPE")) == "NODE")
      {
        surfaces.push_back(
          {scope, scope.prefix + name, parts.front(), -1, line});
        return;
      }
      const char letter = parts.size() == 2 && parts[1].size() == 2
                            ? static_cast<char>(std::toupper(
                                static_cast<unsigned char>(parts[1][0])))
                            : ' ';
      if ((letter != 'S' && !(letter == 'E' && kind.dim == 2)) ||
          parts[1][1] < '1' || parts[1][1] > '6')
        throw broken_line("side in a *SURFACE", line);
      surfaces.push_back(
        {scope, scope.prefix + name, parts.front(), parts[1][1] - '1', line});
    }



    void
    AbaqusReader::begin(const std::string &line)
    {
      keyword                                          = keyword_of(line);
      static const std::vector<std::string> generators = {"*NGEN",
                                                          "*NFILL",
                                                          "*NCOPY",
                                                          "*ELGEN",
                                                          "*ELCOPY",
                                                          "*SYSTEM",
                                                          "*INCLUDE"};
      if (contains(generators, keyword.word))
        throw MeshProblem(
          "uses " + keyword.word +
          "; only files are read that list every node and element");
      if (keyword.word == "*ASSEMBLY")
        in_assembly = true;
      else if (keyword.word == "*END ASSEMBLY")
        in_assembly = false;
      else if (keyword.word == "*END INSTANCE")
        return end_instance();
      else if (keyword.word == "*INSTANCE")
        return begin_instance();
      else if (keyword.word.size() > 8 && keyword.options.count("ELSET") > 0 &&
               keyword.word.compare(keyword.word.size() - 7, 7, "SECTION") == 0)
      {
        const long int material =
          trailing_number(keyword.value("MATERIAL"), MeshContents::Group::none);
        if (material != MeshContents::Group::none)
          sections.emplace_back(scope.prefix + keyword.value("ELSET"),
                                material);
      }
    }



    void
    AbaqusReader::add_line(const std::string &line)
    {
      const std::string &word = keyword.word;
      if (word == "*NODE")
        return add_node(line);
      if (word == "*ELEMENT")
        return add_element(line);
      if (word == "*ELSET")
        return add_to_set(line, "ELSET", element_sets);
      if (word == "*NSET")
        return add_to_set(line, "NSET", node_sets);
      if (word == "*SURFACE")
        return add_to_surface(line);
      if (word == "*TIE")
      {
        const std::vector<std::string> pair = split_list(line, ',');
        if (pair.size() < 2)
          throw broken_line("*TIE", line);
        ties.emplace_back(pair[0], pair[1]);
      }
      if (word == "*INSTANCE")
        move_instance(line);
    }



    void
    AbaqusReader::add(const std::string &line)
    {
      if (!keep_for_part(line))
        line[0] == '*' ? begin(line) : add_line(line);
    }



    namespace
    {
      // Without comments; keywords and elements that go on in the next line
      // after a comma are one
      Lines
      whole_lines(const Lines &lines)
      {
        Lines whole;
        bool  in_elements = false;
        for (std::size_t i = 0; i < lines.size(); ++i)
        {
          std::string line = lines[i];
          if (starts_with(line, "**"))
            continue;
          if (line[0] == '*')
            in_elements = starts_with(upper_case(line), "*ELEMENT");
          if (line[0] == '*' || in_elements)
            while (line.back() == ',' && i + 1 < lines.size() &&
                   lines[i + 1][0] != '*')
              line += " " + lines[++i];
          whole.push_back(line);
        }
        return whole;
      }
    } // namespace



    void
    scan_abaqus(const Lines    &lines,
                const CellKind &kind,
                MeshContents   &contents)
    {
      const Lines  whole       = whole_lines(lines);
      unsigned int n_instances = 0;
      for (const std::string &line : whole)
        n_instances += starts_with(upper_case(line), "*INSTANCE");
      AbaqusReader reader(kind, n_instances, contents);
      for (const std::string &line : whole)
        reader.add(line);
      reader.finish();
    }
  } // namespace MeshScanning
} // namespace MixedCracks
