// SPDX-License-Identifier: GPL-2.0-or-later
// A function on a grid parallel to the axes, x_i in direction d not evenly
// spaced. In the cell of the grid around x, with f_d in [0, 1] the fraction of
// the way to the next line,
//
//   linear    sum over the 2^3 corners c of  value_c prod_d w_d,
//             w_d = f_d where c_d = 1, 1 - f_d where c_d = 0
//   nearest   the value at the corner with c_d = 1 where f_d >= 1/2
//
// Beyond the grid it goes on as constant. In 2-d the third axis has one node.

#include <problem/grid_data.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace MixedCracks
{
  namespace
  {
    // Position between the nodes i and i + 1 of an axis.
    struct Place
    {
      std::size_t i;
      double      fraction; // 0 at node i, 1 at the next one
    };

    Place
    place_on(const std::vector<double> &axis, const double x)
    {
      if (x <= axis.front())
        return {0, 0.};
      if (x >= axis.back())
        return {axis.size() - 1, 0.};
      const std::size_t above =
        std::upper_bound(axis.begin(), axis.end(), x) - axis.begin();
      return {above - 1,
              (x - axis[above - 1]) / (axis[above] - axis[above - 1])};
    }
  } // namespace



  GridData::GridData(std::array<std::vector<double>, 3> axes,
                     std::vector<double>                values,
                     const Interpolation                interpolation)
    : axes(std::move(axes))
    , values(std::move(values))
    , interpolation(interpolation)
  {
    AssertDimension(this->values.size(),
                    this->axes[0].size() * this->axes[1].size() *
                      this->axes[2].size());
  }



  double
  GridData::at(const std::array<std::size_t, 3> &node) const
  {
    return values[(node[2] * axes[1].size() + node[1]) * axes[0].size() +
                  node[0]];
  }



  double
  GridData::linear(const Coordinates &point) const
  {
    std::array<Place, 3> places;
    for (unsigned int d = 0; d < 3; ++d)
      places[d] = place_on(axes[d], point[d]);
    double sum = 0.;
    for (unsigned int corner = 0; corner < 8; ++corner)
    {
      double                     weight = 1.;
      std::array<std::size_t, 3> node;
      for (unsigned int d = 0; d < 3; ++d)
      {
        const bool next = (corner >> d) % 2 == 1;
        weight *= next ? places[d].fraction : 1. - places[d].fraction;
        node[d] = places[d].i + (next ? 1 : 0);
      }
      // nodes without weight may lie beyond the last one
      if (weight > 0.)
        sum += weight * at(node);
    }
    return sum;
  }



  double
  GridData::value(const Coordinates &point) const
  {
    if (interpolation == Interpolation::linear)
      return linear(point);
    std::array<std::size_t, 3> node;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const Place place = place_on(axes[d], point[d]);
      node[d]           = place.i + (place.fraction < 0.5 ? 0 : 1);
    }
    return at(node);
  }
} // namespace MixedCracks
