// SPDX-License-Identifier: GPL-2.0-or-later
// From distributed fields to what rank 0 traces in the plane (in space:
// crack_observer_space.cc). Tracing is about whole bands, and only a few cells
// are damaged: those with a node below 0.9 are sent to rank 0, 12 numbers each
// (four vertices x, y and their phi), and the verdict on the body comes back,
// one number.
//
// Whether nodes have broken is asked in every iteration of a step: one
// reduction when there are none, and an exchange of points only when there are.
// What is gathered comes in an order that depends on the number of ranks, and
// what is built up one by one depends on the order (damage_origins.cc, the
// first of equals in tracing). Points are sorted by x, y, cells and edges by
// all of their numbers: unstructured cells may share their first vertex.

#include <cracks/crack_observer.h>
#include <cracks/damage_origins.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <tuple>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // a node is broken below this: half a cell of l/2 beside a crack phi is
    // sin(1/4) = 0.25 with Wu's density, so that a crack between two rows of
    // nodes has broken ones
    constexpr double broken = 0.3;
    // cells without a node below this are of no interest for paths
    constexpr double damaged = 0.9;
    // damage belongs to earlier damage within this, in length scales
    constexpr double reach = 3.;

    // numbers as they can be sent: four vertices and their values
    using CellNumbers = std::array<double, 12>;
    // two vertices and the number of the boundary
    using EdgeNumbers = std::array<double, 5>;

    // In an order that does not depend on the number of ranks, as long as no
    // two are equal.
    template <typename Numbers>
    std::vector<Numbers>
    gathered_on_root(const std::vector<Numbers> &own,
                     const MPI_Comm              communicator)
    {
      std::vector<Numbers> all;
      for (const auto &part : Utilities::MPI::gather(communicator, own))
        all.insert(all.end(), part.begin(), part.end());
      std::sort(all.begin(), all.end());
      return all;
    }
  } // namespace



  template <int dim>
  void
  CrackObserver<dim>::reinit(const double length, const double lag)
  {
    length_scale          = length;
    front_lag             = lag;
    const IndexSet &owned = fields.phase_field_dofs.owned;
    positions.assign(owned.n_elements(), Point<3>());
    for (const auto &cell : fields.phase_field.active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int v : cell->vertex_indices())
        {
          const auto dof = cell->vertex_dof_index(v, 0);
          if (owned.is_element(dof))
            positions[owned.index_within_set(dof)] = in_space(cell->vertex(v));
        }
    edges = boundary_edges();
  }



  template <int dim>
  std::vector<Point<3>>
  CrackObserver<dim>::newly_broken(const Vector        &phase_field,
                                   const DamageOrigins &origins) const
  {
    std::vector<Point<3>> own, all;
    const IndexSet       &owned = fields.phase_field_dofs.owned;
    for (unsigned int i = 0; i < positions.size(); ++i)
      if (phase_field(owned.nth_index_in_set(i)) < broken &&
          !is_known(positions[i], origins))
        own.push_back(positions[i]);
    const MPI_Comm communicator = fields.communicator();
    if (Utilities::MPI::max(own.empty() ? 0 : 1, communicator) > 0)
      for (const auto &part : Utilities::MPI::all_gather(communicator, own))
        all.insert(all.end(), part.begin(), part.end());
    // in an order that does not depend on the number of ranks
    std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
      return std::tie(a[0], a[1], a[2]) < std::tie(b[0], b[1], b[2]);
    });
    return all;
  }



  template <int dim>
  DamageOrigins
  CrackObserver<dim>::first_origins(const Vector &phase_field) const
  {
    DamageOrigins nothing_known;
    nothing_known.reach = reach * length_scale;
    return origins_at_start(nothing_known.reach,
                            newly_broken(phase_field, nothing_known));
  }



  template <int dim>
  void
  CrackObserver<dim>::watch(State &state) const
  {
    if (state.damage_origins.is_watched())
      add_broken_nodes(newly_broken(state.phase_field, state.damage_origins),
                       state.damage_origins);
  }



  template <int dim>
  std::vector<DamagedCell>
  CrackObserver<dim>::damaged_cells(const Vector &phase_field) const
  {
    std::vector<CellNumbers> own;
    if constexpr (dim == 2)
      for (const auto &cell : fields.phase_field.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          CellNumbers numbers;
          double      smallest = 1.;
          for (const unsigned int v : cell->vertex_indices())
          {
            const double value = phase_field(cell->vertex_dof_index(v, 0));
            numbers[2 * v]     = cell->vertex(v)[0];
            numbers[2 * v + 1] = cell->vertex(v)[1];
            numbers[8 + v]     = value;
            smallest           = std::min(smallest, value);
          }
          if (smallest < damaged)
            own.push_back(numbers);
        }
    std::vector<DamagedCell> cells;
    for (const CellNumbers &numbers :
         gathered_on_root(own, fields.communicator()))
    {
      DamagedCell cell;
      for (unsigned int v = 0; v < 4; ++v)
      {
        cell.vertices[v]    = {numbers[2 * v], numbers[2 * v + 1]};
        cell.phase_field[v] = numbers[8 + v];
      }
      cells.push_back(cell);
    }
    return cells;
  }



  template <int dim>
  std::vector<BoundaryEdge>
  CrackObserver<dim>::boundary_edges() const
  {
    std::vector<EdgeNumbers> own;
    if constexpr (dim == 2)
      for (const auto &cell : fields.phase_field.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary())
            {
              const auto &begin = cell->face(f)->vertex(0);
              const auto &end   = cell->face(f)->vertex(1);
              own.push_back({{begin[0],
                              begin[1],
                              end[0],
                              end[1],
                              1. * cell->face(f)->boundary_id()}});
            }
    std::vector<BoundaryEdge> result;
    for (const auto &numbers : gathered_on_root(own, fields.communicator()))
    {
      const auto name = names.find(static_cast<types::boundary_id>(numbers[4]));
      result.push_back({{numbers[0], numbers[1]},
                        {numbers[2], numbers[3]},
                        name == names.end() ? "boundary" : name->second});
    }
    return result;
  }



  template <int dim>
  TracedCracks
  CrackObserver<dim>::trace(const State &state) const
  {
    TracedCracks traced;
    if (!state.damage_origins.is_watched())
      return traced;
    if constexpr (dim == 3)
      return trace_in_space(fields, names, length_scale, front_lag, state);
    const MPI_Comm                 communicator = fields.communicator();
    const std::vector<DamagedCell> cells = damaged_cells(state.phase_field);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      CrackPathOptions options;
      options.length_scale = length_scale;
      options.nuclei       = in_plane(state.damage_origins.nuclei);
      if (!cells.empty())
        traced.paths = trace_cracks(cells, edges, options);
      traced.outcome =
        classify(traced.paths, edges, options.nuclei, length_scale);
    }
    const int are_separate = separates(traced.outcome) ? 1 : 0;
    traced.separate_body = Utilities::MPI::max(are_separate, communicator) > 0;
    return traced;
  }



  template class CrackObserver<2>;
  template class CrackObserver<3>;
} // namespace MixedCracks
