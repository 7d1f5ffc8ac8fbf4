// SPDX-License-Identifier: GPL-2.0-or-later
// The dofs of a vertex at a given point x: those of the vertices v with
//
//   |x_v - x| < 1e-6 diameter of the cell.
//
// A hanging vertex is none of them: its value follows from its neighbours. One
// on a periodic side stands for the one whose image it is.

#include <base/errors.h>

#include <deal.II/base/mpi.h>

#include <discretization/nearest_vertex.h>
#include <discretization/vertex_dofs.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // Of one component at vertex v; the dofs of the vertices come first.
    template <int dim>
    void
    add_dofs_of_vertex(const FiniteElement<dim>        &element,
                       const unsigned int               v,
                       const unsigned int               component,
                       const VertexDofs                &indices,
                       const AffineConstraints<double> &constraints,
                       VertexDofs                      &found)
    {
      const unsigned int n = element.n_dofs_per_vertex();
      for (unsigned int local = v * n; local < (v + 1) * n; ++local)
        if (element.system_to_component_index(local).first == component)
        {
          if (!constraints.is_constrained(indices[local]))
            found.push_back(indices[local]);
          else if (const auto *entries =
                     constraints.get_constraint_entries(indices[local]);
                   entries != nullptr && entries->size() == 1)
            found.push_back(entries->front().first);
        }
    }
  } // namespace



  template <int dim>
  std::vector<VertexDofs>
  dofs_at_vertices(const DoFHandler<dim>                   &dofs,
                   const AffineConstraints<double>         &constraints,
                   const std::vector<VertexComponent<dim>> &places,
                   const std::string                       &entry)
  {
    std::vector<VertexDofs>   result(places.size());
    const FiniteElement<dim> &element = dofs.get_fe();
    VertexDofs                indices(element.n_dofs_per_cell());
    // a set of points may be as large as a side of the mesh
    std::multimap<double, std::size_t> by_x;
    for (std::size_t i = 0; i < places.size(); ++i)
      by_x.emplace(places[i].point[0], i);
    for (const auto &cell : dofs.active_cell_iterators())
    {
      if (cell->is_artificial())
        continue;
      const double tolerance = 1e-6 * cell->diameter();
      for (const unsigned int v : cell->vertex_indices())
      {
        const Point<dim> vertex = cell->vertex(v);
        const auto       end    = by_x.upper_bound(vertex[0] + tolerance);
        for (auto at = by_x.lower_bound(vertex[0] - tolerance); at != end; ++at)
        {
          const std::size_t i = at->second;
          if (vertex.distance(places[i].point) >= tolerance)
            continue;
          cell->get_dof_indices(indices);
          add_dofs_of_vertex(
            element, v, places[i].component, indices, constraints, result[i]);
        }
      }
    }
    std::vector<int> found;
    for (VertexDofs &here : result)
    {
      std::sort(here.begin(), here.end());
      here.erase(std::unique(here.begin(), here.end()), here.end());
      found.push_back(here.empty() ? 0 : 1);
    }
    Utilities::MPI::max(found, dofs.get_communicator(), found);
    for (std::size_t i = 0; i < places.size(); ++i)
      if (found[i] == 0 && !places[i].may_hang)
      {
        std::ostringstream message;
        message << entry << ": found '" << places[i].point
                << "', where the mesh has no vertex (or a hanging node). "
                   "Allowed are the vertices of its cells; the nearest is "
                << in_words(
                     nearest_vertex(dofs.get_triangulation(), places[i].point))
                << ".";
        throw InputError(message.str());
      }
    return result;
  }



  std::vector<VertexDofs>
  owned_of(const std::vector<VertexDofs> &places, const IndexSet &owned)
  {
    std::vector<VertexDofs> result(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      std::copy_if(places[i].begin(),
                   places[i].end(),
                   std::back_inserter(result[i]),
                   [&owned](const auto dof) { return owned.is_element(dof); });
    return result;
  }



  template std::vector<VertexDofs>
  dofs_at_vertices(const DoFHandler<2> &,
                   const AffineConstraints<double> &,
                   const std::vector<VertexComponent<2>> &,
                   const std::string &);
  template std::vector<VertexDofs>
  dofs_at_vertices(const DoFHandler<3> &,
                   const AffineConstraints<double> &,
                   const std::vector<VertexComponent<3>> &,
                   const std::string &);
} // namespace MixedCracks
