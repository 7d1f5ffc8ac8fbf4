// SPDX-License-Identifier: GPL-2.0-or-later
// Edges that share an end, directly or by way of others, are
//
//   all edges           a closed line; the one with the largest box around it
//                       is the outline, the others lie within the body
//   edges of no side    a notch, slit or hole; it opens at the sides of the
//                       outline with which it shares an end
//
//    left  |              the slit shares its mouth with 'left': a part of
//          o======        that side
//          |    o====o    this one shares no end with others: a line within
//
// Ends are compared as in slit_faces.cc: sorted by f(x) = 0.6180 x + 0.8898 y,
// with |grad f| < 1.1, only those are at one place whose f differs by less than
// that times the tolerance.

#include <cracks/boundary_parts.h>
#include <cracks/crack_path_parts.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // of the shortest edge: ends that are nearer are at one place
    constexpr double same_place = 1e-6;

    using Pairs = std::vector<std::pair<unsigned int, unsigned int>>;

    bool
    is_side(const BoundaryEdge &edge)
    {
      return role_of_boundary(edge.name) == BoundaryRole::side;
    }



    // edges that share an end
    Pairs
    neighbours(const std::vector<BoundaryEdge> &edges)
    {
      struct End
      {
        double       order;
        Point<2>     point;
        unsigned int edge;
      };
      std::vector<End> ends;
      double           tolerance = std::numeric_limits<double>::infinity();
      for (unsigned int e = 0; e < edges.size(); ++e)
      {
        for (const Point<2> &point : {edges[e].begin, edges[e].end})
          ends.push_back({0.6180 * point[0] + 0.8898 * point[1], point, e});
        tolerance = std::min(
          tolerance, same_place * edges[e].begin.distance(edges[e].end));
      }
      std::sort(ends.begin(), ends.end(), [](const End &a, const End &b) {
        return a.order < b.order;
      });
      Pairs pairs;
      for (std::size_t i = 0; i < ends.size(); ++i)
        for (std::size_t j = i + 1;
             j < ends.size() &&
             ends[j].order - ends[i].order <= 1.1 * tolerance;
             ++j)
          if (ends[i].point.distance(ends[j].point) <= tolerance)
            pairs.emplace_back(ends[i].edge, ends[j].edge);
      return pairs;
    }



    // The same number for edges that the pairs lead from one to the other.
    std::vector<unsigned int>
    components(const unsigned int n_edges, const Pairs &pairs)
    {
      std::vector<unsigned int> label(n_edges);
      std::iota(label.begin(), label.end(), 0u);
      const auto root = [&label](unsigned int edge) {
        while (label[edge] != edge)
          edge = label[edge] = label[label[edge]];
        return edge;
      };
      for (const auto &[a, b] : pairs)
        label[root(a)] = root(b);
      for (unsigned int edge = 0; edge < n_edges; ++edge)
        label[edge] = root(edge);
      return label;
    }
  } // namespace



  BoundaryParts::BoundaryParts(const std::vector<BoundaryEdge> &all)
    : edges(all)
    , parts(all.size())
  {
    const Pairs pairs = neighbours(edges);
    Pairs       within_voids;
    for (const auto &[a, b] : pairs)
      if (!is_side(edges[a]) && !is_side(edges[b]))
        within_voids.emplace_back(a, b);
    const auto void_of_edge = components(edges.size(), within_voids);
    std::map<unsigned int, std::set<std::string>> sides_of_void;
    for (const auto &[a, b] : pairs)
      if (is_side(edges[a]) != is_side(edges[b]))
      {
        const unsigned int side = is_side(edges[a]) ? a : b;
        sides_of_void[void_of_edge[a + b - side]].insert(edges[side].name);
      }
    for (unsigned int e = 0; e < edges.size(); ++e)
      if (is_side(edges[e]))
        parts[e].sides = {edges[e].name};
      else
        parts[e].sides = sides_of_void[void_of_edge[e]];
    find_outline(components(edges.size(), pairs));
  }



  void
  BoundaryParts::find_outline(const std::vector<unsigned int> &line_of_edge)
  {
    struct Line
    {
      Point<2> lower, upper;
      bool     is_hole = false;
    };
    std::map<unsigned int, Line> lines;
    for (unsigned int e = 0; e < edges.size(); ++e)
    {
      Line &line =
        lines.try_emplace(line_of_edge[e], Line{edges[e].begin, edges[e].begin})
          .first->second;
      for (const Point<2> &point : {edges[e].begin, edges[e].end})
        for (unsigned int d = 0; d < 2; ++d)
        {
          line.lower[d] = std::min(line.lower[d], point[d]);
          line.upper[d] = std::max(line.upper[d], point[d]);
        }
      line.is_hole =
        line.is_hole || role_of_boundary(edges[e].name) == BoundaryRole::hole;
    }
    const auto outer = std::max_element(
      lines.begin(), lines.end(), [](const auto &a, const auto &b) {
        return a.second.lower.distance(a.second.upper) <
               b.second.lower.distance(b.second.upper);
      });
    for (unsigned int e = 0; e < edges.size(); ++e)
      if (line_of_edge[e] != outer->first)
        parts[e] = {{}, line_of_edge[e], lines[line_of_edge[e]].is_hole};
  }



  // A crack that has met the tip of a notch has the name of the first notch.
  BoundaryPart
  BoundaryParts::at(const Point<2> &point, const std::string &name) const
  {
    BoundaryPart part;
    part.sides      = {name};
    double smallest = std::numeric_limits<double>::infinity();
    for (unsigned int e = 0; e < edges.size(); ++e)
      if (edges[e].name == name || (is_notch(edges[e].name) && is_notch(name)))
      {
        const double distance =
          distance_to({edges[e].begin, edges[e].end}, point);
        if (distance < smallest)
        {
          smallest = distance;
          part     = parts[e];
        }
      }
    return part;
  }
} // namespace MixedCracks
