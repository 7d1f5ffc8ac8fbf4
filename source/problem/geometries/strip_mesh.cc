// SPDX-License-Identifier: GPL-2.0-or-later
// The coarse mesh of a strip with a hole. Grid lines everywhere, but for a box
// around the hole ('HoleBox'), which a ring of cells fills:
//
//  +----+------+----+    rays: one to each vertex on the outline of the box;
//  |    |\    /|    |    each side of the box takes its part of the circle,
//  +----+-+--+-+----+    in equal angles
//  |    | (  ) |    |    layers: n on a ray, at (q^i - 1)/(q^n - 1) of its
//  +----+-+--+-+----+    length, log q = mean of log(R/r) over the rays / n,
//  |    |/    \|    |    R the distance of the end of a ray from the centre:
//  +----+------+----+    cells grow with the distance and stay near-square
//
// The notch must not end in the ring, whose cells could not hold a slit. The
// side of the box that is nearest to it is moved onto the notch, or the box
// away from it: keep_notch_out().

#include <problem/geometries/strip_mesh.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace MixedCracks
{
  namespace
  {
    // Room between the notch and the hole's bounding square below, above
    // and to the left of the hole; negative where they overlap.
    struct Room
    {
      double below, above, beside;
    };

    Room
    room_at_notch(const StripMeasures &m)
    {
      return {m.hole_center[1] - m.hole_radius - m.notch_height,
              m.notch_height - m.hole_center[1] - m.hole_radius,
              m.hole_center[0] - m.hole_radius - m.notch_length};
    }



    bool
    is_close(const double side, const double line, const StripMeasures &m)
    {
      return std::abs(side - line) < 0.5 * m.cell_size;
    }



    // Move a side of the box onto the line of the notch close to it or, when
    // that leaves too little room for good cells at the hole, away from it,
    // to @p outside.
    void
    snap(double              &side,
         const double         line,
         const double         room,
         const double         outside,
         const StripMeasures &m)
    {
      if (is_close(side, line, m))
        side = room > 0.25 * m.hole_radius ? line : outside;
    }



    void
    keep_notch_out(HoleBox &box, const StripMeasures &m)
    {
      const Room   room = room_at_notch(m);
      const double step = 0.75 * m.cell_size;
      const double y    = m.notch_height;
      snap(box.bottom, y, room.below, std::max(0., y - step), m);
      snap(box.top, y, room.above, std::min(m.height, y + step), m);
      snap(box.left, m.notch_length, room.beside, box.left, m);
      snap(box.right, m.notch_length, m.hole_radius, box.right, m);

      const bool inside =
        box.bottom < y && y < box.top && box.left < m.notch_length;
      if (!inside)
        return;
      if (room.beside >= std::max(room.below, room.above))
        box.left = m.notch_length;
      else if (room.below >= room.above)
        box.bottom = y;
      else
        box.top = y;
    }



    // The box needs two cells on each side, so that the hole gets eight.
    std::vector<double>
    with_middle(const double begin, const double end, const double cell_size)
    {
      if (end - begin < 1.5 * cell_size)
        return {begin, 0.5 * (begin + end), end};
      return {begin, end};
    }



    using VertexLoop = std::vector<unsigned int>;

    // The vertices on the outline of the box, counterclockwise, one list per
    // side, each with both corners. Where the box reaches the strip's edge no
    // cell outside of it has made them yet.
    std::array<VertexLoop, 4>
    box_sides(QuadMesh                  &mesh,
              const HoleBox             &box,
              const std::vector<double> &x,
              const std::vector<double> &y)
    {
      std::map<std::pair<double, double>, unsigned int> index;
      for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
        index[{mesh.vertices[v][0], mesh.vertices[v][1]}] = v;
      const auto vertex = [&](const double px, const double py) {
        const auto [entry, is_new] = index.try_emplace({px, py}, 0U);
        if (is_new)
          entry->second = mesh.add_vertex({px, py});
        return entry->second;
      };

      std::array<VertexLoop, 4> sides;
      for (const double line : x)
        if (line >= box.left && line <= box.right)
        {
          sides[0].push_back(vertex(line, box.bottom));
          sides[2].insert(sides[2].begin(), vertex(line, box.top));
        }
      for (const double line : y)
        if (line >= box.bottom && line <= box.top)
        {
          sides[1].push_back(vertex(box.right, line));
          sides[3].insert(sides[3].begin(), vertex(box.left, line));
        }
      return sides;
    }



    // A ray from the hole to a vertex on the box.
    struct Ray
    {
      double       angle; // where it leaves the hole
      unsigned int end;   // vertex on the box
    };

    // One ray per vertex of the box. Each side of the box takes the part of
    // the circle between its corners, in equal angles.
    std::vector<Ray>
    rays_to_box(const QuadMesh                  &mesh,
                const std::array<VertexLoop, 4> &sides,
                const dealii::Point<2>          &center)
    {
      const auto direction = [&](const unsigned int vertex) {
        const dealii::Tensor<1, 2> ray = mesh.vertices[vertex] - center;
        return std::atan2(ray[1], ray[0]);
      };
      std::vector<Ray> rays;
      for (const VertexLoop &side : sides)
      {
        const double begin = direction(side.front());
        double       span  = direction(side.back()) - begin;
        if (span < 0.)
          span += 2. * dealii::numbers::PI;
        const std::size_t n_pieces = side.size() - 1;
        for (std::size_t i = 0; i < n_pieces; ++i)
          rays.push_back({begin + span * i / n_pieces, side[i]});
      }
      return rays;
    }



    // Positions of the layers along a ray, from 0 at the hole to 1 on the
    // box, growing geometrically: near-square cells around a circle grow by
    // one plus their angle from layer to layer.
    std::vector<double>
    ring_layers(const QuadMesh         &mesh,
                const std::vector<Ray> &rays,
                const dealii::Point<2> &center,
                const double            radius)
    {
      double mean_logarithm = 0.;
      for (const Ray &ray : rays)
        mean_logarithm +=
          std::log(mesh.vertices[ray.end].distance(center) / radius) /
          rays.size();
      const double wanted =
        mean_logarithm / std::log(1. + 2. * dealii::numbers::PI / rays.size());
      const double n_layers = std::max(1., std::round(wanted));
      const double growth   = std::exp(mean_logarithm / n_layers);

      std::vector<double> layers;
      for (double layer = 0.; layer <= n_layers; layer += 1.)
        layers.push_back((std::pow(growth, layer) - 1.) /
                         (std::pow(growth, n_layers) - 1.));
      return layers;
    }



    void
    add_ring(QuadMesh                        &mesh,
             const std::array<VertexLoop, 4> &sides,
             const StripMeasures             &m)
    {
      const std::vector<Ray>    rays = rays_to_box(mesh, sides, m.hole_center);
      const std::vector<double> layers =
        ring_layers(mesh, rays, m.hole_center, m.hole_radius);

      std::vector<VertexLoop> vertices;
      for (const Ray &ray : rays)
      {
        const dealii::Point<2> begin =
          m.hole_center + m.hole_radius * dealii::Point<2>(std::cos(ray.angle),
                                                           std::sin(ray.angle));
        const dealii::Tensor<1, 2> along = mesh.vertices[ray.end] - begin;
        VertexLoop                 on_ray;
        for (std::size_t l = 0; l + 1 < layers.size(); ++l)
          on_ray.push_back(mesh.add_vertex(begin + layers[l] * along));
        on_ray.push_back(ray.end);
        vertices.push_back(on_ray);
      }
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        const VertexLoop &here = vertices[i];
        const VertexLoop &next = vertices[(i + 1) % rays.size()];
        for (std::size_t l = 0; l + 1 < layers.size(); ++l)
          mesh.add_quad({{here[l], here[l + 1], next[l + 1], next[l]}});
      }
    }
  } // namespace



  double
  notch_clearance(const StripMeasures &measures)
  {
    const Room room = room_at_notch(measures);
    return std::max({room.below, room.above, room.beside});
  }



  HoleBox
  hole_box(const StripMeasures &m)
  {
    // a layer of cells at least, but no more than half the radius of them
    const double layers = std::max(
      0.25 * m.hole_radius, std::min(0.5 * m.hole_radius, 0.8 * m.cell_size));
    const double reach = std::max(m.hole_radius + layers, m.cell_size);
    HoleBox      box   = {m.hole_center[0] - reach,
                          m.hole_center[0] + reach,
                          m.hole_center[1] - reach,
                          m.hole_center[1] + reach};
    // no thin cells between the box and the strip's edges
    const double thin = 0.5 * m.cell_size;
    if (box.left < thin)
      box.left = 0.;
    if (box.right > m.width - thin)
      box.right = m.width;
    if (box.bottom < thin)
      box.bottom = 0.;
    if (box.top > m.height - thin)
      box.top = m.height;
    if (m.has_notch())
      keep_notch_out(box, m);
    return box;
  }



  std::array<std::vector<double>, 2>
  fixed_lines(const StripMeasures &m)
  {
    std::vector<double> x = {0., m.width};
    std::vector<double> y = {0., m.height};
    if (m.has_notch())
    {
      x.push_back(m.notch_length);
      y.push_back(m.notch_height);
    }
    if (m.has_hole())
    {
      const HoleBox box = hole_box(m);
      for (const double line : with_middle(box.left, box.right, m.cell_size))
        x.push_back(line);
      for (const double line : with_middle(box.bottom, box.top, m.cell_size))
        y.push_back(line);
    }
    return {{x, y}};
  }



  QuadMesh
  strip_mesh(const StripMeasures &m)
  {
    const std::array<std::vector<double>, 2> fixed = fixed_lines(m);
    const std::vector<double> x = m.mirrored.lines(0, fixed[0], m.cell_size);
    const std::vector<double> y = m.mirrored.lines(1, fixed[1], m.cell_size);
    QuadMesh                  mesh;
    if (m.has_hole())
    {
      const HoleBox box = hole_box(m);
      mesh              = tensor_mesh(x, y, [&box](const dealii::Point<2> &p) {
        return p[0] > box.left && p[0] < box.right && p[1] > box.bottom &&
               p[1] < box.top;
      });
      add_ring(mesh, box_sides(mesh, box, x, y), m);
      mesh.smooth([&m](const dealii::Point<2> &p) {
        return m.has_notch() && p[1] == m.notch_height &&
               p[0] <= m.notch_length;
      });
    }
    else
      mesh = tensor_mesh(x, y);

    if (m.has_notch())
      mesh.open_slit(m.notch_tip());
    return mesh;
  }
} // namespace MixedCracks
