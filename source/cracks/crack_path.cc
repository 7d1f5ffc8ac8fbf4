// SPDX-License-Identifier: GPL-2.0-or-later
// Cracks as polylines, from nodal values of phi on the damaged cells. l: length
// scale, h: median size of the broken cells; in brackets the CrackPathOptions.
//
//   1. graph       nodes with phi < 0.5 [connected] off the rim of the body,
//                  joined within cells
//   2. paths       in each component the longest of the cheapest ways between
//                  broken nodes, phi < 0.3, then branches  crack_path_graph.cc
//   3. core        less h at both ends; moved to the mean of (1 - phi)^4 across
//                  the path, and smooth                 crack_path_centring.cc
//   4. parts       without what follows the boundary         crack_path_ends.cc
//   5. ends        at a notch, a parent, the boundary, or 0.6 l [tip_lag]
//                  behind phi = 0.5                          crack_path_ends.cc
//   6. start, length (sum of chords of at most h), kink angle, duplicates
//
// A contour of phi would have two sides and go around the tips; thinning a band
// to a skeleton needs a regular grid and leaves a spur at each ragged edge, to
// be told from branches. A cheapest way has neither, and takes hanging nodes.

#include <base/ranges.h>

#include <cracks/crack_path.h>
#include <cracks/crack_path_parts.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    bool
    is_nucleus_near(const CrackPathProblem &problem, const Point<2> &point)
    {
      const auto &nuclei = problem.options.nuclei;
      return any_of(nuclei, [&](const auto &nucleus) {
        return nucleus.distance(point) < 3. * problem.options.length_scale;
      });
    }



    // Which end is the start; the larger claim wins, then the smaller x, y:
    //
    //   on another crack 8, at a notch 6, on the boundary 2 (+ 1), tip 0 (+ 1)
    //
    // with + 1 for a nucleus within 3 l: where damage came first decides
    // between ends of a kind, but a tip with a nucleus does not outrank the
    // boundary.
    int
    claim(const CrackPathProblem &problem,
          const CrackEnd         &end,
          const Point<2>         &point)
    {
      if (end.kind == CrackEnd::Kind::crack)
        return 8;
      if (is_notch(end.name))
        return 6;
      return (end.kind == CrackEnd::Kind::boundary ? 2 : 0) +
             (is_nucleus_near(problem, point) ? 1 : 0);
    }



    void
    orient(const CrackPathProblem &problem, Crack &crack)
    {
      const Point<2> &a = crack.points.front(), &b = crack.points.back();
      const int       of_start = claim(problem, crack.start, a),
                of_end         = claim(problem, crack.end, b);
      const bool is_later =
        std::abs(a[0] - b[0]) > 1e-9 * problem.h ? b[0] < a[0] : b[1] < a[1];
      if (of_end > of_start || (of_end == of_start && is_later))
      {
        std::reverse(crack.points.begin(), crack.points.end());
        std::swap(crack.start, crack.end);
      }
    }



    // Damage began on the path, but at neither end of it.
    bool
    is_from_interior(const CrackPathProblem &problem, const Crack &crack)
    {
      if (is_nucleus_near(problem, crack.points.front()) ||
          is_nucleus_near(problem, crack.points.back()))
        return false;
      const auto &nuclei = problem.options.nuclei;
      return any_of(nuclei, [&](const auto &nucleus) {
        return distance_to(crack.points, nucleus) <
               3. * problem.options.length_scale;
      });
    }



    // From the reference r (where the notch points, or else the inward normal)
    // to the chord c from the start to the point 3 l along the path,
    //
    //   theta = atan2(r x c, r . c),   degrees, positive to the left of r.
    //
    // The first l of a path is prolonged rather than seen: a tangent at the
    // start would be that of the prolongation.
    double
    kink_angle(const CrackPathProblem &problem, const Crack &crack)
    {
      if (crack.start.kind != CrackEnd::Kind::boundary)
        return std::numeric_limits<double>::quiet_NaN();
      const double l = problem.options.length_scale;
      Polyline     backwards(crack.points.rbegin(), crack.points.rend());
      if (crack.length > 3. * l)
        backwards = without_end(backwards, 3. * l);
      else
        backwards.resize(1);
      const Point<2>     start = crack.points.front();
      const Tensor<1, 2> chord = backwards.back() - start;
      Tensor<1, 2>       reference;
      const NotchTip *tip = problem.boundary.tip_near(start, 0.1 * problem.h);
      if (is_notch(crack.start.name) && tip)
        reference = tip->direction;
      else
        reference = problem.boundary.normal(
          problem.boundary.nearest(start, is_notch(crack.start.name)),
          backwards.back());
      return std::atan2(reference[0] * chord[1] - reference[1] * chord[0],
                        reference * chord) *
             180. / std::acos(-1.);
    }



    // The center line of a path along nodes. Its ends, the last broken nodes,
    // lie anywhere across the band: h is taken off both of them.
    Polyline
    core_of(const CrackPathProblem &problem, const NodePath &path)
    {
      Polyline points = resampled(path.points, problem.h);
      if (length_of(points) > 4. * problem.h)
      {
        points = without_end(points, problem.h);
        std::reverse(points.begin(), points.end());
        points = without_end(points, problem.h);
        std::reverse(points.begin(), points.end());
      }
      return centred(problem, points);
    }



    Crack
    make_crack(const CrackPathProblem &problem,
               const Polyline         &core,
               const Polyline         *parent)
    {
      Crack crack;
      crack.points           = core;
      const NotchTip *at_end = tip_at_end(problem, core);
      const NotchTip *at_start =
        tip_at_end(problem, Polyline(core.rbegin(), core.rend()));
      crack.end = find_end(problem, at_end, crack.points);
      if (parent)
        crack.start = join(problem, *parent, crack.points);
      else
      {
        std::reverse(crack.points.begin(), crack.points.end());
        crack.start = find_end(problem, at_start, crack.points);
        std::reverse(crack.points.begin(), crack.points.end());
      }
      crack.points = resampled(crack.points, problem.h);
      crack.length = length_of(crack.points);
      orient(problem, crack);
      crack.from_interior = is_from_interior(problem, crack);
      crack.kink_angle    = kink_angle(problem, crack);
      return crack;
    }



    // More than half of its points lie within max(l/2, h) of cracks found
    // before: two ways along one wide band are centred to the same line.
    bool
    is_known(const CrackPathProblem   &problem,
             const Crack              &crack,
             const std::vector<Crack> &known)
    {
      const double near =
        std::max(0.5 * problem.options.length_scale, problem.h);
      const auto n = std::count_if(
        crack.points.begin(), crack.points.end(), [&](const Point<2> &point) {
          return any_of(known, [&](const Crack &other) {
            return distance_to(other.points, point) < near;
          });
        });
      return 2 * static_cast<std::size_t>(n) > crack.points.size();
    }
  } // namespace



  std::vector<Crack>
  trace_cracks(const std::vector<DamagedCell>  &cells,
               const std::vector<BoundaryEdge> &edges,
               const CrackPathOptions          &options)
  {
    const DamageField field(cells, options.broken);
    if (field.cell_size() == 0.)
      return {};
    const BodyBoundary     boundary(edges);
    const CrackPathProblem problem{field, boundary, options, field.cell_size()};
    std::vector<Crack>     cracks;
    std::vector<Polyline>  cores;
    for (const NodePath &path : find_node_paths(problem))
    {
      cores.emplace_back();
      if (length_of(path.points) < 0.9 * problem.h)
        continue;
      cores.back()              = core_of(problem, path);
      const bool      is_branch = path.parent != NodePath::no_parent;
      const Polyline *parent    = is_branch && !cores[path.parent].empty()
                                    ? &cores[path.parent]
                                    : nullptr;
      // the first part alone joins the parent: what lies beyond a stretch along
      // the boundary is a crack of its own
      for (const Polyline &part : parts_off_the_rim(problem, cores.back()))
      {
        const Crack crack = make_crack(problem, part, parent);
        parent            = nullptr;
        if (crack.length >= options.shortest * options.length_scale &&
            !is_known(problem, crack, cracks))
          cracks.push_back(crack);
      }
    }
    return cracks;
  }
} // namespace MixedCracks
