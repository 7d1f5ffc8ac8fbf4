// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of cells and unknowns before the mesh is made: cells are cut on
// paper, each only as far as it is decided by the regions,
//
//   most  levels that some part of the cell gets, with a ring around regions
//         where neighbours of cut cells are cut so that levels differ by one
//   least levels that every part gets.
//
// most = least: 2^(dim (to - from)) cells of level 'to'. Otherwise its
// children, up to a number of visits. Width of the ring around a region of
// level F for a cell of level L, in its own size: one cell of each level
// between,
//
//   1/2 + 1/4 + ... + 2^-(F-1-L) = 1 - 2^-(F-1-L).
//
// Unknowns: exactly for the uniform part of the mesh; one vertex, and for
// degree two 2^dim nodes, for each further cell, which is the limit far from
// boundaries.

#include <deal.II/base/mpi.h>

#include <discretization/mesh_estimate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // cells that are looked at before the rest is extrapolated
    constexpr unsigned int most_visits = 200000;

    // A cell by its corners, which need not exist.
    template <int dim>
    struct VirtualCell
    {
      static constexpr unsigned int n = GeometryInfo<dim>::vertices_per_cell;

      std::array<Point<dim>, n> corners;
      unsigned int              level;

      CellExtent<dim>
      extent() const
      {
        Point<dim> center;
        double     diameter = 0.;
        for (unsigned int v = 0; v < n; ++v)
        {
          center += corners[v] / (1. * n);
          diameter =
            std::max(diameter, corners[v].distance(corners[n - 1 - v]));
        }
        return {BoundingBox<dim>(
                  std::vector<Point<dim>>(corners.begin(), corners.end())),
                center,
                diameter};
      }

      VirtualCell
      child(const unsigned int number) const
      {
        VirtualCell result;
        result.level = level + 1;
        for (unsigned int v = 0; v < n; ++v)
        {
          Point<dim> unit = GeometryInfo<dim>::unit_cell_vertex(number);
          unit += GeometryInfo<dim>::unit_cell_vertex(v);
          unit *= 0.5;
          for (unsigned int w = 0; w < n; ++w)
            result.corners[v] +=
              corners[w] * GeometryInfo<dim>::d_linear_shape_function(unit, w);
        }
        return result;
      }
    };



    // As levels of neighbours differ by one at most, a cell is cut where a
    // region whose cells get level @p finest is nearer than one cell of each
    // level between: so far, in units of its size.
    double
    ring_around(const unsigned int level, const unsigned int finest)
    {
      return level + 1 < finest ? 1. - std::pow(0.5, 1. * (finest - 1 - level))
                                : 0.;
    }



    // The cell with a ring around it.
    template <int dim>
    CellExtent<dim>
    grown(const CellExtent<dim> &cell, const double ring)
    {
      Point<dim> lower, upper;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double width = ring * cell.box.side_length(d);
        lower[d]           = cell.box.lower_bound(d) - width;
        upper[d]           = cell.box.upper_bound(d) + width;
      }
      return {BoundingBox<dim>({lower, upper}),
              cell.center,
              (1. + 2. * ring) * cell.diameter};
    }



    // What regions do to a cell and all that it is cut into.
    struct Reach
    {
      unsigned int most;  // levels that a part of it may get
      unsigned int least; // levels that every part gets
    };

    template <int dim>
    Reach
    reach_of(const CellExtent<dim>        &cell,
             const unsigned int            level,
             const unsigned int            n_global,
             const RefinementRegions<dim> &regions)
    {
      Reach        reach{0, 0};
      const double radius = 0.5 * cell.diameter;
      const auto   note   = [&reach](const unsigned int levels,
                                 const bool         everywhere) {
        reach.most = std::max(reach.most, levels);
        if (everywhere)
          reach.least = std::max(reach.least, levels);
      };
      for (const RefinementBox<dim> &each : regions.boxes)
      {
        const CellExtent<dim> ring =
          grown(cell, ring_around(level, n_global + each.levels));
        bool apart = false, inside = true;
        for (unsigned int d = 0; d < dim; ++d)
        {
          const double lower = each.box.lower_bound(d),
                       upper = each.box.upper_bound(d);
          apart              = apart || ring.box.upper_bound(d) <= lower ||
                  ring.box.lower_bound(d) >= upper;
          inside = inside && cell.box.lower_bound(d) >= lower &&
                   cell.box.upper_bound(d) <= upper;
        }
        if (!apart)
          note(each.levels, inside);
      }
      for (const RefinementSurroundings<dim> &each : regions.surroundings)
      {
        double nearest = std::numeric_limits<double>::max();
        for (const FlatPiece<dim> &piece : each.pieces)
          nearest = std::min(nearest, distance(cell.center, piece));
        const double ring = ring_around(level, n_global + each.levels);
        if (nearest < each.distance + 2. * (1. + ring) * radius)
          note(each.levels, nearest + radius < each.distance);
      }
      return reach;
    }



    // Cells by level.
    template <int dim>
    class Counter
    {
    public:
      Counter(const unsigned int            n_global,
              const RefinementRegions<dim> &regions)
        : n_global(n_global)
        , regions(regions)
      {
        for (const auto &each : regions.boxes)
          most_levels = std::max(most_levels, each.levels);
        for (const auto &each : regions.surroundings)
          most_levels = std::max(most_levels, each.levels);
      }

      // @p size: measure^(1/dim) of the cell of the coarse mesh
      void
      count(const VirtualCell<dim> &cell, const double size)
      {
        const CellExtent<dim> extent = cell.extent();
        const Reach           reach =
          reach_of<dim>(extent, cell.level, n_global, regions);
        if (reach.most == reach.least || ++n_visits > most_visits)
        {
          add(cell.level, std::max(cell.level, n_global + reach.least), size);
          return;
        }
        if (is_cut(extent, cell.level))
          for (unsigned int c = 0; c < VirtualCell<dim>::n; ++c)
            count(cell.child(c), size);
        else
          add(cell.level, cell.level, size);
      }

      // by level: number of cells, and the sum of their sizes
      std::map<unsigned int, std::array<double, 2>> levels;

    private:
      bool
      is_cut(const CellExtent<dim> &cell, const unsigned int level) const
      {
        if (level < n_global)
          return true;
        for (unsigned int n = most_levels; n_global + n > level; --n)
          if (wanted_levels<dim>(grown(cell, ring_around(level, n_global + n)),
                                 regions) >= n)
            return true;
        return false;
      }

      void
      add(const unsigned int from, const unsigned int to, const double size)
      {
        const double n = std::pow(2., 1. * dim * (to - from));
        levels[to][0] += n;
        levels[to][1] += n * size * std::pow(0.5, to);
      }

      const unsigned int            n_global;
      const RefinementRegions<dim> &regions;
      unsigned int                  most_levels = 0;
      unsigned int                  n_visits    = 0;
    };



    // Vertices, edges, faces and cells of a mesh that is halved: each keeps its
    // own, each edge has a new vertex in its middle and two halves, each
    // quadrilateral a vertex, 4 edges and 4 quadrilaterals, each hexahedron a
    // vertex, 6 edges, 12 quadrilaterals and 8 hexahedra. Quadratic elements
    // have a node on each of them.
    template <int dim>
    struct Parts
    {
      double vertices, lines, quads, hexes;

      void
      refine()
      {
        const Parts old = *this;
        vertices        = old.vertices + old.lines + old.quads + old.hexes;
        lines           = 2. * old.lines + 4. * old.quads + 6. * old.hexes;
        quads           = 4. * old.quads + 12. * old.hexes;
        hexes           = 8. * old.hexes;
      }

      // of a continuous scalar field of that degree
      double
      dofs(const unsigned int degree) const
      {
        return degree == 1 ? vertices : vertices + lines + quads + hexes;
      }
    };



    template <int dim>
    Parts<dim>
    parts_of(const Triangulation<dim> &coarse)
    {
      Parts<dim> parts{1. * coarse.n_used_vertices(),
                       1. * coarse.n_active_lines(),
                       1. * coarse.n_active_quads(),
                       0.};
      if (dim == 3)
        parts.hexes = coarse.n_active_cells();
      return parts;
    }
  } // namespace



  template <int dim>
  MeshEstimate
  estimate_mesh(const Triangulation<dim>     &coarse,
                const FieldLayout            &layout,
                const unsigned int            n_global,
                const RefinementRegions<dim> &regions)
  {
    // Every rank has all cells of the coarse mesh, and takes some.
    const MPI_Comm     communicator = coarse.get_communicator();
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    unsigned int       turn    = Utilities::MPI::this_mpi_process(communicator);
    Counter<dim>       counter(n_global, regions);
    for (const auto &cell : coarse.cell_iterators_on_level(0))
      if (turn++ % n_ranks == 0)
      {
        VirtualCell<dim> copy;
        copy.level = 0;
        for (const unsigned int v : cell->vertex_indices())
          copy.corners[v] = cell->vertex(v);
        counter.count(copy, std::pow(cell->measure(), 1. / dim));
      }

    MeshEstimate estimate;
    unsigned int finest =
      counter.levels.empty() ? 0 : counter.levels.rbegin()->first;
    finest = Utilities::MPI::max(finest, communicator);
    std::vector<double> sums(3, 0.);
    for (const auto &[level, counts] : counter.levels)
      sums[0] += counts[0];
    sums[1] = counter.levels[finest][0];
    sums[2] = counter.levels[finest][1];
    Utilities::MPI::sum(sums, communicator, sums);
    estimate.n_cells      = sums[0];
    estimate.finest_level = finest;
    estimate.finest_size  = sums[2] / sums[1];
    estimate.is_exact = regions.boxes.empty() && regions.surroundings.empty();

    Parts<dim> parts = parts_of(coarse);
    for (unsigned int i = 0; i < n_global; ++i)
      parts.refine();
    // far from the boundary there are as many vertices as cells, and 2^dim
    // nodes of degree 2
    const double added =
      estimate.n_cells - (dim == 2 ? parts.quads : parts.hexes);
    const double vertices  = parts.dofs(1) + added;
    const double nodes     = layout.displacement_degree == 1
                               ? vertices
                               : parts.dofs(2) + added * std::pow(2., 1. * dim);
    estimate.n_phase_field = vertices;
    estimate.n_elastic     = dim * nodes + (layout.mixed ? vertices : 0.);
    return estimate;
  }



  template <int dim>
  void
  refine_at_points(Triangulation<dim>            &triangulation,
                   const unsigned int             n_global,
                   const RefinementRegions<dim>  &regions,
                   const std::vector<Point<dim>> &points,
                   const double                   max_cells)
  {
    const double factor  = std::pow(2., 1. * dim);
    double       n_cells = 1. * triangulation.n_global_active_cells();
    for (unsigned int i = 0; i < n_global && factor * n_cells <= max_cells; ++i)
    {
      triangulation.refine_global(1);
      n_cells *= factor;
    }
    unsigned int n_flagged = points.empty() ? 0 : 1;
    while (n_flagged > 0)
    {
      n_flagged = 0;
      for (const auto &cell : triangulation.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        // sides may be curved
        BoundingBox<dim> box = cell->bounding_box();
        box.extend(0.05 * cell->diameter());
        if (std::any_of(
              points.begin(),
              points.end(),
              [&box](const auto &point) { return box.point_inside(point); }) &&
            is_refined<dim>(cell, n_global, regions))
        {
          cell->set_refine_flag();
          ++n_flagged;
        }
      }
      n_flagged =
        Utilities::MPI::sum(n_flagged, triangulation.get_communicator());
      if (n_flagged > 0)
        triangulation.execute_coarsening_and_refinement();
    }
  }



#define INSTANTIATE(dim)                                                  \
  template MeshEstimate estimate_mesh(const Triangulation<dim> &,         \
                                      const FieldLayout &,                \
                                      unsigned int,                       \
                                      const RefinementRegions<dim> &);    \
  template void         refine_at_points(Triangulation<dim> &,            \
                                         unsigned int,                    \
                                         const RefinementRegions<dim> &,  \
                                         const std::vector<Point<dim>> &, \
                                         double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
