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
// Parts, instances and assemblies: one of each at most, not moved, since nodes
// of several instances have the same numbers. Other keywords, as of steps and
// loads, are skipped: the .prm says what is applied. Names have no case.

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



    namespace
    {
      std::string
      without_commas(std::string line)
      {
        std::replace(line.begin(), line.end(), ',', ' ');
        return line;
      }



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



      // The one element type that is a cell, one that can mark a boundary or
      // is of no use, or why it cannot be read
      enum class Use
      {
        cell,
        face,
        ignored,
        other_dimension,
        unusable
      };



      Use
      use_of(const std::string &type,
             const std::size_t  n_nodes,
             const CellKind    &kind)
      {
        const auto begins = [&](const char *word) {
          return starts_with(type, word);
        };
        const bool is_line = begins("T2D") || begins("T3D") || begins("B2") ||
                             begins("B3") || begins("R2D") || begins("RB") ||
                             begins("SPRING") || begins("DASHPOT") ||
                             begins("CONN") || begins("GAP") || begins("DC1D");
        const bool is_solid = begins("C3D");
        if (kind.dim == 2 && is_solid)
          return Use::other_dimension;
        if (n_nodes == 1 || begins("MASS") || begins("ROTARY"))
          return Use::ignored;
        if (kind.dim == 2)
        {
          if (n_nodes == 2)
            return Use::face;
          if (is_line)
            return Use::ignored;
          return n_nodes == 4 ? Use::cell : Use::unusable;
        }
        if (n_nodes == 8 && (is_solid || type.empty()))
          return Use::cell;
        if (is_solid)
          return Use::unusable;
        if (n_nodes == 4)
          return Use::face;
        return is_line || n_nodes <= 3 ? Use::ignored : Use::unusable;
      }



      std::string
      what_it_is(const std::string &type,
                 const std::size_t  n_nodes,
                 const std::string &line)
      {
        const bool  is_solid = starts_with(type, "C3D");
        std::string what =
          n_nodes == 3 ? "triangles"
          : n_nodes == 4 && is_solid
            ? "tetrahedra"
            : "elements of " + std::to_string(n_nodes) + " nodes";
        if (!type.empty())
          what += " (type " + type + ")";
        return what + " in the line " + in_quotes(line);
      }
    } // namespace



    std::string
    AbaqusReader::add_node(const std::string &line)
    {
      if (in_assembly && !in_instance)
        return ""; // reference points, numbered apart from the mesh
      const std::vector<double> node = numbers_of(without_commas(line));
      if (node.size() < 1u + kind.dim || !(node[0] >= 0. && node[0] < 1e9))
        return broken_line("node", line);
      const long int   number = std::lround(node[0]);
      dealii::Point<3> position;
      for (unsigned int d = 0; d < 3 && d + 1 < node.size(); ++d)
        position[d] = node[d + 1];
      if (!contents.add_node(number, position))
        return "lists a node twice: " + in_quotes(line);
      if (const auto set = keyword.options.find("NSET");
          set != keyword.options.end())
        node_sets[upper_case(set->second)].add(set->second, number);
      return "";
    }



    std::string
    AbaqusReader::add_element(const std::string &line)
    {
      if (in_assembly && !in_instance)
        return "";
      const std::vector<long int> entry = integers_of(without_commas(line));
      if (entry.size() < 2)
        return broken_line("element", line);
      const std::string type    = upper_case(keyword.value("TYPE"));
      const std::size_t n_nodes = entry.size() - 1;
      const Use         use     = use_of(type, n_nodes, kind);
      if (use == Use::other_dimension)
        return other_dimension("elements " + type, kind);
      if (use == Use::unusable)
        return unusable_element(what_it_is(type, n_nodes, line), kind);
      const auto nodes = contents.indices_of(entry.begin() + 1, entry.end());
      if (nodes.size() != n_nodes && use != Use::ignored)
        return unlisted_node(line);
      AbaqusElement     element;
      const std::string set = keyword.value("ELSET");
      if (use == Use::cell)
      {
        element.cell        = static_cast<long int>(contents.cells.size());
        const bool is_block = starts_with(upper_case(set), "EB");
        contents.cells.push_back(
          {entry[0], nodes, is_block ? trailing_number(set, 0) : 0});
      }
      else if (use == Use::face)
        element.face = nodes;
      if (!elements.emplace(entry[0], element).second)
        return "lists an element twice: " + in_quotes(line);
      if (!set.empty())
        element_sets[upper_case(set)].add(set, entry[0]);
      return "";
    }



    // Numbers, or names of other sets; with GENERATE first, last, increment
    std::string
    AbaqusReader::add_to_set(const std::string                &line,
                             const std::string                &option,
                             std::map<std::string, AbaqusSet> &sets)
    {
      const std::string name = keyword.value(option);
      if (name.empty())
        return "has a *" + option + " without a name (" + option + "=...)";
      AbaqusSet &set = sets[upper_case(name)];
      set.name       = name;
      if (in_assembly && !in_instance && option == "NSET" &&
          keyword.options.count("INSTANCE") == 0)
        return ""; // of reference points
      if (keyword.options.count("GENERATE") > 0)
      {
        const std::vector<long int> range = integers_of(without_commas(line));
        const long int              step  = range.size() == 3 ? range[2] : 1;
        if (range.size() < 2 || range.size() > 3 || step < 1 ||
            range[1] < range[0] || (range[1] - range[0]) / step > 10000000)
          return broken_line("range in a *" + option, line);
        for (long int number = range[0]; number <= range[1]; number += step)
          set.members.push_back(number);
        return "";
      }
      for (const std::string &item : split_list(line, ','))
        if (const std::vector<long int> number = integers_of(item);
            number.size() == 1)
          set.members.push_back(number[0]);
        else if (const auto other = sets.find(upper_case(item));
                 number.empty() && other != sets.end() &&
                 &other->second != &set)
          set.members.insert(set.members.end(),
                             other->second.members.begin(),
                             other->second.members.end());
        else
          return broken_line("*" + option, line);
      return "";
    }



    // An element or a set of them, and one of its sides: S1, S2, ..., of
    // shells E1, E2, ...; for TYPE=NODE a node or a set of them
    std::string
    AbaqusReader::add_to_surface(const std::string &line)
    {
      const std::string name = keyword.value("NAME");
      if (name.empty())
        return "has a *SURFACE without a name (NAME=...)";
      const std::vector<std::string> parts = split_list(line, ',');
      if (parts.empty())
        return broken_line("line of a *SURFACE", line);
      if (upper_case(keyword.value("TYPE")) == "NODE")
      {
        surfaces.push_back({name, parts.front(), -1, line});
        return "";
      }
      const char letter = parts.size() == 2 && parts[1].size() == 2
                            ? static_cast<char>(std::toupper(
                                static_cast<unsigned char>(parts[1][0])))
                            : ' ';
      if ((letter != 'S' && !(letter == 'E' && kind.dim == 2)) ||
          parts[1][1] < '1' || parts[1][1] > kind.last_side)
        return broken_line("side in a *SURFACE", line);
      surfaces.push_back({name, parts.front(), parts[1][1] - '1', line});
      return "";
    }



    std::string
    AbaqusReader::move_instance(const std::string &line)
    {
      for (const double number : numbers_of(without_commas(line)))
        if (number != 0.)
          return "moves or turns its instance " +
                 in_quotes(keyword.value("NAME")) + " (" + in_quotes(line) +
                 "); only nodes that stand where they belong are read";
      return "";
    }



    std::string
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
      if (std::find(generators.begin(), generators.end(), keyword.word) !=
          generators.end())
        return "uses " + keyword.word +
               "; only files are read that list every node and element";
      if (keyword.word == "*ASSEMBLY")
        in_assembly = true;
      else if (keyword.word == "*END ASSEMBLY")
        in_assembly = false;
      else if (keyword.word == "*END INSTANCE")
        in_instance = false;
      else if (keyword.word == "*INSTANCE" || keyword.word == "*PART")
      {
        const bool                is_part = keyword.word == "*PART";
        std::vector<std::string> &names   = is_part ? parts : instances;
        names.push_back(keyword.value("NAME"));
        in_instance = !is_part;
        if (names.size() > 1)
          return std::string("has two ") + (is_part ? "parts" : "instances") +
                 ", " + in_quotes(names[0]) + " and " + in_quotes(names[1]) +
                 "; merge them into one body, or save one of them alone";
      }
      else if (keyword.word.size() > 8 && keyword.options.count("ELSET") > 0 &&
               keyword.word.compare(keyword.word.size() - 7, 7, "SECTION") == 0)
      {
        const long int material =
          trailing_number(keyword.value("MATERIAL"), MeshContents::Group::none);
        if (material != MeshContents::Group::none)
          sections.emplace_back(keyword.value("ELSET"), material);
      }
      return "";
    }



    std::string
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
      return word == "*INSTANCE" ? move_instance(line) : "";
    }



    std::string
    scan_abaqus(const Lines    &lines,
                const CellKind &kind,
                MeshContents   &contents)
    {
      AbaqusReader reader(kind, contents);
      for (std::size_t i = 0; i < lines.size(); ++i)
      {
        std::string line = lines[i];
        if (starts_with(line, "**"))
          continue;
        // a keyword goes on in the next line after a comma
        if (line[0] == '*')
          while (line.back() == ',' && i + 1 < lines.size() &&
                 lines[i + 1][0] != '*')
            line += " " + lines[++i];
        const std::string problem =
          line[0] == '*' ? reader.begin(line) : reader.add_line(line);
        if (!problem.empty())
          return problem;
      }
      return reader.finish();
    }
  } // namespace MeshScanning
} // namespace MixedCracks
