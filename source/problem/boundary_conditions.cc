// SPDX-License-Identifier: GPL-2.0-or-later
// What is applied to the body, as lists in the .prm. With x the place, t the
// time and w a test function, in the terms of (M5) of doc/model.md:
//
//   Displacement             u_c = u_D(x, t) on a boundary, mm
//     component phase field  phi = phi_D(x, t) on a boundary, within 0 and 1
//     symmetry               u . n = 0 on a plane
//   Displacement at points   u_c = u_D(x, t) at a vertex, mm
//   Phase field at points    phi = phi_D(x, t) at a vertex, within 0 and 1
//   Force at points          P_c(x, t) w_c at a vertex, N
//   Traction                 ( tau(x, t), w ) on a boundary, tau in MPa
//   Body force               ( f(x, t), w ) in the body, f in N/mm^3
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
#include <base/text.h>

#include <deal.II/base/patterns.h>

#include <problem/boundary_conditions.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const std::vector<std::string> variables = {"x", "y", "z", "t"};
    const std::string displacement_name = "Boundary conditions/Displacement";
    const std::string points_name =
      "Boundary conditions/Displacement at points";
    const std::string forces_name = "Boundary conditions/Force at points";
    const std::string phase_fields_name =
      "Boundary conditions/Phase field at points";
    const std::string traction_name   = "Boundary conditions/Traction";
    const std::string body_force_name = "Boundary conditions/Body force";

    // components a name stands for
    template <int dim>
    std::vector<unsigned int>
    components_of(const std::string &name,
                  const bool         with_phase_field,
                  const std::string &parameter)
    {
      std::vector<std::string> allowed = {"x", "y"};
      if (dim == 3)
        allowed.push_back("z");
      for (unsigned int d = 0; d < dim; ++d)
        if (name == allowed[d])
          return {d};
      if (name == "all")
      {
        std::vector<unsigned int> all;
        for (unsigned int d = 0; d < dim; ++d)
          all.push_back(d);
        return all;
      }
      if (with_phase_field && name == "phase field")
        return {dim};
      allowed.push_back("all");
      if (with_phase_field)
        allowed.push_back("phase field");
      throw InputError(parameter +
                       ": component: " + unknown_name_message(name, allowed));
    }



    // a second value of one component on one boundary would be lost
    template <int dim>
    void
    require_new(const std::vector<BoundaryEntry<dim>> &entries,
                const std::string                     &boundary,
                const unsigned int                     component,
                const std::string                     &found,
                const std::string                     &parameter)
    {
      for (const BoundaryEntry<dim> &earlier : entries)
        if (earlier.boundary == boundary && earlier.component == component)
          throw InputError(
            parameter + ": found '" + found +
            "', a second entry for a component that has one. "
            "Allowed is one for each component" +
            (boundary.empty() ? "." : " of '" + boundary + "'."));
    }



    template <int dim>
    std::vector<BoundaryEntry<dim>>
    read_entries(const std::string &text,
                 const bool         with_boundary,
                 const bool         with_phase_field,
                 const std::string &parameter)
    {
      std::vector<BoundaryEntry<dim>> result;
      for (const std::string &entry : split_list(text, ';'))
      {
        std::vector<std::string> parts = split_list(entry, ':');
        if (with_phase_field && parts.size() == 2 && parts[1] == "symmetry")
        {
          const unsigned int component = BoundaryEntry<dim>::symmetry;
          require_new(result, parts[0], component, entry, parameter);
          result.push_back(
            {parts[0],
             component,
             std::make_shared<const Expression>("0", variables, parameter)});
          continue;
        }
        if (!with_boundary)
          parts.insert(parts.begin(), "");
        if (parts.size() != 3)
          throw InputError(
            parameter + ": found '" + entry + "', allowed is '" +
            (with_boundary ? "boundary : " : "") + "component : expression'" +
            (with_phase_field ? " or 'boundary : symmetry'" : "") +
            ", several separated by ';'.");
        const auto expression =
          std::make_shared<const Expression>(parts[2], variables, parameter);
        for (const unsigned int component :
             components_of<dim>(parts[1], with_phase_field, parameter))
        {
          require_new(result, parts[0], component, entry, parameter);
          result.push_back({parts[0], component, expression});
        }
      }
      return result;
    }



    template <int dim>
    PointEntry<dim>
    point_entry(const BoundaryEntry<dim> &entry, const std::string &parameter)
    {
      const std::vector<double> numbers =
        parse_numbers(entry.boundary, parameter);
      if (numbers.size() != dim)
        throw InputError(parameter + ": found '" + entry.boundary +
                         "', allowed is a point of " + std::to_string(dim) +
                         " numbers, as '" + (dim == 2 ? "0, 1" : "0, 1, 2") +
                         "'.");
      PointEntry<dim> at{{}, entry.component, entry.expression};
      std::copy(numbers.begin(), numbers.end(), at.point.begin_raw());
      return at;
    }



    // however the point is written
    template <int dim>
    std::vector<PointEntry<dim>>
    point_entries(const std::vector<BoundaryEntry<dim>> &entries,
                  const std::string                     &parameter)
    {
      std::vector<PointEntry<dim>> result;
      for (const BoundaryEntry<dim> &entry : entries)
      {
        const PointEntry<dim> at = point_entry(entry, parameter);
        for (const PointEntry<dim> &earlier : result)
          if (earlier.point == at.point && earlier.component == at.component)
            throw InputError(parameter + ": found '" + entry.boundary +
                             "' twice for a component. Allowed is one entry "
                             "for each component of a point.");
        result.push_back(at);
      }
      return result;
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
    return (*expressions[component])(
      {point[0], point[1], dim == 3 ? point[dim - 1] : 0., this->get_time()});
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
      "value', linear between them. 'boundary : symmetry' is a plane of "
      "symmetry, parallel to the axes: nothing moves through it. "
      "Where two boundaries meet, the entry named first decides. Unit: mm "
      "(phase field: 1).");
    prm.add_parameter(
      "Displacement at points",
      point_displacement_text,
      "Prescribed displacement of single vertices of the mesh, as of the "
      "supports of a beam: 'point : component : expression ; ...', as in '0, 0 "
      ": y : 0'. Where a boundary prescribes the same component, the boundary "
      "decides. Points alone may hold the body, too. The stress under a single "
      "node grows without limit as cells shrink: keep cracks away from it. "
      "On a slit both faces are held. Unit: mm.");
    prm.add_parameter(
      "Force at points",
      point_force_text,
      "Forces on single vertices of the mesh: 'point : component : expression "
      "; ...' with components x, y, z, all, as in '4, 2 : y : -10*t'. They are "
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
                      ": expression ; ...'; at finite strain dead loads, per "
                      "undeformed area. Unit: MPa.");
    prm.add_parameter("Body force",
                      body_force_text,
                      "Forces per volume, 'component : expression ; ...'; at "
                      "finite strain dead loads, per undeformed volume. Unit: "
                      "N/mm^3.");
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
    return read_entries<dim>(displacement_text, true, true, displacement_name);
  }



  template <int dim>
  std::vector<PointEntry<dim>>
  BoundaryConditions<dim>::point_displacements() const
  {
    return point_entries(
      read_entries<dim>(point_displacement_text, true, false, points_name),
      points_name);
  }



  template <int dim>
  std::vector<PointEntry<dim>>
  BoundaryConditions<dim>::point_forces() const
  {
    return point_entries(
      read_entries<dim>(point_force_text, true, false, forces_name),
      forces_name);
  }



  template <int dim>
  std::vector<PointEntry<dim>>
  BoundaryConditions<dim>::point_phase_fields() const
  {
    std::vector<BoundaryEntry<dim>> entries;
    for (const std::string &entry : split_list(point_phase_field_text, ';'))
    {
      const std::vector<std::string> parts = split_list(entry, ':');
      if (parts.size() != 2)
        throw InputError(phase_fields_name + ": found '" + entry +
                         "', allowed is 'point : value', several separated by "
                         "';'.");
      entries.push_back({parts[0],
                         dim,
                         std::make_shared<const Expression>(
                           parts[1], variables, phase_fields_name)});
    }
    return point_entries(entries, phase_fields_name);
  }



  // One function of all components for each boundary, as the assembly goes
  // through boundaries. Components that are not named are 0.
  template <int dim>
  std::map<std::string, std::shared_ptr<ExpressionFunction<dim>>>
  BoundaryConditions<dim>::tractions(const unsigned int n_components) const
  {
    std::map<std::string, std::shared_ptr<ExpressionFunction<dim>>> result;
    for (const BoundaryEntry<dim> &entry :
         read_entries<dim>(traction_text, true, false, traction_name))
    {
      auto &function = result[entry.boundary];
      if (!function)
        function = std::make_shared<ExpressionFunction<dim>>(n_components);
      function->set(entry.component, entry.expression);
    }
    return result;
  }



  template <int dim>
  std::shared_ptr<ExpressionFunction<dim>>
  BoundaryConditions<dim>::body_force(const unsigned int n_components) const
  {
    const auto entries =
      read_entries<dim>(body_force_text, false, false, body_force_name);
    if (entries.empty())
      return nullptr;
    auto function = std::make_shared<ExpressionFunction<dim>>(n_components);
    for (const BoundaryEntry<dim> &entry : entries)
      function->set(entry.component, entry.expression);
    return function;
  }



  template <int dim>
  void
  BoundaryConditions<dim>::check(const BoundaryIds                  &boundaries,
                                 const std::function<std::string()> &hint) const
  {
    std::vector<std::string> names;
    for (const auto &boundary : boundaries)
      names.push_back(boundary.first);
    const auto require_known = [&](const std::string &name,
                                   const std::string &parameter) {
      if (boundaries.count(name) > 0)
        return;
      const std::string more = hint ? hint() : "";
      throw InputError(parameter +
                       ": boundary: " + unknown_name_message(name, names) +
                       (more.empty() ? "" : " " + more));
    };
    bool any_displacement = false;
    for (const BoundaryEntry<dim> &entry : displacements())
    {
      require_known(entry.boundary, displacement_name);
      any_displacement = any_displacement || entry.component != dim;
    }
    const bool any_point = !point_displacements().empty();
    if (!any_displacement && !any_point)
      throw InputError(displacement_name +
                       ": no displacement is prescribed anywhere, here or in "
                       "Displacement at points, so the body can move freely. "
                       "Allowed boundaries: " +
                       join_names(names) + ".");
    for (const auto &traction : tractions(dim))
      require_known(traction.first, traction_name);
    body_force(dim);
    point_forces();
    point_phase_fields();
  }



  template class ExpressionFunction<2>;
  template class ExpressionFunction<3>;
  template class BoundaryConditions<2>;
  template class BoundaryConditions<3>;
} // namespace MixedCracks
