// SPDX-License-Identifier: GPL-2.0-or-later
// The ends of a path, which after centring has lost its last h and is not known
// within l of the boundary. In this order:
//
//   1. a sharp notch tip nearby        a straight line to it
//   2. go on along the damage          boundary met: end there; without the
//                                      last points where they have turned back
//   3. phi = 0.5 on the prolonged path, by bisection
//   4. boundary within max(1.5 l [reach], 2 h) - 0.6 l of that    end there
//   5. otherwise a tip                 cut back by 0.6 l [tip_lag]
//
// Ahead of a tip phi rises as across the crack: with the optimal profiles of
// doc/model.md it is 0.5 at asin(1/2) l = 0.52 l (Wu), (2 - sqrt 2) l = 0.59 l
// (AT1), log(2) l = 0.69 l (AT2) from the crack. 0.6 l stands for all of them.
// The level 0.5 is where phi is steep, so that its place depends on the mesh
// least.

#include <cracks/crack_path_parts.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // in which the path goes on after its last point: the chord of the last
    // part of it
    Tensor<1, 2>
    end_direction(const CrackPathProblem &problem, const Polyline &points)
    {
      const double part =
        std::max(problem.options.length_scale, 2. * problem.h);
      const Polyline     rest  = without_end(points, part);
      const Tensor<1, 2> chord = points.back() - rest.back();
      return chord / std::max(chord.norm(), 1e-300);
    }



    // Within 1.75 max(l, h) of the boundary, at less than some 45 degrees to
    // it, and broken half way to it: damage of the rim, not a crack that comes
    // near.
    bool
    follows_boundary(const CrackPathProblem &problem,
                     const Point<2>         &point,
                     const Tensor<1, 2>     &direction)
    {
      const double        l     = problem.options.length_scale;
      const BoundaryPlace place = problem.boundary.nearest(point, false);
      if (place.distance > 1.75 * std::max(l, problem.h))
        return false;
      const Tensor<1, 2> across = point - place.point;
      if (std::abs(across * direction) > 0.7 * across.norm())
        return false;
      return problem.field.value(place.point + 0.5 * across) <
             problem.options.broken;
    }



    // Steps of h/2 along the chord of the last max(l, 2 h), each moved to the
    // middle of the damage by no more than half a step, until the boundary is
    // met, phi has reached 0.5, or after 10 l. Closer than l/2 to the boundary
    // the damage is not symmetric about the crack, and the steps are not
    // corrected. Returns where the boundary is met.
    BoundaryPlace
    advance(const CrackPathProblem &problem, Polyline &points)
    {
      const double l = problem.options.length_scale, step = 0.5 * problem.h;
      const unsigned int most = std::lround(10. * l / step) + 10;
      for (unsigned int k = 0; k < most; ++k)
      {
        const Tensor<1, 2>  direction = end_direction(problem, points);
        Point<2>            next      = points.back() + step * direction;
        const BoundaryPlace met =
          problem.boundary.first_met(points.back(), next);
        if (met.exists())
        {
          points.push_back(met.point);
          return met;
        }
        if (problem.field.value(next) >= 0.5)
          break;
        if (problem.boundary.nearest(next, false).distance > 0.5 * l)
        {
          const Tensor<1, 2> normal({-direction[1], direction[0]});
          const double       offset = offset_of_center(problem, next, normal);
          next += std::min(0.5 * step, std::max(-0.5 * step, offset)) * normal;
        }
        points.push_back(next);
      }
      return {};
    }



    // straight on to where the phase field passes 0.5, at most a step
    void
    go_on_to_one_half(const CrackPathProblem &problem, Polyline &points)
    {
      const Tensor<1, 2> direction = end_direction(problem, points);
      const Point<2>     from      = points.back();
      double             low = 0., high = 0.5 * problem.h;
      for (unsigned int k = 0; k < 20; ++k)
      {
        const double middle = 0.5 * (low + high);
        const bool   is_low =
          problem.field.value(from + middle * direction) < 0.5;
        (is_low ? low : high) = middle;
      }
      points.push_back(from + low * direction);
    }



    // The boundary within reach of the last point: straight ahead, or, for a
    // path that hardly comes nearer, within half of that to the side.
    BoundaryPlace
    place_ahead(const CrackPathProblem &problem,
                const Polyline         &points,
                const double            reach)
    {
      const BoundaryPlace ahead = problem.boundary.first_met(
        points.back(), points.back() + reach * end_direction(problem, points));
      if (ahead.exists())
        return ahead;
      const BoundaryPlace nearest =
        problem.boundary.nearest(points.back(), false);
      return nearest.distance < 0.5 * reach ? nearest : BoundaryPlace();
    }



    // Lead the path straight to the tip of a notch. Within max(l, 1.5 h) of it
    // phi is that of the notch: from where the path enters this circle last, it
    // is replaced.
    void
    end_at_tip(const CrackPathProblem &problem,
               const Point<2>         &tip,
               Polyline               &points)
    {
      const double near =
        std::max(problem.options.length_scale, 1.5 * problem.h);
      std::size_t last = points.size() - 1;
      while (last > 1 && points[last].distance(tip) >= near)
        --last;
      if (points[last].distance(tip) >= near)
        last = points.size() - 1;
      while (last > 1 && points[last - 1].distance(tip) < near)
        --last;
      points.resize(std::max<std::size_t>(1, last));
      points.push_back(tip);
    }



    CrackEnd
    end_on(const CrackPathProblem &problem, const BoundaryPlace &place)
    {
      return {CrackEnd::Kind::boundary, problem.boundary.name(place)};
    }
  } // namespace



  // Where damage widens, as at the rim of a hole, centring may fold the end of
  // a path, which would then be prolonged backwards along itself. A path ends
  // before the first place, of the last 4 parts, max(l, 2 h) long, where the
  // chords of a part and of the one before it do not enclose less than a right
  // angle: cracks have no sharper kinks. What is cut too much is prolonged.
  void
  unfold_end(const CrackPathProblem &problem, Polyline &points)
  {
    const double part  = std::max(problem.options.length_scale, 2. * problem.h);
    const double whole = length_of(points);
    Polyline     kept  = points;
    for (unsigned int k = 0; k <= 6 && whole > (0.5 * k + 2.) * part; ++k)
    {
      const Polyline later   = without_end(points, 0.5 * k * part);
      const Polyline earlier = without_end(later, part);
      if (end_direction(problem, later) * end_direction(problem, earlier) <= 0.)
        kept = earlier;
    }
    points = kept;
  }



  std::vector<Polyline>
  parts_off_the_rim(const CrackPathProblem &problem, const Polyline &points)
  {
    std::vector<Polyline> parts(1);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const std::size_t before = i > 0 ? i - 1 : 0,
                        after  = std::min(i + 1, points.size() - 1);
      Tensor<1, 2> along       = points[after] - points[before];
      if (along.norm() > 0.)
        along /= along.norm();
      if (!follows_boundary(problem, points[i], along))
        parts.back().push_back(points[i]);
      else if (!parts.back().empty())
        parts.emplace_back();
    }
    if (parts.back().empty())
      parts.pop_back();
    // what is left beyond a part that follows the boundary must be longer
    const double shortest =
      parts.size() > 1 ? std::max(problem.options.length_scale, 2. * problem.h)
                       : 0.9 * problem.h;
    const auto is_short = [&](const Polyline &part) {
      return part.size() < 2 || length_of(part) < shortest;
    };
    parts.erase(std::remove_if(parts.begin(), parts.end(), is_short),
                parts.end());
    return parts;
  }



  const NotchTip *
  tip_at_end(const CrackPathProblem &problem, const Polyline &points)
  {
    const double    reach = 1.5 * problem.options.length_scale + 2. * problem.h;
    const NotchTip *tip   = problem.boundary.tip_near(points.back(), reach);
    // a blunt one is a boundary like others, and has one start of a path only
    return tip && tip->radius < problem.h &&
               points.back().distance(tip->point) <=
                 points.front().distance(tip->point)
             ? tip
             : nullptr;
  }



  CrackEnd
  find_end(const CrackPathProblem &problem,
           const NotchTip         *tip,
           Polyline               &points)
  {
    const double l = problem.options.length_scale, h = problem.h;
    if (tip)
    {
      end_at_tip(problem, tip->point, points);
      return {CrackEnd::Kind::boundary, problem.boundary.notch_name()};
    }
    unfold_end(problem, points);
    BoundaryPlace place = advance(problem, points);
    if (place.exists())
      return end_on(problem, place);
    go_on_to_one_half(problem, points);
    const double reach =
      std::max(problem.options.reach * l, 2. * h) - problem.options.tip_lag * l;
    place = place_ahead(problem, points, std::max(reach, 0.5 * h));
    if (place.exists())
    {
      points.push_back(place.point);
      return end_on(problem, place);
    }
    points = without_end(points, problem.options.tip_lag * l);
    return {};
  }



  // A branch ends at the point x of its parent with the smallest
  //
  //   |x - p| + 3 |x - p - ((x - p) . e) e|,
  //
  // p the first point that is off the parent's profile, e the direction in
  // which the branch is prolonged there. Straight ahead costs 1 per mm,
  // sideways 4: the nearest point alone would bend an oblique branch to the
  // perpendicular.
  CrackEnd
  join(const CrackPathProblem &problem,
       const Polyline         &parent,
       Polyline               &points)
  {
    const double near = std::max(problem.options.length_scale, 1.5 * problem.h);
    while (points.size() > 2 && distance_to(parent, points.front()) < near)
      points.erase(points.begin());
    Polyline           backwards(points.rbegin(), points.rend());
    const Tensor<1, 2> direction = end_direction(problem, backwards);
    Point<2>           foot      = parent.front();
    double             smallest  = std::numeric_limits<double>::infinity();
    // the point of the other crack nearest to the prolonged branch
    for (const Point<2> &point : resampled(parent, 0.1 * problem.h))
    {
      const Tensor<1, 2> gap      = point - points.front();
      const double       ahead    = gap * direction;
      const double       sideways = (gap - ahead * direction).norm();
      const double       measure  = gap.norm() + 3. * sideways;
      if (measure < smallest)
      {
        smallest = measure;
        foot     = point;
      }
    }
    points.insert(points.begin(), foot);
    return {CrackEnd::Kind::crack, "crack"};
  }
} // namespace MixedCracks
