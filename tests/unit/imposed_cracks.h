// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_tests_imposed_cracks_h
#define mixed_cracks_tests_imposed_cracks_h

#include <cracks/crack_path.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

/// Phase fields imposed around known curves, on rectangles of square cells.
namespace MixedCracks
{
  namespace Testing
  {
    using dealii::Point;
    using dealii::Tensor;
    using Curve = std::vector<Point<2>>; ///< points close to each other, mm

    inline Curve
    curve(const std::function<Point<2>(double)> &at, const unsigned int n = 240)
    {
      Curve points;
      for (unsigned int i = 0; i <= n; ++i)
        points.push_back(at(static_cast<double>(i) / n));
      return points;
    }

    inline Curve
    straight(const Point<2> &a, const Point<2> &b)
    {
      return curve([&](const double s) { return a + s * (b - a); });
    }

    /// The nearest place: its number along the curve, the distance to the
    /// curve, and the side on which the point lies.
    struct Nearest
    {
      double       distance = std::numeric_limits<double>::infinity();
      unsigned int number   = 0;
      bool         is_left  = false;
    };

    inline Nearest
    nearest(const Curve &points, const Point<2> &point)
    {
      Nearest result;
      for (unsigned int i = 1; i < points.size(); ++i)
      {
        const Tensor<1, 2> along = points[i] - points[i - 1],
                           gap   = point - points[i - 1];
        const double s           = (gap * along) / along.norm_square();
        const double distance =
          (gap - std::min(1., std::max(0., s)) * along).norm();
        if (distance < result.distance)
          result = {distance, i, along[0] * gap[1] - along[1] * gap[0] > 0.};
      }
      return result;
    }

    /// The largest distance of a point of one polyline to the other.
    inline double
    largest_distance(const Curve &from, const Curve &to)
    {
      double largest = 0.;
      for (std::size_t i = 1; i < from.size(); ++i)
        for (unsigned int k = 0; k <= 4; ++k)
          largest = std::max(
            largest,
            nearest(to, from[i - 1] + 0.25 * k * (from[i] - from[i - 1]))
              .distance);
      return largest;
    }

    // optimal profiles
    inline double
    wu(const double d)
    {
      return d < 0.5 * M_PI ? std::sin(d) : 1.;
    }

    inline double
    at1(const double d)
    {
      return d < 2. ? 1. - (1. - 0.5 * d) * (1. - 0.5 * d) : 1.;
    }

    inline double
    at2(const double d)
    {
      return 1. - std::exp(-d);
    }

    /// A body with cracks.
    struct Imposed
    {
      std::vector<Curve> curves;
      double             l = 0.3, h = 0.15; ///< mm
      Point<2>           lower{0., 0.}, upper{12., 6.};
      double (*profile)(double) = wu;
      /// nodes moved, in h
      double distortion = 0.;
      /// cells farther than this (in l) from the curves are twice as large
      double coarse_beyond = std::numeric_limits<double>::infinity();
      /// the broken band is one, two or three nodes wide, at random
      bool wide = false;
      /// where there is no material
      std::function<bool(const Point<2> &)> is_void = [](const Point<2> &) {
        return false;
      };

      // the same number for the same place, in [0, 1)
      static double
      random(const long i, const long j)
      {
        const double x = std::sin(12.9898 * i + 78.233 * j) * 43758.5453;
        return x - std::floor(x);
      }

      double
      phase_field(const Point<2> &point) const
      {
        double value = 1.;
        for (const Curve &points : curves)
        {
          const Nearest place    = nearest(points, point);
          double        distance = place.distance;
          if (wide)
          {
            // pieces of the band are one node wider on either side
            const long piece = std::lround(std::floor(
              place.number * points[0].distance(points[1]) / (3. * h)));
            const bool more  = random(piece, place.is_left) > 0.5;
            distance         = std::max(0., distance - (more ? 1.5 : 0.5) * h);
          }
          value = std::min(value, profile(distance / l));
        }
        return value;
      }

      Point<2>
      position(const long i, const long j) const
      {
        return Point<2>(lower[0] + h * (i + distortion * (random(i, j) - 0.5)),
                        lower[1] +
                          h * (j + distortion * (random(j, -i) - 0.5)));
      }

      // of a block of two by two cells
      bool
      is_coarse(const long i, const long j) const
      {
        if (coarse_beyond == std::numeric_limits<double>::infinity())
          return false;
        double distance = std::numeric_limits<double>::infinity();
        for (const Curve &points : curves)
          distance = std::min(
            distance, nearest(points, position(2 * i + 1, 2 * j + 1)).distance);
        return distance > coarse_beyond * l;
      }

      // with the values that hanging nodes must have
      double
      nodal_value(const long i, const long j) const
      {
        for (unsigned int d = 0; d < 2; ++d)
        {
          const long along = d == 0 ? i : j, across = d == 0 ? j : i;
          if (along % 2 == 0 || across % 2 != 0)
            continue;
          const long block = (along - 1) / 2, side = across / 2;
          if (d == 0 ? is_coarse(block, side) || is_coarse(block, side - 1)
                     : is_coarse(side, block) || is_coarse(side - 1, block))
            return d == 0 ? 0.5 * (phase_field(position(i - 1, j)) +
                                   phase_field(position(i + 1, j)))
                          : 0.5 * (phase_field(position(i, j - 1)) +
                                   phase_field(position(i, j + 1)));
        }
        return phase_field(position(i, j));
      }

      void
      add_cell(const long                i,
               const long                j,
               const long                size,
               std::vector<DamagedCell> &cells) const
      {
        DamagedCell cell;
        Point<2>    center;
        for (unsigned int v = 0; v < 4; ++v)
        {
          const long p = i + size * (v % 2), q = j + size * (v / 2);
          cell.vertices[v] = position(p, q);
          cell.phase_field[v] =
            size == 1 ? nodal_value(p, q) : phase_field(cell.vertices[v]);
          center += 0.25 * cell.vertices[v];
        }
        if (!is_void(center) && *std::min_element(cell.phase_field.begin(),
                                                  cell.phase_field.end()) < 0.9)
          cells.push_back(cell);
      }

      std::vector<DamagedCell>
      cells() const
      {
        const long nx = std::lround((upper[0] - lower[0]) / (2. * h)),
                   ny = std::lround((upper[1] - lower[1]) / (2. * h));
        std::vector<DamagedCell> result;
        for (long i = 0; i < nx; ++i)
          for (long j = 0; j < ny; ++j)
            if (is_coarse(i, j))
              add_cell(2 * i, 2 * j, 2, result);
            else
              for (unsigned int k = 0; k < 4; ++k)
                add_cell(2 * i + k % 2, 2 * j + k / 2, 1, result);
        return result;
      }
    };

    /// A straight line of edges of about @p size.
    inline void
    add_edges(const Point<2>            &a,
              const Point<2>            &b,
              const std::string         &name,
              const double               size,
              std::vector<BoundaryEdge> &edges)
    {
      const unsigned int n = std::max(1l, std::lround(a.distance(b) / size));
      for (unsigned int i = 0; i < n; ++i)
        edges.push_back({a + (double(i) / n) * (b - a),
                         a + (double(i + 1) / n) * (b - a),
                         name});
    }

    /// The sides of the rectangle.
    inline std::vector<BoundaryEdge>
    sides(const Imposed &body)
    {
      const Point<2>           &a = body.lower, &b = body.upper;
      std::vector<BoundaryEdge> edges;
      add_edges(a, {b[0], a[1]}, "bottom", body.h, edges);
      add_edges({b[0], a[1]}, b, "right", body.h, edges);
      add_edges(b, {a[0], b[1]}, "top", body.h, edges);
      add_edges({a[0], b[1]}, a, "left", body.h, edges);
      return edges;
    }

    /// Both faces of a slit.
    inline void
    add_slit(const Point<2>            &mouth,
             const Point<2>            &tip,
             const double               size,
             std::vector<BoundaryEdge> &edges)
    {
      add_edges(mouth, tip, "notch", size, edges);
      add_edges(tip, mouth, "notch", size, edges);
    }

    inline void
    add_hole(const Point<2>            &center,
             const double               radius,
             std::vector<BoundaryEdge> &edges)
    {
      const auto at = [&](const unsigned int i) {
        const double angle = 2. * M_PI * (i % 48) / 48.;
        return center +
               radius * Tensor<1, 2>({std::cos(angle), std::sin(angle)});
      };
      for (unsigned int i = 0; i < 48; ++i)
        edges.push_back({at(i), at(i + 1), "hole"});
    }

    inline CrackPathOptions
    options(const Imposed &body)
    {
      CrackPathOptions result;
      result.length_scale = body.l;
      return result;
    }
  } // namespace Testing
} // namespace MixedCracks

#endif
