// SPDX-License-Identifier: GPL-2.0-or-later
// Connected components of intact nodes. Each rank joins those of its own cells
// and of the ghosts around them (union-find), a component having the smallest
// number of its nodes; then, until nothing changes on any rank,
//
//   owners tell the numbers of their nodes to the ranks that have them as
//   ghosts a component takes the smallest number that one of its nodes was told
//
// as often as a part leads from rank to rank, at most. An intact node has an
// eighth of the volume of each of its cells. A hanging node is joined to the
// coarse cell, too, on whose face it lies.

#include <cracks/intact_parts.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // Of the nodes that one rank knows.
    class Components
    {
    public:
      Components(const Fields<3>             &fields,
                 const LinearAlgebra::Vector &phase_field,
                 const double                 connected)
        : fields(fields)
        , nodes(std::make_shared<const Utilities::MPI::Partitioner>(
            fields.phase_field_dofs.owned,
            fields.phase_field_dofs.relevant,
            fields.communicator()))
        , root(nodes->locally_owned_size() + nodes->n_ghost_indices())
        , is_intact(root.size(), false)
        , labels(nodes)
      {
        std::iota(root.begin(), root.end(), 0u);
        for (const auto &cell : fields.phase_field.active_cell_iterators())
          if (!cell->is_artificial())
            join_nodes(cell, phase_field, connected);
        agree();
      }

      /// Volume and boundaries of the components, by label, from own cells.
      std::map<double, IntactPart>
      own_parts()
      {
        std::map<double, IntactPart> parts;
        for (const auto &cell : fields.phase_field.active_cell_iterators())
          if (cell->is_locally_owned())
          {
            for (const unsigned int v : cell->vertex_indices())
              if (const unsigned int node = node_of(cell, v); is_intact[node])
                parts[label(node)].volume += cell->measure() / 8.;
            for (const unsigned int f : cell->face_indices())
              if (cell->face(f)->at_boundary())
                for (unsigned int i = 0; i < 4; ++i)
                {
                  const unsigned int node =
                    node_of(cell, GeometryInfo<3>::face_to_cell_vertices(f, i));
                  if (is_intact[node])
                    parts[label(node)].boundaries.insert(
                      cell->face(f)->boundary_id());
                }
          }
        return parts;
      }

    private:
      using Cell = DoFHandler<3>::active_cell_iterator;

      unsigned int
      node_of(const Cell &cell, const unsigned int vertex) const
      {
        return nodes->global_to_local(cell->vertex_dof_index(vertex, 0));
      }

      unsigned int
      root_of(unsigned int node)
      {
        while (root[node] != node)
          node = root[node] = root[root[node]];
        return node;
      }

      void
      join(const unsigned int a, const unsigned int b)
      {
        const unsigned int one = root_of(a), other = root_of(b);
        root[std::max(one, other)] = std::min(one, other);
      }

      // those of one cell, and of what hangs on its faces
      void
      join_nodes(const Cell                  &cell,
                 const LinearAlgebra::Vector &phase_field,
                 const double                 connected)
      {
        unsigned int first = numbers::invalid_unsigned_int;
        const auto   add   = [&](const Cell &of, const unsigned int vertex) {
          if (phase_field(of->vertex_dof_index(vertex, 0)) < connected)
            return;
          const unsigned int node = node_of(of, vertex);
          is_intact[node]         = true;
          if (first == numbers::invalid_unsigned_int)
            first = node;
          join(node, first);
        };
        for (const unsigned int v : cell->vertex_indices())
          add(cell, v);
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f) && cell->neighbor(f)->has_children())
            for (unsigned int c = 0; c < cell->face(f)->n_children(); ++c)
            {
              const auto child = cell->neighbor_child_on_subface(f, c);
              if (child->is_artificial())
                continue;
              for (unsigned int i = 0; i < 4; ++i)
                add(child,
                    GeometryInfo<3>::face_to_cell_vertices(
                      cell->neighbor_of_neighbor(f), i));
            }
      }

      // numbers of nodes on all ranks, until they do not change
      void
      agree()
      {
        std::vector<double> smallest(root.size(), 1e300);
        for (unsigned int node = 0; node < root.size(); ++node)
          if (is_intact[node])
            smallest[root_of(node)] = std::min(
              smallest[root_of(node)], 1. * nodes->local_to_global(node));
        for (int has_changed = 1; has_changed > 0;)
        {
          labels.zero_out_ghost_values();
          for (unsigned int node = 0; node < nodes->locally_owned_size();
               ++node)
            labels.local_element(node) =
              is_intact[node] ? smallest[root_of(node)] : -1.;
          labels.update_ghost_values();
          has_changed = 0;
          for (unsigned int node = nodes->locally_owned_size();
               node < root.size();
               ++node)
            if (is_intact[node] &&
                labels.local_element(node) < smallest[root_of(node)])
            {
              smallest[root_of(node)] = labels.local_element(node);
              has_changed             = 1;
            }
          has_changed = Utilities::MPI::max(has_changed, fields.communicator());
        }
        label_of_root = smallest;
      }

      double
      label(const unsigned int node)
      {
        return label_of_root[root_of(node)];
      }

      const Fields<3>                                   &fields;
      std::shared_ptr<const Utilities::MPI::Partitioner> nodes;
      std::vector<unsigned int>                          root;
      std::vector<bool>                                  is_intact;
      std::vector<double>                                label_of_root;
      dealii::LinearAlgebra::distributed::Vector<double> labels;
    };
  } // namespace



  std::vector<IntactPart>
  intact_parts(const Fields<3>             &fields,
               const LinearAlgebra::Vector &phase_field,
               const double                 connected)
  {
    // label and volume, or label and -1 - the id of a boundary
    std::vector<std::array<double, 2>> own;
    Components components(fields, phase_field, connected);
    for (const auto &[label, part] : components.own_parts())
    {
      own.push_back({{label, part.volume}});
      for (const types::boundary_id id : part.boundaries)
        own.push_back({{label, -1. - id}});
    }
    std::map<double, IntactPart> by_label;
    for (const auto &rows :
         Utilities::MPI::all_gather(fields.communicator(), own))
      for (const auto &[label, value] : rows)
        if (value >= 0.)
          by_label[label].volume += value;
        else
          by_label[label].boundaries.insert(
            static_cast<types::boundary_id>(-1. - value));
    std::vector<IntactPart> parts;
    for (const auto &[label, part] : by_label)
      parts.push_back(part);
    std::stable_sort(
      parts.begin(), parts.end(), [](const IntactPart &a, const IntactPart &b) {
        return a.volume > (1. + 1e-9) * b.volume;
      });
    return parts;
  }
} // namespace MixedCracks
