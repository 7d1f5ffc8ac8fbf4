// SPDX-License-Identifier: GPL-2.0-or-later
// Paths moved into the middle of the damage. Six times, for points x_i at equal
// distances of about h, with the normal n_i of the path:
//
//   x_i <- S(x)_i + d_i n_i,   d = integral of t w(t) / integral of w(t),
//   w(t) = (1 - phi(x + t n))^4,   |t| <= width,
//
// S the smoothing below. The mean rather than the minimum: phi is bilinear in
// cells, so that its minimum lies on nodes, and on the plateau of a band that
// is broken two nodes wide it is not unique. The fourth power, exp(-4 |t|/l)
// for AT2, leaves little weight to the flanks, which neighbours and rims
// distort.
//
// S is the local least-squares parabola (Savitzky and Golay, Anal. Chem. 36
// (1964)) over points within 1.5 l, at least 3 to each side. It reproduces
// parabolas, where a moving average over +-r would pull an arc of curvature k
// inwards by about k r^2/6 each time.

#include <base/segment.h>

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
      smallest = std::min(
        smallest,
        point.distance(nearest_on_segment(points[i - 1], points[i], point)));
    return smallest;
  }



  // At k L/n, k = 0 ... n, of the arc length L, with n = ceil(L / spacing) >=
  // 2.
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
    // How far the damage on both sides of a path is its own: 1.5 max(l, h), the
    // way to the boundary along the normal, half the way to a flank of a notch
    // (where x + t n is nearer to the flank than to x). The same on both sides:
    // a window with one side cut off would move the mean to the other.
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



    // The c_0 that minimises sum_k (c_0 + c_1 s_k + c_2 s_k^2 - x_k)^2 at s_k =
    // first, first + 1, ... With m_p = sum s^p and r_p = sum s^p x, by Cramer's
    // rule,
    //
    //   | m_0 m_1 m_2 |         a r_0 + b r_1 + c r_2    a = m_2 m_4 - m_3^2
    //   | m_1 m_2 m_3 |,  c_0 = ---------------------,   b = m_2 m_3 - m_1 m_4
    //   | m_2 m_3 m_4 |         a m_0 + b m_1 + c m_2    c = m_1 m_3 - m_2^2.
    //
    // Near the ends of a path the window has one side only, and 0 is at its
    // end.
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



    // Each point replaced by the parabola through it and its neighbours within
    // 1.5 l.
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
