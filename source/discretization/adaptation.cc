// SPDX-License-Identifier: GPL-2.0-or-later
// Where finer cells are asked for: predictor and corrector [HWW15, ch. 4]. The
// step computes phi on the mesh it has (predictor); where
//
//   phi(x_v) < threshold  at a vertex of a cell that may be refined,
//
// that cell and all within 'margin' are refined, the accepted state is carried
// over and the step repeated (corrector). A step is accepted on a mesh that its
// own phase field does not ask to refine.
//
// A running crack would ask for the next cell in every iteration. Therefore
// cells ahead of a tip at coarse cells are refined at once,
//
//   x_tip + s n,   s = step, 2 step, ... <= lookahead,
//
// n the direction out of the damage. Nodes with a forward direction (PointGrid:
// damage reaches farther back than to the sides) that are nearer than
// 'distance' to each other are one tip, and n is the sum of theirs.

#include <base/coordinates.h>

#include <deal.II/base/mpi.h>

#include <discretization/adaptation.h>
#include <discretization/point_grid.h>

#include <algorithm>
#include <map>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    template <int dim>
    struct DamagedNodes
    {
      std::vector<Point<dim>> all;
      // those of cells that may be refined; where a crack meets coarse cells
      std::vector<Point<dim>> at_coarse_cells;
      double                  largest_diameter = 0.; // of such cells
    };



    // each point once, in an order that does not depend on the number of ranks
    template <int dim>
    std::vector<Point<dim>>
    gathered(const std::map<types::global_dof_index, Point<dim>> &own,
             const MPI_Comm                                       communicator)
    {
      std::vector<Point<dim>> points, all;
      for (const auto &[dof, point] : own)
        points.push_back(point);
      for (const auto &part : Utilities::MPI::all_gather(communicator, points))
        all.insert(all.end(), part.begin(), part.end());
      std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
        return coordinates_of(a) < coordinates_of(b);
      });
      all.erase(std::unique(all.begin(), all.end()), all.end());
      return all;
    }



    // the nodes of owned cells that lie below the threshold, on all ranks;
    // none when every cell they belong to is as fine as it may be
    template <int dim>
    DamagedNodes<dim>
    damaged_nodes(const Fields<dim>    &fields,
                  const Vector         &phase_field,
                  const AdaptationRule &rule)
    {
      DamagedNodes<dim>                             nodes;
      std::map<types::global_dof_index, Point<dim>> own, own_coarse;
      for (const auto &cell : fields.phase_field.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          const bool may_be_refined =
            static_cast<unsigned int>(cell->level()) < rule.finest_level;
          if (may_be_refined)
            nodes.largest_diameter =
              std::max(nodes.largest_diameter, cell->diameter());
          for (const unsigned int v : cell->vertex_indices())
          {
            const auto dof = cell->vertex_dof_index(v, 0);
            if (phase_field(dof) >= rule.threshold)
              continue;
            own[dof] = cell->vertex(v);
            if (may_be_refined)
              own_coarse[dof] = cell->vertex(v);
          }
        }
      const MPI_Comm communicator = fields.communicator();
      nodes.largest_diameter =
        Utilities::MPI::max(nodes.largest_diameter, communicator);
      nodes.at_coarse_cells = gathered(own_coarse, communicator);
      if (!nodes.at_coarse_cells.empty())
        nodes.all = gathered(own, communicator);
      return nodes;
    }



    // The nodes around one tip, and the unit vectors that point out of the
    // damage there.
    template <int dim>
    struct Tip
    {
      std::vector<Point<dim>> nodes;
      Tensor<1, dim>          forward; // their sum

      Point<dim>
      foremost() const
      {
        return *std::max_element(
          nodes.begin(), nodes.end(), [&](const auto &a, const auto &b) {
            return (a - b) * forward < 0.;
          });
      }
    };



    template <int dim>
    std::vector<Tip<dim>>
    tips_at_coarse_cells(const DamagedNodes<dim> &nodes, const double distance)
    {
      const PointGrid<dim>  grid(nodes.all, distance);
      std::vector<Tip<dim>> tips;
      for (const Point<dim> &node : nodes.at_coarse_cells)
      {
        const Tensor<1, dim> forward = grid.forward_of_tip(node, distance);
        if (forward.norm() == 0.)
          continue;
        auto tip = std::find_if(tips.begin(), tips.end(), [&](const auto &t) {
          return t.nodes.front().distance(node) < distance;
        });
        if (tip == tips.end())
          tip = tips.insert(tips.end(), Tip<dim>());
        tip->nodes.push_back(node);
        tip->forward += forward;
      }
      return tips;
    }



    // places ahead of the tips that have come to coarse cells
    template <int dim>
    std::vector<Point<dim>>
    points_ahead(const DamagedNodes<dim> &nodes, const AdaptationRule &rule)
    {
      const double            distance = rule.margin + nodes.largest_diameter;
      const double            step = rule.margin > 0. ? rule.margin : distance;
      std::vector<Point<dim>> ahead;
      for (const Tip<dim> &tip : tips_at_coarse_cells(nodes, distance))
        if (tip.forward.norm() > 0.)
          for (double s = step; s < rule.lookahead + step; s += step)
            ahead.push_back(tip.foremost() + std::min(s, rule.lookahead) *
                                               tip.forward /
                                               tip.forward.norm());
      return ahead;
    }
  } // namespace



  template <int dim>
  AdaptationPlaces<dim>
  places_to_refine(const Fields<dim>    &fields,
                   const Vector         &phase_field,
                   const AdaptationRule &rule)
  {
    const DamagedNodes<dim> nodes = damaged_nodes(fields, phase_field, rule);
    AdaptationPlaces<dim>   places;
    if (rule.coarsens())
    {
      places.growing = nodes.at_coarse_cells;
      places.damaged = nodes.all;
    }
    else
      places.growing = nodes.all;
    if (rule.lookahead > 0. && !nodes.all.empty())
    {
      const std::vector<Point<dim>> ahead = points_ahead(nodes, rule);
      places.growing.insert(places.growing.end(), ahead.begin(), ahead.end());
    }
    return places;
  }



#define INSTANTIATE(dim)                           \
  template AdaptationPlaces<dim> places_to_refine( \
    const Fields<dim> &, const Vector &, const AdaptationRule &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
