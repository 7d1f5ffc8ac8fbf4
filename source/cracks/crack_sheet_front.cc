// SPDX-License-Identifier: GPL-2.0-or-later
// Fronts are chains of sides: from a vertex with one side to the next such,
// then what is left, in circles. At a point with tangent t of the chain and
// normal n of the sheet, both of length 1,
//
//   ahead = +-(t - (t . n) n) x n, normed, away from the triangle behind.
//
// Chains have points where the triangles have sides; they are replaced by
// points at equal distances of at most h.

#include <base/segment.h>

#include <cracks/crack_sheet_front.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    Tensor<1, 3>
    normed(const Tensor<1, 3> &vector)
    {
      return vector / std::max(vector.norm(), 1e-300);
    }



    // The cut sides at vertices.
    class FrontSides
    {
    public:
      FrontSides(const SheetMesh                      &mesh,
                 const std::vector<SheetMesh::SideOf> &open,
                 const std::set<unsigned int>         &members)
        : mesh(mesh)
      {
        for (const SheetMesh::SideOf &side : open)
          if (mesh.kind(side) == SheetMesh::cut_side &&
              members.count(side.triangle) > 0)
          {
            const auto        &v = mesh.triangles[side.triangle].vertices;
            const unsigned int a = v[side.number], b = v[(side.number + 1) % 3];
            at[a].push_back(sides.size());
            at[b].push_back(sides.size());
            sides.push_back({{{a, b}}, side.triangle});
          }
        is_used.assign(sides.size(), false);
      }

      /// The next chain of sides that were not used, as points with normals and
      /// directions ahead; empty when there is none.
      CrackFront
      next()
      {
        for (const bool from_end : {true, false})
          for (const auto &[vertex, of_vertex] : at)
            if (!from_end || of_vertex.size() == 1)
              for (const unsigned int side : of_vertex)
                if (!is_used[side])
                  return chain_from(vertex);
        return {};
      }

    private:
      struct Side
      {
        std::array<unsigned int, 2> ends;
        unsigned int                triangle;
      };

      CrackFront
      chain_from(const unsigned int first)
      {
        CrackFront   front;
        unsigned int vertex = first;
        while (true)
        {
          const auto &here = at.at(vertex);
          const auto  side =
            std::find_if(here.begin(), here.end(), [&](const unsigned int s) {
              return !is_used[s];
            });
          if (side == here.end())
            break;
          is_used[*side]          = true;
          const auto        &ends = sides[*side].ends;
          const unsigned int next = ends[0] == vertex ? ends[1] : ends[0];
          add(vertex, *side, front);
          add(next, *side, front);
          vertex = next;
        }
        front.is_closed = vertex == first;
        return front;
      }

      // a point of a side; two sides add to what they have in common
      void
      add(const unsigned int vertex,
          const unsigned int number,
          CrackFront        &front) const
      {
        const Side                &side     = sides[number];
        const SheetMesh::Triangle &triangle = mesh.triangles[side.triangle];
        const Point<3>            &a        = mesh.vertices[side.ends[0]],
                       &b                   = mesh.vertices[side.ends[1]];
        const Tensor<1, 3> normal           = mesh.area_vector(triangle);
        Tensor<1, 3>       ahead = cross_product_3d(b - a, normed(normal));
        Tensor<1, 3>       inside;
        for (const unsigned int v : triangle.vertices)
          inside += (mesh.vertices[v] - a) / 3.;
        if (ahead * inside > 0.)
          ahead = -ahead;
        const bool is_same =
          !front.points.empty() &&
          front.points.back().position == mesh.vertices[vertex];
        if (!is_same)
          front.points.push_back({mesh.vertices[vertex], {}, {}});
        front.points.back().normal += normal;
        front.points.back().ahead += ahead;
      }

      const SheetMesh                                  &mesh;
      std::map<unsigned int, std::vector<unsigned int>> at;
      std::vector<Side>                                 sides;
      std::vector<bool>                                 is_used;
    };



    // points at equal distances; of a closed chain the last one is not the
    // first again
    CrackFront
    resampled(const CrackFront &chain, const double spacing)
    {
      CrackFront          front;
      std::vector<double> arcs(1, 0.);
      const auto         &points = chain.points;
      for (std::size_t i = 1; i < points.size(); ++i)
        arcs.push_back(arcs.back() +
                       points[i].position.distance(points[i - 1].position));
      front.length    = arcs.back();
      front.is_closed = chain.is_closed;
      const auto pieces =
        std::max(2l, std::lround(std::ceil(front.length / spacing - 1e-6)));
      std::size_t i = 1;
      for (long k = 0; k < pieces + (front.is_closed ? 0 : 1); ++k)
      {
        const double at = front.length * k / pieces;
        while (i + 1 < points.size() && arcs[i] < at)
          ++i;
        const FrontPoint &a = points[i - 1], &b = points[i];
        const double      s = std::clamp(
          (at - arcs[i - 1]) / std::max(arcs[i] - arcs[i - 1], 1e-300), 0., 1.);
        FrontPoint point{
          a.position + s * (b.position - a.position),
          normed((1. - s) * normed(a.normal) + s * normed(b.normal)),
          (1. - s) * normed(a.ahead) + s * normed(b.ahead)};
        point.ahead -= (point.ahead * point.normal) * point.normal;
        point.ahead = normed(point.ahead);
        front.points.push_back(point);
      }
      return front;
    }
  } // namespace



  std::vector<double>
  distances_to_cut(const SheetMesh &mesh, const double largest)
  {
    std::vector<double>            distances(mesh.vertices.size(), largest);
    std::vector<SheetMesh::SideOf> cut;
    double                         longest = 0.;
    for (const SheetMesh::SideOf &side : mesh.open_sides())
      if (mesh.kind(side) == SheetMesh::cut_side)
      {
        cut.push_back(side);
        longest = std::max(longest, mesh.length(side));
      }
    PointBoxes boxes(largest + 0.5 * longest);
    for (unsigned int i = 0; i < cut.size(); ++i)
    {
      const auto [a, b] = mesh.ends(cut[i]);
      boxes.add(a + 0.5 * (b - a), i);
    }
    for (std::size_t v = 0; v < distances.size(); ++v)
      boxes.near(mesh.vertices[v], [&](const unsigned int i) {
        const auto [a, b] = mesh.ends(cut[i]);
        distances[v]      = std::min(distances[v],
                                mesh.vertices[v].distance(
                                  nearest_on_segment(a, b, mesh.vertices[v])));
      });
    return distances;
  }



  double
  distance_to(const CrackFront &front, const Point<3> &point)
  {
    double      smallest = std::numeric_limits<double>::infinity();
    const auto &points   = front.points;
    for (std::size_t i = front.is_closed ? 0 : 1; i < points.size(); ++i)
      smallest =
        std::min(smallest,
                 point.distance(nearest_on_segment(
                   points[(i + points.size() - 1) % points.size()].position,
                   points[i].position,
                   point)));
    return smallest;
  }



  std::vector<CrackFront>
  fronts_of(const SheetMesh                      &mesh,
            const std::vector<SheetMesh::SideOf> &open,
            const std::set<unsigned int>         &members,
            const CrackSheetOptions              &options)
  {
    FrontSides              sides(mesh, open, members);
    std::vector<CrackFront> fronts;
    for (CrackFront chain = sides.next(); !chain.points.empty();
         chain            = sides.next())
    {
      CrackFront front = resampled(chain, options.cell_size);
      if (front.length > options.length_scale)
        fronts.push_back(std::move(front));
    }
    std::stable_sort(fronts.begin(),
                     fronts.end(),
                     [](const CrackFront &a, const CrackFront &b) {
                       return a.length > (1. + 1e-6) * b.length;
                     });
    return fronts;
  }
} // namespace MixedCracks
