// SPDX-License-Identifier: GPL-2.0-or-later
// What the .prm says of the phase field: initial cracks, nodes that cannot
// break, values on the boundary.
#include <base/collective.h>
#include <base/errors.h>
#include <base/log.h>

#include <deal.II/numerics/vector_tools.h>

#include <discretization/slit_faces.h>

#include <simulation/simulation_load_size.h>
#include <simulation/simulation_setup.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // calls body(dof, position, size of the cell) for the owned nodes of the
    // phase field, seen from every cell around them
    template <int dim, typename Body>
    void
    for_each_node(const Fields<dim> &fields, const Body &body)
    {
      for (const auto &cell : fields.phase_field.active_cell_iterators())
        if (!cell->is_artificial())
          for (const unsigned int v : cell->vertex_indices())
          {
            const auto dof = cell->vertex_dof_index(v, 0);
            if (fields.phase_field_dofs.owned.is_element(dof))
              body(
                dof, cell->vertex(v), cell->diameter() / std::sqrt(1. * dim));
          }
    }



    template <int dim>
    std::string
    extent_in_words(const Triangulation<dim> &triangulation)
    {
      const auto corners = coarse_extent(triangulation).get_boundary_points();
      std::ostringstream text;
      text << "from (" << corners.first << ") to (" << corners.second << ") mm";
      return text.str();
    }



    // A crack without a broken node would be lost in silence. @p breaks: one
    // for each of the names, 0 on a rank where it breaks nothing.
    template <int dim>
    void
    require_broken_nodes(const std::vector<std::string> &names,
                         std::vector<int>                breaks,
                         const Fields<dim>              &fields)
    {
      Utilities::MPI::max(breaks, fields.communicator(), breaks);
      for (std::size_t i = 0; i < names.size(); ++i)
        if (breaks[i] == 0)
          throw InputError(
            names[i] +
            ", which breaks no node of the mesh. Allowed are "
            "cracks in the body, " +
            extent_in_words(fields.phase_field.get_triangulation()) +
            ", that are not too small for its cells or too narrow (Initial "
            "cracks/Half width).");
    }



    // where cells of different sizes meet, the smallest value
    template <int dim>
    void
    set_initial_cracks(const InitialCracks<dim> &cracks,
                       const Fields<dim>        &fields,
                       LinearAlgebra::Vector    &values)
    {
      const InitialPhaseField<dim> phase_field(cracks);
      std::vector<int>             breaks(phase_field.names().size(), 0);
      values = 1.;
      together(fields.communicator(), [&]() {
        for_each_node(
          fields, [&](const auto dof, const auto &position, const double size) {
            values(dof) =
              std::min<double>(values(dof), phase_field.value(position, size));
            phase_field.note_broken(position, size, breaks);
          });
      });
      require_broken_nodes(phase_field.names(), breaks, fields);
    }



    // those that the geometry knows; of a mesh from a file, where it has
    // doubled nodes
    template <int dim>
    std::vector<FlatPiece<dim>>
    slits_of(const Parameters<dim>    &parameters,
             const Triangulation<dim> &triangulation)
    {
      std::vector<FlatPiece<dim>> slits = parameters.geometry.chosen().slits();
      if (slits.empty())
        for (const SlitFace<dim> &face : slit_faces(triangulation))
          slits.push_back(face.place);
      return slits;
    }
  } // namespace



  // phi at the start: the smallest of 0 on slits and in cracks and the given
  // expression, node by node; hanging nodes are means of their neighbours.
  template <int dim>
  LinearAlgebra::Vector
  initial_phase_field(const Parameters<dim>  &parameters,
                      const Fields<dim>      &fields,
                      const Constraints<dim> &constraints)
  {
    const std::vector<FlatPiece<dim>> slits =
      parameters.initial_cracks.broken_slits
        ? slits_of(parameters, fields.phase_field.get_triangulation())
        : std::vector<FlatPiece<dim>>();
    LinearAlgebra::Vector values = fields.owned_vector(fields.phase_field_dofs);
    set_initial_cracks(parameters.initial_cracks, fields, values);
    for_each_node(fields,
                  [&](const auto dof, const auto &position, const double size) {
                    // slits are mesh lines; cracks need not be
                    for (const FlatPiece<dim> &slit : slits)
                      if (distance(position, slit) <= 1e-6 * size)
                        values(dof) = 0.;
                  });
    values.compress(VectorOperation::insert);
    constraints.spread_least(values);
    constraints.phase_field_hanging_nodes().distribute(values);
    return values;
  }



  template <int dim>
  void
  try_initial_phase_field(const Parameters<dim> &parameters,
                          const Fields<dim>     &fields,
                          const double           cell_size)
  {
    const InitialPhaseField<dim> phase_field(parameters.initial_cracks);
    together(fields.communicator(), [&]() {
      for_each_node(
        fields,
        [&](const types::global_dof_index,
            const Point<dim> &position,
            const double) { phase_field.value(position, cell_size); });
    });
  }



  template <int dim>
  State
  undeformed_state(const Parameters<dim>  &parameters,
                   const Fields<dim>      &fields,
                   const Constraints<dim> &constraints)
  {
    State state;
    state.elastic     = fields.ghosted_vector(fields.elastic_dofs);
    state.reaction    = state.elastic;
    state.phase_field = fields.ghosted_vector(fields.phase_field_dofs);
    // named, since a temporary would be moved and take the ghosts away
    const LinearAlgebra::Vector start =
      initial_phase_field(parameters, fields, constraints);
    state.phase_field          = start;
    state.lagged_phase_field   = state.phase_field;
    state.previous_phase_field = state.phase_field;
    return state;
  }



  namespace
  {
    // Where u is prescribed the stress is that of the clamp, not of the body:
    // its concentration at the edge of a clamp or under a point would break it
    // first.
    template <int dim>
    class UnbreakableMaterial
    {
    public:
      UnbreakableMaterial(const Parameters<dim>    &parameters,
                          const Triangulation<dim> &mesh)
        : margin(parameters.boundary_conditions.unbreakable_margin())
      {
        if (margin == 0.)
          return;
        // the coarse mesh is known to every rank, and its boundary with
        // prescribed displacement consists of flat faces
        const auto  ids = parameters.geometry.chosen().boundary_ids();
        BoundaryIds clamped;
        for (const auto &entry : parameters.boundary_conditions.displacements())
          if (entry.component < dim)
          {
            const BoundaryIds &held = ids.at(entry.boundary);
            clamped.insert(held.begin(), held.end());
          }
        for (const auto &cell : mesh.cell_iterators_on_level(0))
          for (const unsigned int face : cell->face_indices())
            if (cell->face(face)->at_boundary() &&
                clamped.contains(cell->face(face)->boundary_id()))
            {
              FlatPiece<dim> piece;
              for (const unsigned int v : cell->face(face)->vertex_indices())
                piece.corners[v] = cell->face(face)->vertex(v);
              faces.push_back(piece);
            }
        auto entries = parameters.boundary_conditions.point_displacements();
        const auto forces = parameters.boundary_conditions.point_forces();
        entries.insert(entries.end(), forces.begin(), forces.end());
        for (const auto &entry : placed_points(parameters, entries, mesh))
          points.push_back(entry.point);
        shifts = shifts_to_images(parameters, mesh);
      }

      bool
      is_empty() const
      {
        return margin == 0.;
      }

      // cell_size: of the rounding that is forgiven
      bool
      contains(const Point<dim> &position, const double cell_size) const
      {
        const double far = margin + 1e-6 * cell_size;
        for (const Tensor<1, dim> &shift : shifts)
        {
          const Point<dim> image = position + shift;
          for (const FlatPiece<dim> &face : faces)
            if (distance(image, face) <= far)
              return true;
          for (const Point<dim> &point : points)
            if (image.distance(point) <= far)
              return true;
        }
        return false;
      }

    private:
      const double                margin;
      std::vector<FlatPiece<dim>> faces;
      std::vector<Point<dim>>     points;
      std::vector<Tensor<1, dim>> shifts;
    };
  } // namespace



  template <int dim>
  IndexSet
  unbreakable_nodes(const Parameters<dim> &parameters,
                    const Fields<dim>     &fields)
  {
    IndexSet                       frozen(fields.phase_field.n_dofs());
    const UnbreakableMaterial<dim> unbreakable(
      parameters, fields.phase_field.get_triangulation());
    if (!unbreakable.is_empty())
      for_each_node(
        fields, [&](const auto dof, const auto &position, const double size) {
          if (unbreakable.contains(position, size))
            frozen.add_index(dof);
        });
    return frozen;
  }



  // The middles of cells count, so that it does not depend on the refinement.
  template <int dim>
  std::string
  warning_about_unbreakable(const Parameters<dim> &parameters,
                            const Fields<dim>     &fields)
  {
    const UnbreakableMaterial<dim> unbreakable(
      parameters, fields.phase_field.get_triangulation());
    if (unbreakable.is_empty())
      return "";
    std::vector<double> volumes(2, 0.); // of what cannot break, of all
    for (const auto &cell : fields.phase_field.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        volumes[1] += cell->measure();
        if (unbreakable.contains(cell->center(), 0.))
          volumes[0] += cell->measure();
      }
    Utilities::MPI::sum(volumes, fields.communicator(), volumes);
    const double share = volumes[0] / volumes[1];
    if (share < 0.5)
      return "";
    return format("%.0f %% of the body are within Boundary conditions/"
                  "Unbreakable margin = %.4g mm of a boundary or point with "
                  "prescribed displacement or a point with a force, and cannot "
                  "break; a plane of symmetry that shall not count is written "
                  "'boundary : symmetry'",
                  100. * share,
                  parameters.boundary_conditions.unbreakable_margin());
  }



  template <int dim>
  std::map<types::global_dof_index, double>
  prescribed_phase_field(const Parameters<dim> &parameters,
                         const Fields<dim>     &fields,
                         const double           time)
  {
    const auto ids = parameters.geometry.chosen().boundary_ids();
    std::map<types::global_dof_index, double> all, owned;
    together(fields.communicator(), [&]() {
      for (const auto &entry : parameters.boundary_conditions.displacements())
        if (entry.component == dim)
        {
          ExpressionFunction<dim> value(1);
          value.set(0, entry.expression);
          value.set_time(time);
          for (const types::boundary_id id : ids.at(entry.boundary))
            VectorTools::interpolate_boundary_values(
              fields.mapping, fields.phase_field, id, value, all);
        }
    });
    for (const auto &[dof, value] : all)
      if (fields.phase_field_dofs.owned.is_element(dof))
        owned[dof] = std::clamp(value, 0., 1.);
    return owned;
  }



#define INSTANTIATE(dim)                                                     \
  template LinearAlgebra::Vector initial_phase_field(                        \
    const Parameters<dim> &, const Fields<dim> &, const Constraints<dim> &); \
  template void try_initial_phase_field(                                     \
    const Parameters<dim> &, const Fields<dim> &, double);                   \
  template State undeformed_state(                                           \
    const Parameters<dim> &, const Fields<dim> &, const Constraints<dim> &); \
  template IndexSet    unbreakable_nodes(const Parameters<dim> &,            \
                                         const Fields<dim> &);               \
  template std::string warning_about_unbreakable(const Parameters<dim> &,    \
                                                 const Fields<dim> &);       \
  template std::map<types::global_dof_index, double> prescribed_phase_field( \
    const Parameters<dim> &, const Fields<dim> &, double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
