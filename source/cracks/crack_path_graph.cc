// SPDX-License-Identifier: GPL-2.0-or-later
// Paths along nodes, as cheapest ways in the metric
//
//   cost of an edge ab = |ab| (1 + 20 mean(phi_a, phi_b)^2),
//
// which is |ab| in the middle of a crack and 6 |ab| where phi = 0.5, from one
// or several sources (Dijkstra). Minimal paths between two points of an image,
// of which Cohen and Kimmel, Int. J. Comput. Vision 24 (1997), have the
// continuous version. For each component of open nodes (phi < 0.5, off the
// rim):
//
//   1. from any broken node to the broken node A farthest away, from A to the
//      farthest, B: AB is the longest path (exactly so in a tree)
//   2. broken nodes within max(3 l [branch_distance], 4 h) of a path are its
//   3. from all nodes of all paths to the farthest broken node that is left: a
//      branch, which leaves the path of its source; again from 2
//      until no broken node is left
//
// "Farthest" is measured in mm along the cheapest way, not by its cost: the
// longest crack counts, not the one that is worst to follow. Each round takes
// at least the end of its branch, so that 3 comes to an end.

#include <cracks/crack_path_parts.h>

#include <algorithm>
#include <limits>
#include <queue>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    using Node                     = DamageField::Node;
    constexpr Node   no_node       = DamageField::no_node;
    constexpr double far_away      = std::numeric_limits<double>::infinity();
    constexpr double cost_of_field = 20.;

    // Shortest ways along nodes that a crack may run through; they are short
    // where the phase field is small.
    struct Ways
    {
      std::vector<double> cost;
      std::vector<double> length; // mm, from the sources
      std::vector<Node>   previous;
    };



    // how a path reaches node @p to, from one of the sources
    std::vector<Node>
    nodes_to(const Ways &ways, Node to)
    {
      std::vector<Node> nodes;
      for (; to != no_node; to = ways.previous[to])
        nodes.push_back(to);
      std::reverse(nodes.begin(), nodes.end());
      return nodes;
    }



    class Graph
    {
    public:
      explicit Graph(const CrackPathProblem &problem)
        : field(problem.field)
        , broken_below(problem.options.broken)
        , open(field.points.size(), false)
      {
        for (Node node = 0; node < open.size(); ++node)
          open[node] = field.values[node] < problem.options.connected &&
                       !is_at_rim(problem, field.points[node]);
      }

      bool
      is_broken(const Node node) const
      {
        return open[node] && field.values[node] < broken_below;
      }

      Ways
      ways_from(const std::vector<Node> &sources) const
      {
        Ways ways{std::vector<double>(open.size(), far_away),
                  std::vector<double>(open.size(), 0.),
                  std::vector<Node>(open.size(), no_node)};
        using Entry = std::pair<double, Node>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>
          queue;
        for (const Node source : sources)
        {
          ways.cost[source] = 0.;
          queue.push({0., source});
        }
        while (!queue.empty())
        {
          const auto [cost, node] = queue.top();
          queue.pop();
          if (cost > ways.cost[node])
            continue;
          for (const Node next : field.neighbours[node])
          {
            const double through = cost + cost_of(node, next);
            if (!open[next] || through >= ways.cost[next])
              continue;
            ways.cost[next]   = through;
            ways.length[next] = ways.length[node] +
                                field.points[node].distance(field.points[next]);
            ways.previous[next] = node;
            queue.push({through, next});
          }
        }
        return ways;
      }

      // the one with the longest way of those that can be reached, are broken
      // and are not @p taken
      Node
      farthest_broken(const Ways &ways, const std::vector<bool> &taken) const
      {
        Node farthest = no_node;
        for (Node node = 0; node < open.size(); ++node)
          if (is_broken(node) && !taken[node] && ways.cost[node] < far_away &&
              (farthest == no_node ||
               ways.length[node] > ways.length[farthest]))
            farthest = node;
        return farthest;
      }

    private:
      double
      cost_of(const Node a, const Node b) const
      {
        const double mean = 0.5 * (field.values[a] + field.values[b]);
        return field.points[a].distance(field.points[b]) *
               (1. + cost_of_field * mean * mean);
      }

      const DamageField &field;
      const double       broken_below;
      std::vector<bool>  open;
    };



    Polyline
    points_of(const DamageField &field, const std::vector<Node> &nodes)
    {
      Polyline points;
      for (const Node node : nodes)
        points.push_back(field.points[node]);
      return points;
    }



    // nodes near a new path belong to it
    void
    take(const DamageField &field,
         const Polyline    &path,
         const double       distance,
         std::vector<bool> &taken)
    {
      for (Node node = 0; node < taken.size(); ++node)
        taken[node] =
          taken[node] || distance_to(path, field.points[node]) < distance;
    }
  } // namespace



  // Near the boundary damage may follow it, and the longest way would, too. A
  // notch has a profile of its own around it, hence 1.5 times the distance, but
  // not around its tip: where the nearest place on the notch is a tip, a crack
  // begins.
  bool
  is_at_rim(const CrackPathProblem &problem, const Point<2> &point)
  {
    const double l   = problem.options.length_scale;
    const double rim = std::max(problem.options.rim * l, 1.5 * problem.h);
    if (problem.boundary.nearest(point, false).distance < rim)
      return true;
    const BoundaryPlace flank = problem.boundary.nearest(point, true);
    return flank.distance < 1.5 * rim &&
           !problem.boundary.tip_near(flank.point, 1e-3 * problem.h);
  }



  std::vector<NodePath>
  find_node_paths(const CrackPathProblem &problem)
  {
    const DamageField &field = problem.field;
    const double       apart =
      std::max(problem.options.branch_distance * problem.options.length_scale,
               4. * problem.h);
    const Graph           graph(problem);
    std::vector<bool>     seen(field.points.size(), false);
    std::vector<NodePath> paths;
    for (Node node = 0; node < field.points.size(); ++node)
    {
      if (!graph.is_broken(node) || seen[node])
        continue;
      const Ways        component = graph.ways_from({node});
      std::vector<bool> taken(field.points.size(), false);
      for (Node other = 0; other < taken.size(); ++other)
      {
        if (component.cost[other] < far_away)
          seen[other] = true;
        else
          taken[other] = true;
      }
      const Node        begin = graph.farthest_broken(component, taken);
      const Ways        ways  = graph.ways_from({begin});
      std::vector<Node> nodes =
        nodes_to(ways, graph.farthest_broken(ways, taken));
      const unsigned int first = paths.size();
      paths.push_back({points_of(field, nodes), NodePath::no_parent});
      std::vector<Node> sources = nodes;
      for (;;)
      {
        take(field, paths.back().points, apart, taken);
        const Ways branches = graph.ways_from(sources);
        const Node end      = graph.farthest_broken(branches, taken);
        if (end == no_node)
          break;
        nodes                 = nodes_to(branches, end);
        const Point<2> leave  = field.points[nodes.front()];
        unsigned int   parent = first;
        for (unsigned int p = first; p < paths.size(); ++p)
          if (distance_to(paths[p].points, leave) == 0.)
            parent = p;
        paths.push_back({points_of(field, nodes), parent});
        sources.insert(sources.end(), nodes.begin(), nodes.end());
      }
    }
    return paths;
  }
} // namespace MixedCracks
