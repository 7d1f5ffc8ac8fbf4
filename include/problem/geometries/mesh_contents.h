// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_contents_h
#define mixed_cracks_problem_geometries_mesh_contents_h

#include <deal.II/base/point.h>

#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace MixedCracks
{
  /// Why a mesh file cannot be used, as the end of a sentence that begins "the
  /// file".
  class MeshProblem : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// What the text of a mesh file says, whatever its format: nodes, cells of
  /// the dimension it is read for, and groups of their faces.
  struct MeshContents
  {
    /// A part of the boundary as the file knows it: a physical group, a
    /// surface, a set, a material of faces.
    struct Group
    {
      static constexpr long int none = -1;

      long int    number = none;
      std::string name; ///< may be empty
    };

    struct Node
    {
      /// Of one that the file does not list
      static constexpr long int none = -1;

      long int         number; ///< of the file
      dealii::Point<3> position;
    };

    struct Cell
    {
      long int                  number; ///< of the file
      std::vector<unsigned int> nodes;  ///< corners: around, in 3-d twice
      long int                  material;
    };

    /// A face that is in a group; in two of them it is listed twice.
    struct Face
    {
      std::vector<unsigned int> nodes;
      unsigned int              group;
    };

    /// A group given by its nodes: the faces that have all theirs in it.
    struct NodeSet
    {
      std::vector<unsigned int> nodes;
      unsigned int              group;
    };

    std::vector<Node>    nodes;
    std::vector<Cell>    cells;
    std::vector<Face>    faces;
    std::vector<NodeSet> node_sets;
    std::vector<Group>   groups;

    /// How many of the cells had nodes between their corners, which are not
    /// used.
    unsigned int n_second_order = 0;

    /// Where a file numbers nodes of several bodies apart, those of body b are
    /// known by their number plus b times this.
    static constexpr long int numbers_per_body = 4294967296;

    /// Returns false when there is one of that number already.
    bool add_node(long int number, const dealii::Point<3> &position);

    /// Indices of nodes with these numbers of the file; shorter than
    /// @p numbers when one is not listed.
    template <typename Iterator>
    std::vector<unsigned int>
    indices_of(Iterator begin, const Iterator end) const
    {
      std::vector<unsigned int> result;
      for (; begin != end; ++begin)
        if (const auto node = index_by_number.find(*begin);
            node != index_by_number.end())
          result.push_back(node->second);
      return result;
    }

    /// The group of that number and name, made when there is none.
    unsigned int group(long int number, const std::string &name);

  private:
    std::unordered_map<long int, unsigned int>    index_by_number;
    std::unordered_map<std::string, unsigned int> group_by_key;
  };
} // namespace MixedCracks

#endif
