// SPDX-License-Identifier: GPL-2.0-or-later
// Paths moved into the middle of the damage.
#include <cracks/crack_path_parts.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  double
  length_of(const Polyline &points)
  {
    double length = 0.;
    for (std::size_t i = 1; i < points.size(); ++i)
      length += points[i].distance(points[i - 1]);
    return length;
  }



  double
  distance_to(const Polyline &points, const Point<2> &point)
  {
    double smallest = std::numeric_limits<double>::infinity();
    if (points.size() == 1)
      return point.distance(points.front());
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      const Tensor<1, 2> along  = points[i] - points[i - 1];
      const double       square = along.norm_square();
      const double       s =
        square > 0. ? ((point - points[i - 1]) * along) / square : 0.;
      smallest = std::min(
        smallest,
        point.distance(points[i - 1] + std::min(1., std::max(0., s)) * along));
    }
    return smallest;
  }



  Polyline
  resampled(const Polyline &points, const double spacing)
  {
    const double total = length_of(points);
    if (points.size() < 2 || total == 0.)
      return points;
    const unsigned int pieces =
      std::max(2l, std::lround(std::ceil(total / spacing - 1e-9)));
    Polyline    result{points.front()};
    std::size_t i     = 1;
    double      begin = 0., piece = points[1].distance(points[0]);
    for (unsigned int k = 1; k < pieces; ++k)
    {
      const double at = total * k / pieces;
      while (i + 1 < points.size() && begin + piece < at)
      {
        begin += piece;
        ++i;
        piece = points[i].distance(points[i - 1]);
      }
      const double s = piece > 0. ? (at - begin) / piece : 0.;
      result.push_back(points[i - 1] + s * (points[i] - points[i - 1]));
    }
    result.push_back(points.back());
    return result;
  }



  Polyline
  without_end(const Polyline &points, const double length)
  {
    Polyline result = points;
    double   left   = length;
    while (result.size() > 1)
    {
      const Point<2> last  = result.back();
      const double   piece = last.distance(result[result.size() - 2]);
      result.pop_back();
      if (piece > left)
      {
        result.push_back(last + (left / piece) * (result.back() - last));
        break;
      }
      left -= piece;
    }
    return result;
  }



  namespace
  {
    // how far the damage on both sides of a path is its own
    double
    half_width(const CrackPathProblem &problem,
               const Point<2>         &point,
               const Tensor<1, 2>     &normal)
    {
      double width = 1.5 * std::max(problem.options.length_scale, problem.h);
      const double step = width / 12.;
      for (const double side : {-1., 1.})
      {
        const Point<2> far = point + side * width * normal;
        width =
          std::min(width, problem.boundary.first_met(point, far).distance);
        for (double t = step; t < width; t += step)
          if (problem.boundary.nearest(point + side * t * normal, true)
                .distance < t)
            width = t;
      }
      return width;
    }



    // the direction of the path at its points, from two points away
    Tensor<1, 2>
    tangent(const Polyline &points, const std::size_t i)
    {
      const std::size_t before = i >= 2 ? i - 2 : 0,
                        after  = std::min(i + 2, points.size() - 1);
      const Tensor<1, 2> chord = points[after] - points[before];
      return chord / std::max(chord.norm(), 1e-300);
    }



    // the value at 0 of the parabola through values at equal distances, by
    // least squares; the first of them is at @p first
    template <typename Values>
    Point<2>
    parabola_at_zero(const Values &values, const int first)
    {
      // normal equations for 1, s, s^2, with moments about 0
      double       m[5] = {0., 0., 0., 0., 0.};
      Tensor<1, 2> r[3];
      for (std::size_t k = 0; k < values.size(); ++k)
      {
        double power = 1.;
        for (unsigned int p = 0; p < 5; ++p, power *= first + double(k))
        {
          m[p] += power;
          if (p < 3)
            r[p] += power * Tensor<1, 2>(values[k]);
        }
      }
      const double a = m[2] * m[4] - m[3] * m[3], b = m[2] * m[3] - m[1] * m[4],
                   c = m[1] * m[3] - m[2] * m[2];
      return Point<2>((a * r[0] + b * r[1] + c * r[2]) /
                      (a * m[0] + b * m[1] + c * m[2]));
    }



    // every point replaced by the parabola through it and its neighbours
    // within 1.5 l, which does not shrink curves
    Polyline
    smoothed(const CrackPathProblem &problem, const Polyline &points)
    {
      const int reach = std::max(
        3l, std::lround(1.5 * problem.options.length_scale / problem.h));
      const int n = points.size();
      if (n < 4)
        return points;
      Polyline result;
      for (int i = 0; i < n; ++i)
      {
        const int first = std::max(0, i - reach),
                  last  = std::min(n - 1, i + reach);
        result.push_back(parabola_at_zero(
          Polyline(points.begin() + first, points.begin() + last + 1),
          first - i));
      }
      return result;
    }
  } // namespace



  double
  offset_of_center(const CrackPathProblem &problem,
                   const Point<2>         &point,
                   const Tensor<1, 2>     &normal)
  {
    const double width = half_width(problem, point, normal);
    if (width < 0.75 * problem.options.length_scale)
      return 0.;
    constexpr int n      = 16;
    double        weight = 0., moment = 0.;
    for (int k = -n; k <= n; ++k)
    {
      const double t      = width * k / n;
      const double value  = problem.field.value(point + t * normal);
      const double damage = std::max(0., 1. - value);
      const double w      = damage * damage * damage * damage;
      weight += w;
      moment += w * t;
    }
    return weight > 0. ? moment / weight : 0.;
  }



  Polyline
  centred(const CrackPathProblem &problem, const Polyline &points)
  {
    constexpr unsigned int iterations = 6;
    Polyline               path       = points;
    for (unsigned int k = 0; k < iterations; ++k)
    {
      path                = smoothed(problem, resampled(path, problem.h));
      const Polyline from = path;
      for (std::size_t i = 0; i < path.size(); ++i)
      {
        const Tensor<1, 2> along = tangent(from, i);
        const Tensor<1, 2> normal({-along[1], along[0]});
        path[i] += offset_of_center(problem, from[i], normal) * normal;
      }
    }
    return smoothed(problem, path);
  }
} // namespace MixedCracks
