// SPDX-License-Identifier: GPL-2.0-or-later
// What is applied to the body, as lists in the .prm. With x the place, t the
// time and w a test function, in the terms of (M5) of doc/model.md:
//
//   Displacement             u_c = u_D(x, t) on a boundary, mm
//     component phase field  phi = phi_D(x, t) on a boundary, within 0 and 1
//     rotation about c       (R(u_D) - I)(x - c), u_D an angle in rad
//     symmetry               u . n = 0 on a plane
//   Displacement at points   u_c = u_D(x, t) at a vertex, mm
//   Phase field at points    phi = phi_D(x, t) at a vertex, within 0 and 1
//   Force at points          P_c(x, t) w_c at a vertex, each one of a set, N
//   Traction                 ( tau(x, t), w ) on a boundary, tau in MPa
//     component normal       tau n, n the outward normal before deformation
//   Pressure                 ( -p(x, t) n, w ) on a boundary, p in MPa; finite
//                            strain: ( -p cof(F) n, w )
//   Body force               ( f(x, t), w ) in the body, f in N/mm^3
//   Mean strain              u(x + L) - u(x) = E(t) L on periodic sides
//
// Each component is a condition of its own: a roller has one, a clamp, "all",
// dim of them. A boundary that is not named is free: tau = 0, and grad phi . n
// = 0. discretization/constraints.cc makes constraints of displacements, where
// the entry that comes first wins at nodes of two boundaries.
//
// Texts stay texts until they are asked for, so that a case can be checked
// before there is a mesh. Names of boundaries are known then, but for those of
// a mesh file that the .prm does not name: hint() reads the file to tell which
// it has.

#include <base/errors.h>
#include <base/names.h>
#include <base/ranges.h>
#include <base/text.h>

#include <deal.II/base/patterns.h>

#include <problem/boundary_conditions.h>
#include <problem/boundary_entries.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const std::string displacement_name = "Boundary conditions/Displacement";
    const std::string points_name =
      "Boundary conditions/Displacement at points";
    const std::string forces_name = "Boundary conditions/Force at points";
    const std::string phase_fields_name =
      "Boundary conditions/Phase field at points";
    const std::string traction_name   = "Boundary conditions/Traction";
    const std::string pressure_name   = "Boundary conditions/Pressure";
    const std::string body_force_name = "Boundary conditions/Body force";



    template <int dim>
    void
    require_known_sets(const std::vector<PointEntry<dim>> &entries,
                       const std::vector<std::string>     &point_sets,
                       const std::string                  &parameter)
    {
      for (const PointEntry<dim> &entry : entries)
        if (!entry.set.empty() && !contains(point_sets, entry.set))
          throw InputError(parameter + ": found '" + entry.set +
                           "', allowed is a point of " + std::to_string(dim) +
                           " numbers, as '" + (dim == 2 ? "0, 1" : "0, 1, 2") +
                           "', or the name of one of Geometry/Point sets, " +
                           (point_sets.empty()
                              ? "of which there are none."
                              : "which are " + join_names(point_sets) + "."));
    }
  } // namespace



  // In 2-d z is 0; components that nothing was said of are 0.
  template <int dim>
  double
  ExpressionFunction<dim>::value(const Point<dim>  &point,
                                 const unsigned int component) const
  {
    if (!expressions[component])
      return 0.;
    const double value = (*expressions[component])(
      {point[0], point[1], dim == 3 ? point[dim - 1] : 0., this->get_time()});
    return rotations[component]
             ? rotations[component]->displacement(point, value)[component]
             : value;
  }



  template <int dim>
  void
  BoundaryConditions<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Boundary conditions");
    prm.add_parameter(
      "Displacement",
      displacement_text,
      "Prescribed values: 'boundary : component : expression ; ...' with "
      "components x, y, z, all, phase field, and expressions in x, y, z, t, "
      "where table(\"load.csv\") is the value at t of a file of rows 'time, "
      "value', linear between them. "
      "Where two boundaries meet, the entry named first decides. 'boundary : "
      "symmetry' is a plane of symmetry, parallel to the axes: nothing moves "
      "through it. 'rotation "
      "about 0, 0' in place of the component turns the boundary as a rigid "
      "whole, counter-clockwise, by the angle of the expression, u = "
      "(R - I)(x - c); in 3-d 'rotation about 0, 0, 0 axis 0, 0, 1', or 'twist "
      "about ...', which leaves the motion along the axis free. Unit: mm "
      "(phase field: 1, angles: rad).");
    prm.add_parameter(
      "Displacement at points",
      point_displacement_text,
      "Prescribed displacement of single vertices of the mesh, as of the "
      "supports of a beam: 'point : component : expression ; ...', as in '0, 0 "
      ": y : 0', or with the name of one of Geometry/Point sets in the place of "
      "the point. Where a boundary prescribes the same component, the boundary "
      "decides. Points alone may hold the body, too. The stress under a single "
      "node grows without limit as cells shrink: keep cracks away from it. "
      "On a slit both faces are held. Unit: mm.");
    prm.add_parameter(
      "Force at points",
      point_force_text,
      "Forces on single vertices of the mesh: 'point : component : expression "
      "; ...' with components x, y, z, all, as in '4, 2 : y : -10*t', or with "
      "the name of one of Geometry/Point sets in the place of the point. The "
      "force of a set acts on each of its vertices, as *CLOAD of Abaqus: n of "
      "them carry n times as much, on a slit both faces; of a finer mesh the "
      "set may have more, but those that adaptation adds have no force. Forces "
      "of several entries are added. They are "
      "forces on the whole body, in 2-d on all of its thickness, and dead "
      "loads. Displacement and stress under a point grow without limit as "
      "cells shrink. Unit: N.");
    prm.add_parameter(
      "Phase field at points",
      point_phase_field_text,
      "Prescribed phase field of single vertices of the mesh: 'point : value ; "
      "...', as in '4, 2 : 1', where the value, an expression in x, y, z, t, is "
      "within 0 (broken) and 1. Where a boundary prescribes it, the boundary "
      "decides. Unit: 1.");
    prm.add_parameter("Traction",
                      traction_text,
                      "Forces per area on the boundary, 'boundary : component "
                      ": expression ; ...' with components x, y, z, all, and "
                      "normal, along the outward normal of the undeformed "
                      "body; at finite strain dead loads, per undeformed area. "
                      "Unit: MPa.");
    prm.add_parameter("Pressure",
                      pressure_text,
                      "Pressures on the boundary, 'boundary : expression ; "
                      "...', positive where they press on the body: t = -p n. "
                      "At finite strain they follow it: normal to the deformed "
                      "boundary, per deformed area, -p cof(F) n per undeformed "
                      "area (not with plane stress). Unit: MPa.");
    prm.add_parameter("Body force",
                      body_force_text,
                      "Forces per volume, 'component : expression ; ...'; at "
                      "finite strain dead loads, per undeformed volume. Unit: "
                      "N/mm^3.");
    prm.add_parameter(
      "Mean strain",
      mean_strain_text,
      "Of a body with Geometry/Periodic sides, what the sides are moved by "
      "against each other: 'component : expression ; ...', as in 'xx : 0.01*t ; "
      "xy : 0.005*t', expressions in t. u(x + L) - u(x) = E L, with L the "
      "vector between the two sides of a pair and E = 0 for components that "
      "are not named. At small strain E is symmetric, 'xy' gives E_xy = E_yx "
      "(half the angle); at finite strain E_ij is the mean of du_i/dx_j, the "
      "mean deformation gradient less 1, and 'xy' and 'yx' are components of "
      "their own. In a direction without periodic sides the body is free. "
      "Unit: 1.",
      Patterns::Anything());
    prm.add_parameter(
      "Unbreakable margin",
      margin,
      "The material within this distance of a boundary or point with "
      "prescribed displacement, but for symmetry, or of a point with a force "
      "cannot break: clamps, bulges, supports. 0: none. Unit: mm.",
      Patterns::Double(0.));
    prm.leave_subsection();
  }



  template <int dim>
  std::vector<BoundaryEntry<dim>>
  BoundaryConditions<dim>::displacements() const
  {
    return read_entries<dim>(
      displacement_text, true, entry_of_phase_field, displacement_name);
  }



  template <int dim>
  std::vector<PointEntry<dim>>
  BoundaryConditions<dim>::point_displacements() const
  {
    return point_entries(
      read_entries<dim>(point_displacement_text, true, "", points_name),
      points_name,
      /*with_sets=*/true);
  }



  template <int dim>
  std::vector<PointEntry<dim>>
  BoundaryConditions<dim>::point_forces() const
  {
    return point_entries(
      read_entries<dim>(point_force_text, true, "", forces_name),
      forces_name,
      /*with_sets=*/true);
  }



  template <int dim>
  std::vector<PointEntry<dim>>
  BoundaryConditions<dim>::point_phase_fields() const
  {
    std::vector<BoundaryEntry<dim>> entries;
    for (const auto &parts :
         read_items(point_phase_field_text, "point : value", phase_fields_name))
      entries.push_back({parts[0],
                         dim,
                         std::make_shared<const Expression>(
                           parts[1], entry_variables(), phase_fields_name)});
    return point_entries(entries, phase_fields_name);
  }



  // One function of all components for each boundary, as the assembly goes
  // through boundaries. Components that are not named are 0.
  template <int dim>
  typename BoundaryConditions<dim>::LoadsByBoundary
  BoundaryConditions<dim>::tractions(const unsigned int n_components) const
  {
    LoadsByBoundary result;
    for (const BoundaryEntry<dim> &entry :
         read_entries<dim>(traction_text, true, entry_of_normal, traction_name))
    {
      if (entry.component == dim)
        continue;
      auto &function = result[entry.boundary];
      if (!function)
        function = std::make_shared<ExpressionFunction<dim>>(n_components);
      function->set(entry.component, entry.expression);
    }
    return result;
  }



  template <int dim>
  typename BoundaryConditions<dim>::LoadsByBoundary
  BoundaryConditions<dim>::normal_tractions() const
  {
    LoadsByBoundary result;
    for (const BoundaryEntry<dim> &entry :
         read_entries<dim>(traction_text, true, entry_of_normal, traction_name))
      if (entry.component == dim)
      {
        auto function = std::make_shared<ExpressionFunction<dim>>(1);
        function->set(0, entry.expression);
        result[entry.boundary] = function;
      }
    return result;
  }



  template <int dim>
  typename BoundaryConditions<dim>::LoadsByBoundary
  BoundaryConditions<dim>::pressures() const
  {
    LoadsByBoundary result;
    for (const auto &parts :
         read_items(pressure_text, "boundary : expression", pressure_name))
    {
      auto function = std::make_shared<ExpressionFunction<dim>>(1);
      function->set(0,
                    std::make_shared<const Expression>(
                      parts[1], entry_variables(), pressure_name));
      if (!result.insert({parts[0], function}).second)
        throw InputError(pressure_name + ": found '" + parts[0] + " : " +
                         parts[1] + "', a second entry for '" + parts[0] +
                         "'. Allowed is one for each boundary.");
    }
    return result;
  }



  template <int dim>
  std::shared_ptr<ExpressionFunction<dim>>
  BoundaryConditions<dim>::body_force(const unsigned int n_components) const
  {
    const auto entries =
      read_entries<dim>(body_force_text, false, "", body_force_name);
    if (entries.empty())
      return nullptr;
    auto function = std::make_shared<ExpressionFunction<dim>>(n_components);
    for (const BoundaryEntry<dim> &entry : entries)
      function->set(entry.component, entry.expression);
    return function;
  }



  template <int dim>
  void
  BoundaryConditions<dim>::check(const NamedBoundaries              &boundaries,
                                 const std::function<std::string()> &hint,
                                 const std::vector<std::string>     &point_sets,
                                 const bool is_periodic) const
  {
    const auto require_known = [&](const std::string &name,
                                   const std::string &parameter) {
      boundary_of(name, boundaries, parameter, hint);
    };
    bool any_displacement = false;
    for (const BoundaryEntry<dim> &entry : displacements())
    {
      require_known(entry.boundary, displacement_name);
      any_displacement = any_displacement || entry.component != dim;
    }
    const auto points = point_displacements();
    require_known_sets(points, point_sets, points_name);
    require_known_sets(point_forces(), point_sets, forces_name);
    if (!any_displacement && points.empty() && !is_periodic)
      throw InputError(displacement_name +
                       ": no displacement is prescribed anywhere, here or in "
                       "Displacement at points, so the body can move freely. "
                       "Allowed boundaries: " +
                       join_names(names_of(boundaries)) + ".");
    for (const auto &traction : tractions(dim))
      require_known(traction.first, traction_name);
    for (const auto &traction : normal_tractions())
      require_known(traction.first, traction_name);
    for (const auto &pressure : pressures())
      require_known(pressure.first, pressure_name);
    body_force(dim);
    point_phase_fields();
  }



  template class ExpressionFunction<2>;
  template class ExpressionFunction<3>;
  template class BoundaryConditions<2>;
  template class BoundaryConditions<3>;
} // namespace MixedCracks
