// SPDX-License-Identifier: GPL-2.0-or-later
// The boundary as straight edges, and what is asked of it. a x b is the area
// spanned by two vectors of the plane.
//
//   nearest     s = (p - a) . (b - a) / |b - a|^2 within [0, 1]: a + s (b - a)
//   first met   f + s w = a + t (b - a),  w the way from f, g = a - f:
//               s = g x (b - a) / w x (b - a),   t = g x w / w x (b - a),
//               the smallest s in [0, 1] with t in [0, 1] up to 1e-6, so that
//               no way slips through between two edges. Edges along the way
//               are left out: it meets their neighbours.
//   tip         of a notch: a vertex which all notch edges leave to one side

#include <base/plane.h>
#include <base/ranges.h>
#include <base/segment.h>

#include <cracks/crack_path_boundary.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // every point once
    std::vector<Point<2>>
    vertices_of(const std::vector<BoundaryEdge> &edges,
                const std::vector<unsigned int> &which,
                const double                     tolerance)
    {
      std::vector<Point<2>> vertices;
      for (const unsigned int e : which)
        for (const Point<2> &point : {edges[e].begin, edges[e].end})
          if (!any_of(vertices, [&](const Point<2> &other) {
                return other.distance(point) < tolerance;
              }))
            vertices.push_back(point);
      return vertices;
    }
  } // namespace



  BoundaryRole
  role_of_boundary(const std::string &name)
  {
    static const std::map<std::string, BoundaryRole> roles = {
      {"hole", BoundaryRole::hole},
      {"notch", BoundaryRole::notch},
      {"slit", BoundaryRole::notch}};
    const auto role = roles.find(name);
    return role == roles.end() ? BoundaryRole::side : role->second;
  }



  BodyBoundary::BodyBoundary(const std::vector<BoundaryEdge> &all)
    : edges(all)
  {
    for (unsigned int e = 0; e < edges.size(); ++e)
      (is_notch(edges[e].name) ? notch_edges : other_edges).push_back(e);
    if (!notch_edges.empty())
      find_notch_tips();
  }



  // A tip of a slit or of a sharp notch: with unit vectors e_k along the notch
  // edges that leave a vertex and their sum m, e_k . m > 0.7 |m| for all of
  // them, that is all within 45 degrees of m. A slit has two that coincide, a
  // V-notch two with up to 90 degrees between them; along a flank they are
  // opposite, m = 0, and the test fails. The notch points along -m. Its mouth,
  // on the rest of the boundary, has one edge only and is left out first.
  void
  BodyBoundary::find_notch_tips()
  {
    double shortest = std::numeric_limits<double>::infinity();
    for (const unsigned int e : notch_edges)
      shortest = std::min(shortest, edges[e].begin.distance(edges[e].end));
    const double          tolerance = 1e-4 * shortest;
    std::vector<Point<2>> mouth;
    for (const Point<2> &vertex : vertices_of(edges, notch_edges, tolerance))
    {
      if (nearest(vertex, false).distance < tolerance)
      {
        mouth.push_back(vertex);
        continue;
      }
      std::vector<Tensor<1, 2>> away;
      for (const unsigned int e : notch_edges)
        for (const auto &[one, other] :
             {std::pair(edges[e].begin, edges[e].end),
              std::pair(edges[e].end, edges[e].begin)})
          if (one.distance(vertex) < tolerance)
            away.push_back((other - one) / other.distance(one));
      Tensor<1, 2> mean;
      for (const auto &direction : away)
        mean += direction;
      const bool is_tip = all_of(away, [&](const Tensor<1, 2> &a) {
        return a * mean > 0.7 * mean.norm();
      });
      if (is_tip)
        tips.push_back({vertex, -mean / mean.norm(), 0.});
    }
    if (tips.empty() && !mouth.empty())
      find_blunt_tip(mouth);
  }



  // A notch without a sharp tip, with a mouth of width w: its axis leads from
  // the middle of the mouth to the vertex farthest from it, and its tip is the
  // mean, by length, of the edges less than w/2 behind that vertex. Any place
  // within 0.75 w of it counts as at the tip: the ends of a semicircle of
  // diameter w lie 0.59 w from its centroid.
  void
  BodyBoundary::find_blunt_tip(const std::vector<Point<2>> &mouth)
  {
    Point<2> middle;
    double   width = 0.;
    for (const Point<2> &point : mouth)
    {
      middle += point / static_cast<double>(mouth.size());
      width = std::max(width, point.distance(mouth.front()));
    }
    Point<2> farthest = middle;
    for (const unsigned int e : notch_edges)
      for (const Point<2> &point : {edges[e].begin, edges[e].end})
        if (point.distance(middle) > farthest.distance(middle))
          farthest = point;
    const double depth = farthest.distance(middle);
    if (depth == 0.)
      return;
    const Tensor<1, 2> axis = (farthest - middle) / depth;
    Point<2>           sum;
    double             weight = 0.;
    for (const unsigned int e : notch_edges)
    {
      const Point<2> center = 0.5 * (edges[e].begin + edges[e].end);
      if ((center - middle) * axis > depth - 0.5 * width)
      {
        const double length = edges[e].begin.distance(edges[e].end);
        sum += length * center;
        weight += length;
      }
    }
    if (weight == 0.)
      return;
    const Tensor<1, 2> direction = sum / weight - middle;
    tips.push_back(
      {Point<2>(sum / weight), direction / direction.norm(), 0.75 * width});
  }



  BoundaryPlace
  BodyBoundary::nearest(const Point<2> &point, const bool notch) const
  {
    BoundaryPlace place;
    for (const unsigned int e : notch ? notch_edges : other_edges)
    {
      const Point<2> candidate =
        nearest_on_segment(edges[e].begin, edges[e].end, point);
      const double distance = candidate.distance(point);
      if (distance < place.distance)
      {
        place.point    = candidate;
        place.distance = distance;
        place.edge     = e;
      }
    }
    return place;
  }



  BoundaryPlace
  BodyBoundary::first_met(const Point<2> &from, const Point<2> &to) const
  {
    BoundaryPlace      place;
    const Tensor<1, 2> way = to - from;
    for (unsigned int e = 0; e < edges.size(); ++e)
    {
      const Tensor<1, 2> along       = edges[e].end - edges[e].begin;
      const double       determinant = cross(way, along);
      if (std::abs(determinant) <= 1e-12 * way.norm() * along.norm())
        continue;
      const Tensor<1, 2> gap = edges[e].begin - from;
      const double       s   = cross(gap, along) / determinant,
                   t         = cross(gap, way) / determinant;
      if (s < 0. || s > 1. || t < -1e-6 || t > 1. + 1e-6)
        continue;
      if (s * way.norm() < place.distance)
      {
        place.distance = s * way.norm();
        place.point    = edges[e].begin + std::min(1., std::max(0., t)) * along;
        place.edge     = e;
      }
    }
    return place;
  }



  const NotchTip *
  BodyBoundary::tip_near(const Point<2> &point, const double distance) const
  {
    const NotchTip *found = nullptr;
    for (const NotchTip &tip : tips)
      if (point.distance(tip.point) <= tip.radius + distance &&
          (!found || point.distance(tip.point) < point.distance(found->point)))
        found = &tip;
    return found;
  }



  Tensor<1, 2>
  BodyBoundary::normal(const BoundaryPlace &place, const Point<2> &inside) const
  {
    const Tensor<1, 2> along = edges[place.edge].end - edges[place.edge].begin;
    Tensor<1, 2>       normal({-along[1], along[0]});
    normal /= normal.norm();
    return normal * (inside - place.point) < 0. ? -normal : normal;
  }
} // namespace MixedCracks
