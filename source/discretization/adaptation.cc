// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/base/mpi.h>

#include <deal.II/distributed/solution_transfer.h>

#include <discretization/adaptation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // Points sorted into boxes, so that those near a place are found quickly.
    template <int dim>
    class PointGrid
    {
    public:
      // @p size: of the boxes, the largest distance that is asked for
      PointGrid(const std::vector<Point<dim>> &points, const double size)
        : size(size)
      {
        for (const Point<dim> &point : points)
          boxes[box_of(point)].push_back(point);
      }

      bool
      has_point_within(const Point<dim> &center, const double distance) const
      {
        const Box home = box_of(center);
        for (int i = 0; i < Utilities::pow(3, dim); ++i)
        {
          Box near = home;
          for (int d = 0, rest = i; d < dim; ++d, rest /= 3)
            near[d] += rest % 3 - 1;
          const auto found = boxes.find(near);
          if (found == boxes.end())
            continue;
          for (const Point<dim> &point : found->second)
            if (point.distance(center) <= distance)
              return true;
        }
        return false;
      }

    private:
      using Box = std::array<int, dim>;

      Box
      box_of(const Point<dim> &point) const
      {
        Box box;
        for (unsigned int d = 0; d < dim; ++d)
          box[d] = static_cast<int>(std::floor(point[d] / size));
        return box;
      }

      const double                           size;
      std::map<Box, std::vector<Point<dim>>> boxes;
    };



    // the nodes of owned cells that lie below the threshold, on all ranks;
    // none when every cell they belong to is as fine as it may be
    template <int dim>
    std::vector<Point<dim>>
    damaged_nodes(const Fields<dim>    &fields,
                  const Vector         &phase_field,
                  const AdaptationRule &rule,
                  double               &largest_diameter)
    {
      std::map<types::global_dof_index, Point<dim>> own;
      bool                                          is_coarse = false;
      for (const auto &cell : fields.phase_field.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          const bool may_be_refined =
            static_cast<unsigned int>(cell->level()) < rule.finest_level;
          if (may_be_refined)
            largest_diameter = std::max(largest_diameter, cell->diameter());
          for (const unsigned int v : cell->vertex_indices())
          {
            const auto dof = cell->vertex_dof_index(v, 0);
            if (phase_field(dof) >= rule.threshold)
              continue;
            own[dof]  = cell->vertex(v);
            is_coarse = is_coarse || may_be_refined;
          }
        }
      const MPI_Comm communicator = fields.communicator();
      largest_diameter = Utilities::MPI::max(largest_diameter, communicator);
      if (Utilities::MPI::max(is_coarse ? 1 : 0, communicator) == 0)
        return {};
      std::vector<Point<dim>> points, all;
      for (const auto &[dof, point] : own)
        points.push_back(point);
      for (const auto &part : Utilities::MPI::all_gather(communicator, points))
        all.insert(all.end(), part.begin(), part.end());
      return all;
    }
  } // namespace



  template <int dim>
  bool
  flag_damaged_cells(const Fields<dim>    &fields,
                     const Vector         &phase_field,
                     const AdaptationRule &rule,
                     Triangulation<dim>   &triangulation)
  {
    double                        largest_diameter = 0.;
    const std::vector<Point<dim>> nodes =
      damaged_nodes(fields, phase_field, rule, largest_diameter);
    if (nodes.empty())
      return false;
    const PointGrid<dim> grid(nodes, rule.margin + largest_diameter);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() &&
          static_cast<unsigned int>(cell->level()) < rule.finest_level &&
          grid.has_point_within(cell->center(),
                                rule.margin + 0.51 * cell->diameter()))
        cell->set_refine_flag();
    return true;
  }



  namespace
  {
    template <int dim>
    using Transfer = parallel::distributed::SolutionTransfer<dim, Vector>;

    std::vector<const Vector *>
    as_constant(const std::vector<Vector *> &vectors)
    {
      return {vectors.begin(), vectors.end()};
    }



    // interpolate to the new mesh and give the vectors their new ghosts
    template <int dim>
    void
    take_over(Transfer<dim>                   &transfer,
              const Fields<dim>               &fields,
              const DofSets                   &dofs,
              const AffineConstraints<double> &hanging_nodes,
              const std::vector<Vector *>     &vectors)
    {
      if (vectors.empty())
        return;
      std::vector<Vector>   owned(vectors.size(), fields.owned_vector(dofs));
      std::vector<Vector *> pointers;
      for (Vector &vector : owned)
        pointers.push_back(&vector);
      transfer.interpolate(pointers);
      for (std::size_t i = 0; i < vectors.size(); ++i)
      {
        hanging_nodes.distribute(owned[i]);
        vectors[i]->reinit(dofs.owned, dofs.relevant, fields.communicator());
        *vectors[i] = owned[i];
      }
    }
  } // namespace



  template <int dim>
  void
  refine_and_transfer(parallel::distributed::Triangulation<dim> &triangulation,
                      Fields<dim>                               &fields,
                      Constraints<dim>                          &constraints,
                      const std::vector<Vector *>               &elastic,
                      const std::vector<Vector *>               &phase_field)
  {
    Transfer<dim> of_elastic(fields.elastic);
    Transfer<dim> of_phase_field(fields.phase_field);
    triangulation.prepare_coarsening_and_refinement();
    if (!elastic.empty())
      of_elastic.prepare_for_coarsening_and_refinement(as_constant(elastic));
    if (!phase_field.empty())
      of_phase_field.prepare_for_coarsening_and_refinement(
        as_constant(phase_field));
    triangulation.execute_coarsening_and_refinement();
    fields.distribute();
    constraints.reinit();
    take_over(of_elastic,
              fields,
              fields.elastic_dofs,
              constraints.elastic_hanging_nodes(),
              elastic);
    take_over(of_phase_field,
              fields,
              fields.phase_field_dofs,
              constraints.phase_field_hanging_nodes(),
              phase_field);
  }



#define INSTANTIATE(dim)                                   \
  template bool flag_damaged_cells(const Fields<dim> &,    \
                                   const Vector &,         \
                                   const AdaptationRule &, \
                                   Triangulation<dim> &);  \
  template void refine_and_transfer(                       \
    parallel::distributed::Triangulation<dim> &,           \
    Fields<dim> &,                                         \
    Constraints<dim> &,                                    \
    const std::vector<Vector *> &,                         \
    const std::vector<Vector *> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
