// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_scan_abaqus_h
#define mixed_cracks_problem_geometries_mesh_scan_abaqus_h

#include <problem/geometries/mesh_scan_formats.h>

namespace MixedCracks
{
  namespace MeshScanning
  {
    std::string upper_case(std::string text);

    /// "*ELEMENT, TYPE=CPS4": the word and its options.
    struct AbaqusKeyword
    {
      std::string                        word; ///< with the star, upper case
      std::map<std::string, std::string> options;

      /// Empty where the option is not given.
      std::string
      value(const std::string &option) const
      {
        const auto found = options.find(option);
        return found == options.end() ? "" : found->second;
      }
    };

    struct AbaqusSet
    {
      std::string           name;
      std::vector<long int> members; ///< numbers of nodes or elements

      void
      add(const std::string &its_name, const long int number)
      {
        name = its_name;
        members.push_back(number);
      }
    };

    /// What became of an element: a cell, a possible face, or neither.
    struct AbaqusElement
    {
      long int                  cell = -1; ///< index
      std::vector<unsigned int> face;
    };

    /// A line of a *SURFACE.
    struct AbaqusSurfaceLine
    {
      std::string name;
      std::string what; ///< number or set
      int         side; ///< from 0; -1: of nodes
      std::string line;
    };

    /// Reads line after line. Labels are compared without regard to case.
    class AbaqusReader
    {
    public:
      AbaqusReader(const CellKind &kind, MeshContents &contents)
        : kind(kind)
        , contents(contents)
      {}

      /// A line with a star. This and the next two return a problem.
      std::string begin(const std::string &line);

      /// A line of data.
      std::string add_line(const std::string &line);

      /// What sets and surfaces refer to, when everything is known.
      std::string finish();

    private:
      std::string add_node(const std::string &line);
      std::string add_element(const std::string &line);
      std::string add_to_set(const std::string                &line,
                             const std::string                &option,
                             std::map<std::string, AbaqusSet> &sets);
      std::string add_to_surface(const std::string &line);
      std::string move_instance(const std::string &line);

      void        add_materials();
      std::string add_element_groups();
      std::string add_node_groups();
      std::string add_surface(const AbaqusSurfaceLine &surface);
      std::string add_side(const AbaqusSurfaceLine &surface,
                           long int                 element,
                           unsigned int             group);

      const CellKind &kind;
      MeshContents   &contents;

      AbaqusKeyword                     keyword;
      bool                              in_assembly = false;
      bool                              in_instance = false;
      std::vector<std::string>          parts, instances;
      std::map<long int, AbaqusElement> elements;
      std::map<std::string, AbaqusSet>  element_sets, node_sets;
      std::vector<AbaqusSurfaceLine>    surfaces;
      /// element sets and their materials
      std::vector<std::pair<std::string, long int>> sections;
    };
  } // namespace MeshScanning
} // namespace MixedCracks

#endif
