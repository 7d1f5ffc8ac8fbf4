// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_scan_abaqus_h
#define mixed_cracks_problem_geometries_mesh_scan_abaqus_h

#include <problem/geometries/mesh_scan_formats.h>

#include <set>

namespace MixedCracks
{
  namespace MeshScanning
  {
    std::string upper_case(std::string text);

    std::string without_commas(std::string line);

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

    /// Where an instance of a part stands: x becomes a + R (x + shift - a), R
    /// the rotation about the axis from a to b.
    struct AbaqusPlacement
    {
      dealii::Tensor<1, 3> shift;
      dealii::Point<3>     a;
      dealii::Tensor<1, 3> axis;       ///< of length 1, or 0
      double               angle = 0.; ///< radian

      dealii::Point<3> operator()(const dealii::Point<3> &x) const;
    };

    struct AbaqusInstance
    {
      std::string     name, part; ///< in upper case
      AbaqusPlacement place;
      unsigned int    n_lines = 0; ///< of its place, that were read
    };

    /// The names and numbers that hold within an instance.
    struct AbaqusScope
    {
      /// Before the names of its sets, with a dot; empty when there is one
      /// instance at most.
      std::string prefix;
      long int    base = 0; ///< added to the numbers of the file
    };

    /// A line of a *SURFACE.
    struct AbaqusSurfaceLine
    {
      AbaqusScope scope;
      std::string name;
      std::string what; ///< number or set
      int         side; ///< from 0; -1: of nodes
      std::string line;
    };

    /// Reads line after line. Labels are compared without regard to case.
    class AbaqusReader
    {
    public:
      /// @p n_instances: how many the file has.
      AbaqusReader(const CellKind    &kind,
                   const unsigned int n_instances,
                   MeshContents      &contents)
        : kind(kind)
        , contents(contents)
        , n_instances(n_instances)
      {}

      /// The next line, without a comment, complete. This and the next return
      /// a problem.
      void add(const std::string &line);

      /// What sets and surfaces refer to, when everything is known.
      void finish();

    private:
      void begin(const std::string &line);
      void add_line(const std::string &line);

      /// Whether the line belongs to a part, which is kept for its instances.
      bool keep_for_part(const std::string &line);
      void begin_instance();
      void end_instance();
      void place_part(const std::string &part);

      void             add_node(const std::string &line);
      void             add_element(const std::string &line);
      void             add_to_set(const std::string                &line,
                                  const std::string                &option,
                                  std::map<std::string, AbaqusSet> &sets);
      void             add_to_surface(const std::string &line);
      void             move_instance(const std::string &line);
      AbaqusScope      scope_of(const std::string &instance) const;
      const AbaqusSet *find_set(const std::map<std::string, AbaqusSet> &sets,
                                const AbaqusScope                      &at,
                                const std::string &name) const;

      /// Make nodes of tied surfaces one; bodies that touch else are a problem.
      void join_bodies();
      void tie(const std::string &first, const std::string &second);
      void check_touching() const;
      std::vector<unsigned int> nodes_of_surface(const std::string &name) const;
      std::set<std::vector<unsigned int>>
             faces_of_surface(const std::string &name) const;
      double tolerance() const;

      void add_materials();
      void add_element_groups();
      void add_node_groups();
      void add_surface(const AbaqusSurfaceLine &surface);
      void add_side(const AbaqusSurfaceLine &surface,
                    long int                 element,
                    unsigned int             group);

      const CellKind &kind;
      MeshContents   &contents;

      AbaqusKeyword                keyword;
      unsigned int                 n_instances;
      bool                         in_assembly = false;
      bool                         in_instance = false;
      std::string                  open_part; ///< being kept
      std::map<std::string, Lines> parts;
      std::vector<AbaqusInstance>  instances;
      AbaqusScope                  scope;
      std::vector<long int>        body_of_node;
      std::vector<std::pair<std::string, std::string>> ties;
      std::map<long int, AbaqusElement>                elements;
      std::map<std::string, AbaqusSet>                 element_sets, node_sets;
      std::vector<AbaqusSurfaceLine>                   surfaces;
      /// element sets and their materials
      std::vector<std::pair<std::string, long int>> sections;
    };
  } // namespace MeshScanning
} // namespace MixedCracks

#endif
