// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_crack_path_field_h
#define mixed_cracks_cracks_crack_path_field_h

#include <cracks/crack_path.h>

#include <map>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// The phase field in the damaged cells: as a graph of nodes, and as a
  /// function of place.
  class DamageField
  {
  public:
    using Node                    = unsigned int;
    static constexpr Node no_node = static_cast<Node>(-1);

    /// @p broken: nodes with a smaller phase field are broken
    DamageField(const std::vector<DamagedCell> &cells, double broken);

    /// Bilinear within the cells; 1 outside.
    double value(const dealii::Point<2> &point) const;

    /// The size of cells with broken nodes, mm; 0 without any.
    double
    cell_size() const
    {
      return size;
    }

    std::vector<dealii::Point<2>>  points;     ///< of the nodes, mm
    std::vector<double>            values;     ///< of the phase field
    std::vector<std::vector<Node>> neighbours; ///< across edges and diagonals

  private:
    using Box = std::pair<long, long>;

    Node find_node(const dealii::Point<2> &point) const;
    Node node_at(const dealii::Point<2> &point);
    void add_cell(const DamagedCell &cell);
    void link(Node a, Node b);
    void link_hanging_nodes(const DamagedCell &cell);
    Box  box_of(const dealii::Point<2> &point, double box_size) const;

    double
    node_box() const
    {
      return 4. * tolerance;
    }

    std::vector<DamagedCell>                 cells;
    std::map<Box, std::vector<unsigned int>> cells_in_box;
    std::map<Box, std::vector<Node>>         nodes_in_box;
    double                                   size      = 0.;
    double                                   box_size  = 1.;
    double                                   tolerance = 1e-9;
  };
} // namespace MixedCracks

#endif
