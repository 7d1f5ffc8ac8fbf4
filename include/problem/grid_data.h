// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_grid_data_h
#define mixed_cracks_problem_grid_data_h

#include <array>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// Values at the nodes of a grid parallel to the axes, as those of a picture
  /// or a table. Outside of the grid they go on as at its nearest edge.
  class GridData
  {
  public:
    using Coordinates = std::array<double, 3>;

    enum class Interpolation
    {
      nearest, ///< of the nearest node
      linear   ///< in each coordinate
    };

    /// @p axes: ascending coordinates of the nodes, at least one for each
    /// axis (just one: the values do not depend on it); mm. @p values: one
    /// for each node, x running fastest, then y.
    GridData(std::array<std::vector<double>, 3> axes,
             std::vector<double>                values,
             Interpolation                      interpolation);

    double value(const Coordinates &point) const;

  private:
    double at(const std::array<std::size_t, 3> &node) const;

    double linear(const Coordinates &point) const;

    std::array<std::vector<double>, 3> axes;
    std::vector<double>                values;
    Interpolation                      interpolation;
  };

  /// A gray-scale picture: row after row, the uppermost first; 0 is black, 1
  /// is white.
  struct Picture
  {
    std::size_t         width  = 0;
    std::size_t         height = 0;
    std::vector<double> values;
  };

  /// A table of values at points.
  struct Table
  {
    std::array<std::vector<double>, 3> axes;   ///< coordinates that occur
    std::vector<double>                values; ///< x running fastest
  };

  /// Whether a file with this text is meant to be a picture.
  bool looks_like_picture(const std::string &text);

  /// Read a portable gray map (PGM; P2 or P5). Returns why that is
  /// impossible, as the end of a sentence that begins "the file"; empty when
  /// it worked.
  std::string read_picture(const std::string &text, Picture &picture);

  /// Read lines of 'x, y, value' or, with @p dim = 3, 'x, y, z, value': the
  /// nodes of a grid, in any order. Numbers are separated by commas,
  /// semicolons or blanks; lines that begin with # and a first line of names
  /// are left out. Returns as read_picture().
  std::string read_table(const std::string &text, int dim, Table &table);
} // namespace MixedCracks

#endif
